"""The formulas behind an answer, for the report: what was computed, in the order in which it was computed."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

from winkler.foundation.measured import MeasuredBed
from winkler.foundation.plane import PlaneFoundation
from winkler.laws.adhesion import AdhesionLaw, DerjaguinMullerToporov, Dugdale
from winkler.media.graded.power_law import GradedHalfSpace
from winkler.media.halfspace import HalfSpace, HomogeneousMedium
from winkler.media.layered.coated import LayeredMedium
from winkler.media.transverse import TransverselyIsotropicHalfSpace
from winkler.problems.adhesion.cycle import AdhesiveCycle
from winkler.problems.adhesion.shear import AdhesiveShear
from winkler.problems.conduction.constriction import Constriction
from winkler.problems.conduction.joule_heating import JouleHeating
from winkler.problems.conduction.thermal_constriction import ThermalConstriction
from winkler.problems.friction.bimodal_damping import BimodalDamping
from winkler.problems.friction.damping import FrictionDamping
from winkler.problems.friction.relaxation_damping import RelaxationDamper
from winkler.problems.friction.tangential import Tangential
from winkler.problems.friction.torsion import Torsion
from winkler.problems.heating.fretting import FrettingHeat
from winkler.problems.heating.steady import FrictionHeating
from winkler.problems.heating.transient import TransientHeating
from winkler.problems.impact.adhesive_impact import AdhesiveImpact
from winkler.problems.impact.impact import Impact
from winkler.problems.normal.yielding import YieldOnset
from winkler.study.chapters.formula import Formula
from winkler.study.chapters.formulas_of_conduction import OF_CONDUCTION, conducted
from winkler.study.chapters.formulas_of_heating import FRETTED, RUBBED_WARM, WARMING
from winkler.study.chapters.formulas_of_rolling import OF_ROLLING
from winkler.study.chapters.formulas_of_roughness import OF_ROUGHNESS
from winkler.study.chapters.formulas_of_viscoelasticity import OF_VISCOELASTICITY
from winkler.study.chapters.formulas_of_wear import worn

__all__ = ["Formula", "formulas_of"]

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


TOP = Formula(
    "The uppermost solid and the other body alone would act with the effective modulus",
    r"\frac{1}{E^*} = \frac{1-\nu_1^2}{E_1} + \frac{1-\nu_2^2}{E_2}",
)
COMPLIANCE = Formula(
    "What lies below is felt by long waves of pressure: they move the surface by C per pressure",
    r"C(\xi) = \frac{2}{E^*\xi}\left(1+M(\xi)\right)",
)
PUNCHES = Formula(
    "From it follow the flat punches of every radius a",
    r"\phi(x) + \int_0^a K(x,t)\,\phi(t)\,\mathrm{d}t = 1, \quad "
    r"K(x,t) = \frac{2}{\pi}\int_0^\infty M\,\cos(\xi x)\,\cos(\xi t)\,\mathrm{d}\xi",
)
LAYERED_SPRINGS = Formula(
    "and from these the springs, whose stiffness changes with x",
    r"c_N(x) = E^*\,\phi(x;x)^2, \quad k(a) = 2E^*\int_0^a \phi\,\mathrm{d}x",
)
LAYERED_PROFILE = Formula(
    "The shape f(r) becomes the equivalent plane profile g; h is that of a homogeneous half-space, and ϱ solves the "
    "same equation with K(x, a) on the right",
    r"g(a)\,\phi(a;a) = h(a) - \int_0^a \rho(x;a)\,h(x)\,\mathrm{d}x, \quad "
    r"h(x) = x\int_0^x \frac{f'(r)}{\sqrt{x^2-r^2}}\,\mathrm{d}r",
)
RINGED_FORCE = r"F_N = 2\int_0^c c_N\,u\,\mathrm{d}x, \quad u(x) = d-g(x) \;\; (x < a)"
GRADED_SPRINGS = Formula(
    "The modulus follows a power of the depth, and so does the stiffness of the springs",
    r"E(z) = E_0\left(\frac{z}{c_0}\right)^k, \quad c_N(x) = E^*\left(\frac{x}{c_0}\right)^k, \quad "
    r"\frac{1}{E^*} = \frac{1-\nu_1^2}{h_1E_{0,1}} + \frac{1-\nu_2^2}{h_2E_{0,2}}",
)
GRADED_PROFILE = Formula(
    "The shape f(r) becomes the equivalent plane profile (here k is the exponent)",
    r"g(x) = x^{1-k}\int_0^x \frac{f'(r)}{(x^2-r^2)^{(1-k)/2}}\,\mathrm{d}r",
)
GRADED_PRESSURE = Formula(
    "Flat punches of all radii add up to the pressure of the three-dimensional contact",
    r"p(r) = \frac{E^*}{\pi c_0^k}\left[\int_r^a \frac{g'(x)}{(x^2-r^2)^{(1-k)/2}}\,\mathrm{d}x + "
    r"\frac{d-g(a)}{(a^2-r^2)^{(1-k)/2}}\right]",
)
MEASURED = Formula(
    "Stiffness and depth were measured at many contact radii; the springs follow from both",
    r"k(a) = \frac{\mathrm{d}F}{\mathrm{d}d}, \quad c_N(x) = \frac{k'(x)}{2}, \quad g(a) = d",
)
VARIED = Formula(
    "Every spring is compressed by d − g(x); the outermost just touches",
    r"q_z(x) = c_N(x)\,\left(d-g(x)\right), \quad |x| < a, \quad g(a) = d",
)
VARIED_PINNED = Formula(
    "Every spring is compressed by d − g(x), up to the rim where the contact is pinned",
    r"q_z(x) = c_N(x)\,\left(d-g(x)\right), \quad |x| < a, \quad g(a) \le d",
)
VARIED_FORCE = Formula(
    "Their sum is the force; stiffness and energy follow",
    r"F_N = 2\int_0^a c_N\left(d-g\right)\,\mathrm{d}x, \quad k = 2\int_0^a c_N\,\mathrm{d}x, \quad "
    r"U = \int_0^a c_N\left(d-g\right)^2\,\mathrm{d}x",
)
SUPERPOSED = Formula(
    "Flat punches of all radii x, with the pressure p₁ at unit depth, add up to that of the three-dimensional contact; "
    "the load of the springs alone does not tell it",
    r"p(r) = \int_r^a p_1(r;x)\,g'(x)\,\mathrm{d}x + p_1(r;a)\left(d-g(a)\right)",
)
STRESSES = MISES._replace(
    says="Below the surface every layer carries its part of every wave; the equivalent stress after von Mises is"
)
STRETCHED = Formula(
    "Springs of the stiffness c_N per length follow the profile also where they are stretched, up to the edge",
    r"q_z(x) = c_N(x)\,\left(d-g(x)\right), \quad |x| < a, \quad s = g(a) - d > 0",
)
GRIFFITH = Formula(
    "The edge is in balance where the energy that it sets free as it recedes pays for the surfaces that open",
    r"\frac{c_N(a)\,s^2}{2\pi a} = w, \quad s(a) = \sqrt{\frac{2\pi a w}{c_N(a)}}, \quad d(a) = g(a)-s(a)",
)
STUCK_FORCE = Formula(
    "Their sum is the force; so depth and force are known for every contact radius",
    r"F_N(a) = 2\int_0^a c_N\left(d-g\right)\,\mathrm{d}x, \quad k(a) = 2\int_0^a c_N\,\mathrm{d}x",
)
RING = Formula(
    "Around the contact, up to c, the surfaces attract each other with the stress of the law, which pulls the springs "
    "there by (written for a homogeneous solid)",
    r"u(x) = -\frac{2\sigma_0}{E^*}\sqrt{c^2-x^2}, \quad a < x < c, \quad "
    r"d = g(a) - \frac{2\sigma_0}{E^*}\sqrt{c^2-a^2}",
)
RING_END = Formula(
    "The ring ends where the surfaces stand apart as far as the attraction reaches", r"h(c) = \frac{w}{\sigma_0}"
)
FAR = Formula(
    "Attraction from afar deforms nothing and adds to the pull; R is the radius of curvature at the apex",
    r"d = g(a), \quad F_N(a) = 2\int_0^a c_N\left(d-g\right)\,\mathrm{d}x - 2\pi R w",
)
STABLE = Formula(
    "A state is stable on a machine of the stiffness k_m if it moves on as the contact grows; a dead load has k_m = 0, "
    "fixed grips an infinite one",
    r"\frac{\mathrm{d}}{\mathrm{d}a}\left(d + \frac{F_N}{k_m}\right) > 0",
)
LOST = Formula(
    "Between jumps the machine's work is stored, but for what opening costs more than closing gained; in a jump all "
    "that the potential falls by is lost",
    r"\mathrm{d}W = F_N\,\mathrm{d}D, \quad D = d + \frac{F_N}{k_m}",
)
SHEARED = Formula(
    "Normal and tangential springs pay for the surface together; the contact shrinks as it is sheared",
    r"c_N(a)\,s^2 + c_T(a)\,u_x^2 = 2\pi a w, \quad F_x = 2u_x\int_0^a c_T\,\mathrm{d}x",
)


HELD = Formula(
    "Along the surface every spring follows the body until it slides; it slides where its load reaches μ times that "
    "across the surface",
    r"q_x(x) = c_T(x)\,u_t(x), \quad |c_T\,u_t| \le \mu\,c_N\left(d-g(x)\right)",
)
TWISTED = Formula(
    "A spring at x is turned by φ x, as long as it does not slide",
    r"q(x) = 8G_t\,\phi\,x, \quad \frac{1}{G_t} = \frac{1}{G_1} + \frac{1}{G_2}",
)
TWIST_BOUND = Formula(
    "It slides where its load reaches what the pressure of all rings farther out lets it bear",
    r"|q(x)| \le 4\mu\,x\int_x^a \frac{p(r)}{\sqrt{r^2-x^2}}\,\mathrm{d}r",
)
TORQUE = Formula("The torque is their moment", r"M_z = 2\int_0^a x\,q(x)\,\mathrm{d}x")
SHIFTED = Formula("Their sum is the force along the surface", r"F_x = 2\int_0^a c_T\,u_t\,\mathrm{d}x")
LOSS = Formula("What is lost in a closed cycle is the work of that force", r"W = \oint F_x\,\mathrm{d}u_x")
SWUNG = Formula(
    "Depth and shift swing together",
    r"d = d_0 + A_z\cos(n\theta), \quad u_x = A_x\cos(m\theta+\varphi)",
)
RELAXED = Formula(
    "A spring that parts in every cycle lets go of what the slow motion has put into it, once in a cycle of the "
    "duration T; the others are a spring along the surface",
    r"F_x = k_x\,u_x + c\,\dot{u}_x, \quad k_x = 2\int_0^{a_{min}} c_T\,\mathrm{d}x",
)
STRUCK = Formula("The force stops the body and throws it back", r"m\,\ddot{d} = -F_N")
THROWN = Formula(
    "and along the surface it slows the body and turns it",
    r"m\,\dot{v}_x = -F_x, \quad I\,\dot{\omega} = \ell\,F_x, \quad \dot{u}_x = v_x - \omega\,\ell",
)


def _sticking(problem: Any) -> tuple[Formula, ...]:
    """Return how springs, edge and force go together under the law of a problem."""
    match problem.law:
        case Dugdale():
            found = [RING, RING_END, STUCK_FORCE._replace(latex=RINGED_FORCE)]
        case DerjaguinMullerToporov():
            found = [FAR]
        case _ if isinstance(problem, AdhesiveShear):
            return (STRETCHED, SHEARED, STUCK_FORCE)
        case _:
            found = [STRETCHED, GRIFFITH, STUCK_FORCE]
    return (*found, STABLE, *([LOST] if isinstance(problem, AdhesiveCycle) else []))


def _rubbed(problem: Any) -> tuple[Formula, ...]:
    """Return how springs hold and slide along the surface, and what follows; nothing if they are not moved along it."""
    match problem:
        case Tangential():
            return (HELD, SHIFTED)
        case Torsion():
            return (TWISTED, TWIST_BOUND, TORQUE)
        case FrictionDamping():
            return (HELD, SHIFTED, LOSS)
        case BimodalDamping():
            return (HELD, SWUNG, LOSS)
        case RelaxationDamper():
            return (RELAXED,)
        case Constriction() | ThermalConstriction() | JouleHeating():
            return conducted(problem)
        case Impact():
            return (HELD, SHIFTED, STRUCK, *([THROWN] if problem.sliding_velocity else []))
        case AdhesiveImpact():
            return (STRUCK,)
        case FrictionHeating():
            return RUBBED_WARM
        case TransientHeating():
            return WARMING
        case _:
            return worn(problem)


def _restored(problem: Any) -> tuple[Formula, ...]:
    """Return how the fields on the surface follow in a homogeneous medium; under a ring they take other steps."""
    return () if isinstance(problem.law, Dugdale) else (PRESSURE, SURFACE)


OF_THEIR_OWN: dict[type, Callable[[Any], tuple[Formula, ...]]] = {
    FrettingHeat: lambda problem: (*formulas_of(problem.motion), *FRETTED),
    **OF_CONDUCTION,
    **OF_ROLLING,
    **OF_ROUGHNESS,
    **OF_VISCOELASTICITY,
}
"""Problem -> what returns its formulas, where they do not begin with springs pressed by an elastic body."""


def formulas_of(problem: Any) -> tuple[Formula, ...]:
    """Return the formulas that answer a problem; none if its bed or medium is not among those that are known here.

    Parameters
    ----------
    problem
        What was asked.
    """
    if type(problem) in OF_THEIR_OWN:
        return OF_THEIR_OWN[type(problem)](problem)
    bed = getattr(problem, "bed", None)
    medium = getattr(bed, "medium", None)
    if bed is None:
        return ()
    pinned = math.isfinite(bed.rim)
    sticks = isinstance(getattr(problem, "law", None), AdhesionLaw)
    varied = [*_sticking(problem)] if sticks else [VARIED_PINNED if pinned else VARIED, VARIED_FORCE]
    rubbed = _rubbed(problem)
    onset = [ONSET] if isinstance(problem, YieldOnset) else []
    if isinstance(medium, HomogeneousMedium):
        found = [MODULUS, *([TRANSVERSE] if isinstance(medium, TransverselyIsotropicHalfSpace) else [])]
        found.append(BACK if isinstance(bed, PlaneFoundation) else PLANE)
        if sticks:
            return (*found, *varied, *_restored(problem), *rubbed)
        found += [PINNED if pinned else SPRINGS, FORCE, PRESSURE, SURFACE]
        return (*found, *([MISES] if isinstance(medium, HalfSpace) else []), *onset, *rubbed)
    if isinstance(bed, MeasuredBed):
        return (MEASURED, *varied, *rubbed)
    if isinstance(medium, GradedHalfSpace):
        return (GRADED_SPRINGS, GRADED_PROFILE, *varied, GRADED_PRESSURE, *rubbed)
    if isinstance(medium, LayeredMedium):
        found = [TOP, COMPLIANCE, PUNCHES, LAYERED_SPRINGS, LAYERED_PROFILE]
        return (*found, *varied, SUPERPOSED, STRESSES, *onset, *rubbed)
    return ()
