"""Poroelastic relaxation: held contacts, computed and measured, and their formulas."""

from __future__ import annotations

from typing import Any

from winkler.study.chapters.answer import Caption, Chapter, Equation, PicturedContact, answer
from winkler.study.chapters.kind import kind

FIRST = Equation(
    "Initially the liquid has not moved, and the body is incompressible; F₁ is the force for a modulus of one",
    r"F_0 = 4G\,F_1(d)",
)
LAST = Equation("Finally the network carries the force alone", r"F_\infty = \frac{F_0}{2(1-\nu)}")
SHARE = Equation(
    "In between, the liquid diffuses out of the contact; the surface is sealed below the indenter and drained outside",
    r"F_N(t) = F_\infty + (F_0-F_\infty)\,g(\tau,\nu), \quad \tau = \frac{D\,t}{a^2}",
)
DIFFUSION = Equation(
    "with the diffusivity from the permeability k and the viscosity of the liquid",
    r"D = \frac{2(1-\nu)}{1-2\nu}\,\frac{G\,k}{\eta}",
)
SCALED = Equation(
    "Hold periods at different contact radii are shifted into one curve; the power n of the radius is 2 for a "
    "poroelastic body, 0 for a viscoelastic one",
    r"t_j = t_1\left(\frac{a_j}{a_1}\right)^{n}",
)

BALL: dict[str, Any] = {"kind": "paraboloid", "curvature_radius": "1 mm"}
TIMES = ("1 s", "3 s", "9 s", "27 s", "81 s", "240 s", "720 s", "2200 s")
SHALLOW: dict[str, Any] = {
    "kind": "held_force",
    "profile": BALL,
    "depth": "10 um",
    "time": list(TIMES),
    "force": [*("26.4 uN", "25.9 uN", "24.8 uN", "23 uN"), *("21.4 uN", "20.3 uN", "19.7 uN", "19.4 uN")],
}
DEEP: dict[str, Any] = {
    **SHALLOW,
    "depth": "40 um",
    "force": [*("213 uN", "211 uN", "209 uN", "202 uN"), *("189 uN", "174 uN", "164 uN", "159 uN")],
}

POROELASTIC = Chapter(
    "bodies that relax",
    kinds={
        "hold": {
            "held_force": kind(
                "winkler.fitting.holds.held_force:HeldForce",
                reader="winkler.io.tables.held_force_table:read_held_force",
                problem="held_contacts",
                **{name: content for name, content in SHALLOW.items() if name != "kind"},
            ),
        },
    },
    answers={
        "poroelastic_relaxation": answer(
            "winkler.problems.poroelastic.held:PoroelasticRelaxation",
            question="How does the force fall when a gel or cartilage is held at a depth and loses its liquid?",
            page="experiments/master-curves.md#a-liquid-that-leaves",
            key="cartilage",
            en="articular cartilage liquid squeezed out loses its liquid tissue drains force drops after pressing hydrogel cartilage biphasic drainage pore pressure consolidation permeability swelling gel poroelasticity tissue water flows out sponge wet gel biphasic theory mow fluid pressurisation gel drainage time contact lens",
            de="knorpel unter dauerlast poroelastisch hydrogel knorpel porendruck konsolidierung durchlässigkeit gel wasser schwamm",
            fr="perd son liquide quand on appuie poroélastique hydrogel cartilage consolidation perméabilité drainage pression interstitielle éponge",
            headline=("relaxation_time", "first_force", "last_force"),
            profile={"kind": "paraboloid", "curvature_radius": "1 mm"},
            shear="5 kPa",
            poisson=0.3,
            diffusivity="1e-9 m^2/s",
            depth="20 um",
            time={"from": "0.1 s", "to": "1000 s", "count": 33, "spacing": "log"},
            picture=Caption(
                "poroelastic",
                "The force over time",
                "Force from the incompressible to the drained limit.",
            ),
            curves=(("time", "force"),),
            pictured=PicturedContact.NONE,
            formulas=(FIRST, LAST, SHARE, DIFFUSION),
        ),
        "held_contacts": answer(
            "winkler.fitting.holds.held_contacts:HeldContacts",
            question="Does a gel relax because its liquid flows or because its network does?",
            page="experiments/master-curves.md#a-liquid-that-leaves",
            en="is it poroelastic or viscoelastic two contact sizes ramp hold gel several radii separate relaxation diffusion diffusivity of a gel",
            de="poroelastisch oder viskoelastisch zwei kontaktgrössen haltezeit gel diffusion",
            fr="poroélastique ou viscoélastique deux rayons maintien gel diffusion",
            verdict="verdict",
            headline=("exponent", "shear", "poisson", "diffusivity"),
            holds=[SHALLOW, DEEP],
            picture=Caption(
                "holds",
                "Holds of several contact radii",
                "Measured forces and those of the poroelastic body, and times over the contact radius, compared with "
                "the laws of poroelastic and viscoelastic bodies.",
            ),
            curves=(("radius", "shift_factor"),),
            pictured=PicturedContact.NONE,
            formulas=(FIRST, LAST, SHARE, SCALED),
        ),
    },
)
