"""Pictures of bodies that strike metal."""

import io

import numpy as np
import pytest

import winkler as wk
from winkler.plot import draw

STEEL = wk.Elastic(210e9, 0.3, 1e9)
BALL = wk.Foundation(wk.Paraboloid(5e-3), wk.HalfSpace(STEEL))
CONE = wk.Foundation(wk.Cone(1.22), wk.HalfSpace(STEEL))


def panels_of(figure):
    return {axes.get_title(loc="left"): axes for axes in figure.axes if axes.get_title(loc="left")}


def test_many_velocities_show_restitution_dent_and_time_over_them():
    velocity = np.array([2.0, 5e-3, 0.02, 0.1, 0.5])
    solved = wk.PlasticImpact(BALL, 4.1e-3, velocity).solve()
    panels = panels_of(draw(solved))
    assert list(panels) == ["restitution", "dent", "time of contact"]
    curve = panels["restitution"].lines[0]
    order = np.argsort(velocity)
    scale = curve.get_xdata()[0] / velocity[order][0]
    np.testing.assert_allclose(curve.get_xdata(), scale * velocity[order])
    np.testing.assert_allclose(curve.get_ydata(), solved.restitution[order])
    assert any(np.allclose(line.get_xdata(), scale * solved.yield_velocity) for line in panels["restitution"].lines[1:])
    depth, radius = (line.get_ydata() for line in panels["dent"].lines[:2])
    assert np.isfinite(depth).tolist() == np.isfinite(radius).tolist() == [False, False, True, True, True]


def test_one_velocity_shows_the_blow_and_the_dent():
    solved = wk.PlasticImpact(BALL, 4.1e-3, 0.5).solve()
    figure = draw(solved)
    assert list(panels_of(figure)) == ["force over depth", "contact radius over depth", "the dent"]
    assert f"{solved.restitution:.4g}" in figure.get_suptitle()
    figure.set_layout_engine("none")
    figure.savefig(io.BytesIO(), format="png", dpi=30)


@pytest.mark.parametrize(("bed", "velocity"), [(BALL, [1e-3, 2e-3]), (CONE, [0.1, 0.2])], ids=["elastic", "cone"])
def test_blows_that_all_yield_or_none_are_drawn(bed, velocity):
    figure = draw(wk.PlasticImpact(bed, 4.1e-3, np.array(velocity)).solve())
    assert len(panels_of(figure)) == 3
    figure.set_layout_engine("none")
    figure.savefig(io.BytesIO(), format="png", dpi=30)
