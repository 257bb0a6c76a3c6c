"""Reference samples of known modulus: fused silica, sapphire, and others."""

from __future__ import annotations

from winkler.materials.elastic import Elastic
from winkler.values.checks.number_checks import NonNegative, PoissonRatio, Positive
from winkler.values.value import value, words


@value
class ReferenceSample:
    """A reference sample.

    Parameters
    ----------
    young : float
        E [Pa].
    poisson : float
        nu [-].
    young_error : float, optional
        Standard uncertainty of E [Pa]; zero by default.
    name : str, optional
    """

    __words__ = words(young_error=("u(E)", "Pa", "standard uncertainty of Young's modulus"), name=("", None, "name"))

    young: Positive
    poisson: PoissonRatio
    young_error: NonNegative = 0.0
    name: str = ""

    def modulus(self, solid: Elastic) -> float:
        """Return the reduced modulus [Pa] of this sample and a tip."""
        return 1.0 / ((1.0 - self.poisson**2) / self.young + (1.0 - solid.poisson**2) / solid.young)


FUSED_SILICA = ReferenceSample(72e9, 0.17, 0.6e9, "fused silica")
SAPPHIRE = ReferenceSample(410e9, 0.234, 8e9, "sapphire")
"""Of the c-plane, as indentation feels it."""
