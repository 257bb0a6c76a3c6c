"""A roller under one load: what it bears, and where along its length."""

from __future__ import annotations

from types import MappingProxyType

from winkler.numerics.types import Array
from winkler.values.value import value, words

__all__ = ["ROLLER_WORDS", "RollerState"]

ROLLER_WORDS = words(
    depth=("d", "m", "approach of the bodies in the middle of the roller, since its middle would touch"),
    tilt=(r"\theta", "rad", "tilt of the roller"),
    stiffness=("k", "N/m", "incremental stiffness dF/dd at the stated tilt or moment"),
    peak_pressure=("p_0", "Pa", "maximum pressure; infinite at loaded sharp ends"),
)
ALONG_WORDS = words(
    edges=("x", "m", "ends of the elements along the roller"),
    x=("x", "m", "places along the roller"),
    y=("y", "m", "places across the roller"),
    pressure_along=("p", "Pa", "greatest pressure across each slice of the roller"),
    force_per_length=("q", "N/m", "force per length along the roller"),
    half_width=("a", "m", "half-width of the contact along the roller"),
    pressure=("p", "Pa", "pressure of each element"),
)


@value
class RollerState:
    """A roller under one load.

    Parameters
    ----------
    depth, tilt : float
        Approach in the middle [m], and tilt [rad], positive where it presses the end at positive x.
    force, moment : float
        F [N] and M [N m] about the middle, positive where the end at positive x bears more.
    stiffness : float
        dF/dd [N/m] at the stated tilt, or at the stated moment.
    peak_pressure : float
        [Pa]; infinite where a sharp end bears.
    middle_pressure : float
        [Pa], zero where the middle is out of contact.
    edge_factor : float
        The greatest pressure over that in the middle; infinite where a sharp end bears or the middle does not.
    area : float
        Of the contact [m^2].
    grid_error : float
        The greatest relative change of force, depth, middle and greatest pressure from a grid of half as many elements.
    edges : ndarray, (n + 1,)
        Ends of the elements along the roller [m].
    x, y : ndarray, (n,) and (m,)
        Middles of the elements along and across the roller [m].
    pressure_along : ndarray, (n,)
        Pressure in the middle of each slice [Pa].
    force_per_length, half_width : ndarray, (n,)
        [N/m] and [m] of each slice.
    pressure : ndarray, (n, m)
        Of each element [Pa].
    """

    __words__ = MappingProxyType({**ROLLER_WORDS, **ALONG_WORDS})

    depth: float
    tilt: float
    force: float
    moment: float
    stiffness: float
    peak_pressure: float
    middle_pressure: float
    edge_factor: float
    area: float
    grid_error: float
    edges: Array
    x: Array
    y: Array
    pressure_along: Array
    force_per_length: Array
    half_width: Array
    pressure: Array
