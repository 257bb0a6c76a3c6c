r"""Friction of a map that is weakened by slip: the bound in each pixel, and what is lost under it.

A pixel remembers the length s of the path along which it has slipped; under a coefficient mu(s) a step of the slip ds
loses p times the integral of mu from s to s + ds, per area.

With G the elastic compliance, :math:`-p\,\mathrm{d}\mu/\mathrm{d}s` times G has a greatest eigenvalue.  Below one each
pixel loses less friction than the bodies unload, and a step of given shifts has one solution only.  Above one they may
jump, and steps must be short enough to see it.
"""

from __future__ import annotations

import math
from collections.abc import Callable

import numpy as np

from winkler.laws.friction import Coulomb
from winkler.laws.varying_friction import SlipWeakening
from winkler.numerics.surfaces.sheared_surface import ShearedSurface
from winkler.numerics.surfaces.traction_grid import TractionGrid
from winkler.numerics.surfaces.varying_bound import vary
from winkler.numerics.types import Array
from winkler.values.errors import OutsideValidity

MOST_FALL = 0.25
"""Part of the whole fall of the coefficient beyond which a step might pass a jump unseen."""
MOST_PRODUCTS, ENOUGH = 40, 1e-2
"""Products with the compliance in search of its eigenvalue, and the change of it that ends the search."""


def bound_of(law: Coulomb | SlipWeakening, pressure: Array, slip_path: Array) -> Array:
    """Return mu p over E*, after slip along a path [m]."""
    coefficient = law.coefficient if isinstance(law, Coulomb) else law.after_slip(slip_path)
    return np.asarray(coefficient * pressure)


def loss_of(law: SlipWeakening, pressure: Array, slip_path: Array, more: Array) -> Array:
    """Return what is lost per area [m] over E* while the path of slip grows by `more` [m]."""
    return np.asarray(pressure * (law.lost(slip_path + more) - law.lost(slip_path)))


def steepness(grid: TractionGrid, law: SlipWeakening, pressure: Array, slip_path: Array, pixel: float) -> float:
    """Return how much faster friction falls than the bodies unload: the greatest eigenvalue, of the powers."""
    root = np.sqrt(pressure * law.fall(slip_path) * pixel)
    field, found = np.stack((root, 0.5 * root)), 0.0
    for _ in range(MOST_PRODUCTS):
        length = float(np.linalg.norm(field))
        if length == 0.0:
            break
        field = root * grid.sheared(root * (field / length))
        before, found = found, float(np.linalg.norm(field))
        if abs(found - before) <= ENOUGH * found:
            break
    return found


def shear_weakened(
    solve: Callable[[Array, Array], ShearedSurface],
    grid: TractionGrid,
    law: Coulomb | SlipWeakening,
    pressure: Array,
    slip_path: Array,
    pixel: float,
    start: Array,
    tolerance: float,
    *,
    by_force: bool,
) -> ShearedSurface:
    """Solve one step.

    Parameters
    ----------
    solve
        Takes the bound and tractions to begin with, both over E*.
    grid
        The surface.
    law
        Law of friction.
    pressure
        p / E*, (nx, ny).
    slip_path
        How far each pixel has slipped before [m].
    pixel
        Its length [m], in which `solve` measures the slip.
    start
        Tractions to begin with.
    tolerance
        Bound on `ShearedSurface.misfit`, which holds the mismatch of the law of friction too.
    by_force
        Whether a force is given.

    Raises
    ------
    OutsideValidity
        If the slip runs away, or may do so within the step, or friction does not bear the given forces.
    NotConverged
        If the step is not solved.
    """
    if isinstance(law, Coulomb):
        return solve(bound_of(law, pressure, slip_path), start)
    sheared, varied = vary(solve, lambda slip: bound_of(law, pressure, slip_path + pixel * slip), start, tolerance)
    slid = np.where(sheared.slipping, np.hypot(sheared.slip[0], sheared.slip[1]), 0.0)
    fallen = float(np.max(law.after_slip(slip_path) - law.after_slip(slip_path + pixel * slid)))
    most = MOST_FALL * (law.static_coefficient - law.kinetic_coefficient)
    if fallen > most and (by_force or steepness(grid, law, pressure, slip_path, pixel) >= 1.0):
        raise OutsideValidity(
            f"the friction coefficient falls by {fallen:.3g} at once while friction may fall faster than the bodies "
            f"unload, so that a jump may pass unseen; use about {math.ceil(fallen / most)} times as many points, or "
            "friction that falls over more slip"
        )
    return sheared._replace(misfit=max(sheared.misfit, varied.mismatch))
