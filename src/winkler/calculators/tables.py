"""The pure numbers of the calculators, from solutions of the package for bodies of unit size and stiffness."""

from __future__ import annotations

import functools
import math
from collections.abc import Callable, Mapping
from typing import Any

import numpy as np

from winkler.calculators.kernels import COMPLETE
from winkler.calculators.series import table_of, table_of_two
from winkler.foundation.foundation import Foundation
from winkler.laws.adhesion import ShortRange
from winkler.laws.friction import Coulomb
from winkler.loading.loads import Depth, Force, LineForce, LineShearForce, ShearForce, Shift, Torque
from winkler.loading.path import Path
from winkler.materials.conductor import ElectricalConductor, ThermalConductor
from winkler.materials.elastic import Elastic
from winkler.materials.graded import PowerLawGraded
from winkler.materials.spring_and_dashpot import StandardSolid
from winkler.media.halfspace import HalfSpace
from winkler.numerics.types import Array
from winkler.profiles.power import Paraboloid

__all__ = ["TABLES"]

MEDIUM, FORCE, FRICTION = HalfSpace(Elastic(1.0, 0.0)), 1.0, 0.5
BEGIN_END = np.array([0.0, 1.0])
LEAST_SHARE, MOST_SHARE = 0.009, 0.991
"""Of the force or torque at which all slides; sliders stay within."""
LARGEST_PECLET = 3e5
HEAT_TOLERANCE = 2e-10
"""The greatest temperature is itself known to about a tenth of it."""
FILMS = math.log(4e-8), math.log(4e7)
GRADINGS, POISSONS = (0.0, 0.9), (0.0, 0.5)


@functools.cache
def hertz() -> Array:
    """Return depth, radius, greatest and mean pressure, stiffness of a ball of unit numbers."""
    from winkler.problems.normal.indentation import Indentation

    one = Indentation(_bed(), Force(FORCE)).solve()
    numbers = (one.depth, one.radius, one.peak_pressure, one.mean_pressure, one.stiffness)
    return np.array([float(number) for number in numbers])


def _bed() -> Foundation:
    """Return a ball of R = 1 on a body of E* = 1."""
    return Foundation(Paraboloid(1.0), MEDIUM)


def _pushed() -> dict[str, Array]:
    """Return the shift over that at which all slides, over the share of the force, and the radius that sticks."""
    from winkler.problems.friction.tangential import Tangential

    bed, depth = _bed(), hertz()[0]
    most = FRICTION * depth * MEDIUM.modulus / MEDIUM.shear_modulus

    def at(s: float) -> Any:
        force = (1.0 - s**3) * FRICTION * FORCE
        return Tangential(
            bed, Coulomb(FRICTION), Path(BEGIN_END, Force(FORCE), ShearForce(np.array([0.0, force])))
        ).solve()

    ends = _roots(3)
    return {
        "shift": table_of(lambda s: float(at(s).shift[-1]) / (most * (1.0 - s**3)), *ends),
        "stick": table_of(lambda s: float(at(s).stick_radius[-1]) / hertz()[1], *ends),
    }


def _roots(power: int) -> tuple[float, float]:
    """Return the ends of s = (1 - share)^(1/power), in which what slides begins smoothly."""
    return (1.0 - MOST_SHARE) ** (1.0 / power), (1.0 - LEAST_SHARE) ** (1.0 / power)


def _rolled() -> dict[str, Array]:
    from winkler.foundation.line import LineFoundation
    from winkler.problems.line_rolling.steady import LineRolling

    bed = LineFoundation(Paraboloid(1.0), MEDIUM)

    def at(s: float) -> Any:
        force = (1.0 - s * s) * FRICTION * FORCE
        return LineRolling(bed, Coulomb(FRICTION), LineShearForce(force), LineForce(FORCE)).solve()

    contact = at(0.5).contact
    half = float(contact.half_width)
    return {
        "line": np.array([half, float(contact.peak_pressure)]),
        "creepage": table_of(
            lambda s: float(at(s).longitudinal_creepage) / (FRICTION * half * (1.0 - s * s)), *_roots(2)
        ),
        "stick": table_of(lambda s: float(at(s).stick_share), *_roots(2)),
    }


