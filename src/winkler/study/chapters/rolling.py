"""Rolling contact: creepages, calibrations, contours, problems, and their formulas."""

from __future__ import annotations

from typing import Any

from winkler.study.chapters.answer import Caption, Chapter, Equation, PicturedContact, answer, followed_by
from winkler.study.chapters.kind import kind
from winkler.study.chapters.normal import plane_profile_formula
from winkler.values.checks.contract import is_a

PRESSED = {"kind": "force", "force": "100 N"}
CREEPING = {"kind": "creepages", "longitudinal": 0.001}
CURVE = {"kind": "creepages", "longitudinal": {"from": 0.0, "to": 0.006, "count": 25}}

SPRINGS = Equation("Springs are compressed by d − g(x)", r"q_z(x) = E^*\,\left(d-g(x)\right), \quad |x| < a")
KALKER = Equation(
    "Their tangential stiffness follows from Kalker's creep coefficients of a circle",
    r"\kappa_x = \frac{1}{2}c_{11}G, \quad \kappa_y = \frac{1}{2}c_{22}G",
)
RAW = Equation("Their tangential stiffness is that of a contact at rest", r"\kappa_x = \kappa_y = G^*")
DRIVEN = Equation(
    "The tangential load of a sticking spring grows with the rolling distance",
    r"\kappa = \sqrt{(\kappa_x\xi)^2+(\kappa_y\eta)^2}",
)
ROLLED = Equation(
    "A spring enters without strain at the leading edge; its tangential load is limited by friction",
    r"q_x(x) = \min\left[\mu\,q_z(y) + \kappa\,(y-x)\right], \quad x \le y < a, \quad q_x(a) = 0",
)
CREEP = Equation("The sum of the spring forces is the creep force", r"F_x = \int_{-a}^a q_x(x)\,\mathrm{d}x")
CARRIED_LOAD = Equation(
    "In every step the tangential load of a spring grows by its increment and is limited by friction",
    r"\left|q_x(x,X)\right| \le \mu\,q_z(x)",
)
LIMIT = Equation(
    "Shakedown limit: the friction limit of the springs that never leave the contact",
    r"F_{lim} = 2\int_W^a \mu\,q_z(x)\,\mathrm{d}x",
)
HERTZ = Equation(
    "Hertz' ellipse with the larger semi-axis α and the smaller one β",
    r"\frac{1}{R_\alpha} = \frac{F_N}{\pi E^*\alpha^3}\,R_D(0,1-m,1), \quad m = 1-\frac{\beta^2}{\alpha^2}",
)
TABLE = Equation(
    "Every point of the contact is a spring, with flexibilities from Kalker's coefficients",
    r"L_1 = \frac{8a}{3c_{11}G}, \quad L_2 = \frac{8a}{3c_{22}G}, \quad L_3 = \frac{\pi a\sqrt{a/b}}{4c_{23}G}",
)
STRIPS = Equation(
    "In the stick zone the traction grows with the distance from the leading edge",
    r"-\frac{\partial\tau_x}{\partial x} = \frac{\xi}{L_1}-\frac{\varphi y}{L_3}, \quad "
    r"-\frac{\partial\tau_y}{\partial x} = \frac{\eta}{L_2}+\frac{\varphi x}{L_3}",
)
BOUND = Equation(
    "up to the traction bound, at which the point slides",
    r"\tau \le \mu\,\frac{2F_N}{\pi ab}\left(1-\frac{x^2}{a^2}-\frac{y^2}{b^2}\right)",
)


def _springs(problem: Any) -> tuple[Equation, ...]:
    calibrated = is_a(problem.calibration, "winkler.problems.rolling.calibration:Kalker")
    return (plane_profile_formula(problem), SPRINGS, KALKER if calibrated else RAW)


def _simplified(problem: Any) -> tuple[Equation, ...]:
    hertz = () if is_a(problem.footprint, "winkler.profiles.ellipse:ContactEllipse") else (HERTZ,)
    return (*hertz, TABLE, STRIPS, BOUND)


