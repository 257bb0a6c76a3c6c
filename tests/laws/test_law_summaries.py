"""Every problem has a summary: the numbers that it is asked for, those of its contact, with units, within bounds."""

from __future__ import annotations

import dataclasses
import functools
import json
import math
import re
from types import SimpleNamespace

import numpy as np
import pytest
import tomli_w
from example_answers import LASTING

import winkler as wk
from winkler.cli import main
from winkler.media.interior.map_peak import greatest_below
from winkler.media.interior.tensor import KINDS as STATED
from winkler.problems.line.indentation import LineSolution
from winkler.problems.normal.elliptic import EllipticSolution
from winkler.problems.normal.indentation import IndentationSolution
from winkler.problems.subsurface.contact_stress import ContactStress
from winkler.study.batch.run import run
from winkler.study.chapters.contents import answers
from winkler.study.language.explain import example_study
from winkler.study.language.reading import parse_study
from winkler.study.report.figures import figures_of
from winkler.study.report.headline.elastic_state import elastic_state
from winkler.study.report.headline.shown_contact import shown_contact, shown_point, stressed_contact
from winkler.study.report.headline.summary import CALLED, contact_summary
from winkler.values.units import quantity

SLOW_EXAMPLES = LASTING | {"viscoelastic_impact"}


def marked(kinds):
    return [pytest.param(kind, marks=[pytest.mark.slow] * (kind in SLOW_EXAMPLES)) for kind in kinds]


KINDS = marked(answers())
WITHOUT_FORCES = {"held_contacts", "spot_cluster", "band_heating"}
STRESSES = {"von_mises", "max_shear", "orthogonal_shear"}
MAPS = {
    "surface_contact", "surface_conduction", "true_area", "seal", "thermal_joint", "surface_constriction", "map_stress",
    "profile_pair", "profile_pair_rolling", "surface_tangential", "joint_stiffness", "surface_rolling",
    "surface_rolling_start", "surface_friction_heating", "roller_contact", "nearly_round_indentation",
}  # fmt: skip
FOLLOW = {
    *MAPS, "viscoelastic_indentation", "plastic_indentation", "line_plastic_indentation", "creep_test",
    "relaxation_test", "pull_off",
}  # fmt: skip
"""Without another way; the greatest stress of a pull-off stands beside the edge."""
ADHESIVE = {"adhesive_indentation", "equilibrium", "adhesive_cycle", "adhesive_shear"}
"""Of these the greatest stress stands on the axis, where it has a closed form: Hertz' less that of a flat punch."""
OWN_PRESSURE = {"line_viscoelastic_indentation", "line_rolling_resistance"}
SUPERSCRIPTS = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻−µΩ", "0123456789--uΩ")
FORCES, MODULI = r"[kMGmµ]?N(?:/m|/mm)?", r"[kMG]?Pa"
MOVED, KEPT = 1e-9, 1e-2
"""By which part inputs are moved, and to which part each number is then the same."""
RESIDUALS = {"strip_error", "penetration", "misfit", "imbalance"}
"""What a solver leaves, which is rounding by its nature."""
DIGITS = 5e-3
"""Four digits are shown, of shares three."""


@functools.cache
def outcome_of(kind):
    return run(parse_study(tomli_w.dumps({"title": "x", **example_study(kind)})))


@functools.cache
def moved_outcomes(kind):
    """Return what comes out where all forces, or all moduli, of the example are greater in the ninth digit."""
    study = example_study(kind)
    changed = (moved(study, unit) for unit in (FORCES, MODULI))
    return [run(parse_study(tomli_w.dumps({"title": "x", **one}))) for one in changed if one != study]


def moved(content, unit):
    if isinstance(content, dict):
        return {key: moved(one, unit) for key, one in content.items()}
    if isinstance(content, list):
        return [moved(one, unit) for one in content]
    found = re.fullmatch(rf"([-\d.e]+) ({unit})", content) if isinstance(content, str) else None
    return f"{float(found[1]) * (1.0 + MOVED)!r} {found[2]}" if found else content


