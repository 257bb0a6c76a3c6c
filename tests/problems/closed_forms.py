"""Depth and force at a contact radius, of every shape with a closed form, at 30 digits (theory 1.1); E* = 1.

Written from the theory sheet, term by term, without a look at the package.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import NamedTuple

import mpmath as mp
import numpy as np

import winkler as wk

mp.mp.dps = 30


class Case(NamedTuple):
    """A profile, its d(a) and F(a) for E* = 1, and contact radii to try."""

    profile: object
    depth: Callable[[mp.mpf], mp.mpf]
    force: Callable[[mp.mpf], mp.mpf]
    radii: np.ndarray


def _m(number: float) -> mp.mpf:
    return mp.mpf(number)


def power(c: float, n: float) -> Case:
    kappa = mp.sqrt(mp.pi) * _m(n) * mp.gamma(_m(n) / 2) / (2 * mp.gamma((_m(n) + 1) / 2))
    return Case(
        wk.PowerLaw(c, n),
        lambda a: kappa * _m(c) * a ** _m(n),
        lambda a: 2 * _m(n) / (_m(n) + 1) * kappa * _m(c) * a ** (_m(n) + 1),
        np.geomspace(1e-6, 1.0, 5),
    )


def cone(theta: float) -> Case:
    t = 1 / mp.tan(_m(theta))
    return Case(
        wk.Cone(theta), lambda a: mp.pi / 2 * a * t, lambda a: mp.pi / 2 * a**2 * t, np.geomspace(1e-9, 1e-2, 5)
    )


def paraboloid(radius: float) -> Case:
    r = _m(radius)
    return Case(
        wk.Paraboloid(radius), lambda a: a**2 / r, lambda a: 4 * a**3 / (3 * r), radius * np.geomspace(1e-7, 1.0, 6)
    )


def _sphere_force(r: mp.mpf, a: mp.mpf) -> mp.mpf:
    with mp.workdps(60):  # the closed form cancels for small a
        return (r**2 + a**2) / 2 * mp.log((r + a) / (r - a)) - a * r


def sphere(radius: float) -> Case:
    r = _m(radius)
    return Case(
        wk.Sphere(radius),
        lambda a: a * mp.atanh(a / r),
        lambda a: _sphere_force(r, a),
        radius * np.array([1e-6, 1e-3, 0.1, 0.5, 0.9, 0.999]),
    )


def ellipsoid(radial: float, axial: float) -> Case:
    a0, ratio = _m(radial), _m(axial) / _m(radial)
    return Case(
        wk.Ellipsoid(radial, axial),
        lambda a: ratio * a * mp.atanh(a / a0),
        lambda a: ratio * _sphere_force(a0, a),
        radial * np.array([1e-3, 0.1, 0.5, 0.9]),
    )


def hyperboloid(radius: float, theta: float) -> Case:
    m = 1 / mp.tan(_m(theta))
    length = _m(radius) * m

    def force(a: mp.mpf) -> mp.mpf:
        with mp.workdps(60):
            return m * ((a**2 - length**2) * mp.atan(a / length) + length * a)

    return Case(
        wk.Hyperboloid(radius, theta),
        lambda a: m * a * mp.atan(a / length),
        force,
        float(length) * np.array([1e-4, 0.2, 0.31, 1.0, 100.0]),
    )


def truncated_cone(theta: float, flat: float) -> Case:
    t, b = 1 / mp.tan(_m(theta)), _m(flat)
    return Case(
        wk.TruncatedCone(theta, flat),
        lambda a: t * a * mp.acos(b / a),
        lambda a: t * a**2 * (mp.acos(b / a) + b / a * mp.sqrt(1 - b**2 / a**2)),
        flat * np.array([1.0 + 1e-9, 1.001, 1.5, 10.0]),
    )


def truncated_paraboloid(radius: float, flat: float) -> Case:
    r, b = _m(radius), _m(flat)
    return Case(
        wk.TruncatedParaboloid(radius, flat),
        lambda a: a / r * mp.sqrt(a**2 - b**2),
        lambda a: 2 / (3 * r) * (2 * a**2 + b**2) * mp.sqrt(a**2 - b**2),
        flat * np.array([1.0 + 1e-9, 1.001, 1.5, 10.0]),
    )


def rounded_punch(flat: float, edge: float) -> Case:
    b, r = _m(flat), _m(edge)
    return Case(
        wk.RoundedPunch(flat, edge),
        lambda a: a / r * (mp.sqrt(a**2 - b**2) - b * mp.acos(b / a)),
        lambda a: (mp.sqrt(a**2 - b**2) * (4 * a**2 - b**2) - 3 * a**2 * b * mp.acos(b / a)) / (3 * r),
        flat * np.array([1.0 + 1e-8, 1.001, 1.5, 10.0]),
    )


def rounded_cone(radius: float, theta: float) -> Case:
    t = 1 / mp.tan(_m(theta))
    b = _m(radius) * t

    def depth(a: mp.mpf) -> mp.mpf:
        if a <= b:
            return a**2 * t / b
        return t * a * (a / b - mp.sqrt(a**2 / b**2 - 1) + mp.acos(b / a))

    def force(a: mp.mpf) -> mp.mpf:
        if a <= b:
            return 4 * a**3 / (3 * _m(radius))
        s = 1 - b**2 / a**2
        return t * a**2 * (mp.acos(b / a) + 4 * a / (3 * b) * (1 - s ** mp.mpf(1.5)) - b / a * mp.sqrt(s))

    return Case(wk.RoundedCone(radius, theta), depth, force, float(b) * np.array([0.01, 0.5, 0.999, 1.001, 2.0, 100.0]))


def capped_paraboloid(radius: float, cap: float, edge: float) -> Case:
    r, r1, b = _m(radius), _m(cap), _m(edge)
    more = 1 / r - 1 / r1

    def beyond(a: mp.mpf) -> mp.mpf:
        return mp.sqrt(a**2 - b**2) if a > b else mp.mpf(0)

    return Case(
        wk.CappedParaboloid(radius, cap, edge),
        lambda a: a**2 / r1 + more * a * beyond(a),
        lambda a: 4 * a**3 / (3 * r1) + more * mp.mpf(2) / 3 * (2 * a**2 + b**2) * beyond(a),
        edge * np.array([0.1, 0.999, 1.001, 3.0]),
    )


CASES = {
    "cone 70": cone(math.radians(70.0)),
    "cone 5": cone(math.radians(5.0)),
    "cone 89": cone(math.radians(89.0)),
    "paraboloid": paraboloid(3e-3),
    "sphere": sphere(5e-6),
    "ellipsoid": ellipsoid(2e-3, 5e-3),
    "hyperboloid": hyperboloid(2e-8, math.radians(70.0)),
    "power 1/2": power(0.3, 0.5),
    "power 1.1": power(0.3, 1.1),
    "power 4": power(0.3, 4.0),
    "power 30": power(2.0, 30.0),
    "truncated cone": truncated_cone(math.radians(84.0), 2e-4),
    "truncated paraboloid": truncated_paraboloid(1e-2, 2e-4),
    "rounded punch": rounded_punch(1e-3, 2e-4),
    "rounded cone": rounded_cone(1e-8, math.radians(70.0)),
    "worn paraboloid": capped_paraboloid(1e-2, 5e-2, 3e-4),
}
