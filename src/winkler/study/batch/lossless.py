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

__all__ = ["packed", "unpacked"]

LEAST_COMPRESSED_BYTES = 4096
"""Arrays with more bytes are compressed."""


def packed(content: Any) -> Any:
    """Return numbers, arrays, texts, rows and values of them as JSON can hold them, with all their digits.

    Examples
    --------
    >>> packed((0.1, float("inf"), True, "µm"))
    [0.1, {'number': 'inf'}, True, 'µm']
    """
    if isinstance(content, np.ndarray):
        data = np.ascontiguousarray(content).tobytes()
        compression = {"zlib": True} if len(data) > LEAST_COMPRESSED_BYTES else {}
        data = zlib.compress(data, 1) if compression else data
        text = base64.b64encode(data).decode("ascii")
        return {"shape": list(content.shape), "type": content.dtype.str, **compression, "data": text}
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
        data = base64.b64decode(content["data"])
        data = zlib.decompress(data) if "zlib" in content else data
        return np.frombuffer(data, dtype=content["type"]).reshape(content["shape"])
    parts = {name: unpacked(item, classes) for name, item in content.items() if name != "fields"}
    return classes[content["fields"]](**parts)
