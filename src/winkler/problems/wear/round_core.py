r"""The core of a fretting contact that sticks before wear and in the end, under a steady depth and amplitude.

Where all springs have one ratio of stiffnesses both are the same: springs within the core bear what they did.  On
layers what a spring bears before it slides depends on the pressure outside of it, which wear takes away.  In the end
the core bears alone, and its edge sticks if

.. math:: G^*\,U\,\varphi_S(c;c) \le \mu E^*\,(d-g(c))\,\varphi_N(c;c) ,

the singular traction beside the singular pressure.  A core that does not hold this shrinks to where it does; one that
holds it grows somewhat while its surroundings wear, by how much depends on the order in which they do.
"""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from winkler.foundation.foundation import Foundation
from winkler.loading.loads import Depth, ShearForce
from winkler.loading.path import numbers_of
from winkler.media.offers import PressedWaves, offers
from winkler.numerics.equations.bracketing import between
from winkler.numerics.transforms import fredholm
from winkler.numerics.types import Array
from winkler.problems.friction.damping import FrictionDamping
from winkler.problems.friction.damping_springs import SlippingSprings
from winkler.problems.normal.indentation import Indentation, IndentationSolution
from winkler.problems.ring_slip.pushed_rings import pushed_rings
from winkler.problems.wear.grids import wear_grid
from winkler.problems.wear.nodes import graded_nodes, halved, nodes_between
from winkler.problems.wear.round_grid import RoundGrid
from winkler.problems.wear.worn_states import round_nodes, unworn

SAMPLES = 513
MIDDLE_RADIUS = 1e-9
"""Part of the contact that stands for its middle, where springs of graded media are known in the limit only."""
EVEN_CELLS, FEW_CELLS, EVEN_REACH = 128, 48, 1.02
"""Cells of even grids on which a core is found, and on which it is sought to lay nodes; their reach over the radius."""
NARROWEST_RING = 1e-9
"""Part of the contact radius below which a ring that slips is none."""


class StuckRadii(NamedTuple):
    """The radius of what sticks [m]: before wear, and at most where the core bears alone; zero or a as there."""

    first: float
    alone: float


def spring_core(bed: Foundation, coefficient: float, depth: float, radius: float, shift: float) -> float:
    """Return the radius up to which springs stick [m], by themselves; the contact radius if all do, zero if none."""

    def margin(x: Array) -> Array:
        ratio = bed.normal_stiffness(x) / bed.tangential_stiffness(x)
        return np.asarray(coefficient * ratio * (depth - bed.gap(x)) - shift)

    return _up_to(margin, radius)


def layered_core(bed: Foundation, coefficient: float, depth: float, radius: float, shift: float) -> StuckRadii:
    """Return the core on layers, by the kernels of the layers.

    Parameters
    ----------
    bed : Foundation
        On bonded layers or a depth grading.
    coefficient : float
        mu [-].
    depth, radius, shift : float
        d, a and the amplitude U [m].
    """
    rings = pushed_rings(bed, coefficient, depth, radius)
    if rings is not None:
        first = rings.stick_radius(shift)
    else:
        grid = _even_grid(bed, radius, EVEN_CELLS)
        first = grid.rub(grid.press(np.zeros(grid.nodes.size), Depth(depth)), coefficient, shift).stick_radius
    first = first if _slips(first, radius) else radius
    return StuckRadii(first, _lone_core(bed, coefficient, depth, radius, shift))


def _lone_core(bed: Foundation, coefficient: float, depth: float, radius: float, shift: float) -> float:
    """Return the widest core on layers that sticks at its edge if it bears alone [m]; parameters as `layered_core`."""
    medium: Any = bed.medium

    def margin(x: Array) -> Array:
        normal = coefficient * medium.modulus * fredholm.edge(medium.response, x) * (depth - bed.gap(x))
        sheared = medium.shear_modulus * fredholm.edge(medium.tangential_response, x) * shift
        return np.asarray((normal - sheared) / medium.modulus)

    return _up_to(margin, radius)


