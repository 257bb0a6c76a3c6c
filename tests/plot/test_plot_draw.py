"""Every item has a figure: labelled, whole, drawn without pyplot, and refused kindly where there is none."""

from __future__ import annotations

import functools
import io
import subprocess
import sys

import numpy as np
import pytest

from winkler.fields.punch_staircase import staircase
from winkler.fields.restoration import restore
from winkler.foundation.foundation import Foundation
from winkler.foundation.plane import PlaneFoundation
from winkler.loading.loads import Depth, Force
from winkler.materials.elastic import Elastic, Rigid, TransverselyIsotropic
from winkler.media.halfspace import HalfSpace
from winkler.media.transverse import TransverselyIsotropicHalfSpace
from winkler.plot import draw, style
from winkler.plot.families import bar_sheet, family_sheet
from winkler.plot.method import method_sheet, pictures_of
from winkler.plot.normal.outline import profile_panel
from winkler.plot.render import render
from winkler.plot.series import series
from winkler.problems.normal.indentation import Indentation
from winkler.problems.normal.yielding import YieldOnset
from winkler.profiles.conical import Cone, TruncatedCone
from winkler.profiles.flat import CappedCylinder, FlatPunch
from winkler.profiles.measured import Measured
from winkler.profiles.power import Paraboloid, PowerLaw
from winkler.profiles.socket import BallInSocket
from winkler.profiles.sphere import Ellipsoid, Sphere
from winkler.profiles.wavy import Wavy
from winkler.values.errors import InvalidInput

STRONG = Elastic(210e9, 0.3, 700e6)
STEEL = HalfSpace(STRONG, Elastic(210e9, 0.3))
BALL = Foundation(Sphere(10e-3), STEEL)
CONTACT = Indentation(BALL, Force(20.0)).solve()
A = CONTACT.radius


def solved(profile, load, medium=STEEL):
    return Indentation(Foundation(profile, medium), load).solve()


def grid(sign=1.0):
    return restore(CONTACT, np.linspace(0.0, 2 * A, 21)[:, None], sign * np.linspace(0.01, 2.0, 25)[None, :] * A)


def measured():
    r = np.linspace(0.0, 1e-6, 60)
    return Measured(r, r**2 / 2e-6)


ITEMS = {
    "profile": lambda: Sphere(10e-3),
    "profile with a wall": lambda: FlatPunch(1e-3),
    "profile without a length": lambda: Cone(1.2),
    "sum": lambda: Paraboloid(10e-3) + Wavy(0.1e-6, 1e-3),
    "measured profile": measured,
    "foundation": lambda: BALL,
    "foundation with a wall": lambda: Foundation(FlatPunch(1e-3), STEEL),
    "plane foundation": lambda: PlaneFoundation(PowerLaw(100.0, 2.0), STEEL),
    "one load": lambda: CONTACT,
    "flat punch": lambda: solved(FlatPunch(1e-3), Force(1e3)),
    "pinned": lambda: solved(CappedCylinder(1e-4, Sphere(10e-3)), Depth(5e-6)),
    "kinked": lambda: solved(TruncatedCone(1.4, 1e-4), Depth(30e-6)),
    "pointed": lambda: solved(Cone(1.4), Depth(3e-6)),
    "no contact": lambda: solved(Sphere(10e-3), Depth(-1e-6)),
    "first touch": lambda: solved(Sphere(10e-3), Depth(0.0)),
    "many loads": lambda: solved(Sphere(10e-3), Depth(np.linspace(0.0, 5e-6, 50))),
    "onset of yield": lambda: YieldOnset(Foundation(Paraboloid(1e-2), STEEL)).solve(),
    "onset in the second body": lambda: YieldOnset(Foundation(Paraboloid(1e-2), HalfSpace(Rigid(), STRONG))).solve(),
    "surface fields": lambda: restore(CONTACT, np.linspace(0.0, 3 * A, 50)),
    "surface fields with poles": lambda: restore(solved(FlatPunch(1e-3), Force(1e3)), np.linspace(0.0, 1.5e-3, 31)),
    "fields on a grid": grid,
    "fields on a turned grid": lambda: restore(
        CONTACT, np.linspace(0.1, 1.0, 9)[None, :] * A, np.linspace(0.1, 1.0, 8)[:, None] * A
    ),
    "fields above": lambda: grid(-1.0),
    "fields along the axis": lambda: restore(CONTACT, np.zeros(30), np.linspace(0.0, 3 * A, 30)),
    "fields at one depth": lambda: restore(CONTACT, np.linspace(0.0, 3 * A, 30), np.full(30, 0.5 * A)),
    "staircase": lambda: staircase(CONTACT, 8),
    "staircase of one step": lambda: staircase(solved(FlatPunch(1e-3), Force(1e3)), 8),
    "staircase of a measured profile": lambda: staircase(solved(measured(), Depth(1e-7)), 12),
}


