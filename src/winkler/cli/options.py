"""Options that the commands which solve and write have in common."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

if TYPE_CHECKING:
    from winkler.study.batch.pool import Workers

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
ClusterAddress = Annotated[
    str,
    typer.Option(
        "--cluster",
        help="Address of a dask scheduler whose workers do it; given up after 60 s without a worker.",
    ),
]


def stated_workers(command: str, workers: int | None, cluster: str) -> Workers:
    """Return who solves, by the options `--workers` and `--cluster`; this machine if neither is given.

    Raises
    ------
    InvalidInput
        If both are given.
    """
    from winkler.study.batch.cluster import Cluster
    from winkler.study.batch.pool import Machine
    from winkler.values.errors import InvalidInput

    if cluster and workers is not None:
        raise InvalidInput(f"{command}: both --workers and --cluster are given; leave one of them out.")
    if cluster:
        return Cluster(cluster)
    return Machine() if workers is None else workers


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
        from winkler.values.errors import InvalidInput

        raise InvalidInput(
            f"{where}'{path}' exists; add --overwrite to replace it, or give another file with --output."
        )
