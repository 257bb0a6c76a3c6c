"""The table of common materials for ``winkler show``."""

from __future__ import annotations

from winkler.cli.streams import until_closed
from winkler.cli.terminal import console, prefixed

__all__ = ["every", "has", "names", "one"]

TABLE_QUANTITIES = ("young", "poisson", "hardness", "density", "conductivity", "resistivity")
"""Quantities in the table of all materials."""


def names() -> tuple[str, ...]:
    """Return the names of the materials."""
    from winkler.materials.named import material_names

    return material_names()


def has(name: str) -> bool:
    """Return whether a material of this name is known."""
    from winkler.errors import InvalidInput
    from winkler.materials.named import material

    try:
        material(name)
    except InvalidInput:
        return False
    return True


@until_closed()
def every() -> None:
    """Show all materials, with their most common quantities."""
    from rich import box
    from rich.table import Table

    from winkler.materials.named import material
    from winkler.vocabulary import GLOSSARY

    table = Table("material", "sort", box=box.SIMPLE_HEAD)
    for quantity in TABLE_QUANTITIES:
        table.add_column(f"{quantity}\n[{GLOSSARY[quantity].unit or '-'}]", justify="right")
    for name in names():
        entry = material(name)
        numbers = {figure.quantity: figure.number for figure in entry.figures}
        table.add_row(
            name,
            entry.sort,
            *(f"{numbers[quantity]:.4g}" if quantity in numbers else "-" for quantity in TABLE_QUANTITIES),
        )
    out = console()
    out.print(table)
    out.print("Room temperature, SI units. `winkler show copper` lists all numbers of a material and their sources.")


@until_closed()
def one(name: str) -> None:
    """Show every number of a material, with its source and how a study names it."""
    import numpy as np
    from rich import box
    from rich.table import Table

    from winkler.materials.named import material
    from winkler.vocabulary import GLOSSARY

    entry = material(name)
    table = Table("quantity", "value", "unit", "source", box=box.SIMPLE_HEAD)
    for figure in entry.figures:
        factor, unit = prefixed(np.array([figure.number]), GLOSSARY[figure.quantity].unit)
        table.add_row(figure.quantity, f"{figure.number * factor:.6g}", unit, figure.source)
    out = console()
    out.print(f"{entry.name}: {entry.sort}, at room temperature")
    out.print(table)
    out.print(f'In a study: first = {{ kind = "named_elastic", name = "{entry.name}" }}', soft_wrap=True)
