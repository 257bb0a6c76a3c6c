"""``winkler show``, ``new``, ``draw``, ``cite``, ``validate``, help and version."""

from __future__ import annotations

import json
import re
import subprocess
import sys
import tomllib
import typing
from pathlib import Path

import pytest
from example_answers import example_problem

import winkler as wk
from winkler.cli import main
from winkler.study.batch.run import run
from winkler.study.language.build import build
from winkler.study.language.catalogue import CATALOGUE, kinds, slot_of
from winkler.study.language.explain import keys_of, place_of, plain_symbol, table_at
from winkler.study.language.grammar import SECTIONS, study_form
from winkler.study.language.reading import parse_study
from winkler.study.language.schema import hints
from winkler.study.language.template import example_text, inline, template
from winkler.study.ledger.ledger import case_files
from winkler.study.report import citing
from winkler.study.report.citing import bibliography, cite

COMMANDS = ("run", "show", "draw", "new", "cite", "validate")


@pytest.fixture
def here(tmp_path, monkeypatch) -> Path:
    monkeypatch.chdir(tmp_path)
    return tmp_path


# ------------------------------------------------------------------------------------------------------- show


@pytest.mark.few(100, slow=60)
@pytest.mark.parametrize("name", list(kinds()))
def test_show_lists_every_key_and_a_valid_example(name, capsys):
    assert main(["show", name]) == 0
    message = capsys.readouterr().out
    assert message.startswith(f"{name} (a {slot_of(name)}): ")
    for key in keys_of(name):
        assert key.name in message
        if key.word.unit is not None:
            assert plain_symbol(key.word.symbol) in message
    assert example_text(name) in message
    table = table_at(tomllib.loads(example_text(name)), place_of(name))
    assert f"'kind': '{name}'" in str(table)
    assert type(build(table, slot_of(name))) is kinds()[table["kind"]].cls


def test_every_key_says_what_it_takes():
    for name, key in [(kind, key) for kind in kinds() for key in keys_of(kind)]:
        assert key.takes, f"{name}.{key.name}"
        assert key.word.meaning, f"{name}.{key.name}"
        if key.word.unit is not None:
            assert key.range, f"{name}.{key.name} is not in the section Parameters of its class"


def test_show_lists_everything(capsys):
    assert main(["show"]) == 0
    message = capsys.readouterr().out
    for slot, known in CATALOGUE.items():
        assert slot in message
        for name in known:
            assert re.search(rf"\b{name}\b", message)
    assert main(["show", "medium"]) == 0
    message = capsys.readouterr().out
    assert "half_space" in message
    assert "sphero_conical" not in message


def test_show_study_prints_the_grammar(capsys):
    assert main(["show", "study"]) == 0
    message = capsys.readouterr().out
    for section, keys in SECTIONS.items():
        assert section in message
        for key in keys:
            assert key in message


def test_the_grammar_is_the_one_that_is_read():
    assert list(study_form().model_fields) != []
    assert set(SECTIONS["the study"]) == set(study_form().model_fields)


def test_show_json(capsys):
    assert main(["show", "cone", "--json"]) == 0
    (content,) = json.loads(capsys.readouterr().out)["kinds"]
    assert content["kind"] == "cone"
    assert content["keys"][0]["unit"] == "rad"
    assert build(content["example"], "profile") == wk.Cone(build(content["example"], "profile").half_angle)
    assert main(["show", "--json"]) == 0
    assert [item["kind"] for item in json.loads(capsys.readouterr().out)["kinds"]] == list(kinds())


@pytest.mark.parametrize(
    ("name", "sentence", "code"),
    [
        ("fti", "'fti' is not known (did you mean 'fit'?); `winkler show` lists every kind.", 2),
        ("cylinder", "Cylinder: a cylinder on its side makes a line contact", 4),
    ],
)
def test_show_what_is_not_known(name, sentence, code, capsys):
    assert main(["show", name]) == code
    assert capsys.readouterr().err.startswith(f"winkler: {sentence}")


# -------------------------------------------------------------------------------------------------------- new


