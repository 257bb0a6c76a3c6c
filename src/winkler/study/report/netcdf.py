"""What a NetCDF variable says of itself."""

from __future__ import annotations

from winkler.vocabulary import Word

__all__ = ["netcdf_attributes"]


def netcdf_attributes(told: Word) -> dict[str, str]:
    """Return unit, meaning and symbol of a word as the attributes of a variable."""
    found = {"long_name": told.meaning, "symbol": told.symbol}
    return found if told.unit is None else {"units": told.unit or "1", **found}
