"""Options that the commands which solve and write have in common."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

__all__ = ["AsJson", "Output", "Overwrite", "Quiet"]

Output = Annotated[
    Path | None,
    typer.Option("--output", "-o", help="Folder of the results; results/NAME unless the study states another one."),
]
Overwrite = Annotated[
    bool, typer.Option("--overwrite", "--yes", "-y", help="Replace results of an earlier run without asking.")
]
Quiet = Annotated[bool, typer.Option("--quiet", "-q", help="Show nothing but errors.")]
AsJson = Annotated[bool, typer.Option("--json", help="Show the answers as JSON.")]
