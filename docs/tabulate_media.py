"""Write the table of media and problems in docs/choosing.md from docs/media/cells.toml, and that file from answers.

The questions in docs/choosing.md and the list of all kinds in docs/study-files.md are written from the records and the
catalogue at each call.

After a problem, a medium or a note on validity was added or changed, ask the package for the cells concerned; a kind
takes some seconds, a medium up to a minute::

    python docs/tabulate_media.py --kinds line_tangential,line_constriction
    python docs/tabulate_media.py --media coated_half_space
    python docs/tabulate_media.py --all                            # some minutes

Each call writes the pages as well; without an option it writes the pages alone, and solves nothing.  Words, notes and
texts of notes follow the answers.  Reasons of refused cells are written by hand, and kept: each refused cell has one,
of its note or its own, from ``[physical]`` (nothing would open it) or ``[opens]`` (what would open it).  A cell whose
kind has no place for its medium has a note from ``[no_place]``, also written by hand.  What is still to be written is
printed, and tests demand it.  What no cell needs any more is removed.

The problem of each cell is the example of its kind in the catalogue, with the medium in place of its own and what
docs/media/examples.toml changes.
"""

from __future__ import annotations

import argparse
import dataclasses
import functools
import json
import re
import tomllib
from collections.abc import Collection
from pathlib import Path
from typing import Any, NamedTuple

import winkler as wk
from winkler.problems.surface_friction.notes import UNCOUPLED_LAYERS
from winkler.study.chapters.contents import answers
from winkler.study.language.build import build
from winkler.study.language.catalogue import CATALOGUE
from winkler.study.language.explain import example_study, table_at
from winkler.study.language.schema import required_fields
from winkler.values.validity import Assumption, Note, Standing

PAGE = Path(__file__).resolve().parent / "choosing.md"
BEGIN, END = "<!-- media: begin -->", "<!-- media: end -->"
QUESTIONS = "<!-- problems: begin -->", "<!-- problems: end -->"
STUDIES = PAGE.with_name("study-files.md")
KINDS_HEAD = "| group | kinds |\n|---|---|\n"
CELLS = PAGE.parent / "media" / "cells.toml"
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
"""How examples differ from those of the catalogue, to be short."""
TAKEN = "taken"
NO_PLACE = "no place"
HEAD = """\
# Which problem answers on which medium, and how: the table of docs/choosing.md, one line a cell.
#
# exact: the assumptions of the method, of which notes on validity say that they hold; approximate, refused: keys of
# notes.  A refused cell has the reason of its note, or its own: physical, or what would open it.  `python
# docs/tabulate_media.py --kinds KIND,...` writes this file from what the package answers, and keeps what is written by
# hand: [physical], [opens], [no_place], each `reason`, and the names of notes.
"""


class Cell(NamedTuple):
    """A word with what it rests on, and the key of a reason of its own for which it is refused.

    Before the problem is solved the word is `TAKEN` or `NO_PLACE`.  What it rests on: assumptions if it is exact, else
    statements, of which cells.toml keeps the keys.
    """

    word: str
    rests: tuple[str, ...] = ()
    reason: str = ""


class Cells(NamedTuple):
    """What cells.toml states; of notes the text and the reason by key, of cells one for each kind and medium."""

    physical: dict[str, str]
    opens: dict[str, str]
    no_place: dict[str, dict[str, str]]
    stated: dict[str, dict[str, str]]
    cells: dict[tuple[str, str], Cell]

    @property
    def notes(self) -> dict[str, dict[str, str]]:
        """All notes by key."""
        return self.stated | self.no_place

    def agrees(self, cell: Cell, found: Cell) -> bool:
        """Return whether a cell states what was found, but for numbers; if taken, whether it can be so."""
        if found.word in {NO_PLACE, TAKEN}:
            placeless = cell.word == "refused" and bool(cell.rests) and set(cell.rests) <= set(self.no_place)
            return placeless == (found.word == NO_PLACE)
        notes = () if cell.word == "exact" else cell.rests
        texts = [self.stated[key]["text"] if key in self.stated else "" for key in notes] or cell.rests
        return cell.word == found.word and set(map(topic, texts)) == set(map(topic, found.rests))

    def reason(self, cell: Cell) -> str:
        """Return the key of the reason of a refused cell, empty if there is none yet."""
        return cell.reason or next((self.notes[key].get("reason", "") for key in cell.rests), "")

    def media(self) -> tuple[list[str], list[str]]:
        """Return the media that do not relax, and those that do."""
        found = [medium for medium in CATALOGUE["medium"] if any(column == medium for _, column in self.cells)]
        elastic = [medium for medium in found if ("indentation", medium) in self.cells]
        return elastic, [medium for medium in found if medium not in elastic]

    def kinds(self, media: Collection[str]) -> list[str]:
        """Return the kinds of problems that have a row in the table of these media."""
        return [kind for kind in CATALOGUE["problem"] if any((kind, medium) in self.cells for medium in media)]


