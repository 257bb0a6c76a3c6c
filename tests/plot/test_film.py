"""Films of height maps that are sheared or roll, and of metals that yield: in the app and as a file."""

from __future__ import annotations

import importlib.util
import io
import json
import sys

import matplotlib
import numpy as np
import pytest
import tomli_w
from PIL import Image

import winkler as wk
from winkler.cli import main
from winkler.plot import film, style
from winkler.plot.panel import NO_CONTACT, Map, Strokes
from winkler.plot.particles.dent_film import dent_sheets, surface_of
from winkler.plot.render import render
from winkler.plot.rough.film import film_panels, film_sheet
from winkler.problems.subsurface import traction_frames
from winkler.study.batch.run import run
from winkler.study.language.explain import example_study
from winkler.study.language.reading import parse_study
from winkler.web.pictures import answer, frames
from winkler.web.pictures.moments import moments_of
from winkler.web.pictures.view import NO_VIEW

PAIR = wk.HalfSpace.between(wk.Elastic(1.0, 0.3), wk.Elastic(1.0, 0.3))
BALL = wk.SampledProfile([0.25, 0.25], wk.Paraboloid(1.0), (33, 33))


@pytest.fixture(scope="module")
def swung():
    """A ball that touches from the second state on and is pushed to and fro."""
    path = wk.Path.through(wk.Depth([0.0, 0.01, 0.01, 0.01]), wk.Shift([0.0, 0.0, 0.0015, -0.0005]))
    return wk.SurfaceTangential(BALL, PAIR, wk.Coulomb(0.3), path)


def test_each_state_has_its_zones_and_one_scale(swung):
    solution, states = swung.solve(), list(swung.steps())
    assert [frame.index for frame in solution.frames] == [0, 1, 2, 3]
    assert film_panels(solution, 0)[0] is NO_CONTACT
    highest = max(float(np.max(np.hypot(*state.traction))) for state in states)
    ends = set()
    for index, state in enumerate(states[1:], 1):
        zones, size = film_panels(solution, index)
        stuck, slid = (mark for mark in zones.marks if isinstance(mark, Map))
        assert np.nansum(slid.z) == np.count_nonzero(state.slipping)
        assert np.nansum(stuck.z) == np.count_nonzero((state.pressure > 0.0) & ~state.slipping)
        (image,) = (mark for mark in size.marks if isinstance(mark, Map))
        assert np.nanmax(image.z) == pytest.approx(np.max(np.hypot(*state.traction)), rel=1e-6)
        ends.add((*image.x.tolist(), *image.y.tolist(), image.bar.low, image.bar.high))
    assert len(ends) == 1
    assert next(iter(ends))[-1] == pytest.approx(highest, rel=1e-6)
    bars = {film_panels(solution, index)[1].marks[0].bar for index in (1, 2, 3)}  # without traction in the first one
    assert len({bar.scale.unit for bar in bars}) == 1
    assert film_sheet(solution, 2).title.startswith("state 3 of 4;")


@pytest.mark.slow
def test_a_film_is_an_animated_picture(swung):
    made = film(swung.gathered(list(swung.steps())[1:3]), per_second=4)
    with Image.open(io.BytesIO(made)) as picture:
        assert picture.format == "GIF"
        assert picture.n_frames == 2
        assert picture.info["duration"] == 250


PROGRAM = """#!{python}
import sys
sys.argv[1:] == ["-version"] or open(sys.argv[-1], "wb").write(sys.stdin.buffer.read())
"""
"""In place of ffmpeg: what it was given goes into the file as it is."""


@pytest.mark.skipif(sys.platform == "win32", reason="a script is no program there")
def test_a_video_gives_all_frames_to_the_program(swung, tmp_path, monkeypatch):
    program = tmp_path / "ffmpeg"
    program.write_text(PROGRAM.format(python=sys.executable))
    program.chmod(0o755)
    monkeypatch.setitem(matplotlib.rcParams, "animation.ffmpeg_path", str(program))
    one, two = (film(swung.gathered(list(swung.steps())[1:end]), form="mp4") for end in (2, 3))
    assert len(two) == 2 * len(one)
    pixels = np.frombuffer(two, np.uint8).reshape(2, -1, 4)
    assert (pixels[..., 3] == 255).all()
    assert (pixels[0] != pixels[1]).any()


