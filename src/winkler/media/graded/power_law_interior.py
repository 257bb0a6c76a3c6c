r"""The field inside a body whose modulus follows a power of the depth, by Hankel integrals.

A wave of the wave number :math:`\xi` feels the modulus :math:`(z\xi)^k` times that at the depth :math:`1/\xi`: its
amplitudes are the same functions of :math:`x=\xi z` for all waves.  They are integrated once for each exponent and
Poisson's ratio, from where they have died out towards the surface, in :math:`x^{1-|k|}`, over which they are smooth.
Springs displaced by u(t) press with

.. math:: \hat p(\xi) = \int_0^a p\,J_0(\xi r)\,r\,\mathrm dr = \frac{E^*}{\pi c_0^k}\,2^{m-1}\Gamma(m)\,\xi^{1-m}
          \int_0^a u(t)\,t^m J_{m-1}(\xi t)\,\mathrm dt , \qquad m = \frac{1+k}2 .
"""

from __future__ import annotations

import functools
import math
from typing import Any

import numpy as np

from winkler.materials.elastic import Elastic
from winkler.materials.graded import PowerLawGraded
from winkler.media.layered.coated_interior import WaveState, superposed
from winkler.media.layered.hankel_waves import LARGEST_PHASE, HankelWaves, RadialWaves
from winkler.media.layered.wave_constants import constants_of
from winkler.media.medium import Displacement
from winkler.media.offers import INSIDE_FROM
from winkler.media.punch_field import BodyField
from winkler.numerics.caching import cached_by_value
from winkler.numerics.panels.sqrt_panels import doubled, nodes
from winkler.numerics.transforms.cosine_transform import NODES, wave_numbers
from winkler.numerics.types import Array
from winkler.values.errors import OutsideValidity

DECAYED = 34.0
"""x at which the amplitudes are nothing."""
DEEPEST = 60.0
"""x from which they are integrated: the part that grows downward has fallen by exp(-2 (60 - 34)) where they count."""
STEEPEST = 0.9
"""Greatest size of the exponent."""
FIRST_WAVE = 1e-3
FIRST_SPRING = 2.0**-24
BESSEL_STEP = 0.02
"""Step of a cubic spline of y^(1-m) J_(m-1)(y), which errs by its fourth power."""
MOST_RADII = 20.0
"""Greatest distance from the axis, in contact radii."""


def field(displacement: Displacement, body: PowerLawGraded, surface_modulus: float, r: Array, z: Array) -> BodyField:
    """Return stresses [Pa] and displacements [m] in one of two bodies.

    Parameters
    ----------
    displacement : Displacement
        u(x) of the springs; hashable.
    body : PowerLawGraded
        The body.
    surface_modulus : float
        E* / c_0^k of the pair [Pa m^-k].
    r, z : ndarray
        Distance from the axis and depth [m], of one shape.

    Raises
    ------
    OutsideValidity
        If a point lies less than 0.02 contact radii below the surface or more than 20 from the axis, or the exponent
        is beyond 0.9 in size.
    """
    k, a, shape = body.exponent, displacement.radius, np.shape(r)
    r, z = np.ravel(r), np.ravel(z)
    result = np.zeros((6, r.size))
    if abs(k) > STEEPEST:
        raise OutsideValidity(
            f"GradedHalfSpace: stresses inside are implemented for exponents from -{STEEPEST} to {STEEPEST}, not for "
            f"{k:g}; request the surface (without z), or sample the grading by a layered medium."
        )
    if a > 0.0 and r.size:
        if np.min(z) < INSIDE_FROM * a or np.max(r) > MOST_RADII * a:
            raise OutsideValidity(
                f"GradedHalfSpace: stresses inside are implemented from {INSIDE_FROM} contact radii below the surface "
                f"and up to {MOST_RADII:g} from the axis, here z >= {INSIDE_FROM * a:.6g} m and "
                f"r <= {MOST_RADII * a:.6g} m; request such places, or the surface (without z)."
            )
        reach = 2.0 ** math.ceil(math.log2(max(np.max(r) / a, 1.25)))
        waves = _waves(displacement, k, surface_modulus, reach)
        table, radial = _amplitudes(k, body.poisson), RadialWaves(waves.xi)
        surface = body.young / (2.0 * (1.0 + body.poisson)) * (waves.xi * body.depth_scale) ** -k
        for depth in np.unique(z):
            end = int(np.searchsorted(waves.xi, DECAYED / depth))
            x = waves.xi[:end] * depth
            states = table(x ** (1.0 - abs(k))) * np.exp(-x)[:, None]
            solid = Elastic(float(body.young_at(depth)), body.poisson)
            state = WaveState(states[:, :2] / surface[:end, None], states[:, 2:], solid)
            (members,) = np.nonzero(z == depth)
            result[:, members] = superposed(state, waves.up_to(end), radial, r[members], end)
    return BodyField(*(part.reshape(shape) for part in result))


