"""``winkler new`` and ``schema``: a commented study to begin with, and what editors complete and check it by."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Annotated

import typer

from winkler.cli.options import Overwrite, completion, refuse_existing
from winkler.cli.streams import write_line

ALSO = {"profile": ("section",), "bed": ("line_bed",), "load": ("line_load",)}
"""Further groups whose kinds an option takes."""


def _kinds(slot: str) -> Callable[[str], list[str]]:
    """Return the completion of the kinds of one group."""

    def names() -> Iterable[str]:
        from winkler.study.language.catalogue import CATALOGUE

        return [kind for group in (slot, *ALSO.get(slot, ())) for kind in CATALOGUE[group]]

    return completion(names)


def _meant(text: str, names: list[str]) -> str:
    """Return which of the names a word may mean, as the end of a clause, or an empty string."""
    from winkler.study.finding.finding import find
    from winkler.values.errors import mistyped, suggest

    found = find(text)
    near = [hit.name for hit in found.hits if hit.name in names][:3]
    if (meant := mistyped(text, names)) or not near:
        return suggest(text, meant)
    if (first := found.hits[0]).name not in names:
        return f" (the {first.group} '{first.name}' may be meant: `{first.command}`)"
    if found.remark:
        return f" ({found.remark.rstrip('.')}; nearest come {', '.join(near)})"
    return f" (did you mean {' or '.join(repr(name) for name in near)}?)"


def new(
    words: Annotated[
        list[str] | None,
        typer.Argument(
            help="Kind of the problem, such as indentation; or what you look for, in your own words, for its name.",
            autocompletion=_kinds("problem"),
            metavar="[PROBLEM]",
            show_default=False,
        ),
    ] = None,
    profile: Annotated[str, typer.Option(help="Kind of the profile.", autocompletion=_kinds("profile"))] = "",
    medium: Annotated[str, typer.Option(help="Kind of the medium.", autocompletion=_kinds("medium"))] = "",
    bed: Annotated[str, typer.Option(help="Kind of the elastic foundation (bed).", autocompletion=_kinds("bed"))] = "",
    load: Annotated[str, typer.Option(help="Kind of the load.", autocompletion=_kinds("load"))] = "",
    output: Annotated[
        Path | None, typer.Option("--output", "-o", help="The file to write; PROBLEM.toml if not given.")
    ] = None,
    overwrite: Annotated[bool, typer.Option("--overwrite", "--yes", "-y", help="Replace an existing file.")] = False,
) -> None:
    """Write a commented study for a problem; it runs as it is.

    Without a problem it is indentation.  Words that are no kind are searched for, and the nearest problems named.

    Example: winkler new indentation --profile cone --output cone.toml
    """
    from winkler.io.whole_file import write_whole
    from winkler.study.batch.run import run
    from winkler.study.language.catalogue import CATALOGUE
    from winkler.study.language.reading import parse_study
    from winkler.study.language.template import template
    from winkler.values.errors import InvalidInput, WinklerError, listed

    problem = " ".join(words or ("indentation",))
    for slot, name in (("problem", problem), ("profile", profile), ("medium", medium), ("bed", bed), ("load", load)):
        names = [kind for group in (slot, *ALSO.get(slot, ())) for kind in CATALOGUE[group]]
        if name and name not in names:
            raise InvalidInput(f"{slot}: '{name}' is not known{_meant(name, names)}; there are {listed(name, names)}.")
    path = output or Path(f"{problem}.toml")
    refuse_existing(path, overwrite)
    text = template(problem, file=path.stem, profile=profile, medium=medium, bed=bed, load=load)
    try:
        run(parse_study(text, file=path.name))
    except WinklerError as error:
        raise type(error)(f"these kinds do not go together: {error}") from None
    write_whole({path: text.encode()})
    write_line(f"Written {path}; run it with: winkler run {path}")


def _all_kinds() -> list[str]:
    from winkler.study.language.catalogue import kinds

    return list(kinds())


def schema(
    kind: Annotated[
        str,
        typer.Argument(
            help="A kind, for its table alone; whole studies if left out.", autocompletion=completion(_all_kinds)
        ),
    ] = "",
    output: Annotated[
        Path | None, typer.Option("--output", "-o", help="The file to write; winkler.schema.json if not given.")
    ] = None,
    overwrite: Overwrite = False,
) -> None:
    """Write a JSON schema of study files, by which editors complete keys and mark mistakes.

    Example: winkler schema
    """
    import json

    from winkler.io.whole_file import write_whole
    from winkler.study.json_schema import json_schema
    from winkler.study.language.template import SCHEMA_FILE
    from winkler.values.errors import InvalidInput, suggest

    names = _all_kinds()
    if kind and kind not in names:
        raise InvalidInput(f"'{kind}' is not a kind{suggest(kind, names)}; `winkler show` lists them.")
    path = output or Path(f"{kind}.schema.json" if kind else SCHEMA_FILE)
    refuse_existing(path, overwrite)
    write_whole({path: (json.dumps(json_schema(kind), indent=1, ensure_ascii=False) + "\n").encode()})
    write_line(f"Written {path}; editors use it for studies that begin with: #:schema {path}")
