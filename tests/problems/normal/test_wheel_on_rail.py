"""Wheels on rails against the boundary elements of CONTACT: ellipses by their radii, profiles by their curvature."""

from __future__ import annotations

import csv
import math
import tomllib

import numpy as np
import pytest

import winkler as wk

POISSON = 0.28
STEEL = wk.Elastic(2.0 * 82e9 * (1.0 + POISSON), POISSON)
PAIR = wk.HalfSpace.between(STEEL, STEEL)
WHEEL_RADIUS = 0.46
HERTZIAN = {"7": 3e-3, "11": 5e-3, "15": 7e-3, "21": 10e-3}
"""Cases whose patch lies where both profiles have one curvature, and the displacement of the wheelset [m]."""


def numbers(file):
    lines = (line for line in file.read_text().splitlines() if not line.startswith(("#", "y_m")))
    return np.array([[float(number) for number in line.split(",")] for line in lines])


def curvature(profile, place, half_width):
    """Of the parabola through the points of a profile within the contact [1/m]; z down, so positive for a rail."""
    near = np.abs(profile[:, 0] - place) <= half_width
    bend, slope, _ = np.polyfit(profile[near, 0] - place, profile[near, 1], 2)
    return 2.0 * bend / (1.0 + slope * slope) ** 1.5


def test_ellipse_of_a_sliding_wheel(shared_data):
    """Printed digits of a, b; greatest pressure to 0.02 %, approach to 0.1 %."""
    table = tomllib.loads((shared_data / "reference" / "contact" / "temperature_wheel.toml").read_text())
    given, case = table["inputs"], table["case"][0]
    bodies = wk.CurvedBodies(0.5 / given["gap_coefficient_A_1_per_m"], 0.5 / given["gap_coefficient_B_1_per_m"])
    found = wk.EllipticIndentation(bodies, PAIR, wk.Force(case["normal_force_N"])).solve()
    assert found.longitudinal_semi_axis == pytest.approx(given["semi_axis_a_m"], abs=5e-6)
    assert found.lateral_semi_axis == pytest.approx(given["semi_axis_b_m"], abs=5e-6)
    assert found.peak_pressure == pytest.approx(case["peak_pressure_Pa"], rel=2e-4)
    assert found.depth == pytest.approx(case["approach_m"], rel=1e-3)


def test_ellipse_pressed_to_a_depth(shared_data):
    table = tomllib.loads((shared_data / "reference" / "contact" / "large_ellipse_sliding.toml").read_text())
    given, case = table["inputs"], table["case"][0]
    bodies = wk.CurvedBodies(given["curvature_radius_x_m"], given["curvature_radius_y_m"])
    found = wk.EllipticIndentation(bodies, PAIR, wk.Depth(given["depth_m"])).solve()
    assert found.force == pytest.approx(case["normal_force_N"], rel=1e-3)
    assert found.peak_pressure == pytest.approx(case["peak_pressure_Pa"], rel=1e-3)


@pytest.mark.parametrize("case", HERTZIAN)
def test_profiles_of_wheel_and_rail(case, shared_data):
    """Manchester benchmark, S1002 on UIC 60: pressure to 0.4 %, approach to 0.3 %, lengths to an element and a half.

    At 0 and 1 mm the curvature changes within the patch, and the pressure is 6 and 1 % off that of an ellipse.
    """
    folder = shared_data / "reference" / "contact" / "manchester"
    lines = [line for line in (folder / "left_wheel.csv").read_text().splitlines() if not line.startswith("#")]
    row = next(row for row in csv.DictReader(lines) if row["case"] == case)
    expected = {name: float(number) for name, number in row.items()}
    assert expected["y_wheelset_m"] == HERTZIAN[case]
    half = 0.5 * expected["width_s_m"]
    rail = curvature(numbers(folder / "rail_uic60.csv"), -expected["contact_y_rail_m"], half)
    wheel = -curvature(numbers(folder / "wheel_s1002.csv"), -expected["contact_y_wheel_m"], half)
    bodies = wk.CurvedPair(math.inf, 1.0 / rail, WHEEL_RADIUS + expected["contact_z_wheel_m"], 1.0 / wheel)
    found = wk.EllipticIndentation(bodies, PAIR, wk.Force(expected["normal_force_N"])).solve()
    assert found.peak_pressure == pytest.approx(expected["peak_pressure_Pa"], rel=4e-3)
    assert found.depth == pytest.approx(expected["approach_m"], rel=3e-3)
    assert 2.0 * found.longitudinal_semi_axis == pytest.approx(expected["length_x_m"], abs=3e-4)
    assert 2.0 * found.lateral_semi_axis == pytest.approx(expected["width_s_m"], abs=3e-4)
