"""A roller under one load: what it bears, and where along its length."""

from __future__ import annotations

from winkler.numerics.types import Array, PerLoad, Q
from winkler.values.value import value, words


@value
class RollerNumbers(PerLoad[Q]):
    """What a roller bears under one load, or under many.

    Parameters
    ----------
    depth, tilt : float or ndarray
        Approach in the middle [m], and tilt [rad], positive where it presses the end at positive x.
    force, moment : float or ndarray
        F [N] and M [N m] about the middle, positive where the end at positive x bears more.
    stiffness : float or ndarray
        dF/dd [N/m] at the stated tilt, or at the stated moment.
    peak_pressure : float or ndarray
        [Pa]; infinite where a sharp end bears.
    middle_pressure : float or ndarray
        [Pa], zero where the middle is out of contact.
    edge_factor : float or ndarray
        The greatest pressure over that in the middle; infinite where a sharp end bears or the middle does not.
    area : float or ndarray
        Of the contact [m^2].
    grid_error : float or ndarray
        The greatest relative change of force, depth, middle and greatest pressure from a grid of half as many elements.
    """

    __words__ = words(
        depth=("d", "m", "approach of the bodies in the middle of the roller, since its middle would touch"),
        tilt=(r"\theta", "rad", "tilt of the roller"),
        stiffness=("k", "N/m", "incremental stiffness dF/dd at the stated tilt or moment"),
        peak_pressure=("p_0", "Pa", "greatest pressure; infinite at loaded sharp ends"),
    )

    depth: Q
    tilt: Q
    force: Q
    moment: Q
    stiffness: Q
    peak_pressure: Q
    middle_pressure: Q
    edge_factor: Q
    area: Q
    grid_error: Q


@value
class RollerState(RollerNumbers[float]):
    """A roller under one load; its numbers are those of `RollerNumbers`.

    Parameters
    ----------
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

    __words__ = words(
        edges=("x", "m", "ends of the elements along the roller"),
        x=("x", "m", "places along the roller"),
        y=("y", "m", "places across the roller"),
        pressure_along=("p", "Pa", "greatest pressure across each slice of the roller"),
        force_per_length=("q", "N/m", "force per length along the roller"),
        half_width=("a", "m", "half-width of the contact along the roller"),
        pressure=("p", "Pa", "pressure of each element"),
    )

    edges: Array
    x: Array
    y: Array
    pressure_along: Array
    force_per_length: Array
    half_width: Array
    pressure: Array
