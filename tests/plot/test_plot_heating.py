"""Sheets of frictional heating: what they show, and what they refuse."""

import numpy as np
import pytest

import winkler as wk
from winkler.plot import draw

STEEL, IRON = wk.Elastic(210e9, 0.3), wk.ThermalConductor(45.0, 12e-6)
BED = wk.Foundation(wk.Paraboloid(10e-3), wk.HalfSpace(STEEL, STEEL))
CONTACT = wk.Indentation(BED, wk.Force(20.0))
PAIR = wk.HeatConductors(IRON, IRON)


def rubbing(**others):
    given = {"contact": CONTACT, "law": wk.Coulomb(0.3), "conductors": PAIR, "first_speed": 1.0}
    return wk.FrictionHeating(**(given | others)).solve()


def titles(figure):
    return [axes.get_title(loc="left") for axes in figure.axes if axes.get_title(loc="left")]


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize("speeds", [(1.0, 0.0), (0.0, -1.0)])
def test_one_contact(speeds):
    figure = draw(rubbing(first_speed=speeds[0], second_speed=speeds[1]))
    moving = "first" if speeds[0] else "second"
    assert titles(figure) == [
        f"surface of the {moving} body",
        "along its motion, contact shaded",
        "flash temperature over the speed",
    ]
    curves = {line.get_label(): line.get_ydata() for line in figure.axes[2].get_lines()}
    assert np.all(np.diff(curves["flash temperature"]) < 0.0)
    assert np.all(curves["flash temperature"] < 1.0)
    np.testing.assert_allclose(curves["at rest"], 1.0)
    assert "K" in figure.axes[1].get_ylabel()


def test_many_contacts():
    figure = draw(rubbing(first_speed=np.geomspace(0.1, 10.0, 7)))
    assert figure.axes[0].get_xlabel().startswith("Peclet number")
    over_force = draw(
        rubbing(contact=wk.Indentation(BED, wk.Force([0.0, 1.0, 2.0])), first_speed=0.0, second_speed=0.0 + 1e-9)
    )
    assert len(over_force.axes[0].get_lines()[0].get_xdata()) == 2


def test_a_contact_that_begins_and_one_that_frets():
    begins = wk.TransientHeating(CONTACT, wk.Coulomb(0.3), PAIR, speed=0.01, time=[1e-3]).solve()
    assert titles(draw(begins)) == ["temperature of the contact", "surface of the first body"]
    path = wk.Path.oscillation(force=100.0, amplitude=1e-6, cycles=2, count=20)
    frets = wk.FrettingHeat(wk.Tangential(BED, wk.Coulomb(0.5), path), 100.0, PAIR).solve()
    assert titles(draw(frets)) == ["heat flux over the radius", "temperature of the surfaces"]


def test_what_is_refused():
    with pytest.raises(wk.OutsideValidity, match="no heat is released"):
        draw(rubbing(first_speed=0.0))
    with pytest.raises(wk.InvalidInput, match="no extent"):
        draw(rubbing(), extent=1e-3)
    still = wk.TransientHeating(CONTACT, wk.Coulomb(0.3), PAIR, speed=0.0, time=[1e-3]).solve()
    with pytest.raises(wk.OutsideValidity, match="no heat is released"):
        draw(still)
