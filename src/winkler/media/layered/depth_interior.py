r"""Stresses and displacements inside a body graded in depth, by Hankel integrals.

The tractions on the surface, :math:`\hat p\,J_0(\xi r)`, decay with depth as `winkler.media.layered.depth_recursion`
computes. Near the surface, where short waves count, the field of a homogeneous half-space made of the surface under the
same pressure is taken out: it is known without an integral over waves (`winkler.media.interior.subsurface`), and what
is left of the amplitudes falls like :math:`1/\xi` even on the surface.  Its strains are those of the surface: below it
the stresses along the surface follow from them with the moduli at that depth.  Waves shorter than a 3000th of the
contact are left out, which matters at depths below a hundredth of the radius.  Against twice as many waves (E three
times stiffer far below) that cost 1e-7 of the mean pressure under a paraboloid or a cone; under a flat punch 3e-6, and
1e-4 at a hundredth of the radius from its edge.

The amplitudes at one depth are smooth functions of the wave number times :math:`e^{-\xi z}`; they are kept as
polynomials, octave by octave, and evaluated at the many wave numbers of the integrals.
"""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from winkler.materials.depth_grading import DepthGrading
from winkler.materials.elastic import Elastic
from winkler.media.interior import subsurface
from winkler.media.layered.blocks import scaled, times
from winkler.media.layered.coated_interior import WaveState, superposed
from winkler.media.layered.coated_load import CarriedLoad
from winkler.media.layered.depth_recursion import Mesh, mesh, states_with_depth
from winkler.media.layered.depth_response import solid_at
from winkler.media.layered.hankel_waves import LARGEST_PHASE, MOST_PAIRS, RadialWaves, waves_of
from winkler.media.layered.wave_constants import constants_of
from winkler.media.punch_field import BodyField
from winkler.numerics.integrals.quadrature import growing
from winkler.numerics.panels.chebyshev import fit_nodes, panels_from
from winkler.numerics.transforms.cosine_transform import NODES
from winkler.numerics.types import Array
from winkler.values.errors import OutsideValidity

LARGEST_WAVE_NUMBER = 3000.0
"""Largest wave number, over the contact radius, near the surface."""
DECAY_DEPTH = 34.0
"""A wave is nothing below this depth over its wave number."""
LEAST_RADIUS_RATIO = 1e-6
"""Nearest to the axis at which a point of the surface is evaluated, over the contact radius."""
WAVES_AT_ONCE = 64
"""Depths for which the recursion through the body runs at once."""
LEAST_WAVE_NUMBER = 1e-3


def field(load: CarriedLoad, grading: DepthGrading, tolerance: float, modulus: float, r: Array, z: Array) -> BodyField:
    """Return stresses and displacements inside the graded body.

    Parameters
    ----------
    load : CarriedLoad
        The pressure.
    grading : DepthGrading
        A value.
    tolerance : float
        Relative error of the amplitudes of the waves.
    modulus : float
        E* of the surface and the counterpart [Pa].
    r, z : ndarray
        Of one shape [m].

    Raises
    ------
    OutsideValidity
        If a point lies thousands of contact radii from the axis and near the surface.
    """
    shape, r, z = np.shape(r), np.ravel(r), np.ravel(z)
    result = np.zeros((6, r.size))
    a = load.radius
    if a == 0.0 or r.size == 0:
        return BodyField(*(part.reshape(shape) for part in result))
    near = z < a
    top = solid_at(grading)
    if near.any():
        # a slope of the load that misses zero at the axis by rounding would be an infinite pressure in its middle
        beside = np.where(z == 0.0, np.maximum(r, LEAST_RADIUS_RATIO * a), r)
        own = subsurface.field(load, beside[near], z[near], modulus=modulus, poisson=top.poisson, shear=top.shear)
        result[:, near] = own
        result[:2, near] = _strained(own, top, grading, z[near])
    depths = np.unique(z)
    end = min(LARGEST_WAVE_NUMBER / a, DECAY_DEPTH / depths[0]) if depths[0] > 0.0 else LARGEST_WAVE_NUMBER / a
    farthest = float(np.max(r))
    if (end * (a + farthest)) * (end * a) * (NODES / LARGEST_PHASE) ** 2 > 0.5 * MOST_PAIRS:
        raise OutsideValidity(
            f"Stresses inside a graded body at r = {farthest:.6g} m and z = {depths[0]:.6g} m under a contact of "
            f"{a:.6g} m would need too many waves; request points deeper or nearer to the axis, or for the surface."
        )
    waves = waves_of(load, modulus, farthest, end)
    radial = RadialWaves(waves.xi)
    for start in range(0, depths.size, WAVES_AT_ONCE):
        part = depths[start : start + WAVES_AT_ONCE]
        for depth, state, last in _states(grading, tolerance, part, waves.xi, load.response.span):
            if depth < a:
                without = _decayed(top, waves.xi[:last] * depth, 0.0, -1.0)
                state = WaveState(state.moved - without[:2].T, state.loaded - without[2:].T, state.solid)
            (members,) = np.nonzero(z == depth)
            result[:, members] += superposed(state, waves, radial, r[members], last)
    return BodyField(*(part.reshape(shape) for part in result))


