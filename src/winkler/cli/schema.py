"""``winkler schema``: a JSON schema of study files, for editors."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from winkler.cli.options import Overwrite, completion, refuse_existing
from winkler.cli.streams import write_line

__all__ = ["schema"]


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

    from winkler.errors import InvalidInput, suggest
    from winkler.io.whole_file import write_whole
    from winkler.study.json_schema import json_schema
    from winkler.study.language.template import SCHEMA_FILE

    names = _all_kinds()
    if kind and kind not in names:
        raise InvalidInput(f"'{kind}' is not a kind{suggest(kind, names)}; `winkler show` lists them.")
    path = output or Path(f"{kind}.schema.json" if kind else SCHEMA_FILE)
    refuse_existing(path, overwrite)
    write_whole({path: (json.dumps(json_schema(kind), indent=1, ensure_ascii=False) + "\n").encode()})
    write_line(f"Written {path}; editors use it for studies that begin with: #:schema {path}")
