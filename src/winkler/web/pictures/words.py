"""Words of a picture as the browser sets them."""

from __future__ import annotations

import re

from winkler.study.language.explain import plain_symbol

__all__ = ["marked", "spoken_html"]


def marked(symbol: str) -> str:
    r"""Return a LaTeX symbol as plotly sets it: italic letters, indices below.

    Examples
    --------
    >>> marked("F_N"), marked("E^*"), marked(r"\sigma_{vM}")
    ('<i>F</i><sub>N</sub>', '<i>E</i><sup>*</sup>', '<i>σ</i><sub>vM</sub>')
    """
    if not symbol:
        return ""
    found = re.fullmatch(
        r"(\\?[A-Za-z]+|\\[A-Za-z]+ ?[A-Za-z])('*)(?:_(\{[^{}]*\}|\\?\w+))?(?:\^(\{[^{}]*\}|\*))?", symbol
    )
    if found is None:
        return plain_symbol(symbol)
    base, primes, below, above = found.groups()
    text = f"<i>{plain_symbol(base)}</i>{primes}"
    text += f"<sub>{plain_symbol(below)}</sub>" if below else ""
    return text + (f"<sup>{plain_symbol(above)}</sup>" if above else "")


def spoken_html(text: str) -> str:
    r"""Return words with LaTeX symbols between dollars as plotly sets them.

    Examples
    --------
    >>> spoken_html("area = $F_N$\n= 10 N")
    'area = <i>F</i><sub>N</sub><br>= 10 N'
    """
    parts = text.split("$")
    shown = (" − ".join(map(marked, part.split(" - "))) if place % 2 else part for place, part in enumerate(parts))
    return re.sub(r"\^\{?([\w/]+)\}?", r"<sup>\1</sup>", "".join(shown)).replace("\n", "<br>")
