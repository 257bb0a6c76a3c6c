"""The readings of one indentation with their uncertainties."""

from __future__ import annotations

import functools
from typing import Any

import numpy as np

from winkler.errors import InvalidInput
from winkler.fitting.nanoindentation.doubts import doubts_of
from winkler.fitting.nanoindentation.notes import nanoindentation_notes
from winkler.fitting.nanoindentation.thermal_drift import ThermalDrift
from winkler.fitting.nanoindentation.zero_point import ZeroPoint
from winkler.numerics.types import Array
from winkler.validity import Note
from winkler.values import value, words

__all__ = ["COMMON_SOURCES", "NanoindentationSolution"]

COMMON_SOURCES = ("calibration", "epsilon", "constants")
"""Sources that are the same in all indentations with one indenter."""


@value
class NanoindentationSolution:
    """Modulus and hardness of n unloadings, in the order of measurement, with the standard uncertainty by each source.

    Parameters
    ----------
    problem : Nanoindentation
        The problem.
    zero_point : ZeroPoint
        Point of first touch.
    drift : ThermalDrift
        Thermal drift.
    force, depth, stiffness, exponent, final_depth : ndarray, (n,)
        At the peaks: force [N], depth [m], stiffness of the contact [N/m], exponent [-], and depth [m] at which the
        fitted unloading ends.
    contact_depth, area, modulus, young, hardness : ndarray, (n,)
        h_c [m], A [m^2], reduced modulus [Pa], Young's modulus of the sample [Pa], hardness [Pa].
    sources : tuple of str
        Sources of uncertainty.
    young_shares, hardness_shares, depth_shares : ndarray, (sources, n)
        Standard uncertainties [Pa], [Pa] and [m] (contact depth) by each source; their squares add.
    skipped : tuple of str
        Unloadings that were not evaluated, with the reason.
    """

    __words__ = words(
        zero_point=("D_0", None, "point of first touch"),
        drift=(r"\dot h_T", None, "thermal drift"),
        stiffness=("S", "N/m", "stiffness of the contact at the peak"),
        exponent=("m", "", "exponent of the unloading"),
        modulus=("E_r", "Pa", "reduced modulus, that of the pair"),
        sources=("", None, "sources of uncertainty"),
        young_shares=("u_i(E)", "Pa", "standard uncertainty of Young's modulus by each source"),
        hardness_shares=("u_i(H)", "Pa", "standard uncertainty of the hardness by each source"),
        depth_shares=("u_i(h_c)", "m", "standard uncertainty of the contact depth by each source"),
        skipped=("", None, "unloadings that were not evaluated"),
    )

    problem: Any
    zero_point: ZeroPoint
    drift: ThermalDrift
    force: Array
    depth: Array
    stiffness: Array
    exponent: Array
    final_depth: Array
    contact_depth: Array
    area: Array
    modulus: Array
    young: Array
    hardness: Array
    sources: tuple[str, ...]
    young_shares: Array
    hardness_shares: Array
    depth_shares: Array
    skipped: tuple[str, ...] = ()

    @property
    def young_errors(self) -> Array:
        """Combined standard uncertainties of Young's modulus [Pa] ``(n,)``."""
        return np.asarray(np.sqrt(np.sum(np.square(self.young_shares), axis=0)))

    @property
    def hardness_errors(self) -> Array:
        """Combined standard uncertainties of the hardness [Pa] ``(n,)``."""
        return np.asarray(np.sqrt(np.sum(np.square(self.hardness_shares), axis=0)))

    def interval(self, name: str, confidence: float = 0.95) -> tuple[Array, Array]:
        """Return the lower and upper ends of the intervals of all unloadings, of the logarithm: none is below zero.

        Parameters
        ----------
        name : str
            "young" or "hardness".
        confidence : float
            Between 0 and 1.
        """
        from scipy.special import ndtri

        if name not in ("young", "hardness") or not 0.0 < confidence < 1.0:
            raise InvalidInput(
                f"interval: of {name!r} with the confidence {confidence!r}; give 'young' or 'hardness', and a "
                "confidence between 0 and 1."
            )
        width = float(ndtri(0.5 + 0.5 * confidence))
        middle, error = (self.young, self.young_errors) if name == "young" else (self.hardness, self.hardness_errors)
        return middle * np.exp(-width * error / middle), middle * np.exp(width * error / middle)

    @property
    def deepest(self) -> int:
        """Index of the unloading from the greatest force, the last of equal ones."""
        top = float(self.force.max())
        return int(np.flatnonzero(self.force >= 0.99 * top)[-1])

    @property
    def validity(self) -> tuple[Note, ...]:
        """Validity of the evaluation: pile-up, exponent, zero point, drift, calibration, unloadings left out."""
        return nanoindentation_notes(self)

    @functools.cached_property
    def doubts(self) -> tuple[str, ...]:
        """Sentences on what makes the readings doubtful: two touches, numbers that end on a bound; mostly empty."""
        return doubts_of(self)

    @property
    def own_young_error(self) -> float:
        """Standard uncertainty [Pa] of Young's modulus at the greatest force by sources of this indentation alone."""
        return self._own(self.young_shares)

    @property
    def own_hardness_error(self) -> float:
        """Standard uncertainty [Pa] of the hardness at the greatest force by sources of this indentation alone."""
        return self._own(self.hardness_shares)

    def _own(self, shares: Array) -> float:
        own = [place for place, source in enumerate(self.sources) if source not in COMMON_SOURCES]
        return float(np.sqrt(np.sum(np.square(shares[own, self.deepest]))))
