"""Text of a picture as HTML of the browser."""

from __future__ import annotations

import re

from winkler.study.language.explain import plain_symbol


def symbol_html(symbol: str) -> str:
    r"""Return a LaTeX symbol as HTML: italic letters, subscripts and superscripts.

    Examples
    --------
    >>> symbol_html("F_N"), symbol_html("E^*"), symbol_html(r"\sigma_{vM}")
    ('<i>F</i><sub>N</sub>', '<i>E</i><sup>*</sup>', '<i>σ</i><sub>vM</sub>')
    >>> symbol_html(r"h_\mathrm{rms}"), symbol_html("x_0, y_0")
    ('<i>h</i><sub>rms</sub>', '<i>x</i><sub>0</sub>, <i>y</i><sub>0</sub>')
    >>> symbol_html(r"\bar T") == "<i>T\u0304</i>"
    True
    """
    if not symbol:
        return ""
    if ", " in symbol:
        return ", ".join(map(symbol_html, symbol.split(", ")))
    symbol = symbol.replace(r"\mathrm{", "{")
    match = re.fullmatch(
        r"(\\?[A-Za-z]+|\\[A-Za-z]+ ?[A-Za-z])('*)(?:_(\{[^{}]*\}|\\?\w+))?(?:\^(\{[^{}]*\}|\*))?", symbol
    )
    if match is None:
        return plain_symbol(symbol)
    base, primes, below, above = match.groups()
    text = f"<i>{plain_symbol(base)}</i>{primes}"
    text += f"<sub>{plain_symbol(below)}</sub>" if below else ""
    return text + (f"<sup>{plain_symbol(above)}</sup>" if above else "")


def text_html(text: str) -> str:
    r"""Return text with LaTeX symbols between dollars as HTML.

    Examples
    --------
    >>> text_html("area = $F_N$\n= 10 N")
    'area = <i>F</i><sub>N</sub><br>= 10 N'
    """
    parts = text.split("$")
    parts_html = (
        " − ".join(map(symbol_html, part.split(" - "))) if place % 2 else part for place, part in enumerate(parts)
    )
    return re.sub(r"\^\{?([\w/]+)\}?", r"<sup>\1</sup>", "".join(parts_html)).replace("\n", "<br>")


def text_plain(text: str) -> str:
    """Return text with LaTeX symbols between dollars as text alone.

    Examples
    --------
    >>> text_plain("stress below $x$")
    'stress below x'
    """
    return "".join(plain_symbol(part) if place % 2 else part for place, part in enumerate(text.split("$")))
