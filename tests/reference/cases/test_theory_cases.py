"""The tables of the theory are cases: their numbers are those of the references, and have the digits that are known.

The numbers of sections 1, 7 and 8.2 are checked beside the reference solutions of these sections.
"""

from __future__ import annotations

import csv
import tomllib
from pathlib import Path

import mpmath as mp
import numpy as np
import pytest
from theory_solutions import REFERENCES

import winkler
from winkler.problems.rolling import kalker

CASES = Path(winkler.__file__).parent / "cases"
SHEAR = 208e9 / 2.5
STEEL = 208e9 / (2.0 * (1.0 - 0.0625))
LIMIT = 0.3 * 4.0 / 3.0 * STEEL * 1e-9 / 10e-3
"""mu F_N of the ball that rolls, a = 1 mm and R = 10 mm."""
HEAT = 0.3 * 4.0 / 3.0 * 210e9 / 1.82 * 1e-12 / 10e-3 * 0.24 / (45.0 * 1e-4)
"""mu F v/(lambda a) at Pe = 1."""
SPEEDS = np.array([0.01, 0.05, 0.1, 0.5, 1.0, 5.0, 10.0])

SCALES = {
    ("heating_speeds", "first_max_temperature"): ("top", HEAT * SPEEDS),
    ("rolling_simplified_saturation", "longitudinal_force"): ("share", 24e3),
    ("rolling_cubic_saturation", "longitudinal_force"): ("share", LIMIT),
    ("shakedown_limit", "shakedown_force"): ("share", LIMIT),
}
"""Where a case has units of its own: the name of the number in the reference, and its unit."""
REQUESTED = {"lubkin_table": {"angle"}, "torsion_flat_punch": {"angle"}, "torsion_cone": {"angle"}} | {
    "heating_speeds": {"overestimate", "top"},
    "savkoor_briggs_sheared": {"force"},
    "rolling_simplified_saturation": {"share"},
    "rolling_cubic_saturation": {"share"},
    "rolling_uncalibrated": {"share", "slopes"},
    "shakedown_limit": {"share"},
}
"""Numbers of the reference that a case has as input, or has in other units."""
OTHERS = {
    ("heating_speeds", "first_peclet"): SPEEDS,
    ("mindlin_ratio", "problem.bed.medium.modulus"): 1.0,
    ("rolling_uncalibrated", "longitudinal_force.0"): [
        0.3 * 4 / 3 * 80e9 / (1 - nu) * 1e-7 * (1 - (1 - 1e-6 * (1 - nu) / (0.03 * (2 - nu) * 1.0)) ** 3)
        for nu in (0.0, 0.25, 0.5)
    ],
}


def read(name):
    return tomllib.loads((CASES / f"{name}.toml").read_text(encoding="utf-8"))


def values(name, quantity):
    (found,) = [item["value"] for item in read(name)["expect"] if item["quantity"] == quantity]
    return np.atleast_1d(np.asarray(found, dtype=float))


@pytest.mark.few(2, slow=6)
@pytest.mark.parametrize("name", REFERENCES)
def test_a_case_states_what_the_reference_solution_gives(name):
    stated = REFERENCES[name]()
    expected = {item["quantity"] for item in read(name)["expect"]}
    assert set(stated) - REQUESTED.get(name, set()) <= expected
    for quantity in expected:
        if (name, quantity) in OTHERS:
            wanted = OTHERS[name, quantity]
        else:
            word, unit = SCALES.get((name, quantity), (quantity, 1.0))
            content = stated[word] if isinstance(stated[word], list) else [stated[word]]
            wanted = np.array([float(number) for number in content]) * unit
        # the reference integrates the motion of the ball to some ten digits
        close = 1e-9 if name in ("maw_barber_fawcett_no_slip", "rolling_uncalibrated") else 1e-13
        np.testing.assert_allclose(values(name, quantity), wanted, rtol=close, err_msg=quantity)


@pytest.mark.parametrize("name", ["lubkin_table", "torsion_flat_punch", "torsion_cone"])
def test_the_angles_are_those_of_the_reference_solution(name):
    requested = read(name)["problem"]["path"]["lateral"]["angle"]["values"]
    np.testing.assert_allclose(requested, [float(angle) for angle in REFERENCES[name]()["angle"]], rtol=1e-14)


