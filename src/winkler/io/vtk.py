r"""Fields inside the bodies as VTK files, for ParaView, VisIt and PyVista.

A file is a structured grid, in VTK's legacy format, version 3.0, binary (big-endian doubles), or in VTK's XML with raw
numbers behind it (.vts), of which a collection (.pvd) lists those of a time series.  Libraries were tried: pyevtk and
meshio have no tensors on structured grids, vtk weighs a hundred megabytes.  Lengths are in m and stresses in Pa; x and
y lie along the surface, z points into the first body.  An axisymmetric field is rotated about the axis:

.. math:: \sigma_{xx} = \sigma_r\cos^2\varphi + \sigma_\theta\sin^2\varphi, \quad
          \sigma_{xy} = (\sigma_r - \sigma_\theta)\sin\varphi\cos\varphi, \quad
          \sigma_{xz} = \tau_{rz}\cos\varphi .
"""

from __future__ import annotations

import math
import os
from collections.abc import Mapping
from itertools import pairwise
from pathlib import Path
from typing import NamedTuple
from xml.sax.saxutils import quoteattr

import numpy as np

from winkler.fields.restoration import SubsurfaceFields
from winkler.foundation.sheared_fields import BodyFields
from winkler.io.whole_file import write_whole
from winkler.numerics.types import Array
from winkler.problems.conduction.fields import CurrentFields, HeatFields
from winkler.values.checks.number_checks import affordable
from winkler.values.errors import InvalidInput
from winkler.values.limits import MOST_NUMBERS

HALF_PLANE = 1
"""Number of planes for which an axisymmetric field is written in the half-plane y = 0, x > 0 alone."""
MOST_STATES = 200
"""Of a time series: each is a file, all of which are open until all are written, and a process may open 256."""

BodyField = SubsurfaceFields | BodyFields | CurrentFields | HeatFields


class _PointGrid(NamedTuple):
    """Points `(3, n1, n2, n3)`, and the fields there: scalars, vectors `(3, ...)` and tensors `(3, 3, ...)`."""

    points: Array
    scalars: dict[str, Array]
    vectors: dict[str, Array]
    tensors: dict[str, Array]


def write_vtk(
    fields: BodyField | Mapping[float, BodyField],
    path: str | os.PathLike[str],
    *,
    around: int = HALF_PLANE,
) -> Path:
    """Write fields inside the bodies, or a time series of fields, as structured grids of VTK.

    Parameters
    ----------
    fields
        What ``restore(solution, r, z)``, ``restore_body(solution, x, y, z)`` or ``restore_conduction(solution, r, z)``
        returns, on a grid: ``restore(solution, r[:, None], z[None, :])``.  Or a mapping of times [s], rising, to such
        fields.
    path : str or path
        The file; its ending must be ``.vtk`` (legacy format) or ``.vts`` (XML); of a time series ``.pvd``, beside
        which the states are written as ``NAME_0000.vts``, ``NAME_0001.vts`` ...
    around : int, optional
        For axisymmetric fields: planes through the axis, evenly spaced over the full turn; the first one is repeated
        at the end to close the body.  The default 1 writes only the half-plane y = 0, x > 0.

    Returns
    -------
    Path

    Raises
    ------
    InvalidInput
        If the ending is another one, the file cannot be written, the fields are no such fields or not on a grid, or
        the times do not rise.

    Notes
    -----
    The file contains the stress tensor, the displacement vector, the von Mises stress and the maximum shear stress.
    For a current it contains current density, potential and temperature; for heat the heat flux and the excess
    temperature.  The z axis of tensors and vectors in the second body (z < 0) has the same direction as in the first:
    out of the second body.

    References
    ----------
    W. Schroeder, K. Martin, B. Lorensen, The Visualization Toolkit, 4th ed., Kitware 2006: simple legacy formats
    """
    target = Path(path)
    if isinstance(around, bool) or not isinstance(around, int) or not (around == HALF_PLANE or 3 <= around <= 10_000):
        raise InvalidInput(f"write_vtk: around is {around!r}; give 1 for a half-plane, or 3 to 10000 planes.")
    series = isinstance(fields, Mapping)
    endings = (".pvd",) if series else (".vtk", ".vts")
    if target.suffix not in endings:
        raise InvalidInput(f"{target}: the ending is {target.suffix!r}; give {' or '.join(endings)}.")
    if isinstance(fields, Mapping):
        write_whole(_series(target, fields, around))
    elif target.suffix == ".vts":
        write_whole({target: _xml_content(_grid_of(fields, around))})
    else:
        write_whole({target: _file_content(_grid_of(fields, around), type(fields).__name__)})
    return target