def _stuck() -> dict[str, Array]:
    """Return an adhesive ball over s = sqrt(1 + F over the pull-off force), in which it parts smoothly."""
    from winkler.problems.adhesion.indentation import AdhesiveIndentation
    from winkler.problems.adhesion.pull_off import PullOff

    bed, law = _bed(), ShortRange(1.0)
    parted = PullOff(bed, law).solve()

    def at(s: float) -> Any:
        return AdhesiveIndentation(bed, law, Force((1.0 - s * s) * float(parted.force))).solve()

    ends = 0.05, math.sqrt(51.0)
    return {
        "pull": np.array([float(parted.force), float(parted.radius)]),
        "radius": table_of(lambda s: float(at(s).radius), *ends),
        "depth": table_of(lambda s: float(at(s).depth), *ends),
    }


def _heated() -> dict[str, Array]:
    """Return the greatest temperature, times radius and conductivity, per watt, over log(1 + Pe)."""
    from winkler.media.conduction.conductors import HeatConductors
    from winkler.problems.heating.steady import FrictionHeating
    from winkler.problems.normal.indentation import Indentation

    body, radius = ThermalConductor(1.0, 1.0), float(hertz()[1])
    conductors = HeatConductors(body, body)

    def at(logarithm: float) -> float:
        speed = 2.0 * math.expm1(logarithm) / radius
        if speed == 0.0:
            speed = 1e-13
        ball = Indentation(_bed(), Force(FORCE))
        one = FrictionHeating(ball, Coulomb(FRICTION), conductors, first_speed=speed).solve()
        into = float(one.first_share) * float(one.heat_rate)
        return float(one.first_max_temperature) * radius / into

    return {"peak": table_of(at, 0.0, math.log1p(LARGEST_PECLET), HEAT_TOLERANCE)}


def _spot() -> dict[str, Array]:
    """Return constriction, which a film changes by its ratio to the bodies, and film of a spot of unit radius."""
    from winkler.laws.film import SurfaceFilm
    from winkler.media.conduction.conductors import ElectricalConductors
    from winkler.problems.conduction.constriction import Constriction
    from winkler.problems.normal.indentation import Indentation

    one, radius = ElectricalConductor(1.0), float(hertz()[1])

    def at(logarithm: float) -> Any:
        film = SurfaceFilm(2.0 * radius * math.exp(logarithm))
        return Constriction(Indentation(_bed(), Force(FORCE)), ElectricalConductors(one, one, film)).solve()

    unit = at(0.0)
    return {
        "spot": table_of(lambda ratio: 0.5 * radius * float(at(ratio).constriction), *FILMS),
        "film": np.array([0.5 * radius * float(unit.film_resistance)]),
    }


def _crept() -> dict[str, Array]:
    """Return which part of its creep a standard solid has done, over log(1 + time / time of retardation)."""
    solid = StandardSolid(relaxed_shear=1.0, shear=1.0, relaxation_time=0.5)

    def at(logarithm: float) -> float:
        time = math.expm1(logarithm)
        compliance = float(np.ravel(solid.creep(np.array([time])))[0])
        return (compliance - 0.5) / 0.5

    return {"crept": table_of(at, 0.0, math.log1p(COMPLETE))}


def _graded() -> dict[str, Array]:
    from winkler.media.graded.power_law import GradedHalfSpace
    from winkler.problems.normal.indentation import Indentation

    def at(exponent: float, poisson: float) -> Any:
        medium = GradedHalfSpace(PowerLawGraded(1.0, 1.0, exponent, poisson))
        return Indentation(Foundation(Paraboloid(1.0), medium), Force(FORCE)).solve()

    def stiffness(exponent: float) -> float:
        one = at(exponent, 0.3)
        return float(one.stiffness) * float(one.depth) / FORCE

    def force(exponent: float, poisson: float) -> float:
        return math.log(FORCE / float(at(exponent, poisson).radius) ** (3.0 + exponent))

    return {
        "force": table_of_two(force, GRADINGS, POISSONS),
        "depth": table_of(lambda k: float(at(k, 0.3).depth) / float(at(k, 0.3).radius) ** 2, *GRADINGS),
        "stiffness": table_of(stiffness, *GRADINGS),
    }


