"""Cases of problems in limits where they meet closed forms, recomputed from their own inputs by mpmath."""

from __future__ import annotations

import tomllib
from pathlib import Path

import mpmath as mp
import pytest
from test_friction_cases import Ball, number

import winkler

CASES = Path(winkler.__file__).parent / "cases"


def jkr_equilibria(problem: dict) -> dict:
    """Johnson, Kendall and Roberts; the derivative of the depth is zero at the end of stability."""
    ball, work, a = Ball(problem), number(problem["law"]["work"]), number(problem["reach"])
    return {
        "starts.0": mp.cbrt(mp.pi * ball.radius**2 * work / (8 * ball.modulus)),
        "depth.-1": a**2 / ball.radius - mp.sqrt(2 * mp.pi * work * a / ball.modulus),
        "force.-1": ball.force(a) - mp.sqrt(8 * mp.pi * work * ball.modulus * a**3),
    }


def jkr_slow_peeling(problem: dict) -> dict:
    """The contact at the first point, and the greatest pull."""
    ball, work = Ball(problem), number(problem["law"]["work"])
    depth = number(problem["path"]["normal"]["depth"][0])
    a = mp.findroot(
        lambda a: a**2 / ball.radius - mp.sqrt(2 * mp.pi * work * a / ball.modulus) - depth,
        mp.sqrt(2 * ball.radius * depth),
    )
    return {
        "radius.0": a,
        "force.0": ball.force(a) - mp.sqrt(8 * mp.pi * work * ball.modulus * a**3),
        "lowest_force.-1": -mp.mpf(3) / 2 * mp.pi * work * ball.radius,
    }


def fretting_heat_rate(problem: dict) -> dict:
    """Mindlin and Deresiewicz, many times a second; equal bodies share the heat evenly."""
    motion = problem["contact"]
    start, swing = motion["path"]["steps"]
    ball, force = Ball(motion), number(start["normal"]["force"])
    loss = ball.loss(force, number(swing["lateral"]["shear_force"]) / (ball.friction * force))
    return {"loss_per_cycle": loss, "heat_rate": number(problem["frequency"]) * loss, "first_share": mp.mpf(1) / 2}


def elastomer_one_wave(problem: dict) -> dict:
    """All waves are taken to be as long as their mean."""
    solid, wave = problem["solid"], 2 * mp.pi / mp.mpf("1e-3")
    relaxed, shear, tau = (number(solid[word]) for word in ("relaxed_shear", "shear", "relaxation_time"))
    found = []
    for velocity in problem["velocity"]:
        turn = mp.mpc(0, wave * number(velocity) * tau)
        modulus = relaxed + shear * turn / (1 + turn)
        found.append(number(problem["spectrum"]["rms_height"]) * wave * modulus.imag / abs(modulus))
    return {"coefficient": found}


def rough_indentation_smooth(problem: dict) -> dict:
    """Hertz."""
    depth, ball = number(problem["load"]["depth"]), Ball(problem)
    a = mp.sqrt(ball.radius * depth)
    return {"force": ball.force(a), "stiffness": 2 * ball.modulus * a}


def reduction_of_a_ball(problem: dict) -> dict:
    """Hertz with the radius 1 m of the map."""
    a = mp.sqrt(number(problem["depth"]))
    return {"force.-1": mp.mpf(4) / 3 * a**3, "stiffness.-1": 2 * a}


def conduction_of_a_map(problem: dict) -> dict:
    """Hertz with the radius 1 m of the map, and Holm."""
    a, pair = mp.sqrt(number(problem["contact"]["load"]["depth"])), problem["conductors"]
    return {"conductance": 4 * a / sum(number(pair[which]["resistivity"]) for which in ("first", "second"))}


def true_area_of_a_ball(problem: dict) -> dict:
    """Hertz with the radius 1 m of the map."""
    depth = number(problem["contact"]["load"]["depth"])
    return {"area": mp.pi * depth, "peak_pressure": 2 * mp.sqrt(depth) / mp.pi, "patch_count": mp.mpf(1)}


def thermal_joint_of_a_ball(problem: dict) -> dict:
    """Hertz with the radius 1 m of the map, and an isothermal disc."""
    a, pair = mp.sqrt(number(problem["contact"]["load"]["depth"])), problem["conductors"]
    return {"spot_conductance": 4 * a / sum(1 / number(pair[which]["conductivity"]) for which in ("first", "second"))}


