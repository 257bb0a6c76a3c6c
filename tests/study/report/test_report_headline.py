"""The elastic contact beside an answer, and the advice beside the worst statement, against closed forms."""

from __future__ import annotations

import math
import re
from dataclasses import astuple
from types import SimpleNamespace

import numpy as np
import pytest
import tomli_w

import winkler as wk
from winkler.study.batch.run import run
from winkler.study.chapters.contents import answer_of
from winkler.study.language.catalogue import CATALOGUE
from winkler.study.language.explain import example_study
from winkler.study.language.reading import parse_study
from winkler.study.language.template import whole_text
from winkler.study.report.headline.advice import ADVICE, worst_doubt
from winkler.study.report.headline.elastic_state import _pressed_strip, elastic_state, unknown_because
from winkler.study.report.headline.section import doubt_line, doubt_of, headline, headline_section
from winkler.study.report.headline.shown_contact import shown_point, stressed_contact
from winkler.study.report.headline.summary import contact_summary
from winkler.study.report.tables import contact_section
from winkler.values.units import quantity
from winkler.values.validity import Assumption, Note, Standing, in_words

MODULUS = 210e9 / (1.0 - 0.3**2)
"""Effective modulus of steel against a rigid body [Pa]."""
RADIUS = 10e-3


def solved(kind, **changes):
    """Return the outcome of the example of a kind, with other contents at some paths."""
    table = example_study(kind)
    for path, content in changes.items():
        holder = table
        *parents, last = path.split("__")
        for name in parents:
            holder = holder[name]
        holder[last] = content
    return run(parse_study(tomli_w.dumps({"title": "x", **table})))


def ball(**changes):
    steel = {"kind": "elastic", "young": "210 GPa", "poisson": 0.3, **changes.pop("steel", {})}
    profile = {"kind": "paraboloid", "curvature_radius": "10 mm"}
    bed = {"kind": "foundation", "profile": profile, "medium": {"kind": "half_space", "first": steel}}
    return solved("indentation", problem__bed=bed, **changes)


def test_a_ball_has_the_stresses_of_hertz():
    """Johnson, Contact Mechanics (1985), sec. 4.2: 0.62 p0 at 0.48 a for nu = 0.3; p0 = (6 F E*^2 / pi^3 R^2)^(1/3)."""
    state = elastic_state(shown_point(ball()))
    pressure = (6.0 * 100.0 * MODULUS**2 / (math.pi**3 * RADIUS**2)) ** (1.0 / 3.0)
    width = (0.75 * 100.0 * RADIUS / MODULUS) ** (1.0 / 3.0)
    assert state.peak_pressure == pytest.approx(pressure, rel=1e-12)
    z = np.linspace(0.3, 0.7, 400_001)  # stresses on the axis of Hertz's contact, over p0
    hoop = -1.3 * (1.0 - z * np.arctan(1.0 / z)) + 0.5 / (1.0 + z**2)
    level = np.abs(hoop + 1.0 / (1.0 + z**2))
    assert state.von_mises == pytest.approx(float(np.max(level)) * pressure, rel=1e-9)
    assert state.depth == pytest.approx(float(z[np.argmax(level)]) * width, rel=1e-4)
    assert math.isnan(state.yield_load)


def test_the_load_of_yield_follows_from_the_strength():
    """A ball yields at p0 = Y / 0.62, by the cube of the pressure; with half the strength at an eighth of the load."""
    state = elastic_state(shown_point(ball(steel={"strength": "700 MPa"})))
    assert state.yield_load == pytest.approx(100.0 * (700e6 / state.von_mises) ** 3, rel=1e-8)
    half = elastic_state(shown_point(ball(steel={"strength": "350 MPa"})))
    assert half.yield_load == pytest.approx(state.yield_load / 8.0, rel=1e-8)
    page = headline_section(ball(steel={"strength": "700 MPa"}))
    assert f"{state.yield_load:.4g} N" in page