KNOWN_TO_SMALL_RADII = {"measured", "designed", "calibrated_tip", "tabulated_tip"}
"""Profiles whose examples end at radii that soft bodies reach."""
SOFT = ("viscoelastic_indentation", "relaxation_test", "harmonic_indentation")


OTHER_LINES = (
    "line_indentation",
    "line_tangential",
    "line_friction_heating",
    "line_fretting_wear",
    "line_sliding_wear",
)
"""Problems of lines that take an example of most profiles."""


UNLIKE_BALLS_AND_CONES = {
    *("area_function", "capped_cylinder", "capped_paraboloid", "flat_punch", "power_law", "rounded_punch", "sum"),
    *("truncated_cone", "truncated_paraboloid", "wavy"),
}
"""Profiles under which it is not known how bodies yield."""


def goes_together(problem: str, profile: str) -> bool:
    """Say whether the example of a profile has an answer to that of a problem."""
    sharp = {
        "cone",
        "flat_punch",
        "truncated_cone",
        "truncated_paraboloid",
        "berkovich",
        "vickers",
        "cube_corner",
        "area_function",
        "capped_paraboloid",
        "pyramid",
        "pyramid_by_edges",
        "calibrated_tip",
    }
    pinned = {"flat_punch", "capped_cylinder"}
    # with a flat end, a rim or a valley, or blunter than a paraboloid
    blunt = pinned | {"power_law", "rounded_punch", "truncated_cone", "truncated_paraboloid", "wavy", "sum"}
    refused = {
        "adhesive_shear": {"flat_punch"},  # pressed at its rim
        "yield_onset": sharp,
        "plastic_indentation": blunt | {"capped_paraboloid", "area_function"},
        "dent_limit": blunt | {"ball_in_socket", "area_function"},  # at the load of the example
        "strength_from_dent": blunt | {"ball_in_socket"},
        **dict.fromkeys(("line_yield_onset", "line_shakedown"), sharp),
        **{name: {"area_function"} for name in OTHER_LINES},  # of a tip of revolution
        "line_plastic_indentation": set(CATALOGUE["profile"]) - {"paraboloid"},
        "periodic_indentation": {
            "area_function",
            "capped_cylinder",
        },  # of a tip of revolution, or narrower than the pitch
        **dict.fromkeys(
            ("line_rolling", "line_rolling_start", "line_rolling_resistance"),
            set(CATALOGUE["profile"]) - {"paraboloid"},
        ),
        "sliding_resistance": pinned | KNOWN_TO_SMALL_RADII,
        **dict.fromkeys(("plastic_indentation", "plastic_impact"), UNLIKE_BALLS_AND_CONES),
        "limiting_profile": {"flat_punch"},  # no ring that slips
        "line_limiting_profile": {"flat_punch", "area_function"},
        "viscoelastic_impact": KNOWN_TO_SMALL_RADII,
        "creep_test": KNOWN_TO_SMALL_RADII,
        **{soft: {"designed"} for soft in SOFT},
        "line_viscoelastic_indentation": KNOWN_TO_SMALL_RADII | {"area_function"},  # the last of a tip of revolution
    }
    return profile not in refused.get(problem, set())


PROBLEMS = [name for name in CATALOGUE["problem"] if "bed" in hints(kinds()[name].cls)]


USUAL = ("sphere", "rounded_punch", "flat_punch")
"""Profiles that every problem is tried with, the first by default; all others with an indentation."""
PROFILES = list(CATALOGUE["profile"])
SEARCHES = {"line_yield_onset", "line_shakedown"}
"""Problems that search for the greatest stress under many loads, a second or two for a profile."""
MARCHES = {"sliding_wear", "viscoelastic_adhesion"}
"""Problems whose march takes a second for a profile: two profiles of each are tried among the slow tests."""

TOO_LONG = {("line_friction_heating", "calibrated_tip")}
"""Takes more than ten minutes: quadratures over hundreds of pieces of the tip, at 35,000 places."""


