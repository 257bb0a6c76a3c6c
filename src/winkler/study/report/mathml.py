r"""Formulas for web pages: LaTeX becomes MathML, which browsers display without scripts or fonts of this package.

A small part of LaTeX is understood: letters, numbers, signs, ``_`` and ``^``, primes, groups, ``\frac``, ``\sqrt``,
``\int``, ``\oint``, ``\sum``, ``\dot``, ``\bar``, ``\mathrm``, ``\text``, growing brackets by ``\left`` and ``\right``,
Greek letters and some signs.  Anything else is refused, so that a page never shows half a formula.
"""

from __future__ import annotations

import html
import re

from winkler.values.errors import InvalidInput

TOKEN = re.compile(r"\\[A-Za-z]+|\\[,;! ]|\d+(?:\.\d+)?|[A-Za-z]|\S")

LETTERS = {
    "alpha": "α", "beta": "β", "gamma": "γ", "delta": "δ", "epsilon": "ε", "theta": "θ", "kappa": "κ", "lambda": "λ",
    "mu": "μ", "nu": "ν", "pi": "π", "rho": "ρ", "sigma": "σ", "tau": "τ", "phi": "φ", "xi": "ξ", "psi": "ψ",
    "omega": "ω", "chi": "χ", "eta": "η", "zeta": "ζ", "varphi": "φ", "ell": "ℓ",
    "Delta": "Δ", "Gamma": "Γ", "Phi": "Φ", "Lambda": "Λ", "Omega": "Ω", "infty": "∞", "partial": "∂",
}  # fmt: skip
SIGNS = {
    "langle": "⟨", "rangle": "⟩", "le": "≤", "ge": "≥", "ne": "≠", "approx": "≈", "cdot": "·", "times": "×", "pm": "±",
    "to": "→", "dots": "…", "quad": "\u2003", ",": "\u2009", ";": "\u2005", " ": " ", "!": "",
}  # fmt: skip
LARGE_OPERATORS = {"int": "∫", "oint": "∮", "sum": "∑"}
ACCENTS = {"dot": "˙", "ddot": "¨", "bar": "¯"}
UPRIGHT_COMMANDS = ("mathrm", "text")
FUNCTION_NAMES = ("max", "min", "ln", "log", "sin", "cos", "tan", "arcsin", "arccos", "arctan")


def formula(latex: str) -> str:
    """Return a formula that stands on its own line.

    Parameters
    ----------
    latex
        Without dollars.

    Raises
    ------
    InvalidInput
        If a part of it is not understood.
    """
    return f'<math display="block">{_Reader(latex).whole()}</math>'


def inline(latex: str) -> str:
    r"""Return a formula or symbol inside a line of text; nothing for nothing.

    Examples
    --------
    >>> inline(r"\sigma_Y")
    '<math><msub><mi>σ</mi><mi>Y</mi></msub></math>'
    """
    return f"<math>{_Reader(latex).whole()}</math>" if latex else ""


def symbol(latex: str) -> str:
    """Return a symbol inside a line of text; a name that is no formula, such as a user's constant, as it is written.

    Examples
    --------
    >>> symbol("my__constant")
    '<i>my__constant</i>'
    """
    try:
        return inline(latex)
    except InvalidInput:
        return f"<i>{html.escape(latex)}</i>"