def _strained(own: BodyField, top: Elastic, grading: DepthGrading, z: Array) -> tuple[Array, Array]:
    """Return the radial and hoop stress of a grading under the axial stress and the strains of its surface."""
    radial, hoop, axial = own.radial_stress, own.hoop_stress, own.axial_stress
    young, poisson = grading.young_at(z), grading.poisson_at(z)
    outward = (radial - top.poisson * (hoop + axial)) / top.young
    around = (hoop - top.poisson * (radial + axial)) / top.young
    plane, held = young / (1.0 - poisson**2), poisson / (1.0 - poisson) * axial
    return plane * (outward + poisson * around) + held, plane * (around + poisson * outward) + held


def _states(
    grading: DepthGrading, tolerance: float, depths: Array, xi: Array, span: float
) -> Iterator[tuple[float, WaveState, int]]:
    """Yield, depth by depth, the amplitudes of the waves that matter, and how many these are."""
    bounds = np.array([0.0, *growing(LEAST_WAVE_NUMBER / span, 2.0 * xi[-1], 2.0)])
    samples = fit_nodes(bounds)
    cells = mesh(grading, tolerance, 0.25 / bounds[-1], tuple(float(z) for z in depths))
    for depth, amplitudes in _amplitudes(cells, samples.ravel(), depths):
        last = int(np.searchsorted(xi, DECAY_DEPTH / depth)) if depth > 0.0 else xi.size
        grown = amplitudes * np.exp(np.minimum(samples.ravel() * depth, 2.0 * DECAY_DEPTH))
        held = np.exp(-xi[:last] * depth)
        parts = [panels_from(bounds, row.reshape(samples.shape))(xi[:last]) * held for row in grown]
        yield depth, WaveState(np.stack(parts[:2], axis=1), np.stack(parts[2:], axis=1), solid_at(grading, depth)), last


def sunk(grading: DepthGrading, tolerance: float, xi: Array, depth: float) -> Array:
    """Return displacements times xi per pressure of 1 [1/Pa] at one depth [m] below the grading ``(m,)``."""
    result, last = np.zeros(xi.size), int(np.searchsorted(xi, DECAY_DEPTH / depth))
    if last:
        cells = mesh(grading, tolerance, 0.25 / float(xi[last - 1]), (depth,))
        ((_, amplitudes),) = _amplitudes(cells, xi[:last], np.array([depth]))
        result[:last] = amplitudes[1]
    return result


def _amplitudes(cells: Mesh, xi: Array, depths: Array) -> Iterator[tuple[float, Array]]:
    """Yield, depth by depth, displacements times xi and tractions ``(4, m)``."""
    requested = set(depths.tolist())
    rung = None
    for rung in states_with_depth(cells, xi):
        if rung.depth in requested:
            yield rung.depth, np.array(rung[1:])
    assert rung is not None
    deep = Elastic(2.0 * (1.0 + cells.deep_poisson) * cells.deep_shear, cells.deep_poisson)
    for depth in depths[depths > rung.depth]:
        yield float(depth), _decayed(deep, xi * (depth - rung.depth), rung.shear, rung.axial)


def _decayed(solid: Elastic, x: Array, shear: Array | float, axial: Array | float) -> Array:
    """Return displacements times xi and tractions ``(4, m)`` at x below the surface of a half-space under tractions."""
    constants = constants_of(solid)
    decay, compliance = constants.decay(x), scaled(1.0 / constants.shear, constants.half_space)
    moved = times(compliance, decay)
    return np.array([row[0] * shear + row[1] * axial for row in (moved[:2], moved[2:], decay[:2], decay[2:])])
