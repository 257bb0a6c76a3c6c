"""Histories, steps and small oscillations of contacts whose layers relax each by a law of its own."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import numpy as np

from winkler.foundation.bed import Bed
from winkler.foundation.footprint import DISC
from winkler.foundation.line_bed import LineBed
from winkler.foundation.on_medium import OnMedium, UnderProfile
from winkler.loading.loads import Depth, Force
from winkler.media.halfspace import HalfSpace
from winkler.media.offers import offers
from winkler.media.relaxing.by_waves import RelaxingByWaves
from winkler.numerics.springs.coupled_cells import CoupledCells
from winkler.numerics.types import Array, ComplexArray
from winkler.problems.normal.solve_contact import at_depth, at_force
from winkler.problems.viscoelastic.layered_march import LayeredMarch, MarchedPoint, TooNarrow, beyond, cells_of
from winkler.values.errors import InvalidInput, NotConverged, OutsideValidity

MOST_CELLS = 2000
COARSE_CELLS = 32
"""With which it is estimated how far contacts reach."""
REACH_MARGIN = 1.25
"""Cells reach so much farther than the contacts at once and after all time."""
WIDENED, MOST_WIDENINGS = 1.4, 20
LONG_AGO = 1e9
"""Retardation times after which nothing creeps any more."""
STEP_CELLS = 256
"""Cells of a creep or relaxation test."""
PUNCH_CELLS = 192
"""Cells under a small oscillation; twice as many remove the error of the second order."""


def is_layered(owner: str, bed: Bed, count: int = 2) -> bool:
    """Return whether layers of a bed relax each by a law of its own; refuse too many cells, and no profile."""
    if not offers(bed.medium, RelaxingByWaves):
        return False
    if not isinstance(bed, UnderProfile) or bed.footprint != DISC:
        raise InvalidInput(
            f"{owner}: a {type(bed.medium).__name__} needs Foundation(profile, medium) of a body of revolution, whose "
            "contact is a disc; the equivalent profile of other beds changes in time."
        )
    refuse_many(owner, bed, count)
    return True


def refuse_many(owner: str, bed: Bed | LineBed, count: int) -> None:
    """Refuse more cells than are needed."""
    if count > MOST_CELLS:
        raise InvalidInput(
            f"{owner}: count is {count}, but on a {type(bed.medium).__name__} at most {MOST_CELLS} cells are solved, "
            "which know forces to 1e-6; give fewer."
        )


def uppermost(bed: Bed) -> Bed:
    """Return the bed on half-spaces of the uppermost layer and of the second body, after all time."""
    assert isinstance(bed, OnMedium)
    assert offers(bed.medium, RelaxingByWaves)
    relaxed = bed.medium.relaxed
    return bed.with_medium(HalfSpace(relaxed.layers[0].solid, relaxed.second))


def contact_reach(owner: str, bed: Bed, normal: Depth | Force, most: float) -> float:
    """Return up to which radius [m] cells are needed for contacts up to a depth [m] or force [N]."""
    if most <= 0.0:
        raise OutsideValidity(f"{owner}: the bodies never touch along this path; press them.")
    by_depth = isinstance(normal, Depth)
    _, radius = (at_depth if by_depth else at_force)(uppermost(bed), np.array([most]))
    end = min(bed.rim, bed.reach)
    reach = min(REACH_MARGIN * float(radius[0]), end)
    for _ in range(MOST_WIDENINGS):
        cells = cells_of(bed, reach, COARSE_CELLS)
        last = LONG_AGO * float(cells.times[-1])
        ends = [
            cells.step(cells.at_rest, span, most if by_depth else None, None if by_depth else most)
            for span in (0.0, last)
        ]
        widest = max(end.radius for end in ends)
        if widest >= bed.rim * (1.0 - 1e-12):
            return bed.rim
        if all(end.held < cells.count for end in ends) and widest > 0.25 * reach:
            return REACH_MARGIN * widest
        if reach == bed.reach and widest >= reach:
            raise beyond(bed)
        reach = min(WIDENED * reach if widest > 0.25 * reach else max(2.0 * widest, 0.1 * reach), end)
    raise NotConverged(f"{owner}: how wide the contact becomes was not found; press less, or use thicker layers.")


def _walked(
    owner: str, bed: Bed, points: tuple[Array, Array], normal: Depth | Force, count: int, tolerance: float
) -> Iterator[tuple[CoupledCells, MarchedPoint]]:
    """Yield the cells at every point of a path, (times, depths or forces)."""
    reach = contact_reach(owner, bed, normal, float(np.max(points[1])))
    return walked(owner, bed, points, normal, tolerance, lambda wide: cells_of(bed, wide, count), reach)


def walked(
    owner: str,
    bed: Bed | LineBed,
    points: tuple[Array, Array],
    normal: Depth | Force,
    tolerance: float,
    cells_up_to: Callable[[float], CoupledCells],
    reach: float,
) -> Iterator[tuple[CoupledCells, MarchedPoint]]:
    """Yield the cells at every point of a path, (times, depths or forces); wider cells start again from the first.

    Parameters
    ----------
    owner, bed, points, normal, tolerance
        As of `marched`; forces of a line bed are those per length.
    cells_up_to : callable
        Cells up to a radius or half-width [m].
    reach : float
        Up to where contacts are expected to reach [m].
    """
    times, loads = points
    done = 0
    for _ in range(MOST_WIDENINGS):
        march = LayeredMarch(owner, bed, cells_up_to(reach), tolerance)
        march.time = float(times[0])
        try:
            for i, (time, load) in enumerate(zip(times.tolist(), loads.tolist(), strict=True)):
                point = march.go(time, normal, float(loads[max(i - 1, 0)]), load)
                if i >= done:
                    done += 1
                    yield march.cells, point
            return
        except TooNarrow:
            reach *= WIDENED
    raise NotConverged(f"{owner}: the contact grows without end; press less, or end the path before.")


def marched(
    owner: str, bed: Bed, times: Array, normal: Depth | Force, loads: Array, count: int, tolerance: float
) -> Iterator[tuple[CoupledCells, MarchedPoint]]:
    """Return the cells and what is known at every point of a path.

    Parameters
    ----------
    owner : str
        For errors.
    bed : Bed
        On a medium `RelaxingByWaves`.
    times : ndarray, (steps,)
        [s].
    normal : Depth or Force
        What is prescribed.
    loads : ndarray, (steps,)
        Depths [m] or forces [N].
    count : int
        How many cells.
    tolerance : float
        Of the depth or force in one step, over the greatest one so far.
    """
    return _walked(owner, bed, (times, loads), normal, count, tolerance)


def stepped(owner: str, bed: Bed, time: Array, load: Depth | Force, cells: int = STEP_CELLS) -> tuple[Array, ...]:
    """Return depth [m], force [N] and radius [m] at times [s] after a sudden depth or force."""
    moments, place = np.unique(time, return_inverse=True)
    number = float(load.depth if isinstance(load, Depth) else load.force)
    times, loads = np.concatenate([[0.0], moments]), np.full(moments.size + 1, number)
    found = [point.state for _, point in _walked(owner, bed, (times, loads), load, cells, 0.0)]
    rows = [[getattr(state, name) for state in found[1:]] for name in ("depth", "force", "radius")]
    return tuple(np.array(row)[place] for row in rows)


def complex_stiffness(bed: Bed, radius: float, frequency: Array) -> ComplexArray:
    """Return the stiffness [N/m] of a contact of a fixed radius [m] at angular frequencies [rad/s]."""
    coarse, fine = (_punch(bed, radius, frequency.ravel(), count) for count in (PUNCH_CELLS // 2, PUNCH_CELLS))
    return np.asarray(fine + (fine - coarse) / 3.0).reshape(frequency.shape)


def _punch(bed: Bed, radius: float, frequency: Array, count: int) -> ComplexArray:
    cells = cells_of(bed, radius, count)
    parts = 1.0 / (1.0 + 1j * frequency[:, None] * cells.times)
    kernels = cells.kernels[0] + parts @ cells.kernels[1:]
    ones = np.full(count, cells.width, dtype=complex)
    return np.array([2.0 * ones @ np.linalg.solve(cells.matrix(kernel), ones) for kernel in kernels])
