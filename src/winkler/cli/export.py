"""``winkler export``: the contact law of a study as a source file for other programs."""

from __future__ import annotations

from pathlib import Path
from typing import Annotated

import typer

from winkler.cli.options import refuse_existing
from winkler.cli.streams import write_line


def export(
    study: Annotated[Path, typer.Argument(help="A study of a contact law.", show_default=False, readable=False)],
    to: Annotated[str, typer.Option("--to", help="The language.", show_default=False)],
    output: Annotated[Path, typer.Option("--output", "-o", help="Folder of the files.")] = Path(),
    name: Annotated[str, typer.Option(help="With which functions and types begin.")] = "contact",
    tolerance: Annotated[float, typer.Option(help="Error of a force given by a table, over the greatest.")] = 1e-6,
    count: Annotated[int, typer.Option(help="Number of springs with friction.")] = 32,
    precision: Annotated[str, typer.Option(help="Type of numbers: double, or float in C.")] = "double",
    every_radius: Annotated[bool, typer.Option("--every-radius", help="R of the pair goes into every step.")] = False,
    overwrite: Annotated[bool, typer.Option("--overwrite", "--yes", "-y", help="Replace existing files.")] = False,
) -> None:
    """Write the contact law of a study as a source file that tests itself against winkler.

    Example: winkler export examples/studies/normal/hertz.toml --to c --name ball
    """
    from winkler.exporting.choose import LAWS
    from winkler.exporting.export import export as exported_law
    from winkler.exporting.export import write_export
    from winkler.study.language.catalogue import in_kinds, kind_of, kinds
    from winkler.study.language.reading import read_study
    from winkler.values.errors import InvalidInput, WinklerError

    problem = read_study(study).problem
    if type(problem).__name__ not in LAWS:
        laws = ", ".join(kind for kind in map(in_kinds, LAWS) if kind in kinds())
        raise InvalidInput(
            f"{study.name}: problem.kind is {kind_of(type(problem))}, which is no contact law for other programs; "
            f"export one of: {laws}."
        )
    try:
        law = exported_law(
            problem, to, name=name, tolerance=tolerance, count=count, precision=precision, every_radius=every_radius
        )
    except WinklerError as error:
        raise error.reworded(in_kinds) from None
    for file, _ in law.files:
        refuse_existing(output / file, overwrite, "output: ")
    for path in write_export(law, output):
        write_line(f"{path} written: {law.title}.")
