"""``winkler run`` and ``merge``: solve a study, or its shards, and write its results, or show its numbers alone."""

from __future__ import annotations

import dataclasses
import math
import time
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, NamedTuple

import typer

from winkler.cli.options import AsJson, ClusterAddress, Output, Overwrite, Quiet, Settings, StudyFile, stated_workers
from winkler.cli.results import resumed, verdict_json, write_outcome_json
from winkler.cli.streams import until_closed, write_line

if TYPE_CHECKING:
    from winkler.study.batch.outcome import Outcome
    from winkler.study.batch.pool import Workers
    from winkler.study.language.study import Study
    from winkler.values.errors import WinklerError

EXPECTATION_MISSED = 1


def run(
    study: StudyFile,
    output: Output = None,
    settings: Settings = None,
    overwrite: Overwrite = False,
    workers: Annotated[
        int | None,
        typer.Option(
            "--workers", "-w", help="Processes that solve a sweep; all processors, if it takes a while, unless given."
        ),
    ] = None,
    cluster: ClusterAddress = "",
    shard: Annotated[
        str,
        typer.Option(
            "--shard",
            help="The part of a sweep to solve alone, such as 2/8; `winkler merge` writes the results of all.",
        ),
    ] = "",
    anew: Annotated[bool, typer.Option("--anew", help="Forget what a sweep that was stopped has solved.")] = False,
    figures: Annotated[
        str,
        typer.Option(
            "--figures",
            help="Formats of the figures as files, in place of the study's: some of svg, png, pdf, such as svg,png; "
            "all, or none.",
        ),
    ] = "",
    quiet: Quiet = False,
    as_json: Annotated[
        bool, typer.Option("--json", help="Show the answers as JSON; nothing is written unless --output is given.")
    ] = False,
) -> int:
    """Solve a study; write numbers, figures and a report.

    The results are written whole or not at all. A sweep, or a march through wear, that was stopped goes on where it
    was if the same study is run again. Exit code 1 if an expectation is missed; if points of a sweep have no answer,
    the code of the first one, or 70 if winkler itself made a mistake at one of them.

    Example: winkler run examples/studies/normal/hertz.toml --output results/ball
    """
    from winkler.study.language.reading import read_study
    from winkler.values.errors import Interrupted, Mistake

    started = time.perf_counter()
    solvers = stated_workers("run", workers, cluster)
    content = _with_figures(read_study(study, settings=settings or ()), figures)
    job = _RunRequest(content, study.name, solvers, started, hidden=quiet or as_json)
    named_folder = output or Path(content.output.folder or Path("results") / study.stem)
    if shard:
        return _shard_solved(job, named_folder, shard, anew=anew)
    if as_json and output is None:
        folder, before, outcome = None, 0, _solved_alone(job)
        place = "shown on stdout"
    else:
        folder = named_folder
        before, outcome = _solved_and_written(job, folder, overwrite=overwrite, anew=anew)
        place = f"in {folder}"
    if as_json:
        _print_json(outcome, folder)
    elif folder is not None and not quiet:
        _print(outcome, folder)
        if before:
            write_line(f"{before} of {job.many} points were known from the run before.")
    code = exit_code(outcome)
    if code == Interrupted.exit_code:
        raise Interrupted(f"interrupted; the points that were reached are {'kept ' if folder else ''}{place}.")
    if code == Mistake.exit_code:
        raise _mistake(study.name, outcome, place)
    return code


