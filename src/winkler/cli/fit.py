"""``winkler fit``: fit measured curves, and write the results."""

from __future__ import annotations

import dataclasses
import json
import math
import time
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from winkler.cli.options import AsJson, ClusterAddress, Output, Overwrite, Quiet, Settings, stated_workers
from winkler.cli.results import batch_json, print_batch, resumed, write_outcome_json
from winkler.cli.streams import until_closed, write_line

if TYPE_CHECKING:
    from winkler.fitting.compare import AnyFit
    from winkler.fitting.search import FitState
    from winkler.study.batch.fit_outcome import FitOutcome
    from winkler.study.language.fit_study import FitStudy

MOST_ROWS = 24
"""Rows of a table; longer ones are cut."""


def fit(
    study: Annotated[
        Path,
        typer.Argument(
            help=r"A study file (TOML) with \[fit], \[indentation] or \[calibration], or of held contacts.",
            show_default=False,
            readable=False,
        ),
    ],
    output: Output = None,
    settings: Settings = None,
    overwrite: Overwrite = False,
    workers: Annotated[
        int | None,
        typer.Option(
            "--workers", "-w", help="Processes that fit many curves; all processors, if it takes a while, unless given."
        ),
    ] = None,
    cluster: ClusterAddress = "",
    time_limit: Annotated[
        float | None,
        typer.Option(help=r"The longest that the fit of one curve may take \[s]; that of the study if not given."),
    ] = None,
    segments: Annotated[
        str,
        typer.Option(
            "--segments", help="Where the curves are loaded, held, unloaded: 'loading 0 s, hold 12 s, unloading 17 s'."
        ),
    ] = "",
    pages: Annotated[
        int, typer.Option(help="Of how many curves an own page is written, with everything behind their parameters.")
    ] = 0,
    anew: Annotated[bool, typer.Option("--anew", help="Forget what a batch that was stopped has fitted.")] = False,
    quiet: Quiet = False,
    as_json: AsJson = False,
) -> int:
    """Fit parameters of a model to one curve, many files, or a force map; evaluate or calibrate nanoindentations.

    The results are written whole or not at all; after Ctrl-C with what was fitted so far. A batch that was stopped goes
    on where it was if the same study is fitted again. If curves have no answer, the exit code is that of the first one.
    A curve that takes longer than the time limit has none; the others go on.

    Example: winkler fit examples/studies/fitting/fit_gel.toml --output results/gel
    """
    from winkler.cli import nanoindentation, terminal
    from winkler.cli.measured_problem import is_measured_problem
    from winkler.cli.run import run
    from winkler.io.processes.stopping import clear_interrupt
    from winkler.study.batch.fit_outcome import Fitted
    from winkler.study.batch.fit_recording import recalled_fits
    from winkler.study.batch.fit_run import fit_curves, gather_fits, pieces
    from winkler.study.batch.journal import Journal
    from winkler.study.batch.run import named
    from winkler.study.language.fit_reading import read_fit_study
    from winkler.study.report.writing import outcome_files, write_files
    from winkler.values.errors import Interrupted, InvalidInput, WinklerError

    started = time.perf_counter()
    if nanoindentation.wanted(study):
        if cluster:
            raise InvalidInput(
                f"{study.name}: nanoindentations are evaluated here, in a few seconds; leave --cluster out."
            )
        options = {"overwrite": overwrite, "quiet": quiet, "as_json": as_json}
        return nanoindentation.evaluate(study, output, settings or (), **options)
    if is_measured_problem(study):
        return run(study, output, settings, overwrite, workers, cluster, anew=anew, quiet=quiet, as_json=as_json)
    fitters = stated_workers("fit", workers, cluster)
    if time_limit is not None and not time_limit > 0.0:
        raise InvalidInput(f"fit: --time-limit is {time_limit:g}; give a positive time in s.")
    if pages < 0:
        raise InvalidInput(f"fit: --pages is {pages}; give the number of curves with a page of their own, or leave it.")
    stated = [part.strip() for part in segments.split(",") if part.strip()]
    more = [f"fit.segments={json.dumps(stated)}"] if stated else []
    content = read_fit_study(study, settings=(*(settings or ()), *more))
    if time_limit is not None:
        content = dataclasses.replace(content, time_limit=time_limit)
    folder = output or Path(content.output.folder or Path("results") / study.stem)
    todo = pieces(content)
    many = f"{len(todo)} {'files' if len(content.sources) > 1 else 'curves'}"
    fitted: dict[int, Any] = {}
    running = _RunningFit(content)
    journal = Journal.beside(folder, content)
    with resumed(folder, journal, many=many, overwrite=overwrite, anew=anew) as partial:
        before, batch_journal = recalled_fits(content, todo, journal), journal if len(todo) > 1 else None
        known_count, hidden = len(before), quiet or as_json
        stream = fit_curves(content, todo, before, workers=fitters, watch=running.watch, journal=batch_journal)
        try:
            fitted.update(
                terminal.tracked(stream, len(todo), hidden=hidden, doing=running.progress, before=known_count)
            )
        except KeyboardInterrupt:
            if not fitted and running.state is not None:
                raise Interrupted(f"interrupted after {running.best()}; nothing was written.") from None
            if not any(isinstance(result, Fitted) for results in fitted.values() for result in results):
                raise
            clear_interrupt()
        left = len(todo) - len(fitted)
        try:
            outcome = gather_fits(content, fitted.items(), started=started, source=study.name, left=left)
        except WinklerError as error:
            raise named(error, study.name) from None
        write_files(outcome_files(outcome, pages=pages), partial, journal)
        journal.complete = not left
    if as_json:
        _print_json(outcome, folder)
    elif not quiet:
        _print(outcome, folder)
        if known_count:
            write_line(f"{known_count} of {many} were known from the run before.")
    if left:
        raise Interrupted(
            f"interrupted; {len(outcome.results)} curves were done and are in {folder}, {left} of {many} are missing; "
            "the same command goes on from there."
        )
    return outcome.refused[0].code if outcome.refused else 0


