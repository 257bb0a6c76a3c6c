"""Friction on contacts that are not round: the problem of height maps, and its formulas."""

from __future__ import annotations

from typing import Any

from winkler.study.chapters.answer import Caption, Chapter, Equation, PicturedContact, answer
from winkler.study.chapters.friction import NORMAL_START
from winkler.study.chapters.kind import kind
from winkler.study.chapters.rough import DISC, ELEMENTS, SAME_AREA, STAMP

TO_AND_FRO = [
    NORMAL_START,
    {"kind": "oscillate", "lateral": {"kind": "shift", "shift": "1 um"}, "cycles": 1.25, "count": 12},
]
BALL = {"kind": "sampled_profile", "lengths": ["0.6 mm", "0.6 mm"], "shape": [65, 65]}
OBLONG = {
    "kind": "sampled_profile",
    "lengths": ["0.52 mm", "0.26 mm"],
    "shape": [65, 65],
    "profile": {
        "kind": "curved_bodies",
        "longitudinal_curvature_radius": "20 mm",
        "lateral_curvature_radius": "5 mm",
    },
}

WEAKENED: dict[str, Any] = {"static_coefficient": 0.4, "kinetic_coefficient": 0.3, "distance": "10 um"}

CERRUTI = Equation(
    "Displacement due to tangential tractions; r points from the traction to the displaced point",
    r"u = \frac{1}{\pi}\int\left(\frac{a}{r}\,\tau+\frac{b}{r^3}\,r\,(r\cdot\tau)\right)\mathrm{d}A, \quad "
    r"a+b = \frac{1}{2G_t}, \quad 2a+b = \frac{2}{G^*}",
)
COULOMB = Equation(
    "In slip zones the traction equals its bound and has the direction of the slip s of the step",
    r"|\tau| \le \mu p, \quad \tau\cdot s = \mu p\,|s|",
)
SHEAR_FORCE = Equation("The spring forces add up to the tangential force", r"F = \int\tau\,\mathrm{d}A")
ENERGY = Equation("Energy dissipated in each step: traction times slip", r"W_d = \sum\int\mu p\,|s|\,\mathrm{d}A")

STIFFNESSES = Equation(
    "The tangential stiffness without slip is known; the stick zone is the contact at a smaller depth d*",
    r"F_x = \mu\left(F_N-F_N^*\right), \quad u_x = \mu\int_{d^*}^{d}\frac{k}{K_x}\,\mathrm{d}d'",
)

WITHOUT_SLIP = Equation(
    "Stiffnesses of the whole contact without slip, normal and tangential",
    r"K_z = \frac{\mathrm{d}F_N}{\mathrm{d}d}, \quad K_x = \frac{F_x}{u_x}, \quad K_y = \frac{F_y}{u_y}",
)
RATIO = Equation(
    "Ratio of tangential to normal stiffness of a disc, for bodies of the same material (Mindlin)",
    r"\frac{K_x}{K_z} = \frac{G^*}{E^*} = \frac{2\,(1-\nu)}{2-\nu}",
)
LOOPS = Equation(
    "Displacement and energy loss per cycle under a constant normal force (Ciavarella, Jaeger, Masing)",
    r"u = \mu\int_{F_N-F_x/\mu}^{F_N}\frac{\mathrm{d}F'}{K_x(F')}, \quad "
    r"W = 4F_x\,u-8\int_0^{F_x}u\,\mathrm{d}f",
)

