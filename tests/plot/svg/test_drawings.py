"""Drawings in SVG show what panels declare: numbers at their places, ticks, limits, colours, letters of known width."""

from __future__ import annotations

import base64
import re
import struct
import sys
import zlib
from xml.etree import ElementTree

import numpy as np
import pytest
from legibility import faults
from matplotlib import font_manager
from matplotlib.figure import Figure
from matplotlib.ft2font import FT2Font

from winkler.plot import style
from winkler.plot.marks import Area, Bars, Dots, Facets, Line, Map, Rule, Text, Vectors
from winkler.plot.panel import Panel, PanelAxis, Sheet
from winkler.plot.render import render
from winkler.plot.series import Scale
from winkler.plot.svg.letters import OF, runs_of, width_of
from winkler.plot.svg.pixels import Colours, stops_of
from winkler.plot.svg.scales import Side, round_steps, ticks_of
from winkler.plot.svg.sheet import drawing_of
from winkler.values.errors import InvalidInput
from winkler.values.vocabulary import GLOSSARY

SVG = "{http://www.w3.org/2000/svg}"
X = np.linspace(0.0, 1.0, 50)
AXES = {"across": PanelAxis("place"), "upright": PanelAxis("height")}


def drawn(*marks, **of):
    """Return the drawing of one panel, and its elements."""
    drawing = drawing_of(Sheet((Panel(marks, **(AXES | of)),)))
    return drawing, ElementTree.fromstring(drawing.text)


def with_class(root, name):
    return [one for one in root.iter() if name in one.get("class", "").split()]


def corners(path):
    return np.array([[float(part) for part in pair.split()] for pair in re.findall(r"[ML]([^A-Za-z]+)", path)])


# ----------------------------------------------------------------------------------------------------------- letters


def test_letters_are_as_wide_as_in_the_font():
    font = FT2Font(font_manager.findfont(font_manager.FontProperties(family="DejaVu Sans")))
    font.set_size(1000, 72)
    known = [letter for letter in OF if font.get_char_index(ord(letter))]
    apart = [
        OF[letter] - font.load_char(ord(letter)).linearHoriAdvance / 65536.0 / 1000.0
        for letter in known
        if letter not in "\u0302\u0303\u0304\u0307\u2009"  # they stand above a letter, or are left to the browser
    ]
    assert len(known) > 180
    assert np.max(np.abs(apart)) < 2e-3


def symbols():
    """Return all symbols of the glossary and of the classes."""
    from winkler.plot.registered import everything

    everything()
    loaded = [module for name, module in sys.modules.items() if name.startswith("winkler.")]
    classes = {one for module in loaded for one in vars(module).values() if isinstance(one, type)}
    own = [entry for cls in classes for entry in vars(cls).get("__words__", {}).values()]
    return sorted({entry.symbol for entry in [*GLOSSARY.values(), *own] if entry.symbol})


def test_every_symbol_can_be_written():
    found = symbols()
    assert len(found) > 150
    for symbol in found:
        runs = runs_of(f"${symbol}$")
        assert not set("".join(run.text for run in runs)) - set(OF), symbol
        assert "\\" not in "".join(run.text for run in runs)


def test_indices_are_small_and_low_and_powers_high():
    (force, index), (length, power) = runs_of("$F_N$"), runs_of("$r^{2}$")
    assert (force.text, index.text, length.text, power.text) == ("F", "N", "r", "2")
    assert index.rise < force.rise == length.rise < power.rise
    assert index.size == power.size < 1.0
    assert (force.italic, power.italic) == (True, False)


def test_signs_between_terms_have_room_and_others_do_not():
    assert "".join(run.text for run in runs_of(r"$-\mu p = a-b$")) == "−μp = a − b"


def test_what_cannot_be_written_is_refused():
    with pytest.raises(InvalidInput, match="nonsense"):
        runs_of(r"$\nonsense$")


def test_a_wider_text_is_wider():
    assert width_of("mm", 9.0) == pytest.approx(2.0 * 0.974 * 9.0)
    assert width_of("m\nmm", 9.0) == width_of("mm", 9.0)


# -------------------------------------------------------------------------------------------------- places and limits


def read_off(root, which):
    """Return shown numbers at the ticks of an axis, and their places."""
    ticks = [one for one in with_class(root, "tick") if which in one.attrib["class"].split()]
    numbers = [float("".join(one.itertext()).replace("−", "-")) for one in ticks]
    names = {"x": "x", "y": "y"}
    return np.array(numbers), np.array([float(one.attrib[names[which]]) for one in ticks])


