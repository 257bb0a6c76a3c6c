"""``winkler cite``: the papers behind a study or a kind."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from winkler.cli.streams import write_line


def cite(
    what: Annotated[str, typer.Argument(help="A study file, or a kind.", show_default=False)],
    bibtex: Annotated[bool, typer.Option("--bibtex", help="Show BibTeX entries.")] = False,
) -> None:
    """Show the papers that a study, or a kind, is based on.

    Example: winkler cite examples/studies/normal/hertz.toml --bibtex
    """
    from winkler.study.language.catalogue import kinds
    from winkler.study.language.reading import read_study
    from winkler.study.report.citing import bibliography
    from winkler.study.report.citing import cite as papers_of

    if what in kinds() and not Path(what).is_file():
        line = kinds()[what]
        keys = dict.fromkeys((*getattr(line.cls, "references", ()), *line.cites))
        papers = tuple(bibliography()[key] for key in keys)
    else:
        study = read_study(what)
        papers = papers_of((study.problem, study.sweep))
    for paper in papers:
        write_line(paper.bibtex + "\n" if bibtex else paper.text)
    if not papers and not bibtex:
        write_line(f"{what} is based on no particular paper.")
