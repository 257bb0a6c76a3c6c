"""The formulas behind an answer, for the report: what was computed, in the order in which it was computed."""

from __future__ import annotations

import math
from typing import Any, NamedTuple

from winkler.foundation.plane import PlaneFoundation
from winkler.media.halfspace import HalfSpace, HomogeneousMedium
from winkler.media.transverse import TransverselyIsotropicHalfSpace
from winkler.problems.yielding import YieldOnset

__all__ = ["Formula", "formulas_of"]


class Formula(NamedTuple):
    """A formula and what it says.

    Parameters
    ----------
    says
        One sentence.
    latex
        For `winkler.study.mathml.formula`.
    """

    says: str
    latex: str


MODULUS = Formula(
    "The two bodies act like one with the effective modulus",
    r"\frac{1}{E^*} = \frac{1-\nu_1^2}{E_1} + \frac{1-\nu_2^2}{E_2}",
)
TRANSVERSE = Formula(
    "A transversely isotropic body contributes the effective modulus (after Elliott)",
    r"E^*_{TI} = \frac{2\sqrt{C_{44}}\,(C_{11}C_{33}-C_{13}^2)}"
    r"{\sqrt{C_{11}}\,\sqrt{(\sqrt{C_{11}C_{33}}-C_{13})(C_{13}+2C_{44}+\sqrt{C_{11}C_{33}})}}",
)
PLANE = Formula(
    "The shape f(r) becomes the equivalent plane profile",
    r"g(x) = x\int_0^x \frac{f'(r)}{\sqrt{x^2-r^2}}\,\mathrm{d}r",
)
BACK = Formula(
    "The plane profile g(x) was given; the body that belongs to it is",
    r"f(r) = \frac{2}{\pi}\int_0^r \frac{g(x)}{\sqrt{r^2-x^2}}\,\mathrm{d}x",
)
SPRINGS = Formula(
    "Springs of the stiffness E* per length are compressed by d − g(x); the outermost just touches",
    r"q_z(x) = E^*\,\left(d-g(x)\right), \quad |x| < a, \quad g(a) = d",
)
PINNED = Formula(
    "Springs of the stiffness E* per length are compressed by d − g(x), up to the rim where the contact is pinned",
    r"q_z(x) = E^*\,\left(d-g(x)\right), \quad |x| < a, \quad g(a) \le d",
)
FORCE = Formula(
    "Their sum is the force; stiffness and energy follow",
    r"F_N = 2E^*\int_0^a \left(d-g(x)\right)\,\mathrm{d}x, \quad k = 2E^*a, \quad "
    r"U = E^*\int_0^a \left(d-g(x)\right)^2\,\mathrm{d}x",
)
PRESSURE = Formula(
    "The springs' load gives back the pressure of the three-dimensional contact",
    r"p(r) = \frac{E^*}{\pi}\left[\int_r^a \frac{g'(x)}{\sqrt{x^2-r^2}}\,\mathrm{d}x + "
    r"\frac{d-g(a)}{\sqrt{a^2-r^2}}\right]",
)
SURFACE = Formula(
    "and the displacement of the surface, inside the contact and outside",
    r"u_z(r) = \frac{2}{\pi}\int_0^{\min(r,a)} \frac{d-g(x)}{\sqrt{r^2-x^2}}\,\mathrm{d}x",
)
MISES = Formula(
    "Below the surface the stresses of flat punches of all radii add up; the equivalent stress after von Mises is",
    r"\sigma_{vM} = \sqrt{\frac{1}{2}\left[(\sigma_r-\sigma_\theta)^2+(\sigma_\theta-\sigma_z)^2+"
    r"(\sigma_z-\sigma_r)^2\right]+3\tau_{rz}^2}",
)
ONSET = Formula("Yielding begins where this stress first reaches the strength", r"\max\sigma_{vM} = \sigma_Y")


def formulas_of(problem: Any) -> tuple[Formula, ...]:
    """Return the formulas that answer a problem; none if its bed is not a row of springs over a homogeneous half-space.

    Parameters
    ----------
    problem
        What was asked.
    """
    bed = getattr(problem, "bed", None)
    medium = getattr(bed, "medium", None)
    if bed is None or not isinstance(medium, HomogeneousMedium):
        return ()
    found = [MODULUS]
    if isinstance(medium, TransverselyIsotropicHalfSpace):
        found.append(TRANSVERSE)
    found.append(BACK if isinstance(bed, PlaneFoundation) else PLANE)
    found += [PINNED if math.isfinite(bed.rim) else SPRINGS, FORCE, PRESSURE, SURFACE]
    if isinstance(medium, HalfSpace):
        found.append(MISES)
    if isinstance(problem, YieldOnset):
        found.append(ONSET)
    return tuple(found)
