"""Figures of media that change with the depth, and of measured beds: what they say is what the values say."""

from __future__ import annotations

import math

import numpy as np
import pytest

import winkler as wk
from winkler.plot import draw
from winkler.plot.extent import is_singular
from winkler.plot.marks import Text
from winkler.plot.medium import interfaces, is_varied, makeup_panel, typical_width
from winkler.plot.method import PICTURES, method_sheet, pictures_of
from winkler.plot.normal.curves import line_load
from winkler.plot.render import render
from winkler.values.errors import InvalidInput, OutsideValidity

STEEL = wk.Elastic(210e9, 0.3)
CARBON, CHROMIUM = wk.Elastic(180e9, 0.22), wk.Elastic(279e9, 0.21)
STACK = wk.CoatedHalfSpace([wk.Layer(CARBON, 2e-6), wk.Layer(CHROMIUM, 0.5e-6)], on=STEEL)
FILM = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(1e6, 0.5), 1e-3)], on=wk.Rigid())
SOIL = wk.GradedHalfSpace(wk.PowerLawGraded(220e9, 1e-3, 0.3, 0.25))
SKIN = wk.GradedHalfSpace(wk.Rigid(), wk.PowerLawGraded(220e9, 1e-3, -0.3, 0.25))
CASE = wk.DepthGradedHalfSpace(wk.TabulatedGrading([0.0, 1e-3], [2e9, 1e9], [0.3, 0.3]), tolerance=1e-2)
RADII = np.linspace(1e-5, 1e-4, 12)
MEASURED = wk.MeasuredBed(RADII, 2e11 * RADII, RADII**2 / 1e-2)
MEDIA = {"stack": STACK, "film": FILM, "soil": SOIL, "skin": SKIN, "case": CASE}


@pytest.fixture(scope="module")
def pressed():
    """A ball on the stack, wide enough to feel both interfaces."""
    return wk.Indentation(wk.Foundation(wk.Paraboloid(50e-6), STACK), wk.Radius(3e-6)).solve()


def texts(figure):
    return [text.get_text() for axes in figure.axes for text in axes.texts]


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize("name", MEDIA)
def test_a_medium_has_a_figure(name, tmp_path):
    figure = draw(MEDIA[name])
    makeup, springs = figure.axes
    assert makeup.yaxis_inverted()
    assert makeup.get_xlabel().startswith("Young's modulus")
    assert makeup.get_ylabel().startswith("depth below the surface")
    assert "normal stiffness" in springs.get_ylabel()
    figure.set_layout_engine("none")  # which takes two thirds of a drawing
    figure.savefig(tmp_path / "medium.svg")


def test_layers_are_labelled_and_drawn_at_their_depths():
    figure = draw(STACK)
    text = texts(figure)
    assert any("2 µm" in text and "180 GPa" in text and "0.22" in text for text in text)
    assert any("500 nm" in text and "279 GPa" in text for text in text)
    assert any(text.startswith("on ") and "210 GPa" in text for text in text)
    assert interfaces(STACK) == pytest.approx((2e-6, 2.5e-6), rel=1e-15)
    assert interfaces(SOIL) == interfaces(wk.HalfSpace(STEEL)) == ()
    assert any("on a rigid base" in text for text in texts(draw(FILM)))


def test_labels_of_thin_layers_do_not_cover_each_other():
    """Layers of 2 and 0.5 um in pictures eight times as deep (20 um, of 100 asked for), and 3.25 um deep."""
    for medium, end in ((STACK, 1e-4), (STACK, 3e-6)):
        places = [mark.y for mark in makeup_panel(medium, end).marks if isinstance(mark, Text)]
        assert len(places) == 3
        least = 0.075 * min(max(end, 1.3 * 2.5e-6), 8.0 * 2.5e-6)
        assert np.all(np.diff(places) >= least * (1.0 - 1e-9))
        assert 0.0 < places[0] < places[-1] < max(end, 1.3 * 2.5e-6)


@pytest.mark.slow
def test_the_stress_map_has_a_line_at_every_interface_and_a_step_across_it(pressed):
    figure = render(method_sheet("stress", pressed))
    axes = figure.axes[0]
    levels = sorted(float(line.get_ydata()[0]) for line in axes.lines if line.get_linestyle() == "--")
    assert levels == pytest.approx([2.0, 2.5])
    note = next(text for text in texts(figure) if text.startswith("greatest"))
    z = np.unique(np.concatenate([np.linspace(0.01, 6.0, 300), [2.0, 2.0 + 1e-8, 2.5, 2.5 + 1e-8]])) * 1e-6
    most = np.max(wk.restore(pressed, np.linspace(0.0, 4e-6, 41)[:, None], z[None, :]).von_mises)
    assert float(note.split()[1]) == pytest.approx(most / 1e9, rel=2e-3)