def _grid_of(fields: BodyField, around: int) -> _PointGrid:
    if isinstance(fields, SubsurfaceFields | CurrentFields | HeatFields):
        affordable("write_vtk", "places", (around + 1) * np.broadcast(fields.r, fields.z).size, MOST_NUMBERS // 16)
    match fields:
        case SubsurfaceFields():
            return _revolved(_stress_half_plane(fields), around)
        case CurrentFields() | HeatFields():
            return _revolved(_flux_half_plane(fields), around)
        case BodyFields():
            if around != HALF_PLANE:
                raise InvalidInput("write_vtk: BodyFields are not axisymmetric; leave around out.")
            return _body_grid(fields)
        case _:
            raise InvalidInput(
                f"write_vtk: a {type(fields).__name__} is no field inside the bodies; give what restore(solution, r, "
                "z), restore_body(solution, x, y, z) or restore_conduction(solution, r, z) returns."
            )


def _series(target: Path, states: Mapping[float, BodyField], around: int) -> dict[Path, bytes]:
    """Return the files of a time series: the states, and the collection that lists them."""
    try:
        times = [float(time) for time in states]
    except (TypeError, ValueError):
        raise InvalidInput("write_vtk: a time is no number; give a mapping of times [s] to fields.") from None
    if not times or not all(map(math.isfinite, times)) or any(after <= before for before, after in pairwise(times)):
        raise InvalidInput("write_vtk: the times must be finite and rise, at least one; give {time: fields, ...}.")
    affordable("write_vtk", "states", len(times), MOST_STATES)
    digits = max(4, len(str(len(times) - 1)))
    names = [f"{target.stem}_{place:0{digits}d}.vts" for place in range(len(times))]
    files = {
        target.with_name(name): _xml_content(_grid_of(fields, around))
        for name, fields in zip(names, states.values(), strict=True)
    }
    listed = [
        f'<DataSet timestep="{time!r}" part="0" file={quoteattr(name)}/>\n'
        for name, time in zip(names, times, strict=True)
    ]
    return files | {target: _xml_file("Collection", f"<Collection>\n{''.join(listed)}</Collection>\n").encode("utf-8")}


class _HalfPlane(NamedTuple):
    """A field in the half-plane of r and z, on a grid of at most two axes: radial, hoop, axial and shear parts."""

    r: Array
    z: Array
    scalars: dict[str, Array]
    vectors: dict[str, tuple[Array, Array]]
    tensors: dict[str, tuple[Array, Array, Array, Array]]


def _plane(numbers: Array) -> Array:
    """Return numbers on a grid of two axes."""
    if numbers.ndim > 2:
        raise InvalidInput(f"write_vtk: the places have the shape {numbers.shape}; give r[:, None] and z[None, :].")
    return numbers.reshape(numbers.shape + (1,) * (2 - numbers.ndim))


def _stress_half_plane(fields: SubsurfaceFields) -> _HalfPlane:
    sign = np.where(fields.z < 0.0, -1.0, 1.0)  # each body has its own axis, into itself
    stress = fields.radial_stress, fields.hoop_stress, fields.axial_stress, sign * fields.shear_stress
    return _HalfPlane(
        fields.r,
        fields.z,
        {"von_mises": fields.von_mises, "max_shear": fields.max_shear},
        {"displacement": (fields.radial_displacement, sign * fields.axial_displacement)},
        {"stress": stress},
    )


def _flux_half_plane(fields: CurrentFields | HeatFields) -> _HalfPlane:
    r, z = np.broadcast_arrays(fields.r, fields.z)
    if isinstance(fields, CurrentFields):
        density = fields.radial_current_density, fields.axial_current_density
        scalars = {"potential": fields.potential, "temperature": fields.temperature}
        return _HalfPlane(r, z, scalars, {"current_density": density}, {})
    flux = fields.radial_heat_flux, fields.axial_heat_flux
    return _HalfPlane(r, z, {"excess_temperature": fields.excess_temperature}, {"heat_flux": flux}, {})


def _revolved(half: _HalfPlane, around: int) -> _PointGrid:
    """Return the field of a half-plane rotated about the axis."""
    angles = np.linspace(0.0, 2.0 * math.pi, around + 1) if around != HALF_PLANE else np.zeros(1)
    cos, sin = np.cos(angles)[:, None], np.sin(angles)[:, None]
    rows, columns = _plane(half.r).shape
    flat = np.zeros((rows, angles.size, columns))

    def full(numbers: Array) -> Array:
        return _plane(numbers)[:, None, :] + flat

    def times(radial: Array, factor: Array) -> Array:
        return _plane(radial)[:, None, :] * factor[None] + flat

    vectors = {
        name: np.stack([times(radial, cos), times(radial, sin), full(axial)])
        for name, (radial, axial) in half.vectors.items()
    }
    tensors = {}
    for name, (radial, hoop, axial, shear) in half.tensors.items():
        xx = times(radial, cos**2) + times(hoop, sin**2)
        yy = times(radial, sin**2) + times(hoop, cos**2)
        xy = times(radial - hoop, sin * cos)
        xz, yz = times(shear, cos), times(shear, sin)
        tensors[name] = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, full(axial)]])
    points = np.stack([times(half.r, cos), times(half.r, sin), full(half.z)])
    return _PointGrid(points, {name: full(numbers) for name, numbers in half.scalars.items()}, vectors, tensors)