@functools.cache
def summary_of(kind):
    return {row.key: row for row in contact_summary(outcome_of(kind))}


def read(text, unit):
    """Return the number of a text with a prefix, powers and a unit, in SI."""
    plain = text.replace("\N{NO-BREAK SPACE}", " ").translate(SUPERSCRIPTS).replace("Ω", "ohm")
    plain = re.sub(r"·10(-?\d+)", r"e\1", plain)
    if unit == "":
        return float(plain.removesuffix(" %")) * (0.01 if plain.endswith("%") else 1.0)
    plain = plain.replace("°", " deg") if "°" in plain else plain
    number, _, rest = plain.partition(" ")
    rest = re.sub(r"([a-z])([23])\b", r"\1^\2", rest)
    return quantity(f"{number} {rest.strip()}", unit, what="row")


def sources(kind):
    """Return where the numbers of a row may come from: the answer, its contact, that of the pictures."""
    point = shown_point(outcome_of(kind))
    contacts = (getattr(point.each[-1], "contact", None), shown_contact(point))
    named = [(point.readable, point.problem), *((vars_of(one), getattr(one, "problem", None)) for one in contacts)]
    return [(numbers, problem) for numbers, problem in named if numbers]


def vars_of(contact):
    names = (*CALLED, "leak_rate")
    found = {name: getattr(contact, name, None) for name in names}
    return {name: np.ravel(one) for name, one in found.items() if isinstance(one, float | np.ndarray)}


def sides_of(problem):
    """Return the sides of the height map behind a problem [m]; not numbers where there is none."""
    rough = getattr(getattr(problem, "contact", problem), "topography", None)
    side = getattr(problem, "side", math.nan)
    return map(float, rough.lengths if rough is not None else (side, side))


def candidates(kind, key):
    """Yield the numbers along the loads that a row may be of, from closed forms where no solution states it."""
    point = shown_point(outcome_of(kind))
    for numbers, problem in sources(kind):
        if key in numbers:
            yield numbers[key]
            continue
        force, area = numbers.get("force"), numbers.get("area")
        if area is None and "radius" in numbers:
            area = math.pi * numbers["radius"] ** 2
        x, y = sides_of(problem)
        with np.errstate(invalid="ignore", divide="ignore"):
            if key == "area" and area is not None:
                yield area
            elif key == "mean_pressure" and force is not None and area is not None:
                yield np.where(area > 0.0, force / area, 0.0)
            elif key == "nominal_pressure" and force is not None:
                yield force / (x * y)
            elif key == "contact_share" and area is not None:
                yield area / (x * y)
            elif key == "leak_per_width" and "leak_rate" in numbers:
                yield numbers["leak_rate"] / y
    state = elastic_state(point)
    if state is not None and key == "peak_pressure":
        yield np.array([state.peak_pressure])
    elif state is not None and key == "yield_force":
        yield np.array([state.yield_load])


def other_stress(kind, key):
    """Return a stress that the summary states by another way, and how far both may be apart."""
    if kind in FOLLOW:
        return None, None
    point = shown_point(outcome_of(kind))
    found, problem = stressed_contact(point), point.problem
    bed = getattr(getattr(found, "problem", problem), "bed", None)
    if kind in ADHESIVE:
        return on_axis_of_jkr(found, key), 1e-4
    if isinstance(found, EllipticSolution | IndentationSolution | LineSolution):
        return getattr(ContactStress(found.problem).solve(), key), 1e-6
    if hasattr(found, "longitudinal_semi_axis"):  # the principal axes of an ellipse on half-spaces, by its own pressure
        return greatest_below_ellipse(found, key), 1e-3
    if kind in OWN_PRESSURE:
        return greatest_below_line_loads(point, bed.medium.first.poisson, key), 2e-3
    if isinstance(bed, wk.LineFoundation) and not hasattr(found, "closure_pressure"):
        force = getattr(found, "force_per_length", None)
        load = wk.HalfWidth(np.max(found.half_width)) if force is None else wk.LineForce(float(np.max(force)))
        return getattr(ContactStress(wk.LineIndentation(bed, load)).solve(), key), 1e-6
    if hasattr(found, "strip_peaks") or hasattr(found, "closure_pressure"):
        reach = np.max(np.abs(found.edges)) if hasattr(found, "edges") else found.half_width
        x, z = np.meshgrid(reach * np.linspace(-1.2, 1.2, 301), reach * np.linspace(0.01, 2.0, 300))
        return np.max(measured(found.stresses(x, z), key)), 2e-3
    return None, None


