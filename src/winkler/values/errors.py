"""The errors of the package.

::

    WinklerError
    |-- InvalidInput      (also a ValueError)   what was given cannot be used
    |-- OutsideValidity   (also a ValueError)   the input is sound, the theory does not reach it
    |-- NotConverged      (also an ArithmeticError)   a solver did not converge; it never returns half a result
    |-- Mistake           (also a RuntimeError)   winkler itself is wrong; only points of a sweep are caught so
    `-- Interrupted       the reader stopped a batch; finished parts remain

Each message states what was given, what is allowed, and what to do, in one sentence on one line.  An error about
several mistakes has several sentences, each on a line of its own.  `suggest` finds the nearest known word,
`mistake_in` describes an unexpected error.

Words that are usual elsewhere, in papers and other programs, and the names that winkler has for them.

Where several names are listed, the first that is offered at that place is meant: the radius of a ball is its
``curvature_radius``, that of a contact its ``radius``.
"""

from __future__ import annotations

import difflib
import re
from collections.abc import Callable, Collection, Iterable
from typing import Self

LONGEST_TEXT = 300
"""Longer texts of unexpected errors are cut."""
MISTYPED = 0.8
"""Least similarity, by difflib, of a misspelt word to the known one."""
MOST_LISTED, NEAREST = 12, 4
"""Names that a sentence lists; of more it names so many."""
ADDRESS = re.compile(r" at 0x[0-9A-Fa-f]+")
"""In the ``repr`` of an object that has none of its own."""


class WinklerError(Exception):
    r"""Base class of all winkler errors; `exit_code` is the exit code of the command line.

    Each argument is one sentence, and becomes one line.

    Examples
    --------
    >>> str(WinklerError("the force is [1.\n 2.] N; give one number.", "the depth is missing; add it."))
    'the force is [1. 2.] N; give one number.\nthe depth is missing; add it.'
    """

    exit_code = 1

    def __init__(self, *sentences: str) -> None:
        # where an object lies in memory says nothing, and differs from run to run
        # one line, also where the ``repr`` of an array has several
        super().__init__(
            *(" ".join(filter(None, map(str.strip, ADDRESS.sub("", one).splitlines()))) for one in sentences)
        )

    def __str__(self) -> str:
        return "\n".join(self.args)

    def reworded(self, change: Callable[[str], str]) -> Self:
        """Return the error with each of its sentences changed, and with its notes."""
        other = type(self)(*map(change, self.args))
        for note in getattr(self, "__notes__", ()):
            other.add_note(note)
        return other


class InvalidInput(WinklerError, ValueError):
    """The input cannot be used: a wrong sign, unit, file, name or number."""

    exit_code = 2


class NotConverged(WinklerError, ArithmeticError):
    """A numerical method did not reach its tolerance."""

    exit_code = 3


class OutsideValidity(WinklerError, ValueError):
    """The input is valid, but the theory does not apply to it."""

    exit_code = 4


class Mistake(WinklerError, RuntimeError):
    """Points of a sweep met an error that winkler does not raise on purpose: winkler is wrong, not what was given."""

    exit_code = 70


class Interrupted(WinklerError):
    """A batch was stopped by its reader; what had been done is kept."""

    exit_code = 130


def mistake_in(error: BaseException) -> str:
    r"""Return one clause that attributes an unexpected error to winkler: what it is, and where it was raised.

    Examples
    --------
    >>> mistake_in(ValueError("f(a) and f(b) must\n have different signs"))
    'winkler made a mistake (ValueError: f(a) and f(b) must have different signs)'
    """
    text = " ".join(str(error).split())
    text = text if len(text) <= LONGEST_TEXT else f"{text[:LONGEST_TEXT]}..."
    place, frame = "", error.__traceback__
    while frame is not None:
        module = str(frame.tb_frame.f_globals.get("__name__", ""))
        if module.startswith("winkler."):
            place = f" at {module}:{frame.tb_lineno}"
        frame = frame.tb_next
    return f"winkler made a mistake ({type(error).__name__}: {text}{place})"


