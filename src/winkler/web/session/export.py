"""Export of results as one file: numbers, figures, or report, by the writers of the command line."""

from __future__ import annotations

import io
import tempfile
import zipfile
from pathlib import Path

from winkler.study.batch.fit_outcome import FitOutcome
from winkler.study.batch.outcome import Outcome
from winkler.study.report import archive, figures, fit_report, fit_writing, report
from winkler.study.report.figure import ReportFigure, save
from winkler.study.report.page_parts import REPORT
from winkler.web.pictures.replies import File

__all__ = ["exported"]


def exported(outcome: Outcome | FitOutcome, what: str, page: Path) -> File:
    """Return results as a file.

    Parameters
    ----------
    outcome
        Outcome of a study.
    what
        ``csv``, ``netcdf``, ``png`` or ``report``.
    page
        The folder of the page: files are written there first, and removed with it if the worker is killed.
    """
    if what == "report":
        return File(REPORT, _page(outcome).encode("utf-8"))
    with tempfile.TemporaryDirectory(dir=page) as place:
        folder = Path(place)
        if what == "png":
            save(_figures(outcome), folder, ("png",))
            return _packed(folder)
        name = _numbers(outcome, folder)[0 if what == "csv" else 1]
        return File(name, (folder / name).read_bytes())


def _figures(outcome: Outcome | FitOutcome) -> tuple[ReportFigure, ...]:
    return fit_report.figures_of(outcome) if isinstance(outcome, FitOutcome) else figures.figures_of(outcome)


def _page(outcome: Outcome | FitOutcome) -> str:
    return fit_report.page(outcome) if isinstance(outcome, FitOutcome) else report.page(outcome)


def _numbers(outcome: Outcome | FitOutcome, folder: Path) -> tuple[str, str]:
    """Write all numbers, and return the file names of the table and the archive."""
    if isinstance(outcome, FitOutcome):
        fit_writing.write_numbers(outcome, folder)
        return fit_writing.CSV, fit_writing.NETCDF
    archive.write_archive(outcome, folder)
    return archive.CSV, archive.NETCDF


def _packed(folder: Path) -> File:
    """Return the pictures of a folder as one archive."""
    store = io.BytesIO()
    with zipfile.ZipFile(store, "w") as pack:
        for path in sorted(folder.rglob("*.png")):
            pack.write(path, path.name)
    return File("figures.zip", store.getvalue())