def pairs():
    """Of the usual ones every eighth, of the rest every 32nd: each problem meets other profiles, and the reverse."""
    for number, problem in enumerate(PROBLEMS):
        for place, profile in enumerate(PROFILES):
            if (problem, profile) in TOO_LONG:
                continue
            usual = problem == "indentation" or profile in USUAL
            if (profile == USUAL[0] or problem == "indentation") and problem not in SEARCHES | MARCHES:
                yield pytest.param(problem, profile)
            elif usual or (number + place) % 8 == 0:
                lasts = profile not in USUAL[: 1 if problem in SEARCHES else 2] and problem in SEARCHES | MARCHES
                more = (number + place) % (8 if usual else 32) != 0
                yield pytest.param(problem, profile, marks=pytest.mark.long if lasts or more else pytest.mark.slow)


@pytest.mark.few(3, slow=20)
@pytest.mark.parametrize(("problem", "profile"), [*pairs()])
def test_new_writes_a_study_that_runs(problem, profile, here, capsys):
    code = main(["new", problem, "--profile", profile, "--output", "study.toml"])
    message = capsys.readouterr()
    if not (here / "study.toml").exists():
        assert code in (2, 4)
        assert message.err.startswith("winkler: these kinds do not go together: ")
        assert not goes_together(problem, profile)
        return
    assert (code, message.err) == (0, "")
    text = (here / "study.toml").read_text(encoding="utf-8")
    study = parse_study(text)
    assert type(study.problem) is kinds()[problem].cls
    if study.problem != example_problem(problem):  # the examples are solved in test_cli_same_numbers.py
        assert run(study).failed == ()
    for line in text.splitlines():
        assert not re.match(r"^\w+ = .*[^ ]$", line) or "#" in line or line.startswith(("kind", "title"))


@pytest.mark.few(1, slow=4)
@pytest.mark.parametrize(
    ("option", "kind"),
    [("--medium", name) for name in CATALOGUE["medium"]]
    + [("--bed", name) for name in CATALOGUE["bed"] if name != "foundation"],
)
def test_new_with_other_parts(option, kind, here):
    relaxes = any(part in kind for part in ("relax", "visco", "poro"))  # no single answer exists: a march is requested
    problem = "viscoelastic_indentation" if relaxes else "indentation"
    assert main(["new", problem, option, kind]) == 0
    study = parse_study((here / f"{problem}.toml").read_text(encoding="utf-8"))
    bed = study.problem.bed
    assert kinds()[kind].cls in (type(bed), type(bed.medium))


@pytest.mark.parametrize(
    ("problem", "option", "kind"),
    [("line_indentation", "--bed", name) for name in CATALOGUE["line_bed"]]
    + [("line_profile_contact", "--profile", name) for name in ("punch_row", "formula_section")]
    + [("line_indentation", "--load", "mean_pressure"), ("line_indentation", "--medium", "coated_half_space")],
)
def test_new_with_parts_of_line_contacts(problem, option, kind, here):
    """`winkler show line_indentation` lists them: an option takes them too."""
    assert main(["new", problem, option, kind, "--overwrite"]) == 0
    found = parse_study((here / f"{problem}.toml").read_text(encoding="utf-8")).problem
    bed = getattr(found, "bed", None)
    parts = (bed, getattr(bed, "medium", None), getattr(found, "section", None), found.load)
    assert kinds()[kind].cls in map(type, parts)


def test_an_optional_number_in_a_template_is_allowed():
    """Its first grid has at least 64 places: 10 would be refused."""
    text = re.sub(r"^# (elements)", r"\1", template("line_profile_contact"), flags=re.MULTILINE)
    assert parse_study(text).problem.elements == 64


OF_DENTS = {"blow", "restitution"}
"""Loads of which a strength is found, that press no body."""


@pytest.mark.few(1)
@pytest.mark.parametrize("load", [load for load in CATALOGUE["load"] if load not in OF_DENTS])
def test_what_is_commented_out_is_valid_too(load):
    """Sweep, fields and output of the template are right when their marks are taken away."""
    text = template("indentation", load=load)
    lines = text.splitlines()
    for number, line in enumerate(lines):
        match = re.match(r"^# (\[\w+\].*|\"?[\w.]+\"? = .*)$", line)
        lines[number] = match[1] if match else line
    study = parse_study("\n".join(lines))
    assert len(study.sweep) == 1
    assert study.fields.r.relative
    assert study.fields.z.values.size > 10
    assert study.output.folder == "results/study"
    assert study.problem.bed.medium.first.strength > 0.0
    outcome = run(study)
    assert outcome.failed == ()
    assert len(outcome.solved) == 9


