r"""Letters of a picture: the width of a text, and the text with its LaTeX symbols as elements of SVG.

Widths are those of DejaVu Sans, which is wider than the fonts that stand in for it, so that a picture has room in each.
"""

from __future__ import annotations

import re
from html import escape
from typing import NamedTuple

from winkler.values.errors import InvalidInput
from winkler.values.readable import GREEK

FONT = "DejaVu Sans,Verdana,Bitstream Vera Sans,sans-serif"
LINE_HEIGHT = 1.2
"""Distance of two lines over the size of the letters."""
RISE, FALL = 0.76, 0.24
"""Height of a line above and below its base line, over the size of the letters."""
SMALLER, RAISED, LOWERED = 0.72, 0.38, -0.16
"""Of raised and lowered letters: their size, and their places over the size of the letters around them."""

ADVANCES = {
    167: "⁄", 227: "′", 275: "'", 278: "ijl", 295: "IJΙ", 318: " \u00a0,.·‘’⋅",
    337: "/:;\\|", 338: "ι", 352: "f", 361: "-",
    374: "″", 390: "()[]⟨⟩", 392: "t", 401: "!²³⁰¹⁴⁵⁶⁷⁸⁹", 411: "r", 413: "ℓ", 460: '"', 500: "*_`°–∥", 517: "∂",
    518: "“”", 521: "s∫", 525: "z", 528: "⁻", 531: "?", 541: "ε", 544: "ζ", 550: "cç", 557: "LΓ", 558: "ξ", 559: "ν",
    575: "F", 578: "χ", 579: "kυ", 587: "ς", 589: "κ", 592: "vxyγλ", 602: "πτ", 603: "PΡ", 611: "TYΤΥ", 612: "oöδθο",
    613: "aä", 615: "eéèϵ", 619: "ϑ", 630: "ß", 632: "EΕΞΣ", 634: "hnuüñℎησ", 635: "Sbdgpqρϱ", 636: "$0123456789{}µμ",
    637: "√", 638: "β", 656: "KΚ", 659: "α", 660: "φψϕ", 669: "∆", 674: "∑", 684: "AVÄΑΔΛ", 685: "XZΖΧ", 686: "BΒ",
    695: "R", 698: "C", 714: "∝", 732: "UÜ", 748: "NΝ", 752: "HΗΠ", 764: "Ω", 770: "D", 775: "G", 780: "&",
    787: "OQÖΘΟΦΨ", 818: "w", 833: "∞", 837: "ω", 838: "#+<=>^~±×÷−∓≈≠≤≥→←∼", 863: "MΜ", 871: "⊥", 950: "%", 974: "m",
    989: "W", 1000: "@—…", 0: "\u0304\u0307\u0302\u0303", 200: "\u2009",
}  # fmt: skip
"""Advance in thousandths of the size of the letters -> the letters that have it."""
OF = {letter: advance / 1000.0 for advance, letters in ADVANCES.items() for letter in letters}
OTHER = 1.0
"""Width of a letter that the table does not hold."""
BOLD = 1.12
"""Greatest mean width of bold words over that of others."""

ACCENTS = {"bar": "\u0304", "overline": "\u0304", "dot": "\u0307", "hat": "\u0302", "tilde": "\u0303"}
SIGNS = {
    "pm": "±", "mp": "∓", "propto": "∝", "infty": "∞", "cdot": "·", "times": "×", "le": "≤", "ge": "≥", "approx": "≈",
    "int": "∫", "partial": "∂", "sum": "∑", "langle": "⟨", "rangle": "⟩", "to": "→", "sqrt": "√", "Phi": "Φ",
    "Gamma": "Γ", "pi": "π", "chi": "χ", "varepsilon": "ε", "Sigma": "Σ", "Omega": "Ω",
}  # fmt: skip
FUNCTIONS = ("log", "ln", "exp", "tan", "sin", "cos", "max", "min", "arctan")
UPRIGHT = ("mathrm", "text", "operatorname")
SPACES = {",": "\u2009", ";": " ", " ": " ", "!": ""}
BETWEEN = frozenset("−+=<>±∝≈≤≥→")
"""Signs that have a space at either side where they stand between two terms."""


