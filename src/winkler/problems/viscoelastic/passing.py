r"""A spring of a viscoelastic line under a body that passes over it at a steady speed.

In the frame of the body the spring is pressed in from the leading edge on, relaxes meanwhile, and lets go where it
would pull.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from winkler.foundation.bed import Bed
from winkler.loading.loads import Depth, Force
from winkler.numerics.equations.roots import between
from winkler.numerics.integrals.quadrature import gauss_legendre
from winkler.numerics.springs.free_relaxation import Recovery
from winkler.numerics.springs.spring_pass import pass_over
from winkler.numerics.types import Array
from winkler.problems.normal.solve_contact import at_depth, at_end, at_force
from winkler.problems.viscoelastic.march import elastic_like, relaxation_of
from winkler.values.errors import NotConverged, OutsideValidity

__all__ = ["SlidPast", "pass_at_depth", "pass_under_load"]

DOUBLINGS = 200
NODES = 8
"""For what fades within an interval by no more than e: exact to rounding."""
RECONTACT_MARGIN = 1e-6
"""A spring behind the contact is touched again when the body is this part of the depth below it."""


class SlidPast(NamedTuple):
    """What a spring has met under a body at one depth, place by place, with force, resistance and trailing edge."""

    depth: float
    radius: float
    place: Array
    loads: Array
    force: float
    shear_force: float
    trailing_edge: float

    @property
    def touching(self) -> tuple[Array, Array]:
        """Places and loads from the trailing to the leading edge."""
        inside = self.place > self.trailing_edge
        place = np.append(self.place[inside], self.trailing_edge)
        return place[::-1], np.append(self.loads[inside], 0.0)[::-1]


def pass_under_load(bed: Bed, normal: Depth | Force, count: int, speed: float) -> SlidPast:
    """Return what the springs have met at the depth that is prescribed, or that gives the force."""
    if isinstance(normal, Depth):
        return pass_at_depth(bed, count, float(normal.depth), speed)
    wanted = float(normal.force)
    elastic = elastic_like(bed)
    series = relaxation_of("", bed)
    finite = [modulus for modulus in (series.relaxed, series.glassy) if 0.0 < modulus < math.inf]
    modulus = finite[0] if finite else float(series.viscosity / np.max(series.times, initial=1.0))
    end, most = at_end(elastic)
    high = low = end if wanted / modulus >= most else float(at_force(elastic, np.array([wanted / modulus]))[0][0])
    for _ in range(DOUBLINGS):
        if pass_at_depth(bed, count, low, speed).force <= wanted:
            break
        high, low = low, 0.5 * low
    for _ in range(DOUBLINGS):
        if pass_at_depth(bed, count, high, speed).force >= wanted:
            break
        if high == end:
            raise OutsideValidity(
                f"SlidingResistance: at {speed:.6g} m/s the force {wanted:.6g} N presses the body beyond what is "
                "known of its profile; give less."
            )
        low, high = high, min(2.0 * high, end)
    else:
        raise NotConverged(f"SlidingResistance: at {speed:.6g} m/s no depth bears the force {wanted:.6g} N.")
    depth = high
    if high > low:

        def missing(logarithm: float) -> float:
            return pass_at_depth(bed, count, math.exp(logarithm), speed).force / wanted - 1.0

        depth = math.exp(between(missing, math.log(low), math.log(high), absolute=1e-15))
    return pass_at_depth(bed, count, depth, speed)


def pass_at_depth(bed: Bed, count: int, depth: float, speed: float) -> SlidPast:
    """Return what a spring meets when the body passes over it at a depth [m]."""
    elastic = elastic_like(bed)
    _, radii = at_depth(elastic, np.array([depth]))
    radius = float(radii[0])
    if radius >= elastic.rim:
        raise OutsideValidity(
            f"SlidingResistance: at the depth {depth:.6g} m the contact fills the body up to its rim, whose "
            "leading corner would cut into the other one; give a rounded body, or less load."
        )
    x = np.linspace(radius, 0.0, count // 2 + 1)
    x = np.unique(np.concatenate([x, [b for b, _ in elastic.kinks if b < radius]]))
    before, after = _slopes(elastic, x)
    gaps = elastic.gap(x)
    recess = np.concatenate([depth - gaps[::-1], depth - gaps[1:]])
    recess[0] = recess[-1] = 0.0
    place = np.concatenate([radius - x[::-1], radius + x[1:]])
    series = relaxation_of("", bed)
    memory, loads, sums = np.zeros(series.moduli.size), np.empty(place.size), np.empty(3)
    pass_over(
        series.relaxed, series.viscosity * speed, series.moduli, series.times * speed, place, recess,
        np.concatenate([after[::-1], -before]), np.concatenate([before[::-1], -after]), memory, loads,
        gauss_legendre(NODES), sums,
    )  # fmt: skip
    force, work, let_go = sums.tolist()
    _refuse_again(bed, place, recess, memory, let_go, depth, speed)
    return SlidPast(depth, radius, radius - place, loads, force, work, radius - let_go)


def _refuse_again(
    bed: Bed, place: Array, recess: Array, memory: Array, let_go: float, depth: float, speed: float
) -> None:
    """Refuse bodies that touch the spring again after it has let go."""
    behind = place > let_go
    recovery = Recovery.of(relaxation_of("", bed))
    left = depth - float(bed.gap(np.abs(np.array([0.5 * float(place[-1]) - let_go])))[0])
    weights = recovery.from_displacement * left + recovery.from_memory @ memory
    free = np.exp(-(place[behind, None] - let_go) / speed * recovery.rates) @ weights
    if np.any(recess[behind] - free > RECONTACT_MARGIN * depth):
        raise OutsideValidity(
            f"SlidingResistance: at {speed:.6g} m/s the body touches the surface again behind the contact, which "
            "is no disc then; give a body whose flanks grow steeper, or another speed."
        )


def _slopes(bed: Bed, x: Array) -> tuple[Array, Array]:
    """Return g' at the near and at the far end of every interval between places (n,), with their mean as it is."""
    mean = np.diff(bed.gap(x)) / np.diff(x)
    with np.errstate(divide="ignore", invalid="ignore"):
        slope = bed.gap_slope(x)
    near = np.where(np.isfinite(slope[:-1]), slope[:-1], mean)
    far = np.where(np.isfinite(slope[1:]), slope[1:], mean)
    excess = mean - 0.5 * (near + far)
    return near + excess, far + excess
