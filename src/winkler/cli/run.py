"""``winkler run``: solve a study and write its results."""

from __future__ import annotations

import math
import time
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from winkler.cli.options import AsJson, Output, Overwrite, Quiet
from winkler.cli.results import resumed, say_outcome
from winkler.cli.saying import read_or_not, say

if TYPE_CHECKING:
    from winkler.errors import WinklerError
    from winkler.study.batch.outcome import Outcome

__all__ = ["run"]

MISSED = 1


def run(
    study: Annotated[Path, typer.Argument(help="A study file (TOML).", show_default=False)],
    output: Output = None,
    overwrite: Overwrite = False,
    workers: Annotated[
        int | None,
        typer.Option(
            "--workers", "-w", help="Processes that solve a sweep; all processors, if it takes a while, unless given."
        ),
    ] = None,
    cluster: Annotated[
        str,
        typer.Option(
            "--cluster",
            help="Address of a dask scheduler whose workers solve a sweep; given up after 60 s without a worker.",
        ),
    ] = "",
    anew: Annotated[bool, typer.Option("--anew", help="Forget what a sweep that was stopped has solved.")] = False,
    quiet: Quiet = False,
    as_json: AsJson = False,
) -> int:
    """Solve a study; write numbers, figures and a report.

    The results are written whole or not at all. A sweep, or a march through wear, that was stopped goes on where it
    was if the same study is run again. Exit code 1 if an expectation is missed; if points of a sweep have no answer,
    the code of the first one, or 70 if winkler itself made a mistake at one of them.

    Example: winkler run examples/studies/normal/hertz.toml --output results/ball
    """
    from winkler.cli import terminal
    from winkler.errors import Interrupted, InvalidInput, Mistake, WinklerError
    from winkler.study.batch.checkpoint import Keep
    from winkler.study.batch.cluster import Cluster
    from winkler.study.batch.journal import Journal
    from winkler.study.batch.pool import Machine
    from winkler.study.batch.run import gather, named
    from winkler.study.batch.sweep import solve_points
    from winkler.study.language.reading import read_study
    from winkler.study.report.writing import write_outcome

    started = time.perf_counter()
    if cluster and workers is not None:
        raise InvalidInput("run: both --workers and --cluster are given; leave one of them out.")
    asked = read_study(study)
    folder = output or Path(asked.output.folder or Path("results") / study.stem)
    many, hidden = math.prod(asked.shape), quiet or as_json
    journal, keep = Journal.beside(folder, asked), Keep.beside(folder)
    with resumed(folder, journal, keep, many=f"{many} points", overwrite=overwrite, anew=anew) as partial:
        before = journal.count
        who = Cluster(cluster) if cluster else Machine() if workers is None else workers
        watch = terminal.marching(hidden=hidden or many > 1)
        points = solve_points(asked, journal if many > 1 else None, workers=who, watch=watch, keep=keep)
        watched = terminal.tracked(points, many, hidden=hidden, before=before)
        try:
            outcome = gather(asked, watched, started=started, source=study.name)
            write_outcome(outcome, partial)
        except WinklerError as error:
            raise named(error, study.name) from None
        code = _code(outcome)
        journal.complete = code != Interrupted.exit_code
    if as_json:
        _print_json(outcome, folder)
    elif not quiet:
        _print(outcome, folder)
        if before:
            say(f"{before} of {many} points were known from the run before.")
    if code == Interrupted.exit_code:
        raise Interrupted(f"interrupted; the points that were reached are kept in {folder}.")
    if code == Mistake.exit_code:
        raise _mistake(study.name, outcome, folder)
    return code


def _code(outcome: Outcome) -> int:
    from winkler.study.batch.run import first_failure

    if outcome.failed:
        return first_failure(outcome.failed).code
    stopped = [point.code for point in outcome.solved if point.code]
    if stopped:
        return stopped[-1]
    return 0 if all(verdict.passed for verdict in outcome.verdicts) else MISSED


def _mistake(name: str, outcome: Outcome, folder: Path) -> WinklerError:
    """Return what is raised when the results are written and winkler is at fault for points without an answer."""
    from winkler.errors import Mistake
    from winkler.study.batch.run import first_failure, raised

    count = sum(point.code == Mistake.exit_code for point in outcome.failed)
    first = first_failure(outcome.failed)
    return raised(
        first,
        f"{name}: at {count} of {len(outcome.points)} points winkler is at fault, not the study; what the others "
        f"answer is in {folder}. The first: {first.reason}",
    )


@read_or_not()
def _print(outcome: Outcome, folder: Path) -> None:
    from winkler.cli import terminal
    from winkler.cli.validate import verdict_table

    out = terminal.console()
    out.print(outcome.study.title)
    terminal.answers(outcome, out)
    terminal.indices(outcome, out)
    if outcome.verdicts:
        out.print(verdict_table(outcome.verdicts))
    terminal.notes(outcome, out)
    if outcome.failed:
        first = outcome.failed[0]
        out.print(f"{len(outcome.failed)} of {len(outcome.points)} points have no answer; the first: {first.reason}")
    for point in outcome.solved:
        if point.stopped:
            out.print(point.stopped)
    out.print(f"Written to {folder} in {outcome.provenance.seconds:.1f} s.", soft_wrap=True)


def _print_json(outcome: Outcome, folder: Path) -> None:
    from winkler.cli.validate import verdict_json

    more = {
        "expect": [verdict_json(verdict) for verdict in outcome.verdicts],
        "failed": [
            {"index": list(point.index), "reason": point.reason, "code": point.code} for point in outcome.failed
        ],
    }
    say_outcome(outcome, folder, "answers", more)
