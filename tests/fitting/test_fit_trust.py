"""What a fit says about itself: range of adhesion, coating, tip and baseline, confirmed by closed forms."""

from __future__ import annotations

import dataclasses
import math
import re

import numpy as np
import pytest
from synthetic import hertz, jkr, noise, there_and_back

import winkler as wk
from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.fit import fit
from winkler.fitting.validity import fit_notes
from winkler.laws.adhesion import DerjaguinMullerToporov, Dugdale, ShortRange
from winkler.problems.adhesion.indentation import AdhesiveIndentation
from winkler.values.validity import Note, Standing

R, YOUNG, WORK = 5e-6, 1e4, 1e-4
MODULUS = YOUNG / 0.75
PATH = "bed.medium.first.young"


def bed(young: float = YOUNG, radius: float = R) -> wk.Foundation:
    return wk.Foundation(wk.Paraboloid(radius), wk.HalfSpace.between(wk.Elastic(young, 0.5)))


def curve(bottom: float = -1e-6) -> ForceCurve:
    position, _ = there_and_back(bottom, 1e-6, 300)
    return ForceCurve(position, hertz(position, MODULUS, R) + 2e-11 * noise(np.random.default_rng(0), 600))


def note_on(notes: tuple[Note, ...], topic: str) -> Note:
    return next(note for note in notes if note.statement.startswith(topic))


def sticky(law, young: float, radius: float) -> tuple[Note, ...]:
    model = AdhesiveIndentation(bed(young, radius), law, wk.Depth(0.1 * radius))
    return fit_notes(model, curve(), (PATH,), curve().position > 0.0, 0.3 * radius, 0.01)


@pytest.mark.parametrize(
    ("law", "young", "radius", "standing"),
    [
        (ShortRange(1e-4), 1e4, 5e-6, Standing.ASYMPTOTIC),
        (ShortRange(0.05), 1e9, 1e-6, Standing.APPROXIMATE),
        (ShortRange(0.02), 5e10, 20e-9, Standing.OUTSIDE),
        (DerjaguinMullerToporov(0.02), 5e10, 20e-9, Standing.ASYMPTOTIC),
        (DerjaguinMullerToporov(0.05), 1e9, 1e-6, Standing.OUTSIDE),
        (DerjaguinMullerToporov(1e-4), 1e4, 5e-6, Standing.OUTSIDE),
    ],
)
def test_the_range_of_attraction(law, young, radius, standing):
    """Tabor's parameter from its definition, with a range of 0.3 nm."""
    note = note_on(sticky(law, young, radius), "Range")
    tabor = float(re.search(r"Tabor parameter is ([-+.e0-9]+):", note.statement)[1])
    assert tabor == pytest.approx(math.cbrt(radius * (law.work / (young / 0.75)) ** 2) / 0.3e-9, rel=0.01)
    assert note.standing is standing
    assert ("use Dugdale(work, strength)" in note.statement) == (standing is not Standing.ASYMPTOTIC)


def test_a_law_with_a_range_needs_no_such_note():
    assert not any(note.statement.startswith("Range") for note in sticky(Dugdale(1e-4, 1e5), 1e4, 5e-6))


def coated(thickness: float, names: tuple[str, ...]) -> Note:
    medium = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(YOUNG, 0.5), thickness)], on=wk.Elastic(1e9, 0.2))
    model = wk.Indentation(wk.Foundation(wk.Paraboloid(R), medium), wk.Depth(1e-8))
    return note_on(fit_notes(model, curve(), names, curve().position > 0.0, 2e-7, 0.01), "Coating")


def test_a_thick_coating_says_nothing_of_what_carries_it():
    """Small a/h: k = 2 E* a (1 + 1.1 .. 1.3 a/h) on a hard base; at a/h = 0.001 less than a percent."""
    film = "bed.medium.layers[0].solid.young"
    assert coated(2e-4, (film,)).standing is Standing.ASYMPTOTIC
    blind = coated(2e-4, (film, "bed.medium.on.young"))
    assert blind.standing is Standing.OUTSIDE
    assert "hardly depends on bed.medium.on.young" in blind.statement
    assert coated(2e-4, (film, "bed.medium.layers[0].thickness")).standing is Standing.OUTSIDE


def test_a_thin_coating():
    note = coated(4e-7, ("bed.medium.layers[0].solid.young",))
    assert note.standing is Standing.APPROXIMATE
    assert "0.5 of the thickness 400 nm" in note.statement
    assert (
        "distinguished only by the increase of this effect"
        in coated(4e-7, ("bed.medium.layers[0].solid.young", "bed.medium.on.young")).statement
    )


def test_a_paraboloid_for_a_ball():
    """The ball's force from Sneddon: F = E* ((a^2 + R^2)/2 ln((R + a)/(R - a)) - a R), d = a/2 ln(...)."""
    a = 2e-6
    logarithm = math.log((R + a) / (R - a))
    depth, force = 0.5 * a * logarithm, MODULUS * (0.5 * (a**2 + R**2) * logarithm - a * R)
    share = force / hertz(depth, MODULUS, R) - 1.0
    model = wk.Indentation(bed(), wk.Depth(depth))
    note = note_on(fit_notes(model, curve(), (PATH,), curve().position > 0.0, a, 0.01), "Tip")
    assert f"change the force by {share:+.2%}" in note.statement
    assert note.standing is Standing.APPROXIMATE
    small = note_on(
        fit_notes(dataclasses.replace(model, load=wk.Depth(1e-9)), curve(), (), curve().position > 0, 7e-8, 0.0), "Tip"
    )
    assert small.standing is Standing.ASYMPTOTIC


def test_a_contact_wider_than_the_tip():
    model = wk.Indentation(bed(), wk.Depth(6e-6))
    note = note_on(fit_notes(model, curve(), (PATH,), curve().position > 0.0, 5.5e-6, 0.01), "Tip")
    assert note.standing is Standing.OUTSIDE


def test_a_contact_that_stays_on_the_ball_of_a_cone():
    tip = wk.SpheroConical(curvature_radius=1e-6, half_angle=0.6)
    model = wk.Indentation(wk.Foundation(tip, bed().medium), wk.Depth(1e-8))
    note = note_on(fit_notes(model, curve(), (PATH,), curve().position > 0.0, 1e-7, 0.01), "Tip")
    assert "does not depend on the other parts" in note.statement


def test_the_extent_of_the_baseline():
    names = [PATH, "contact_point", "baseline"]
    notes = fit(curve(), wk.Indentation(bed(), wk.Depth(0.0)), free=names).validity
    note = note_on(notes, "Baseline")
    assert note.standing is Standing.EXACT
    assert "50% of the travel) on approach and" in note.statement
    assert note_on(notes, "Tip")  # the contact's own notes and the fit's
    short = note_on(fit(curve(-5e-8), wk.Indentation(bed(), wk.Depth(0.0)), free=names).validity, "Baseline")
    assert short.standing is Standing.APPROXIMATE
    assert "depends on the model" in short.statement


def test_a_real_fit_classifies_its_adhesion():
    position, inward = there_and_back(-1e-6, 1e-6, 300)
    force = jkr(position, inward, MODULUS, R, WORK, 0.05) + 2e-11 * noise(np.random.default_rng(1), 600)
    model = AdhesiveIndentation(bed(), ShortRange(1e-3), wk.Depth(0.0))
    found = fit(ForceCurve(position, force, 0.05), model, free=[PATH, "law.work", "contact_point"])
    assert note_on(found.validity, "Range").standing is Standing.ASYMPTOTIC