def test_a_template_shows_optional_switches():
    """Coupled rolling is found without the manual; the line is a key of the problem itself."""
    study = parse_study(re.sub(r"^# (coupled = )", r"\1", template("line_rolling"), flags=re.MULTILINE))
    assert study.problem.coupled is True


def test_optional_stresses_in_a_template_are_usual_ones():
    """A strength or a bulk stress of 210 GPa, the modulus of steel, would be none."""
    study = parse_study(re.sub(r"^# (bulk_stress|strength)", r"\1", template("line_tangential"), flags=re.MULTILINE))
    assert study.problem.path.bulk_stress == 100e6
    assert study.problem.bed.medium.first.strength == 700e6
    assert run(study).failed == ()


def test_new_does_not_replace_a_file_without_consent(here, capsys):
    (here / "indentation.toml").write_text("mine")
    assert main(["new"]) == 2
    assert capsys.readouterr().err == (
        "winkler: 'indentation.toml' exists; add --overwrite to replace it, or give another file with --output.\n"
    )
    assert (here / "indentation.toml").read_text() == "mine"
    assert main(["new", "--overwrite"]) == 0
    assert (here / "indentation.toml").read_text() != "mine"


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (
            ["indention"],
            "problem: 'indention' is not known (did you mean 'indentation'?); there are indentation, "
            "line_indentation, rough_indentation, plastic_indentation and 87 more, which `winkler show` lists.",
        ),
        (
            ["--load", "forces"],
            "load: 'forces' is not known (did you mean 'force'?); there are force, depth, radius, blow",
        ),
        (
            ["--output", "no/where.toml"],
            "cannot be written (no such file or directory); name a file in a folder that exists.",
        ),
        (
            ["yield_onset", "--load", "force"],
            "yield_onset has no place for force, a load; see `winkler show yield_onset`.",
        ),
        (["yield_onset", "--profile", "cone"], "these kinds do not go together: YieldOnset: the apex is pointed"),
    ],
)
def test_new_refuses(arguments, sentence, here, capsys):
    assert main(["new", *arguments]) in (2, 4)
    message = capsys.readouterr()
    assert sentence in message.err
    assert message.err.count("\n") == 1
    assert list(here.iterdir()) == []


def test_inline_values_are_toml():
    content = {"a": 1, "b": 2.5, "c": True, "d": 'quote " and \\ and ü', "e": [1, {"f": "g"}]}
    assert tomllib.loads(f"x = {inline(content)}")["x"] == content


# ------------------------------------------------------------------------------------------------------- draw

STUDY = template("indentation").replace("# [fields]", "[fields]").replace("# r = ", "r = ").replace("# z = ", "z = ")


@pytest.mark.few(1)
@pytest.mark.parametrize("part", ["contact", "profile", "bed", "surface", "stress"])
def test_draw(part, here, capsys):
    (here / "ball.toml").write_text(STUDY, encoding="utf-8")
    assert main(["draw", "ball.toml", "--part", part]) == 0
    assert capsys.readouterr().out == f"Written ball-{part}.png\n"
    assert (here / f"ball-{part}.png").read_bytes()[:4] == b"\x89PNG"


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize(
    ("option", "kind", "part"),
    [
        ("medium", "coated_half_space", "medium"),
        ("medium", "coated_half_space", "stress"),
        ("medium", "graded_half_space", "medium"),
        ("bed", "measured_bed", "medium"),
        ("bed", "measured_bed", "bed"),
        ("bed", "measured_bed", "contact"),
    ],
)
def test_draw_other_media_and_beds(option, kind, part, here):
    text = template("indentation", **{option: kind})
    fields = '[fields]\nr = ["0 a", "1 a"]\nz = ["0.1 mm", "0.2 mm"]\n' if part == "stress" else ""
    (here / "study.toml").write_text(text + fields, encoding="utf-8")
    assert main(["draw", "study.toml", "--part", part]) == 0
    assert (here / f"study-{part}.png").read_bytes()[:4] == b"\x89PNG"


