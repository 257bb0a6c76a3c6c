"""Studies made from the catalogue: spoilt ones, which are to be refused well, and varied ones, which are solved.

What may stand where is read from the classes of the kinds (`winkler.study.language.schema`), so that a new kind is
tried without a line here.
"""

from __future__ import annotations

import copy
import functools
import re
from random import Random
from typing import Any

import fuzz_words

from winkler.study.language import quantities
from winkler.study.language.catalogue import CATALOGUE, kinds
from winkler.study.language.explain import completed, example_study
from winkler.study.language.schema import allowed_in_list, allowed_kinds, hints

PROBLEMS = tuple(CATALOGUE["problem"])
AMOUNT = re.compile(r"([-+]?[0-9][-+.0-9eE]*)(?![0-9])(.*)", re.DOTALL)
FORMULAS = (
    "r**2/(2*R)", "R*(cosh(r/R) - 1)", "r**2/(2*R) + r**4/R**3", "sqrt(R**2 + r**2) - R", "R - sqrt(R**2 - r**2)",
    "r + 0*R", "r**1.5/R**0.5", "R*(exp(r/R) - 1)", "r**2/(2*R)*(1 + 0.1*cos(20*r/R))", "R*log(1 + r/R)", "1 - R + r",
)  # fmt: skip
DEEPEST = 5
"""Parts inside parts that are swapped; a sum of sums of sums takes long and shows nothing."""
LONGEST = 6
"""Entries of lists in studies that are solved."""
MARCHED_CYCLES = 50.0
"""Cycles of a path that is marched through: 2000 points of up to 5 ms each, and the march tells how far it is."""
REFUSED_CYCLES = 1e6
"""So many are more points than a path may have: they stay, to be refused."""


@functools.cache
def examples() -> dict[str, dict[str, Any]]:
    """Return a whole study for every kind of the catalogue."""
    return {name: example_study(name) for name in kinds()}


def places(inside: Any, start: tuple[Any, ...] = ()) -> list[tuple[Any, ...]]:
    """Return the key of everything inside a table, as a tuple."""
    found: list[tuple[Any, ...]] = []
    items = inside.items() if isinstance(inside, dict) else enumerate(inside) if isinstance(inside, list) else ()
    for key, content in items:
        found += [(*start, key), *places(content, (*start, key))]
    return found


def spoilt(rng: Random) -> dict[str, Any]:
    """Return a study with one to three things replaced, added, moved or taken away."""
    whole = list(examples().values())
    tables = [study["problem"] for study in whole]
    study = copy.deepcopy(rng.choice(whole))
    for _ in range(rng.choice((1, 1, 2, 3))):
        known = places(study)
        if not known:
            break
        *outer, last = rng.choice(known)
        inside = study
        for key in outer:
            inside = inside[key]
        _spoil(rng, study, tables, inside, tuple(outer), last)
    return study


def _spoil(rng: Random, study: Any, tables: list[Any], inside: Any, outer: tuple[Any, ...], last: Any) -> None:
    """Change one thing of a study in place."""
    what = rng.choice(("edge", "edge", "unit", "replace", "replace", "take", "add", "part", "list", "section", "deep"))
    here = inside[last]
    if what == "edge" and isinstance(here, str) and (amount := AMOUNT.fullmatch(here)):
        inside[last] = f"{fuzz_words.number(rng)}{amount[2]}"
    elif what == "edge":
        inside[last] = fuzz_words.number(rng)
    elif what == "unit" and isinstance(here, str):
        inside[last] = re.sub(r"[^-+.0-9eE ]+.*", lambda _: rng.choice(fuzz_words.UNITS), here, count=1)
    elif what == "take":
        del inside[last]
    elif what == "add" and isinstance(inside, dict):
        key = rng.choice((fuzz_words.text(rng, 8), rng.choice(("file", "kind", "radii", "count", "strength"))))
        inside[key] = fuzz_words.content(rng, tables)
    elif what == "part":
        other = rng.choice(tables)
        found = [key for key in places(other) if key[-1] == last] or places(other)
        part = other
        for key in rng.choice(found):
            part = part[key]
        inside[last] = copy.deepcopy(part)
    elif what == "list":
        again = 3 if isinstance(here, list) else rng.choice((0, 1, 2, 100))
        inside[last] = copy.deepcopy((here if isinstance(here, list) else [here]) * again)
    elif what == "section":
        study.update(_section(rng, tables, ".".join(map(str, (*outer, last)))))
    elif what == "deep":
        key = last if isinstance(inside, dict) and rng.random() < 0.5 else None
        for _ in range(rng.choice((1, 2, 12, 60))):
            here = [here] if key is None else {key: here}
        inside[last] = here
    else:
        inside[last] = fuzz_words.content(rng, tables)


