"""The friction cases in src/winkler/cases/*.toml, recomputed by mpmath from their own inputs."""

from __future__ import annotations

import math
import tomllib
from pathlib import Path

import mpmath as mp
import pytest
from ledger_solutions import REFERENCES as LAST
from theory_solutions import REFERENCES

import winkler
from winkler.values.units import to_si

CASES = Path(winkler.__file__).parent / "cases"


def number(raw) -> mp.mpf:
    return mp.mpf(raw if isinstance(raw, int | float) else repr(to_si(raw, what="a case")))


class Ball:
    """Bodies and friction of a case."""

    def __init__(self, problem: dict) -> None:
        medium = problem["bed"]["medium"]
        solids = [medium[which] for which in ("first", "on", "second") if which in medium]
        pairs = [(number(solid["young"]), number(solid["poisson"])) for solid in solids]
        shears = [young / (2 * (1 + nu)) for young, nu in pairs]
        self.modulus = 1 / sum((1 - nu**2) / young for young, nu in pairs)
        self.shear = 1 / sum((2 - nu) / (4 * g) for g, (_, nu) in zip(shears, pairs, strict=True))
        self.twist = 1 / sum(1 / g for g in shears)
        self.radius = number(problem["bed"]["profile"].get("curvature_radius", 0))
        self.friction = number(problem.get("law", {}).get("coefficient", 0))

    def contact(self, force: mp.mpf) -> mp.mpf:
        return mp.cbrt(3 * force * self.radius / (4 * self.modulus))

    def force(self, a: mp.mpf) -> mp.mpf:
        return mp.mpf(4) / 3 * self.modulus * a**3 / self.radius

    def shift(self, a: mp.mpf, c: mp.mpf) -> mp.mpf:
        return self.friction * self.modulus / self.shear * (a**2 - c**2) / self.radius

    def loss(self, force: mp.mpf, share: mp.mpf) -> mp.mpf:
        """Mindlin and Deresiewicz."""
        whole = 18 * (self.friction * force) ** 2 / (5 * self.contact(force) * self.shear)
        return whole * (1 - (1 - share) ** (mp.mpf(5) / 3) - 5 * share / 6 * (1 + (1 - share) ** (mp.mpf(2) / 3)))


def mindlin_partial_slip(problem: dict) -> dict:
    ball, force = Ball(problem), number(problem["path"]["normal"]["force"])
    a = ball.contact(force)
    c = a * mp.cbrt(1 - number(problem["path"]["lateral"]["shear_force"][-1]) / (ball.friction * force))
    return {"shift.-1": ball.shift(a, c), "stick_radius.-1": c}


def mindlin_deresiewicz_loop(problem: dict) -> dict:
    ball, force = Ball(problem), number(problem["path"]["normal"]["force"])
    share = number(problem["path"]["lateral"]["shear_force"][1]) / (ball.friction * force)
    loss, a = ball.loss(force, share), ball.contact(force)
    return {
        "dissipation.1": loss / 4,
        "dissipation.-1": 5 * loss / 4,
        "shift.2": -ball.shift(a, a * mp.cbrt(1 - share)),
    }


def coated_steel_loop(problem: dict) -> dict:
    """The layer, its base and the ball are of one steel."""
    (layer,) = problem["bed"]["medium"]["layers"]
    assert layer["solid"] == problem["bed"]["medium"]["on"]
    return mindlin_deresiewicz_loop(problem)


def mindlin_deresiewicz_loss(problem: dict) -> dict:
    ball, force = Ball(problem), number(problem["normal"]["force"])
    share = number(problem["amplitude"]["shear_force"]) / (ball.friction * force)
    a = ball.contact(force)
    return {"loss_per_cycle": ball.loss(force, share), "shift": ball.shift(a, a * mp.cbrt(1 - share))}


def unloading_at_fixed_shift(problem: dict) -> dict:
    ball = Ball(problem)
    depths = [mp.mpf(d) for d in problem["path"]["normal"]["depth"]["values"]]
    shift = mp.mpf(problem["path"]["lateral"]["shift"]["values"][-1])
    core = depths[0] * ball.radius - shift * ball.radius * ball.shear / (ball.friction * ball.modulus)
    found = {}
    for place, depth in enumerate(depths[1:], start=1):
        inner = mp.sqrt(max(core - ball.radius * (depths[0] - depth), 0))
        found[f"shear_force.{place}"] = ball.friction * (ball.force(mp.sqrt(ball.radius * depth)) - ball.force(inner))
    return found


def lubkin_torsion(problem: dict) -> dict:
    ball, force = Ball(problem), number(problem["path"]["normal"]["force"])
    a, angle = ball.contact(force), mp.mpf(problem["path"]["lateral"]["angle"]["values"][-1])
    most = 3 * ball.friction * force / (4 * mp.pi * ball.twist * a**2)

    def turned(c: mp.mpf) -> mp.mpf:
        m = 1 - (c / a) ** 2
        return most * (mp.ellipk(m) - mp.ellipe(m)) - angle

    c = mp.findroot(turned, (mp.mpf("0.3") * a, mp.mpf("0.9") * a), solver="anderson", tol=1e-30)

    def sliding(x: mp.mpf) -> mp.mpf:
        m = 1 - (x / a) ** 2
        return 6 * ball.friction * force / (mp.pi * a**2) * x**2 * (mp.ellipk(m) - mp.ellipe(m))

    torque = 2 * (8 * ball.twist * angle * c**3 / 3 + mp.quad(sliding, [c, (c + a) / 2, a]))
    return {"torque.-1": torque, "stick_radius.-1": c}


