"""Pictures of rolling: what they draw is what the answers say, and every axis has its unit."""

from __future__ import annotations

import io

import numpy as np
import pytest

import winkler as wk
from winkler.plot import draw

STEEL = wk.Elastic(208e9, 0.25)
PAIR = wk.HalfSpace.between(STEEL, STEEL)
WHEEL = wk.Foundation(wk.Paraboloid(0.4), PAIR)
MU, LOAD = wk.Coulomb(0.3), wk.Force(80e3)
CONTACT = wk.ContactEllipse(6e-3, 4e-3)


def rolling(creepage):
    return wk.Rolling(WHEEL, MU, creepage, LOAD).solve()


def simplified(creepage):
    return wk.SimplifiedRolling(CONTACT, PAIR, MU, creepage, LOAD, count=16).solve()


ITEMS = {
    "one creepage": (lambda: rolling(wk.Creepage(2e-3)), 2),
    "two creepages": (lambda: rolling(wk.Creepage(1e-3, -1e-3)), 2),
    "a curve": (lambda: rolling(wk.Creepage(np.linspace(0.0, 6e-3, 7), 1e-3)), 2),
    "a lateral curve": (lambda: rolling(wk.Creepage(lateral=np.linspace(-6e-3, 6e-3, 60))), 2),
    "none": (lambda: rolling(wk.Creepage()), 2),
    "all the same": (lambda: rolling(wk.Creepage([1e-3, 1e-3])), 2),
    "spin": (lambda: simplified(wk.Creepage(spin=0.5)), 4),
    "everything": (lambda: simplified(wk.Creepage(1e-3, 5e-4, -0.5)), 4),
    "spins": (lambda: simplified(wk.Creepage(spin=np.linspace(0.0, 3.0, 5))), 4),
    "start": (lambda: wk.RollingStart(WHEEL, MU, wk.Creepage(1e-3), LOAD, 14e-3, count=50).solve(), 2),
    "short distance": (
        lambda: wk.RollingStart(
            WHEEL, MU, wk.Creepage(1e-3), LOAD, 1e-3, wk.ShearForce(-9e3), points=1, count=50
        ).solve(),
        2,
    ),
    "creeps on": (lambda: wk.OscillatingRolling(WHEEL, MU, 1e-3, 20e3, LOAD, cycles=50, count=50).solve(), 3),
    "comes to rest": (lambda: wk.OscillatingRolling(WHEEL, MU, 1e-3, 5e3, LOAD, cycles=1, count=50).solve(), 3),
    "far": (lambda: wk.OscillatingRolling(WHEEL, MU, 9e-3, 5e3, LOAD, cycles=2, count=50).solve(), 3),
}


@pytest.mark.few(1, slow=3)
@pytest.mark.parametrize("name", ITEMS)
def test_is_drawn_with_labels_and_units(name):
    make, panels = ITEMS[name]
    figure = draw(make())
    figure.set_layout_engine("none")  # which takes two thirds of a drawing
    figure.savefig(io.BytesIO(), format="png", dpi=30)
    assert len(figure.axes) == panels
    for axes in figure.axes:
        if name in ("none", "all the same") and axes is figure.axes[0]:
            assert any("creepage" in text.get_text() for text in axes.texts)
            continue
        assert axes.get_ylabel()
        if axes.get_label() != "<colorbar>":
            assert axes.get_xlabel()


def line(axes, label):
    return next(found for found in axes.lines if found.get_label() == label)


def test_the_creep_curve_is_the_answer():
    answer = rolling(wk.Creepage(np.linspace(0.0, 6e-3, 7)))
    drawn = line(draw(answer).axes[0], "longitudinal")
    np.testing.assert_allclose(drawn.get_ydata(), answer.longitudinal_force / 24e3, rtol=1e-12)


def test_of_one_creepage_the_curve_goes_through_its_point():
    answer = rolling(wk.Creepage(2e-3))
    axes = draw(answer).axes[0]
    x, y = line(axes, "longitudinal").get_data()
    point = next(found for found in axes.lines if found.get_marker() == "o")
    assert float(np.interp(point.get_xdata()[0], x, y)) == pytest.approx(point.get_ydata()[0], abs=1e-3)
    assert point.get_ydata()[0] == pytest.approx(answer.saturation)
    assert y[-1] == pytest.approx(1.0)


def test_the_springs_stay_below_their_bound():
    axes = draw(rolling(wk.Creepage(2e-3))).axes[1]
    load, bound = (line(axes, label).get_ydata() for label in ("$q_x$", r"bound $\mu q_z$"))
    assert np.all(load <= bound * (1.0 + 1e-9) + 1e-12)
    assert np.max(load) > 0.5 * np.max(bound)


def test_the_start_tends_to_the_steady_force():
    answer = ITEMS["start"][0]()
    axes = draw(answer).axes[0]
    force = line(axes, "$F_x$").get_ydata()
    assert force[-1] == pytest.approx(line(axes, "steady").get_ydata()[0], rel=1e-3)
    np.testing.assert_allclose(force, answer.shear_force / 24e3)


def test_rocking_shows_its_place_below_or_above_the_limit():
    for name in ("creeps on", "comes to rest"):
        figure = draw(ITEMS[name][0]())
        assert figure.axes[0].get_title(loc="left") == name
        amplitudes, limit = figure.axes[2].lines[0].get_data()
        np.testing.assert_allclose(limit, 1.0 - 1.5 * amplitudes + 0.5 * amplitudes**3, atol=1e-12)


@pytest.mark.slow
def test_unlike_rollers_without_creepage_are_dragged_backwards():
    """The creep curve has the sign of the force, which is not that of the creepage."""
    bed = wk.LineFoundation(wk.Paraboloid(25e-3), wk.HalfSpace.between(wk.Elastic(70e9, 0.33), STEEL))
    answer = wk.LineRolling(bed, MU, wk.Creepage([0.0, 2e-3]), wk.LineForce(2e4), coupled=True).solve()
    curve, points = draw(answer).axes[0].lines[:2]
    first, last = points.get_ydata()
    assert first == pytest.approx(answer.shear_force_per_length[0] / (0.3 * 2e4), rel=1e-9)
    assert first < -0.2
    assert last > 0.2
    assert np.interp(0.0, *curve.get_data()) == pytest.approx(first, rel=1e-9)
