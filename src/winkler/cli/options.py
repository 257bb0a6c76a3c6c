"""Options that the commands which solve and write have in common."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Annotated

import typer

__all__ = ["AsJson", "Output", "Overwrite", "Quiet", "Settings", "completion", "refuse_existing"]

Output = Annotated[
    Path | None,
    typer.Option("--output", "-o", help="Folder of the results; results/NAME unless the study states another one."),
]
Overwrite = Annotated[
    bool, typer.Option("--overwrite", "--yes", "-y", help="Replace results of an earlier run without asking.")
]
Quiet = Annotated[bool, typer.Option("--quiet", "-q", help="Show nothing but errors.")]
AsJson = Annotated[bool, typer.Option("--json", help="Show the answers as JSON.")]
Settings = Annotated[
    list[str] | None,
    typer.Option(
        "--set",
        metavar="KEY=CONTENT",
        help="A content in place of the study's, such as problem.load.force='20 N'; may be given again.",
    ),
]


def completion(names: Callable[[], Iterable[str]]) -> Callable[[str], list[str]]:
    """Return the completion of the shell by these names."""

    def begun(incomplete: str) -> list[str]:
        return [name for name in names() if name.startswith(incomplete)]

    return begun


def refuse_existing(path: Path, overwrite: bool, where: str = "") -> None:
    """Refuse to replace a file, unless that is requested.

    Raises
    ------
    InvalidInput
    """
    if path.exists() and not overwrite:
        from winkler.errors import InvalidInput

        raise InvalidInput(
            f"{where}'{path}' exists; add --overwrite to replace it, or give another file with --output."
        )
