"""The table of common materials for ``winkler show``."""

from __future__ import annotations

from typing import TYPE_CHECKING

from winkler.cli import terminal
from winkler.cli.streams import until_closed

if TYPE_CHECKING:
    from winkler.materials.named import NamedMaterial

__all__ = ["every", "one"]

TABLE_QUANTITIES = ("young", "poisson", "hardness", "density", "conductivity", "resistivity")
"""Quantities in the table of all materials."""


@until_closed()
def every() -> None:
    """Show all materials, with their most common quantities."""
    from winkler.materials.named import material, material_names
    from winkler.vocabulary import GLOSSARY

    table = terminal.table("material", "sort")
    for quantity in TABLE_QUANTITIES:
        table.add_column(f"{quantity}\n[{GLOSSARY[quantity].unit or '-'}]", justify="right")
    for name in material_names():
        entry = material(name)
        numbers = {figure.quantity: figure.number for figure in entry.figures}
        table.add_row(
            name,
            entry.sort,
            *(f"{numbers[quantity]:.4g}" if quantity in numbers else "-" for quantity in TABLE_QUANTITIES),
        )
    out = terminal.console()
    out.print(table)
    out.print("Room temperature, SI units. `winkler show copper` lists all numbers of a material and their sources.")


@until_closed()
def one(entry: NamedMaterial) -> None:
    """Show every number of a material, with its source and how a study names it."""
    from winkler.readable import scale_of
    from winkler.vocabulary import GLOSSARY

    table = terminal.table("quantity", "value", "unit", "source")
    for figure in entry.figures:
        scale = scale_of(GLOSSARY[figure.quantity].unit, figure.number)
        table.add_row(figure.quantity, f"{figure.number / scale.factor:.6g}", scale.unit, figure.source)
    out = terminal.console()
    out.print(f"{entry.name}: {entry.sort}, at room temperature")
    out.print(table)
    out.print(f'In a study: first = {{ kind = "named_elastic", name = "{entry.name}" }}', soft_wrap=True)