@pytest.mark.slow
def test_springs_of_a_varying_medium_are_not_stated_to_be_equal():
    title = draw(wk.Foundation(wk.Paraboloid(50e-6), STACK)).axes[1].get_title(loc="left")
    assert "(middle) to" in title
    assert any("thicker springs are stiffer" in text for text in texts(draw(wk.Foundation(wk.Cone(1.2), SOIL))))
    even = draw(wk.Foundation(wk.Paraboloid(50e-6), wk.HalfSpace(STEEL)))
    assert not any("thicker" in text for text in texts(even))
    assert is_varied(np.array([np.inf, 1.0, 1.0]))
    assert not is_varied(np.ones(3))


@pytest.mark.parametrize(("exponent", "medium"), [(0.3, SOIL), (-0.3, SKIN)])
def test_the_load_of_graded_springs_is_drawn_finite_and_its_area_is_the_force(exponent, medium):
    contact = wk.Indentation(wk.Foundation(wk.Paraboloid(1e-2), medium), wk.Force(100.0)).solve()
    curve = line_load(contact, 2.0 * contact.radius)
    x, q = curve.along.content, curve.of.content
    assert np.isfinite(q).all()
    area = np.sum(0.5 * (q[1:] + q[:-1]) * np.diff(x))
    assert area == pytest.approx(100.0, rel=5e-3), exponent
    assert len(draw(contact).axes) == 4


def test_whether_a_pressure_is_infinite_is_the_mediums_affair():
    """A kink or a pointed apex is too much for a homogeneous surface, not for one that is soft at the top."""
    for shape in (wk.Cone(1.2), wk.CappedParaboloid(1e-2, 2e-2, 1e-4)):
        on = {
            name: wk.Indentation(wk.Foundation(shape, medium), wk.Radius(2e-4)).solve().pressed
            for name, medium in (("steel", wk.HalfSpace(STEEL)), ("soil", SOIL))
        }
        assert is_singular(on["steel"])
        assert not is_singular(on["soil"])


def test_pictures_of_the_medium_are_for_media_that_have_something_to_show(pressed):
    even = wk.Indentation(wk.Foundation(wk.Paraboloid(1e-2), wk.HalfSpace(STEEL)), wk.Force(1.0)).solve()
    assert "medium" not in pictures_of(even)
    assert set(PICTURES) - set(pictures_of(pressed)) == {"depths"}  # which takes seconds in layers
    with pytest.raises(InvalidInput, match="the same at every depth"):
        render(method_sheet("medium", even))
    with pytest.raises(InvalidInput, match="the same at every depth"):
        typical_width(wk.HalfSpace(STEEL))


@pytest.mark.few(3)
@pytest.mark.parametrize("name", list(PICTURES))
def test_every_picture_of_a_coated_contact(name, pressed, tmp_path):
    figure = render(method_sheet(name, pressed))
    figure.set_layout_engine("none")  # which takes two thirds of a drawing
    figure.savefig(tmp_path / "one.svg")


def test_a_graded_contact_has_a_stress_map_with_the_place_of_the_greatest():
    contact = wk.Indentation(wk.Foundation(wk.Paraboloid(1e-2), SOIL), wk.Force(10.0)).solve()
    (figure,) = render(method_sheet("stress", contact)).axes[:1]
    found = wk.ContactStress(contact.problem).solve()
    (mark,) = [line for line in figure.lines if line.get_marker() == "+"]
    scale = float(mark.get_ydata()[0]) / found.von_mises_depth
    assert math.log10(scale) == pytest.approx(round(math.log10(scale)), abs=1e-3)


def test_a_measured_bed_shows_what_was_measured_and_its_springs():
    figure = draw(MEASURED)
    assert [axes.get_title(loc="left") for axes in figure.axes] == [
        "measured stiffness",
        "its springs",
        "springs under $g(x)$",
    ]
    given = next(line for line in figure.axes[0].lines if "measured points" in str(line.get_label()))
    assert given.get_xdata() == pytest.approx(RADII * 1e6)
    assert given.get_ydata() == pytest.approx(2e11 * RADII / 1e6)


def test_a_measured_contact_shows_springs_and_curves_and_refuses_fields():
    contact = wk.Indentation(MEASURED, wk.Depth(0.4e-6)).solve()
    titles = [axes.get_title(loc="left") for axes in draw(contact).axes]
    assert titles == [
        "measured stiffness",
        "springs under $g(x) − d$",
        "load of the springs $q(x)$",
        "force over depth",
    ]
    for name in ("medium", "springs", "line_load", "force"):
        render(method_sheet(name, contact))
    for name in ("shape", "pressure", "displacement", "stress"):
        with pytest.raises(
            OutsideValidity, match="needs a round contact|The area of the contact is not known|cannot be restored"
        ):
            render(method_sheet(name, contact))
    many = wk.Indentation(MEASURED, wk.Depth(np.linspace(0.05e-6, 0.4e-6, 8))).solve()
    assert len(draw(many).axes) == 3
    untouched = wk.Indentation(MEASURED, wk.Depth(-1e-9)).solve()
    assert "no contact" in texts(draw(untouched))
