"""Tangential contact: friction, lateral loads, paths, problems, and their formulas."""

from __future__ import annotations

from typing import Any

from winkler.media.offers import PowerOfDepth, PressedWaves, offers
from winkler.study.chapters.answer import Caption, Chapter, Equation, PicturedContact, answer, followed_by
from winkler.study.chapters.kind import kind
from winkler.study.chapters.normal import normal_formulas

NORMAL_START = {"kind": "start", "normal": {"kind": "force", "force": "100 N"}}
OSCILLATION = [
    NORMAL_START,
    {"kind": "ramp", "normal": {"kind": "force", "force": "200 N"}, "duration": "1 s"},
    {"kind": "oscillate", "lateral": {"kind": "shift", "shift": "0.5 um"}, "cycles": 2.0},
    {"kind": "hold", "duration": "1 s"},
]
STEEL = {"kind": "elastic", "young": "210 GPa", "poisson": 0.3}
TWIST = [
    {**NORMAL_START, "lateral": {"kind": "angle", "angle": "0 rad"}},
    {"kind": "oscillate", "lateral": {"kind": "angle", "angle": "2 mrad"}, "cycles": 1.25},
]
LOOP_WAY = [
    *("0.00 um", "-1.00 um", "-2.00 um", "-1.56 um", "-1.11 um", "-0.67 um", "-0.22 um"),
    *("0.22 um", "0.67 um", "1.11 um", "1.56 um", "2.00 um", "1.56 um", "1.11 um"),
    *("0.67 um", "0.22 um", "-0.22 um", "-0.67 um", "-1.11 um", "-1.56 um", "-2.00 um"),
    *("-1.00 um", "0.00 um"),
]
LOOP_FORCE = [
    *("0.00 N", "-32.63 N", "-50.00 N", "-34.27 N", "-19.17 N", "-4.76 N", "8.82 N"),
    *("21.41 N", "32.76 N", "42.42 N", "49.26 N", "50.00 N", "34.27 N", "19.17 N"),
    *("4.76 N", "-8.82 N", "-21.41 N", "-32.76 N", "-42.42 N", "-49.26 N", "-50.00 N"),
    *("-15.49 N", "15.25 N"),
]

TANGENTIAL_SPRINGS = Equation(
    "Each spring follows the tangential displacement until its tangential load reaches μ times its normal load; then "
    "it slides",
    r"q_x(x) = c_T(x)\,u_t(x), \quad |c_T\,u_t| \le \mu\,c_N\left(d-g(x)\right)",
)
TWISTED = Equation(
    "A spring at x that does not slide is displaced by φ x",
    r"q(x) = 8G_t\,\phi\,x, \quad \frac{1}{G_t} = \frac{1}{G_1} + \frac{1}{G_2}",
)
TWIST_BOUND = Equation(
    "It slides where its load reaches the bound that follows from the pressure at larger radii",
    r"|q(x)| \le 4\mu\,x\int_x^a \frac{p(r)}{\sqrt{r^2-x^2}}\,\mathrm{d}r",
)
TORQUE = Equation("Torque of the spring forces", r"M_z = 2\int_0^a x\,q(x)\,\mathrm{d}x")
TANGENTIAL_FORCE = Equation(
    "The spring forces add up to the tangential force", r"F_x = 2\int_0^a c_T\,u_t\,\mathrm{d}x"
)
LOSS = Equation("The dissipated energy of a closed cycle is the work of this force", r"W = \oint F_x\,\mathrm{d}u_x")
MASING = Equation(
    "After a load reversal displacements and forces are doubled; a compliance C is in series (Masing)",
    r"|F_x-F_t| = 2f(s), \quad |x-x_t| = 2s + 2C\,f(s)",
)
SLIDING_SCALE = Equation(
    "Shear force and displacement of the first loading are both proportional to the coefficient of friction",
    r"f(s) = \mu\,g\left(\frac{s}{\mu}\right)",
)
COMMON_OSCILLATION = Equation(
    "Depth and tangential displacement oscillate together",
    r"d = d_0 + A_z\cos(n\theta), \quad u_x = A_x\cos(m\theta+\varphi)",
)
RELAXED = Equation(
    "A spring that separates in every cycle of the duration T loses the load due to the slow motion; all others act "
    "as one tangential spring",
    r"F_x = k_x\,u_x + c\,\dot{u}_x, \quad k_x = 2\int_0^{a_{min}} c_T\,\mathrm{d}x",
)