def test_a_cylinder_has_the_stresses_of_hertz():
    """Below the axis of a strip of Hertz, with s = sqrt(1 + z^2): s_x, s_z and nu (s_x + s_z) over p0."""
    outcome = solved("line_indentation")
    state, answers = elastic_state(shown_point(outcome)), outcome.points[0].answers
    z = np.linspace(0.5, 1.0, 400_001)
    s = np.sqrt(1.0 + z**2)
    along, down = -((1.0 + 2.0 * z**2) / s - 2.0 * z), -1.0 / s
    across = 0.3 * (along + down)
    level = np.sqrt(0.5 * ((along - across) ** 2 + (across - down) ** 2 + (down - along) ** 2))
    peak = float(answers["peak_pressure"][0])
    assert state.von_mises == pytest.approx(float(np.max(level)) * peak, rel=1e-9)
    assert state.depth == pytest.approx(float(z[np.argmax(level)]) * float(answers["half_width"][0]), rel=1e-4)
    assert state.unit == "N/m"


@pytest.mark.parametrize(("kind", "reason"), [
    ("line_adhesion", "the edge is under tension"),
    ("line_fretting_wear", "known at single places only; line_indentation states"),
    ("sliding_wear", "known at single places only; indentation states"),
    ("rough_contact", "no pressure at each place"),
    ("harmonic_indentation", "depends on the history of the load; viscoelastic_indentation"),
    ("dent_limit", "a metal that has yielded"),
])  # fmt: skip
def test_what_is_not_an_elastic_contact_says_why_it_has_no_stresses(kind, reason):
    outcome = solved(kind)
    assert elastic_state(shown_point(outcome)) is None
    assert reason in headline_section(outcome)
    (row,) = (one for one in contact_summary(outcome) if one.key == "stresses")
    assert reason in row.remark
    assert row.table()["value"] is None


def test_an_answer_without_a_load_gives_no_reason():
    assert unknown_because(shown_point(solved("spot_cluster"))) == ""


def test_the_stresses_of_a_creep_test_follow_from_its_history():
    """Lee and Radok's pressure of a Maxwell solid by quadrature, and below it Boussinesq's rings on the axis."""
    tau, force, moment, maxwell = 1.0, 1.0, 0.5, {"kind": "maxwell", "shear": "1 MPa", "relaxation_time": "1 s"}
    ball = {"kind": "paraboloid", "curvature_radius": "10 mm"}
    bed = {"kind": "foundation", "profile": ball, "medium": {"kind": "viscoelastic_half_space", "first": maxwell}}
    outcome = solved("creep_test", problem__bed=bed, problem__force="1 N", problem__time=["0.5 s"])
    times = moment * (1.0 - np.linspace(1.0, 0.0, 4001) ** 2)
    widths = np.cbrt(0.75 * force * RADIUS * (1.0 + times / tau) / 4e6)
    r = widths[-1] * np.sin(np.linspace(0.0, 0.5 * np.pi, 801))
    elastic = 8e6 / np.pi / RADIUS * np.sqrt(np.maximum(widths**2 - r[:, None] ** 2, 0.0))
    faded = np.exp((times - moment) / tau) / tau
    pressure = elastic[:, -1] - np.trapezoid(faded * elastic, times, axis=1)
    z = widths[-1] * np.linspace(0.2, 0.9, 701)[:, None]
    apart = np.hypot(r, z)
    down = -3.0 * np.trapezoid(pressure * z**3 * r / apart**5, r, axis=1)
    trace = -3.0 * np.trapezoid(pressure * z * r / apart**3, r, axis=1)  # 2 (1 + nu)
    state = elastic_state(shown_point(outcome))
    assert state.peak_pressure == pytest.approx(pressure[0], rel=1e-5)
    assert state.von_mises == pytest.approx(np.max(np.abs(1.5 * down - 0.5 * trace)), rel=1e-3)


def test_a_strip_by_its_own_pressure_is_that_of_hertz():
    bed = wk.LineFoundation(wk.Paraboloid(RADIUS), wk.HalfSpace(wk.Elastic(210e9, 0.3)))
    contact = wk.LineIndentation(bed, wk.LineForce(1e5)).solve()
    state = _pressed_strip(SimpleNamespace(each=[contact], problem=contact.problem))
    closed = wk.ContactStress(contact.problem).solve()
    assert state.von_mises == pytest.approx(closed.von_mises, rel=2e-5)
    assert state.shears[0].value == pytest.approx(closed.max_shear, rel=2e-5)