class Run(NamedTuple):
    """Letters of one look: the text, whether it is italic, and its size and rise over those of the text."""

    text: str
    italic: bool = False
    size: float = 1.0
    rise: float = 0.0


class Rectangle(NamedTuple):
    """A rectangle [pt], with y downwards."""

    left: float
    top: float
    right: float
    bottom: float

    def grown(self, by: float) -> Rectangle:
        """Return the rectangle with an edge around it."""
        return Rectangle(self.left - by, self.top - by, self.right + by, self.bottom + by)

    def drawn(self, look: str) -> str:
        """Return it as an element of SVG with some attributes."""
        wide, high = self.right - self.left, self.bottom - self.top
        return f'<rect x="{self.left:.2f}" y="{self.top:.2f}" width="{wide:.2f}" height="{high:.2f}" {look}/>'

    def meets(self, other: Rectangle) -> bool:
        """Return whether two rectangles have an area in common."""
        return (
            self.left < other.right and other.left < self.right and self.top < other.bottom and other.top < self.bottom
        )


def runs_of(text: str) -> list[Run]:
    r"""Return one line of text, with LaTeX symbols between dollars, as letters of one look each.

    Raises
    ------
    InvalidInput
        If a symbol has a command that pictures do not know.

    Examples
    --------
    >>> [(run.text, run.rise) for run in runs_of("force $F_N$")]
    [('force ', 0.0), ('F', 0.0), ('N', -0.16)]
    """
    found: list[Run] = []
    for place, part in enumerate(text.split("$")):
        if place % 2:
            found += _symbols(part)
        elif part:
            found.append(Run(part))
    return _joined(found)


def _joined(found: list[Run]) -> list[Run]:
    """Return runs of which neighbours of one look are one."""
    joined: list[Run] = []
    for run in found:
        if joined and joined[-1][1:] == run[1:]:
            joined[-1] = run._replace(text=joined[-1].text + run.text)
        else:
            joined.append(run)
    return joined


def _symbols(latex: str, upright: bool = False) -> list[Run]:
    found: list[Run] = []
    place = 0
    while place < len(latex):
        letter = latex[place]
        if letter in "_^":
            inner, place = _next(latex, place + 1, upright)
            lift = RAISED if letter == "^" else LOWERED
            found += [run._replace(size=SMALLER * run.size, rise=lift + SMALLER * run.rise) for run in inner]
        else:
            inner, place = _next(latex, place, upright)
            between = found and found[-1].text not in "([|/" and any(run.text in BETWEEN for run in inner)
            found += [run._replace(text=f" {run.text} ") for run in inner] if between else inner
    return found


def _next(latex: str, place: int, upright: bool) -> tuple[list[Run], int]:
    """Return the next letter, group or command, and the place after it."""
    letter = latex[place]
    if letter == "{":
        depth, end = 1, place + 1
        while depth:
            depth += {"{": 1, "}": -1}.get(latex[end], 0)
            end += 1
        return _symbols(latex[place + 1 : end - 1], upright), end
    if letter != "\\":
        if letter == " ":
            return [], place + 1
        sign = {"-": "−", "'": "′", "*": "*"}.get(letter, letter)
        return [Run(sign, italic=sign.isalpha() and not upright)], place + 1
    if latex[place + 1] in SPACES:
        return [Run(SPACES[latex[place + 1]])], place + 2
    name = re.match(r"[A-Za-z]+", latex[place + 1 :])
    if name is None:
        raise InvalidInput(f"a picture has the symbol {latex!r}, which it cannot write; use letters and their indices.")
    end = place + 1 + len(name[0])
    while end < len(latex) and latex[end] == " ":
        end += 1
    if name[0] in UPRIGHT:
        return _next(latex, end, True)
    if name[0] in ACCENTS:
        inner, end = _next(latex, end, upright)
        return [*inner[:-1], inner[-1]._replace(text=inner[-1].text + ACCENTS[name[0]])], end
    if name[0] in ("left", "right"):
        return [], end
    if name[0] in FUNCTIONS:
        return [Run(name[0])], end
    sign = SIGNS.get(name[0]) or GREEK.get(name[0], "")
    if not sign:
        raise InvalidInput(f"a picture has the command \\{name[0]}, which it cannot write; use letters and indices.")
    return [Run(sign, italic=sign.isalpha() and sign.islower())], end