def texts(figure):
    """Return every text of a figure that is drawn: visible, not empty, and of ticks only those within the limits."""
    from matplotlib.axis import Axis
    from matplotlib.text import Text

    hidden = set()
    for axis in figure.findobj(Axis):
        shown = axis._update_ticks() if axis.axes.axison else []
        every = [*axis.majorTicks, *axis.minorTicks]
        hidden |= {id(text) for tick in every if tick not in shown for text in (tick.label1, tick.label2)}
    found = [text for text in figure.findobj(Text) if text.get_visible() and text.get_text().strip()]
    return [text for text in found if id(text) not in hidden]


@functools.cache
def laid_out(name):
    """Return the figure of an item, drawn once."""
    figure = draw(ITEMS[name]())
    figure.canvas.draw()
    return figure


@pytest.mark.few(4, slow=2)
@pytest.mark.parametrize("name", ITEMS)
def test_every_item_has_a_whole_labelled_figure(name):
    figure = laid_out(name)
    ink = np.asarray(figure.canvas.buffer_rgba())[..., :3].min(axis=-1) < 255
    assert np.count_nonzero(ink) > 10_000
    renderer = figure.canvas.get_renderer()
    frame = figure.bbox
    for axes in figure.axes:
        if axes.axison and axes.get_label() != "<colorbar>" and not axes.get_title().startswith("the contact"):
            assert axes.get_xlabel() or axes.get_ylabel(), f"{name}: axes without labels"
    for text in texts(figure):
        box = text.get_window_extent(renderer)
        if box.width > 0.0:
            cut = f"{name}: {text.get_text()!r} is cut off"
            assert min(box.x0 - frame.x0, box.y0 - frame.y0) > -1.0, cut
            assert max(box.x1 - frame.x1, box.y1 - frame.y1) < 1.0, cut


@pytest.mark.few(1, slow=2)
@pytest.mark.parametrize("name", ["one load", "foundation", "many loads", "onset of yield", "staircase"])
def test_titles_and_labels_do_not_overlap(name):
    figure = laid_out(name)
    renderer = figure.canvas.get_renderer()
    boxes = []
    for axes in figure.axes:
        labels = [axes.title, axes._left_title, axes.xaxis.label, axes.yaxis.label]
        boxes += [label.get_window_extent(renderer) for label in labels if label.get_text() and label.get_visible()]
    if figure._suptitle is not None:
        boxes.append(figure._suptitle.get_window_extent(renderer))
    assert len(boxes) > 3
    for place, one in enumerate(boxes):
        assert not any(one.overlaps(other) for other in boxes[place + 1 :])


def test_axes_of_a_contact_carry_symbols_and_fitting_units():
    figure = draw(CONTACT)
    labels = {axes.get_xlabel() for axes in figure.axes} | {axes.get_ylabel() for axes in figure.axes}
    assert {
        "place along the springs $x$ [µm]",
        "load of the springs $q_z$ [kN/m]",
        "distance from the axis $r$ [µm]",
        "pressure $p$ [MPa]",
    } <= labels
    assert figure._suptitle.get_text() == "$F_N$ = 20 N   $d$ = 1.191 µm   $a$ = 109.1 µm"


def test_the_drawn_pressure_is_the_restored_one():
    line = draw(CONTACT).axes[3].lines[0]
    x, y = line.get_data()
    assert np.max(y) == pytest.approx(CONTACT.mean_pressure * 1.5 / 1e6, rel=1e-4)
    np.testing.assert_allclose(y, restore(CONTACT, np.abs(x) * 1e-6).pressure / 1e6, rtol=1e-9)


@pytest.mark.slow
def test_the_extent_can_be_chosen():
    figure = draw(CONTACT, extent=5e-4)
    assert figure.axes[3].get_xlim() == pytest.approx((-500.0, 500.0), rel=1e-3)
    assert draw(Sphere(10e-3), extent=1e-4).axes[1].get_xlim() == pytest.approx((0.0, 100.0))
    shown = draw(restore(CONTACT, np.linspace(0.0, 3 * A, 31)), extent=A)
    assert shown.axes[0].lines[0].get_xdata().size == 11
    cut = draw(grid(), extent=A).axes[0]
    assert cut.get_xlim() == pytest.approx((-A * 1e6, A * 1e6))