def merge(
    study: StudyFile,
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
    from winkler.study.batch.shards import put_together
    from winkler.study.language.reading import read_study

    content = read_study(study, settings=settings or ())
    folder = output or Path(content.output.folder or Path("results") / study.stem)
    parts = put_together(content, folder)
    code = run(study, folder, settings, overwrite=overwrite, quiet=quiet, as_json=as_json)
    for part in parts:
        part.remove()
    return code


class _RunRequest(NamedTuple):
    """The study to solve, the workers, and when it began."""

    study: Study
    name: str
    workers: Workers
    started: float
    hidden: bool

    @property
    def many(self) -> int:
        """Number of points."""
        return math.prod(self.study.shape)


def _with_figures(study: Study, given: str) -> Study:
    """Return the study with the formats of its figures that the option gives."""
    from winkler.study.language.study import PICTURES

    if not given:
        return study
    whole = {"all": PICTURES, "none": ()}
    formats = whole[given] if given in whole else tuple(name.strip() for name in given.split(","))
    return dataclasses.replace(study, output=dataclasses.replace(study.output, figures=formats))


def _solved_alone(job: _RunRequest) -> Outcome:
    """Solve a study, and write nothing."""
    from winkler.study.batch.run import gather, named
    from winkler.study.batch.sweep import solve_points
    from winkler.values.errors import WinklerError

    points = solve_points(job.study, workers=job.workers)
    try:
        return gather(job.study, points, started=job.started, source=job.name)
    except WinklerError as error:
        raise named(error, job.name) from None


def _solved_and_written(job: _RunRequest, folder: Path, *, overwrite: bool, anew: bool) -> tuple[int, Outcome]:
    """Solve a study and write its results; return how many points an earlier run had solved, and the outcome."""
    from winkler.cli import terminal
    from winkler.study.batch.checkpoint import CheckpointStore
    from winkler.study.batch.journal import Journal
    from winkler.study.batch.run import gather, named
    from winkler.study.batch.sweep import solve_points
    from winkler.study.report.writing import outcome_files, write_files
    from winkler.values.errors import Interrupted, WinklerError

    study, many = job.study, job.many
    journal, keep = Journal.beside(folder, study), CheckpointStore.beside(folder)
    with resumed(folder, journal, keep, many=f"{many} points", overwrite=overwrite, anew=anew) as partial:
        before = journal.count
        watch = terminal.marching(hidden=job.hidden or many > 1)
        points = solve_points(study, journal if many > 1 else None, workers=job.workers, watch=watch, keep=keep)
        watched = terminal.tracked(points, many, hidden=job.hidden, before=before)
        try:
            outcome = gather(study, watched, started=job.started, source=job.name)
            write_files(outcome_files(outcome), partial, journal)
        except WinklerError as error:
            raise named(error, job.name) from None
        journal.complete = exit_code(outcome) != Interrupted.exit_code
    return before, outcome


def _shard_solved(job: _RunRequest, folder: Path, text: str, *, anew: bool) -> int:
    """Solve one shard of a sweep, and keep its points beside the folder of results; return the exit code."""
    from winkler.cli import terminal
    from winkler.study.batch.checkpoint import CheckpointStore
    from winkler.study.batch.journal import Journal
    from winkler.study.batch.points import Failed
    from winkler.study.batch.run import first_failure, named
    from winkler.study.batch.shards import Shard
    from winkler.study.batch.sweep import solve_points
    from winkler.values.errors import Interrupted, InvalidInput, WinklerError

    shard, study = Shard.read(text), job.study
    if job.many == 1:
        raise InvalidInput(f"{job.name}: shard: the study has no sweep; leave --shard out.")
    own = shard.beside(folder)
    own.parent.mkdir(parents=True, exist_ok=True)
    journal, keep, many = Journal.beside(own, study), CheckpointStore.beside(own), job.many
    share = int(many - shard.others(many).sum())
    if anew:
        journal.remove()
        keep.remove()
    failed = []
    with journal:
        points = solve_points(study, journal, workers=job.workers, keep=keep, shard=shard)
        try:
            for point in terminal.tracked(points, share, hidden=job.hidden, before=journal.count):
                failed += [point] if isinstance(point, Failed) else []
        except KeyboardInterrupt:
            kept = f"{journal.count} of {share} points of shard {text} are kept beside {folder}"
            raise Interrupted(f"interrupted; {kept}, and the same command goes on from there.") from None
        except WinklerError as error:
            raise named(error, job.name) from None
    keep.remove()
    if not job.hidden:
        write_line(f"{share} of {many} points are kept beside {folder}; put all shards together with: winkler merge")
    return first_failure(failed).code if failed else 0


def exit_code(outcome: Outcome) -> int:
    """Return the exit code of a study that was solved."""
    from winkler.study.batch.run import first_failure

    if outcome.failed:
        return first_failure(outcome.failed).code
    stopped = [point.code for point in outcome.solved if point.code]
    if stopped:
        return stopped[-1]
    return 0 if all(verdict.passed for verdict in outcome.verdicts) else EXPECTATION_MISSED


def _mistake(name: str, outcome: Outcome, place: str) -> WinklerError:
    """Return what is raised when the results are there and winkler is at fault for points without an answer."""
    from winkler.study.batch.run import first_failure, raised
    from winkler.values.errors import Mistake

    count = sum(point.code == Mistake.exit_code for point in outcome.failed)
    first = first_failure(outcome.failed)
    return raised(
        first,
        f"{name}: at {count} of {len(outcome.points)} points winkler is at fault, not the study; what the others "
        f"answer is {place}. The first: {first.reason}",
    )


@until_closed()
def _print(outcome: Outcome, folder: Path) -> None:
    from winkler.cli import terminal
    from winkler.cli.validate import verdict_table
    from winkler.study.report.headline.loops import LOOP_HEADS, loop_rows, loops_title
    from winkler.study.report.headline.questions import questions_of
    from winkler.study.report.headline.section import doubt_of, headline
    from winkler.study.report.headline.summary import contact_summary
    from winkler.values.readable import with_readable_numbers
    from winkler.values.validity import Standing

    out = terminal.console()
    out.print(outcome.study.title)
    terminal.answers(outcome, out)
    doubt = doubt_of(outcome)
    if doubt.standing is Standing.OUTSIDE:
        out.print(f"Do not use these results: {with_readable_numbers(doubt.statement)} {doubt.advice}", soft_wrap=True)
    elif sentence := headline(outcome):
        out.print(sentence, soft_wrap=True)
    if summary := contact_summary(outcome):
        shown = terminal.table("summary", "value", "where, and compared with what")
        for one in summary:
            shown.add_row(one.name, one.text, one.remark)
        out.print(shown)
    if loops := loop_rows(outcome):
        out.print(f"{loops_title(outcome)}:")
        shown = terminal.table(*LOOP_HEADS)
        for loop in loops:
            shown.add_row(*loop)
        out.print(shown)
    terminal.indices(outcome, out)
    if outcome.verdicts:
        out.print(verdict_table(outcome.verdicts))
    terminal.notes(outcome, out, questions_of(outcome))
    failed = [
        (f"point {', '.join(str(place + 1) for place in point.index) or 1}", point.reason) for point in outcome.failed
    ]
    terminal.failures(failed, f"of {len(outcome.points)} points", out)
    for point in outcome.solved:
        if point.stopped:
            out.print(point.stopped)
    out.print(f"Written to {folder} in {outcome.provenance.seconds:.1f} s.", soft_wrap=True)


def _print_json(outcome: Outcome, folder: Path | None) -> None:
    from winkler.study.report.headline.summary import contact_summary

    more = {
        "summary": [one.table() for one in contact_summary(outcome)],
        "expect": [verdict_json(verdict) for verdict in outcome.verdicts],
        "failed": [
            {"index": list(point.index), "reason": point.reason, "code": point.code} for point in outcome.failed
        ],
    }
    write_outcome_json(outcome, folder, "answers", more)
