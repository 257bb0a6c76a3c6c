"""Numbers as text for readers: with the prefix that fits them, so that 0.000187 m is 187 µm.

Contents are SI, units those of the glossary.
"""

from __future__ import annotations

import math
import re
from typing import Any, NamedTuple

import numpy as np

PREFIXES = {-18: "a", -15: "f", -12: "p", -9: "n", -6: "µ", -3: "m", 0: "", 3: "k", 6: "M", 9: "G", 12: "T"}

PREFIXED = ("m", "N", "Pa", "J", "W", "s", "V", "A", "Hz", "K", "ohm", "S", "N m", "ohm m")
"""Units that take a prefix when they stand first and without a power: µm, kN, MN/m, mN m."""
POWERS = {"m^2": (2, 1e-2), "m^3": (3, 1e-3)}
"""Areas and volumes -> power of the metre, and the least number that its prefix may leave."""

GREEK = {
    "epsilon": "ε", "theta": "θ", "lambda": "λ", "mu": "μ", "nu": "ν", "phi": "φ", "sigma": "σ", "tau": "τ",
    "alpha": "α", "gamma": "γ", "rho": "ρ", "beta": "β", "eta": "η", "zeta": "ζ", "kappa": "κ", "omega": "ω",
    "varphi": "φ", "psi": "ψ", "ell": "ℓ", "Delta": "Δ", "delta": "δ", "Lambda": "Λ", "xi": "ξ",
    "infty": "∞", "tan": "tan ", "int": "∫",
}  # fmt: skip
"""Names of letters and signs in LaTeX -> the letters."""

WHOLE_BELOW = 1e6
"""Largest number whose rounded digits are written as zeros."""
RAW_NUMBER = re.compile(
    r"(?<![\w.])(\d+(?:\.\d+)?e[+-]?\d+|0\.0\d+)(?: ((?:m|N|Pa|J|W|s|V|A|K)(?:/[msN])?)(?![\w/^*]| [mNJs]\b))?"
)
"""A number with a power of ten, or with zeros behind the point, and its unit if a prefix fits that."""
SUPERSCRIPT = str.maketrans("0123456789-", "⁰¹²³⁴⁵⁶⁷⁸⁹⁻")


NAMES_IN_WORDS = {
    "r": "distance from the axis",
    "x": "place",
    "y": "place across",
    "z": "depth below the surface",
    "von_mises": "von Mises stress",
    "radius": "contact radius",
    "hurst": "Hurst exponent",
    "gap": "equivalent profile",
    "line_load": "load of the springs",
    "von_mises_depth": "depth of greatest von Mises stress",
    "max_shear": "greatest shear stress",
    "max_shear_depth": "depth of greatest shear stress",
    "orthogonal_shear": "orthogonal shear stress",
    "orthogonal_shear_depth": "depth of orthogonal shear stress",
    "long_axis_shear": "orthogonal shear stress, long axis",
    "long_axis_shear_depth": "depth of orthogonal shear, long axis",
    "max_temperature": "greatest temperature",
    "first_max_temperature": "greatest temperature of the first body",
    "second_max_temperature": "greatest temperature of the second body",
    "first_mean_temperature": "mean temperature of the first body",
    "second_mean_temperature": "mean temperature of the second body",
    "first_share": "share of the first body",
    "stick_share": "part of the contact that sticks",
    "hardened_share": "part of the contact at its hardness",
    "misfit": "error of the solver",
    "penetration": "overlap left by the solver",
    "holm_radius": "Holm radius",
    "pull_off_force_per_length": "pull-off force per length",
    "young": "Young's modulus",
    "poisson": "Poisson's ratio",
    "modulus": "effective modulus",
    "shear": "shear modulus",
}
"""Names in words that differ from the field names."""


class Scale(NamedTuple):
    """How numbers of one unit are shown: SI value = `factor` times the shown number, in `unit`."""

    factor: float
    unit: str


def pretty_unit(unit: str) -> str:
    """Return a unit with its whole powers set as superscripts.

    Examples
    --------
    >>> pretty_unit("N/m^2"), pretty_unit("m^-3"), pretty_unit("m^1.5")
    ('N/m²', 'm⁻³', 'm^1.5')
    """
    unit = unit.replace("ohm", "Ω")
    return re.sub(r"\^(-?\d+)(?![\d.])", lambda match: match[1].translate(SUPERSCRIPT), unit)


