"""The formulas behind the answers for viscoelastic contacts."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from winkler.foundation.plane import PlaneFoundation
from winkler.laws.crack import SaturatingWork
from winkler.materials.at_temperature import AtTemperature
from winkler.materials.temperature import Arrhenius
from winkler.media.relaxing.proportional import RelaxingInProportion
from winkler.problems.viscoelastic.adhesion import ViscoelasticAdhesion
from winkler.problems.viscoelastic.impact import ViscoelasticImpact
from winkler.problems.viscoelastic.indentation import ViscoelasticIndentation
from winkler.problems.viscoelastic.material_tests import CreepTest, HarmonicIndentation, RelaxationTest
from winkler.problems.viscoelastic.sliding import SlidingResistance
from winkler.problems.viscoelastic.tangential import ViscoelasticTangential
from winkler.study.chapters.formula import Formula

__all__ = ["OF_VISCOELASTICITY"]

PAIR = Formula(
    "The bodies bear the same pressure, so their creep adds up, and the modulus E*(t) of the pair follows",
    r"C(t) = \frac{1-\nu_1}{2}\,J_1(t) + \frac{1-\nu_2}{2}\,J_2(t), \quad "
    r"\int_0^t E^*(t-t')\,C(t')\,\mathrm{d}t' = t",
)
SERIES = Formula(
    "The relaxation is a sum of exponentials, each of which is carried along exactly while the springs move steadily",
    r"E^*(t) = E^*_\infty + \sum_i E^*_i\,e^{-t/\tau_i}",
)
SHIFT = Formula("Temperature multiplies all times by one factor", r"G(t;T) = G\left(\frac{t}{a_T}\right)")
FERRY = Formula("which follows the law of Williams, Landel and Ferry", r"\log_{10} a_T = -\frac{c_1(T-T_0)}{c_2+T-T_0}")
ACTIVATED = Formula(
    "which follows the law of Arrhenius", r"\ln a_T = \frac{Q}{R}\left(\frac{1}{T}-\frac{1}{T_0}\right)"
)
PLANE = Formula(
    "Poisson's ratio does not change in time, so the shape f(r) becomes the same equivalent plane profile as on an "
    "elastic body",
    r"g(x) = x\int_0^x \frac{f'(r)}{\sqrt{x^2-r^2}}\,\mathrm{d}r",
)
BACK = Formula(
    "The plane profile g(x) was given; the body that belongs to it is",
    r"f(r) = \frac{2}{\pi}\int_0^r \frac{g(x)}{\sqrt{r^2-x^2}}\,\mathrm{d}x",
)
SPRINGS = Formula(
    "Every spring remembers how it was pressed",
    r"q(x,t) = \int_0^t E^*(t-t')\,\frac{\partial u(x,t')}{\partial t'}\,\mathrm{d}t', \quad u = d(t)-g(x)",
)
LET_GO = Formula(
    "A spring lets go when it would pull; it then recovers without a load, until the body catches it again",
    r"q(x,t) = 0 \quad \mathrm{until} \quad d(t)-g(x) \ge u(x,t)",
)
FORCE = Formula("Their sum is the force", r"F_N(t) = 2\int_0^{a(t)} q(x,t)\,\mathrm{d}x")
PRESSURE = Formula(
    "and the springs' load gives back the pressure of the three-dimensional contact",
    r"p(r,t) = -\frac{1}{\pi}\int_r^{a(t)} \frac{\partial q}{\partial x}\,\frac{\mathrm{d}x}{\sqrt{x^2-r^2}}",
)
ENERGY = Formula(
    "What the body has spent is stored in the springs, also in those that have let go, or lost",
    r"\int F_N\,\mathrm{d}d = U(t) + W(t)",
)
SUNK = Formula(
    "The contact only grows, so the elastic answer holds with the load replaced by its hereditary integral (Lee and "
    "Radok); F₁ is the force at a modulus of one",
    r"F_1(d(t)) = F_N\,C(t)",
)
HELD = Formula(
    "The contact stays as it is, so the force falls as the modulus does; F₁ is the force at a modulus of one",
    r"F_N(t) = E^*(t)\,F_1(d)",
)
SHAKEN = Formula(
    "About the relaxed contact the bodies meet a complex stiffness",
    r"k'+\mathrm{i}k'' = 2a\,E^*(\mathrm{i}\omega), \quad \tan\delta = \frac{k''}{k'}",
)
DYNAMIC = Formula(
    "with the complex modulus of the pair",
    r"E^*(\mathrm{i}\omega) = E^*_\infty + \sum_i E^*_i\,\frac{\mathrm{i}\omega\tau_i}{1+\mathrm{i}\omega\tau_i}",
)
STRUCK = Formula("The force stops the body and throws it back", r"m\,\ddot{d} = -F_N")
RESTITUTION = Formula(
    "Restitution is what is left of the velocity, and what it lacks has gone", r"W = \frac{1}{2}mv^2\left(1-e^2\right)"
)
ALIKE = Formula(
    "All parts of the bodies relax in proportion: at any time they are the elastic ones times one function",
    r"E(z,t) = E(z)\,\varphi(t), \quad \varphi(t) = \frac{G(t)}{G}",
)
SAME = Formula(
    "so the equivalent plane profile g(x) and the stiffness of the springs are those of the elastic medium",
    r"u = d(t)-g(x), \quad |x| < a(t)",
)
VARIED = Formula(
    "Every spring remembers how it was pressed",
    r"q(x,t) = c_N(x)\int_0^t \varphi(t-t')\,\frac{\partial u(x,t')}{\partial t'}\,\mathrm{d}t'",
)
ALONG = Formula(
    "Along the surface every spring remembers how far it was dragged; its modulus relaxes as that across the surface "
    "does, since Poisson's ratios are constant",
    r"q_x(x,t) = \int_0^t G^*(t-t')\,\frac{\partial u_t(x,t')}{\partial t'}\,\mathrm{d}t'",
)
SLIDES = Formula("It slides where that reaches what friction bears", r"|q_x(x,t)| \le \mu\,q(x,t)")
SHIFTED = Formula("The sum is the force along the surface", r"F_x(t) = 2\int_0^{a(t)} q_x(x,t)\,\mathrm{d}x")
LOSSES = Formula(
    "What was spent is stored, lost in the bodies, or lost to friction",
    r"\int F_N\,\mathrm{d}d + \int F_x\,\mathrm{d}u_x = U + W_b + W_f",
)
PASSED = Formula(
    "Seen from the body, every spring is pressed in from the leading edge on, and relaxes on its way below it",
    r"q(x) = \int_x^a E^*\left(\frac{x'-x}{v}\right)\,g'(x')\,\mathrm{d}x'",
)
BORNE = Formula("until it lets go; the sum is the force", r"F_N = \int_{x_2}^a q(x)\,\mathrm{d}x")
RESISTED = Formula(
    "The front bears more than the back, and so the line of springs resists; the body resists less, by what waves "
    "aslant do not lose",
    r"F_{x,1} = \int_{x_2}^a q(x)\,g'(x)\,\mathrm{d}x",
)

RELAXED = Formula(
    "The body is taken as relaxed; springs follow the profile also where they are stretched, up to the edge",
    r"q(x) = c_N(x)\,\left(d-g(x)\right), \quad |x| < a, \quad F_N = 2\int_0^a q\,\mathrm{d}x",
)
OPENING = Formula(
    "The edge opens as fast as what is set free there pays for, by the law of Gent and Schultz",
    r"\frac{c_N(a)\,(g(a)-d)^2}{2\pi a} = w_0\left[1+\left(\frac{|\dot{a}|}{v_0}\right)^n\right]",
)
SATURATING = Formula(
    "The edge opens as fast as what is set free there pays for; fast opening takes a last work and no more",
    r"\frac{c_N(a)\,(g(a)-d)^2}{2\pi a} = w(|\dot{a}|), \quad w(0) = w_0, \quad w(v_0) = \frac{w_0+w_\infty}{2}, "
    r"\quad w \to w_\infty",
)
MACHINE = Formula("while the far end of the machine moves on", r"D(t) = d + \frac{F_N}{k_m}")
SPENT = Formula("Of the machine's work what is not stored is lost", r"\int F_N\,\mathrm{d}D = U + W")


def _pulled(problem: Any) -> tuple[Formula, ...]:
    """Return the formulas of rubber that is pulled off."""
    opening = SATURATING if isinstance(problem.law, SaturatingWork) else OPENING
    return (BACK if isinstance(problem.bed, PlaneFoundation) else PLANE, RELAXED, opening, MACHINE, SPENT)


def _shape(problem: Any) -> tuple[Formula, ...]:
    """Return how bodies and shape become springs."""
    medium = problem.bed.medium
    proportional = isinstance(medium, RelaxingInProportion)
    solids = (medium.solid,) if proportional else (medium.first, medium.second)
    laws = [solid.law for solid in solids if isinstance(solid, AtTemperature)]
    warm = [SHIFT, *dict.fromkeys(ACTIVATED if isinstance(law, Arrhenius) else FERRY for law in laws)] if laws else []
    if proportional:
        return (ALIKE, *warm, SAME)
    return (PAIR, SERIES, *warm, BACK if isinstance(problem.bed, PlaneFoundation) else PLANE)


def _restored(problem: Any) -> tuple[Formula, ...]:
    return () if isinstance(problem.bed.medium, RelaxingInProportion) else (PRESSURE,)


def _remembering(problem: Any) -> Formula:
    return VARIED if isinstance(problem.bed.medium, RelaxingInProportion) else SPRINGS


def _pressed(problem: Any) -> tuple[Formula, ...]:
    return (*_shape(problem), _remembering(problem), LET_GO, FORCE, *_restored(problem), ENERGY)


def _dragged(problem: Any) -> tuple[Formula, ...]:
    return (*_shape(problem), SPRINGS, LET_GO, FORCE, ALONG, SLIDES, SHIFTED, LOSSES)


def _slid(problem: Any) -> tuple[Formula, ...]:
    return (*_shape(problem), PASSED, BORNE, RESISTED)


def _struck(problem: Any) -> tuple[Formula, ...]:
    return (*_shape(problem), _remembering(problem), LET_GO, FORCE, STRUCK, RESTITUTION)


def _crept(problem: Any) -> tuple[Formula, ...]:
    return (*_shape(problem), SUNK)


def _held(problem: Any) -> tuple[Formula, ...]:
    return (*_shape(problem), HELD)


def _shaken(problem: Any) -> tuple[Formula, ...]:
    return (*_shape(problem), SHAKEN, DYNAMIC)


OF_VISCOELASTICITY: dict[type, Callable[[Any], tuple[Formula, ...]]] = {
    ViscoelasticIndentation: _pressed,
    ViscoelasticImpact: _struck,
    ViscoelasticTangential: _dragged,
    SlidingResistance: _slid,
    ViscoelasticAdhesion: _pulled,
    CreepTest: _crept,
    RelaxationTest: _held,
    HarmonicIndentation: _shaken,
}
"""Problem -> what returns its formulas."""