def _section(rng: Random, tables: list[Any], key: str) -> dict[str, Any]:
    """Return a section beside the problem, of which something may be wrong."""
    made = {
        "sweep": lambda: {key: fuzz_words.content(rng, tables), "design": fuzz_words.content(rng, tables)},
        "fields": lambda: {rng.choice(("r", "z", "x")): fuzz_words.content(rng, tables)},
        "expect": lambda: [{"quantity": rng.choice((key, "depth", "force.-1")), "value": fuzz_words.leaf(rng),
                            "tolerance": fuzz_words.number(rng), "scale": fuzz_words.leaf(rng)}],
        "output": lambda: {"figures": fuzz_words.content(rng, tables), "report": fuzz_words.leaf(rng)},
        "title": lambda: fuzz_words.content(rng, tables),
        "grade": lambda: fuzz_words.leaf(rng),
    }  # fmt: skip
    name = rng.choice(list(made))
    section = made[name]()
    if name == "sweep" and rng.random() < 0.6:
        section = {key: [fuzz_words.leaf(rng) for _ in range(rng.randint(1, 3))]}
    return {name: section}


class Drawn:
    """How far numbers are moved, and which parts are swapped, in one study."""

    def __init__(self, rng: Random, wide: float, without: tuple[str, ...] = ()) -> None:
        self.rng, self.wide, self.without = rng, wide, without

    def varied(self, table: dict[str, Any], deep: int = 0) -> dict[str, Any]:
        """Return a kind's table with other numbers, lists and parts, each such as its class takes."""
        rng, line, table = self.rng, kinds()[table["kind"]], dict(table)
        rows = rng.choice(("keep", "keep", "keep", "first", "twice", "last", "each"))  # of lists that go together
        for field, hint in hints(line.cls).items():
            allowed, listed = allowed_kinds(hint), allowed_in_list(hint)
            here = table.get(field)
            if allowed:
                if deep < DEEPEST and rng.random() < (0.25 if here is not None else 0.05):
                    here = self.part(allowed) or here
                if here is not None:
                    table[field] = self.varied(here, deep + 1)
            elif listed and here is not None:
                parts = [self.varied(part, deep + 1) for part in here if isinstance(part, dict)]
                if deep < DEEPEST and rng.random() < 0.3 and (new := self.part(listed)) is not None:
                    new = self.varied(new, deep + 1)
                    parts = rng.choice(([*parts, new], [new, *parts], parts[1:], [new]))
                table[field] = parts[:LONGEST]
            elif here is not None:
                table[field] = self.other(here, rows)
            elif rng.random() < 0.1 and (unit := quantities.unit_of(line.cls, field)) is not None:
                such = {int: rng.randint(1, 12), bool: True, str: "x"}.get(hint, quantities.sample(unit))
                table[field] = self.other(such, rows)
        if line.cls.__module__ == "winkler.loading.path_steps" and isinstance(
            cycles := table.get("cycles"), float | str
        ):
            table["cycles"] = MARCHED_CYCLES if MARCHED_CYCLES < float(cycles) < REFUSED_CYCLES else cycles
        return table

    def part(self, allowed: tuple[str, ...]) -> dict[str, Any] | None:
        """Return an example of one of the kinds that may stand somewhere."""
        left = [name for name in allowed if name not in self.without]
        return completed({"kind": self.rng.choice(left)}) if left else None

    def other(self, here: Any, rows: str) -> Any:
        """Return a number, a list, a range or a text near what stands there."""
        rng = self.rng
        if isinstance(here, bool):
            return rng.random() < 0.5
        if isinstance(here, int):
            return rng.choice((here, here, 1, 2, 3, 5, 8, 16)) if here <= 32 else rng.randint(8, 32)
        if isinstance(here, float):
            usual = 0.0 < here < 1.0 and rng.random() < 0.95  # a ratio that has an end, as Poisson's
            return here if rng.random() < 0.5 else here * (rng.uniform(0.0, 1.6) if usual else self.factor())
        if isinstance(here, str):
            amount = AMOUNT.fullmatch(here)
            if amount is None:
                return rng.choice(FORMULAS) if "r**" in here else here
            return here if rng.random() < 0.4 else self.scaled(here, self.factor())
        if isinstance(here, dict):
            if "count" in here:
                factor = self.factor()
                return {
                    key: self.scaled(inside, factor) if key in ("from", "to") else inside
                    for key, inside in here.items()
                } | {"count": rng.randint(1, LONGEST) if rows != "keep" else here["count"]}
            return {key: self.other(inside, rows) for key, inside in here.items()}
        if isinstance(here, list):
            return self.row(here, rows)
        return here

    def row(self, here: list[Any], rows: str) -> list[Any]:
        """Return a list with all its numbers moved alike, or each, or some taken away, as all lists beside it."""
        factor = self.factor()
        if rows == "each":
            return [self.other(inside, rows) for inside in here]
        moved = [self.scaled(inside, factor) for inside in here]
        if self.rng.random() < 0.05:
            self.rng.shuffle(moved)
        return {"first": moved[:-1], "last": moved[-1:], "twice": moved + moved[-1:]}.get(rows, moved) or moved

    def scaled(self, here: Any, factor: float) -> Any:
        """Return a quantity times a factor; whatever else it is, as it is."""
        if isinstance(here, str) and (amount := AMOUNT.fullmatch(here)):
            return f"{float(amount[1]) * factor!r}{amount[2]}"
        return here * factor if isinstance(here, float) and here > 1.0 else here

    def factor(self) -> float:
        """Return what a number is multiplied by: mostly near one, rarely at an edge."""
        rng, what = self.rng, self.rng.random()
        if what < 0.75 or not self.wide:
            return float(10.0 ** rng.uniform(-0.5, 0.5))
        if what < 0.95:
            return float(10.0 ** rng.uniform(-self.wide, self.wide))
        return rng.choice((0.0, -1.0, 1.0, 1e20, 1e-20, 1e9, 1e-9))


