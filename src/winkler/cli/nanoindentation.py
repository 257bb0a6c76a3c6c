"""``winkler fit`` of a study with ``[indentation]`` or ``[calibration]``."""

from __future__ import annotations

import math
import time
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from winkler.cli.results import batch_json, print_batch, validity_json, verdict_json
from winkler.cli.streams import until_closed, write_json

if TYPE_CHECKING:
    from winkler.study.nanoindentation.running import NanoindentationOutcome

NUMBER_MISSED = 1


def wanted(study: Path) -> bool:
    """Return whether a study file is one of nanoindentations."""
    from winkler.study.nanoindentation.reading import is_nanoindentation

    return is_nanoindentation(study)


def evaluate(
    study: Path, output: Path | None, settings: Sequence[str], *, overwrite: bool, quiet: bool, as_json: bool
) -> int:
    """Evaluate the curves of a study, or calibrate its indenter, and write the results; return the exit code.

    After Ctrl-C the curves that were evaluated are written; a calibration needs all of its curves.
    """
    from winkler.cli import terminal
    from winkler.io.processes.stopping import clear_interrupt, raise_pending
    from winkler.study.nanoindentation.reading import read_nanoindentation_study
    from winkler.study.nanoindentation.running import evaluated_files, gathered, read_references
    from winkler.study.nanoindentation.writing import nanoindentation_files
    from winkler.study.report.reserving import reserved
    from winkler.study.report.writing import holds_results, placed, write_files
    from winkler.values.errors import Interrupted, InvalidInput

    started = time.perf_counter()
    content = read_nanoindentation_study(study, settings=settings)
    folder = output or Path(content.output.folder or Path("results") / study.stem)
    with reserved(folder):
        if holds_results(folder) and not overwrite:
            raise InvalidInput(f"output: '{folder}' holds results; give --overwrite, or another folder with --output.")
        found: list[Any] = []
        stream: Any = read_references(content) if content.calibrates else evaluated_files(content)
        try:
            for one in terminal.tracked(stream, len(content.sources), hidden=quiet or as_json, doing="evaluating"):
                raise_pending()
                found.append(one)
        except KeyboardInterrupt:
            if content.calibrates or not found:
                raise
            clear_interrupt()
        left = 0 if content.calibrates else len(content.sources) - len(found)
        outcome = gathered(content, found, started=started, source=study.name, left=left)
        outcome.verdicts  # noqa: B018  an expectation that no evaluation has is refused before anything is written
        with placed(folder, overwrite=overwrite) as partial:
            write_files(nanoindentation_files(outcome), partial)
    if as_json:
        write_json(_as_json(outcome, folder))
    elif not quiet:
        _print(outcome, folder)
    if left:
        raise Interrupted(f"interrupted; {len(found)} files were done and are in {folder}, {left} are missing.")
    if outcome.unevaluated:
        return outcome.unevaluated[0].code
    return 0 if all(verdict.passed for verdict, _ in outcome.verdicts) else NUMBER_MISSED


@until_closed()
def _print(outcome: NanoindentationOutcome, folder: Path) -> None:
    from winkler.cli import terminal
    from winkler.cli.validate import verdict_table
    from winkler.study.nanoindentation.report import (
        CONTINUOUS_HEADS,
        calibration_rows,
        continuous_rows,
        first_yield_rows,
        mean_rows,
    )

    out = terminal.console()
    out.print(outcome.study.title)
    if outcome.calibration:
        table = terminal.table("number", "value", "standard uncertainty")
        for row in calibration_rows(outcome):
            table.add_row(*row)
    elif outcome.evaluated:
        table = terminal.table("quantity", "mean", "standard uncertainty", "95 % interval")
        for line in mean_rows(outcome):
            table.add_row(*line)
    if outcome.calibration or outcome.evaluated:
        out.print(table)
    for name, content in first_yield_rows(outcome):
        out.print(f"{name}: {content}", soft_wrap=True)
    if outcome.verdicts:
        verdicts, names = zip(*outcome.verdicts, strict=True)
        out.print(verdict_table(verdicts, names))
    if outcome.continuous:
        table = terminal.table(*CONTINUOUS_HEADS)
        for cells in continuous_rows(outcome):
            table.add_row(*cells)
        out.print(table)
        depths = sum(one.solution.points.size for one in outcome.continuous)
        out.print(f"Continuous stiffness: {depths} depths of {len(outcome.continuous)} curves.", soft_wrap=True)
    if outcome.evaluated:
        unloadings = sum(one.solution.force.size for one in outcome.evaluated)
        out.print(f"{len(outcome.evaluated)} curves with {unloadings} unloadings were evaluated.", soft_wrap=True)
    print_batch(outcome, out, "quantities.csv")
    terminal.notes(outcome, out)
    kinds: tuple[tuple[Any, ...], ...] = (outcome.evaluated, outcome.continuous, outcome.unevaluated)
    curves = {one.name for kind in kinds for one in kind}
    terminal.failures([(one.name, one.reason) for one in outcome.unevaluated], f"of {len(curves)} curves", out)
    out.print(f"Written to {folder} in {outcome.provenance.seconds:.1f} s.", soft_wrap=True)


def _as_json(outcome: NanoindentationOutcome, folder: Path) -> dict[str, Any]:
    means = {
        name: {"mean": mean.mean, "error": mean.error, "interval": list(mean.interval()),
               "shares": dict(zip(mean.sources, mean.shares.tolist(), strict=True))}
        for name, mean in outcome.means.items()
    }  # fmt: skip
    calibration = [
        {
            "frame_compliance": one.frame_compliance,
            "frame_compliance_error": one.frame_compliance_error,
            "correlation": one.correlation if math.isfinite(one.correlation) else None,
            "area": list(one.indenter.area.coefficients),
            "left_out": list(one.left_out),
        }
        for one in outcome.calibration
    ]
    failed = [{"curve": one.name, "reason": one.reason, "code": one.code} for one in outcome.unevaluated]
    found = outcome.first_yield
    first_yield = None if found is None else {"curves": found.force.size, "mean_stress": found.mean_stress,
                                              "interval": list(found.interval()), "shape": found.shape}  # fmt: skip
    continuous = [
        {"curve": one.name, "depths": list(one.window), **one.mean._asdict(),
         "stated_young": _known(one.stated[0]), "stated_hardness": _known(one.stated[1])}
        for one in outcome.continuous
    ]  # fmt: skip
    return {"means": means, "first_yield": first_yield, "continuous": continuous,
            **batch_json(outcome),
            "expect": [verdict_json(verdict) | {"curve": name} for verdict, name in outcome.verdicts],
            "calibration": calibration, "failed": failed, "left": outcome.left, "folder": str(folder),
            "validity": validity_json(outcome)}  # fmt: skip


def _known(number: float) -> float | None:
    return number if math.isfinite(number) else None