def test_without_a_strength_the_page_says_so():
    page = headline_section(ball())
    assert "set a strength of the first body to see it" in page
    assert "71.2 µm below the surface" in page


def test_each_assumption_has_an_advice():
    assert set(ADVICE) == set(Assumption)


def test_an_error_that_is_stated_asks_for_something_else_than_a_limit_that_is_passed():
    """A pyramid, replaced by its cone, was measured as far as it was pressed."""
    profile = {"kind": "vickers"}
    outcome = ball(problem__bed__profile=profile, problem__load={"kind": "depth", "depth": "10 nm"})
    doubt = worst_doubt(tuple(note for note in outcome.validity if "pyramid" in note.statement))
    assert doubt.advice == "What to do: compare with another description of the shape, or allow for this error."


def test_springs_that_are_calibrated_are_not_to_be_calibrated():
    steel = wk.HalfSpace.between(wk.Elastic(210e9, 0.3), wk.Elastic(210e9, 0.3))
    ball = wk.Foundation(wk.Paraboloid(RADIUS), steel)
    doubt = worst_doubt(wk.Kalker().notes(ball, 1e-4))
    assert "is calibrated with Kalker's coefficients" in doubt.statement
    assert doubt.advice == "What to do: allow for this error, or solve the contact as surface_rolling."
    doubt = worst_doubt(wk.Uncalibrated().notes(ball, 1e-4))
    assert "not calibrated" in doubt.statement
    assert doubt.advice == "What to do: calibrate the springs by Kalker's coefficients."


def test_the_advice_names_the_load_that_the_size_allows():
    """A slope and a share of the radius of 0.1 are reached at F = 4/3 E* (0.1 R)^3 / R."""
    doubt = doubt_of(ball(problem__load={"kind": "force", "force": "100 kN"}))
    limit = 4.0 / 3.0 * MODULUS * (0.1 * RADIUS) ** 3 / RADIUS
    named = re.search(r"use at most ([\d.]+) (k?)N", doubt.advice)
    load = float(named[1]) * (1e3 if named[2] else 1.0)
    assert doubt.standing is Standing.APPROXIMATE
    assert load == pytest.approx(limit, rel=0.01)
    assert load <= limit
    assert doubt_of(ball()).statement == ""


def test_shear_stresses_are_the_greatest_of_both_bodies():
    """The second body yields first and has the lower shear stress: Poisson's ratio lessens it (Johnson, sec. 3.4)."""
    soft = {"kind": "elastic", "young": "70 GPa", "poisson": 0.45, "strength": "90 MPa"}
    hard = {"kind": "elastic", "young": "210 GPa", "poisson": 0.1}
    outcome = solved("indentation", problem__bed__medium={"kind": "half_space", "first": hard, "second": soft})
    parts = wk.ContactStress(outcome.study.problem).solve().parts
    state = elastic_state(shown_point(outcome))
    assert state.body == "second body"
    for found, name in zip(state.shears, ("max_shear", "orthogonal_shear"), strict=True):
        assert found.value == pytest.approx(max(getattr(part, name) for part in parts), rel=1e-6)
        assert found.body == max(parts, key=lambda part: getattr(part, name)).name
    assert parts[0].max_shear > 1.05 * parts[1].max_shear


STRONG = {"kind": "elastic", "young": "210 GPa", "poisson": 0.3, "strength": "700 MPa"}
COATED = {
    "kind": "coated_half_space",
    "layers": [{"kind": "layer", "solid": STRONG, "thickness": "5 um"}],
    "on": STRONG,
}
HEAVY = {
    "indentation": {"problem__load": {"kind": "force", "force": "20 kN"}},
    "line_indentation": {"problem__load": {"kind": "line_force", "force_per_length": "20 kN/mm"}},
    "impact": {},
}


