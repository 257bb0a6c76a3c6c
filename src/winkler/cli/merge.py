"""``winkler merge``: the shards of a sweep put together, and the results written."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from winkler.cli.options import AsJson, Output, Overwrite, Quiet, Settings

__all__ = ["merge"]


def merge(
    study: Annotated[Path, typer.Argument(help="A study file (TOML) with a sweep.", show_default=False)],
    output: Output = None,
    settings: Settings = None,
    overwrite: Overwrite = False,
    quiet: Quiet = False,
    as_json: AsJson = False,
) -> int:
    """Write the results of a sweep whose shards were solved by `winkler run --shard`.

    The results are those of one run. Exit codes are those of `winkler run`.

    Example: winkler merge study.toml --output results/study
    """
    from winkler.cli.run import run
    from winkler.study.batch.shards import put_together
    from winkler.study.language.reading import read_study

    content = read_study(study, settings=settings or ())
    folder = output or Path(content.output.folder or Path("results") / study.stem)
    parts = put_together(content, folder)
    code = run(study, folder, settings, overwrite=overwrite, quiet=quiet, as_json=as_json)
    for part in parts:
        part.remove()
    return code