def nearest(word: str, known: Iterable[str]) -> str:
    """Return the known word that `word` was meant to be, or an empty string.

    The same word in capitals or small letters; one for which that word is usual elsewhere;
    one of similar spelling; one that has it as a part, or is a part of it.

    Examples
    --------
    >>> nearest("depht", ["force", "depth"]), nearest("nu", ["young", "poisson"]), nearest("poisson_ratio", ["poisson"])
    ('depth', 'poisson', 'poisson')
    """
    names = list(known)
    same = [name for name in names if name.lower() == word.lower() and len(word) > 1]
    meant = [name for name in SYNONYMS.get(word) or SYNONYMS.get(word.lower(), ()) if name in names]
    if same or meant:
        return (same or meant)[0]
    if close := difflib.get_close_matches(word, names, n=1, cutoff=0.6):
        return close[0]
    parts = [name for name in names if word in name.split("_") or name in word.split("_")]
    return parts[0] if len(parts) == 1 else ""


def mistyped(word: str, known: Iterable[str]) -> list[str]:
    """Return those of the known words of which `word` is a misspelling: few letters differ, or two changed places.

    Examples
    --------
    >>> mistyped("indentaton", ["indentation", "impact"]), mistyped("fti", ["fit"]), mistyped("gear", ["wear"])
    (['indentation'], ['fit'], [])
    """
    names = list(known)
    swapped = [name for name in names if sorted(name) == sorted(word)]
    return swapped or difflib.get_close_matches(word, names, cutoff=MISTYPED)


def listed(word: str, names: Collection[str]) -> str:
    """Return names for a sentence: of many only the nearest few to a word, and where all are listed.

    Examples
    --------
    >>> listed("forse", ["depth", "force"])
    'depth, force'
    """
    if len(names) <= MOST_LISTED:
        return ", ".join(names)
    near = difflib.get_close_matches(word, names, n=NEAREST) or [*names][:NEAREST]
    return f"{', '.join(near)} and {len(names) - len(near)} more, which `winkler show` lists"


def suggest(word: str, known: Iterable[str]) -> str:
    """Return `` (did you mean 'x'?)`` for the known word nearest to `word`, or an empty string."""
    near = nearest(word, known)
    return f" (did you mean '{near}'?)" if near else ""


SYNONYMS: dict[str, tuple[str, ...]] = {
    # symbols
    "a": ("radius",),
    "d": ("depth",),
    "delta": ("depth",),
    "e": ("young", "modulus"),
    "e_star": ("modulus",),
    "estar": ("modulus",),
    "f": ("force", "coefficient"),
    "fn": ("force",),
    "fx": ("shear_force",),
    "g": ("shear", "shear_modulus"),
    "g_star": ("shear_modulus",),
    "gamma": ("work",),
    "h": ("depth", "thickness"),
    "k": ("stiffness", "normal_stiffness", "rate"),
    "m": ("mass",),
    "mu": ("coefficient",),
    "n": ("force", "count", "cycles", "exponent"),
    "nu": ("poisson",),
    "p": ("force", "pressure"),
    "phi": ("angle",),
    "r": ("curvature_radius", "flat_radius", "radius"),
    "sigma_y": ("strength",),
    "sigma_zz": ("pressure",),
    "tau": ("traction", "relaxation_time"),
    "theta": ("half_angle",),
    "ux": ("shift",),
    "v": ("velocity", "speed"),
    "w12": ("work",),
    # words
    "adhesion_energy": ("work",),
    "alpha": ("half_angle",),
    "angle": ("half_angle",),
    "approach": ("depth",),
    "contact_size": ("radius",),
    "creepage": ("drive",),
    "creepages": ("drive",),
    "dist": ("stroke", "distance"),
    "elastic_modulus": ("young", "modulus"),
    "extent": ("reach",),
    "force_density": ("line_load",),
    "friction": ("coefficient", "law"),
    "geometry": ("profile",),
    "indentation": ("depth",),
    "indenter": ("profile",),
    "load": ("force", "normal"),
    "material": ("medium", "first"),
    "model": ("law",),
    "npts": ("count",),
    "penetration": ("depth",),
    "radius": ("curvature_radius", "flat_radius"),
    "rigid_profile": ("gap",),
    "shape": ("profile",),
    "solid": ("medium", "first"),
    "substrate": ("on", "medium"),
    "surface_energy": ("work",),
    "tip": ("profile",),
    "yield_stress": ("strength",),
    # public names
    "Ball": ("Sphere",),
    "DMT": ("DerjaguinMullerToporov",),
    "Hertz": ("Indentation",),
    "JKR": ("ShortRange",),
    "Maugis": ("Dugdale",),
    "Mindlin": ("Tangential",),
    "Punch": ("FlatPunch",),
    "Substrate": ("HalfSpace",),
}
"""Symbols and words are looked up in small letters; public names as they are written."""
