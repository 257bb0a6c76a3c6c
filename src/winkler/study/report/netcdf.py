"""NetCDF files of variables with units and meanings, written as xarray writes them, without loading it.

What a dataset is made of is a table of variables and one of coordinates, name -> (dimensions, numbers, attributes),
and the attributes of the whole: the arguments of ``xarray.Dataset``.  The conventions of the file are those of CF
(cfconventions.org): NaN is the fill value of floats, and ``coordinates`` names what stands beside a variable.
"""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from winkler.vocabulary import Word

__all__ = ["netcdf_attributes", "write_variables"]

LARGE = 1000
"""Arrays of floats with more numbers are compressed, without loss."""

Variables = dict[str, tuple[tuple[str, ...], Any, dict[str, str]]]
"""Name -> dimensions, numbers, attributes."""


def netcdf_attributes(told: Word) -> dict[str, str]:
    """Return unit, meaning and symbol of a word as the attributes of a variable."""
    found = {"long_name": told.meaning, "symbol": told.symbol}
    return found if told.unit is None else {"units": told.unit or "1", **found}


def write_variables(path: Path, variables: Variables, coords: Variables, attributes: dict[str, Any]) -> None:
    """Write variables into a NetCDF file; one that is there is replaced.

    Parameters
    ----------
    path
        The file.
    variables, coords, attributes
        As for ``xarray.Dataset``; a coordinate with the name of its only dimension belongs to that dimension.
    """
    import h5netcdf

    arrays = {name: np.asarray(content) for name, (_, content, _) in {**variables, **coords}.items()}
    beside = {name: set(dims) for name, (dims, _, _) in coords.items() if tuple(dims) != (name,)}
    with h5netcdf.File(path, "w", decode_vlen_strings=True) as file:
        file.attrs.update(attributes)
        for name, (dims, _, told) in {**coords, **variables}.items():
            sizes = dict(zip(dims, arrays[name].shape, strict=True))
            file.dimensions.update({dim: size for dim, size in sizes.items() if dim not in file.dimensions})
            near = " ".join(sorted(other for other, needed in beside.items() if needed <= set(dims)))
            more = {"coordinates": near} if near and name not in coords else {}
            _add(file, name, tuple(dims), arrays[name], {**told, **more}, packed=name in variables)


def _add(file: Any, name: str, dims: tuple[str, ...], array: Any, told: dict[str, str], *, packed: bool) -> None:
    """Add one variable to an open file."""
    import h5py

    how: dict[str, Any] = {}
    if array.dtype.kind == "f":
        how["fillvalue"] = array.dtype.type(np.nan)
        if packed and array.size > LARGE:
            how |= {"compression": "gzip", "compression_opts": 4, "shuffle": True}
    elif array.dtype.kind == "b":
        array, told = array.astype(np.int8), {**told, "dtype": "bool"}
    texts = array.dtype.kind in "OU"
    made = file.create_variable(name, dims, h5py.string_dtype() if texts else array.dtype, **how)
    made.attrs.update(told)
    made[...] = array.astype(object) if texts else array
