"""Surfaces of triangles (.stl), where each place has one height: their heights on a grid of pixels."""

from __future__ import annotations

import re
from pathlib import Path

import numpy as np

from winkler.io.height_matrix import MapContents, point_map, refuse_many
from winkler.io.text_file import content_of
from winkler.numerics.types import Array
from winkler.values.errors import InvalidInput
from winkler.values.limits import FILE_BYTES

HEAD_SIZE, COUNT_SIZE = 80, 4
FACET = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])
VERTEX = re.compile(rb"vertex[ \t]++([-+0-9.eE]{1,30}+)[ \t]++([-+0-9.eE]{1,30}+)[ \t]++([-+0-9.eE]{1,30}+)")


def mesh_map(path: Path) -> MapContents:
    """Return the height map of a file of triangles, without a unit: pixels as many as corners, heights between these.

    Raises
    ------
    InvalidInput
        If it is cut, or a body whose faces do not all look up or all down.
    """
    corners = _corners(content_of(path, FILE_BYTES), path)
    refuse_many(len(corners), path)
    if not np.all(np.isfinite(corners)):
        raise InvalidInput(f"{path}: a corner of its triangles is not finite; save the surface anew.")
    upward = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])[:, 2]
    if not len(corners) or (np.any(upward > 0.0) and np.any(upward < 0.0)):
        raise InvalidInput(
            f"{path}: its {len(corners)} triangles are no surface with one height at each place; cut it open, so that "
            "all of them look up, or save its heights as rows x, y, z."
        )
    return point_map(path, np.unique(corners.reshape(-1, 3), axis=0), joined=True)


def _corners(content: bytes, path: Path) -> Array:
    """Return the corners of all triangles ``(n, 3, 3)``."""
    count = int.from_bytes(content[HEAD_SIZE : HEAD_SIZE + COUNT_SIZE], "little")
    begin = HEAD_SIZE + COUNT_SIZE
    if len(content) == begin + count * FACET.itemsize:
        return np.frombuffer(content, FACET, count, begin)["corners"].astype(float)
    found = VERTEX.findall(content) if content.lstrip().startswith(b"solid") else []
    if not found or len(found) % 3:
        raise InvalidInput(f"{path}: this is no whole file of triangles; save it anew.")
    try:
        return np.array(found, dtype=float).reshape(-1, 3, 3)
    except ValueError:
        raise InvalidInput(f"{path}: a corner of its triangles is no number; save the surface anew.") from None
