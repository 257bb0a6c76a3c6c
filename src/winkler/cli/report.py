"""``winkler report``: a study as a report alone, if wanted with curves that can be read off."""

from __future__ import annotations

import time
from pathlib import Path
from typing import Annotated

import typer

from winkler.cli.options import Settings, StudyFile, refuse_existing
from winkler.cli.streams import write_line


def report(
    study: StudyFile,
    output: Annotated[
        Path | None,
        typer.Option("--output", "-o", help="The page; NAME.html, or NAME.pdf, if not given.", show_default=False),
    ] = None,
    interactive: Annotated[
        bool, typer.Option("--interactive", help="Let curves be read off, by mouse, finger or arrow keys.")
    ] = False,
    film: Annotated[
        bool, typer.Option("--film", help="Add a film of a path, a time, cycles or loads, with a slider.")
    ] = False,
    one_sheet: Annotated[
        bool, typer.Option("--page", help="Write one page of A4 (PDF): question, picture, answers, validity, yield.")
    ] = False,
    workers: Annotated[
        int | None, typer.Option("--workers", "-w", help="Processes that solve a sweep; chosen unless given.")
    ] = None,
    settings: Settings = None,
    overwrite: Annotated[bool, typer.Option("--overwrite", "--yes", "-y", help="Replace an existing page.")] = False,
) -> int:
    """Solve a study and write its report alone: one page that needs nothing else.

    Exit codes are those of `winkler run`; points of a sweep that have no answer are listed on the page.

    Example: winkler report examples/studies/normal/hertz.toml --interactive
    """
    from winkler.cli import terminal
    from winkler.cli.run import exit_code
    from winkler.io.whole_file import write_whole
    from winkler.study.batch.pool import Machine
    from winkler.study.batch.run import gather, named
    from winkler.study.batch.sweep import solve_points
    from winkler.study.language.reading import read_study
    from winkler.study.report.figures import figures_of
    from winkler.study.report.report import page
    from winkler.values.errors import InvalidInput, WinklerError

    started = time.perf_counter()
    path = output or Path(f"{study.stem}.{'pdf' if one_sheet else 'html'}")
    allowed = (".pdf",) if one_sheet else (".html", ".htm")
    if path.suffix.lower() not in allowed:
        raise InvalidInput(f"report: '{path}' does not end like a page; give {allowed[0]}.")
    if one_sheet and interactive:
        raise InvalidInput("report: --page is a sheet of paper, on which nothing is read off; leave --interactive out.")
    if one_sheet and film:
        raise InvalidInput("report: --page is a sheet of paper, on which nothing moves; leave --film out.")
    refuse_existing(path, overwrite, "report: ")
    content = read_study(study, settings=settings or ())
    solvers = Machine() if workers is None else workers
    points = solve_points(content, workers=solvers, watch=terminal.marching(hidden=True))
    try:
        outcome = gather(content, points, started=started, source=study.name)
    except WinklerError as error:
        raise named(error, study.name) from None
    shown = figures_of(outcome)
    if one_sheet:
        from winkler.study.report.headline.one_page import one_page

        made = one_page(outcome, shown)
    else:
        text = page(outcome, shown)
        if interactive:
            from winkler.calculators.read_off import with_reading

            text = with_reading(text, shown)
        if film:
            from winkler.study.report.headline.shown_contact import shown_point
            from winkler.web.pictures.film_page import with_film

            text = with_film(text, shown_point(outcome))
        made = text.encode("utf-8")
    write_whole({path: made})
    write_line(f"Written {path}")
    return exit_code(outcome)
