"""What stands at the top of every file: what it is, its units and signs, what goes in and out, how far it holds."""

from __future__ import annotations

import textwrap

from winkler.exporting.step_law import StepLaw
from winkler.io.traces import CONVENTIONS

WIDTH = 112


def heading_lines(law: StepLaw) -> list[str]:
    """Return the heading in lines of text, without marks of a comment."""
    lines = [law.title + ".", "Written by winkler from its own source; do not change it, export it again.", ""]
    lines += ["Conventions"]
    for sentence in CONVENTIONS:
        lines += _item(sentence)
    lines += ["", "Made for"]
    for text in law.inputs:
        lines += _item(text)
    for what, quantities in (("in", law.motion), ("out", law.answer)):
        lines += ["", f"What goes {what} in every step" if what == "in" else "What comes out"]
        for one in quantities:
            lines += _item(f"{one.name} [{one.unit or '-'}]: {one.meaning}")
    lines += ["", "How far it holds"]
    for note in law.notes:
        lines += _item(note)
    return lines


def _item(text: str) -> list[str]:
    return textwrap.wrap(text, WIDTH, initial_indent="- ", subsequent_indent="  ")