PRINTED = [
    # 0
    ("mindlin_ratio", "problem.bed.medium.shear_modulus", 1.0, ".823529"),
    # 3
    ("rolling_simplified_saturation", "longitudinal_force", 24e3, ".26994 .69620 .95288 .99941"),
    ("rolling_cubic_saturation", "longitudinal_force", LIMIT, ".2710 .7037 .9630 1"),
    ("rolling_uncalibrated", "longitudinal_force.0", 80e9 * 1e-12, "2.000 2.286 2.667"),
    ("shakedown_limit", "shakedown_force", LIMIT, ".704"),
    # 4
    ("jkr_first_touch", "force", -np.pi, "1.333333333"),
    ("jkr_cycle", "dissipation.2", 1.0, "6.418315112"),
    ("jkr_cycle", "dissipation.-1", 1.0, "7.092195972"),
    ("maugis_table", "force", -1.0, "1.9506 1.7182 1.6007 1.5346 1.5063"),
    # 5
    ("heating_speeds", "first_max_temperature", HEAT * SPEEDS, "0 0 .36016 0 .279134 0 .125456"),
    # 6
    ("two_spots_bem", "resistance", 1.0, "1.0080"),
    # 8.1
    (
        "graded_shear_moduli",
        "problem.bed.medium.shear_modulus",
        1.0,
        (".9031452196 .8169924799 .8066857105 .7916567993 .6866071539 .6060889225 .5951459275 .5772300255"),
    ),
    # 9
    ("hertz_impact_depth", "depth.100", 1.0, ".974514960"),
    ("hertz_impact_depth", "duration", 1.0, "2.868265699"),
    (
        "maw_barber_fawcett_table",
        "lateral_restitution",
        -1.0 / np.array([0.1, 0.5, 1, 1.5, 2, 4, 4.5, 5, 6]),
        (".0206 .0480 -.0596 -.4280 -.8372 -1.4365 -1.2176 -.7647 .2353"),
    ),
    ("maw_barber_fawcett_no_slip", "lateral_restitution", -1.0, ".3870 .2800 .2317 -.1040"),
    # 11
    ("limiting_profile_wide_core", "radius", 1.0, "1.096897"),
    ("limiting_profile_wide_core", "worn_volume", 1.0, ".0900483"),
    ("limiting_profile_wide_core", "force", 1.0, "1.258667"),
    ("limiting_profile_nearly_stuck", "radius", 1.0, "1.024811"),
    ("limiting_profile_nearly_stuck", "worn_volume", 1.0, ".00302666"),
    ("limiting_profile_nearly_stuck", "force", 1.0, "1.328417"),
    # 12
    (
        "lubkin_table",
        "torque",
        0.8,
        (
            ".0197513720 .1763453815 .3105272952 .4097384796 .4804799793 .5285759656 .5591932999 .5768680426 "
            ".5855425693 .5886198851 .5890481981"
        ),
    ),
    ("torsion_cone", "torque", 0.03 * np.pi, ".4364065089"),
    # 13
    ("particle_yield_onset", "yield_depth", 1.0, ".035303022"),
]
"""Case, quantity, its unit, and the numbers as they are printed; 0 where none is."""


@pytest.mark.parametrize(
    ("name", "quantity", "unit", "printed"), PRINTED, ids=[f"{row[0]}-{row[1]}" for row in PRINTED]
)
def test_the_printed_numbers_are_cases(name, quantity, unit, printed):
    found = values(name, quantity) / unit
    texts = printed.split()
    assert len(texts) == found.size
    for text, number in zip(texts, found, strict=True):
        if text != "0":
            assert number == pytest.approx(float(text), abs=1.01 * 10.0 ** -len(text.partition(".")[2])), text


def test_the_table_of_graded_bodies_is_a_case():
    """h_N = E* (1 - nu^2)/E0."""
    printed = (
        ".8100622978 .7678700736 .7568163665 .7309030227 1.062728703 1.088528206 1.096278249 1.116440045 "
        "1.104151431 1.167483348 1.188243901 1.246293023 1.000893963 1.1014446 1.141408652 1.272792206 "
        ".6417553318 .7214312988 .7634169469 .9369001128"
    )
    found = values("graded_moduli", "problem.bed.medium.modulus").reshape(5, 4)
    found = found * (1.0 - np.array([0.0, 0.25, 0.3, 0.4]) ** 2)
    np.testing.assert_allclose(found.ravel(), [float(text) for text in printed.split()], rtol=1e-9)