@pytest.mark.parametrize("log", [False, True])
def test_a_curve_runs_through_its_numbers(log):
    x = np.array([0.02, 0.03, 0.11, 0.4, 0.97])
    drawing, root = drawn(Line(x, 3.0 * x**2, width=2.0), across=PanelAxis("a", log=log, plain=True))
    numbers, places = read_off(root, "x")
    scale = np.log10 if log else np.asarray
    slope, start = np.polyfit(scale(numbers), places, 1)
    found = corners(with_class(root, "curve")[0].attrib["d"])
    assert len(numbers) > 2
    assert found[:, 0] == pytest.approx(slope * scale(x) + start, abs=0.15)  # ticks are written with one digit
    numbers, places = read_off(root, "y")
    slope, _ = np.polyfit(numbers, places, 1)  # the base line of a number lies below the middle of its letters
    assert np.diff(found[:, 1]) == pytest.approx(slope * np.diff(3.0 * x**2), abs=0.15)
    ((_, plane),) = drawing.panels
    assert found[:, 0] == pytest.approx(plane.x(x), abs=6e-3)


def test_numbers_are_shown_in_the_unit_of_the_axis():
    micro = PanelAxis("depth", Scale(1e-6, "µm"))
    _, root = drawn(Line(2e-6 * X, X), across=micro)
    assert read_off(root, "x")[0].max() == 2.0
    assert "depth [µm]" in ["".join(one.itertext()) for one in with_class(root, "label")]


PANELS = {
    "a curve": Panel((Line(X, np.sin(9.0 * X)),)),
    "a curve with gaps": Panel((Line(X, np.where(X > 0.5, np.nan, X)),)),
    "decades": Panel((Line(X, X**3),), PanelAxis(log=True), PanelAxis(log=True)),
    "declared margins": Panel((Line(X, X),), PanelAxis(margin=0.1), PanelAxis(margin=0.2)),
    "one declared end": Panel((Line(X, X),), PanelAxis(low=-1.0), PanelAxis(high=7.0)),
    "falling": Panel((Line(X, X),), PanelAxis(), PanelAxis(falling=True)),
    "a constant": Panel((Line(X, np.full(50, 3.0)),)),
    "zero": Panel((Line(X, np.zeros(50)),)),
    "an area": Panel((Area(X, X, -2.0),)),
    "rules": Panel((Line(X, X), Rule(2.0), Rule(-1.0, upright=True), Rule(point=(0.0, 0.0), slope=9.0))),
    "dots": Panel((Dots(X, X**2),)),
    "bars": Panel((Bars(np.arange(3.0), np.array([1.0, 2.0, 4.0])),)),
    "headroom": Panel((Line(X, X),), PanelAxis(), PanelAxis(headroom=0.3)),
    "ticks": Panel((Line(X, X),), PanelAxis(), PanelAxis(ticks=np.array([-1.0, 3.0]))),
    "cells": Panel((Map(np.arange(4.0), np.arange(3.0), np.ones((2, 3)), kind="cells", colours="Reds", place=""),)),
    "contours": Panel((Map(X, X, X[:, None] + X, place=""), Line(0.5 * X, X))),
    "arrows": Panel((Vectors(X, X, X, X),)),
    "facets": Panel((Facets(np.array([[[0.0, 0.0], [1.0, 0.0], [1.0, 2.0]]]), np.zeros((1, 3))),)),
}  # fmt: skip


@pytest.mark.parametrize("name", PANELS)
def test_axes_end_where_those_of_matplotlib_do(name):
    sheet = Sheet((PANELS[name],))
    ((_, plane),) = drawing_of(sheet).panels
    axes = render(sheet).axes[0]
    for side, ends in ((plane.across, axes.get_xlim()), (plane.upright, axes.get_ylim())):
        assert side[:2] == pytest.approx(ends, rel=1e-9, abs=1e-9)