def hertz_impact(problem: dict) -> dict:
    ball, mass, velocity = Ball(problem), number(problem["mass"]), number(problem["velocity"])
    deepest = (15 * mass * velocity**2 / (16 * ball.modulus * mp.sqrt(ball.radius))) ** (mp.mpf(2) / 5)
    duration = 4 * mp.sqrt(mp.pi) * mp.gamma(mp.mpf(2) / 5) / (5 * mp.gamma(mp.mpf(9) / 10)) * deepest / velocity
    return {"duration": duration, "restitution": mp.mpf(1)}


def relaxation_damper_cone(problem: dict) -> dict:
    ball, profile = Ball(problem), problem["bed"]["profile"]
    slope = mp.pi / 2 / mp.tan(number(profile["half_angle"]))
    pace = 2 * mp.pi * number(problem["frequency"])
    amplitude = number(problem["depth_amplitude"])
    return {"damping": 2 * (mp.pi**2 - 4) / mp.pi * ball.shear * amplitude / (pace * slope)}


def thornton_ning_sticking_ball(problem: dict) -> dict:
    """Potentials of Johnson, Kendall and Roberts at first touch, and where fixed grips lose their hold."""
    ball, work, mass = Ball(problem), number(problem["law"]["work"]), number(problem["mass"])

    def potential(a: mp.mpf) -> mp.mpf:
        depth = a**2 - mp.sqrt(2 * mp.pi * a)
        return mp.quad(lambda x: (depth - x**2) ** 2, [0, a]) - mp.pi * a**2

    touch, parting = mp.cbrt(2 * mp.pi), mp.cbrt(mp.pi / 8)
    unit = mp.cbrt(work**5 * ball.radius**4 / ball.modulus**2)
    lost = (potential(parting) - potential(touch)) * unit
    return {"restitution": mp.sqrt(1 - 2 * lost / (mass * number(problem["velocity"]) ** 2))}


RECOMPUTED = (
    mindlin_partial_slip,
    mindlin_deresiewicz_loop,
    coated_steel_loop,
    mindlin_deresiewicz_loss,
    unloading_at_fixed_shift,
    lubkin_torsion,
    hertz_impact,
    relaxation_damper_cone,
    thornton_ning_sticking_ball,
)


@pytest.mark.parametrize("reference", RECOMPUTED, ids=lambda reference: reference.__name__)
def test_a_case_is_recomputed(reference):
    case = tomllib.loads((CASES / f"{reference.__name__}.toml").read_text(encoding="utf-8"))
    assert case["grade"] == "analytical"
    with mp.workdps(30):
        found = reference(case["problem"])
    assert set(found) == {expectation["quantity"] for expectation in case["expect"]}
    for expectation in case["expect"]:
        deviation = abs(found[expectation["quantity"]] / mp.mpf(expectation["value"]) - 1)
        assert deviation < 5e-15, (expectation["quantity"], float(deviation))


def test_every_friction_case_is_recomputed_or_cited():
    kinds = {"tangential", "torsion", "friction_damping", "bimodal_damping", "relaxation_damper"}
    kinds |= {"impact", "adhesive_impact"}
    cases = {path.stem: tomllib.loads(path.read_text(encoding="utf-8")) for path in CASES.glob("*.toml")}
    rubbed = {name for name, case in cases.items() if case.get("problem", {}).get("kind") in kinds}
    rubbed.discard("mindlin_relaxes")  # recomputed beside the other bodies that relax
    analytical = {name for name in rubbed if cases[name]["grade"] == "analytical"}
    assert analytical - set(REFERENCES) - set(LAST) == {reference.__name__ for reference in RECOMPUTED}
    stated = {"maw_barber_fawcett", "maw_barber_fawcett_table", "cattaneo_shift_contact"}
    assert rubbed - analytical - set(REFERENCES) - set(LAST) == stated


def test_the_oblique_impact_is_that_of_its_table():
    """psi = 3 of the table for nu = 0.3, in which the points leave at psi = -1.3797."""
    case = tomllib.loads((CASES / "maw_barber_fawcett.toml").read_text(encoding="utf-8"))
    ball, problem = Ball(case["problem"]), case["problem"]
    psi = (
        ball.shear / ball.modulus * number(problem["lateral_velocity"]) / (ball.friction * number(problem["velocity"]))
    )
    assert float(psi) == pytest.approx(3.0, rel=1e-12)
    solid = 0.4 * number(problem["mass"]) * ball.radius**2
    assert float(number(problem["inertia"]) / solid) == pytest.approx(1.0, rel=1e-12)
    assert case["expect"][0]["value"] == pytest.approx(1.3797 / 3.0, rel=1e-12)
    assert math.isclose(float(ball.shear / ball.modulus), 2.0 * 0.7 / 1.7, rel_tol=1e-12)