def test_a_video_without_its_program_says_what_to_install(swung, monkeypatch):
    monkeypatch.setitem(matplotlib.rcParams, "animation.ffmpeg_path", "no such program")
    monkeypatch.setitem(sys.modules, "imageio_ffmpeg", None)
    solution = swung.gathered(list(swung.steps())[:2])
    with pytest.raises(wk.InvalidInput, match=r"^film: an \.mp4 is written by the program ffmpeg, .*imageio-ffmpeg"):
        film(solution, form="mp4")
    with pytest.raises(wk.InvalidInput, match="the form 'avi' is not known; give one of gif, mp4"):
        film(solution, form="avi")


@pytest.mark.skipif(importlib.util.find_spec("imageio_ffmpeg") is None, reason="imageio-ffmpeg is not installed")
def test_a_video_is_read_back(swung, tmp_path, monkeypatch):
    import imageio_ffmpeg

    monkeypatch.setitem(matplotlib.rcParams, "animation.ffmpeg_path", "no such program")
    made = tmp_path / "made.mp4"
    made.write_bytes(film(swung.gathered(list(swung.steps())[1:4]), per_second=4, form="mp4"))
    count, seconds = imageio_ffmpeg.count_frames_and_secs(str(made))
    assert (count, seconds) == (3, 0.75)


def test_what_has_no_film_is_refused(swung):
    with pytest.raises(wk.InvalidInput, match=r"^film: int has no frames; give a solution of SurfaceTangential, .*\.$"):
        film(3)
    with pytest.raises(wk.InvalidInput, match="per_second is 0"):
        film(swung.gathered(list(swung.steps())[:1]), per_second=0)


def test_large_histories_keep_every_second_frame(swung, monkeypatch):
    states = list(swung.steps())[1:] * 4
    monkeypatch.setattr(traction_frames, "MOST_BYTES", 50_000)
    kept = swung.gathered(states).frames
    assert [frame.index for frame in kept] == list(range(0, 12, kept[1].index))
    assert kept[1].index == 4
    assert sum(frame.traction.nbytes for frame in kept) <= 50_000
    assert traction_frames.frame_at(kept, 11) is kept[-1]
    assert traction_frames.frame_at(kept, kept[1].index - 1) is kept[0]


def test_the_app_draws_the_zones_of_the_moment():
    table = example_study("surface_rolling") | {}
    table["problem"]["topography"]["shape"] = [24, 24]
    outcome = run(parse_study(tomli_w.dumps(table)))
    moments = moments_of(outcome.points[0])
    assert moments.total == 6
    shares = []
    for moment in (0, 5):
        shown = {
            each.name: json.loads(each.chart)
            for each in answer.pictures(answer.scene(outcome, moments, moment, NO_VIEW, still=False))
        }
        stuck, slid, arrows = shown["stick_and_slip"]["data"]
        assert stuck["type"] == slid["type"] == "heatmap"
        assert len(arrows["x"]) % 6 == 0
        counts = [sum(cell is not None for row in part["z"] for cell in row) for part in (stuck, slid)]
        shares.append(counts[0] / sum(counts))
        assert shown["traction"]["data"][0]["zmax"] > 0.0
    assert shares == pytest.approx(outcome.points[0].solution.stick_share[[0, 5]])