@pytest.mark.parametrize("seed", range(5))
def test_ticks_are_round_and_as_many_as_there_is_room_for(seed):
    rng = np.random.default_rng(seed)
    low, wide = rng.normal(), 10.0 ** rng.uniform(-3.0, 4.0)
    for most in (3, 5, 7, 9):
        places = round_steps(low, low + wide, most)
        step = places[1] - places[0] if places.size > 1 else wide
        digit = step / 10.0 ** np.floor(np.log10(step) + 1e-9)
        assert places.size == 1 or np.min(np.abs(digit - np.array([1.0, 2.0, 2.5, 5.0, 10.0]))) < 1e-6
        assert wide / step <= most + 1e-9
        assert places.min() >= low - 1e-9 * wide
        assert places.max() <= low + wide * (1.0 + 1e-9)
        assert places.size == 1 or (low - places[0] + step > 0.0 and places[-1] + step > low + wide - 1e-9 * wide)


@pytest.mark.parametrize("seed", range(5))
def test_an_axis_however_short_has_two_numbers(seed):
    """The residuals of compared models stood beside a zero alone."""
    rng = np.random.default_rng(seed)
    least, wide = rng.normal(), 10.0 ** rng.uniform(-3.0, 4.0)
    for low, high, length in ((least, least + wide, 12.0), (-wide, wide, 20.0), (-0.9 * wide, 0.3 * wide, 30.0)):
        for axis in (PanelAxis("residual"), PanelAxis("residual", parts=3)):
            side = Side(low, high + 2.0 * axis.parts, False, 0.0, length)
            assert ticks_of(axis, side, 9.0, across=False).places.size >= 2


def test_equal_scales_are_equal():
    ring = np.linspace(0.0, 2.0 * np.pi, 181)
    _, root = drawn(Line(3.0 * np.cos(ring), 3.0 * np.sin(ring)), equal=True)
    found = corners(with_class(root, "curve")[0].attrib["d"])
    assert np.ptp(found[:, 0]) == pytest.approx(np.ptp(found[:, 1]), abs=0.03)


# -------------------------------------------------------------------------------------------------- maps and colours


def pixels_of(root):
    """Return the pixels of an image ``(rows, columns, 4)``, read from the PNG file that is in it."""
    (image,) = root.iter(f"{SVG}image")
    data = base64.b64decode(image.attrib["href"].split(",")[1])
    columns, rows = struct.unpack(">II", data[16:24])
    start = data.index(b"IDAT")
    length = struct.unpack(">I", data[start - 4 : start])[0]
    lines = np.frombuffer(zlib.decompress(data[start + 4 : start + 4 + length]), dtype=np.uint8)
    return lines.reshape(rows, 1 + 4 * columns)[:, 1:].reshape(rows, columns, 4)


def test_the_pixels_of_a_map_lie_where_its_numbers_do():
    z = np.array([[0.0, 1.0], [2.0, 3.0], [4.0, np.nan]])  # three along x, two along y
    _, root = drawn(Map(np.array([0.0, 3.0]), np.array([0.0, 2.0]), z, kind="pixels", place=""))
    found = pixels_of(root)
    of = Colours(255.0 * np.array([style.channels(("viridis_r", p)) for p in np.linspace(0.0, 1.0, 17)]), 0.0, 4.0)
    assert found.shape == (2, 3, 4)
    assert found[1, 0, :3] == pytest.approx(of.of(np.array(0.0)), abs=1.0)  # left and below
    assert found[0, 1, :3] == pytest.approx(of.of(np.array(3.0)), abs=1.0)
    assert found[1, 2, :3] == pytest.approx(of.of(np.array(4.0)), abs=1.0)
    assert found[..., 3].tolist() == [[255, 255, 0], [255, 255, 255]]


def test_cells_of_unequal_width_are_resampled_to_their_places():
    z = np.array([[1.0, 2.0]])
    _, root = drawn(Map(np.array([0.0, 1.0, 4.0]), np.array([0.0, 1.0]), z, kind="cells", place=""))
    row = pixels_of(root)[0]
    assert np.mean(row[:, 0] == row[0, 0]) == pytest.approx(0.25, abs=0.01)


@pytest.mark.parametrize("name", [*sorted(style.MAPS), "viridis"])
def test_colours_are_those_of_matplotlib(name):
    from matplotlib import colormaps

    along = np.linspace(0.0, 1.0, 101)
    apart = np.abs(Colours(stops_of(name) / 255.0, 0.0, 1.0).of(along) - colormaps[name](along)[:, :3])
    assert np.mean(apart) < 0.01
    assert np.max(apart) < 0.045  # straight lines between 17 colours; cividis has a kink between two


