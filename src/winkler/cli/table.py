"""``winkler table``: the contact law of a study as a look-up table for other programs."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from winkler.cli.options import refuse_existing
from winkler.cli.streams import write_line


def table(
    study: Annotated[Path, typer.Argument(help="A study of an indentation.", show_default=False, readable=False)],
    output: Annotated[Path, typer.Option("--output", "-o", help="The table: .csv or .json.", show_default=False)],
    tolerance: Annotated[float, typer.Option(help="Error of the interpolated force, over the greatest force.")] = 1e-6,
    overwrite: Annotated[bool, typer.Option("--overwrite", "--yes", "-y", help="Replace an existing table.")] = False,
) -> None:
    """Write force, stiffnesses and radius over the depth, up to the deepest load of a study, for other programs.

    Example: winkler table examples/studies/normal/hertz.toml --output ball.csv
    """
    import numpy as np

    from winkler.io.tables.law_table import write_law
    from winkler.problems.normal.indentation import Indentation
    from winkler.problems.particles.contact_law import ContactLaw
    from winkler.study.language.reading import read_study
    from winkler.values.errors import InvalidInput

    problem = read_study(study).problem
    if not isinstance(problem, Indentation):
        raise InvalidInput(f"{study.name}: the problem is no indentation; only that has one curve for all histories.")
    refuse_existing(output, overwrite, "output: ")
    deepest = float(np.max(problem.solve().depth))
    law = ContactLaw(problem.bed, deepest, tolerance).solve()
    write_law(law, output)
    write_line(
        f"{law.depth.size} rows written to {output}; errors of the force: {law.hermite_error:.2g} by cubics, "
        f"at most {law.linear_error:.2g} by straight lines."
    )
