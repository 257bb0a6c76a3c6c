"""Export of results as one file: numbers, figures, or report, by the writers of the command line."""

from __future__ import annotations

import io
import zipfile
from pathlib import PurePath

from winkler.study.batch.fit_outcome import FitOutcome
from winkler.study.batch.outcome import Outcome
from winkler.study.report import archive, figures, fit_report, fit_writing, report
from winkler.study.report.figure import ReportFigure, figure_files
from winkler.study.report.page_parts import REPORT
from winkler.values.errors import InvalidInput
from winkler.web.pictures.replies import File


def exported(outcome: Outcome | FitOutcome, what: str, assumed: str = "") -> File:
    """Return results as a file.

    Parameters
    ----------
    outcome
        Outcome of a study.
    what
        ``csv``, ``netcdf``, ``png`` or ``report``.
    assumed
        Which numbers of the study nobody has given, in a sentence for the report; empty if none.

    Raises
    ------
    InvalidInput
        If there is no NetCDF file, as its library cannot be loaded.
    """
    if what == "report":
        page = (fit_report if isinstance(outcome, FitOutcome) else report).page(outcome, assumed=assumed)
        return File(REPORT, page.encode("utf-8"))
    if what == "png":
        return _packed(figure_files(_figures(outcome), ("png",)))
    files = fit_writing.number_files(outcome) if isinstance(outcome, FitOutcome) else archive.archive_files(outcome)
    module = fit_writing if isinstance(outcome, FitOutcome) else archive
    name = module.CSV if what == "csv" else module.NETCDF
    if name not in files:
        raise InvalidInput(
            f"{name}: h5netcdf or h5py cannot be loaded, so the app gives no NetCDF file; save the results as CSV, "
            "or install both packages and start the app again."
        )
    return File(name, files[name])


def _figures(outcome: Outcome | FitOutcome) -> tuple[ReportFigure, ...]:
    return fit_report.figures_of(outcome) if isinstance(outcome, FitOutcome) else figures.figures_of(outcome)


def _packed(pictures: dict[str, bytes]) -> File:
    """Return pictures as one archive."""
    store = io.BytesIO()
    with zipfile.ZipFile(store, "w") as pack:
        for name, content in sorted(pictures.items()):
            pack.writestr(PurePath(name).name, content)
    return File("figures.zip", store.getvalue())
