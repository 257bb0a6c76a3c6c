"""The table of common materials for ``winkler show``."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from winkler.cli import terminal
from winkler.cli.streams import until_closed

if TYPE_CHECKING:
    from winkler.materials.named import NamedMaterial

TABLE_QUANTITIES = ("young", "poisson", "strength", "hardness", "density", "conductivity", "resistivity")
"""Quantities in the table of all materials."""


@until_closed()
def several(names: Sequence[str]) -> None:
    """Show materials, with their most common quantities."""
    from winkler.materials.named import material
    from winkler.values.readable import with_unit
    from winkler.values.vocabulary import GLOSSARY

    table = terminal.table("material", "sort")
    for quantity in TABLE_QUANTITIES:
        table.add_column(quantity, justify="right")
    for name in names:
        entry = material(name)
        numbers = {figure.quantity: figure.number for figure in entry.figures}
        table.add_row(
            name,
            entry.sort,
            *(
                with_unit(numbers[quantity], GLOSSARY[quantity].unit) if quantity in numbers else "-"
                for quantity in TABLE_QUANTITIES
            ),
        )
    out = terminal.console()
    out.print(table)
    out.print("Values at room temperature. `winkler show copper` lists all values of a material with their sources.")


@until_closed()
def one(entry: NamedMaterial) -> None:
    """Show every number of a material, with its source and how a study names it."""
    from winkler.values.readable import scale_of
    from winkler.values.vocabulary import GLOSSARY

    table = terminal.table("quantity", "value", "range", "unit", "source")
    for figure in entry.figures:
        scale = scale_of(GLOSSARY[figure.quantity].unit, figure.number)
        ends = [f"{end / scale.factor:.4g}" for end in figure.spread or ()]
        number = f"{figure.number / scale.factor:.6g}"
        table.add_row(figure.quantity, number, " to ".join(ends) or "not stated", scale.unit, figure.source)
    out = terminal.console()
    out.print(f"{entry.name}: {entry.sort}, at room temperature")
    out.print(table)
    if {"young", "poisson"} - {figure.quantity for figure in entry.figures}:
        out.print(
            'It is no named_elastic body: write kind = "elastic" with its modulus and a Poisson ratio of your own.'
        )
        return
    out.print(f'In a study: first = {{ kind = "named_elastic", name = "{entry.name}" }}', soft_wrap=True)
