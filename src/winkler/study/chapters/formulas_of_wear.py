"""The formulas behind the answers for contacts that wear."""

from __future__ import annotations

from typing import Any

from winkler.problems.wear.fretting import FrettingWear
from winkler.problems.wear.limiting_profile import LimitingProfile
from winkler.problems.wear.sliding import SlidingWear
from winkler.study.chapters.formula import Formula

__all__ = ["worn"]

SWUNG = Formula(
    "Pushed to and fro by the amplitude U, every spring goes along until friction holds it no longer",
    r"u_t(x) = \min\left(U, \mu\,\frac{E^*}{G^*}\,(d-g(x))\right)",
)
SLIP = Formula(
    "What they fall short is the slip of the surfaces, restored around the axis",
    r"s(r) = \frac{2}{\pi}\int_0^r \frac{U-u_t(x)}{\sqrt{r^2-x^2}}\,\mathrm{d}x",
)
FRETTED = Formula(
    "In a cycle every point slips four times that far, and its worn depth grows with the pressure (for Archard's law)",
    r"\frac{\mathrm{d}f}{\mathrm{d}n} = 4\,\kappa\,p(r)\,s(r)",
)
SLID = Formula(
    "Where a surface slides, its worn depth grows with pressure and distance (for Archard's law)",
    r"\frac{\mathrm{d}f}{\mathrm{d}s} = \kappa\,p(r)",
)
ANEW = Formula(
    "The worn profile is turned into springs anew, and so on; what was worn off changes the springs by",
    r"\Delta g(x) = \Delta f(0) + x\int_0^x \frac{\Delta f'(r)}{\sqrt{x^2-r^2}}\,\mathrm{d}r",
)
CORE = Formula("The core that sticks for ever ends at c", r"G^*\,U = \mu\,E^*\,(d-g(c))")
LIMIT = Formula(
    "and in the end nothing else bears: the worn surface is that which the core's pressure leaves the other one",
    r"f_\infty(r) = d-u(r) = \frac{2}{\pi}\left(\int_0^c \frac{g(x)}{\sqrt{r^2-x^2}}\,\mathrm{d}x "
    r"+ d\,\arccos\frac{c}{r}\right)",
)


def worn(problem: Any) -> tuple[Formula, ...]:
    """Return the formulas of a problem of wear; none of others."""
    match problem:
        case FrettingWear():
            return SWUNG, SLIP, FRETTED, ANEW
        case SlidingWear():
            return SLID, ANEW
        case LimitingProfile():
            return CORE, LIMIT
        case _:
            return ()
