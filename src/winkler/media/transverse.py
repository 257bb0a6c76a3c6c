r"""Transversely isotropic half-spaces whose axis is the surface normal: the same springs with other moduli.

.. math:: E^*_{TI} = \frac{2\sqrt{C_{44}}\,(C_{11}C_{33}-C_{13}^2)}
          {\sqrt{C_{11}}\sqrt{(\sqrt{C_{11}C_{33}}-C_{13})(C_{13}+2C_{44}+\sqrt{C_{11}C_{33}})}} , \qquad
          \frac{2}{G^*_{TI}} = \frac{\sqrt{C_{33}/C_{11}}}{E^*_{TI}} + \frac{1}{2\sqrt{C_{44}C_{66}}}
"""

from __future__ import annotations

import functools
import math

from winkler.errors import InvalidInput, OutsideValidity
from winkler.materials.elastic import RIGID, Elastic, Rigid, TransverselyIsotropic
from winkler.media.halfspace import HomogeneousMedium
from winkler.media.interior.twist_field import twist_constants
from winkler.media.layered.wave_constants import Wave, half_space_compliance
from winkler.media.medium import Displacement
from winkler.media.punch_field import BodyField
from winkler.numerics.types import Array
from winkler.validity import Assumption, Note, Standing
from winkler.values import value

__all__ = ["TransverselyIsotropicHalfSpace"]

Body = TransverselyIsotropic | Elastic | Rigid


def _compliances(body: Body) -> tuple[float, float]:
    """Return what a body adds to 1/E* and to 1/G* [1/Pa]."""
    if isinstance(body, Rigid):
        return 0.0, 0.0
    if isinstance(body, Elastic):
        return (1.0 - body.poisson**2) / body.young, (2.0 - body.poisson) / (4.0 * body.shear)
    c11, c13, c33, c44 = body.c11, body.c13, body.c33, body.c44
    mean = math.sqrt(c11 * c33)
    normal = math.sqrt(c11 * (mean - c13) * (c13 + 2.0 * c44 + mean)) / (
        2.0 * math.sqrt(c44) * (mean - c13) * (mean + c13)
    )
    c66 = 0.5 * (c11 - body.c12)
    lateral = 0.5 * (math.sqrt(c33 / c11) * normal + 0.5 / math.sqrt(c44 * c66))
    return normal, lateral


@value
class TransverselyIsotropicHalfSpace(HomogeneousMedium):
    """Two half-spaces of which at least one is transversely isotropic about the surface normal.

    Parameters
    ----------
    first : TransverselyIsotropic, Elastic or Rigid
        The body below, z > 0.
    second : TransverselyIsotropic, Elastic or Rigid, optional
        The body above; rigid unless given.

    Raises
    ------
    InvalidInput
        If both bodies are rigid.

    References
    ----------
    H. A. Elliott, Proc. Camb. Phil. Soc. 45 (1949) 621-630, doi:10.1017/S0305004100025305
    """

    first: Body
    second: Body = RIGID

    def __post_init__(self) -> None:
        if _compliances(self.first)[0] + _compliances(self.second)[0] == 0.0:
            raise InvalidInput("TransverselyIsotropicHalfSpace: both bodies are rigid; at least one must be elastic.")

    @classmethod
    def between(cls, first: Body, second: Body = RIGID) -> TransverselyIsotropicHalfSpace:
        """Return the medium between two bodies; the second is rigid unless given."""
        return cls(first, second)

    @functools.cached_property
    def modulus(self) -> float:
        """E* [Pa]."""
        return 1.0 / (_compliances(self.first)[0] + _compliances(self.second)[0])

    @functools.cached_property
    def shear_modulus(self) -> float:
        """G* [Pa]."""
        return 1.0 / (_compliances(self.first)[1] + _compliances(self.second)[1])

    @functools.cached_property
    def along_modulus(self) -> float:
        """m_L [Pa] of shear along a wave, as in plane strain."""
        return 1.0 / sum(half_space_compliance(body, Wave.ALONG) for body in (self.first, self.second))

    @functools.cached_property
    def torsional_modulus(self) -> float:
        """G_t [Pa], 1/G_t = sum of 1/sqrt(C44 C66)."""
        twist_moduli = [twist_constants(body)[0] for body in (self.first, self.second) if not isinstance(body, Rigid)]
        return 1.0 / sum(1.0 / modulus for modulus in twist_moduli)

    def interior(self, displacement: Displacement, r: Array, z: Array, *, below: bool) -> BodyField:
        """Refused: stresses inside an anisotropic body are not known to winkler."""
        raise OutsideValidity(
            "The stresses inside a TransverselyIsotropicHalfSpace are not known to winkler; request the surface "
            "(without z), or use HalfSpace."
        )

    notes = (
        Note(
            Assumption.RESPONSE,
            Standing.EXACT,
            "Frictionless contact of homogeneous half-spaces, transversely isotropic about the surface normal: "
            "pressure and depth follow from the isotropic solution with the effective modulus.",
            "H. A. Elliott, Proc. Camb. Phil. Soc. 45 (1949) 621, doi:10.1017/S0305004100025305",
        ),
    )
    """The assumptions."""