PUSHED_DEEP = Equation(
    "A spring at x that does not slide carries a load proportional to the displacement; its stiffness is the "
    "increase of the stiffness of a disc of that radius without slip",
    r"h(x) = G^*\,u_x, \quad 2\,G^*\,e(x)^2 = \frac{\mathrm{d}k_x}{\mathrm{d}x}",
)
PUSH_SUM = Equation(
    "It slides where this load reaches the bound of annular elements under μ p; the shear force is the sum",
    r"|h(x)| \le b(x), \quad F_x = 2\int_0^a e(x)^2\,h(x)\,\mathrm{d}x",
)
TWISTED_DEEP = Equation(
    "A spring at x that does not slide carries a load proportional to the angle; its stiffness is the increase of "
    "the torsional stiffness of a flat punch of that radius",
    r"h(x) = 8G_t\,\phi, \quad 16\,G_t\,e(x)^2 = \frac{\mathrm{d}k_\varphi}{\mathrm{d}x}",
)
TORQUE_DEEP = Equation(
    "It slides where this load reaches the bound of annular elements under μ p; the torque is the sum",
    r"|h(x)| \le b(x), \quad M_z = 2\int_0^a e(x)^2\,h(x)\,\mathrm{d}x",
)


def tangential_formulas(problem: Any) -> tuple[Equation, ...]:
    """Return the formulas of a tangential contact, by rings or by springs."""
    of_rings, of_springs = (PUSHED_DEEP, PUSH_SUM), (TANGENTIAL_SPRINGS, TANGENTIAL_FORCE)
    return followed_by(normal_formulas, *(of_rings if getattr(problem, "by_rings", False) else of_springs))(problem)


def torsion_formulas(problem: Any) -> tuple[Equation, ...]:
    """Return the formulas of a twist: those of homogeneous bodies, or of bodies that change with depth."""
    medium = getattr(getattr(problem, "bed", None), "medium", None)
    changing = offers(medium, PowerOfDepth) or offers(medium, PressedWaves)
    more = (TWISTED_DEEP, TORQUE_DEEP) if changing else (TWISTED, TWIST_BOUND, TORQUE)
    return followed_by(normal_formulas, *more)(problem)