def test_a_band_of_contours_covers_what_lies_between_its_levels():
    plane = Map(X, X, np.broadcast_to(X, (50, 50)), levels=np.array([0.0, 0.3, 1.0]), place="", kind="contours")
    drawing, root = drawn(plane)
    bands = [path for path in root.iter(f"{SVG}path") if path.get("fill-rule")]
    areas = []
    for band in bands:
        x, y = corners(band.attrib["d"]).T
        areas.append(abs(np.sum(x * np.roll(y, -1) - y * np.roll(x, -1))) / 2.0)
    box = drawing.panels[0][1].box
    whole = (box.right - box.left) * (box.bottom - box.top)
    assert np.array(areas) / whole == pytest.approx([0.3, 0.7], abs=2e-3)


def test_noise_of_many_points_is_thinned_and_keeps_its_ends():
    y = np.random.default_rng(0).normal(size=60_000)
    drawing, root = drawn(Line(np.linspace(0.0, 1.0, y.size), y))
    found = corners(with_class(root, "curve")[0].attrib["d"])
    ((_, plane),) = drawing.panels
    assert len(found) < 4_000
    assert [found[:, 1].min(), found[:, 1].max()] == pytest.approx(plane.y([y.max(), y.min()]), abs=0.01)


def test_the_same_sheet_gives_the_same_text():
    sheet = Sheet((PANELS["contours"], PANELS["bars"]), title="a title")
    assert drawing_of(sheet).text == drawing_of(sheet).text


# ------------------------------------------------------------------------------------------------------ legibility


WAVES = tuple(Line(X, 0.5 + 0.5 * np.sin(phase + 9.0 * X), name=f"after {phase} s") for phase in range(5))


@pytest.mark.parametrize("wanted", ["upper right", "best", "lower left"])
def test_a_legend_covers_no_curve(wanted):
    assert faults(drawn(*WAVES, legend=wanted)[0]) == []


@pytest.mark.parametrize(
    ("marks", "of", "fault"),
    [
        ((Line(X, X),), {"across": PanelAxis("")}, "no name: the x axis"),
        ((Line(X, X),), {"across": PanelAxis("a", low=2.0, high=3.0)}, "cut: 50 of 50 points"),
        ((), {}, "empty: "),
        ((Line(X, X), Text(0.5, 0.2, "here", size=6.0)), {}, "small: 'here'"),
        ((Line(X, X), Text(0.5, 0.2, "here"), Text(0.5, 0.2, "there")), {}, "overlap: 'there' and 'here'"),
        ((Line(X, X), Text(2.5, 0.2, "far away")), {}, "outside: 'far away'"),
        ((Line(X, X),), {"upright": PanelAxis("force [uN]")}, "letters: 'force [uN]'"),
        ((Line(X, X),), {"upright": PanelAxis("a", low=0.0, high=100.0)}, "flat: "),
        ((Line(X, X),), {"upright": PanelAxis("a", ticks=np.array([0.5]))}, "one number: "),
        ((Line(X, X),), {"upright": PanelAxis("a", log=True, low=1e-19, high=1.0)}, "decades: "),
        ((Line(np.array([0.0, 0.4, 0.7, 1.0]), np.array([0.0, 0.1, 0.4, 0.9])),), {}, "polygon: a curve of 4 points"),
        ((Line(X, X), Area(X, np.zeros(50), np.full(50, 0.004))), {}, "thin: "),
        ((Line(X, X), Text(0.5, 0.5, "here")), {}, "struck through: 'here'"),
        ((Line(X, X), Rule(0.5), Text(0.2, 0.5, "here")), {}, "struck through: 'here'"),
    ],
)  # fmt: skip
def test_each_fault_of_a_drawing_is_found(marks, of, fault):
    assert any(found.startswith(fault) for found in faults(drawn(*marks, **of)[0]))


def test_a_curve_below_a_legend_is_found():
    drawing, _ = drawn(Line(X, X, name="curve"), legend="upper left")
    moved = drawing.text.replace('<g class="legend">', '<g class="legend">' + LETTERS_ON_THE_CURVE, 1)
    assert any(found.startswith("below the legend") for found in faults(drawing._replace(text=moved)))


LETTERS_ON_THE_CURVE = "".join(
    f'<text x="{x}" y="{y}" font-size="8.5" text-anchor="start">name</text>' for x, y in ((80, 60), (250, 180))
)


def test_a_drawing_needs_no_matplotlib_and_a_picture_is_one():
    assert isinstance(render(Sheet((PANELS["a curve"],))), Figure)