@pytest.mark.parametrize("kind", HEAVY)
def test_beyond_the_onset_of_yield_the_advice_names_the_kind_that_goes_on(kind):
    """That kind solves the same question; on layers, which it does not take, the advice is another."""
    outcome = solved(kind, **HEAVY[kind], problem__bed__medium={"kind": "half_space", "first": STRONG})
    further = answer_of(outcome.study.problem).beyond
    advice = f"What to do: solve it as {further}, which follows the metal beyond its elastic limit."
    assert doubt_of(outcome).advice == advice
    problem, followed = outcome.study.problem, CATALOGUE["problem"][further].cls
    if kind == "impact":
        same = followed(problem.bed, problem.mass, problem.velocity)
    else:
        same = followed(problem.bed, type(problem.load)(np.ravel(*astuple(problem.load))))
    assert np.all(same.solve().residual_depth > 0.0)
    layers = {"kind": "layered_line_foundation"} if kind == "line_indentation" else {}
    coated = solved(
        kind, **HEAVY[kind], problem__bed={**example_study(kind)["problem"]["bed"], **layers, "medium": COATED}
    )
    assert doubt_of(coated).advice == f"What to do: {ADVICE[Assumption.ELASTIC]}."


def test_what_is_good_to_a_per_cent_or_more_says_why():
    """A slope of 0.09 is small; the deviation that it makes stands in the head, without an advice."""
    outcome = ball(problem__load={"kind": "depth", "depth": f"{0.0081 * RADIUS} m"})
    doubt = doubt_of(outcome)
    assert in_words(outcome.validity) in ("good to about 4 %", "good to about 3 %")
    assert doubt.advice == ""
    assert "0.09" in doubt.statement
    assert doubt_line(doubt).startswith('<p class="since">The ')
    assert doubt_line(doubt_of(ball())) == ""


def test_of_two_notes_of_one_standing_that_with_the_greater_error_decides():
    notes = [
        Note(Assumption.SMALL_SLOPES, Standing.APPROXIMATE, f"It is off by {error}.", "a check", error)
        for error in (None, 0.06, 0.07)
    ]
    assert worst_doubt(tuple(notes)).statement == "It is off by 0.07."
    assert in_words(notes) == "an estimate: ± 7 % or more"


def test_a_sweep_is_headed_by_a_range():
    outcome = solved("indentation", sweep={"problem.load.force": ["10 N", "80 N"]})
    depth = [float(point.answers["depth"][0]) for point in outcome.points]
    assert depth[1] / depth[0] == pytest.approx(4.0, rel=0.01)
    low, high = (f"{1e9 * depth[0]:.4g} nm", f"{1e6 * depth[1]:.4g} µm")
    lead = headline_section(outcome).partition("</p>")[0].replace("\xa0", " ")
    assert lead.endswith(f"Over 2 points the depth rises from {low} at force = 10 N to {high} at force = 80 N.")
    outcome = solved("indentation", sweep={"problem.load.force": ["80 N", "10 N", "20 N"]})
    lead = headline_section(outcome).partition("</p>")[0].replace("\xa0", " ")
    assert lead.endswith(f"Over 3 points the depth is between {low} (force = 10 N) and {high} (force = 80 N).")


def test_a_sweep_of_many_velocities_says_which_one_is_compared():
    velocities = {"problem__velocity": ["0.1 m/s", "0.2 m/s"]}
    outcome = solved("plastic_impact", **velocities, sweep={"problem.bed.medium.first.strength": ["1 GPa", "2 GPa"]})
    low, high = (f"{point.answers['restitution'][-1]:.4g}" for point in outcome.points)
    lead = headline_section(outcome).partition("</p>")[0].replace("\xa0", " ")
    assert f"Over 2 points and at the last velocity, 200 mm/s, the restitution rises from {low} at" in lead
    assert lead.endswith(f"to {high} at strength = 2 GPa.")


