"""Texts and bytes that readers get: spoilt tables, spoilt bytes, formulas and quantities of any kind."""

from __future__ import annotations

from random import Random

import fuzz_words

CELLS = [
    *("", "nan", "-inf", "1e999", "1,5", "0x10", "--", "1_000", "ß", "9" * 400, "# c", "\t", "radius", "[m]", '"', "'"),
    *("1e-320", "True", "1+2j", "٣", "=1+1", "2024-01-01", "1.2.3", "\x00", "1 000", "1.000,5", "[[]]", "\ufeff1"),
]
BINARY = [
    *(b"", b"PK\x03\x04", b"\x93NUMPY\x01\x00", b"\xef\xbb\xbf", b"\xff\xfe", b"\x1f\x8b\x08", b"\x89HDF\r\n\x1a\n"),
    *(b"CDF\x01", b"\x00\x02", b"[problem]\n", b"ISO_1\n", b"BZh9", b"\xfd7zXZ\x00", b"DataFile\0", b"\x00" * 64),
]
OPERATORS = ["+", "-", "*", "/", "**", " - ", "**-", "//", "%", "^", ",", ".", "", "<", "==", "@", "&", ":=", "="]
NAMES = ["r", "r", "r", "R", "c", "pi", "e", "x", "__import__", "r.real", "lambda", "r[0]", "None", "'r'", "1j", "inf"]
FUNCTIONS = [
    *("sqrt", "sin", "cos", "tan", "exp", "log", "sinh", "cosh", "tanh", "arcsin", "arccos", "arctan", "abs", "max"),
    *("eval", "open", "where", "power", "factorial", "Sqrt", "gamma"),
]


def spoilt_table(rng: Random, text: str) -> bytes:
    """Return a table with cells, lines, separators or bytes changed."""
    lines = text.split("\n")
    for _ in range(rng.randint(1, 4)):
        place = rng.randrange(len(lines))
        cells = lines[place].split(",")
        what = rng.choice(
            ("cell", "cell", "cell", "number", "line", "take", "twice", "separator", "swap", "column", "long")
        )
        if what in ("cell", "number"):
            word = str(fuzz_words.number(rng)) if what == "number" else rng.choice((*CELLS, fuzz_words.text(rng, 6)))
            cells[rng.randrange(len(cells))] = word
            lines[place] = ",".join(cells)
        elif what == "line":
            lines.insert(place, fuzz_words.text(rng, 30))
        elif what == "take" and len(lines) > 1:
            del lines[place]
        elif what == "twice":
            lines[place:place] = [lines[place]] * rng.choice((1, 2, 50))
        elif what == "separator":
            lines[place] = rng.choice((";", "\t", " ", ",,", "|")).join(cells)
        elif what == "column":
            take = rng.randrange(len(cells))
            lines = [",".join(row[:take] + row[take + 1 :]) for row in (line.split(",") for line in lines)]
        elif what == "long":
            lines[place] += rng.choice((" ", ",", "#", "9", "\t")) * 3000
        else:
            lines[place] = ",".join(reversed(cells))
    content = rng.choice(("\n", "\n", "\r\n", "\r")).join(lines)
    encoded = content.encode(rng.choice(("utf-8", "utf-8", "utf-8", "utf-16", "utf-8-sig")), "surrogatepass")
    return spoilt_bytes(rng, encoded) if rng.random() < 0.25 else encoded


def spoilt_bytes(rng: Random, whole: bytes) -> bytes:
    """Return bytes of which some were changed, put in, moved or cut off."""
    for _ in range(rng.choice((1, 1, 2, 4))):
        place, width = rng.randint(0, len(whole)), rng.choice((1, 1, 2, 8, 64))
        what = rng.choice(("change", "flip", "insert", "cut", "take", "twice", "start"))
        if what == "change":
            whole = whole[:place] + rng.randbytes(width) + whole[place + width :]
        elif what == "flip" and place < len(whole):
            whole = whole[:place] + bytes([whole[place] ^ (1 << rng.randrange(8))]) + whole[place + 1 :]
        elif what == "insert":
            whole = whole[:place] + rng.choice((rng.randbytes(width), rng.choice(BINARY))) + whole[place:]
        elif what == "cut":
            whole = whole[:place]
        elif what == "take":
            whole = whole[:place] + whole[place + width :]
        elif what == "twice":
            whole = whole[:place] + whole[max(0, place - width) :]
        else:
            whole = rng.choice(BINARY) + whole
    return whole


def formula(rng: Random, deep: int = 4) -> str:
    """Return a formula, of which most can be read."""
    what = rng.random()
    if what < 0.04:
        return fuzz_words.text(rng, 30)
    if deep == 0 or what < 0.3:
        return rng.choice(NAMES[: 7 if rng.random() < 0.93 else None])
    if what < 0.45:
        value = fuzz_words.number(rng) if rng.random() < 0.4 else rng.randint(0, 9)
        return f"{value!r}"
    if what < 0.6:
        name = rng.choice(FUNCTIONS[: 12 if rng.random() < 0.95 else None])
        return f"{name}({formula(rng, deep - 1)})"
    if what < 0.7:
        return f"({formula(rng, deep - 1)})"
    operator = rng.choice(OPERATORS[: 5 if rng.random() < 0.96 else None])
    return f"{formula(rng, deep - 1)}{operator}{formula(rng, deep - 1)}"


def quantity(rng: Random) -> str:
    """Return a quantity as a text, of which a part may be wrong."""
    what = rng.random()
    if what < 0.3:
        return fuzz_words.quantity(rng)
    if what < 0.4:
        return fuzz_words.text(rng, 30)
    if what < 0.5:
        return "".join(rng.choices("0123456789.eE+-*/^()  mkNPaGdegCs,µ°%", k=rng.randint(0, 30)))
    unit = ""
    for _ in range(rng.randint(1, 4)):
        unit += rng.choice(("", "*", "/", " ", "·")) + rng.choice(fuzz_words.UNITS[:16])
        unit += rng.choice(("", "", "^2", "^-1", "²"))
    return f"{fuzz_words.number(rng)} {unit}"