def read() -> Cells:
    """Return what stands in cells.toml."""
    table = tomllib.loads(CELLS.read_text(encoding="utf-8"))
    cells = {}
    for kind, row in table["cells"].items():
        for medium, content in row.items():
            own = content.pop("reason", "")
            ((word, keys),) = content.items()
            cells[kind, medium] = Cell(word, tuple(keys), own)
    return Cells(table["physical"], table["opens"], table["no_place"], table["stated"], cells)


def written(table: Cells) -> str:
    """Return the text of cells.toml, without what no cell needs."""
    used = {key for cell in table.cells.values() if cell.word != "exact" for key in cell.rests}
    reasons = {table.reason(cell) for cell in table.cells.values() if cell.word == "refused"}
    reasons |= {note.get("reason", "") for key, note in table.notes.items() if key in used}
    lines = [HEAD]
    for name, texts in (("physical", table.physical), ("opens", table.opens)):
        kept = {key: text for key, text in texts.items() if key in reasons}
        lines += [f"[{name}]", *(f"{key} = {quoted(text)}" for key, text in kept.items()), ""]
    for name, notes in (("no_place", table.no_place), ("stated", table.stated)):
        lines += [f"[{name}]", ""]
        for key in sorted(used & set(notes)):
            lines += [f"[{name}.{key}]", *(f"{word} = {quoted(text)}" for word, text in notes[key].items()), ""]
    for kind in CATALOGUE["problem"]:
        row = {medium: table.cells[kind, medium] for medium in CATALOGUE["medium"] if (kind, medium) in table.cells}
        if row:
            lines += [f"[cells.{kind}]"]
            for medium, cell in row.items():
                own = f", reason = {quoted(cell.reason)}" if cell.reason else ""
                lines.append(f"{medium} = {{ {cell.word} = [{', '.join(map(quoted, cell.rests))}]{own} }}")
            lines.append("")
    return "\n".join(lines)


def quoted(text: str) -> str:
    """Return a text as TOML writes it."""
    return json.dumps(text, ensure_ascii=False)


def example(kind: str, medium: str) -> dict[str, Any]:
    """Return the study of a cell: the example of the kind on that medium, with what `SHORT` changes."""
    table: dict[str, Any] = example_study(kind, medium=medium)["problem"]
    usual, here = SHORT["changed"].get(kind, {}), SHORT["changed_on"].get(medium, {}).get(kind, {})
    for key, content in (usual | here).items():
        place, _, last = key.rpartition(".")
        if holds(table, place):
            (table_at(table, place) if place else table)[last] = content
        elif key in here or not holds(example_study(kind)["problem"], place):  # some media have another contact
            raise ValueError(f"examples.toml: the example of {kind} on {medium} has no {place!r}; correct {key!r}.")
    return table


def holds(table: dict[str, Any], place: str) -> bool:
    """Return whether a study has a table at a place."""
    try:
        return not place or bool(table_at(table, place))
    except KeyError:
        return False


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
        return Cell("refused", (plain(str(error), medium),)), None


def answer(kind: str, medium: str) -> Cell:
    """Return what the package answers in a cell."""
    before, problem = made(kind, medium)
    if problem is None:
        return before
    try:
        stated = problem.solve().validity  # type: ignore[attr-defined]
    except wk.NotConverged:  # of this example: no word about the medium
        raise
    except wk.WinklerError as error:
        return Cell("refused", (plain(str(error), medium),))
    if undeclared := {note.assumption for note in stated} - type(problem).assumptions:  # type: ignore[attr-defined]
        raise ValueError(f"{kind} on {medium}: it has notes on {undeclared}, which are not among its assumptions.")
    counted = kind in SHORT["known_by_their_grid"]
    notes = [note for note in stated if of_method(note) or (counted and note.assumption is Assumption.RESOLUTION)]
    if kind not in SHORT["partly_outside"] and any(note.standing is Standing.OUTSIDE for note in notes):
        raise ValueError(f"{kind} on {medium}: its example is outside the validity of the method, take another.")
    if not notes:
        raise ValueError(f"{kind} on {medium}: its validity does not say how exact the method is; give it a note.")
    whys = [plain(note.statement, medium) for note in notes if note.standing is not Standing.EXACT]
    if whys:
        return Cell("approximate", tuple(dict.fromkeys(whys)))
    names = {note.assumption for note in notes}
    return Cell("exact", tuple(assumption.name.lower() for assumption in Assumption if assumption in names))