LASTING = ("coated_half_space", "depth_graded_half_space", "sum", "measured_bed")
"""Parts whose answers take long where numbers are far from each other; they are moved a little only."""
MARCHING = (
    *("viscoelastic_adhesion", "fretting_wear", "sliding_wear", "line_fretting_wear", "line_sliding_wear"),
    "surface_wear",
)
"""Problems that take long on such parts, or with numbers far from each other, while they tell how far they are."""


def solvable(rng: Random, problem: str) -> dict[str, Any]:
    """Return a study of a problem to be solved: a variation of one of the examples that state it."""
    known = [study["problem"] for study in examples().values() if study["problem"]["kind"] == problem]
    chosen = rng.choice([table for table in known if problem not in MARCHING or not _lasts(table)])
    wide = 0.0 if problem in MARCHING or _lasts(chosen) or rng.random() < 0.05 else rng.choice((0.0, 1.0, 4.0))
    made = Drawn(rng, wide, LASTING if wide or problem in MARCHING else ()).varied(copy.deepcopy(chosen))
    if (wide or problem in MARCHING) and _lasts(made):  # an example of a part brought one with it
        made = Drawn(rng, 0.0).varied(copy.deepcopy(chosen))
    return {"title": problem, "problem": made}


def _lasts(table: dict[str, Any]) -> bool:
    return any(f"'{name}'" in str(table) for name in LASTING)
