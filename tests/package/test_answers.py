"""Each problem of the catalogue has all that a reader is promised, and each name in a chapter stands for something."""

from __future__ import annotations

import dataclasses
import inspect
import re
import tomllib
import typing
from importlib.resources import files
from pathlib import Path

from winkler import study
from winkler.plot import sheet_of
from winkler.problems.answer import March
from winkler.study.batch.outcome import number_names
from winkler.study.chapters.answer import Answer, PicturedContact
from winkler.study.chapters.contents import answers
from winkler.study.chapters.kind import _loaded
from winkler.study.language.build import build
from winkler.study.language.catalogue import kinds
from winkler.study.language.explain import example_study
from winkler.study.ledger.physics import CHAPTERS, PHYSICS
from winkler.values.checks.contract import path_of
from winkler.web.form import form

MEMBERS = ("total", "steps", "gathered")
"""Of a march: with them it is watched, and keeps what it has reached."""
PLANE = ("_x", "_y")


def solution_of(problem: type) -> type:
    """Return the class of the solution of a problem."""
    return typing.get_type_hints(inspect.unwrap(problem.solve))["return"]


def kinds_in(table: object) -> set[str]:
    """Return the kinds that a table of a study names."""
    if isinstance(table, list):
        return set().union(*map(kinds_in, table))
    if not isinstance(table, dict):
        return set()
    here = {str(table["kind"])} if "kind" in table else set()
    return here.union(*map(kinds_in, table.values()))


def pictured(name: str, solution: type) -> bool:
    """Return whether a picture is registered; of an answer without one, whether that of its example is drawn."""
    if any(base in sheet_of.registry for base in solution.__mro__[:-1]):
        return True
    return bool(sheet_of(build(example_study(name)["problem"]).solve()).panels)


def missing(name: str, result: Answer, docs: Path, cases: set[str]) -> list[str]:
    """Return what is missing of one record."""
    problem = result.kind.cls
    page = docs / result.page.partition("#")[0]
    manual = page.read_text(encoding="utf-8") if page.is_file() else ""
    solution = solution_of(problem)
    fields = {field.name for field in dataclasses.fields(solution)}
    numbers = set(number_names(solution))
    known = numbers | {f"{number}{end}" for number in numbers for end in PLANE}
    drawn = {word for pair in result.curves for word in pair} | set(result.compared)
    marches = hasattr(problem, "steps") or "states" in fields
    checks = {
        "a picture, of its own or of its numbers or contact": pictured(name, solution),
        "a caption, of its own or of a contact that is shown": result.picture
        or result.pictured is not PicturedContact.NONE,
        "formulas": result.formulas(build(example_study(name)["problem"])),
        "words for the contact that the report shows": result.pictured is not PicturedContact.PATH
        or result.contact_shown,
        "a place in the validation table": PHYSICS.get(name) in CHAPTERS,
        "curves of numbers that it has": drawn <= known,
        "progress (total, steps and gathered), as it marches": not marches
        or all(hasattr(problem, member) for member in MEMBERS),
        "a form in the app": form.initial_table(name)["problem"]["kind"] == name,
        "a question of a user": result.question.endswith("?"),
        "a page of the manual that names it": re.search(rf"\b({problem.__name__}|{name})\b", manual),
        "a case from the literature": name in cases,
    }
    return [f"{name} has no {what}" for what, there in checks.items() if not there]


def test_each_answer_has_what_a_reader_is_promised(root: Path):
    cases = [tomllib.loads(path.read_text()) for path in files("winkler.cases").iterdir() if path.name.endswith("toml")]
    named = set().union(*(kinds_in(case.get("problem", {})) for case in cases))
    found = [line for name, result in answers().items() for line in missing(name, result, root / "docs", named)]
    assert not found, "\n".join(found)


def test_each_path_of_a_class_is_where_its_class_or_function_stands():
    wrong = []
    for file in Path(study.__path__[0]).rglob("*.py"):
        for path in re.findall(r'"(winkler\.[\w.]+:\w+)"', file.read_text(encoding="utf-8")):
            try:
                item = _loaded(path)
            except (ImportError, AttributeError):
                wrong.append(f"{file.name}: there is no {path}")
                continue
            if path_of(item) != path:
                wrong.append(f"{file.name}: {path} stands in {item.__module__}")
    assert not wrong, "\n".join(wrong)


def test_marches_are_problems():
    protocol = {name for name in vars(March) if not name.startswith("_")}
    assert protocol == set(MEMBERS)
    assert {name for name, line in kinds().items() if hasattr(line.cls, "steps")} <= set(answers())


def test_a_solution_of_many_loads_names_a_number_that_it_has_for_each():
    solutions = [solution_of(line.cls) for line in (answer.kind for answer in answers().values())]
    many = [cls for cls in solutions if hasattr(cls, "at") and "states" not in cls.__dataclass_fields__]
    assert len(many) >= 5
    assert [cls.__name__ for cls in many if getattr(cls, "per_load", "") not in number_names(cls)] == []
