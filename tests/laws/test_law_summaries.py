"""Every problem has a summary: the numbers that it is asked for, those of its contact, with units, within bounds."""

from __future__ import annotations

import functools
import math
import re

import numpy as np
import pytest
import tomli_w

from winkler.problems.subsurface.contact_stress import ContactStress
from winkler.study.batch.run import run
from winkler.study.chapters.contents import answers
from winkler.study.language.explain import example_study
from winkler.study.language.reading import parse_study
from winkler.study.report.headline.declared import CALLED
from winkler.study.report.headline.elastic_state import elastic_state, stressed_contact
from winkler.study.report.headline.shown_contact import shown_contact, shown_point
from winkler.study.report.headline.summary import contact_summary
from winkler.values.units import quantity

SLOW_EXAMPLES = {"viscoelastic_impact"}
KINDS = [pytest.param(kind, marks=[pytest.mark.slow] * (kind in SLOW_EXAMPLES)) for kind in answers()]
WITHOUT_FORCES = {"held_contacts", "spot_cluster", "band_heating"}
STRESSES = {"max_shear", "orthogonal_shear"}
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
    named = [(point.answers, point.problem), *((vars_of(one), getattr(one, "problem", None)) for one in contacts)]
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
    if key in ("von_mises", "peak_pressure") and state is not None:
        yield np.array([getattr(state, key)])
    elif key == "yield_force" and state is not None:
        yield np.array([state.yield_load])
    elif key in STRESSES and state is not None:
        yield np.array([getattr(ContactStress(stressed_contact(point).problem).solve(), key)])


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
        ends = [one[[-1, int(np.nanargmax(np.abs(one)))]] for one in candidates(kind, key) if np.isfinite(one).any()]
        assert any(row.number == pytest.approx(one, rel=1e-9) for end in ends for one in end), (key, row, ends)
        if " … " not in row.text and math.isfinite(row.number):
            assert read(row.text, row.unit) == pytest.approx(row.number, rel=DIGITS), (key, row.text)


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