class _Reader:
    """Reads a formula from left to right."""

    def __init__(self, latex: str) -> None:
        self.latex = latex
        self.tokens = TOKEN.findall(latex)
        self.place = 0

    def whole(self) -> str:
        markup = self.row("")
        if self.place < len(self.tokens):
            raise self.unknown(self.tokens[self.place])
        return markup

    def unknown(self, token: str) -> InvalidInput:
        return InvalidInput(f"formula: '{token}' in '{self.latex}' is not understood; write it differently.")

    def peek(self) -> str:
        return self.tokens[self.place] if self.place < len(self.tokens) else ""

    def take(self) -> str:
        token = self.peek()
        self.place += 1
        return token

    def row(self, closing: str) -> str:
        """Read until the closing token, which is left."""
        parts = []
        while self.peek() and self.peek() not in (closing, "}", "\\right"):
            parts.append(self.scripted())
        return "".join(parts)

    def group(self) -> str:
        """Read ``{...}`` or a single piece, as one element."""
        if self.peek() != "{":
            return self.atom(self.take())
        self.take()
        start = self.place
        inside = self.row("}")
        if self.take() != "}":
            raise self.unknown("{")
        words = self.tokens[start : self.place - 1]
        if len(words) > 1 and all(re.fullmatch("[A-Za-z]", token) for token in words):
            return f"<mtext>{''.join(words)}</mtext>"
        return inside if len(words) == 1 else f"<mrow>{inside}</mrow>"

    def scripted(self) -> str:
        """Read a piece with its subscript and superscript."""
        token = self.take()
        base = self.atom(token)
        below, above, primes = "", "", 0
        while self.peek() in ("_", "^", "'"):
            sign = self.take()
            if (sign == "_" and below) or (sign == "^" and above):
                raise self.unknown(f"{sign}{sign}")
            if sign == "_":
                below = self.group()
            elif sign == "^":
                above = self.group()
            else:
                primes += 1
        if primes:
            above = f"<mrow>{'<mo>′</mo>' * primes}{above}</mrow>" if primes > 1 or above else "<mo>′</mo>"
        stacked = token == "\\sum"
        if below and above:
            tag = "munderover" if stacked else "msubsup"
            return f"<{tag}>{base}{below}{above}</{tag}>"
        if below or above:
            tag = ("munder" if below else "mover") if stacked else ("msub" if below else "msup")
            return f"<{tag}>{base}{below or above}</{tag}>"
        return base

    def atom(self, token: str) -> str:
        if token == "{":
            self.place -= 1
            return self.group()
        if token.startswith("\\"):
            return self.command(token[1:])
        if not token or token in "}_^&#$%\\":
            raise self.unknown(token or "the end")
        if token[0].isdigit():
            return f"<mn>{token}</mn>"
        if token.isalpha():
            return f"<mi>{token}</mi>"
        fence = ' stretchy="false"' if token in "()[]|" else ""
        return f"<mo{fence}>{html.escape({'-': '−', '*': '∗'}.get(token, token))}</mo>"

    def command(self, name: str) -> str:
        if name == "frac":
            return f"<mfrac>{self.group()}{self.group()}</mfrac>"
        if name == "sqrt":
            return f"<msqrt>{self.group()}</msqrt>"
        if name in ACCENTS:
            return f'<mover accent="true"><mrow>{self.group()}</mrow><mo>{ACCENTS[name]}</mo></mover>'
        if name in UPRIGHT_COMMANDS:
            return self.upright(name)
        if name == "left":
            opening = self.take()
            inside = self.row("\\right")
            if self.take() != "\\right":
                raise self.unknown("\\left")
            return f"<mrow><mo>{html.escape(opening)}</mo>{inside}<mo>{html.escape(self.take())}</mo></mrow>"
        if name in LARGE_OPERATORS:
            return f"<mo>{LARGE_OPERATORS[name]}</mo>"
        if name in LETTERS:
            return f"<mi>{LETTERS[name]}</mi>"
        if name in FUNCTION_NAMES:
            return f'<mi mathvariant="normal">{name}</mi>'
        if name in SIGNS:
            return (
                f"<mtext>{SIGNS[name]}</mtext>"
                if SIGNS[name].isspace() or not SIGNS[name]
                else f"<mo>{SIGNS[name]}</mo>"
            )
        raise self.unknown(f"\\{name}")

    def upright(self, name: str) -> str:
        if self.take() != "{":
            raise self.unknown(f"\\{name}")
        words = []
        while self.peek() not in ("}", ""):
            words.append(self.take())
        self.take()
        text = (" " if name == "text" else "").join(words)
        return (
            f"<mtext>{html.escape(text)}</mtext>"
            if name == "text"
            else f'<mi mathvariant="normal">{html.escape(text)}</mi>'
        )