@pytest.mark.parametrize("extent", [0.0, -1e-3, np.nan, np.inf, "1 mm"])
def test_an_extent_that_is_none(extent):
    with pytest.raises(InvalidInput, match="extent is .* give a positive distance"):
        draw(CONTACT, extent=extent)


def test_many_loads_have_no_extent():
    with pytest.raises(InvalidInput, match="no extent"):
        draw(ITEMS["many loads"](), extent=1e-3)


@pytest.mark.parametrize("item", [3.0, "sphere", Elastic(1e9, 0.3), STEEL, None])
def test_what_cannot_be_drawn(item):
    with pytest.raises(InvalidInput, match="there is no picture of a .*; give a profile"):
        draw(item)


def test_a_profile_need_not_be_a_shape_of_winkler():
    class Mine:
        """Fulfils the contract without inheriting."""

        reach, rim, size, kinks = 1e-3, np.inf, np.inf, ()

        def height(self, r):
            return 50.0 * r**2

        def gap(self, x):
            return 100.0 * x**2

    assert len(draw(Mine()).axes) == 2


def test_an_empty_staircase():
    with pytest.raises(InvalidInput, match="no punches to show"):
        draw(staircase(solved(Sphere(1.0), Force(0.0)), 3))


def test_fields_outside_the_extent():
    with pytest.raises(InvalidInput, match="nothing within the extent"):
        draw(restore(CONTACT, np.array([1e-3, 2e-3])), extent=1e-6)


def test_stresses_inside_a_crystal_are_drawn():
    wood = TransverselyIsotropicHalfSpace(TransverselyIsotropic(162e9, 92e9, 69e9, 181e9, 47e9))
    solution = solved(Sphere(10e-3), Depth(1e-6), wood)
    assert "greatest" in " ".join(text.get_text() for text in render(method_sheet("stress", solution)).axes[0].texts)


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize("name", pictures_of(CONTACT))
def test_every_picture_of_the_method(name, tmp_path):
    figure = render(method_sheet(name, CONTACT))
    figure.set_layout_engine("none")  # which takes two thirds of a drawing
    figure.savefig(tmp_path / "one.svg")
    assert (tmp_path / "one.svg").read_text(encoding="utf-8").startswith("<?xml")


@pytest.mark.parametrize("name", ["stress", "force"])
def test_without_a_contact_there_is_nothing_to_show(name):
    with pytest.raises(InvalidInput, match="do not touch"):
        render(method_sheet(name, solved(Sphere(10e-3), Depth(-1e-6))))


@pytest.mark.slow
def test_the_mark_on_the_stress_map_is_the_known_greatest_stress():
    figure = render(method_sheet("stress", solved(Paraboloid(10e-3), Force(20.0))))
    note = next(text.get_text() for text in texts(figure) if text.get_text().startswith("greatest"))
    solution = solved(Paraboloid(10e-3), Force(20.0))
    peak = 1.5 * solution.mean_pressure * 2 * 0.310020502  # theory sheet, 1.2
    assert f"{peak / 1e6:.4g} MPa" in note
    assert f"{0.4808644853 * solution.radius * 1e6:.3g} µm" in note


def test_a_map_is_symmetric_and_deep_is_down():
    axes = draw(grid()).axes[0]
    low, high = axes.get_ylim()
    assert low > high == 0.0
    assert axes.get_xlim()[0] == -axes.get_xlim()[1]
    low, high = draw(grid(-1.0)).axes[0].get_ylim()
    assert low == 0.0 > high


def test_families_distinguish_many_curves():
    x = series("force", np.geomspace(1.0, 1e3, 9))
    for count in (1, 3, 12):
        curves = [series("depth", (1 + n) * 1e-6 * x.content ** (2 / 3)) for n in range(count)]
        figure = render(family_sheet([x] * count, curves, [f"R = {n} mm" for n in range(count)]))
        axes = figure.axes[0]
        looks = {(line.get_color(), str(line.get_linestyle())) for line in axes.lines}
        assert len(looks) == count
        assert axes.get_xscale() == axes.get_yscale() == "log"
        assert bool(figure.legends) == (count > 1)
        assert axes.get_xlabel() == "force $F_N$ [N]"


def test_bars_leave_out_what_has_no_answer():
    figure = render(bar_sheet(["cone", "ball", "ring"], series("depth", np.array([1e-6, 2e-6, np.nan]))))
    assert [bar.get_width() for bar in figure.axes[0].patches] == pytest.approx([1.0, 2.0, 0.0])