def test_draw_no_profile_of_a_measured_bed_and_no_makeup_of_an_even_medium(here, capsys):
    (here / "study.toml").write_text(template("indentation", bed="measured_bed"), encoding="utf-8")
    assert main(["draw", "study.toml", "--part", "profile"]) == 2
    assert "draw: this study has no profile; `--part bed` shows what it has." in capsys.readouterr().err
    (here / "study.toml").write_text(template("indentation"), encoding="utf-8")
    assert main(["draw", "study.toml", "--part", "medium"]) == 2
    assert "draw: there is no picture of a HalfSpace" in capsys.readouterr().err


@pytest.mark.slow
def test_draw_a_curve_as_svg(here):
    text = STUDY.replace('force = "100 N"', 'force = { from = "1 N", to = "9 N", count = 5 }')
    (here / "ball.toml").write_text(text, encoding="utf-8")
    assert main(["draw", "ball.toml", "--part", "curve", "--output", "curve.svg"]) == 0
    assert "<svg" in (here / "curve.svg").read_text(encoding="utf-8")


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (["--part", "contct"], "draw: the part 'contct' is not known (did you mean 'contact'?); give one of contact,"),
        (["--output", "ball.docx"], "draw: 'ball.docx' does not end like a picture; give .svg, .png, .pdf."),
        (["--point", "3"], "draw: there is no point 3; the study has 1, counted from 0."),
        (["--load", "1"], "draw: there is no load 1; the study has 1, counted from 0."),
        (
            ["--output", "no/where.png"],
            "cannot be written (no such file or directory); name a file in a folder that exists.",
        ),
        (["--output", "ball.png"], "draw: 'ball.png' exists; add --overwrite to replace it"),
    ],
)
def test_draw_refuses(arguments, sentence, here, capsys):
    (here / "ball.toml").write_text(STUDY, encoding="utf-8")
    (here / "ball.png").write_text("mine")
    assert main(["draw", "ball.toml", *arguments]) == 2
    message = capsys.readouterr().err
    assert sentence in message
    assert message.count("\n") == 1
    assert sorted(path.name for path in here.iterdir()) == ["ball.png", "ball.toml"]
    assert (here / "ball.png").read_text() == "mine"


def test_draw_needs_the_fields_it_shows(here, capsys):
    (here / "ball.toml").write_text(template("indentation"), encoding="utf-8")
    assert main(["draw", "ball.toml", "--part", "stress"]) == 2
    assert "the study restores no such fields; add [fields] with r and z." in capsys.readouterr().err


@pytest.mark.few(1)
@pytest.mark.parametrize("part", ["contact", "profile", "curve"])
def test_draw_a_line_contact(here, part):
    (here / "roller.toml").write_text(template("line_limiting_profile"), encoding="utf-8")
    assert main(["draw", "roller.toml", "--part", part, "--output", "roller.png"]) == 0
    assert (here / "roller.png").read_bytes().startswith(b"\x89PNG")


# ------------------------------------------------------------------------------------------------------- cite


def test_every_cited_paper_is_in_the_bibliography():
    for name, line in kinds().items():
        for key in (*line.cites, *getattr(line.cls, "references", ())):
            assert key in bibliography(), f"{name} cites {key}"


def test_every_paper_has_a_key_of_its_own():
    file = Path(citing.__file__).parent / "references.bib"
    keys = re.findall(r"^@\w+\{(\w+),$", file.read_text(encoding="utf-8"), flags=re.MULTILINE)
    assert [key for key in sorted(set(keys)) if keys.count(key) > 1] == []
    assert kinds()["rounded_punch"].cites == ("ciavarella_hills_monno_1998",)