def on_axis_of_jkr(found, key):
    """Return the greatest stress on the axis of an adhesive ball, where shears across it vanish.

    Of a harmonic f that is 1 at the surface, sigma_z = f - z f' and 2 sigma_r = (1 + 2 nu) f + z f'.
    """
    if key == "orthogonal_shear":
        return None
    bed, a = found.problem.bed, float(np.max(found.radius))
    modulus, nu, z = bed.medium.modulus, bed.medium.first.poisson, np.linspace(0.2, 1.0, 80001)
    hertz = 2.0 * modulus * a / (math.pi * bed.profile.curvature_radius)
    punch = math.sqrt(2.0 * found.problem.law.work * modulus / (math.pi * a))
    slope = z / (1.0 + z * z) - np.arctan(1.0 / z)
    parts = [(hertz, 1.0 + z * (slope - z / (1.0 + z * z)), slope)]
    parts.append((-punch, 1.0 / (1.0 + z * z), -2.0 * z / (1.0 + z * z) ** 2))
    mises = sum(peak * (0.5 * (1.0 - 2.0 * nu) * f - 1.5 * z * of_z) for peak, f, of_z in parts)
    return np.max(mises) * (1.0 if key == "von_mises" else 0.5)


def greatest_below_line_loads(point, poisson, key):
    """Return the greatest stress below a strip as a sum of Flamant's line loads."""
    forces = [round(float(np.max(one.force_per_length)), 9) for one in point.each]
    found = [one for one, force in zip(point.each, forces, strict=True) if force == max(forces)][-1]
    half = float(np.max(found.half_width))
    low, high = float(getattr(found, "trailing_edge", -half)), float(getattr(found, "leading_edge", half))
    places = 0.5 * (low + high) - 0.5 * (high - low) * np.cos(np.pi * (np.arange(2000) + 0.5) / 2000)
    loads = found.pressure(places)
    loads = loads * 0.5 * (high - low) * np.sin(np.pi * (np.arange(2000) + 0.5) / 2000) * np.pi / 2000
    x, z = np.meshgrid(np.linspace(low, high, 41), half * np.linspace(0.1, 1.5, 141))
    across = x[..., None] - places
    share = -2.0 / np.pi * loads / (across**2 + z[..., None] ** 2) ** 2
    deep = z[..., None] * np.ones_like(across)
    xx, zz, xz = (np.sum(share * part, axis=-1) for part in (across**2 * deep, deep**3, across * deep**2))
    below = SimpleNamespace(xx_stress=xx, yy_stress=poisson * (xx + zz), zz_stress=zz, xz_stress=xz)
    return np.max(measured(below, key))


def greatest_below_ellipse(found, key):
    problem = found.problem
    bodies = problem.bodies if hasattr(problem, "bodies") else problem.contact.bodies
    force = 2.0 / 3.0 * math.pi * found.longitudinal_semi_axis * found.lateral_semi_axis * found.peak_pressure
    contact = wk.EllipticIndentation(bodies, problem.medium, wk.Force(float(force)))
    return getattr(ContactStress(contact).solve(), key)