@pytest.mark.slow
def test_the_command_writes_a_film(tmp_path, capsys):
    study = tmp_path / "rolls.toml"
    table = example_study("surface_rolling")
    table["problem"]["topography"]["shape"] = [24, 24]
    study.write_text(tomli_w.dumps(table), encoding="utf-8")
    made = tmp_path / "rolls.gif"
    assert main(["draw", str(study), "--part", "film", "--output", str(made)]) == 0
    with Image.open(made) as picture:
        assert picture.n_frames == 6
    assert main(["draw", str(study), "--part", "film", "--output", str(tmp_path / "rolls.png")]) == 2
    assert "does not end like a film; give .gif or .mp4." in capsys.readouterr().err


def example_frames(kind, monkeypatch, **changes):
    """Return five frames of the example of a kind, with changes of the problem, and the solved point."""
    monkeypatch.setattr(frames, "MOST_FRAMES", 5)
    table = example_study(kind)
    table["problem"].update(changes)
    point = run(parse_study(tomli_w.dumps({"title": kind, **table}))).points[0]
    return list(frames.frames_of(point)), point


def test_a_pushed_body_moves_in_one_frame(monkeypatch):
    sheets, point = example_frames("tangential", monkeypatch)
    assert len(sheets) == 5
    for panels in zip(*(sheet.panels for sheet in sheets), strict=True):
        assert len({(panel.upright.low, panel.upright.high, panel.upright.scale) for panel in panels}) == 1
    colours = [set(mark.colours) for sheet in sheets for mark in sheet.panels[1].marks if isinstance(mark, Strokes)]
    assert style.GREEN in set().union(*colours)
    last = [mark for mark in sheets[-1].panels[3].marks if mark.marker]
    assert (float(last[0].x[0]), float(last[0].y[0])) == (point.solution.shift[-1], point.solution.shear_force[-1])


def test_one_load_does_not_move(monkeypatch):
    with pytest.raises(wk.InvalidInput, match="of one load does not move; give a path"):
        example_frames("indentation", monkeypatch)


@pytest.mark.parametrize("argument", ["contact.load", "first_speed"])
def test_a_contact_that_warms_up_moves_over_loads_and_speeds(argument):
    """The bed is that of the contact which the problem takes."""
    table = example_study("friction_heating")
    if argument == "first_speed":
        table["problem"]["first_speed"] = ["1 m/s", "2 m/s", "4 m/s"]
    else:
        table["problem"]["contact"]["load"] = {"kind": "force", "force": ["5 N", "10 N", "20 N"]}
    point = run(parse_study(tomli_w.dumps({"title": "warm", **table}))).points[0]
    assert len(list(frames.frames_of(point))) == 3


STEEL = wk.HalfSpace(wk.Elastic(210e9, 0.3, strength=300e6), wk.Elastic(210e9, 0.3))
BEARING = wk.Foundation(wk.Paraboloid(5e-3), STEEL)


def pressed_again():
    """A ball that dents a plate, is let go, pressed less than before, and let go; none of its points is an onset."""
    return wk.PlasticIndentation(BEARING, wk.Force([100.0, 0.0, 60.0, 0.0])).solve()


def shown(sheet, name):
    """Return a row of the first panel by its name in the legend."""
    return next(mark for mark in sheet.panels[0].marks if getattr(mark, "name", "") == name)


def test_a_film_of_a_dent_ends_with_the_dent_that_stays():
    pressed = pressed_again()
    sheets = list(dent_sheets(pressed, 21))
    assert len(sheets) == 21
    left = float(pressed.residual_depth[-1])
    assert left > 1e-6
    last, first = shown(sheets[-1], "surface"), shown(sheets[0], "surface")
    assert np.nanmin(last.y) == pytest.approx(-left, rel=1e-12)
    assert not first.y.any()
    assert np.isnan(shown(sheets[-1], "contact").y).all()
    assert sheets[-1].title.endswith("the dent is 2.761 µm deep")
    assert left == pytest.approx(2.761e-6, abs=5e-10)
    assert sheets[0].title.endswith("elastic, no dent")
    beyond = shown(sheets[-1], "beyond the dent: elastic part alone")
    assert np.nanmin(np.abs(beyond.x[np.isfinite(beyond.y)])) > float(pressed.largest_radius[-1])
    assert not np.nan_to_num(beyond.y).any()
    marked = [sheet.panels[1].marks[-1] for sheet in sheets]
    forces = [float(mark.y[0]) for mark in marked]
    assert forces == pytest.approx([*range(0, 100, 20), *range(100, 0, -20), *range(0, 60, 12), *range(60, -1, -12)])