def test_the_angles_of_torsion_are_as_printed():
    printed = (
        ".00375944587 .0385138791 .0794192099 .1234362505 .1716373462 .2257118580 .2885338883 .3655699474 .4692548849 "
        ".6397178390 1.1915886244"
    )
    found = [float(angle) / 0.8 for angle in REFERENCES["lubkin_table"]()["angle"]]
    np.testing.assert_allclose(found, [float(text) for text in printed.split()], atol=1.01e-10)
    assert float(REFERENCES["torsion_cone"]()["angle"][0]) / (0.03 * np.pi) == pytest.approx(0.2048898680, abs=1e-10)


def test_what_the_rule_at_rest_says_too_much():
    """Of Hertz' flux, in per cent."""
    found = 100.0 * np.array(REFERENCES["heating_speeds"]()["overestimate"])
    np.testing.assert_allclose(found, [0.42, 2.1, 4.1, 18.7, 34.3, 122.0, 199.0], rtol=0.015)


def test_a_shear_force_of_contact_is_as_it_was_written(shared_data):
    table = np.genfromtxt(shared_data / "reference" / "tangential_shift_circle.csv", delimiter=",", skip_header=1)
    rows = table[(table[:, 0] == 0.0) & (table[:, 1] == 96)]
    rows = rows[np.argsort(rows[:, 2])]
    np.testing.assert_allclose(values("cattaneo_shift_contact", "shear_force"), 0.4 * rows[:, 3], rtol=1e-13)


def test_a_ball_of_contact_is_as_it_was_printed(shared_data):
    printed = tomllib.loads((shared_data / "reference" / "contact" / "cattaneo_ball.toml").read_text(encoding="utf-8"))
    case = printed["case"][1]
    assert values("surface_cattaneo_contact", "shift_x").tolist() == [case["shift_x_m"]]
    assert values("surface_cattaneo_contact", "depth").tolist() == [case["approach_m"]]
    assert values("surface_cattaneo_contact", "dissipation").tolist() == [-case["friction_work_J"]]


def test_creep_forces_of_contact_are_as_they_were_printed(shared_data):
    file = shared_data / "reference" / "contact" / "creep_curve_ellipse.csv"
    rows = {float(row["creep_x"]): -float(row["force_x_N"]) for row in csv.DictReader(file.open().readlines()[1:])}
    printed = [rows[creepage] for creepage in (4e-4, 1.2e-3, 2e-3, 2.8e-3)]
    assert values("surface_rolling_contact", "longitudinal_force").tolist() == printed


def test_the_start_of_rolling_of_contact_is_as_it_was_printed(shared_data):
    file = shared_data / "reference" / "contact" / "cattaneo_to_carter.csv"
    rows = list(csv.DictReader(file.open().readlines()[1:]))
    printed = [float(row["creep_x"] or 0.0) for row in rows[:5]]
    assert values("surface_rolling_start_contact", "longitudinal_creepage").tolist() == printed


def test_the_table_of_kalker_is_as_it_was_printed(shared_data):
    file = shared_data / "reference" / "kalker_table_E3.csv"
    table = np.genfromtxt(file, delimiter=",", skip_header=1, usecols=range(2, 11))
    np.testing.assert_array_equal(np.concatenate([kalker.ACROSS, kalker.ALONG]), table)


@pytest.mark.parametrize("of", ["", "_ellipses"])
@pytest.mark.parametrize(("name", "quantity", "power", "size"), [
    ("c11", "longitudinal_force", 1.0, 1e-10),
    ("c22", "lateral_force", 1.0, 1e-10),
    ("c23", "lateral_force", 1.5, 1e-8),
])  # fmt: skip
def test_the_coefficients_of_contact_are_extrapolated(shared_data, name, of, quantity, power, size):
    """A straight line over the size of an element through all grids; F = G (ab)^power c times the creepage."""
    with (shared_data / "reference" / f"creep_coefficients_{'ellipse' if of else 'circle'}.csv").open() as file:
        rows = list(csv.DictReader(file))
    points = [(1.0, nu) for nu in (0.0, 0.25, 0.3, 0.5)]
    if of:
        points = [(ratio, 0.25) for ratio in (0.2, 0.5, 2.0)[: 2 if name == "c23" else 3]]
    forces = []
    for ratio, nu in points:
        found = [row for row in rows if float(row["nu"]) == nu and float(row.get("a/b", 1.0)) == ratio]
        element = np.array([1.0 / float(row["n"]) for row in found])
        limit = np.polyfit(element, [float(row[name.upper()]) for row in found], 1)[1]
        forces.append(80e9 * (1e-6 * ratio) ** power * limit * size)
    np.testing.assert_allclose(values(f"kalker_{name}{of}", quantity), forces, rtol=1e-10)