def measured(fields, key):
    """Return a stress of a kind from its components, tension positive; of plane strain without two of the shears."""
    none = np.zeros_like(fields.xx_stress)
    xy, yz = getattr(fields, "xy_stress", none), getattr(fields, "yz_stress", none)
    xx, yy, zz, xz = fields.xx_stress, fields.yy_stress, fields.zz_stress, fields.xz_stress
    if key == "orthogonal_shear":
        return np.hypot(xz, yz)
    if key == "von_mises":
        return np.sqrt(0.5 * ((xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2) + 3.0 * (xy**2 + xz**2 + yz**2))
    rows = np.stack([np.stack(row, axis=-1) for row in ((xx, xy, xz), (xy, yy, yz), (xz, yz, zz))], axis=-2)
    principal = np.linalg.eigvalsh(rows)
    return 0.5 * (principal[..., 2] - principal[..., 0])


@pytest.mark.parametrize("kind", KINDS)
def test_the_summary_has_the_numbers_that_are_asked_for(kind):
    outcome = outcome_of(kind)
    asked = [name for name in answers()[kind].headline if name in outcome.answers]
    finite = {name for name in asked if not np.isnan(np.ravel(outcome.answer(name))[-1])}
    rows = summary_of(kind)
    assert finite <= set(rows), "what the question asks is not among the rows"
    assert rows, "no row"
    contact = {name for name in CALLED if name in outcome.answers and np.isfinite(outcome.answer(name)).all()}
    assert contact <= set(rows), "a number of the contact is not among the rows"


@pytest.mark.parametrize("kind", KINDS)
def test_each_row_is_a_number_of_the_solution_with_its_unit(kind):
    for key, row in summary_of(kind).items():
        if key in STRESSES and key not in outcome_of(kind).answers:
            continue
        if key == "stresses":
            assert row.remark
            assert STRESSES.isdisjoint(summary_of(kind)), "both stresses and why there are none"
            continue
        ends = [one[[-1, int(np.nanargmax(np.abs(one)))]] for one in candidates(kind, key) if np.isfinite(one).any()]
        assert any(row.number == pytest.approx(one, rel=1e-9) for end in ends for one in end), (key, row, ends)
        if " … " not in row.text and math.isfinite(row.number):
            assert read(row.text, row.unit) == pytest.approx(row.number, rel=DIGITS), (key, row.text)


@pytest.mark.parametrize("kind", KINDS)
def test_stresses_are_those_that_another_way_finds(kind):
    """Below round contacts, ellipses, cylinders, strips and waves; maps, rollers, metals, relaxing bodies follow."""
    for key in STRESSES & set(summary_of(kind)) - set(outcome_of(kind).answers):
        other, apart = other_stress(kind, key)
        assert (other is None) == (kind in FOLLOW or (kind in ADHESIVE and key == "orthogonal_shear"))
        if other is not None:
            assert summary_of(kind)[key].number == pytest.approx(other, rel=apart), key


def pressed_map(kind):
    """Return the medium and the loads of the height map, or of the most pressed patch, of an example."""
    solution = shown_point(outcome_of(kind)).solution
    patches = getattr(solution, "patches", ())
    if isinstance(patches, tuple) and patches:
        patch = max(patches, key=lambda one: np.max(one.surface_load.pressure))
        return getattr(patch, "patch", patch).medium, [patch.surface_load]
    if not hasattr(solution, "surface_load"):
        solution = shown_point(outcome_of(kind)).each[-1].contact
    loads = [solution.surface_load]
    for one in getattr(solution, "heaviest", ()):
        lengths = solution.problem.topography.lengths
        periodic = solution.problem.topography.periodic
        loads.append(wk.SurfaceLoad(one.pressure, lengths, *one.traction, periodic=periodic))
    medium = getattr(solution.problem, "medium", None) or wk.HalfSpace(solution.problem.solid)
    return medium, loads


@pytest.mark.parametrize("kind", marked(sorted(MAPS)))
def test_stresses_of_maps_are_those_of_a_search_between_their_pixels(kind):
    """By `MapStress`, which climbs from place to place, where the summary compares depths; of all heavy states."""
    medium, loads = pressed_map(kind)
    found = [wk.MapStress(load, medium.first).solve().von_mises for load in loads]
    assert summary_of(kind)["von_mises"].number == pytest.approx(max(found), rel=0.02)


def test_stresses_of_a_ball_on_a_map_are_those_of_hertz():
    """A ball of 10 mm on pixels of 8 um, of which the contact is 37 wide."""
    x = (np.arange(64) - 31.5) * 8e-6
    heights = -(x[:, None] ** 2 + x[None, :] ** 2) / 20e-3
    steel = wk.HalfSpace(wk.Elastic(210e9, 0.3, strength=2e9))
    mapped = wk.SurfaceContact(wk.Topography(heights, [512e-6, 512e-6]), steel, wk.Force(100.0)).solve()
    point = SimpleNamespace(problem=mapped.problem, solution=mapped, each=(mapped,))
    state = elastic_state.__wrapped__(point)
    ball = wk.ContactStress(wk.Indentation(wk.Foundation(wk.Paraboloid(10e-3), steel), wk.Force(100.0))).solve()
    assert state.von_mises == pytest.approx(ball.von_mises, rel=5e-3)
    assert state.shears[0].value == pytest.approx(ball.max_shear, rel=5e-3)
    assert state.shears[1].value == pytest.approx(ball.orthogonal_shear, rel=2e-2)
    assert state.depth == pytest.approx(ball.von_mises_depth, rel=0.03)
    assert state.share == pytest.approx(ball.von_mises / 2e9, rel=5e-3)


def test_bodies_that_relax_slowly_have_the_stresses_of_hertz():
    """Stresses below given pressures depend on Poisson's ratio alone; at the greatest force of a blow of depth."""
    solid = wk.StandardSolid(1e6, 1e6, 1e9, 0.4)
    path = wk.Path([0.0, 1.0, 2.0], wk.Depth([0.0, 1e-5, 0.0]))
    bed = wk.Foundation(wk.Paraboloid(10e-3), wk.ViscoelasticHalfSpace(solid))
    found = wk.ViscoelasticIndentation(bed, path).solve()
    state = elastic_state.__wrapped__(SimpleNamespace(problem=found.problem, solution=found, each=(found,)))
    elastic = wk.Foundation(wk.Paraboloid(10e-3), wk.HalfSpace(wk.Elastic(2.0 * 2e6 * 1.4, 0.4)))
    ball = wk.ContactStress(wk.Indentation(elastic, wk.Force(float(np.max(found.force))))).solve()
    assert state.von_mises == pytest.approx(ball.von_mises, rel=2e-3)
    assert state.shears[0].value == pytest.approx(ball.max_shear, rel=2e-3)
    assert state.depth == pytest.approx(ball.von_mises_depth, rel=0.01)


def test_metals_that_yield_bear_their_strength_and_below_it_the_elastic_stress():
    """Of a ball the stress is the cube root of the load, of a cylinder its square root, up to the first yield."""
    for kind, power in (("plastic_indentation", 1.0 / 3.0), ("line_plastic_indentation", 0.5)):
        row = summary_of(kind)["von_mises"]
        assert row.number == 700e6
        assert "residual stresses are not computed" in row.remark
        assert "times this" in summary_of(kind)["yield_force"].remark
        problem = outcome_of(kind).points[0].problem
        half = dataclasses.replace(problem, path=type(problem.path)([0.0, 0.5 * problem.yield_force]))
        state = elastic_state.__wrapped__(SimpleNamespace(problem=half, solution=half.solve(), each=(half.solve(),)))
        assert state.von_mises == pytest.approx(700e6 * 0.5**power, rel=1e-9)


@pytest.mark.parametrize("kind", KINDS)
def test_the_rows_keep_physical_bounds(kind):
    """Means are below peaks; tau is between half and 1/sqrt(3) of von Mises; shares and loss factors are positive."""
    number = {key: row.number for key, row in summary_of(kind).items() if " … " not in row.text}
    little = 1.0 + 1e-9

    def ordered(low, high, factor=1.0):
        if low in number and high in number:
            assert number[low] <= little * factor * number[high], (low, high)

    if number.get("force", 1.0) > 0.0:
        ordered("mean_pressure", "peak_pressure")
        ordered("nominal_pressure", "mean_pressure")
    ordered("max_shear", "von_mises", 1.0 / math.sqrt(3.0))
    ordered("orthogonal_shear", "max_shear")
    if "max_shear" in number and "von_mises" in number:
        assert number["max_shear"] >= 0.5 * number["von_mises"] / little
    assert 0.0 <= number.get("contact_share", 0.0) <= 1.0
    for name in ("area", "radius", "half_width", "loss_per_cycle", "loss_factor", "leak_per_width", "peak_pressure"):
        assert number.get(name, 0.0) >= 0.0, name


@pytest.mark.parametrize("kind", KINDS)
def test_no_number_that_is_shown_is_rounding(kind):
    """What is more than rounding moves in the digits in which the inputs move: in the ninth, not in the second."""
    point, others = outcome_of(kind).points[0], [outcome.points[0] for outcome in moved_outcomes(kind)]
    assert others or kind in WITHOUT_FORCES, "nothing was moved"
    for name, numbers in point.readable.items():
        for other in others if name not in RESIDUALS else ():
            assert other.readable[name] == pytest.approx(numbers, rel=KEPT, abs=0.0, nan_ok=True), name


def test_rounding_is_kept_in_files_and_named_where_it_is():
    """The lateral force of a wheel that rolls straight on is some nN of 100 N: zero for readers, kept in files."""
    outcome = outcome_of("surface_rolling")
    kept = {column.name: column.content for column in outcome.table()}["lateral_force"]
    shown = {column.name: column.content for column in outcome.readable_table()}["lateral_force"]
    assert 0.0 < np.max(np.abs(kept)) < 1e-6
    assert np.all(shown == 0.0)
    assert summary_of("surface_rolling")["longitudinal_force"].number == outcome.answer("longitudinal_force")[-1]
    assert "nN" not in " ".join(row.text for row in summary_of("surface_rolling").values())


def test_json_has_the_rows_of_the_summary(tmp_path, capsys):
    study = tmp_path / "ball.toml"
    study.write_text(tomli_w.dumps({"title": "x", **example_study("surface_rolling")}), encoding="utf-8")
    assert main(["run", str(study), "--json"]) == 0
    rows = {row["key"]: row for row in json.loads(capsys.readouterr().out)["summary"]}
    assert rows == {key: row.table() for key, row in summary_of("surface_rolling").items()}
    assert rows["lateral_force"]["value"] == 0.0
    assert rows["von_mises"]["unit"] == "Pa"


def test_stresses_below_a_map_are_drawn_over_the_depth():
    """The greatest of each kind at each depth, as `stresses_at_depth` has them in the middles of the pixels."""
    outcome = outcome_of("surface_contact")
    figure = next(one for one in figures_of(outcome) if one.name == "depths")
    assert "on this grid, without friction" in figure.sentence
    solution = shown_point(outcome).solution
    part = solution.problem.medium.first
    below = greatest_below(solution.surface_load.field(part.poisson), STATED)
    for z, values in zip(below.depths, below.values.T, strict=True):
        fields = solution.stresses_at_depth(float(z))
        expected = [np.max(measured(fields, key)) for key in ("von_mises", "max_shear", "orthogonal_shear")]
        assert values == pytest.approx(expected, rel=1e-6)