def test_the_bibliography_is_complete_and_sound():
    for key, paper in bibliography().items():
        assert re.fullmatch(r"[a-z_]+_\d{4}", key)
        assert f"{{{key}," in paper.bibtex
        assert key[-4:] in paper.text
        assert "{" not in paper.text
        assert "\\" not in paper.text
        assert paper.doi == "" or re.fullmatch(r"10\.\d{4,}/\S+", paper.doi)


def test_cite_a_study(here, capsys):
    (here / "tip.toml").write_text(template("indentation", profile="berkovich"), encoding="utf-8")
    assert main(["cite", "tip.toml"]) == 0
    message = capsys.readouterr().out
    assert "doi:10.1007/978-3-642-53876-6" in message  # the method
    assert "doi:10.1557/JMR.1992.1564" in message  # the equal-area cone
    assert len(message.splitlines()) == len(set(message.splitlines()))
    assert main(["cite", "tip.toml", "--bibtex"]) == 0
    message = capsys.readouterr().out
    assert message.count("@") == message.count("\n}\n") >= 4


def test_cite_a_kind(capsys):
    assert main(["cite", "cone"]) == 0
    assert "Boussinesq's problem for a rigid cone" in capsys.readouterr().out
    assert main(["cite", "rigid"]) == 0
    assert capsys.readouterr().out == "rigid is based on no particular paper.\n"


def test_cite_in_python():
    bed = wk.Foundation(wk.Sphere(1.0), wk.HalfSpace(wk.Elastic(1.0, 0.3)))
    keys = [paper.key for paper in cite(wk.Indentation(bed, wk.Force(1.0)))]
    assert "hertz_1882" in keys
    assert "johnson_1985" in keys
    assert len(keys) == len(set(keys))


# --------------------------------------------------------------------------------------------------- validate

CASE = """title = "Hertz"
source = "H. Hertz"
grade = "analytical"

[problem]
kind = "indentation"
load = { kind = "radius", radius = "0.5 m" }

[problem.bed]
kind = "foundation"
profile = { kind = "paraboloid", curvature_radius = "1 m" }
medium = { kind = "half_space", first = { kind = "elastic", young = "1 Pa", poisson = 0.0 } }

[[expect]]
quantity = "depth"
value = 0.25
unit = "m"
tolerance = 1e-12
"""


@pytest.mark.slow
def test_validate_the_package(capsys):
    """Some cases; `tests/study/batch/test_study_verdicts.py` solves all, one by one."""
    names = [path.stem for path in case_files()[::24]]
    assert main(["validate", *names]) == 0
    assert re.search(rf"{len(names)} cases, \d+ numbers, none missed\.", capsys.readouterr().out)


def test_validate_own_cases(here, capsys):
    (here / "right.toml").write_text(CASE, encoding="utf-8")
    (here / "wrong.toml").write_text(CASE.replace("0.25", "0.26"), encoding="utf-8")
    assert main(["validate", "right.toml"]) == 0
    message = capsys.readouterr().out
    assert "right (analytical): Hertz" in message
    assert "H. Hertz" in message
    assert "1 cases, 1 numbers, none missed." in message
    assert main(["validate", "."]) == 1
    assert "2 cases, 2 numbers, 1 missed." in capsys.readouterr().out
    assert main(["validate", ".", "--quiet"]) == 1
    message = capsys.readouterr().out
    assert "wrong (analytical)" in message
    assert "right" not in message


def test_validate_as_json_and_markdown(here, capsys):
    (here / "right.toml").write_text(CASE, encoding="utf-8")
    assert main(["validate", "right.toml", "--json"]) == 0
    (entry,) = json.loads(capsys.readouterr().out)["cases"]
    assert entry["passed"] is True
    (number,) = entry["numbers"]
    assert (number["quantity"], number["expected"], number["unit"]) == ("depth", 0.25, "m")
    assert number["digits"] > 12.0
    assert main(["validate", "right.toml", "--markdown"]) == 0
    assert capsys.readouterr().out.startswith("# Validation\n")


# ----------------------------------------------------------------------------------------------------- others


