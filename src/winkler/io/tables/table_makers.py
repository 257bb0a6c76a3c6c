"""Who has written a text table, by a word above it."""

from __future__ import annotations

from collections.abc import Sequence

__all__ = ["maker_in"]

MAKERS = {
    "Number of Points =": "Hysitron, text export",
    "Anton Paar": "Anton Paar, text export",
    "CSM Instruments": "CSM Instruments, text export",
    "NanoTest": "Micro Materials, text export",
    "Piuma": "Optics11, text export",
    "Chiaro": "Optics11, text export",
    "iMicro": "KLA, text export",
}
"""What stands above a table that its header makes readable, and who writes it."""
HEAD_LINES = 60


def maker_in(head: Sequence[str]) -> str:
    """Return who has written a text table, by a word in the lines above it; "text table" if none is known."""
    above = "\n".join(head[:HEAD_LINES])
    return next((maker for word, maker in MAKERS.items() if word in above), "text table")