def of_method(note: Note) -> bool:
    """Return whether a note is on the method, not on the numbers of the example."""
    ranged = note.assumption is Assumption.ADHESION and "Tabor" in note.statement
    return (note.assumption in OF_METHOD or note == UNCOUPLED_LAYERS) and not ranged


def plain(sentence: str, medium: str) -> str:
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


def places() -> list[tuple[str, str]]:
    """Return kind and medium of each cell; media that relax have a table of their own."""
    media = list(CATALOGUE["medium"])
    elastic = [medium for medium in media if made("indentation", medium)[0].word == TAKEN]
    relaxing = [medium for medium in media if medium not in elastic]
    return [
        (kind, medium)
        for kind in CATALOGUE["problem"]
        for group in (elastic, relaxing)
        if any(made(kind, medium)[0].word == TAKEN for medium in group)
        for medium in group
    ]


def updated(table: Cells, kinds: Collection[str], media: Collection[str]) -> Cells:
    """Return what cells.toml is to state once the cells of these kinds on these media were asked."""
    texts, cells, before = dict(table.stated), {}, set()
    for place in places():
        old = table.cells.get(place, Cell("refused"))
        if place[0] in kinds and place[1] in media:
            found = answer(*place)
            print(*place, found.word)
            if found.word == NO_PLACE:
                cells[place] = old if table.agrees(old, found) else Cell("refused")
            elif found.word == "exact":
                cells[place] = found
            else:
                keys = tuple(dict.fromkeys(key_of(why, texts, before) for why in found.rests))
                cells[place] = Cell(found.word, keys, old.reason if old[:2] == (found.word, keys) else "")
        elif place in table.cells:
            cells[place] = old
        before.update(cells[place].rests if place in cells else ())
    return Cells(table.physical, table.opens, table.no_place, texts, cells)


def key_of(why: str, texts: dict[str, dict[str, str]], before: set[str]) -> str:
    """Return the key of a statement; of those that differ in numbers the first in the table is the text of the note."""
    name = "_".join(re.findall(r"[a-z]+", why.lower())[:5])
    names = (name, *(f"{name}_{number}" for number in range(2, 99)))
    known = (key for key, note in texts.items() if topic(note["text"]) == topic(why))
    key = next(known, None) or next(one for one in names if one not in texts)
    if key not in before:
        texts[key] = texts.get(key, {}) | {"text": why}
        before.add(key)
    return key


def to_be_written(table: Cells) -> list[str]:
    """Return what is missing in cells.toml and can only be written by hand."""
    missing = []
    for (kind, medium), cell in table.cells.items():
        if cell.word == "refused" and not cell.rests:
            missing.append(f"{kind} on {medium} has no place for it: say why in a note of [no_place].")
        elif cell.word == "refused" and table.reason(cell) not in {*table.physical, *table.opens}:
            missing.append(
                f"{kind} on {medium} is refused: give it, or its note {cell.rests[0]}, a `reason` that stands in "
                "[physical] or [opens]."
            )
    return missing


def section(table: Cells) -> str:
    """Return the tables, their notes and what would open refused cells."""
    numbers: dict[str, int] = {}
    lines: list[str] = []
    for media in table.media():
        lines += ["", "| kind of problem | " + " | ".join(f"`{medium}`" for medium in media) + " |"]
        lines += ["|---" * (len(media) + 1) + "|"]
        for kind in table.kinds(media):
            words = []
            for medium in media:
                word, keys, _ = table.cells[kind, medium]
                led = [str(numbers.setdefault(key, len(numbers) + 1)) for key in keys if word != "exact"]
                words.append(f"{word} ({', '.join(led)})" if led else word)
            lines.append(f"| `{kind}` | " + " | ".join(words) + " |")
    notes = [f"{number}. {table.notes[key]['text']}" for key, number in numbers.items()]
    return "\n".join([BEGIN, *lines, "", *notes, "", *opening(table), "", END])


def refused(table: Cells, reasons: Collection[str]) -> list[tuple[str, str]]:
    """Return kind and medium of the cells that are refused for one of these reasons."""
    return [place for place, cell in table.cells.items() if cell.word == "refused" and table.reason(cell) in reasons]