@functools.lru_cache(maxsize=32)
def _amplitudes(k: float, poisson: float) -> Any:
    """Return displacements times xi and the shear modulus at 1/xi, and tractions, times exp(x), over x^(1-|k|)."""
    from scipy.integrate import solve_ivp
    from scipy.interpolate import CubicSpline

    one, power = constants_of(Elastic(1.0, poisson)), 1.0 - abs(k)
    n, axial, plane = one.lateral, one.axial, one.plane

    def slopes(y: float, values: Array) -> Array:
        x = y ** (1.0 / power)
        u, w, t, s = values.reshape(4, 2)
        step, soft, stiff = x ** abs(k), x ** max(-2.0 * k, 0.0) if k < 0.0 else 1.0, x ** max(2.0 * k, 0.0)
        # step / x^k and step x^k
        rows = step * w + soft * t, -n * step * u + axial * soft * s, plane * stiff * u + n * step * s, -step * t
        return np.ravel(np.stack(rows) + step * values.reshape(4, 2)) / power

    half_space = np.array(one.half_space).reshape(2, 2) / DEEPEST**k
    start = np.concatenate([half_space, np.eye(2)])
    # towards the surface; knots are dense there
    ends = DEEPEST**power * np.linspace(1.0, 0.0, 6001) ** 3
    found = solve_ivp(slopes, (ends[0], 0.0), start.ravel(), "DOP853", ends, rtol=1e-11, atol=1e-13)
    states = found.y.T.reshape(-1, 4, 2)
    amounts = np.linalg.solve(states[-1, 2:], [0.0, -1.0])
    return CubicSpline(ends[::-1], (states @ amounts)[::-1])


@cached_by_value(8)
def _waves(displacement: Displacement, k: float, surface_modulus: float, reach: float) -> HankelWaves:
    """Return the pressure as waves, for places up to `reach` radii from the axis."""
    from scipy.interpolate import CubicSpline
    from scipy.special import gamma, jv

    a, m = displacement.radius, 0.5 * (1.0 + k)
    end = DECAYED / (INSIDE_FROM * a)
    xi, weights = wave_numbers(FIRST_WAVE / a, LARGEST_PHASE / (a * (1.0 + reach)), end)
    kinks = np.array([b for b, _ in displacement.kinks if 0.0 < b < a])
    steps = np.arange(1.0, np.ceil(a * end / LARGEST_PHASE)) * (LARGEST_PHASE / end)
    small = a * FIRST_SPRING * 2.0 ** np.arange(24)
    edges = np.unique(np.concatenate([[0.0, a], small, doubled(list(kinks), a), steps[steps < a]]))
    t, shares = (part[0] for part in nodes(edges[None], kinks, NODES))
    y = np.arange(0.0, a * end * (1.0 + 1e-9) + 2.0 * BESSEL_STEP, BESSEL_STEP)
    bessel = np.append(2.0 ** (1.0 - m) / gamma(m), y[1:] ** (1.0 - m) * jv(m - 1.0, y[1:]))
    curve = CubicSpline(y, bessel)
    load = shares * displacement.value(t) * t**k  # t^m J(xi t) = t^k xi^(m-1) curve
    transform = np.concatenate([curve(np.outer(part, t)) @ load for part in np.array_split(xi, 1 + xi.size // 256)])
    factor = surface_modulus / math.pi * 2.0 ** (m - 1.0) * float(gamma(m))
    return HankelWaves(xi, weights * xi * factor * transform)