def test_axes_of_a_film_of_a_dent_do_not_move():
    frames_of_axes = set()
    for sheet in dent_sheets(pressed_again(), 5):
        figure = render(sheet)
        frames_of_axes.add(tuple((*axes.get_xlim(), *axes.get_ylim()) for axes in figure.axes))
    assert len(frames_of_axes) == 1


def test_the_surface_of_a_film_follows_the_indenter_where_it_touches():
    """The dent less the elastic displacement is the outline of the indenter, which neither of them knows."""
    along = wk.PlasticIndentation(BEARING, wk.Force([0.2, 20.0, 100.0, 50.0, 5.0, 0.0])).solve()
    for place in range(5):
        touch, edge = float(along.radius[place]), float(along.largest_radius[place])
        r = np.linspace(0.0, 0.999 * touch, 40)
        within, beyond = surface_of(along, place, r)
        indenter = r**2 / (2.0 * 5e-3) - along.depth[place]
        assert within == pytest.approx(indenter, abs=1e-9 * along.depth[place])
        assert np.isnan(beyond).all()
        outside = np.linspace(1.001 * touch, edge, 40)[:-1] if touch < 0.99 * edge else np.zeros(0)
        assert (surface_of(along, place, outside)[0] < outside**2 / (2.0 * 5e-3) - along.depth[place]).all()


def test_before_yield_the_surface_beyond_is_that_of_hertz():
    """K. L. Johnson, Contact Mechanics, equation 3.42b."""
    along = wk.PlasticIndentation(BEARING, wk.Force([0.2])).solve()
    a, r = float(along.radius[0]), np.array([1.1, 1.5, 3.0]) * float(along.radius[0])
    sunk = ((2.0 * a**2 - r**2) * np.arcsin(a / r) + a * np.sqrt(r**2 - a**2)) / (np.pi * 5e-3)
    within, beyond = surface_of(along, 0, r)
    assert within == pytest.approx(-sunk, rel=1e-9)
    assert np.isnan(beyond).all()


@pytest.mark.parametrize("kind", ["plastic_impact", "dent_limit", "plastic_indentation"])
def test_dents_of_studies_have_films(kind, monkeypatch):
    changes = {"velocity": "0.4 m/s"} if kind == "plastic_impact" else {}
    sheets, point = example_frames(kind, monkeypatch, **changes)
    assert 2 < len(sheets) <= 5
    forces = [float(sheet.panels[1].marks[-1].y[0]) for sheet in sheets]
    greatest = point.solution.greatest_force if kind == "plastic_impact" else point.solution.force
    assert max(forces) <= np.max(greatest) * (1.0 + 1e-9)
    if kind != "plastic_indentation":
        assert max(forces) == pytest.approx(np.max(greatest), rel=1e-9)
        assert forces[-1] == 0.0


def test_dents_without_a_shape_have_no_film():
    crowned = wk.EllipticFoundation(wk.CurvedBodies(5e-3, 50e-3), STEEL)
    with pytest.raises(wk.InvalidInput, match="does not compute the shape of an elliptic dent"):
        film(wk.PlasticIndentation(crowned, wk.Force([100.0, 0.0])).solve())
    with pytest.raises(wk.InvalidInput, match="touch at no moment"):
        film(wk.PlasticIndentation(BEARING, wk.Force([0.0])).solve())
    with pytest.raises(wk.InvalidInput, match="of 2 velocities has as many dents; give one velocity"):
        film(wk.PlasticImpact(BEARING, mass=4e-3, velocity=np.array([0.1, 0.2])).solve())
