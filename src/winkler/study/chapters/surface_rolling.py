"""Rolling of contacts that need not be elliptic: the problem of height maps, and its formulas."""

from __future__ import annotations

from winkler.study.chapters.answer import Caption, Chapter, Equation, PicturedContact, answer
from winkler.study.chapters.kind import kind
from winkler.study.chapters.rough import ELEMENTS
from winkler.study.chapters.surface_friction import CERRUTI, SHEAR_FORCE

WHEEL = {
    "kind": "sampled_profile",
    "profile": {"kind": "curved_bodies", "longitudinal_curvature_radius": "20 mm", "lateral_curvature_radius": "10 mm"},
    "lengths": ["0.6 mm", "0.5 mm"],
    "shape": [54, 45],
}
CREEPS = {"kind": "creepages", "longitudinal": {"from": 0.0002, "to": 0.004, "count": 6, "spacing": "log"}}

PASSED = Equation(
    "Slip while the bodies roll by Δx: the rigid slip minus the increase of the elastic displacement",
    r"s(x) = w\,\Delta x-u(x)+u(x+\Delta x), \quad w_x = \xi-\varphi y, \quad w_y = \eta+\varphi x",
)
CARRIED = Equation(
    "Slip while the bodies roll by Δx: the rigid slip minus the increase of the elastic displacement; u' is that of "
    "the previous step",
    r"s(x) = w\,\Delta x-u(x)+u'(x+\Delta x), \quad w_x = \xi-\varphi y, \quad w_y = \eta+\varphi x",
)
DRAWN = Equation(
    "For dissimilar bodies u includes the displacement due to pressure, and tractions displace the surface normally",
    r"u_p = -\frac{\beta}{\pi E^*}\int\frac{r}{r^2}\,p\,\mathrm{d}A, \quad "
    r"u_z = \frac{\beta}{\pi E^*}\int\frac{r\cdot\tau}{r^2}\,\mathrm{d}A",
)
COULOMB = Equation(
    "In slip zones the traction is at its bound, along the slip",
    r"|\tau| \le \mu p, \quad \tau\cdot s = \mu p\,|s|",
)
MOMENT = Equation("Moment on the first body", r"M_z = \int(x\,\tau_y-y\,\tau_x)\,\mathrm{d}A")
RESISTANCE = Equation(
    "Additional dissipation due to the tangential displacement by pressure",
    r"F_r = \int\tau\cdot\frac{\partial u_p}{\partial x}\,\mathrm{d}A",
)

SURFACE_ROLLING = Chapter(
    "rolling",
    kinds={
        "law": {
            "falling_friction": kind(
                "winkler.laws.varying_friction:FallingFriction",
                problem="surface_rolling",
                static_coefficient=0.4,
                kinetic_coefficient=0.16,
                velocity="0.1 m/s",
            ),
        },
        "creepage": {
            "creep_forces": kind(
                "winkler.problems.surface_rolling.creep_force:CreepForce",
                problem="surface_rolling",
                longitudinal="15 N",
                twist={"kind": "spin"},
            ),
        },
        "twist": {
            "spin": kind(
                "winkler.problems.surface_rolling.creep_force:Spin",
                en="spin creepage twist rate",
                de="bohrschlupf",
                fr="spin",
                problem="surface_rolling",
                spin="5 1/m",
            ),
        },
    },
    answers={
        "surface_rolling": answer(
            "winkler.problems.surface_rolling.steady:SurfaceRolling",
            question="Which forces does a contact of any outline transmit when it rolls, with creepages and spin, or how much does it creep under forces?",
            page="chapters/surfaces/surface-rolling.md",
            en="creep forces contact kalker exact rolling boundary elements creep wheel rail variational half-space rolling of a map rough rolling heathcote slip conforming groove rolling spin corrugation rail slip velocities in the contact patch",
            de="rollen randelemente kalker contact schlupf rad schiene exakt",
            fr="roulement éléments de frontière kalker contact pseudo-glissement exact",
            headline=("longitudinal_force", "lateral_force", "moment", "stick_share"),
            topography=WHEEL,
            medium={"kind": "half_space", "second": {"kind": "elastic"}},
            load={"kind": "force", "force": "100 N"},
            drive=CREEPS,
            speed="20 m/s",
            picture=Caption(
                "surface_rolling",
                "Rolling by boundary elements",
                "Stick and slip zones under the last creepage with traction arrows, and the creep force.",
            ),
            curves=(
                ("longitudinal_creepage", "longitudinal_force"),
                ("lateral_creepage", "lateral_force"),
                ("spin_creepage", "lateral_force"),
                ("longitudinal_creepage", "stick_share"),
                ("longitudinal_creepage", "rolling_resistance"),
            ),
            pictured=PicturedContact.NONE,
            formulas=(ELEMENTS, CERRUTI, PASSED, DRAWN, COULOMB, SHEAR_FORCE, MOMENT, RESISTANCE),
        ),
        "surface_rolling_start": answer(
            "winkler.problems.surface_rolling.start:SurfaceRollingStart",
            question="How does a contact of any outline begin to roll?",
            page="chapters/surfaces/surface-rolling.md#from-rest",
            en="transient rolling boundary elements start from rest kalker transient",
            de="instationäres rollen randelemente anfahren",
            fr="roulement transitoire éléments de frontière démarrage",
            headline=("longitudinal_force", "longitudinal_creepage", "stick_share", "distance"),
            topography=WHEEL,
            medium={"kind": "half_space", "second": {"kind": "elastic"}},
            load={"kind": "force", "force": "100 N"},
            drive={"kind": "shear_force", "shear_force": "15 N"},
            distance="0.5 mm",
            picture=Caption(
                "surface_rolling_start",
                "From rest to rolling by boundary elements",
                "Stick and slip zones at the end with arrows for the traction, its magnitude, and creepage or force "
                "over the rolling distance.",
            ),
            curves=(
                ("distance", "longitudinal_creepage"),
                ("distance", "lateral_creepage"),
                ("distance", "longitudinal_force"),
                ("distance", "stick_share"),
            ),
            pictured=PicturedContact.NONE,
            formulas=(ELEMENTS, CERRUTI, CARRIED, DRAWN, COULOMB, SHEAR_FORCE, MOMENT),
        ),
    },
)