class _RunningFit:
    """Progress of the running fit."""

    def __init__(self, study: FitStudy) -> None:
        self.study = study
        self.state: FitState | None = None

    def watch(self, states: Iterable[FitState | AnyFit]) -> Iterator[FitState | AnyFit]:
        """Pass states on, and store the last."""
        from winkler.fitting.search import FitState
        from winkler.io.processes.stopping import raise_pending

        for state in states:
            raise_pending()
            self.state = state if isinstance(state, FitState) else None
            yield state

    def progress(self) -> str:
        """Return the progress as a short text."""
        return f"fitting: {_progress_text(self.state, self.study)}" if self.state is not None else "fitting"

    def best(self) -> str:
        """Return the best numbers so far, in a sentence."""
        from winkler.values.readable import with_unit

        assert self.state is not None
        keys = {free.path: free.key for free in self.study.free}
        numbers = zip(self.state.names, self.state.values.tolist(), strict=True)
        words = (f"{keys[name]} = {with_unit(n, self.study.word(keys[name]).unit, 5)}" for name, n in numbers)
        return f"{_progress_text(self.state, self.study)}; the best numbers so far, not converged: {', '.join(words)}"


def _progress_text(state: FitState, study: FitStudy) -> str:
    from winkler.values.readable import with_unit

    left = f", residuals of {with_unit(state.scatter, study.spread.unit)}" if math.isfinite(state.scatter) else ""
    return f"{state.evaluations} evaluation{'s' * (state.evaluations != 1)}{left}"


@until_closed()
def _print(outcome: FitOutcome, folder: Path) -> None:
    from winkler.cli import terminal
    from winkler.study.report.examined.sentences import further_sentences

    out = terminal.console()
    out.print(outcome.study.title)
    _table(outcome, out)
    for sentence in further_sentences(outcome):
        out.print(sentence, soft_wrap=True)
    for result in outcome.fitted[:MOST_ROWS]:
        for flag in result.fit.flags:
            where = f"{result.name}, " if len(outcome.results) > 1 else ""
            out.print(f"  {where}{flag}", soft_wrap=True)
    print_batch(outcome, out, "fit.csv")
    terminal.notes(outcome, out)
    failed = [(one.name, one.reason) for one in outcome.refused]
    terminal.failures(failed, f"of {len(outcome.results)} curves", out)
    out.print(f"Written to {folder} in {outcome.provenance.seconds:.1f} s.", soft_wrap=True)


def _table(outcome: FitOutcome, out: Any) -> None:
    """Show a list for one curve, a table of numbers and errors for many."""
    from winkler.cli import terminal
    from winkler.study.language.explain import plain_symbol
    from winkler.study.report.fit_tables import curve_texts, number_texts
    from winkler.values.readable import with_unit

    study = outcome.study
    if len(outcome.results) == 1:
        fit = outcome.fitted[0].fit
        out.print(_headline(outcome), soft_wrap=True)
        table = terminal.table("free", "symbol", "fitted", "standard error", "95 % interval")
        for free, word, number, error, low, high in number_texts(outcome, outcome.fitted[0]):
            table.add_row(free.key, plain_symbol(word.symbol), number, error, f"{low} ... {high}")
        out.print(table)
        out.print(
            f"{fit.count} points, worth {fit.effective_count:.0f} independent ones; {fit.slow_share:.0%} of the "
            f"noise's variance is slow; noise {with_unit(fit.noise, study.spread.unit)}; chi-square per degree of "
            f"freedom {fit.chi_square:.3g}, in contact {fit.chi_square_in_contact:.3g}.",
            soft_wrap=True,
        )
        return
    table = terminal.table("curve")
    columns = [[result.name for result in outcome.results]]
    for free in study.free:
        unit, texts = curve_texts(outcome, free, "-")
        table.add_column(f"{free.label}\n[{unit}]" if unit else free.label, justify="right")
        columns.append(texts)
    table.add_column("flags")
    columns.append(outcome.flags(", ", "no answer"))
    terminal.add_rows(table, columns)
    out.print(table)


def _headline(outcome: FitOutcome) -> str:
    """Return the first free number with its interval of 95 %, and how many points stand behind it."""
    from winkler.values.readable import with_unit

    free, fit = outcome.study.free[0], outcome.fitted[0].fit
    word = outcome.study.word(free.key)
    low, high = fit.interval(free.path)
    number = fit.value(free.path)
    below, above = (with_unit(end, word.unit, 2) for end in (number - low, high - number))
    around = f"± {above}" if below == above else f"- {below} + {above}"
    return (
        f"{free.label} = {with_unit(number, word.unit, 5)} {around} (95 %), from {fit.effective_count:.0f} effective "
        f"points of {fit.count}."
    )


def _print_json(outcome: FitOutcome, folder: Path) -> None:
    more = {
        "flags": [
            {"curve": result.name, "name": flag.name, "statement": flag.statement}
            for result in outcome.fitted
            for flag in result.fit.flags
        ],
        "failed": [{"curve": one.name, "reason": one.reason, "code": one.code} for one in outcome.refused],
        "left": outcome.left,
        **batch_json(outcome),
    }
    write_outcome_json(outcome, folder, "columns", more)