def _body_grid(fields: BodyFields) -> _PointGrid:
    shape = np.shape(fields.x)
    if len(shape) > 3:
        raise InvalidInput(f"write_vtk: the places have the shape {shape}; give a grid of at most three axes.")
    whole = shape + (1,) * (3 - len(shape))
    sign = np.where(fields.z < 0.0, -1.0, 1.0).reshape(whole)
    xx, yy, zz, xy, xz, yz = (
        getattr(fields, f"{name}_stress").reshape(whole) for name in ("xx", "yy", "zz", "xy", "xz", "yz")
    )
    xz, yz = sign * xz, sign * yz
    displacement = [getattr(fields, f"{name}_displacement").reshape(whole) for name in "xyz"]
    return _PointGrid(
        np.stack([fields.x.reshape(whole), fields.y.reshape(whole), fields.z.reshape(whole)]),
        {"von_mises": fields.von_mises.reshape(whole), "max_shear": fields.max_shear.reshape(whole)},
        {"displacement": np.stack([displacement[0], displacement[1], sign * displacement[2]])},
        {"stress": np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])},
    )


def _file_content(grid: _PointGrid, title: str) -> bytes:
    """Return the bytes of a legacy file; the first axis runs fastest in it."""
    shape = grid.points.shape[1:]
    count = math.prod(shape)

    def raw(numbers: Array, parts: int) -> bytes:
        return _rows(numbers, parts, shape, ">f8") + b"\n"

    pieces = [
        f"# vtk DataFile Version 3.0\nwinkler {title}, SI units\nBINARY\nDATASET STRUCTURED_GRID\n"
        f"DIMENSIONS {shape[0]} {shape[1]} {shape[2]}\nPOINTS {count} double\n".encode("ascii"),
        raw(grid.points, 3),
        f"POINT_DATA {count}\n".encode("ascii"),
    ]
    for name, numbers in grid.scalars.items():
        pieces += [f"SCALARS {name} double 1\nLOOKUP_TABLE default\n".encode("ascii"), raw(numbers, 1)]
    for name, numbers in grid.vectors.items():
        pieces += [f"VECTORS {name} double\n".encode("ascii"), raw(numbers, 3)]
    for name, numbers in grid.tensors.items():
        pieces += [f"TENSORS {name} double\n".encode("ascii"), raw(numbers, 9)]
    return b"".join(pieces)


def _rows(numbers: Array, parts: int, shape: tuple[int, ...], kind: str) -> bytes:
    """Return numbers with the parts of a point together, the first axis of the points fastest."""
    return np.ascontiguousarray(numbers.reshape(parts, *shape).transpose(3, 2, 1, 0), dtype=kind).tobytes()


def _xml_content(grid: _PointGrid) -> bytes:
    """Return the bytes of a structured grid in XML; its numbers follow the underscore, each array behind its length."""
    shape = grid.points.shape[1:]
    extent = " ".join(f"0 {count - 1}" for count in shape)
    blocks: list[bytes] = []

    def array(name: str, numbers: Array, parts: int) -> str:
        place = sum(map(len, blocks))
        content = _rows(numbers, parts, shape, "<f8")
        blocks.append(len(content).to_bytes(8, "little") + content)
        return (
            f'<DataArray type="Float64" Name="{name}" NumberOfComponents="{parts}" format="appended" '
            f'offset="{place}"/>\n'
        )

    points = array("points", grid.points, 3)
    fields = "".join(
        array(name, numbers, parts)
        for parts, group in ((1, grid.scalars), (3, grid.vectors), (9, grid.tensors))
        for name, numbers in group.items()
    )
    described = (
        f'<StructuredGrid WholeExtent="{extent}">\n<Piece Extent="{extent}">\n<PointData>\n{fields}</PointData>\n'
        f"<Points>\n{points}</Points>\n</Piece>\n</StructuredGrid>\n"
    )
    start, end = _xml_file("StructuredGrid", f'{described}<AppendedData encoding="raw">\n_@</AppendedData>\n').split(
        "@"
    )
    return start.encode("utf-8") + b"".join(blocks) + b"\n" + end.encode("utf-8")


def _xml_file(kind: str, content: str) -> str:
    version = 'version="1.0" byte_order="LittleEndian" header_type="UInt64"'
    return f'<?xml version="1.0"?>\n<VTKFile type="{kind}" {version}>\n{content}</VTKFile>\n'