def _even_grid(bed: Foundation, radius: float, cells: int) -> RoundGrid:
    """Return a bed on a grid of even cells that reaches a little beyond the contact radius [m]."""
    return wear_grid(bed, graded_nodes(0.0, min(EVEN_REACH * radius, bed.rim), bed.rim, cells))


def _slips(core: float, radius: float) -> bool:
    """Return whether a ring around a core slips, within a contact radius [m]."""
    return core < radius * (1.0 - NARROWEST_RING)


def fretting_nodes(problem: Any) -> Array:
    """Return the radii on which a `FrettingWear` begins to wear."""
    if offers(problem.bed.medium, PressedWaves):
        return _layered_nodes(problem)
    return round_nodes(problem, lambda pressed: _stick_radius(problem, pressed))


def _stick_radius(problem: Any, pressed: IndentationSolution) -> float:
    """Return the radius of the core that sticks at first [m], as of a lower depth; zero if all sticks or slips."""
    most = problem.law.coefficient * float(pressed.force)
    if isinstance(problem.amplitude, ShearForce) and float(problem.amplitude.shear_force) >= most:
        return 0.0
    springs = SlippingSprings(problem.law.coefficient, pressed)
    moved = float(FrictionDamping(problem.bed, problem.law, problem.normal, problem.amplitude).solve().shift)
    if moved >= springs.reach:
        return 0.0
    core = float(Indentation(problem.bed, Depth(springs.depth * (1.0 - moved / springs.reach))).solve().radius)
    return core if core < springs.radius else 0.0


def _layered_nodes(problem: Any) -> Array:
    """Return the radii on which a `FrettingWear` on layers begins to wear.

    Where something sticks they are close together between the core before wear and that which bears alone.
    """
    even = round_nodes(problem)
    bed, reach = problem.bed, float(even[-1])
    if reach == bed.rim:
        return even
    grid = _even_grid(bed, float(Indentation(bed, problem.normal).solve().radius), FEW_CELLS)
    contact = grid.press(np.zeros(grid.nodes.size), problem.normal)
    rubbed = problem.rubbed(grid, contact)
    first = rubbed.stick_radius
    if first == 0.0 or not _slips(first, contact.radius):
        return graded_nodes(0.0, reach, bed.rim, problem.count)
    # under a steady force the core takes over what the worn ring lets go: what bears alone is not known before
    held = isinstance(problem.normal, Depth)
    alone = _lone_core(bed, problem.law.coefficient, contact.depth, contact.radius, rubbed.shift) if held else first
    low, high = sorted((first, alone if alone > 0.0 else first))
    return nodes_between(low, high, reach, problem.count)


def expected_loss(problem: Any, nodes: Array, found: float) -> float:
    """Return what a `FrettingWear` on layers loses in a cycle before wear [J], on a grid without end.

    Where that is not known, it follows from half of the nodes: errors are of second order.

    Parameters
    ----------
    problem : FrettingWear
    nodes : ndarray, (n,)
        On which it begins to wear [m].
    found : float
        What it loses there [J].
    """
    contact, coefficient = Indentation(problem.bed, problem.normal).solve(), problem.law.coefficient
    rings = pushed_rings(problem.bed, coefficient, float(contact.depth), float(contact.radius))
    if rings is not None:
        size = np.array([float(numbers_of(problem.amplitude))])
        return float(rings.loss(rings.shift(size) if isinstance(problem.amplitude, ShearForce) else size)[0])
    return found + (found - float(problem.state(unworn(halved(nodes))).loss_per_cycle)) / 3.0


def _up_to(margin: Any, radius: float) -> float:
    """Return up to where a margin is not negative [m]; the radius if nowhere, zero if it is so from the middle on."""
    place = radius * np.linspace(0.0, 1.0, SAMPLES)
    place[0] = MIDDLE_RADIUS * radius
    sticks = margin(place) >= 0.0
    if not sticks[0]:
        return 0.0
    if np.all(sticks):
        return radius
    last = int(np.argmin(sticks)) - 1
    return float(between(lambda x, _: margin(x), place[last : last + 1], place[last + 1 : last + 2])[0])
