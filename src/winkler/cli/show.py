"""``winkler show``: what a kind takes, with units, ranges and an example."""

from __future__ import annotations

from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from winkler.cli.options import completion
from winkler.cli.streams import until_closed, write_json, write_line

if TYPE_CHECKING:
    from winkler.study.finding.finding import SearchResult

OF_A_FILE = "Of measured files"
OF_A_SURFACE = "Of a height map or a line scan"


def _names() -> Iterable[str]:
    from winkler.study.language.catalogue import CATALOGUE, kinds

    return ("study", "fit", "nanoindentation", "materials", *CATALOGUE, *kinds())


def show(
    words: Annotated[
        list[str] | None,
        typer.Argument(
            help="A kind, a group, a material, 'study', 'fit', 'nanoindentation' or 'materials'; measured files "
            "or folders of them; or what you look for, in your own words.",
            autocompletion=completion(_names),
            show_default=False,
        ),
    ] = None,
    as_json: Annotated[bool, typer.Option("--json", help="Show it as JSON.")] = False,
    unit: Annotated[str, typer.Option(help="Unit of its heights, such as nm.", rich_help_panel=OF_A_SURFACE)] = "",
    lengths: Annotated[
        str, typer.Option(help="Its lengths, such as '10 um, 5 um'.", rich_help_panel=OF_A_SURFACE)
    ] = "",
    channel: Annotated[
        str, typer.Option(help="Which of its channels or measurements.", rich_help_panel=OF_A_SURFACE)
    ] = "",
    periodic: Annotated[
        bool, typer.Option("--periodic", help="The map is periodic.", rich_help_panel=OF_A_SURFACE)
    ] = False,
    tip_radius: Annotated[
        str, typer.Option(help="Radius of the tip that has scanned it, such as '10 nm'.", rich_help_panel=OF_A_SURFACE)
    ] = "",
    without_spikes: Annotated[
        bool,
        typer.Option(
            "--without-spikes", help="Take grains and scars out, and bridge them.", rich_help_panel=OF_A_SURFACE
        ),
    ] = False,
    detrend: Annotated[
        str, typer.Option(help="What is subtracted: none, mean, plane or paraboloid.", rich_help_panel=OF_A_SURFACE)
    ] = "none",
    levelled: Annotated[
        str,
        typer.Option(
            help="What is subtracted from each scan line: none, median, differences, line or parabola.",
            rich_help_panel=OF_A_SURFACE,
        ),
    ] = "none",
    lines_along: Annotated[
        str, typer.Option(help="Direction of the scan lines: x or y.", rich_help_panel=OF_A_SURFACE)
    ] = "x",
    output: Annotated[
        Path | None,
        typer.Option(
            "--output", "-o", help="Picture of a map, scan or curve: .png, .svg or .pdf.", rich_help_panel=OF_A_FILE
        ),
    ] = None,
    write: Annotated[
        Path | None,
        typer.Option("--write", "-w", help="A study to start from, .toml, with this file.", rich_help_panel=OF_A_FILE),
    ] = None,
    overwrite: Annotated[
        bool,
        typer.Option(
            "--overwrite", "--yes", "-y", help="Replace an existing picture or study.", rich_help_panel=OF_A_FILE
        ),
    ] = False,
) -> None:
    r"""Show keys, units, ranges and an example of a kind; or find the kind for a word or a question.

    Without a name, all kinds are listed; 'study' shows the sections of a study file, 'fit' those of `winkler fit` with
    its models, corrections and flags, 'nanoindentation' the sections \[indentation], \[calibration] and \[indenter],
    'materials' the table of common materials, and the name of a material its numbers and their sources.

    Other words, in English, German or French, are searched for: what comes nearest is listed, the best first, and what
    winkler does not cover is said.

    Of a measured file it shows how it is read and why, the range of each column, what was done (segments, events,
    touch, drift), what is doubtful, and of a map or a scan its statistics; --write writes a study to start from. Many
    files, or a folder, make a list with a row for each.

    Example: winkler show does my gasket leak
    """
    from winkler.cli import materials, show_file, show_fit, show_nanoindentation
    from winkler.study.language.catalogue import CATALOGUE, FORMER, REFUSED, kinds
    from winkler.values.errors import InvalidInput

    name = " ".join(words or ())
    if name in FORMER and not as_json:
        write_line(f'{name} is a kind of version 0.2: studies with it still run; write kind = "{FORMER[name]}".')
    name = FORMER.get(name, name)
    stated = (unit, lengths, channel, periodic, tip_radius, without_spikes, detrend, levelled, lines_along)
    prepared = stated != ("", "", "", False, "", False, "none", "none", "x")
    if paths := show_file.files_named(words or []):
        from winkler.study.inspection.surfaces import SurfaceOptions

        options = SurfaceOptions(*stated) if prepared else None
        show_file.show_files(paths, options, show_file.ShownFile(output, write, overwrite, as_json))
        return
    if prepared or output is not None or write is not None:
        raise InvalidInput(
            f"'{name}' is not the path of a file, which has a dot or a slash; options other than --json are "
            "for measured files: give the path of one, or leave them out."
        )
    # a word may name a group and a kind (force is one, load the other): the kind is meant, groups have no kind's name
    if as_json and name == "fit":
        write_json(show_fit.fit_json())
    elif as_json and name == "nanoindentation":
        write_json(show_nanoindentation.nanoindentation_json())
    elif as_json and (not name or name in kinds()):
        _json(name)
    elif name in kinds():
        _kind(name)
    elif name == "study":
        _study()
    elif name == "fit":
        show_fit.show_fit()
    elif name == "nanoindentation":
        show_nanoindentation.show_nanoindentation()
    elif name == "materials":
        from winkler.materials.named import material_names

        materials.several(material_names())
    elif not name or name in CATALOGUE:
        _list(name)
    elif name in REFUSED:
        REFUSED[name].cls(1.0)
    else:
        _search(name, as_json=as_json)


