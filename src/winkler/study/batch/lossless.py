"""Numbers, arrays and values as JSON, from which they come back to the last digit, and as the same kinds.

Only objects of the classes that a caller names are created, so that a foreign file runs no code.
"""

from __future__ import annotations

import base64
import dataclasses
import math
import zlib
from collections.abc import Mapping
from typing import Any

import numpy as np

LEAST_COMPRESSED_BYTES = 4096
"""Arrays with more bytes are compressed."""
WORD = np.dtype(np.int64)


def packed(content: Any) -> Any:
    """Return numbers, arrays, texts, rows and values of them as JSON can hold them, with all their digits.

    Examples
    --------
    >>> packed((0.1, float("inf"), True, "µm"))
    [0.1, {'number': 'inf'}, True, 'µm']
    """
    if isinstance(content, np.ndarray):
        compressed = content.nbytes > LEAST_COMPRESSED_BYTES
        data = _compressed(content) if compressed else np.ascontiguousarray(content).tobytes()
        text = base64.b64encode(data).decode("ascii")
        mark = {"zlib": True} if compressed else {}
        return {"shape": list(content.shape), "type": content.dtype.str, **mark, "data": text}
    if dataclasses.is_dataclass(content):
        fields = {field.name: packed(getattr(content, field.name)) for field in dataclasses.fields(content)}
        return {"fields": type(content).__name__, **fields}
    if isinstance(content, float) and not math.isfinite(content):
        return {"number": str(content)}
    if isinstance(content, tuple | list):
        return [packed(item) for item in content]
    return content


def unpacked(content: Any, classes: Mapping[str, type]) -> Any:
    """Return the content that was packed; lists come back as tuples.

    Parameters
    ----------
    content
        The result of ``json.loads``.
    classes : mapping of str to type
        Allowed classes of values, by name.

    Raises
    ------
    KeyError
        If it holds a value of another class.

    Examples
    --------
    >>> unpacked(packed((0.1, float("inf"), np.arange(2.0))), {})
    (0.1, inf, array([0., 1.]))
    """
    if isinstance(content, list):
        return tuple(unpacked(item, classes) for item in content)
    if not isinstance(content, dict):
        return content
    if "number" in content:
        return float(content["number"])
    if "data" in content:
        data, kind, shape = base64.b64decode(content["data"]), np.dtype(content["type"]), tuple(content["shape"])
        if "zlib" in content:
            return _decompressed(data, kind, shape)
        return np.frombuffer(data, dtype=kind).reshape(shape)
    parts = {name: unpacked(item, classes) for name, item in content.items() if name != "fields"}
    return classes[content["fields"]](**parts)


def _compressed(content: np.ndarray[Any, Any]) -> bytes:
    """Return an array compressed: second differences of numbers of eight bytes, taken as whole numbers, byte by byte.

    Along smooth curves neighbours differ in their last bytes alone; whole numbers lose nothing where they overflow.
    """
    rows = np.ascontiguousarray(content)
    if rows.dtype.itemsize == WORD.itemsize:
        rows = np.diff(rows.view(WORD), n=2, axis=0, prepend=np.zeros((2, *rows.shape[1:]), WORD))
    planes = rows.reshape(-1).view(np.uint8).reshape(-1, rows.dtype.itemsize).T
    return zlib.compress(planes.tobytes(), 1)


def _decompressed(data: bytes, kind: np.dtype[Any], shape: tuple[int, ...]) -> np.ndarray[Any, Any]:
    planes = np.frombuffer(zlib.decompress(data), np.uint8).reshape(kind.itemsize, -1)
    rows = np.ascontiguousarray(planes.T).reshape(-1)
    if kind.itemsize == WORD.itemsize:
        rows = np.cumsum(np.cumsum(rows.view(WORD).reshape(shape), axis=0), axis=0)
    return np.frombuffer(rows.tobytes(), dtype=kind).reshape(shape)
