"""Studies and numbers made to harm: keys that are kinds, names without end, sizes that no machine has."""

from __future__ import annotations

import re
import sys
from pathlib import Path

import numpy as np
import pytest
from bounded import sentence_within

import winkler as wk
import winkler.values.limits as limits
from winkler.cli import main
from winkler.fields.restoration import SubsurfaceFields
from winkler.io.vtk import write_vtk
from winkler.loading.path_steps import Follow, Hold, Oscillate, Ramp, Start
from winkler.loading.program import Program
from winkler.study.language.build import build
from winkler.study.language.designs import Crossed, Sensitivity, axes_of
from winkler.study.language.explain import completed
from winkler.study.language.fit_reading import parse_fit_study
from winkler.study.language.reading import parse_study
from winkler.study.language.study import Fields, Places
from winkler.study.language.template import whole_text
from winkler.study.language.varied import Axis, Range
from winkler.values.errors import InvalidInput
from winkler.values.limits import STUDY_MARKS
from winkler.values.units import quantity, scale

PRESSED = whole_text("indentation")
assert '"100 N"' in PRESSED
PROFILE = '[problem.bed.profile]\nkind = "measured"\nfile = "{}"\n[problem.bed.medium]'
linux = pytest.mark.skipif(sys.platform != "linux", reason="bounds are set as Linux does")


@pytest.mark.parametrize(
    "text",
    [
        f'kind = "force"\nforce = "100 N"\n{PRESSED}',
        f'force = "100 N"\nkind = "force"\n{PRESSED}',
        f'sphere = 1\nkind = "sphere"\n{PRESSED}',
        f'{PRESSED}\n[output]\nforce = "100 N"\nkind = "force"\n',
        f'{PRESSED}\n[fields]\nr = "1 mm"\ncone = 1\nkind = "cone"\n',
        f'{PRESSED}\n[[expect]]\nforce = 1\nkind = "force"\n',
    ],
)
def test_a_key_beside_a_kind_of_its_name_where_no_kind_is(text):
    with pytest.raises(InvalidInput) as message:
        parse_study(text, file="study.toml")
    assert "kind is not known; " in str(message.value)
    assert any(
        word in str(message.value) for word in ("force is not known", "sphere is not known", "cone is not known")
    )


TEXTS = {
    "a key of many parts": ("a." * 20_000 + "a = 1\n", "a key has more than 50 parts"),
    "a quoted key of many parts": ('"a" . ' * 20_000 + "a = 1\n", "a key has more than 50 parts"),
    "a table of many parts": ("[" + "a." * 20_000 + "a]\n", "a key has more than 50 parts"),
    "letters without a point": ("a" * 300_000 + " ", "this is not TOML"),
    "quotes without an end": ("'" * 100_001, "this is not TOML"),
    "many entries": ("a = [" + "1," * (STUDY_MARKS + 1) + "]", "more than 1000000 entries"),
    "many tables": ("[a]\n" * STUDY_MARKS, "more than 1000000 entries"),
    "lists within lists": ("a = " + "[" * 900, "nested too deep"),
    "a zero with a power": (PRESSED.replace("100 N", "0e999999999 N"), ""),
    "a unit with powers": (PRESSED.replace("100 N", "1 ((((mm^12))^12))^12"), "its size cannot be computed with"),
    "a word of letters": (PRESSED.replace("100 N", "1 " + "N" * 300_000), "too long for a quantity"),
}


@linux
@pytest.mark.parametrize("case", TEXTS)
def test_texts_made_to_harm(case):
    text, sentence = TEXTS[case]
    message = sentence_within(lambda: parse_study(text, file="study.toml"))
    assert message.startswith("study.toml") if sentence else message == ""
    assert sentence in message


LONG = "9" * 5000


@pytest.mark.parametrize(
    "more",
    [
        f'[sweep]\n"problem.bed.{LONG}" = ["1 N"]\n',
        f'[sweep]\n"problem.load.force.{LONG}" = ["1 N"]\n',
        f'[sweep]\n"{"a." * 20_000}" = ["1 N"]\n',
        f'[[expect]]\nquantity = "depth{".1" * 9000}.x"\nvalue = "1 m"\ntolerance = 0.1\n',
        f'[[expect]]\nquantity = "{LONG}"\nvalue = "1 m"\ntolerance = 0.1\n',
    ],
)
def test_keys_without_end(more):
    with pytest.raises(InvalidInput, match=r"at most 500 letters|more than 50 parts|give at most 500\."):
        parse_study(f"{PRESSED}\n{more}", file="study.toml")