def test_a_sweep_of_paths_is_headed_by_what_each_has_lost():
    """A loop begins without a loss: the range is over the points, not along their paths."""
    outcome = solved("tangential", sweep={"problem.law.coefficient": [0.3, 0.4]})
    ends = [f"{1e6 * point.answers['dissipation'][-1]:.4g} µJ" for point in outcome.points]
    lead = headline_section(outcome).partition("</p>")[0].replace("\xa0", " ")
    assert f"the dissipation falls from {ends[0]} at coefficient = 0.3 to {ends[1]} at coefficient = 0.4" in lead


def test_a_sweep_without_a_difference_says_so():
    outcome = solved("impact", sweep={"problem.mass": ["1 g", "2 g"]})
    assert "The restitution is 1 at all 2 points." in headline_section(outcome).replace("\xa0", " ")


def test_a_map_touches_on_a_part_of_its_area():
    """The example of a rough square of a millimetre by a millimetre."""
    outcome = solved("rough_contact")
    share = 100.0 * outcome.points[0].answers["area"][-1] / outcome.study.problem.side**2
    assert f"touch on {share:.3g} % of the area" in headline_section(outcome).replace("\xa0", " ")


def test_the_margin_stands_in_the_headline_and_not_where_yield_is_sought():
    """A ball yields at the cube of strength over stress times its load."""
    state = elastic_state(shown_point(outcome := ball(steel={"strength": "7000 MPa"})))
    text = headline_section(outcome).replace("\xa0", " ")
    assert f"It yields at {(7e9 / state.von_mises) ** 3:.3g} times this load, " in text
    assert "times this load" not in headline_section(solved("yield_onset"))


def test_the_summary_of_a_ball_is_that_of_hertz():
    """Johnson, Contact Mechanics (1985), sec. 4.2: shear of 0.31 p0 at 0.48 a below the middle of a ball, nu = 0.3."""
    found = {one.name: one for one in contact_summary(ball(steel={"strength": "700 MPa"}))}
    pressure = (6.0 * 100.0 * MODULUS**2 / (math.pi**3 * RADIUS**2)) ** (1.0 / 3.0)
    width = (0.75 * 100.0 * RADIUS / MODULUS) ** (1.0 / 3.0)
    assert found["greatest pressure p0"].number == pytest.approx(pressure, rel=1e-9)
    assert found["mean pressure"].number == pytest.approx(pressure / 1.5, rel=1e-9)
    assert found["contact area"].number == pytest.approx(math.pi * width**2, rel=1e-9)
    assert found["approach"].number == pytest.approx(width**2 / RADIUS, rel=1e-9)
    assert found["greatest shear stress"].number == pytest.approx(0.310 * pressure, rel=2e-3)
    assert f"{0.481 * width * 1e6:.1f}"[:2] == found["greatest shear stress"].remark[:2]
    state = elastic_state(shown_point(ball(steel={"strength": "700 MPa"})))
    assert found["load at which it yields"].number == pytest.approx(state.yield_load)
    page = contact_section(ball())
    assert "greatest shear stress" in page
    assert "load at which it yields" not in page


def test_the_summary_compares_steel_balls_in_grooves_with_their_static_rating():
    """4.2 GPa for ball bearings, ISO 76:2006; other materials and round contacts are not rated."""
    solid = {"kind": "elastic", "young": "208 GPa", "poisson": 0.3}
    medium = {"kind": "half_space", "first": solid, "second": solid}
    (first, *_) = contact_summary(solved("elliptic_indentation", problem__medium=medium))
    assert first.remark == f"{first.number / 4.2e9:.3g} of the static rating of ball bearings, 4.2 GPa (ISO 76)"
    soft = {"kind": "half_space", "first": {**solid, "young": "3 GPa"}}
    (first, *_) = contact_summary(solved("elliptic_indentation", problem__medium=soft))
    assert first.remark == ""
    assert contact_summary(ball())[0].remark == ""


