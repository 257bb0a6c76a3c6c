"""Pieces of a page: escaped text, sections, tables; all texts of a user are escaped."""

from __future__ import annotations

import html
import re
from collections.abc import Iterable

from winkler.values.readable import with_readable_numbers
from winkler.values.validity import Note, in_words, worst


def safe(text: object) -> str:
    """Return text that a page shows as it is.

    Examples
    --------
    >>> safe("<b>steel & 'stone'</b>")
    '&lt;b&gt;steel &amp; &#x27;stone&#x27;&lt;/b&gt;'
    """
    return html.escape(str(text), quote=True)


def with_fixed_units(sentence: str) -> str:
    """Return a sentence, escaped, with readable numbers and no line break between a number and its unit."""
    readable = with_readable_numbers(sentence)
    return re.sub(r"(\d) (?=[µa-zA-Z°⁰-⁹/]{1,6}[,.;) ])", "\\1\u00a0", safe(readable))


def assumed_line(sentence: str) -> str:
    """Return the line that says which numbers of a study nobody has given; nothing for an empty sentence."""
    return f'<p class="since assumed">{with_fixed_units(sentence)}</p>' if sentence else ""


def section(title: str, *parts: str) -> str:
    """Return a section of a page; empty parts are left out."""
    return f"<section>\n<h2>{safe(title)}</h2>\n" + "\n".join(part for part in parts if part) + "\n</section>"


def badge(notes: Iterable[Note]) -> str:
    """Return what a user may do with a result of these notes, as a page shows it."""
    told = tuple(notes)
    return f'<span class="standing {worst(told).value}">{safe(in_words(told))}</span>'


def number(text: str) -> str:
    """Return the cell of a table for a number, already escaped."""
    return f'<td class="number">{text}</td>'


def table(heads: list[str], rows: list[str]) -> str:
    """Return a table that scrolls by itself on narrow screens.

    Parameters
    ----------
    heads
        Cells of the heading, without their tags; one that begins with ``#`` stands over numbers, an empty one over what
        needs no heading.  None for no heading.
    rows
        Whole rows, with their tags.
    """
    cells = [_heading(head) for head in heads]
    top = f"<thead><tr>{''.join(cells)}</tr></thead>" if heads else ""
    return f'<div class="scroll" tabindex="0"><table>{top}<tbody>{"".join(rows)}</tbody></table></div>'


def _heading(head: str) -> str:
    if head.startswith("#"):
        return f'<th class="number">{head[1:]}</th>'
    return f"<th>{head}</th>" if head else "<td></td>"
