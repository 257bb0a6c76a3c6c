"""What a worker sends, gathered for a test."""

import json
from types import SimpleNamespace

import numpy as np

from winkler.web.answer import Frame, Picture


def gathered(replies):
    """Return the parts of an answer, its pictures in one: a frame with ``pictures`` (charts decoded) and ``remark``."""
    found, pictures = [], []
    for reply in replies:
        if isinstance(reply, Picture):
            chart = decoded(json.loads(reply.chart)) if reply.chart else None
            pictures.append(SimpleNamespace(name=reply.name, title=reply.title, chart=chart, missing=reply.missing))
        elif isinstance(reply, Frame):
            assert reply.total == len(pictures)
            found.append(SimpleNamespace(pictures=pictures, remark=reply.remark))
            pictures = []
        else:
            found.append(reply)
    assert not pictures
    return found


def decoded(chart):
    """Return a chart with its coordinates as arrays."""
    for line in chart["data"] if isinstance(chart["data"], list) else []:
        for name in ("x", "y", "z"):
            if name in line:
                line[name] = np.array(line[name], dtype=float)
    return chart


def charts_of(frame):
    """Return name -> chart of a frame."""
    return {one.name: one.chart for one in frame.pictures}
