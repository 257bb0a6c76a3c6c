"""The formulas behind the answers for rough surfaces and arbitrary shapes."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from winkler.problems.normal.elliptic import EllipticIndentation
from winkler.problems.normal.near_round import NearlyRoundIndentation
from winkler.problems.rough.elastomer_friction import ElastomerFriction
from winkler.problems.rough.line_contact import RoughContact
from winkler.problems.rough.line_indentation import RoughIndentation
from winkler.problems.rough.reduce import Reduction
from winkler.problems.rough.surface_conduction import SurfaceConduction
from winkler.problems.rough.surface_contact import SurfaceContact
from winkler.study.chapters.formula import Formula

__all__ = ["OF_ROUGHNESS"]

ELEMENTS = Formula(
    "Pressures and gaps are never negative, and one of the two is zero in every pixel",
    r"w = h(x,y)-d+\frac{1}{\pi E^*}\int\frac{p\,\mathrm{d}A}{\sqrt{(x-x_i)^2+(y-y_i)^2}}, "
    r"\quad p \ge 0, \; w \ge 0, \; p\,w = 0",
)
SAME_AREA = Formula(
    "The stiffness is that of a flat punch of the shape of the contact (after Barber)",
    r"k = \frac{\mathrm{d}F_N}{\mathrm{d}d}",
)
PROPORTION = Formula(
    "Conductance and stiffness are in proportion, whatever the contact looks like (after Barber)",
    r"\frac{1}{R} = \frac{2k}{E^*(\rho_1+\rho_2)}",
)
BOUNDS = Formula(
    "The map lies between a flat and the same flat raised by its height s; k with the index ∞ is the stiffness of the "
    "flat",
    r"\frac{F_N}{F_N/k_\infty+s} \le k \le k_\infty",
)
DISC = Formula(
    "A disc as stiff as the contact has the radius a, and what stands above it is g",
    r"a = \frac{k}{2E^*}, \quad g(a) = d",
)
SPECTRUM = Formula("The line takes the spectrum of the surface to its own", r"C_1(q) = \pi\,q\,C(q)")
LINE = Formula(
    "Its springs, sorted by their gaps, tell every load at once",
    r"F_N = E^*\Delta x\sum_{\gamma_i<d}(d-\gamma_i), \quad k = E^*\Delta x\,n(d)",
)
PERSSON = Formula(
    "The part of the square that touches is Persson's",
    r"\frac{A}{A_0} = \mathrm{erf}\left(\frac{\sqrt{2}\,p}{E^* h'}\right)",
)
ON_BODY = Formula("The heights stand on the profile of the body", r"z(x) = h(x) - g(|x|)")
ELLIPSE = Formula(
    "The contact is an ellipse, the pressure a half-ellipsoid above it (after Hertz)",
    r"p = \frac{3F_N}{2\pi ab}\sqrt{1-\frac{x^2}{a^2}-\frac{y^2}{b^2}}",
)
BALL = Formula(
    "Force and depth are those of a ball of the radius",
    r"R_{eq} = \frac{9F_N^2}{16E^{*2}d^3}",
)
BETTI = Formula(
    "Every direction has its own g, and the force is the mean",
    r"F_N = 2E^*\frac{\langle aI\rangle}{\langle a\rangle}, \quad I = \int_0^a(d-g)\,\mathrm{d}x",
)
GREATEST = Formula(
    "The contour is the one with the greatest force (after Barber)", r"I + a\,(d-g(a)) = \frac{F_N}{2E^*}"
)
SHEARED_WAVES = Formula(
    "Every wave of the roughness shears the elastomer at the frequency q v",
    r"\mu = h'\,\frac{\int q^3C\,\frac{G''(qv)}{|G(qv)|}\,\mathrm{d}q}{\int q^3C\,\mathrm{d}q}",
)

OF_ROUGHNESS: dict[type, Callable[[Any], tuple[Formula, ...]]] = {
    SurfaceContact: lambda problem: (ELEMENTS, SAME_AREA),
    SurfaceConduction: lambda problem: (ELEMENTS, SAME_AREA, PROPORTION, BOUNDS, SPECTRUM, LINE, PERSSON),
    Reduction: lambda problem: (ELEMENTS, SAME_AREA, DISC),
    RoughContact: lambda problem: (SPECTRUM, LINE, PERSSON),
    RoughIndentation: lambda problem: (SPECTRUM, ON_BODY, LINE, PERSSON),
    EllipticIndentation: lambda problem: (ELLIPSE, BALL),
    NearlyRoundIndentation: lambda problem: (BETTI, GREATEST),
    ElastomerFriction: lambda problem: (SHEARED_WAVES,),
}
"""Problem -> its formulas."""