def seal_of_grooves(problem: dict) -> dict:
    """Westergaard's wave of the height 0.01 m: the integral of the slope of its gap, and the cubic law."""
    height = mp.mpf("0.01")
    c = number(problem["contact"]["load"]["force"]) / (mp.pi * height)
    b = mp.asin(mp.sqrt(c))

    def gap(t):
        u = max(mp.sin(t) ** 2, c)  # rounding at the edge
        return 2 * height * (mp.sqrt(u * (u - c)) - c * mp.log((mp.sqrt(u) + mp.sqrt(u - c)) / mp.sqrt(c)))

    def moment(power):
        width = mp.pi / 2 - b  # s^2, as the gap begins with a power of 3/2
        return 2 / mp.pi * mp.quad(lambda s: gap(b + width * s**2) ** power * 2 * s * width, [0, 0.5, 1])

    mean, cube = moment(1), moment(3)
    drop, viscosity = number(problem["pressure_drop"]), number(problem["viscosity"])
    return {"leak_rate": cube * drop / (12 * viscosity), "mean_gap": mean, "flow_factor": cube / mean**3}


def surface_wear_wave(problem: dict) -> dict:
    """A wave of the height 0.01 m and the length 1 m in full contact, with E* and the rate one."""
    far, wave = number(problem["distance"][0]), 2 * mp.pi
    force, height = number(problem["contact"]["load"]["force"]), mp.mpf("0.01")
    fade = mp.exp(-wave * far / 2)
    even = force / number(problem["contact"]["topography"]["lengths"][1])
    return {
        "rms_height.-1": height / mp.sqrt(2) * fade,
        "peak_pressure.-1": even + wave * height * fade / 2,
        "worn_volume.-1": force * far,
    }


def plastic_spot(problem: dict) -> dict:
    """The area F / H, Holm's disc of that area, and Kohlrausch's voltage."""
    contact, pair = problem["contact"], problem["conductors"]
    area = number(contact["load"]["force"]) / number(contact["hardness"])
    both = sum(number(pair[which]["resistivity"]) for which in ("first", "second"))
    resistance = both / (4 * mp.sqrt(area / mp.pi))
    hot, cold = number(problem["softening_temperature"]), mp.mpf("293.15")
    voltage = 2 * mp.sqrt(mp.mpf("2.44e-8") * (hot**2 - cold**2))
    return {
        "area": area,
        "resistance": resistance,
        "softening_voltage": voltage,
        "softening_current": voltage / resistance,
    }


def joint_stiffness_of_a_ball(problem: dict) -> dict:
    """Hertz, Mindlin's ratio, and Masing's loop of Mindlin's shift; bodies of E = 2 Pa and nu = 0.3, R = 1 m."""
    nu, force, friction = mp.mpf("0.3"), number(problem["load"]["force"]), mp.mpf("0.3")
    modulus, ratio = 1 / (1 - nu**2), 2 * (1 - nu) / (2 - nu)
    normal = 2 * modulus * mp.cbrt(3 * force / (4 * modulus))
    share = [mp.mpf(one) for one in ("0.5", "0.9")]

    def moved(s):
        return 3 * friction * force / (2 * ratio * normal) * (1 - (1 - s) ** (mp.mpf(2) / 3))

    def lost(s):
        return 4 * friction * force * (s * moved(s) - 2 * mp.quad(moved, [0, s]))

    shift, loss = [moved(s) for s in share], [lost(s) for s in share]
    return {
        "stiffness": normal, "stiffness_x": ratio * normal, "ratio_x": ratio, "shift_amplitude": shift,
        "loss_per_cycle": loss, "spring_shift": shift, "spring_loss": loss,
    }  # fmt: skip


RECOMPUTED = (
    jkr_equilibria, jkr_slow_peeling, fretting_heat_rate, elastomer_one_wave, rough_indentation_smooth,
    reduction_of_a_ball, conduction_of_a_map, true_area_of_a_ball, seal_of_grooves, thermal_joint_of_a_ball,
    surface_wear_wave, plastic_spot,
    joint_stiffness_of_a_ball,
)  # fmt: skip


@pytest.mark.parametrize("of", RECOMPUTED, ids=lambda of: of.__name__)
def test_a_case_is_recomputed(of):
    case = tomllib.loads((CASES / f"{of.__name__}.toml").read_text(encoding="utf-8"))
    with mp.workdps(30):
        found = of(case["problem"])
        assert {item["quantity"] for item in case["expect"]} == set(found)
        for item in case["expect"]:
            numbers, wanted = (x if isinstance(x, list) else [x] for x in (item["value"], found[item["quantity"]]))
            for written, expected in zip(numbers, wanted, strict=True):
                assert abs(mp.mpf(written) / expected - 1) < 1e-15, (item["quantity"], expected)
