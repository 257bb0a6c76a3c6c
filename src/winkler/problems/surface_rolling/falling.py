r"""Steady rolling under friction that may fall with the velocity of slip.

A traction q changes the slip velocity by about V q / E*, whatever the length on which it varies; under a coefficient
mu(v) that again changes the traction.  Where :math:`-\mu'(v)\,p\,V/E^* > 1` the second change is the greater one, and
several contacts solve the equations.
"""

from __future__ import annotations

import numpy as np

from winkler.laws.friction import Coulomb
from winkler.laws.varying_friction import FallingFriction
from winkler.numerics.surfaces.rolled_surface import RolledSurface, roll
from winkler.numerics.surfaces.traction_grid import TractionGrid
from winkler.numerics.surfaces.varying_bound import vary
from winkler.numerics.types import Array
from winkler.values.errors import OutsideValidity


def roll_under(
    friction: Coulomb | FallingFriction,
    speed: float,
    grid: TractionGrid,
    pressure: Array,
    rigid: Array,
    start: Array,
    *,
    tolerance: float,
) -> RolledSurface:
    """Solve steady rolling at a speed [m/s].

    Parameters are those of `winkler.numerics.surfaces.rolled_surface.roll`, with p / E* in place of the bound.

    Raises
    ------
    OutsideValidity
        If friction falls so steeply that several contacts solve the equations.
    NotConverged
        If stick and slip, or the coefficients of friction, are not found to the tolerance.
    """
    if isinstance(friction, Coulomb):
        return roll(grid, friction.coefficient * pressure, rigid, start, tolerance=tolerance)
    rolled, varied = vary(
        lambda bound, start: roll(grid, bound, rigid, start, tolerance=tolerance),
        lambda creep: friction.at_velocity(speed * creep) * pressure,
        start,
        tolerance,
    )
    creep = np.where(rolled.slipping, np.hypot(rolled.slip[0], rolled.slip[1]), 0.0)
    steep = speed * float(np.max(friction.fall(speed * creep) * pressure))
    if steep > 1.0:
        raise OutsideValidity(
            f"friction falls {steep:.3g} times as fast with the velocity of slip as the bodies unload; the stick zone "
            "is not determined: give a lower speed, or friction that falls over a greater velocity"
        )
    return rolled._replace(misfit=max(rolled.misfit, varied.mismatch))
