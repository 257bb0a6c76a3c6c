r"""The depth of a line contact on layers, where it has one: the layers lie on a rigid base; elsewhere the approach.

Averaged over the strip with the weight of a flat punch's pressure, the surface sinks by

.. math:: \delta = \bar f + \frac2\pi\int_0^\infty\Big[(1+M)\,J_0(ka) - \tfrac12E^*kU(k)\Big]\frac{\hat p}{E^*k}\,
          \mathrm dk ,

where :math:`U\,\hat p\cos kx` are the displacements of the points against which it is counted.  On a rigid base under a
rigid body U is zero and :math:`1+M\propto k` for long waves.  With

.. math:: \int_0^\infty\frac{1-e^{-kL}}k J_0^2(ka)\,\mathrm dk
          = \frac1\pi\int_0^\pi\ln\frac{L+\sqrt{L^2+4a^2\sin^2(\theta/2)}}a\,\mathrm d\theta , \qquad
          \int_0^\infty J_0J_{2n}\frac{\mathrm dk}k = 0

what is left dies out like :math:`e^{-2kh}`.
"""

from __future__ import annotations

import math
from numbers import Real
from typing import cast

import numpy as np

from winkler.foundation.layered_line import LayeredLineFoundation
from winkler.foundation.strip_waves import averages
from winkler.materials.elastic import Elastic, Rigid
from winkler.media.layered import depth_interior
from winkler.media.layered.coated_interior import wave_states
from winkler.media.layered.depth_response import GradedBody
from winkler.media.layered.stack import StackBody
from winkler.media.offers import PlaneMedium
from winkler.numerics.transforms.cosine_transform import DECAY_SPAN, wave_numbers
from winkler.numerics.transforms.strips.strip_equation import LOCAL_PHASE, excess_at
from winkler.numerics.types import Array
from winkler.problems.line.approach import depth_of
from winkler.problems.line.references import PlateBase, Reference, RollerCentre
from winkler.values.errors import InvalidInput, OutsideValidity

FIRST_WAVE_NUMBER, LARGEST_PHASE = 0.1, 12.0
POINTS, POINTS_PER_RATIO = 64, 48


def has_depth(medium: object) -> bool:
    """Return whether a depth needs no reference: on layers that a rigid base holds, or moduli that grow forever."""
    held = isinstance(getattr(medium, "on", None), Rigid) and isinstance(getattr(medium, "second", None), Rigid)
    return held or getattr(medium, "exponent", 0.0) > 0.0


def layered_approach(
    bed: LayeredLineFoundation,
    half_width: float,
    rim_load: float,
    first: float | Reference | None,
    second: float | Reference | None,
) -> float:
    """Return how far two points on the axis have come together [m], one in each body.

    Parameters
    ----------
    bed : LayeredLineFoundation
    half_width, rim_load : float
        As of `LayeredLineFoundation.pressure`.
    first : float or None
        Depth [m] of the point in the body that carries the layers; on a rigid base it is not used.
    second : float, RollerCentre, PlateBase or None
        Depth [m] of the point in the other body, or a finite body; of a rigid one it is not used.
    """
    medium = cast(PlaneMedium, bed.medium)
    below = _first_depth(medium, first) if not isinstance(bed.strained, Rigid) else math.inf
    above, added = math.inf, 0.0
    if not isinstance(medium.second, Rigid):
        above, added = _second_depth(medium, second, half_width)
    if half_width == 0.0:
        return 0.0
    carried, response = bed.carried(half_width, rim_load), medium.response
    shortest, end = min(response.smooth, above), 0.0
    if response.smooth > response.length:
        end = LOCAL_PHASE / half_width
    k, weights = wave_numbers(
        FIRST_WAVE_NUMBER / max([response.span, *(depth for depth in (below, above) if depth < math.inf)]),
        LARGEST_PHASE / (2.0 * half_width),
        max(2.0 * DECAY_SPAN / shortest, end),
    )
    from scipy.special import j0

    flat, pressed = j0(k * half_width), bed.transform(k, carried)
    widths, loads = bed.beside(half_width)
    load = float(bed.load_profile(np.array([half_width]))[0]) + rim_load + float(np.sum(loads))
    surface = excess_at(response, k) * pressed * flat + np.exp(-2.0 * k * shortest) * load * flat**2
    references = 0.5 * medium.modulus * pressed * (_moved_first(bed, k, below) + _moved_second(medium, k, above))
    waves = float(weights @ ((surface - references) / k))
    mean = float(averages(bed.half_plane, np.array([half_width]))[0])
    mean -= 2.0 / math.pi * float(loads @ np.log(widths / half_width))  # what they sink by is that of wider punches
    return mean + 2.0 / math.pi * (load * (_logarithm(2.0 * shortest / half_width)) + waves) + load * added


def _logarithm(ratio: float) -> float:
    """Return the integral of (1 - exp(-k L)) J_0(ka)^2 / k, from L/a."""
    count = POINTS + math.ceil(POINTS_PER_RATIO / ratio)
    angle = math.pi * (np.arange(count) + 0.5) / count
    return float(np.mean(np.log(ratio + np.hypot(ratio, 2.0 * np.sin(0.5 * angle)))))


def _first_depth(medium: PlaneMedium, place: float | Reference | None) -> float:
    if not isinstance(place, Real) or not medium.thickness <= place < math.inf:
        raise InvalidInput(
            "A line contact on layers has no depth of its own unless a rigid base carries them. Give the depth below "
            f"the first body's surface against which it is counted, finite and at least the {medium.thickness:.6g} m "
            "of the layers or the grading."
        )
    return float(place)


def _second_depth(medium: PlaneMedium, place: float | Reference | None, half_width: float) -> tuple[float, float]:
    """Return the depth in the second body [m], and what its finite size adds over the load per E*."""
    body = medium.second
    if not isinstance(body, Elastic):
        raise OutsideValidity(
            "Displacements inside a transversely isotropic second body are not implemented; give an Elastic "
            "or a Rigid one."
        )
    depth = depth_of(place, "second", half_width)
    if not isinstance(place, RollerCentre | PlateBase):
        return depth, 0.0
    share = medium.modulus * (1.0 - body.poisson**2) / (math.pi * body.young)
    return depth, share * place.added(body.poisson)


def _moved_first(bed: LayeredLineFoundation, k: Array, depth: float) -> Array:
    """Return displacements times k per pressure of 1 [1/Pa] in the body under the layers."""
    moved = np.zeros(k.size)
    if depth < math.inf:
        body = bed.layered_body
        if isinstance(body, GradedBody):
            return depth_interior.sunk(body.grading, body.tolerance, k, depth)
        stack = StackBody(bed.layered.stack, bed.layered.on)
        at = np.array([np.nextafter(max(depth, float(stack.bottoms[-1])), math.inf)])
        for _, state, end in wave_states(stack, at, k):
            moved[:end] = state.moved[:end, 1]
    return moved


def _moved_second(medium: PlaneMedium, k: Array, depth: float) -> Array:
    """Return the same of the second body, a half-plane."""
    body = medium.second
    if depth == math.inf or not isinstance(body, Elastic):
        return np.zeros(k.size)
    return (1.0 + body.poisson) / body.young * (2.0 * (1.0 - body.poisson) + k * depth) * np.exp(-k * depth)