@pytest.mark.parametrize("arguments", [["--help"], ["-h"], [], *([command, "--help"] for command in COMMANDS)])
def test_help(arguments, capsys):
    assert main(arguments) == 0
    message = capsys.readouterr()
    assert message.err == ""
    assert "Usage: winkler" in message.out
    assert "Example" in message.out
    if len(arguments) < 2 and "--help" not in arguments[1:]:
        for command in COMMANDS:
            assert command in message.out
        assert "--install-completion" in message.out


def test_version(capsys):
    assert main(["--version"]) == 0
    assert capsys.readouterr().out == f"winkler {wk.__version__}\n"


@pytest.mark.slow
def test_help_and_wrong_words_load_nothing_heavy():
    """The command line answers at once because it imports what a command needs only when that command is called."""
    code = (
        "import sys; from winkler.cli import main; main(['--help']); main(['run', '--help']); main(['rnu']); "
        "print('LOADED', *sys.modules)"
    )
    answer = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    loaded = set(answer.stdout.split("LOADED")[1].split())
    heavy = {"matplotlib", "xarray", "pint", "h5py", "scipy.optimize", "winkler.study.language.catalogue"}
    assert heavy & loaded == set()


@pytest.mark.slow
def test_the_module_is_the_command(here):
    command = [sys.executable, "-m", "winkler"]
    answer = subprocess.run([*command, "--version"], capture_output=True, text=True, check=True)
    assert answer.stdout == f"winkler {wk.__version__}\n"
    wrong = subprocess.run([*command, "show", "qqqqxx"], capture_output=True, text=True, check=False)
    assert wrong.returncode == 2
    assert wrong.stderr.startswith("winkler: ")


def test_help_keeps_what_stands_in_brackets(capsys, monkeypatch):
    """Brackets are markup there; without a backslash "[fit]" and the extra of "winkler[app]" were lost."""
    from winkler.cli.app import FUNCTIONS

    monkeypatch.setenv("COLUMNS", "200")
    listed = []
    for callback in FUNCTIONS.values():
        hints = typing.get_type_hints(callback, include_extras=True)
        given = [note.help for hint in hints.values() for note in getattr(hint, "__metadata__", ())]
        message = "\n".join(filter(None, [callback.__doc__, *given])).replace("\\[", "[")
        brackets = re.findall(r"\[[a-z]+\]", message)
        listed += brackets
        assert main([callback.__name__, "--help"]) == 0
        shown = capsys.readouterr().out
        for bracket in brackets:
            assert bracket in shown, (callback.__name__, bracket)
    assert {"[fit]", "[app]", "[s]"} <= set(listed)


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize(
    ("words", "suggested"),
    [("winkler show sph", "sphere"), ("winkler new --profile rounded_c", "rounded_cone"), ("winkler dr", "draw")],
)
def test_completion_of_the_shell(words, suggested):
    code = "import sys; from winkler.cli import main; sys.exit(main([]))"
    answer = subprocess.run(
        [sys.executable, "-c", code],
        env={
            "_WINKLER_COMPLETE": "complete_bash",
            "COMP_WORDS": words,
            "COMP_CWORD": str(len(words.split()) - 1),
            "PATH": "",
        },
        capture_output=True,
        text=True,
        check=False,
    )
    assert suggested in answer.stdout.split()


@pytest.mark.parametrize(
    "command",
    [["show", "cone"], ["show", "fit"], ["show", "nanoindentation"], ["show", "gasket", "leak"], ["run", "a.toml"]],
)
def test_json_begins_with_the_number_of_its_form(command, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    assert main(["new", "indentation", "--output", "a.toml"]) == 0
    capsys.readouterr()
    assert main([*command, "--json"]) == 0
    content = json.loads(capsys.readouterr().out)
    assert next(iter(content.items())) == ("schema", 1)
    page = (Path(__file__).resolve().parents[2] / "docs" / "command-line.md").read_text(encoding="utf-8")
    if command[0] == "run":
        [row] = re.findall(r"^\| `run` \| (`title`.*) \|$", page, re.MULTILINE)
        assert re.findall(r"`(\w+)`", re.sub(r"\([^)]*\)", "", row)) == list(content)[1:]
