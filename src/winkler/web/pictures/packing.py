"""A figure as JSON for the browser."""

from __future__ import annotations

from typing import Any

import numpy as np
import orjson

from winkler.web.pictures.chart import Chart


def packed(chart: Chart) -> str:
    """Return a figure as JSON, its numbers in single precision."""
    return orjson.dumps(_single(chart), option=orjson.OPT_SERIALIZE_NUMPY).decode()


def _single(content: Any) -> Any:
    if isinstance(content, dict):
        return {name: _single(item) for name, item in content.items()}
    if isinstance(content, list | tuple):
        return [_single(item) for item in content]
    if isinstance(content, np.ndarray) and content.dtype.kind == "i":
        return np.ascontiguousarray(content)
    if isinstance(content, np.ndarray):
        return np.ascontiguousarray(content, dtype=np.float32)
    return content.item() if isinstance(content, np.generic) else content
