"""The lines of a user and the answers of all public problems are checked by mypy and pyright without a cast."""

from __future__ import annotations

import inspect
import json
import os
import re
import runpy
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from answer_types import names_of, public_problems, questions, undecided
from example_answers import LASTING, example_problem, solved

import winkler
from winkler.numerics.types import PerLoad
from winkler.study.language.catalogue import CATALOGUE

LINES = Path(__file__).with_name("typed") / "user.py"
SOURCE = Path(winkler.__file__).parents[1]
WRONG = """
import winkler as wk
import numpy as np

bed = wk.Foundation(wk.Sphere(1e-2), wk.HalfSpace(wk.Elastic(1e9, 0.3)))
number: float = wk.Indentation(bed, wk.Force(np.array([1.0, 2.0]))).solve().depth
"""
PLANE = {f"Tangential: state {word}" for word in ("shear_force", "shift")}
"""Numbers of a path along a line, arrays of two in the plane: no checker can tell from the class which path it is."""
LOADS = re.compile(
    r"\b(Force|Depth|Radius|LineForce|HalfWidth|MeanPressure|NominalPressure|Shift|ShearForce|LineShearForce|Torque|Angle"
    r"|Spin|Creepage|CreepForce|Load|Quantity|\w+Quantity)\b(?!\[)"
)
ONE_PAIR = {"SurfaceRolling.drive"}
"""A shear force in the plane is an array of two, and one load."""
MANY = [name for name, line in CATALOGUE["problem"].items() if issubclass(line.cls, PerLoad)]


@pytest.mark.slow
def test_the_lines_run(capsys):
    runpy.run_path(str(LINES))
    assert capsys.readouterr().out.startswith("3.483 um 186.62 ")
    assert len(LINES.read_text(encoding="utf-8").splitlines()) >= 60


@pytest.mark.slow
def test_mypy_tells_all_answers_and_takes_no_array_for_a_number(tmp_path, root):
    pytest.importorskip("mypy", reason="no mypy here: pip install winkler[checks]")
    lines, asked = questions()
    (tmp_path / "wrong.py").write_text(WRONG, encoding="utf-8")
    (tmp_path / "answers.py").write_text(lines, encoding="utf-8")
    pages = [str(LINES), str(tmp_path / "wrong.py"), str(tmp_path / "answers.py")]
    command = [sys.executable, "-m", "mypy", "--strict", *pages]
    # from the folder of the sources, whose cache a check of the sources has filled
    given = {**os.environ, "MYPYPATH": "src"}
    told = subprocess.run(command, cwd=root, env=given, capture_output=True, text=True).stdout
    assert "wrong.py:6: error: Incompatible types in assignment" in told
    assert "Found 1 error in 1 file (checked 3 source files)" in told
    wrong, known = undecided(told, "answers.py", asked)
    assert known == set(asked.values())
    assert set(wrong) == PLANE, wrong


def test_what_is_undecided_is_found():
    asked = dict(enumerate(("number", "anything", "either", "row", "part", "one", "many"), start=1))
    array = "numpy.ndarray[tuple[Any, ...], numpy.dtype[Any]]"
    kinds = (
        "float",
        "Any",
        f"float | {array}",
        array,
        "dict[str, Any]",
        "x.Solution[float]",
        f"x.Load[float | {array}]",
    )
    told = "\n".join(f'a.py:{line}: note: Revealed type is "{kind}"' for line, kind in enumerate(kinds, start=1))
    wrong, known = undecided(told, "a.py", asked)
    assert set(wrong) == {"anything", "either", "part", "many"}
    assert known == set(asked.values())


def test_what_may_be_many_decides_the_type_of_the_answer():
    """A problem with answers per load names in its parameters all that may be an array, or says that it is one."""
    problems = {name: each for name, each in public_problems().items() if issubclass(each, PerLoad)}
    assert len(problems) >= 37
    found = {
        f"{name}.{word}"
        for name, problem in problems.items()
        for base in problem.__mro__
        for word, note in inspect.get_annotations(base).items()
        if LOADS.search(re.sub(r'".*?"|\bClassVar.*', "", note))
    }
    assert found == ONE_PAIR


@pytest.mark.parametrize("kind", [pytest.param(kind, marks=[pytest.mark.slow] * (kind in LASTING)) for kind in MANY])
def test_answers_to_one_load_are_numbers(kind):
    """What type checkers are told of the answers holds where they are computed: the examples of the manual."""
    solution = solved(example_problem(kind))
    told = {
        word: note.fget.__annotations__.get("return") if isinstance(note, property) else note
        for base in type(solution).__mro__
        for word, note in {**vars(base), **inspect.get_annotations(base)}.items()
        if word in names_of(type(solution))
    }
    per_load = [word for word, note in told.items() if note == "Q"]
    assert per_load
    shapes = {word: np.shape(getattr(solution, word)) for word in per_load}
    types = {word: type(getattr(solution, word)) for word in per_load}
    assert len(set(shapes.values())) == 1, shapes
    assert set(types.values()) == {np.ndarray if shapes[per_load[0]] else float}, types


@pytest.mark.long  # pyright fetches its program when it first runs
def test_pyright_takes_them_and_no_array_for_a_number(tmp_path):
    pytest.importorskip("pyright", reason="no pyright here: pip install winkler[checks]")
    (tmp_path / "wrong.py").write_text(WRONG, encoding="utf-8")
    (tmp_path / "right.py").write_text(LINES.read_text(encoding="utf-8"), encoding="utf-8")
    settings = {"include": ["*.py"], "extraPaths": [str(SOURCE)], "pythonVersion": "3.11"}
    (tmp_path / "pyrightconfig.json").write_text(json.dumps(settings), encoding="utf-8")
    command = [sys.executable, "-m", "pyright", "--outputjson", "--pythonpath", sys.executable, "-p", str(tmp_path)]
    told = json.loads(subprocess.run(command, cwd=tmp_path, capture_output=True, text=True).stdout)
    assert told["summary"]["filesAnalyzed"] == 2
    found = [(Path(one["file"]).name, one["range"]["start"]["line"] + 1) for one in told["generalDiagnostics"]]
    assert found == [("wrong.py", 6)], told["generalDiagnostics"]
