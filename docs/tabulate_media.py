"""Write the table of media and problems in docs/choosing.md from what the package answers.

Run ``python docs/tabulate_media.py`` (a minute) after a problem, a medium or a note on validity was added; tests
compare the page with what this would write.  The problem of each cell is the example of its kind in the catalogue, with
the medium in place of its own and what docs/media/examples.toml changes.
"""

from __future__ import annotations

import functools
import re
import tomllib
from fnmatch import fnmatch
from pathlib import Path
from typing import Any, NamedTuple

import winkler as wk
from winkler.problems.surface_friction.notes import UNCOUPLED_LAYERS
from winkler.study.language.build import build
from winkler.study.language.catalogue import CATALOGUE
from winkler.study.language.explain import example_study, table_at
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
"""What belongs to a method on a medium, as coupling does for maps on layers; others depend on the numbers of a case."""
SHORT = tomllib.loads((PAGE.parent / "media" / "examples.toml").read_text(encoding="utf-8"))
"""How examples differ from those of the catalogue, to be short; why kinds of problems have no place for media."""
TAKEN = "taken"
NO_PLACE = "no place"


class Cell(NamedTuple):
    """One of "exact", "approximate" and "refused", with the reasons; before it is solved, `TAKEN` or `NO_PLACE`."""

    word: str
    whys: tuple[str, ...] = ()


def example(kind: str, medium: str) -> dict[str, Any]:
    """Return the study of a cell: the example of the kind on that medium, with what `SHORT` changes."""
    table: dict[str, Any] = example_study(kind, medium=medium)["problem"]
    changes = SHORT["changed"].get(kind, {}) | SHORT["changed_on"].get(medium, {}).get(kind, {})
    for key, content in changes.items():
        place, _, last = key.rpartition(".")
        (table_at(table, place) if place else table)[last] = content
    return table


@functools.cache
def made(kind: str, medium: str) -> tuple[Cell, object]:
    """Return what can be said before the problem is solved, and the problem."""
    try:
        table = example(kind, medium)
    except wk.WinklerError:
        return Cell(NO_PLACE), None
    try:
        return Cell(TAKEN), build(table)
    except wk.WinklerError as error:
        return Cell("refused", (reason(str(error), medium),)), None


def cell(kind: str, medium: str) -> Cell:
    """Return a cell of the table."""
    before, problem = made(kind, medium)
    if before.word == NO_PLACE:
        return Cell("refused", (reason_of_no_place(kind, medium),))
    if problem is None:
        return before
    try:
        stated = problem.solve().validity  # type: ignore[attr-defined]
    except wk.NotConverged:  # of this example: no word about the medium
        raise
    except wk.WinklerError as error:
        return Cell("refused", (reason(str(error), medium),))
    counted = kind in SHORT["known_by_their_grid"]
    notes = [note for note in stated if of_method(note) or (counted and note.assumption is Assumption.RESOLUTION)]
    if kind not in SHORT["partly_outside"] and any(note.standing is Standing.OUTSIDE for note in notes):
        raise ValueError(f"{kind} on {medium}: its example is outside the validity of the method, take another.")
    if not notes:
        raise ValueError(f"{kind} on {medium}: its validity does not say how exact the method is; give it a note.")
    whys = [reason(note.statement, medium) for note in notes if note.standing is not Standing.EXACT]
    return Cell("approximate" if whys else "exact", tuple(dict.fromkeys(whys)))


def reason_of_no_place(kind: str, medium: str) -> str:
    """Return why a kind of problem has no place for a medium, as stated in `SHORT`."""
    for row in SHORT["no_place"]:
        if any(fnmatch(kind, pattern) for pattern in row["problems"]) and medium in row["media"]:
            return str(row["why"])
    raise ValueError(f"docs/media/examples.toml does not say why {kind} has no place for {medium}.")


def of_method(note: Note) -> bool:
    """Return whether a note is on the method, not on the numbers of the example."""
    ranged = note.assumption is Assumption.ADHESION and "Tabor" in note.statement
    return (note.assumption in OF_METHOD or note == UNCOUPLED_LAYERS) and not ranged


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
                whys += [why for why in found.whys if topic(why) not in map(topic, whys)]
                topics = [topic(why) for why in whys]
                numbers = ", ".join(str(topics.index(topic(why)) + 1) for why in found.whys)
                words.append(f"{found.word} ({numbers})" if numbers else found.word)
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
                word, _, numbers = content.partition(" (")
                cells[first, medium] = Cell(word, tuple(whys[number] for number in re.findall(r"\d+", numbers)))
    return cells


if __name__ == "__main__":
    page = PAGE.read_text(encoding="utf-8")
    before, after = page.index(BEGIN), page.index(END) + len(END)
    PAGE.write_text(page[:before] + section() + page[after:], encoding="utf-8")
