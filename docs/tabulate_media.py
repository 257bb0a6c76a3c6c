"""Write the table of media and problems in docs/choosing.md from what the package answers.

Run ``python docs/tabulate_media.py`` (some minutes) after a problem, a medium or a note on validity was added; tests
compare the page with what this would write.  The problem of each cell is the example of its kind in the catalogue, with
the medium in place of its own.
"""

from __future__ import annotations

import functools
import re
from pathlib import Path
from typing import NamedTuple

import winkler as wk
from winkler.study.language.build import build
from winkler.study.language.catalogue import CATALOGUE
from winkler.study.language.explain import example_study
from winkler.validity import Assumption, Note, Standing

PAGE = Path(__file__).resolve().parent / "choosing.md"
BEGIN, END = "<!-- media: begin -->", "<!-- media: end -->"
OF_METHOD = {
    Assumption.RESPONSE,
    Assumption.SINGLE_CONTACT,
    Assumption.SLIP,
    Assumption.ADHESION,
    Assumption.CALIBRATION,
    Assumption.STEADY,
    Assumption.CONDUCTION,
    Assumption.WEAR,
    Assumption.ROUGHNESS,
}
"""What belongs to a method on a medium; the other assumptions depend on the numbers of a case."""
NO_PLACE = "–"
TAKEN = "taken"
LONG = {
    "adhesive_impact",
    "joint_stiffness",
    "line_viscoelastic_indentation",
    "profile_pair_rolling",
    "reduced_friction",
    "reduction",
    "rolling_start",
    "seal",
    "simplified_rolling",
    "sliding_resistance",
    "sliding_wear",
    "surface_adhesion",
    "surface_conduction",
    "surface_rolling",
    "surface_rolling_heating",
    "surface_rolling_start",
    "surface_tangential",
    "surface_wear",
    "thermal_joint",
    "transient_heating",
    "viscoelastic_adhesion",
    "viscoelastic_impact",
    "viscoelastic_indentation",
    "viscoelastic_tangential",
}
"""Kinds whose examples take seconds: it is stated which media they take, not how exactly."""


class Cell(NamedTuple):
    """One of "exact", "approximate", "refused", `NO_PLACE` and, where it is not solved, `TAKEN`; and why."""

    word: str
    why: str = ""


@functools.cache
def made(kind: str, medium: str) -> tuple[Cell, object]:
    """Return what can be said before the problem is solved, and the problem."""
    try:
        table = example_study(kind, medium=medium)["problem"]
    except wk.WinklerError:
        return Cell(NO_PLACE), None
    try:
        if kind == "yield_onset" and medium == "coated_half_space":  # its example has no strength
            table["bed"]["medium"]["layers"][0]["solid"]["strength"] = "2 GPa"
        return Cell(TAKEN), build(table)
    except wk.WinklerError as error:
        return Cell("refused", reason(str(error), medium)), None


def cell(kind: str, medium: str) -> Cell:
    """Return a cell of the table."""
    before, problem = made(kind, medium)
    if problem is None or kind in LONG:
        return before
    try:
        notes = problem.solve().validity
    except wk.WinklerError as error:
        return Cell("refused", reason(str(error), medium))
    order = list(Standing)
    worst = [note for note in notes if of_method(note) and note.standing in order[2:]]
    if not worst:
        return Cell("exact")
    note = max(worst, key=lambda each: order.index(each.standing))
    return Cell("approximate", reason(note.statement, medium))


def of_method(note: Note) -> bool:
    """Return whether a note is on the method, not on the numbers of the example."""
    ranged = note.assumption is Assumption.ADHESION and "Tabor" in note.statement
    return note.assumption in OF_METHOD and not ranged


def reason(sentence: str, medium: str) -> str:
    """Return a sentence without the names of problem and medium, so that equal reasons are equal."""
    sentence = re.sub(r"^(problem[\w.]*: )?([A-Z]\w+: )?", "", sentence)
    name = CATALOGUE["medium"][medium].path.rpartition(":")[2]
    sentence = re.sub(rf"\b(an? )?{name}\b(?!\()", "this medium", sentence, count=1)
    sentence = re.sub(r"^[Tt]he (medium of the )?bed (is|stands on) this medium; ", "", sentence)
    sentence = re.sub(r"^[Tt]he medium( of the bed)? is this medium; ", "", sentence)
    return sentence[0].upper() + sentence[1:].rstrip(".") + "."


def topic(sentence: str) -> str:
    """Return a reason without its numbers, which are those of the example."""
    return re.sub(r"[-+]?\d[-+.\de]*", "#", sentence)


def columns() -> tuple[list[str], list[str]]:
    """Return the media that do not relax, and those that do."""
    media = list(CATALOGUE["medium"])
    elastic = [medium for medium in media if made("indentation", medium)[0].word == TAKEN]
    return elastic, [medium for medium in media if medium not in elastic]


def rows(media: list[str]) -> list[str]:
    """Return the kinds of problems that one of these media suits."""
    return [kind for kind in CATALOGUE["problem"] if any(made(kind, medium)[0].word == TAKEN for medium in media)]


def section() -> str:
    """Return the tables and their notes."""
    whys: list[str] = []
    lines: list[str] = []
    for media in columns():
        lines += ["", "| kind of problem | " + " | ".join(f"`{medium}`" for medium in media) + " |"]
        lines += ["|---" * (len(media) + 1) + "|"]
        for kind in rows(media):
            words = []
            for medium in media:
                found = cell(kind, medium)
                if found.why and topic(found.why) not in map(topic, whys):
                    whys.append(found.why)
                number = [topic(why) for why in whys].index(topic(found.why)) + 1 if found.why else 0
                words.append(f"{found.word} ({number})" if number else found.word)
            print(kind, *words)
            lines.append(f"| `{kind}` | " + " | ".join(words) + " |")
    notes = [f"{number}. {why}" for number, why in enumerate(whys, 1)]
    return "\n".join([BEGIN, *lines, "", *notes, "", END])


def stated() -> dict[tuple[str, str], Cell]:
    """Return the cells that stand on the page."""
    text = PAGE.read_text(encoding="utf-8")
    text = text[text.index(BEGIN) : text.index(END)]
    whys = dict(re.findall(r"^(\d+)\. (.*)$", text, re.MULTILINE))
    cells: dict[tuple[str, str], Cell] = {}
    media: list[str] = []
    for line in re.findall(r"^\|(.*)\|$", text, re.MULTILINE):
        first, *others = (part.strip().strip("`") for part in line.split("|"))
        if first == "kind of problem":
            media = others
        elif first in CATALOGUE["problem"]:
            for medium, content in zip(media, others, strict=True):
                word, _, number = content.partition(" (")
                cells[first, medium] = Cell(word, whys[number.rstrip(")")] if number else "")
    return cells


if __name__ == "__main__":
    page = PAGE.read_text(encoding="utf-8")
    before, after = page.index(BEGIN), page.index(END) + len(END)
    PAGE.write_text(page[:before] + section() + page[after:], encoding="utf-8")
