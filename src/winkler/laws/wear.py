r"""Laws of wear: the depth that a surface loses by slip under pressure.

Archard (Reye, Preston): the worn depth grows with pressure and slip,

.. math:: \mathrm df(r) = \kappa\,p(r)\,\mathrm ds(r) ,

where :math:`\kappa` is the wear coefficient over the hardness, often stated in mm^3 per N and m.  Where both surfaces
wear, only the sum of what both lose changes the contact.
"""

from __future__ import annotations

from typing import Annotated, Protocol, runtime_checkable

import numpy as np

from winkler.numerics.types import Array
from winkler.values.checks.contract import offered
from winkler.values.checks.number_checks import POSITIVE
from winkler.values.errors import InvalidInput
from winkler.values.value import value, words


@value
class Archard:
    """Wear proportional to pressure and slip distance.

    Parameters
    ----------
    rate : float
        Worn volume per force and slip [1/Pa], positive; 1 mm^3/(N m) is 1e-9 1/Pa.

    Raises
    ------
    InvalidInput
        If it is not positive and finite.

    References
    ----------
    J. F. Archard, J. Appl. Phys. 24 (1953) 981-988, doi:10.1063/1.1721448
    """

    rate: Annotated[float, POSITIVE._replace(demand="give a positive, finite number{unit} (1 mm^3/(N m) is 1e-9)")]

    def depth_per_slip(self, pressure: Array) -> Array:
        """Worn depth per slip [-] under pressures [Pa]."""
        return np.asarray(self.rate * pressure)


@offered("a law with a method depth_per_slip(pressure)")
@runtime_checkable
class OwnWear(Protocol):
    """A law of wear of one's own, written for its implementer.

    It holds for every point of the surface by itself, and is called with numpy arrays.  Make it a value (frozen, equal
    by content).
    """

    def depth_per_slip(self, pressure: Array) -> Array:
        """Return the worn depth per slip [-] under pressures [Pa]; same shape, not negative, finite."""


@value
class PairWear:
    """Wear of both surfaces, each with a separate law.

    Parameters
    ----------
    first : Archard or OwnWear
        The body below (z > 0).
    second : Archard or OwnWear
        The body above.

    Raises
    ------
    InvalidInput
        If one of them is no law of wear.
    """

    __words__ = words(first=("1", None, "how the body below wears"), second=("2", None, "how the body above wears"))

    first: Archard | OwnWear
    second: Archard | OwnWear


@value
class Unworn:
    """Nothing is worn off: the other body of a pair."""

    def depth_per_slip(self, pressure: Array) -> Array:
        """Zero under any pressure [-]."""
        return np.zeros(pressure.shape)


WearLaw = Archard | PairWear | OwnWear
"""How surfaces may wear; one law alone is that of the first body, and the second does not wear."""


def worn_by(law: WearLaw, pressure: Array) -> tuple[Array, Array]:
    """Return what the first and the second body lose per slip [-] under pressures [Pa].

    Raises
    ------
    InvalidInput
        If a user-defined law returns anything but one number for each pressure, not negative and finite.
    """
    if isinstance(law, PairWear):
        return _checked_depths(law.first, pressure), _checked_depths(law.second, pressure)
    return _checked_depths(law, pressure), np.zeros(pressure.shape)


def _checked_depths(law: Archard | OwnWear, pressure: Array) -> Array:
    if isinstance(law, Archard):
        return law.depth_per_slip(pressure)
    worn = np.asarray(law.depth_per_slip(pressure), dtype=float)
    if worn.shape != pressure.shape or not np.all(np.isfinite(worn)) or np.any(worn < 0.0):
        raise InvalidInput(
            f"{type(law).__name__}.depth_per_slip must return one number for each of the {pressure.size} pressures, "
            "finite and not negative."
        )
    # where nothing presses nothing is worn, whatever a law returns at zero pressure
    return np.where(pressure > 0.0, worn, 0.0)