SURFACE_FRICTION = Chapter(
    "friction and impacts",
    kinds={
        "law": {
            "linear_slip_weakening": kind(
                "winkler.laws.varying_friction:LinearSlipWeakening", problem="surface_tangential", **WEAKENED
            ),
            "exponential_slip_weakening": kind(
                "winkler.laws.varying_friction:ExponentialSlipWeakening", problem="surface_tangential", **WEAKENED
            ),
        },
    },
    answers={
        "surface_tangential": answer(
            "winkler.problems.surface_friction.tangential:SurfaceTangential",
            question="Where does a contact of any outline stick and slip when it is pushed and twisted?",
            page="chapters/surfaces/surface-friction.md",
            en="friction of rough surface partial slip map shear of asperities fretting of a measured surface stick slip in three dimensions",
            de="reibung rauer oberflächen teilschlupf höhenkarte scherung asperiten",
            fr="frottement surface rugueuse glissement partiel cisaillement aspérités",
            headline=("dissipation", "shear_force_x", "stick_share", "peak_pressure", "force", "loss_per_cycle"),
            topography=BALL,
            medium={"kind": "half_space", "second": {"kind": "elastic"}},
            path={"kind": "program", "steps": TO_AND_FRO},
            picture=Caption(
                "surface_tangential",
                "Stick and slip zones",
                "Stick and slip zones at the end of the path with arrows for the traction, its magnitude, and the "
                "loop of the shear force, by boundary elements.",
            ),
            curves=(
                ("shift_x", "shear_force_x"),
                ("shift_y", "shear_force_y"),
                ("angle", "torque"),
                ("time", "stick_share"),
                ("time", "dissipation"),
            ),
            pictured=PicturedContact.NONE,
            formulas=(ELEMENTS, CERRUTI, COULOMB, SHEAR_FORCE, ENERGY),
        ),
        "reduced_friction": answer(
            "winkler.problems.surface_friction.reduced:ReducedFriction",
            question="Which springs replace a rough surface under long histories of shear, and how large is their error?",
            page="chapters/surfaces/surface-friction.md#springs-instead-and-their-error",
            en="springs for friction of a map equivalent friction model reduced order joint model",
            de="ersatzfedern reibung höhenkarte reduziertes modell",
            fr="ressorts équivalents frottement modèle réduit",
            headline=("shift_error", "loss_error", "force", "shift", "spring_shift"),
            topography=OBLONG,
            medium={"kind": "half_space", "second": {"kind": "elastic"}},
            depth="1.5 um",
            picture=Caption(
                "reduced_friction",
                "Springs and boundary elements under the same shear force",
                "Loops along x and y (lines: springs, points: boundary elements), and the stiffness of both "
                "directions over the depth.",
            ),
            curves=(("shift_x", "shear_force"), ("shift_y", "shear_force")),
            pictured=PicturedContact.NONE,
            formulas=(ELEMENTS, SAME_AREA, DISC, STIFFNESSES, CERRUTI, COULOMB),
        ),
        "joint_stiffness": answer(
            "winkler.problems.surface_friction.joint:JointStiffness",
            question="How stiff is a joint of rough surfaces, normal and tangential, and how much energy does it lose in a cycle?",
            page="chapters/surfaces/joints.md",
            key="bolt joint",
            en="bolted joint stiffness interface stiffness machine tool joint contact stiffness per area damping how stiff is the joint flange shear stiffness joint damping bolted flange clamp guideway stiffness machine tool interface per unit area ultrasonic reflection tangential stiffness of a rough interface normal stiffness of joint modal identification of joint contact layer for finite elements greenwood stiffness bolted faces compliance of rough bodies asperity compliance",
            de="fügestelle steifigkeit schraubverbindung fugensteifigkeit kontaktsteifigkeit werkzeugmaschine dämpfung wie steif führungssteifigkeit verschraubte fuge",
            fr="raideur de liaison boulonnée assemblage raideur de contact amortissement joint machine-outil raideur d'interface glissière serrage de vis rigidité des plaques",
            headline=("areal_stiffness", "areal_stiffness_x", "ratio_x", "loss_per_cycle", "shift_error", "loss_error"),
            topography={**STAMP, "seed": 1},
            medium={"kind": "half_space", "second": {"kind": "elastic"}},
            picture=Caption(
                "joint_stiffness",
                "Stiffness of the joint, and dissipated energy per cycle",
                "Normal and tangential stiffness per area over the nominal pressure, and their ratio compared with "
                "that of a disc; loops of the shear force, and dissipated energy per cycle over the displacement "
                "amplitude (lines: springs, points: boundary elements).",
            ),
            curves=(
                ("nominal_pressure", "areal_stiffness"),
                ("nominal_pressure", "areal_stiffness_x"),
                ("force", "ratio_x"),
                ("shift_amplitude", "loss_per_cycle"),
                ("shift_amplitude", "loss_factor"),
            ),
            pictured=PicturedContact.NONE,
            formulas=(ELEMENTS, WITHOUT_SLIP, RATIO, LOOPS, CERRUTI, COULOMB),
        ),
    },
)