@pytest.mark.parametrize("name", ["c22", "c33"])
def test_the_coefficients_of_contact_on_a_circle_are_extrapolated(shared_data, name):
    with (shared_data / "reference" / "creep_coefficients_circle.csv").open() as file:
        rows = [row for row in csv.DictReader(file) if row["nu"] == "0.25"]
    element = np.array([1.0 / float(row["n"]) for row in rows])
    limit = np.polyfit(element, [float(row[name.upper()]) for row in rows], 1)[1]
    np.testing.assert_allclose(values(f"kalker_linear_{name}_contact", "creep_coefficient"), limit, rtol=1e-12)


def test_the_linear_coefficients_of_a_disc():
    """The leading edge wants sum k_j U_j(y) = -2 sqrt(1 - y^2): F = 2 k_0; the moment is that of the plain X."""
    k0 = 2 / mp.pi * mp.quad(lambda y: 2 * (1 - y**2), [-1, 1])
    np.testing.assert_allclose(values("kalker_linear_c11_disc", "creep_coefficient"), float(2 * k0), rtol=1e-15)
    turned = mp.quad(lambda r: 2 / mp.pi * r**3 / mp.sqrt(1 - r**2), [0, 1]) * mp.pi
    np.testing.assert_allclose(values("kalker_linear_c23_disc", "creep_coefficient"), float(turned), rtol=1e-15)


def test_the_particle_of_lammps_is_as_it_was_written(shared_data):
    table = np.genfromtxt(shared_data / "reference" / "particle_mdr_elastic.csv", delimiter=",", names=True)
    case = read("particle_lammps")
    depths = case["problem"]["path"]["depth"]["values"]
    table = table[np.argsort(table["overlap_m"])]
    np.testing.assert_allclose(
        values("particle_lammps", "force"),
        np.interp(depths, table["overlap_m"] / 2.0, table["force_N"]),
        rtol=1e-12,
    )


class TestCurves:
    """The curves of the fits obey the formulas that their first lines name."""

    def curve(self, name):
        return np.loadtxt(CASES / "curves" / f"{name}.csv", delimiter=",", skiprows=2) * 1e-9

    def test_hertz(self):
        depth, force = self.curve("fit_hertz").T
        pressed = np.maximum(depth - 1e-6, 0.0)
        np.testing.assert_allclose(force, 4 / 3 * 4e3 / 0.75 * np.sqrt(5e-6) * pressed**1.5, rtol=1e-9, atol=1e-24)

    def test_sneddon(self):
        depth, force = self.curve("fit_sneddon").T
        wanted = 2 / np.pi * 2e4 / 0.75 * np.tan(np.radians(35)) * np.maximum(depth - 1e-6, 0.0) ** 2
        np.testing.assert_allclose(force, wanted, rtol=1e-9, atol=1e-24)

    def test_johnson_kendall_roberts(self):
        """(F - F_H)^2 = 8 pi w E* a^3 with d = a^2/R - sqrt(2 pi a w/E*)."""
        depth, force = self.curve("fit_jkr").T
        modulus, work, radius = 4e4 / 0.75, 2e-4, 5e-6
        held = force != 0.0
        for d, f in zip(depth[held] - 1e-6, force[held], strict=True):
            # s = sqrt(a): s^4/R - sqrt(2 pi w/E*) s - d = 0
            rough = np.roots([1.0 / radius, 0.0, 0.0, -np.sqrt(2.0 * np.pi * work / modulus), -d])
            found = []
            for s in rough[(np.abs(rough.imag) < 1e-9) & (rough.real > 0.0)].real:
                a = s * s
                found.append(4 * modulus * a**3 / (3 * radius) - np.sqrt(8 * np.pi * a**3 * work * modulus))
            assert min(abs(each - f) for each in found) < 1e-6 * abs(f) + 1e-18