def _damped() -> dict[str, Array]:
    from winkler.problems.friction.damping import FrictionDamping

    bed = _bed()
    most = FRICTION * float(hertz()[0]) * MEDIUM.modulus / MEDIUM.shear_modulus

    def at(s: float) -> Any:
        force = (1.0 - s**3) * FRICTION * FORCE
        return FrictionDamping(bed, Coulomb(FRICTION), Force(FORCE), ShearForce(force)).solve()

    return {
        "shift": table_of(lambda s: float(at(s).shift) / (most * (1.0 - s**3)), *_roots(3)),
        "loss": table_of(
            lambda s: float(at(s).loss_per_cycle) / (FRICTION * FORCE * most * (1.0 - s**3) ** 3), *_roots(3)
        ),
    }


def _rough() -> dict[str, Array]:
    """Return logarithms of the bounds over the smooth stiffness, over that of roughness over depth."""
    from winkler.media.conduction.conductors import ElectricalConductors
    from winkler.problems.conduction.bounds import ConductanceBounds

    one = ElectricalConductor(1.0)
    pair = ElectricalConductors(one, one)

    def at(logarithm: float) -> Any:
        return ConductanceBounds(_bed(), pair, math.exp(logarithm) * float(hertz()[0]), FORCE).solve()

    ends = math.log(1e-4), math.log(1e4)
    unit = at(0.0)
    return {
        "least": table_of(lambda r: math.log(at(r).least_stiffness / unit.smooth_stiffness), *ends),
        "greatest": table_of(lambda r: math.log(at(r).greatest_stiffness / unit.smooth_stiffness), *ends),
        "spot": np.array([2.0 * unit.smooth_conductance / unit.smooth_stiffness]),
    }


def _worn() -> dict[str, Array]:
    from winkler.problems.wear.limiting_profile import LimitingProfile

    bed, depth = _bed(), 1.0
    most = FRICTION * depth * MEDIUM.modulus / MEDIUM.shear_modulus

    def at(s: float) -> Any:
        return LimitingProfile(bed, Coulomb(FRICTION), Depth(depth), Shift((1.0 - s * s) * most)).solve()

    ends = _roots(2)
    return {
        "ends": np.array([float(at(0.5).problem.contact.radius)]),
        "stick": table_of(lambda s: at(s).stick_radius, *ends),
        "radius": table_of(lambda s: at(s).radius, *ends),
        "force": table_of(lambda s: at(s).force, *ends),
        "volume": table_of(lambda s: math.log(at(s).worn_volume), *ends),
    }


def _twisted() -> dict[str, Array]:
    from winkler.problems.friction.torsion import Torsion

    bed, radius = _bed(), float(hertz()[1])
    unit = FRICTION * FORCE / (MEDIUM.torsional_modulus * radius**2)
    slipping = Path(BEGIN_END, Force(FORCE), Torque(np.array([0.0, 1e-3])))
    limit = float(Torsion(bed, Coulomb(FRICTION), slipping).solve().torque_limit[-1])

    def at(share: float) -> Any:
        path = Path(BEGIN_END, Force(FORCE), Torque(np.array([0.0, share * limit])))
        return Torsion(bed, Coulomb(FRICTION), path).solve()

    ends = LEAST_SHARE, MOST_SHARE
    return {
        "most": np.array([limit / (FRICTION * FORCE * radius)]),
        "angle": table_of(lambda t: float(at(t).angle[-1]) / (unit * t), *ends),
        "stick": table_of(lambda t: float(at(t).stick_radius[-1]) / radius, *ends),
    }


TABLES: Mapping[str, Callable[[], dict[str, Array]]] = {
    "normal": lambda: {"hertz": hertz()},
    "tangential": lambda: {"hertz": hertz(), **_pushed()},
    "rolling": _rolled,
    "adhesion": _stuck,
    "heating": lambda: {"hertz": hertz(), **_heated()},
    "conduction": lambda: {"hertz": hertz(), **_spot()},
    "viscoelastic": lambda: {"hertz": hertz(), **_crept()},
    "graded": _graded,
    "damping": lambda: {"hertz": hertz(), **_damped()},
    "roughness": lambda: {"hertz": hertz(), **_rough()},
    "wear": _worn,
    "torsion": lambda: {"hertz": hertz(), **_twisted()},
}
"""Calculator -> what computes its tables, in the order in which its kernel takes them."""
