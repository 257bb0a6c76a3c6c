"""The normal contact of a body of revolution without friction, as a law for other programs."""

from __future__ import annotations

import numpy as np

from winkler.exporting.step_law import LawTable, StepLaw, StepNumber
from winkler.exporting.translation.plain import plain
from winkler.foundation.bed import Bed
from winkler.foundation.footprint import EllipticOutline
from winkler.loading.loads import Depth
from winkler.numerics.types import Array
from winkler.problems.normal.indentation import Indentation
from winkler.problems.normal.stiffness_ratio import alike, stiffness_ratios
from winkler.problems.particles.contact_law import CHECK_POSITIONS, SAFETY_FACTOR, first_radius
from winkler.problems.particles.table_step import cubic_energy, follow_table, monotone_intervals, step_table
from winkler.values.errors import InvalidInput, NotConverged, OutsideValidity

MOTION = (StepNumber("depth", "m", "d at the end of the step, not positive without contact"),)
ANSWER = (
    StepNumber("force", "N", "normal force, compression positive"),
    StepNumber("stiffness", "N/m", "dF/dd"),
    StepNumber("energy", "J", "elastic energy, the integral of the force"),
)
SHEAR = StepNumber("shear_stiffness", "N/m", "of the contact along the surface while nothing slips")
BEYOND = "Beyond the greatest depth nothing is known: the answer is not-a-number."
FIRST_INTERVALS, MOST_REFINEMENTS, MOST_ROWS = 8, 30, 20_000
ROUNDING = 1e-12
"""A power that is off by no more than this part of the force is the law itself."""
LAST_DIGITS = 1e-15
"""Of a force, over the greatest one."""
SEED = 20260725


def normal_law(bed: Bed, deepest: float, tolerance: float, inputs: tuple[str, ...]) -> StepLaw:
    """Return the law of a contact without friction.

    Parameters
    ----------
    bed : Bed
    deepest : float
        Up to which depth [m].
    tolerance : float
        Error of the force between the rows, over the greatest force.
    inputs : tuple of str

    Raises
    ------
    InvalidInput
        If the deepest load presses nothing.
    NotConverged
        If the table would need too many rows.
    """
    tables, error = force_table(bed, deepest, tolerance)
    rng = np.random.default_rng(SEED)
    trial = deepest * np.append(rng.uniform(-0.1, 1.0, 40), [0.0, 1.0, 1e-6])
    ratios = _shear_ratio(bed, deepest)
    shear = LawTable("shear", "stiffness against shear over that against pressing", ratios)
    notes = (*normal_notes(error), *map(str, Indentation(bed, Depth(deepest)).solve().validity))
    title = "A contact without friction and adhesion: one curve for loading and unloading"
    answer = (*ANSWER, SHEAR) if ratios.size else ANSWER
    return StepLaw(title, step_table, (*tables, shear), (), MOTION, answer, notes, inputs, trial[:, np.newaxis])


def normal_notes(error: float) -> tuple[str, ...]:
    """Return what is to be said of the table."""
    how = "closed form" if error <= ROUNDING else "cubics between rows"
    return (
        f"The normal force ({how}) is off by at most {error:.2g} of the greatest, as measured at five places between "
        "all rows; the stiffness never falls, and the energy is the integral of just this force.",
        BEYOND,
    )


def _shear_ratio(bed: Bed, deepest: float) -> Array:
    """Return the one ratio of the stiffnesses; empty if no single number describes it, as on layers or of ellipses."""
    if isinstance(bed.footprint, EllipticOutline):
        return np.zeros(0)
    widest = float(np.max(Indentation(bed, Depth(deepest)).solve().radius))
    try:
        ratios = stiffness_ratios(bed, widest)
    except OutsideValidity:
        return np.zeros(0)
    return np.array(ratios[1:]) if alike(ratios) else np.zeros(0)


def force_table(bed: Bed, deepest: float, tolerance: float) -> tuple[tuple[LawTable, ...], float]:
    """Return depths, forces, stiffnesses and energies, and the greatest error of the force over the greatest force.

    Raises
    ------
    InvalidInput, NotConverged
        As `normal_law`.
    """
    if not deepest > 0.0:
        raise InvalidInput(f"export: the deepest load presses {deepest:g} m deep; give one that presses the bodies.")
    depth = deepest * np.array([0.0, 1.0])
    force, stiffness = _pressed(bed, depth)
    if stiffness[0] == 0.0 and (error := float(np.max(_errors(bed, depth, force, stiffness)))) <= ROUNDING:
        return _tables(depth, force, stiffness), error
    depth = deepest * np.linspace(0.0, 1.0, FIRST_INTERVALS + 1) ** 2
    force, stiffness = _pressed(bed, depth)
    for _ in range(MOST_REFINEMENTS):
        errors = _errors(bed, depth, force, stiffness)
        coarse = np.flatnonzero((errors > tolerance) | ~monotone_intervals(depth, force, stiffness))
        if not coarse.size:
            return _tables(depth, force, stiffness), float(np.max(errors))
        if depth.size + coarse.size > MOST_ROWS:
            break
        depth = np.sort(np.concatenate([depth, 0.5 * (depth[coarse] + depth[coarse + 1])]))
        force, stiffness = _pressed(bed, depth)
    raise NotConverged(
        f"export: {depth.size} rows do not give a table whose stiffness never falls, to {tolerance:g} of the force; "
        "give a greater tolerance."
    )


def _pressed(bed: Bed, depth: Array) -> tuple[Array, Array]:
    """Return force and stiffness at depths that begin with zero."""
    pressed = Indentation(bed, Depth(depth)).solve()
    stiffness = np.array(pressed.stiffness)
    stiffness[0] = float(bed.stiffness(np.array([first_radius(bed)]))[0])  # as it begins to touch
    return np.array(pressed.force), stiffness


def _errors(bed: Bed, depth: Array, force: Array, stiffness: Array) -> Array:
    """Return a bound of the error of every interval over the greatest force, a little above what is measured."""
    energy = _energies(depth, force, stiffness)
    places = depth[:-1, None] + np.diff(depth)[:, None] * CHECK_POSITIONS
    true = np.asarray(Indentation(bed, Depth(places.ravel())).solve().force).reshape(places.shape)
    follow = plain(follow_table)
    found = [follow(depth, force, stiffness, energy, float(d))[0] for d in places.ravel()]
    measured = np.max(np.abs(np.reshape(found, places.shape) - true), axis=1) / force[-1]
    return np.asarray(measured / SAFETY_FACTOR + LAST_DIGITS)


def _energies(depth: Array, force: Array, stiffness: Array) -> Array:
    """Return the integral of the interpolated force up to every row."""
    width, mean = np.diff(depth), np.diff(force) / np.diff(depth)
    pieces = [
        plain(cubic_energy)(*row, 1.0)
        for row in zip(force[:-1], stiffness[:-1], mean, stiffness[1:], width, strict=True)
    ]
    if stiffness[0] == 0.0:
        pieces[0] = force[1] * depth[1] / (stiffness[1] * depth[1] / force[1] + 1.0)
    return np.concatenate([[0.0], np.cumsum(pieces)])


def _tables(depth: Array, force: Array, stiffness: Array) -> tuple[LawTable, ...]:
    return (
        LawTable("depth", "d [m] of the rows", depth),
        LawTable("force", "F [N]", force),
        LawTable("stiffness", "dF/dd [N/m]", stiffness),
        LawTable("energy", "J up to each row", _energies(depth, force, stiffness)),
    )