@pytest.mark.slow
def test_figures_come_without_pyplot_and_leave_the_readers_settings(tmp_path):
    code = (
        "import sys, matplotlib\n"
        "before = dict(matplotlib.rcParams)\n"
        "from winkler.plot import draw\n"
        "from winkler.profiles.sphere import Sphere\n"
        f"draw(Sphere(1e-2)).savefig({str(tmp_path / 'ball.pdf')!r})\n"
        "assert 'matplotlib.pyplot' not in sys.modules\n"
        "assert dict(matplotlib.rcParams) == before\n"
    )
    subprocess.run([sys.executable, "-c", code], check=True, timeout=120)
    assert (tmp_path / "ball.pdf").read_bytes().startswith(b"%PDF")


def test_the_package_is_light_until_something_is_drawn():
    code = "import sys, winkler.plot; assert 'matplotlib' not in sys.modules"
    subprocess.run([sys.executable, "-c", code], check=True, timeout=60)


@pytest.mark.slow
def test_a_notebook_shows_the_picture():
    figure = draw(Sphere(1e-2))
    assert figure._repr_html_().startswith('<img alt="figure"')
    assert "base64" in figure._repr_html_()
    assert repr(figure).startswith("<Picture of ")


@pytest.mark.few(0, slow=1)
@pytest.mark.parametrize("ending", ["svg", "pdf", "PDF", "png"])
def test_the_same_picture_on_another_day_is_the_same_file(ending, tmp_path, monkeypatch):
    for day in ("1", "86401"):
        monkeypatch.setenv("SOURCE_DATE_EPOCH", day)  # which matplotlib states as the date, where it states one
        draw(CONTACT).savefig(tmp_path / f"{day}.{ending}")
        stream = io.BytesIO()
        draw(CONTACT).savefig(stream, format=ending.lower())
        assert stream.getvalue() == (tmp_path / f"{day}.{ending}").read_bytes()
    assert (tmp_path / f"1.{ending}").read_bytes() == (tmp_path / f"86401.{ending}").read_bytes()


@pytest.mark.slow
def test_what_is_stated_with_a_picture_stays():
    stream = io.BytesIO()
    draw(Sphere(1e-2)).savefig(stream, format="svg", metadata={"Title": "A ball"})
    assert b"<dc:title>A ball</dc:title>" in stream.getvalue()
    assert b"<dc:date>" not in stream.getvalue()


VISION = {
    "deuteranopia": [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]],
    "protanopia": [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
}
"""G. M. Machado, M. M. Oliveira, L. A. F. Fernandes, IEEE Trans. Vis. Comput. Graph. 15 (2009) 1291, severity 1."""


@pytest.mark.parametrize("vision", VISION)
def test_colour_blind_readers_distinguish_the_first_curves(vision):
    from matplotlib.colors import to_rgb

    colours = np.array([to_rgb(colour) for colour in style.CYCLE[:5]])
    linear = np.where(colours <= 0.04045, colours / 12.92, ((colours + 0.055) / 1.055) ** 2.4)
    perceived = np.clip(linear @ np.array(VISION[vision]).T, 0.0, 1.0)
    # CIE L*a*b* of linear sRGB, white D65
    xyz = perceived @ np.array([[0.4124, 0.2126, 0.0193], [0.3576, 0.7152, 0.1192], [0.1805, 0.0722, 0.9505]])
    f = np.cbrt(np.maximum(xyz / np.array([0.9505, 1.0, 1.089]), 1e-6))
    lab = np.stack([116 * f[:, 1] - 16, 500 * (f[:, 0] - f[:, 1]), 200 * (f[:, 1] - f[:, 2])], axis=-1)
    apart = [np.linalg.norm(lab[i] - lab[j]) for i in range(5) for j in range(i)]
    assert min(apart) > 12.0  # a difference of 2.3 is just noticeable


@pytest.mark.parametrize("body", [Sphere(1e-5), Ellipsoid(1e-5, 2e-5), BallInSocket(1e-5, 2e-5)])
def test_a_ball_pressed_to_its_equator_is_drawn_without_a_warning(body):
    """At the equator the plane profile is infinite: the division was reported on the terminal of a user."""
    pressed = solved(body, Depth(2.5e-5))
    for sheet in (method_sheet("springs", pressed), profile_panel(body, 2.0 * body.reach)):
        assert sheet
    assert pressed.radius > 0.8 * body.reach
