"""NetCDF files of variables with units and meanings, written as xarray writes them, without loading it.

A dataset consists of a table of variables and one of coordinates, name -> (dimensions, numbers, attributes), and its
attributes: the arguments of ``xarray.Dataset``.  The conventions of the file are those of CF
(cfconventions.org): NaN is the fill value of floats, and ``coordinates`` names the auxiliary coordinates of a variable.
"""

from __future__ import annotations

import functools
import io
import logging
from typing import Any

import numpy as np

from winkler.values.vocabulary import Word

LOG = logging.getLogger(__name__)
LEAST_COMPRESSED = 1000
"""Arrays of floats with more numbers are compressed, without loss."""

Variables = dict[str, tuple[tuple[str, ...], Any, dict[str, str]]]
"""Name -> dimensions, numbers, attributes."""


def netcdf_attributes(entry: Word) -> dict[str, str]:
    """Return unit, meaning and symbol of a word as the attributes of a variable."""
    texts = {"long_name": entry.meaning, "symbol": entry.symbol}
    return texts if entry.unit is None else {"units": entry.unit or "1", **texts}


@functools.cache
def has_netcdf() -> bool:
    """Return whether NetCDF files can be written; a process says once that they cannot."""
    try:
        import h5netcdf  # noqa: F401
        import h5py  # noqa: F401
    except (ImportError, OSError) as error:
        why = " ".join(str(error).split()).rstrip(".")
        LOG.warning(
            "winkler: no NetCDF file is written, as h5netcdf or h5py cannot be loaded (%s); all other results are.", why
        )
        return False
    return True


def netcdf_file(variables: Variables, coords: Variables, attributes: dict[str, Any]) -> bytes:
    """Return a NetCDF file of variables, made in memory: on a full disk the library ends the process.

    Parameters
    ----------
    variables, coords, attributes
        As for ``xarray.Dataset``; a coordinate with the name of its only dimension belongs to that dimension.
    """
    import h5netcdf

    arrays = {name: np.asarray(content) for name, (_, content, _) in {**variables, **coords}.items()}
    auxiliary = {name: set(dims) for name, (dims, _, _) in coords.items() if tuple(dims) != (name,)}
    store = io.BytesIO()
    with h5netcdf.File(store, "w", decode_vlen_strings=True) as file:
        file.attrs.update(attributes)
        for name, (dims, _, attached) in {**coords, **variables}.items():
            sizes = dict(zip(dims, arrays[name].shape, strict=True))
            file.dimensions.update({dim: size for dim, size in sizes.items() if dim not in file.dimensions})
            near = " ".join(sorted(other for other, needed in auxiliary.items() if needed <= set(dims)))
            more = {"coordinates": near} if near and name not in coords else {}
            _add(file, name, tuple(dims), arrays[name], {**attached, **more}, packed=name in variables)
    return store.getvalue()


def _add(file: Any, name: str, dims: tuple[str, ...], array: Any, attached: dict[str, str], *, packed: bool) -> None:
    """Add one variable to an open file."""
    import h5py

    options: dict[str, Any] = {}
    if array.dtype.kind == "f":
        if dims != (name,):  # a coordinate has no gaps, and may state no value for them
            options["fillvalue"] = array.dtype.type(np.nan)
        if packed and array.size > LEAST_COMPRESSED:
            options |= {"compression": "gzip", "compression_opts": 4, "shuffle": True}
    elif array.dtype.kind == "b":
        array, attached = array.astype(np.int8), {**attached, "dtype": "bool"}
    texts = array.dtype.kind in "OU"
    variable = file.create_variable(name, dims, h5py.string_dtype() if texts else array.dtype, **options)
    variable.attrs.update(attached)
    variable[...] = array.astype(object) if texts else array
