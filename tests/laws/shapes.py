"""Every shape of the package with random, sensible numbers: what the laws are tried on.

A `Specimen` makes the same shape at any size: all lengths times a factor, angles and exponents untouched.  At the
factor one its lengths are of the order of one.  To put a new shape under all laws, write its strategy and add a line
to `KINDS` (its contact is one disc at every load up to `widest`) or to `WAVES` (transforms only).
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import numpy as np
from hypothesis import strategies as st

import winkler as wk


class Specimen(NamedTuple):
    """A shape at any size, and up to which contact radius it is pressed (for the factor one)."""

    make: Callable[[float], wk.Shape]
    widest: float
    flat: float = 0.0
    pinned: bool = False

    def __repr__(self) -> str:
        return f"Specimen({self.make(1.0)!r}, widest={self.widest!r}, flat={self.flat!r}, pinned={self.pinned!r})"


def number(low: float, high: float) -> st.SearchStrategy[float]:
    return st.floats(low, high, allow_nan=False, width=64)


length = number(0.3, 3.0)
angle = number(0.25, 1.5)

paraboloid = st.builds(lambda big: Specimen(lambda s: wk.Paraboloid(s * big), 0.9 * big), length)
power_law = st.builds(
    lambda c, n: Specimen(lambda s: wk.PowerLaw(c * s ** (1.0 - n), n), 1.5), number(0.05, 2.0), number(0.6, 8.0)
)
sphere = st.builds(lambda big: Specimen(lambda s: wk.Sphere(s * big), 0.9 * big), length)
ellipsoid = st.builds(lambda a, b: Specimen(lambda s: wk.Ellipsoid(s * a, s * b), 0.9 * a), length, length)
ball_in_socket = st.builds(
    lambda big, wide: Specimen(lambda s: wk.BallInSocket(s * big, s * big * wide), 0.9 * big), length, number(1.01, 3.0)
)
hyperboloid = st.builds(lambda big, t: Specimen(lambda s: wk.Hyperboloid(s * big, t), 3.0 * big), length, angle)
cone = st.builds(lambda t: Specimen(lambda s: wk.Cone(t), 1.0), angle)
pyramid = st.sampled_from([wk.Berkovich, wk.Vickers, wk.CubeCorner]).map(lambda tip: Specimen(lambda s: tip(), 1.0))
sharp_pyramid = st.builds(lambda n, t: Specimen(lambda s: wk.Pyramid(n, t), 1.0), st.integers(3, 8), angle)
rounded_pyramid = st.builds(
    lambda n, t, big: Specimen(lambda s: wk.RoundedPyramid(n, t, s * big), 3.0 * big / math.tan(t)),
    st.integers(3, 4),
    angle,
    length,
)
truncated_cone = st.builds(lambda t, b: Specimen(lambda s: wk.TruncatedCone(t, s * b), 5.0 * b, flat=b), angle, length)
rounded_cone = st.builds(
    lambda big, t: Specimen(lambda s: wk.RoundedCone(s * big, t), 3.0 * big / math.tan(t)), length, angle
)
sphero_conical = st.builds(lambda big, t: Specimen(lambda s: wk.SpheroConical(s * big, t), 3.0 * big), length, angle)
rounded_punch = st.builds(
    lambda b, big: Specimen(lambda s: wk.RoundedPunch(s * b, s * big), 3.0 * b, flat=b), length, length
)
truncated_paraboloid = st.builds(
    lambda big, b: Specimen(lambda s: wk.TruncatedParaboloid(s * big, s * b), 3.0 * b, flat=b), length, length
)
capped_paraboloid = st.builds(
    lambda big, worn, b: Specimen(lambda s: wk.CappedParaboloid(s * big, s * big * worn, s * b), 3.0 * b),
    length,
    number(1.0, 20.0),
    length,
)
ground_paraboloid = st.builds(
    lambda big, sharp, b: Specimen(lambda s: wk.CappedParaboloid(s * big, s * big * sharp, s * b), 3.0 * b),
    length,
    number(0.1, 1.0),
    length,
)
wavy = st.builds(lambda h, wave: Specimen(lambda s: wk.Wavy(s * h, s * wave), 3.0), number(0.01, 0.3), length)


def _wavy_ball(big: float, wave: float, part: float) -> Specimen:
    # the waves take away less than the curvature of the ball, so that the shape stays convex
    amplitude = part / big * (wave / (2.0 * math.pi)) ** 2
    return Specimen(lambda s: wk.Paraboloid(s * big) + wk.Wavy(s * amplitude, s * wave), 0.9 * big)


wavy_ball = st.builds(_wavy_ball, length, number(0.1, 2.0), number(0.05, 0.95))
flat_punch = st.builds(lambda b: Specimen(lambda s: wk.FlatPunch(s * b), b, flat=b, pinned=True), length)


def _area(coefficients: tuple[float, ...], widest: float) -> Specimen:
    """C_n multiplies h^(2^(1-n)) and scales with s^(2 - 2^(1-n))."""

    def make(s: float) -> wk.AreaFunction:
        return wk.AreaFunction(tuple(c * s ** (2.0 - 2.0 ** (1 - n)) for n, c in enumerate(coefficients)))

    return Specimen(make, widest)


area_function = st.one_of(
    number(0.5, 30.0).map(lambda c: _area((c,), 1.0)),
    st.tuples(number(0.5, 30.0), number(0.1, 5.0)).map(lambda c: _area(c, 1.0)),
    length.map(lambda big: _area((-math.pi, 2.0 * math.pi * big), 0.9 * big)),
    st.tuples(number(5.0, 30.0), number(0.0, 2.0), number(0.01, 0.5)).map(lambda c: _area(c, 1.0)),
    st.tuples(number(5.0, 30.0), number(0.0, 2.0), number(0.0, 0.1), number(1e-3, 0.1)).map(lambda c: _area(c, 1.0)),
)
formula = st.one_of(
    st.builds(
        lambda c, n: Specimen(lambda s: wk.Formula("c*r + b*r**n", c=c, b=s ** (1.0 - n), n=n), 1.0),
        number(0.05, 1.0),
        number(1.5, 6.0),
    ),
    st.builds(
        lambda h, w: Specimen(lambda s: wk.Formula("h*(cosh(r/w) - 1)", reach=9.0 * s * w, h=s * h, w=s * w), 2.5 * w),
        number(0.05, 1.0),
        length,
    ),
    st.builds(
        lambda big, c: Specimen(
            lambda s: wk.Formula("c*(sqrt(R**2 + r**2) - R) + r**3/R**2", R=s * big, c=c), 2.0 * big
        ),
        length,
        number(0.05, 1.0),
    ),
    st.builds(
        lambda b, m, k: Specimen(
            # no simple part of 2.9 b is the corner itself, beyond which g rises with an infinite slope
            lambda s: wk.Formula("m*r + k*(r - b + sqrt((r - b)**2))", corners=(s * b,), b=s * b, m=m, k=k),
            2.9 * b,
        ),
        length,
        number(0.1, 1.0),
        number(0.05, 0.5),
    ),
)

SMOOTH = {
    "paraboloid": paraboloid,
    "power_law": power_law,
    "sphere": sphere,
    "ellipsoid": ellipsoid,
    "ball_in_socket": ball_in_socket,
    "hyperboloid": hyperboloid,
    "cone": cone,
    "pyramid": pyramid,
    "sphero_conical": sphero_conical,
    "rounded_cone": rounded_cone,
    "sharp_pyramid": sharp_pyramid,
    "rounded_pyramid": rounded_pyramid,
}
EDGED = {
    "truncated_cone": truncated_cone,
    "rounded_punch": rounded_punch,
    "truncated_paraboloid": truncated_paraboloid,
    "capped_paraboloid": capped_paraboloid,
}


def _sampled(source: Specimen, count: int) -> Specimen:
    places = np.linspace(0.0, source.widest, count)
    heights = source.make(1.0).height(places)
    return Specimen(lambda s: wk.Measured(s * places, s * heights), 0.9 * source.widest)


measured = st.builds(_sampled, st.one_of(paraboloid, sphere, hyperboloid, cone, sphero_conical), st.integers(12, 120))


def _capped(source: Specimen, pinned: bool) -> Specimen:
    rim = source.flat + 0.9 * (source.widest - source.flat)
    return Specimen(lambda s: wk.CappedCylinder(s * rim, source.make(s)), rim, flat=source.flat, pinned=pinned)


caps = st.one_of(*SMOOTH.values(), *EDGED.values())
capped_cylinder = st.builds(_capped, caps, st.just(False))
pinned_cylinder = st.builds(_capped, caps, st.just(True))


def _sum(one: Specimen, other: Specimen) -> Specimen:
    widest, flat = min(one.widest, other.widest), min(one.flat, other.flat)
    return Specimen(lambda s: one.make(s) + other.make(s), max(widest, 1.1 * flat), flat=flat)


sums = st.one_of(
    st.builds(_sum, st.one_of(*SMOOTH.values()), st.one_of(*SMOOTH.values())),
    st.builds(_sum, st.one_of(*SMOOTH.values()), st.one_of(*EDGED.values())),
)

KINDS: dict[str, st.SearchStrategy[Specimen]] = {
    **SMOOTH,
    **EDGED,
    "flat_punch": flat_punch,
    "capped_cylinder": capped_cylinder,
    "pinned_cylinder": pinned_cylinder,
    "wavy_ball": wavy_ball,
    "area_function": area_function,
    "formula": formula,
    "measured": measured,
    "sum": sums,
}
"""Shapes whose contact is one disc."""
WAVES = {"wavy": wavy, "ground_paraboloid": ground_paraboloid}
"""Shapes that are not convex."""