FRICTION = Chapter(
    "friction and impacts",
    kinds={
        "law": {
            "coulomb": kind(
                "winkler.laws.friction:Coulomb",
                en="coulomb friction law amontons constant coefficient",
                de="coulombsches gesetz",
                fr="loi de coulomb",
                problem="tangential",
                coefficient=0.3,
            ),
            "static_kinetic": kind(
                "winkler.laws.friction:StaticKinetic",
                problem="tangential",
                static_coefficient=0.4,
                kinetic_coefficient=0.3,
            ),
        },
        "lateral": {
            "shift": kind("winkler.loading.loads:Shift", problem="adhesive_shear", shift="1 nm"),
            "shear_force": kind("winkler.loading.loads:ShearForce", problem="adhesive_shear", shear_force="1 mN"),
            "angle": kind("winkler.loading.loads:Angle", problem="torsion", angle="1 mrad"),
            "torque": kind("winkler.loading.loads:Torque", problem="torsion", torque="1 mN m"),
        },
        "log": {
            "friction_log": kind(
                "winkler.fitting.logs.friction_log:FrictionLog",
                reader="winkler.io.logs.log_tables:read_friction_log",
                problem="friction_loops",
                displacement=LOOP_WAY,
                shear_force=LOOP_FORCE,
            ),
        },
        "path": {
            "path": kind(
                "winkler.loading.path:Path",
                reader="winkler.io.tables.path_table:read_path",
                time=["0 s", "1 s", "2 s"],
                normal={"kind": "force", "force": "100 N"},
                lateral={"kind": "shift", "shift": ["0 um", "0.5 um", "-0.5 um"]},
            ),
            "program": kind("winkler.loading.program:Program", steps=OSCILLATION),
        },
        "step": {
            "start": kind("winkler.loading.path_steps:Start", normal={"kind": "force", "force": "100 N"}),
            "ramp": kind("winkler.loading.path_steps:Ramp", normal={"kind": "force", "force": "200 N"}),
            "hold": kind("winkler.loading.path_steps:Hold"),
            "oscillate": kind("winkler.loading.path_steps:Oscillate", lateral={"kind": "shift", "shift": "0.5 um"}),
            "circle": kind(
                "winkler.loading.path_steps:Circle",
                within=[NORMAL_START, {"kind": "circle", "lateral": {"kind": "shift", "shift": "0.5 um"}}],
                lateral={"kind": "shift", "shift": "0.5 um"},
            ),
            "follow": kind(
                "winkler.loading.path_steps:Follow",
                within=[NORMAL_START, {"kind": "follow", "path": {"kind": "path"}, "cycles": 2}],
            ),
        },
    },
    answers={
        "tangential": answer(
            "winkler.problems.friction.tangential:Tangential",
            question="How does a pressed joint respond when it is pushed along the surface: partial slip, fretting loop, loss?",
            page="chapters/friction.md",
            key="friction slip",
            en="mindlin cattaneo friction stick slip partial slip tangential stiffness micro-slip hysteresis loop fretting loop presliding how stiff is the joint sideways shear pre-sliding displacement microslip static friction coulomb dem contact law sliding begins hysteresis bolt damping friction on coating layered shear of a film coated fretting stick slip of layers friction of polymer rubber pad viscoelastic shear creep of joint sliding of rubber with time amontons coulomb law ring of slip annulus cattaneo-mindlin pull sideways push sideways whole area slides gross sliding friction joint prestressed stick zone slip zone piezo drive inertia actuator dahl model lugre bristle preload and lateral force static friction limit contact stiffness lateral ratio of tangential to normal stiffness tangential displacement of a circular region gross slip limit",
            de="reibung haften gleiten mindlin tangentialsteifigkeit teilschlupf mikroschlupf haftreibung schubsteifigkeit reibhysterese losbrechkraft reibkraft beschichtung schicht tangential beschichtet gummi viskoelastisch polymer amontons coulombsche reibung haftgebiet gleitgebiet seitlich schieben wann rutscht der gepresste körper rutscht durch",
            fr="frottement adhérence glissement mindlin raideur tangentielle glissement partiel micro-glissement cisaillement boucle d'hystérésis revêtement couche polymère caoutchouc viscoélastique loi de coulomb amontons anneau de glissement collé glissant",
            headline=("dissipation", "shear_force", "shift", "stick_radius", "loss_per_cycle"),
            path={"kind": "program", "steps": OSCILLATION},
            picture=Caption(
                "tangential",
                "The contact along its path",
                "Loop of the shear force, forces and energies over time, and stick and slip of the last contact.",
            ),
            curves=(
                ("shift", "shear_force"),
                ("shift_x", "shear_force_x"),
                ("shift_y", "shear_force_y"),
                ("time", "dissipation"),
            ),
            pictured=PicturedContact.PATH,
            contact_shown="the contact at its greatest depth, without friction",
            formulas=tangential_formulas,
        ),
        "torsion": answer(
            "winkler.problems.friction.torsion:Torsion",
            question="How does a pressed contact respond when it is twisted about its axis?",
            page="chapters/friction.md#twisted",
            en="twist spin torque rotate pivot bearing friction torque screw drilling twisting pivot lubkin jäger reissner sagoci swivel centre plate turning moment clutch spinning friction drilling friction pivot jewel bearing drag torque to break loose turning on the spot ball turntable torsional loading of a circular region torque until a pressed ball spins around its axis",
            de="drehmoment verdrehen torsion drehen bohrreibung zapfen spin verdrillen kupplung reibmoment losbrechmoment bohrmoment",
            fr="couple torsion pivot vriller rotation moment de frottement pivotement embrayage frottement de pivotement pivot couple de décollement",
            headline=("dissipation", "torque", "angle", "stick_radius", "loss_per_cycle"),
            path={"kind": "program", "steps": TWIST},
            picture=Caption(
                "torsion",
                "The contact along its path",
                "Loop of the torque, forces and energies over time, and stick and slip of the last contact.",
            ),
            curves=(("angle", "torque"), ("time", "dissipation")),
            pictured=PicturedContact.PATH,
            contact_shown="the contact at its greatest depth, without the twist",
            formulas=torsion_formulas,
        ),
        "friction_damping": answer(
            "winkler.problems.friction.damping:FrictionDamping",
            question="How much energy does a joint or a damper lose in a cycle, and how stiff is it?",
            page="chapters/friction.md",
            en="damping vibration joint loss per cycle what does it cost per cycle energy dissipation blade damper underplatform damper loss factor dissipated energy bolted joint hysteresis structural damping friction damper iwan quality factor friction loss iwan element masing loop under-platform damper ring damper area of the hysteresis loop lap joint damping wedge damper freight bogie friction ring microslip damping wire rope self damping riveted joint dissipation built-up structure",
            de="dämpfung schwingung energieverlust je zyklus verlustfaktor reibdämpfer fügestelle fugendämpfung schraubverbindung reibungsdämpfung verlust pro umlauf fügestellendämpfung reibkeil schleife fläche der hystereseschleife",
            fr="amortissement vibration perte par cycle énergie dissipée amortisseur à friction liaison boulonnée facteur de perte assemblage vibrant énergie perdue par cycle amortisseur à coin",
            headline=("loss_per_cycle", "loss_factor", "secant_stiffness", "shear_force"),
            normal={"kind": "force", "force": "100 N"},
            amplitude={"kind": "shift", "shift": "0.5 um"},
            picture=Caption(
                "damping", "Damping by friction", "Energy loss, stiffness and loss factor over the amplitude."
            ),
            contact_shown="the contact under its normal load, without friction",
            formulas=followed_by(tangential_formulas, LOSS),
        ),
        "bimodal_damping": answer(
            "winkler.problems.friction.bimodal_damping:BimodalDamping",
            question="How much energy is lost when depth and shift oscillate together?",
            page="chapters/friction.md#pressed-and-pushed-at-once",
            en="shaking vertically vibration makes sliding easier vibration lowers friction shake two-directional vibration normal and tangential oscillation phase ultrasonic vibration combined damping oblique loading vibrating both ways ultrasonic vibration reduces friction shaken up and down and sideways",
            de="schwingung in zwei richtungen normal und tangential phase ultraschall",
            fr="vibration bidirectionnelle normale et tangentielle phase ultrasons ultrasons réduisent le frottement",
            headline=("loss_per_cycle", "loss_stiffness"),
            depth="3 um",
            depth_amplitude="1 um",
            shift_amplitude="0.5 um",
            phase="90 deg",
            picture=Caption("damping", "Damping by friction", "Energy dissipated in every closed cycle."),
            contact_shown="the contact at its greatest depth, without friction",
            formulas=followed_by(normal_formulas, TANGENTIAL_SPRINGS, COMMON_OSCILLATION, LOSS),
        ),
        "relaxation_damper": answer(
            "winkler.problems.friction.relaxation_damping:RelaxationDamper",
            question="How does a shaken contact brake a slow motion without sliding?",
            page="chapters/friction.md",
            en="shaking vertically vibration eases sliding damper without sliding relaxation damping oscillating depth viscous like damping lossless material",
            de="relaxationsdämpfer dämpfer ohne gleiten",
            fr="amortisseur par relaxation sans glissement",
            headline=("damping", "shear_stiffness"),
            depth="3 um",
            depth_amplitude="1 um",
            frequency="100 Hz",
            picture=Caption("damping", "Damping by relaxation", "Stiffness and damping under an oscillating depth."),
            contact_shown="the contact at its greatest depth, without friction",
            formulas=followed_by(normal_formulas, RELAXED),
        ),
        "friction_loops": answer(
            "winkler.fitting.logs.friction_loops:FrictionLoops",
            question="Which friction and which stiffness explain the measured loops?",
            page="experiments/logs.md",
            en="measured friction loops fretting test log hysteresis loops of a rig friction coefficient from loops frame compliance of the machine tangential stiffness measured gross slip tribometer reciprocating fretting loops",
            de="gemessene reibschleifen schwingverschleiss fretting versuch hysterese reibungskoeffizient aus messung rahmennachgiebigkeit",
            fr="boucles de frottement mesurées fretting essai coefficient de frottement mesuré souplesse du bâti",
            headline=("coefficient", "contact_stiffness", "series_compliance", "loss_per_cycle"),
            normal={"kind": "force", "force": "100 N"},
            log={"kind": "friction_log", "displacement": LOOP_WAY, "shear_force": LOOP_FORCE},
            picture=Caption(
                "loops",
                "Measured loops",
                "Measured loops (second half of the cycles), fitted last loop, and energy dissipated per cycle.",
            ),
            pictured=PicturedContact.NONE,
            formulas=(MASING, SLIDING_SCALE),
        ),
    },
)