def _search(text: str, *, as_json: bool) -> None:
    """Show a material, those that share a name, or what comes nearest to words of the user's own."""
    from winkler.cli import materials
    from winkler.materials.named import SHORE, material, material_names, materials_called
    from winkler.study.finding.finding import find, materials_meant
    from winkler.values.errors import InvalidInput, mistyped, suggest

    called = materials_called(text) or materials_meant(text)
    try:
        entry = material(text)
    except InvalidInput:
        if SHORE.fullmatch(" ".join(text.lower().split())):
            raise
        if called and not as_json:
            materials.several(called)
            return
        found = find(text)
        if not found.hits:
            near = suggest(text, mistyped(text, [*_names(), *material_names()]))
            told = near or " and may not be covered"
            raise InvalidInput(f"'{text}' is not known{told}; `winkler show` lists every kind.") from None
        if as_json:
            write_json(found.table())
        else:
            _hits(text, found)
    else:
        materials.one(entry)


@until_closed()
def _hits(text: str, found: SearchResult) -> None:
    from winkler.cli import terminal

    out = terminal.console()
    out.print(f"{found.remark} Nearest to '{text}', the best first:".lstrip())
    table = terminal.table("group", "kind", "what it is", "shown by")
    for hit in found.hits:
        table.add_row(hit.group, hit.name, hit.meaning, hit.command)
    out.print(table)


@until_closed()
def _list(only: str) -> None:
    from winkler.cli import terminal
    from winkler.study.language.catalogue import CATALOGUE
    from winkler.study.language.explain import summary

    table = terminal.table("group", "kind", "what it is")
    for slot, lines in CATALOGUE.items():
        if only in ("", slot):
            for number, (name, line) in enumerate(lines.items()):
                table.add_row("" if number else slot, name, summary(line.cls))
            table.add_section()
    out = terminal.console()
    out.print(table)
    out.print("`winkler show KIND` shows the keys of a kind, `winkler show study` what a study file may contain.")
    out.print("`winkler show fit` and `winkler show nanoindentation` show what is evaluated from measured curves.")


@until_closed()
def _kind(name: str) -> None:
    from winkler.cli import terminal
    from winkler.study.chapters.contents import answers
    from winkler.study.language.catalogue import kinds, slot_of
    from winkler.study.language.explain import keys_of, plain_symbol, summary
    from winkler.study.language.reading import parse_study
    from winkler.study.language.template import example_text, whole_text
    from winkler.study.report.citing import cite

    out = terminal.console()
    out.print(f"{name} (a {slot_of(name)}): {summary(kinds()[name].cls)}")
    if name in answers():
        out.print(f"It answers: {answers()[name].question}")
    rows = keys_of(name)
    if rows:
        table = terminal.table("key", "symbol", "takes", "meaning", "range", "")
        for key in rows:
            need = "required" if key.required else "optional"
            table.add_row(key.name, plain_symbol(key.word.symbol), key.takes, key.word.meaning, key.range, need)
        out.print(table)
    else:
        out.print("It has no keys.\n")
    out.print("Example:\n")
    out.print(example_text(name), soft_wrap=True)
    papers = cite(parse_study(whole_text(name)).problem)
    mine = [
        paper.text
        for paper in papers
        if paper.key in (*kinds()[name].cites, *getattr(kinds()[name].cls, "references", ()))
    ]
    for text in mine:
        out.print(f"See {text}", soft_wrap=True)


@until_closed()
def _study() -> None:
    from winkler.cli import terminal
    from winkler.study.language.grammar import SECTIONS

    table = terminal.table("section", "key", "meaning")
    for section, rows in SECTIONS.items():
        for number, (key, meaning) in enumerate(rows.items()):
            table.add_row("" if number else section, key, meaning)
        table.add_section()
    terminal.console().print(table)


def _json(name: str) -> None:
    from winkler.study.chapters.contents import answers
    from winkler.study.language.catalogue import kinds, slot_of
    from winkler.study.language.explain import completed, keys_of, summary

    content = [
        {
            "kind": kind,
            "group": slot_of(kind),
            "meaning": summary(line.cls),
            "question": answers()[kind].question if kind in answers() else "",
            "keys": [
                {
                    "key": key.name,
                    "symbol": key.word.symbol,
                    "unit": key.word.unit,
                    "takes": key.takes,
                    "meaning": key.word.meaning,
                    "range": key.range,
                    "required": key.required,
                }
                for key in keys_of(kind)
            ],
            "example": completed({"kind": kind}),
        }
        for kind, line in kinds().items()
        if name in ("", kind)
    ]
    write_json({"kinds": content})