def run_width(run: Run) -> float:
    """Return the width of letters of one look over the size of the text."""
    return run.size * sum(OF.get(letter, OTHER) for letter in run.text)


def width_of(text: str, size: float, *, bold: bool = False) -> float:
    """Return the width of the longest line of a text [pt]."""
    return size * (BOLD if bold else 1.0) * max(sum(map(run_width, runs_of(line))) for line in text.split("\n"))


def text_box(
    text: str, x: float, y: float, size: float, *, across: str = "center", upright: str = "center",
    turned: bool = False, bold: bool = False, spacing: float = LINE_HEIGHT,
) -> Rectangle:  # fmt: skip
    """Return the rectangle of a text at a place.

    Parameters
    ----------
    text
        Lines.
    x, y, size
        [pt], y downwards.
    across, upright
        Which point of the text lies there: ``left``, ``center`` or ``right``, and ``top``, ``center``, ``bottom`` or
        ``baseline``.
    turned
        Whether it is read upwards.
    bold
        Whether its letters are bold.
    spacing
        Distance of the lines over the size of the letters.
    """
    lines = text.count("\n") + 1
    wide, high = width_of(text, size, bold=bold), size * ((RISE + FALL) + (lines - 1) * spacing)
    if turned:
        wide, high = high, wide
    left = x - {"left": 0.0, "center": 0.5, "right": 1.0}[across] * wide
    below = high - size * FALL if upright == "baseline" else {"top": 0.0, "center": 0.5, "bottom": 1.0}[upright] * high
    return Rectangle(left, y - below, left + wide, y - below + high)


def text_element(
    text: str, x: float, y: float, size: float, *, across: str = "center", upright: str = "center",
    turned: bool = False, bold: bool = False, spacing: float = LINE_HEIGHT, colour: str = "", kind: str = "",
) -> str:  # fmt: skip
    """Return a text at a place as elements of SVG; `colour` and the class `kind` are left out if empty."""
    lines = text.split("\n")
    box = text_box(text, x, y, size, across=across, upright=upright, turned=turned, bold=bold, spacing=spacing)
    sides = {"left": "start", "center": "middle", "right": "end", "bottom": "start", "top": "end"}
    anchor = sides[upright if turned else across]
    look = f'font-size="{size:g}" text-anchor="{anchor}"'
    look += ' font-weight="bold"' if bold else ""
    look += f' fill="{colour}"' if colour else ""
    look += f' class="{kind}"' if kind else ""
    found = []
    for place, line in enumerate(lines):
        along = size * (RISE + place * spacing)
        if turned:
            level = {"start": box.bottom, "middle": 0.5 * (box.top + box.bottom), "end": box.top}[anchor]
            where = f'transform="translate({box.left + along:.1f} {level:.1f}) rotate(-90)"'
        else:
            where = f'x="{x:.1f}" y="{box.top + along:.1f}"'
        found.append(f"<text {where} {look}>{_spans(runs_of(line), size)}</text>")
    return "".join(found)


def _spans(runs: list[Run], size: float) -> str:
    """Return letters as spans; each says how far its base line lies from that of the one before."""
    found, level = [], 0.0
    for run in runs:
        look = ' font-style="italic"' if run.italic else ""
        look += f' font-size="{run.size * size:.3g}"' if run.size != 1.0 else ""
        look += f' dy="{(level - run.rise) * size:.3g}"' if run.rise != level else ""
        level = run.rise
        text = escape(run.text, quote=False).replace("  ", " \u00a0")  # of two spaces a page shows one
        found.append(f"<tspan{look}>{text}</tspan>" if look else text)
    return "".join(found)
