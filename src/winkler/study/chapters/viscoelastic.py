"""Viscoelastic normal contact and impact: problems, and their formulas."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from winkler.study.chapters.answer import Caption, Chapter, Equation, PicturedContact, answer, followed_by
from winkler.study.chapters.impact import EQUATION_OF_MOTION
from winkler.study.chapters.normal import BACK, PLANE, PLANE_FOUNDATION
from winkler.values.checks.contract import is_a

BED = {"kind": "foundation", "medium": {"kind": "viscoelastic_half_space"}}
DECADES = {"from": "1 ms", "to": "10 s", "count": 33, "spacing": "log"}
IN_AND_OUT = [
    {"kind": "start", "normal": {"kind": "depth", "depth": "0 um"}},
    {"kind": "ramp", "normal": {"kind": "depth", "depth": "100 um"}, "duration": "0.1 s", "count": 20},
    {"kind": "hold", "duration": "0.2 s", "count": 10},
    {"kind": "ramp", "normal": {"kind": "depth", "depth": "0 um"}, "duration": "0.1 s", "count": 20},
]

PAIR = Equation(
    "Both bodies carry the same pressure, so their creep functions add; the modulus E*(t) of the pair follows",
    r"C(t) = \frac{1-\nu_1}{2}\,J_1(t) + \frac{1-\nu_2}{2}\,J_2(t), \quad "
    r"\int_0^t E^*(t-t')\,C(t')\,\mathrm{d}t' = t",
)
SERIES = Equation(
    "The relaxation function is a sum of exponentials; each is integrated exactly at constant spring speed",
    r"E^*(t) = E^*_\infty + \sum_i E^*_i\,e^{-t/\tau_i}",
)
SHIFT = Equation("Temperature multiplies all times by one factor", r"G(t;T) = G\left(\frac{t}{a_T}\right)")
FERRY = Equation(
    "which follows the law of Williams, Landel and Ferry", r"\log_{10} a_T = -\frac{c_1(T-T_0)}{c_2+T-T_0}"
)
ACTIVATED = Equation(
    "which follows the law of Arrhenius", r"\ln a_T = \frac{Q}{R}\left(\frac{1}{T}-\frac{1}{T_0}\right)"
)
PLANE_KEPT = PLANE._replace(
    says="Poisson's ratio is constant, so the equivalent plane profile of f(r) is that of an elastic body"
)
SPRINGS = Equation(
    "The load of every spring is a hereditary integral of its compression",
    r"q(x,t) = \int_0^t E^*(t-t')\,\frac{\partial u(x,t')}{\partial t'}\,\mathrm{d}t', \quad u = d(t)-g(x)",
)
DETACHMENT = Equation(
    "A spring separates when its load would become tensile; it recovers freely until the body touches it again",
    r"q(x,t) = 0 \quad \mathrm{until} \quad d(t)-g(x) \ge u(x,t)",
)
FORCE = Equation("The sum of the spring forces is the force", r"F_N(t) = 2\int_0^{a(t)} q(x,t)\,\mathrm{d}x")
PRESSURE = Equation(
    "and the load of the springs gives the pressure of the three-dimensional contact",
    r"p(r,t) = -\frac{1}{\pi}\int_r^{a(t)} \frac{\partial q}{\partial x}\,\frac{\mathrm{d}x}{\sqrt{x^2-r^2}}",
)
ENERGY = Equation(
    "The work of the body is stored in the springs (also in separated ones) or dissipated",
    r"\int F_N\,\mathrm{d}d = U(t) + W(t)",
)
CREEP = Equation(
    "The contact only grows, so the elastic solution holds with the hereditary integral of the load (Lee and Radok); "
    "F₁ is the force for a modulus of one",
    r"F_1(d(t)) = F_N\,C(t)",
)
RELAXATION = Equation(
    "The contact does not change, so the force is proportional to the modulus; F₁ is the force for a modulus of one",
    r"F_N(t) = E^*(t)\,F_1(d)",
)
COMPLEX_STIFFNESS = Equation(
    "Complex stiffness for oscillations about the relaxed contact",
    r"k'+\mathrm{i}k'' = 2a\,E^*(\mathrm{i}\omega), \quad \tan\delta = \frac{k''}{k'}",
)
DYNAMIC = Equation(
    "with the complex modulus of the pair",
    r"E^*(\mathrm{i}\omega) = E^*_\infty + \sum_i E^*_i\,\frac{\mathrm{i}\omega\tau_i}{1+\mathrm{i}\omega\tau_i}",
)
RESTITUTION = Equation("Coefficient of restitution, and dissipated energy", r"W = \frac{1}{2}mv^2\left(1-e^2\right)")
PROPORTIONAL = Equation(
    "All moduli relax in proportion: they are the elastic moduli times one function of time",
    r"E(z,t) = E(z)\,\varphi(t), \quad \varphi(t) = \frac{G(t)}{G}",
)
SAME_PROFILE = Equation(
    "so the equivalent plane profile g(x) and the stiffness of the springs are those of the elastic medium",
    r"u = d(t)-g(x), \quad |x| < a(t)",
)
VARIED = Equation(
    "The load of every spring is a hereditary integral of its compression",
    r"q(x,t) = c_N(x)\int_0^t \varphi(t-t')\,\frac{\partial u(x,t')}{\partial t'}\,\mathrm{d}t'",
)

LAYERS = Equation(
    "Layers with separate relaxation functions: creep function of each wave of the line load, from the compliance of "
    "the stack with the moduli at the Laplace variable s",
    r"U(\xi,t) = \int_0^t c(\xi,t-t')\,\frac{\partial Q(\xi,t')}{\partial t'}\,\mathrm{d}t', \quad "
    r"c(\xi,t) = c_0(\xi) + \sum_m c_m(\xi)\left(1-e^{-t/\lambda_m}\right)",
)
BIOT = Equation(
    "At the Laplace variable s the dilatation e of each wave obeys a diffusion equation; the liquid pressure p is "
    "zero at the surface, and no liquid passes the base (Biot)",
    r"\frac{\partial^2e}{\partial z^2} = \left(\xi^2+\frac{s}{D}\right)e, \quad "
    r"\varphi = \frac{2G\,(1-\nu)}{1-2\nu}\,e - p, \quad "
    r"\frac{\partial^2\varphi}{\partial z^2} = \xi^2\varphi",
)
SEEPING = Equation(
    "Creep function of each wave of the line load, from that of an incompressible film to that of the drained network",
    r"U(\xi,t) = \int_0^t c(\xi,t-t')\,\frac{\partial Q(\xi,t')}{\partial t'}\,\mathrm{d}t', \quad "
    r"c(\xi,t) = c_0(\xi) + \sum_m c_m(\xi)\left(1-e^{-t/\lambda_m}\right)",
)
PRESSED = Equation(
    "In contact the displacement follows from the depth and the profile h of a homogeneous body; outside the load is "
    "zero, and it vanishes at the edge",
    r"u(x,t) = d(t)-h(x), \quad |x| < a(t), \quad q(x,t) = 0, \quad |x| \ge a(t)",
)
PUNCH = Equation(
    "Stiffness for oscillations about the relaxed contact: a flat punch with the complex compliance of every wave",
    r"\int c(\xi,\mathrm{i}\omega)\,Q(\xi)\,\cos\xi x\,\frac{\mathrm{d}\xi}{\pi} = 1, \quad "
    r"k'+\mathrm{i}k'' = 2\int_0^a q\,\mathrm{d}x",
)

STEP = Caption("step", "After the step", "The depth under a force, or the force at a depth, over time.")
STEP_CURVES = (("time", "depth"), ("time", "radius"), ("time", "force"))

AT_TEMPERATURE = "winkler.materials.at_temperature:AtTemperature"
ARRHENIUS = "winkler.materials.temperature:Arrhenius"
IN_PROPORTION = "winkler.media.relaxing.proportional:RelaxingInProportion"
COATED = "winkler.media.relaxing.layered:ViscoelasticCoatedHalfSpace"
POROUS = "winkler.media.relaxing.poroelastic:PoroelasticFilm"


def _by_waves(medium: Any) -> bool:
    """Return whether every wave relaxes by a function of its own."""
    return is_a(medium, COATED) or is_a(medium, POROUS)


def pair_formulas(problem: Any) -> tuple[Equation, ...]:
    """Return the formulas of the relaxation of the bodies."""
    medium = problem.bed.medium
    if _by_waves(medium):
        return (BIOT, SEEPING, PRESSED) if is_a(medium, POROUS) else (LAYERS, PRESSED)
    proportional = is_a(medium, IN_PROPORTION)
    solids = (medium.solid,) if proportional else (medium.first, medium.second)
    laws = [solid.law for solid in solids if is_a(solid, AT_TEMPERATURE)]
    warm = [SHIFT, *dict.fromkeys(ACTIVATED if is_a(law, ARRHENIUS) else FERRY for law in laws)] if laws else []
    return (PROPORTIONAL, *warm) if proportional else (PAIR, SERIES, *warm)


def relaxing_formulas(problem: Any) -> tuple[Equation, ...]:
    """Return the formulas from bodies and shape to springs."""
    if _by_waves(problem.bed.medium):
        return pair_formulas(problem)
    if is_a(problem.bed.medium, IN_PROPORTION):
        shape = SAME_PROFILE
    else:
        shape = BACK if is_a(problem.bed, PLANE_FOUNDATION) else PLANE_KEPT
    return (*pair_formulas(problem), shape)


def _unless_coated(*formulas: Equation) -> Callable[[Any], tuple[Equation, ...]]:
    """Return a function that returns what holds where all relaxes in proportion, or the force alone."""

    def own(problem: Any) -> tuple[Equation, ...]:
        return (*relaxing_formulas(problem), *((FORCE,) if _by_waves(problem.bed.medium) else formulas))

    return own


def _oscillation_formulas(problem: Any) -> tuple[Equation, ...]:
    own = (PUNCH,) if _by_waves(problem.bed.medium) else (COMPLEX_STIFFNESS, DYNAMIC)
    return (*relaxing_formulas(problem), *own)


def _hereditary_formulas(problem: Any) -> tuple[Equation, ...]:
    if _by_waves(problem.bed.medium):
        return (*relaxing_formulas(problem), FORCE)
    springs = VARIED if is_a(problem.bed.medium, IN_PROPORTION) else SPRINGS
    return (*relaxing_formulas(problem), springs, DETACHMENT, FORCE)


def _indentation_formulas(problem: Any) -> tuple[Equation, ...]:
    restored = () if is_a(problem.bed.medium, IN_PROPORTION) else (PRESSURE,)
    return (*_hereditary_formulas(problem), *restored, ENERGY)


VISCOELASTIC = Chapter(
    "bodies that relax",
    kinds={},
    answers={
        "viscoelastic_indentation": answer(
            "winkler.problems.viscoelastic.indentation:ViscoelasticIndentation",
            question="How do force and depth change with time when a body is pressed into rubber, a gel or a cell?",
            page="chapters/viscoelastic.md#along-a-path",
            key="rubber",
            en="rubber foot sinks into the floor polymer rubber gel creep time-dependent ting lee radok loading rate viscoelasticity cell tissue soft matter plastic creeping hysteresis of polymer loading unloading rate dependence biological cells loading curve differs from unloading hysteresis time-dependent poisson ratio skin soft tissue fading memory silicone pad standard linear solid maxwell kelvin indentation silly putty memory foam",
            de="viskoelastisch gummi polymer kriechen zeitabhängig gel kunststoff gewebe zelle belastungsgeschwindigkeit haut weichgewebe standardmodell",
            fr="viscoélastique caoutchouc polymère fluage gel dépendant du temps tissu cellule plastique vitesse de charge peau tissu mou",
            headline=("dissipation", "force", "depth", "radius", "loss_per_cycle"),
            bed=BED,
            path={"kind": "program", "steps": IN_AND_OUT},
            count=200,
            picture=Caption(
                "relaxing",
                "The contact along its path",
                "Force, depth, contact radius and energies; springs and pressure of a late contact, with separated "
                "springs that recover.",
            ),
            curves=(("depth", "force"), ("time", "force"), ("time", "depth"), ("time", "dissipation")),
            pictured=PicturedContact.NONE,
            formulas=_indentation_formulas,
        ),
        "creep_test": answer(
            "winkler.problems.viscoelastic.material_tests:CreepTest",
            question="How deep does a body sink into rubber or a gel under a constant force?",
            page="chapters/viscoelastic.md",
            en="creep compliance constant load step load sinks in over time settling slow penetration sagging retardation dwell hold at load standing load mark over years furniture foot on vinyl flooring slow settlement cold flow retardation time pad under constant load grow with time under dead weight grows in time",
            de="dauerlast knorpel verformt sich kriechversuch kriechen konstante last retardation setzt sich haltezeit einsinken gummipuffer langzeitverformung setzverhalten dauerbelastung",
            fr="essai de fluage charge constante enfoncement lent tassement tassement sous charge",
            headline=("depth", "radius", "force", "time"),
            says={"depth": "the body has sunk in by {depth}"},
            bed=BED,
            force="1 N",
            time=DECADES,
            picture=STEP,
            curves=STEP_CURVES,
            pictured=PicturedContact.NONE,
            formulas=_unless_coated(CREEP),
        ),
        "relaxation_test": answer(
            "winkler.problems.viscoelastic.material_tests:RelaxationTest",
            question="How does the force fall when rubber or a gel is held at a depth?",
            page="chapters/viscoelastic.md",
            en="force drops after pressing force falls relaxation stress relaxation hold depth force decays loses preload compression set ramp and hold bolted flange loosens elastomer sealing force over time loosens long-term force loss compression set of a snap fit stress relaxation",
            de="relaxationsversuch spannungsrelaxation kraftabfall haltezeit vorspannung lässt nach setzen setzverhalten dichtkraft nimmt ab",
            fr="relaxation essai de relaxation relaxation des contraintes maintien force diminue précontrainte perte de serrage élastomère",
            headline=("force", "radius", "depth", "time"),
            bed=BED,
            depth="100 um",
            time=DECADES,
            picture=STEP,
            curves=STEP_CURVES,
            pictured=PicturedContact.NONE,
            formulas=_unless_coated(RELAXATION),
        ),
        "harmonic_indentation": answer(
            "winkler.problems.viscoelastic.oscillation:HarmonicIndentation",
            question="Which storage and loss stiffness does a shaken indenter measure?",
            page="chapters/viscoelastic.md",
            en="dma storage modulus loss modulus tan delta dynamic indentation oscillation csm frequency sweep complex modulus loss tangent dynamic stiffness nanodma complex modulus of a gel oscillate continuous stiffness dynamic mechanical analysis bead rheometry phase angle under sinusoidal load lag",
            de="speichermodul verlustmodul dynamisch schwingend frequenz dma komplexer modul verlustfaktor phasenwinkel",
            fr="module de conservation module de perte dynamique oscillation fréquence tan delta",
            headline=("storage_stiffness", "loss_stiffness", "loss_tangent"),
            bed=BED,
            normal={"kind": "depth", "depth": "100 um"},
            angular_frequency={"from": "0.1 rad/s", "to": "1000 rad/s", "count": 33, "spacing": "log"},
            picture=Caption(
                "harmonic",
                "A small oscillation",
                "Storage stiffness (in phase), loss stiffness (a quarter of a cycle ahead), and their ratio.",
            ),
            curves=(
                ("angular_frequency", "storage_stiffness"),
                ("angular_frequency", "loss_stiffness"),
                ("angular_frequency", "loss_tangent"),
            ),
            pictured=PicturedContact.NONE,
            formulas=_oscillation_formulas,
        ),
        "viscoelastic_impact": answer(
            "winkler.problems.viscoelastic.impact:ViscoelasticImpact",
            question="How high does a rubber ball bounce?",
            page="chapters/viscoelastic.md#struck-rubbed-rolled-over-pulled-off",
            en="comes back tap test rubber ball bounce polymer impact rebound resilience schob drop on rubber viscoelastic restitution pendulum rebound rubber bushing impact foam mat squash ball polymer ball energy return rebound test rebound resilience of elastomer impact pendulum silly putty",
            de="gummiball rückprallelastizität aufprall auf gummi stoss viskoelastisch dämpfender stoss rückprallversuch elastomere gummi prallt",
            fr="rebond caoutchouc résilience choc viscoélastique balle rebond d'élastomère balle de squash mousse",
            headline=("restitution", "duration", "dissipation"),
            says={"restitution": "the coefficient of restitution is {restitution}; the contact lasts {duration}"},
            bed=BED,
            mass="30 g",
            velocity="1 m/s",
            count=100,
            tolerance=1e-3,
            picture=Caption("impact", "The impact", "Force, velocity, depth and radius until separation."),
            curves=(("depth", "force"), ("time", "force"), ("time", "velocity")),
            pictured=PicturedContact.NONE,
            formulas=followed_by(_hereditary_formulas, EQUATION_OF_MOTION, RESTITUTION),
        ),
    },
)
