"""The table of common materials, as ``winkler show`` shows it."""

from __future__ import annotations

from winkler.cli.saying import read_or_not
from winkler.cli.terminal import console, prefixed

__all__ = ["every", "has", "names", "one"]

SHOWN = ("young", "poisson", "hardness", "density", "conductivity", "resistivity")
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


@read_or_not()
def every() -> None:
    """Show all materials, with what is asked for most."""
    from rich import box
    from rich.table import Table

    from winkler.materials.named import material
    from winkler.vocabulary import GLOSSARY

    table = Table("material", "sort", box=box.SIMPLE_HEAD)
    for quantity in SHOWN:
        table.add_column(f"{quantity}\n[{GLOSSARY[quantity].unit or '-'}]", justify="right")
    for name in names():
        found = material(name)
        known = {figure.quantity: figure.number for figure in found.figures}
        table.add_row(name, found.told, *(f"{known[quantity]:.4g}" if quantity in known else "-" for quantity in SHOWN))
    out = console()
    out.print(table)
    out.print("Room temperature, SI units. `winkler show copper` tells all numbers of a material and their sources.")


@read_or_not()
def one(name: str) -> None:
    """Show every number of a material, with its source and how a study names it."""
    import numpy as np
    from rich import box
    from rich.table import Table

    from winkler.materials.named import material
    from winkler.vocabulary import GLOSSARY

    found = material(name)
    table = Table("quantity", "value", "unit", "source", box=box.SIMPLE_HEAD)
    for figure in found.figures:
        factor, unit = prefixed(np.array([figure.number]), GLOSSARY[figure.quantity].unit)
        table.add_row(figure.quantity, f"{figure.number * factor:.6g}", unit, figure.source)
    out = console()
    out.print(f"{found.name}: {found.told}, at room temperature")
    out.print(table)
    out.print(f'In a study: first = {{ kind = "named_elastic", name = "{found.name}" }}', soft_wrap=True)