def test_the_summary_of_a_sweep_has_ranges_and_the_stresses_of_the_point_that_is_pressed_most():
    """Hertz: p0 grows with the cube root of the load, the approach with its power of two thirds."""
    swept = ball(sweep={"problem.load.force": ["80 N", "10 N"]})
    found = {one.key: one for one in contact_summary(swept)}
    alone = {one.key: one for one in contact_summary(ball(problem__load={"kind": "force", "force": "80 N"}))}
    assert found["peak_pressure"].number == pytest.approx(alone["peak_pressure"].number, rel=1e-12)
    low, high = (quantity(text, "Pa", what="row") for text in found["peak_pressure"].text.split(" … "))
    assert high / low == pytest.approx(2.0, rel=1e-3)
    assert found["depth"].remark == "at force = 10 N … 80 N"
    assert found["von_mises"].number == pytest.approx(alone["von_mises"].number, rel=1e-12)
    assert found["von_mises"].remark.endswith(", at force = 80 N")
    assert "force" not in found  # the study gives it
    assert ", at force = 80" in contact_section(swept).replace("\xa0", " ")


def test_a_sweep_says_which_point_is_nearest_to_yielding():
    """A ball yields at the cube of strength over stress times its load: the heaviest one first, or the weakest."""
    swept = ball(steel={"strength": "3 GPa"}, sweep={"problem.load.force": ["80 N", "1 kN", "10 N"]})
    state = elastic_state(swept.points[1])
    assert f"The point force = 1 kN is nearest to yielding: it yields at {state.margin:.3g} times this load, " in (
        headline(swept)
    )
    strength = "problem.bed.medium.first.strength"
    weak = ball(steel={"strength": "3 GPa"}, sweep={strength: ["3 GPa", "1 GPa", "2 GPa"]})
    found = headline(weak)
    assert "The point strength = 1 GPa is nearest to yielding: it has yielded: this is " in found
    assert "yield" not in headline(ball(sweep={"problem.load.force": ["80 N", "10 N"]}))


def test_a_metal_and_a_map_have_their_margins_too():
    """The load over that of the first yield; below maps, whose stress is no power of the load, the stress itself."""
    dented = solved("plastic_indentation")
    onset = dented.points[0].problem.yield_force
    times = np.max(dented.answer("force")) / onset
    assert f"Its greatest load is {times:.3g} times that of the first yield." in headline(dented)
    solid = {"kind": "elastic", "young": "210 GPa", "poisson": 0.3, "strength": "9 GPa"}
    mapped = solved("surface_contact", problem__medium={"kind": "half_space", "first": solid})
    assert re.search(
        r"Its greatest stress is 0\.\d+ of the strength, [\d.]+ µm below the surface, first body", (headline(mapped))
    )


def test_an_ellipse_of_springs_has_the_stresses_of_hertz():
    """The springs of an ellipse, for their own sake, as `ContactStress` has them of the ellipse itself."""
    steel = wk.HalfSpace(wk.Elastic(210e9, 0.3))
    bodies = wk.CurvedBodies(10e-3, 5e-3)
    found = wk.Indentation(wk.EllipticFoundation(bodies, steel), wk.Force(100.0)).solve()
    state = elastic_state.__wrapped__(SimpleNamespace(problem=found.problem, solution=found, each=(found,)))
    own = wk.ContactStress(wk.EllipticIndentation(bodies, steel, wk.Force(100.0))).solve()
    assert state.von_mises == pytest.approx(own.von_mises, rel=1e-6)
    assert [one.value for one in state.shears] == pytest.approx([own.max_shear, own.orthogonal_shear], rel=1e-6)


def boussinesq(load, x, z, poisson):
    """Return the von Mises stress [Pa] below pixels, each as 16 point forces (Johnson 3.18), at y = 0."""
    sides, counts = np.array(load.pixel) / 4.0, 4 * np.array(load.pressure.shape)
    along, across = (load.corner[i] + (np.arange(counts[i]) + 0.5) * sides[i] for i in range(2))
    force = np.repeat(np.repeat(load.pressure, 4, axis=0), 4, axis=1) * np.prod(sides) / (2.0 * np.pi)
    u, v = x - along[:, None], -across
    square = u * u + v * v
    far, soft = np.sqrt(square + z * z), 1.0 - 2.0 * poisson
    near = soft * (1.0 - z / far) * (u * u - v * v) / square**2
    xx = np.sum(force * (near + soft * z * v * v / (far**3 * square) - 3.0 * z * u * u / far**5))
    yy = np.sum(force * (-near + soft * z * u * u / (far**3 * square) - 3.0 * z * v * v / far**5))
    zz, xz = np.sum(force * -3.0 * z**3 / far**5), np.sum(force * -3.0 * u * z * z / far**5)
    return math.sqrt(0.5 * ((xx - yy) ** 2 + (yy - zz) ** 2 + (zz - xx) ** 2) + 3.0 * xz * xz)


