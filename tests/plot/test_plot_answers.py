"""The picture of an answer whose class has none of its own: its numbers over the load, or its contact."""

from __future__ import annotations

from typing import Any, ClassVar

import numpy as np
import pytest

import winkler as wk
from winkler.plot import sheet_of
from winkler.values.errors import InvalidInput
from winkler.values.value import value
from winkler.values.vocabulary import Word

BED = wk.Foundation(wk.Paraboloid(10e-3), wk.HalfSpace.between(wk.Elastic(210e9, 0.3)))


@value
class Pressing:
    """A problem of a user: the work that presses two bodies together."""

    bed: Any
    load: Any


@value
class PressingSolution:
    """Its answer."""

    problem: Pressing
    pressing_work: Any
    stiffness: Any
    contact: Any

    __words__: ClassVar[dict[str, Word]] = {"pressing_work": Word("W", "J", "work that presses the bodies together")}


def solved(force: Any) -> PressingSolution:
    load = wk.Force(force)
    contact = wk.Indentation(BED, load).solve()
    return PressingSolution(Pressing(BED, load), contact.energy, contact.stiffness, contact)


def test_numbers_of_many_loads_are_drawn_over_the_load():
    force = np.linspace(10.0, 100.0, 7)
    sheet = sheet_of(solved(force))
    assert [panel.title for panel in sheet.panels] == ["pressing work over force", "stiffness over force"]
    for panel, power in zip(sheet.panels, (5.0 / 3.0, 1.0 / 3.0), strict=True):
        [line] = panel.marks
        np.testing.assert_array_equal(line.x, force)
        np.testing.assert_allclose(line.y / line.y[-1], (force / 100.0) ** power, rtol=1e-12)  # Hertz


def test_of_one_load_its_contact_is_drawn_under_its_numbers():
    answer = solved(100.0)
    sheet = sheet_of(answer)
    assert [panel.title for panel in sheet.panels] == [panel.title for panel in sheet_of(answer.contact).panels]
    assert sheet.title.startswith("pressing work 87.76 µJ")  # 2/5 F d of a ball


def test_a_history_is_drawn_over_time():
    @value
    class Course:
        problem: Any
        depth: Any
        time: Any

    time = np.array([0.0, 1.0, 3.0])
    [panel] = sheet_of(Course(None, np.array([1e-6, 2e-6, 5e-6]), time)).panels
    assert panel.title == "depth over time"
    np.testing.assert_array_equal(panel.marks[0].x, time)


def test_a_single_number_without_a_contact_has_no_picture():
    lone = PressingSolution(Pressing(BED, wk.Force(1.0)), 1e-6, 1e6, None)
    with pytest.raises(InvalidInput, match="one number of each quantity and no contact"):
        sheet_of(lone)


def test_a_class_with_a_picture_of_its_own_keeps_it():
    assert sheet_of.dispatch(wk.IndentationSolution) is not sheet_of.dispatch(PressingSolution)
    assert sheet_of.dispatch(wk.TangentialSolution) is not sheet_of.dispatch(PressingSolution)
