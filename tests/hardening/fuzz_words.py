"""Numbers, quantities and words as no study should have them: what the cases of fuzz tests are made of."""

from __future__ import annotations

import copy
import math
from random import Random
from typing import Any

EDGES = [
    *(0, 1, -1, 2, 2**31, 2**63 - 1, -(2**63), 10**30),
    *(0.0, -0.0, 0.5, 1.0, -1.0, 1.5, 5e-324, 1e-320, 1e-300, 1e-59, 1e-30, 1e-9, 1e9, 1e30, 1e59, 1e300),
    *(1.7976931348623157e308, -1e308, math.nan, math.inf, -math.inf, 0.1 + 0.2, 1.0 - 2**-53, 1.0 + 2**-52),
]
UNITS = [
    *("m", "mm", "um", "nm", "N", "kN", "Pa", "GPa", "deg", "rad", "K", "degC", "1/s", "m^-3", "J/m^2", "s", "kg", "%"),
    *("", " ", "furlong", "m**9999", "N/0", "m^(1e9)", "m^^2", "m^", "/m", "mm mm", "µm", "μm⁻¹", "degC/m", "N m", "a"),
    *("m/m/m", "delta_degC", "1e3", "m^0.3333333333333333", "dB", "[m]", "m;import os", "GPa" * 40),
]
TEXTS = [
    *("", " ", "infinite", "nan", "inf", "true", "None", "__class__", "file", "../..", "/etc/passwd", "C:\\x", "."),
    *("r**9**9**9", "1 m; 2 m", "\x00", "\x1b[2J", "\u202e", "\ufeff", "\u2028", "μ", "ß" * 300, "{}", "%s%n", "{0.a}"),
    *(
        "1,5 mm",
        "1 000 mm",
        "0x10",
        "1e",
        "-",
        "--1",
        "１２ mm",
        "٣ mm",
        "1e999 m",
        "9" * 400 + " m",
        "\t1\tmm",
        "NaN m",
    ),
]
LETTERS = "abcrxRz0123456789.,;:=+-*/^()[]{}<>\"'\\#%&|~ \t\n\r_eE\x00\x07\x1b\x85\xa0µ²⁻ß\u2028\u202e\ufffd😀"


def number(rng: Random) -> float | int:
    """Return a number of any size, or an edge."""
    what = rng.random()
    if what < 0.4:
        return rng.choice(EDGES)
    if what < 0.6:
        return rng.randint(-3, 12)
    return rng.choice((1.0, 1.0, 1.0, -1.0)) * 10.0 ** rng.uniform(-12.0, 12.0)


def text(rng: Random, most: int = 20) -> str:
    """Return a text, of letters that mean something somewhere."""
    if rng.random() < 0.4:
        return rng.choice(TEXTS)
    return "".join(rng.choices(LETTERS, k=rng.randint(0, most)))


def quantity(rng: Random) -> str:
    """Return a number and a unit that need not go together."""
    return f"{number(rng)}{rng.choice((' ', '', '  ', '*', chr(0xA0)))}{rng.choice(UNITS)}"


def leaf(rng: Random) -> Any:
    """Return anything that stands at one key."""
    make = rng.choice((number, quantity, quantity, text, lambda rng: rng.random() < 0.5))
    return make(rng)


def content(rng: Random, tables: list[dict[str, Any]], deep: int = 3) -> Any:
    """Return anything: a leaf, a range, a part of a study, or lists and tables of them."""
    what = rng.random()
    if what < 0.5 or deep == 0:
        return leaf(rng)
    if what < 0.6:
        return {"from": leaf(rng), "to": leaf(rng), "count": number(rng), "spacing": rng.choice(("log", "linear", ""))}
    if what < 0.65:
        return {"values": content(rng, tables, deep - 1), "unit": rng.choice(UNITS)}
    if what < 0.8:
        return copy.deepcopy(rng.choice(tables))
    if what < 0.9:
        return [content(rng, tables, deep - 1) for _ in range(rng.choice((0, 1, 2, 3, 3, 40)))]
    return {text(rng, 8): content(rng, tables, deep - 1) for _ in range(rng.randint(0, 3))}