@pytest.mark.parametrize("unit", ["m " * 5000, "m^" + "9" * 90, "(" * 90, "Ym^12 Ym^12 Ym^12 Ym^12 Ym^12 Ym^12"])
def test_units_made_to_harm(unit):
    with pytest.raises(InvalidInput):
        scale(unit, "m")
    with pytest.raises(InvalidInput):
        quantity(f"1 {unit}", "m", what="length")


@pytest.mark.parametrize("name", ["a" * 5000, "a" * 300, "x.**", "b/" * 3000, "../../..", "", "**"])
def test_files_named_to_harm(name, tmp_path):
    before, _, behind = PRESSED.partition("[problem.bed.profile]")
    text = before + PROFILE.format(name) + behind.partition("[problem.bed.medium]")[2]
    with pytest.raises(InvalidInput, match=r"problem\.bed\.profile: file is "):
        parse_study(text, folder=tmp_path)


@pytest.mark.parametrize(
    "name", ["a" * 5000, "**x", "/**x", "[" * 400, "*/" * 3000, "**/" * 5 + "*", "1²2", "~", "?" * 300]
)
def test_curves_named_to_harm(name, tmp_path):
    (tmp_path / "1²2.txt").write_text("")
    model = PRESSED.partition("[problem.load]")[0]
    section = f'[fit]\ncurve = "{name}"\npart = "approach"\n[fit.free]\n"problem.bed.medium.first.young" = true\n'
    with pytest.raises(InvalidInput, match=r"fit\.curve"):
        parse_fit_study(model + section, folder=tmp_path)


@pytest.mark.parametrize("swept", [False, True])
def test_folders_of_results_with_long_names(swept, tmp_path, capsys, monkeypatch):
    monkeypatch.chdir(tmp_path)
    sweep = '\n[sweep]\n"problem.load.force" = ["1 N", "2 N"]\n' if swept else ""
    study = tmp_path / f"{'n' * 240}.toml"
    study.write_text(PRESSED + sweep)
    for more in ((), ("--output", "o" * 255), ("--output", "o" * 300), ("--output", "o/" * 2500 + "o")):
        assert main(["run", str(study), *more]) == 2
        message = capsys.readouterr().err
        assert message.count("\n") == 1
        assert "give a" in message
    (tmp_path / "s.toml").write_text(PRESSED + sweep + '\n[output]\nfolder = "x\\u0000y"\n')
    assert main(["run", str(tmp_path / "s.toml")]) == 2
    for words in (["validate", "q" * 300], ["new", "indentation", "--output", "q" * 300]):
        assert main(words) == 2
    assert sorted(path.name for path in tmp_path.iterdir()) == [study.name, "s.toml"]


# ------------------------------------------------------------------------------------------------------------- sizes

COUNTS = [
    ("bimodal_damping", "normal_cycles"),
    ("bimodal_damping", "lateral_cycles"),
    ("equilibrium", "count"),
    ("fretting_wear", "count"),
    ("hold", "count"),
    ("impact", "count"),
    ("oscillate", "count"),
    ("circle", "count"),
    ("ramp", "count"),
    ("follow", "cycles"),
    ("random_topography", "shape"),
    ("rolling_start", "count"),
    ("oscillating_rolling", "cycles"),
    ("rough_contact", "count"),
    ("rough_contact", "realisations"),
    ("rough_indentation", "count"),
    ("rough_indentation", "realisations"),
    ("simplified_rolling", "count"),
    ("sliding_resistance", "count"),
    ("sliding_wear", "count"),
    ("surface_conduction", "realisations"),
    ("viscoelastic_impact", "count"),
    ("viscoelastic_indentation", "count"),
    ("tangential", "count"),
]


@pytest.mark.few(12)
@linux
@pytest.mark.parametrize(("kind", "field"), COUNTS)
def test_counts_that_no_machine_has(kind, field):
    from winkler.study.language.catalogue import slot_of

    given = [10**11, 10**11] if field == "shape" else 10**11
    table = completed({"kind": kind}) | {field: given}
    message = sentence_within(lambda: build(table, slot_of(kind)))
    assert "raised" not in message
    assert "10000000" in message