def scale_of(unit: str | None, *contents: Any) -> Scale:
    """Return the prefix that fits the greatest of the finite numbers; degrees for radians.

    Parameters
    ----------
    unit
        Of the glossary; None counts as none.
    contents : array_like
        What is to be shown together, SI.

    Examples
    --------
    >>> scale_of("m", [0.0, 187e-6])
    Scale(factor=1e-06, unit='µm')
    """
    if not unit:
        return Scale(1.0, "")
    if unit == "rad":
        return Scale(math.pi / 180.0, "°")
    unit = re.sub(r"\^1(?![\d.])", "", unit)
    if unit == "1/Pa":  # compliances of rubber are numbers per megapascal
        least = scale_of("Pa", *(1.0 / part[part > 0.0] for part in map(_finite, contents)))
        return Scale(1.0 / least.factor, f"1/{least.unit}")
    head, slash, tail = unit.partition("/")
    greatest = max((float(np.max(part)) for part in map(_finite, contents) if part.size), default=0.0)
    if head in POWERS:
        times, least_number = POWERS[head]
        reached = greatest * (1.0 + 1e-9)
        fitting = [power for power in PREFIXES if power <= 0 and reached >= least_number * 10.0 ** (times * power)]
        power = max(fitting, default=0) if greatest > 0.0 else 0
        return Scale(float(f"1e{times * power}"), pretty_unit(f"{PREFIXES[power]}{head}{slash}{tail}"))
    if head not in PREFIXED:
        return Scale(1.0, pretty_unit(unit))
    power = 3 * math.floor(math.log10(greatest * (1.0 + 1e-9)) / 3.0) if greatest > 0.0 else 0
    power = min(max(PREFIXES) if head not in ("m", "s", "K") else 0, power)
    power = power if power in PREFIXES else 0  # what is smaller than all prefixes stands in powers of ten
    return Scale(float(f"1e{power}"), pretty_unit(f"{PREFIXES[power]}{head}{slash}{tail}"))


def middle_scale(unit: str | None, content: Any) -> Scale:
    """Return the prefix that fits the median of the numbers: for tables and logarithmic axes.

    Examples
    --------
    >>> middle_scale("N", [1.0, 10.0, 100.0, 1e3])
    Scale(factor=1.0, unit='N')
    """
    sizes = _finite(content)
    sizes = sizes[sizes > 0.0]
    return scale_of(unit, float(np.median(sizes)) if sizes.size else 0.0)


def _finite(content: Any) -> np.ndarray:
    numbers: np.ndarray = np.abs(np.asarray(content, dtype=float)).ravel()
    return np.asarray(numbers[np.isfinite(numbers)])


def with_unit(number: float, unit: str | None, digits: int = 4, *, beside: float | None = None) -> str:
    """Return a number with its unit for reading; in the unit of a number that stands beside it, if there is one.

    Examples
    --------
    >>> with_unit(1.8662e-4, "m"), with_unit(0.3, ""), with_unit(2.1e11, "Pa")
    ('186.6 µm', '0.3', '210 GPa')
    >>> with_unit(5.5e-8, "m^2"), with_unit(1.2e-15, "m^3"), with_unit(5.3e-23, "m"), with_unit(0.0018, "N m")
    ('0.055 mm²', '1200 µm³', '5.3·10⁻²³ m', '1.8 mN m')
    >>> with_unit(1.374e-12, "m^3/s", beside=2.643e-14)
    '1.374·10⁶ µm³/s'
    >>> with_unit(math.inf, "ohm"), with_unit(math.nan, "")
    ('infinite', 'undefined')

    Rounded digits before the point are written as zeros:

    >>> with_unit(0.2394, "Pa", 2), with_unit(-1.52e8, "Pa", 2)
    ('240 mPa', '−150 MPa')
    """
    if not math.isfinite(number):
        return "undefined" if math.isnan(number) else f"{'−' * (number < 0.0)}infinite"
    scale = scale_of(unit, number if beside is None else beside)
    text = f"{number / scale.factor:.{digits}g}".replace("-", "−")
    if "e+" in text and abs(float(text.replace("−", "-"))) < WHOLE_BELOW:
        text = f"{float(text.replace('−', '-')):.0f}".replace("-", "−")
    elif "e" in text:
        mantissa, exponent = text.split("e")
        power = str(int(exponent.replace("−", "-"))).translate(SUPERSCRIPT)
        text = f"{mantissa}·10{power}"
    return f"{text}{'' if scale.unit == '°' else ' '}{scale.unit}".rstrip()


def with_readable_numbers(sentence: str) -> str:
    """Return a sentence whose numbers with a power of ten have the prefix of a unit, or few digits, in its place.

    Examples
    --------
    >>> with_readable_numbers("stretched by 3.55e-09 m, a strength of 1.67e+08 Pa, up to 4.1e+02 per cent")
    'stretched by 3.55 nm, a strength of 167 MPa, up to 410 %'
    >>> with_readable_numbers("1e+02 per cent of 0.0109 m")
    '100 % of 10.9 mm'
    >>> with_readable_numbers("a drift of 4e-11 m/s under 2.5e+04 N/m")
    'a drift of 40 pm/s under 25 kN/m'
    >>> with_readable_numbers("0.000201 m below, with 2e-05 of it; E1e-3 and 1.5 m stay")
    '201 µm below, with 2·10⁻⁵ of it; E1e-3 and 1.5 m stay'
    """

    def readable(found: re.Match[str]) -> str:
        digits = len(found[1].partition("e")[0].replace(".", "").lstrip("0"))
        if "e" not in found[1] and not found[2]:
            return found[0]
        return with_unit(float(found[1]), found[2] or "", max(digits, 1))

    return re.sub(r"(?<=\d) per cent\b", " %", RAW_NUMBER.sub(readable, sentence))


def name_in_words(name: str) -> str:
    """Return a field name in words: ``line_load`` is the load of the springs."""
    return NAMES_IN_WORDS.get(name, name.replace("_", " "))