ROLLING = Chapter(
    "rolling",
    kinds={
        "creepage": {
            "creepages": kind("winkler.problems.rolling.creepage:Creepage", problem="rolling", longitudinal=0.001),
        },
        "calibration": {
            "kalker": kind("winkler.problems.rolling.calibration:Kalker", "kalker_1990", problem="rolling"),
            "uncalibrated": kind("winkler.problems.rolling.calibration:Uncalibrated", problem="rolling"),
        },
        "footprint": {
            "curved_bodies": kind(
                "winkler.profiles.ellipse:CurvedBodies",
                "johnson_1985",
                problem="simplified_rolling",
                longitudinal_curvature_radius="20 mm",
                lateral_curvature_radius="10 mm",
            ),
            "curved_pair": kind(
                "winkler.profiles.curved_pair:CurvedPair",
                "johnson_1985",
                problem="elliptic_indentation",
                first_longitudinal_radius="5 mm",
                first_lateral_radius="5 mm",
                second_longitudinal_radius="26 mm",
                second_lateral_radius="-5.2 mm",
            ),
            "contact_ellipse": kind(
                "winkler.profiles.ellipse:ContactEllipse",
                problem="simplified_rolling",
                longitudinal_semi_axis="0.2 mm",
                lateral_semi_axis="0.15 mm",
            ),
        },
    },
    answers={
        "rolling": answer(
            "winkler.problems.rolling.steady:Rolling",
            question="Which creep forces does a ball or a wheel transmit when it pulls or brakes?",
            page="chapters/rolling.md",
            en="creep forces ball rolling creepage traction wheel creep force kalker vermeulen johnson ball drive slip ratio spin micro-slip ball on plate rolls how much does it slip reynolds slip heathcote slip tractive rolling ball rolling with traction writing ball pen spin creepage camber creep curve saturation spin axis",
            de="rollen schlupf kugel traktion kalker schlupfkraft rad wälzkontakt schlupf traktionskoeffizient kugelschreiber",
            fr="roulement pseudo-glissement bille force de traction kalker roue stylo à bille glissement relatif",
            headline=("longitudinal_force", "lateral_force", "stick_share", "loss_per_distance"),
            creepage=CURVE,
            load=PRESSED,
            picture=Caption(
                "creep", "Rolling", "Creep force over creepage, and the load of the springs at the largest creepage."
            ),
            curves=(
                ("longitudinal_creepage", "longitudinal_force"),
                ("lateral_creepage", "lateral_force"),
                ("longitudinal_creepage", "stick_share"),
            ),
            contact_shown="the contact under its normal load, without friction",
            formulas=followed_by(_springs, DRIVEN, ROLLED, CREEP),
        ),
        "simplified_rolling": answer(
            "winkler.problems.rolling.simplified_theory:SimplifiedRolling",
            question="Which creep forces does a wheel transmit on an elliptic contact or with spin, by the simplified theory?",
            page="chapters/rolling.md#spin-and-contacts-that-are-not-round",
            key="wheel rail",
            en="creep forces fastsim wheel rail creep force kalker spin tyre train railway traction ellipse creepage locomotive adhesion coefficient vehicle dynamics hunting bearing ball spin heathcote slip microslip in ball bearings camber thrust cornering force of a tyre side slip tyre self-aligning torque creep curve saturated creep force lateral creep derailment friction limit motorcycle",
            de="fastsim rad schiene schlupfkraft bahn eisenbahn kraftschluss lokomotive zug kalker schlupf kraftschlussbeiwert schräglauf reifen seitenkraft querschlupf",
            fr="fastsim roue rail chemin de fer force de pseudo-glissement kalker train locomotive dérive pneu effort latéral roue rail glissement relatif",
            headline=("longitudinal_force", "lateral_force", "moment", "saturation"),
            medium={"kind": "half_space"},
            creepage={"kind": "creepages", "longitudinal": 0.0005, "spin": "5 1/m"},
            load=PRESSED,
            picture=Caption(
                "creep",
                "Rolling",
                "Creep force over creepage; traction, stick and slip zones at the largest creepage.",
            ),
            curves=(
                ("longitudinal_creepage", "longitudinal_force"),
                ("lateral_creepage", "lateral_force"),
                ("spin_creepage", "lateral_force"),
            ),
            pictured=PicturedContact.NONE,
            formulas=_simplified,
        ),
        "rolling_start": answer(
            "winkler.problems.rolling.start:RollingStart",
            question="How do the creep forces grow when a round contact begins to roll?",
            page="chapters/rolling.md#from-rest-to-rolling",
            en="skidding skids starts rolling from rest transient creep wheel begins to roll build-up of creep force start-up distance to steady state locomotive starts",
            de="anrollen anfahren rad aus der ruhe instationär",
            fr="démarrage roulement départ arrêté transitoire roue",
            headline=("shear_force", "stick_share", "distance"),
            creepage=CREEPING,
            load=PRESSED,
            distance="0.6 mm",
            picture=Caption(
                "start",
                "From rest to rolling",
                "Force over the distance, and springs at several distances.",
            ),
            curves=(("distance", "shear_force"), ("distance", "stick_share")),
            pictured=PicturedContact.PATH,
            contact_shown="the contact under its normal load, without friction",
            formulas=followed_by(_springs, DRIVEN, CARRIED_LOAD, CREEP),
        ),
        "oscillating_rolling": answer(
            "winkler.problems.rolling.oscillating:OscillatingRolling",
            question="Does a contact hold under a shear force while it is rocked?",
            page="chapters/rolling.md",
            en="rocking shakedown false brinelling walking ball moves a little to and fro oscillating bearing rocking ball rattling ratchet by vibration rigid shift standstill marks during transport ship vibration dithering small oscillation of bearing ratchet roll back and forth",
            de="hin und her rollen schaukeln stillstandsmarkierung riffelbildung oszillierendes lager pendeln falsche brinellierung riffelmarken transport stillstand",
            fr="roulement oscillant balancement faux effet brinell va-et-vient marques à l'arrêt transport vibrations",
            headline=("shakedown_force", "shift_per_cycle", "shift"),
            amplitude="40 um",
            shear_force="15 N",
            load=PRESSED,
            picture=Caption(
                "rocking",
                "Rocking back and forth",
                "Tangential displacement over the cycles, the springs after several cycles, and the shakedown limit.",
            ),
            curves=(("cycle", "shift"),),
            pictured=PicturedContact.PATH,
            contact_shown="the contact under its normal load, without friction",
            formulas=followed_by(_springs, CARRIED_LOAD, LIMIT),
        ),
    },
)