def test_fractional_solids_that_hardly_relax_are_refused():
    for solid in (
        lambda x: wk.FractionalZener(5e5, 3e8, 2e-5, x, shortest=1e-8, longest=10.0),
        lambda x: wk.PowerLawSolid(500.0, 1.0, x, shortest=1e-4, longest=100.0),
    ):
        with pytest.raises(
            InvalidInput, match=r"exponent is 1e-09; give a number from 0\.0001 to below 1: .* use Elastic\.$"
        ):
            solid(1e-9)
        assert solid(1e-4).exponent == 1e-4


def test_rows_that_are_too_long_are_refused():
    rising = np.geomspace(1e-3, 1e3, 20_001)
    for make in (
        lambda: wk.RelaxationData(rising, 1e6 / (1.0 + rising)),
        lambda: wk.CreepData(rising, 1e-6 * (1.0 + rising)),
        lambda: wk.DynamicData(rising, 1e6 + rising, 1.0 + rising),
        lambda: wk.Prony(1e6, np.ones(1001), rising[:1001]),
        lambda: wk.GeneralisedKelvin(1e-6, np.ones(1001), rising[:1001]),
        lambda: wk.MeasuredBed(*[np.arange(1.0, 500_002.0)] * 3),
        lambda: Oscillate(wk.Depth(1e-6), cycles=1e6, count=100),
        lambda: Follow(wk.Path(np.arange(1000.0), wk.Depth(np.ones(1000))), 20_000),
        lambda: wk.random_topography(wk.SelfAffine(0.8, 1e-6, 1e-3, 2e-5), (4100, 4100), (1e-3, 1e-3), seed=1),
    ):
        with pytest.raises(InvalidInput, match=r"are too many; give at most|are more than"):
            make()


@pytest.mark.parametrize("step", [Hold(1.0, 400), Ramp(wk.Depth(1e-6), count=400)])
def test_a_program_of_too_many_points_is_refused(step, monkeypatch):
    monkeypatch.setattr("winkler.loading.program.PATH_POINTS", 1000)
    with pytest.raises(InvalidInput, match=r"Program: 1201 points are too many; give at most 1000\."):
        Program((Start(wk.Depth(1e-6)), step, step, step))


def test_places_and_points_that_are_too_many():
    many = Places(np.linspace(0.0, 1.0, 2000))
    with pytest.raises(InvalidInput, match=r"fields: 4000000 places are too many; give at most 1048576\."):
        Fields(many, many)
    axes = tuple(Axis(f"problem.{name}", tuple(map(float, range(4000)))) for name in ("x", "y", "z"))
    with pytest.raises(InvalidInput, match=r"sweep: 64000000000 points are too many"):
        axes_of(Crossed(), axes)
    with pytest.raises(InvalidInput, match=r"sweep: 67108864 points are too many"):
        axes_of(Sensitivity(2**24), tuple(Range(f"problem.{name}", 0.0, 1.0) for name in ("x", "y")))


def test_a_body_of_rotation_of_too_many_places(tmp_path):
    bed = wk.Foundation(wk.FlatPunch(1e-3), wk.HalfSpace(wk.Elastic(210e9, 0.3)))
    r, z = np.linspace(0.0, 1e-3, 30)[:, None], np.linspace(1e-5, 1e-3, 30)[None, :]
    fields = wk.restore(wk.Indentation(bed, wk.Force(1.0)).solve(), r, z)
    assert isinstance(fields, SubsurfaceFields)
    with pytest.raises(InvalidInput, match=r"write_vtk: 9000900 places are too many"):
        write_vtk(fields, tmp_path / "body.vtk", around=10_000)


def test_the_manual_states_the_limits():
    page = (Path(__file__).parents[3] / "docs" / "exchange.md").read_text(encoding="utf-8")
    message = {int(number) for number in re.findall(r"\d+", page.partition("| at most |")[2])}
    units = dict.fromkeys(("TEXT_BYTES", "STUDY_BYTES", "FILE_BYTES", "READING_BYTES"), 10**6)
    inner = {"LIST_BYTES", "UNIT_LETTERS", "MEASURED_PLACES", "LEAST_STEP_RATIO"}
    stated = {
        getattr(limits, name) // units.get(name, 1) for name in vars(limits) if name.isupper() and name not in inner
    }
    assert stated <= message