def opening(table: Cells) -> list[str]:
    """Return the section of the page on why cells are refused."""
    open_cells, closed = refused(table, table.opens), refused(table, table.physical)
    lines = [
        "### Why problems are refused",
        "",
        f"The tables have {len(table.cells)} combinations of problem and medium (cells), of which "
        f"{len(open_cells) + len(closed)} are refused. {len(closed)} of these have a physical reason. For "
        f"{len(open_cells)} the required computation is not implemented.",
    ]
    for title, texts in (("not implemented", table.opens), ("physical reason", table.physical)):
        lines += ["", f"| {title} | cells | refused |", "|---|---|---|"]
        for key, text in texts.items():
            places = refused(table, [key])
            lines.append(f"| {text} | {len(places)} | {grouped(places)} |")
    return lines


def grouped(places: list[tuple[str, str]]) -> str:
    """Return cells as words: kinds that are refused on the same media together."""
    media: dict[str, tuple[str, ...]] = {}
    for kind, medium in places:
        media[kind] = (*media.get(kind, ()), medium)
    alike = {group: [kind for kind in media if media[kind] == group] for group in media.values()}
    return "; ".join(
        f"{', '.join(f'`{kind}`' for kind in kinds)} on {', '.join(f'`{medium}`' for medium in group)}"
        for group, kinds in alike.items()
    )


def page(table: Cells) -> str:
    """Return the text of the page with these cells."""
    text = PAGE.read_text(encoding="utf-8")
    for (begin, end), new in ((QUESTIONS, questions()), ((BEGIN, END), section(table))):
        text = text[: text.index(begin)] + new + text[text.index(end) + len(end) :]
    return text


def questions() -> str:
    """Return the table of what a user may ask, how the problem that answers is written, and where more is said."""
    lines = [QUESTIONS[0], "", "| question | how | page |", "|---|---|---|"]
    for record in answers().values():
        cls = record.kind.cls
        needed = required_fields(cls)
        more = ["..."] if len(needed) < len(dataclasses.fields(cls)) else []
        how = f"{cls.__name__}({', '.join([*needed, *more])})"
        lines.append(f"| {record.question} | `{how}` | [{heading(record.page)}]({record.page}) |")
    return "\n".join([*lines, "", QUESTIONS[1]])


def heading(place: str) -> str:
    """Return the title of a page, and the heading in it that an address names."""
    path, _, anchor = place.partition("#")
    text = re.sub(r"^```.*?^```$", "", (PAGE.parent / path).read_text(encoding="utf-8"), flags=re.MULTILINE | re.DOTALL)
    titles = [
        re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", title) for title in re.findall(r"^#{1,3} (.*)$", text, re.MULTILINE)
    ]
    anchors = {re.sub(r"[^\w -]", "", title).lower().replace(" ", "-"): title for title in titles}
    if anchor and anchor not in anchors:
        raise ValueError(f"{path} has no heading #{anchor}; it has {', '.join(anchors)}.")
    return f"{titles[0]}: {anchors[anchor][0].lower()}{anchors[anchor][1:]}" if anchor else titles[0]


def studies_page() -> str:
    """Return the text of the page on study files with the kinds of each slot; rows that stand keep their order."""
    above, head, rest = STUDIES.read_text(encoding="utf-8").partition(KINDS_HEAD)
    rows, _, below = rest.partition("\n\n")
    standing = [slot for slot in re.findall(r"^\| (\w+)", rows, re.MULTILINE) if slot in CATALOGUE]
    lines = [
        f"| {slot} | {' '.join(f'`{kind}`' for kind in CATALOGUE[slot])} |"
        for slot in dict.fromkeys([*standing, *CATALOGUE])
    ]
    return above + head + "\n".join(lines) + "\n\n" + below


def main() -> None:
    """Ask for the cells that the command line names, and write cells.toml and the pages."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    for slot, name in (("problem", "kinds"), ("medium", "media")):
        parser.add_argument(f"--{name}", type=lambda text: text.split(","), help=f"names of the slot {slot}, by commas")
    parser.add_argument("--all", action="store_true", help="ask for each cell")
    asked = parser.parse_args()
    known = list(CATALOGUE["problem"]), list(CATALOGUE["medium"])
    for given, names in zip((asked.kinds, asked.media), known, strict=True):
        if unknown := set(given or ()) - set(names):
            parser.error(f"not in the catalogue: {', '.join(sorted(unknown))}")
    table = read()
    if asked.all or asked.kinds or asked.media:
        table = updated(table, asked.kinds or known[0], asked.media or known[1])
        CELLS.write_text(written(table), encoding="utf-8")
        table = read()
    PAGE.write_text(page(table), encoding="utf-8")
    STUDIES.write_text(studies_page(), encoding="utf-8")
    print(*to_be_written(table), sep="\n")


if __name__ == "__main__":
    main()