@pytest.mark.slow
def test_a_tilted_roller_is_stressed_most_near_its_end():
    """By point forces; as an endless cylinder its most pressed slice would be 5 % more stressed, five times deeper."""
    steel = wk.HalfSpace(wk.Elastic(210e9, 0.3))
    found = wk.RollerContact(
        10e-3, 10e-3, wk.LogarithmicEnds(1e6), steel, wk.Force(12e3), wk.Tilt(0.5e-3), elements=48
    ).solve()
    state = elastic_state.__wrapped__(SimpleNamespace(problem=found.problem, solution=found, each=(found,)))
    load = found.surface_load
    below = {
        z: max(boussinesq(load, x, z, 0.3) for x in np.linspace(4.9e-3, 4.98e-3, 9)) for z in (50e-6, 66.7e-6, 90e-6)
    }
    assert max(below, key=below.get) == 66.7e-6
    assert state.von_mises == pytest.approx(below[66.7e-6], rel=3e-3)
    assert state.depth == pytest.approx(66.7e-6, abs=10e-6)


@pytest.mark.slow
def test_ellipses_on_layers_have_stresses():
    """On layers of the material of the base they are Hertz'; the summary had called them not implemented."""
    steel = wk.Elastic(210e9, 0.3)
    bodies, load = wk.CurvedBodies(10e-3, 20e-3), wk.Force(20.0)
    found = wk.EllipticIndentation(bodies, wk.CoatedHalfSpace([wk.Layer(steel, 30e-6)], steel), load).solve()
    state = elastic_state.__wrapped__(SimpleNamespace(problem=found.problem, solution=found, each=(found,)))
    own = wk.ContactStress(wk.EllipticIndentation(bodies, wk.HalfSpace(steel), load)).solve()
    assert state.von_mises == pytest.approx(own.von_mises, rel=2e-3)
    assert state.depth == pytest.approx(own.von_mises_depth, rel=0.03)


def test_stresses_below_an_edge_that_adheres_are_those_of_hertz_less_those_of_a_flat_punch():
    """On the axis, of a harmonic f that is 1 at the surface, sigma_z = f - z f', 2 sigma_r = (1 + 2 nu) f + z f'."""
    point = shown_point(run(parse_study(whole_text("adhesive_cycle"))))
    state, contact = elastic_state(point), stressed_contact(point)
    bed, a = contact.problem.bed, contact.radius
    modulus, radius = bed.medium.modulus, bed.profile.curvature_radius
    hertz, punch = 2.0 * modulus * a / (np.pi * radius), np.sqrt(2.0 * contact.problem.law.work * modulus / (np.pi * a))
    assert state.peak_pressure == pytest.approx(hertz - punch, rel=1e-6)
    z, nu = np.linspace(0.3, 0.7, 40001), bed.medium.first.poisson
    slope = z / (1.0 + z * z) - np.arctan(1.0 / z)
    below = [(hertz, 1.0 + z * (slope - z / (1.0 + z * z)), slope)]
    below.append((-punch, 1.0 / (1.0 + z * z), -2.0 * z / (1.0 + z * z) ** 2))
    mises = sum(peak * (0.5 * (1.0 - 2.0 * nu) * f - 1.5 * z * of_z) for peak, f, of_z in below)
    assert state.von_mises == pytest.approx(np.max(mises), rel=1e-6)
    assert state.depth == pytest.approx(z[np.argmax(mises)] * a, rel=1e-3)
    assert "attraction" in state.sharp
    assert state.under == "with adhesion, without friction"
