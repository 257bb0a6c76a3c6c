"""Wear: laws, problems, and their formulas."""

from __future__ import annotations

from winkler.study.chapters.answer import WORN_SHAPE, Caption, Chapter, Equation, PicturedContact, answer, followed_by
from winkler.study.chapters.kind import kind
from winkler.study.chapters.normal import ELLIPSE, normal_formulas

STEEL = {"kind": "archard", "rate": "1e-5 mm^3/(N m)"}
CYCLE_COUNTS = [0.0, 100.0, 1000.0, 3000.0, 10000.0]

FRETTING_SPRINGS = Equation(
    "Under the displacement amplitude U every spring sticks until its load reaches the friction limit",
    r"u_t(x) = \min\left(U, \mu\,\frac{E^*}{G^*}\,(d-g(x))\right)",
)
SLIP = Equation(
    "Slip of the surfaces, from the difference between U and the displacement of the springs",
    r"s(r) = \frac{2}{\pi}\int_0^r \frac{U-u_t(x)}{\sqrt{r^2-x^2}}\,\mathrm{d}x",
)
FRETTING_RATE = Equation(
    "Each cycle every point slips four times this distance; worn depth is proportional to pressure (Archard)",
    r"\frac{\mathrm{d}f}{\mathrm{d}n} = 4\,\kappa\,p(r)\,s(r)",
)
SLIDING_RATE = Equation(
    "In sliding, the worn depth is proportional to pressure and sliding distance (Archard's law)",
    r"\frac{\mathrm{d}f}{\mathrm{d}s} = \kappa\,p(r)",
)
UPDATED_SPRINGS = Equation(
    "The worn profile is transformed after each step; the worn depth changes the plane profile by",
    r"\Delta g(x) = \Delta f(0) + x\int_0^x \frac{\Delta f'(r)}{\sqrt{x^2-r^2}}\,\mathrm{d}r",
)
CORE = Equation("The stick zone ends at c", r"G^*\,U = \mu\,E^*\,(d-g(c))")
LIMIT = Equation(
    "Finally the stick zone carries the whole load; the worn surface matches the displacement due to its pressure",
    r"f_\infty(r) = d-u(r) = \frac{2}{\pi}\left(\int_0^c \frac{g(x)}{\sqrt{r^2-x^2}}\,\mathrm{d}x "
    r"+ d\,\arccos\frac{c}{r}\right)",
)
SLID_ELLIPSE = Equation(
    "As long as the wear is small, the worn depth of the slider is proportional to Hertz' pressure",
    r"h(x,y) = \kappa_1\,p_0\,s\,\sqrt{1-\frac{x^2}{a^2}-\frac{y^2}{b^2}}, \quad V = \kappa_1\,F\,s",
)
TRACK = Equation(
    "and n passes at the angle θ to x wear a track of parabolic cross-section",
    r"h(t) = n\,\kappa_2\,\frac{3F}{4w}\left(1-\frac{t^2}{w^2}\right)",
)
TRACK_WIDTH = Equation(
    "whose half-width is that of the ellipse across the sliding direction",
    r"w = \sqrt{a^2\sin^2\theta+b^2\cos^2\theta}",
)

WEAR = Chapter(
    "wear",
    kinds={
        "wear": {
            "archard": kind(
                "winkler.laws.wear:Archard",
                "archard_1953",
                en="archard wear coefficient specific wear rate holm",
                de="archard verschleisskoeffizient",
                fr="loi d'archard",
                rate="1e-5 mm^3/(N m)",
            ),
            "pair_wear": kind(
                "winkler.laws.wear:PairWear",
                problem="fretting_wear",
                first=STEEL,
                second={"kind": "archard", "rate": "2e-5 mm^3/(N m)"},
            ),
        },
    },
    answers={
        "fretting_wear": answer(
            "winkler.problems.wear.fretting:FrettingWear",
            unstressed=WORN_SHAPE,
            question="How does a fretting joint wear?",
            page="chapters/wear.md",
            key="fretting",
            en="worn taper junction fretting wear scar reciprocating wear archard vibration wear contact scar depth connector fretting how long does it last lifetime debris hip implant taper worn off rate dissipated energy wear coefficient fretting modular taper micromotion trunnion fretting corrosion of connectors tin fretting number of cycles electric contact vibration wear tube million cycles vibrating plug wears through its gold plating press fit of a hub on a shaft fretting spline coupling false brinelling",
            de="schwingverschleiss fretting reibkorrosion verschleissnarbe archard lebensdauer passungsrost wie lange hält es zyklen hält schwingungsreibung modularer konus reibkorrosion einer passung welle nabe",
            fr="usure par fretting petits débattements trace d'usure archard durée de vie vibration million de cycles usure cône modulaire usure après cycles",
            headline=("worn_volume", "worn_depth", "cycles"),
            says={"worn_volume": "{worn_volume} are worn off, {worn_depth} deep"},
            normal={"kind": "force", "force": "100 N"},
            amplitude={"kind": "shift", "shift": "0.5 um"},
            cycles=CYCLE_COUNTS,
            count=100,
            tolerance=1e-3,
            picture=Caption(
                "fretting",
                "Worn by fretting",
                "Profiles, worn depth and pressure after some of the cycles; contact, stick zone, volume and load over them.",
            ),
            curves=(("cycles", "worn_volume"), ("cycles", "stick_radius"), ("cycles", "force"), ("cycles", "depth")),
            pictured=PicturedContact.NONE,
            formulas=followed_by(normal_formulas, FRETTING_SPRINGS, SLIP, FRETTING_RATE, UPDATED_SPRINGS),
        ),
        "sliding_wear": answer(
            "winkler.problems.wear.sliding:SlidingWear",
            unstressed=WORN_SHAPE,
            question="How does a pin wear on a disc?",
            page="chapters/wear.md",
            key="wear",
            en="knee implant wear bushing sleeve loses material material loss cup wear denture tooth wear pin on disc wear rate archard volume worn tip wear ball wears flat lifetime block running-in ball-on-disc wear track how long does it last abrasion prosthesis adhesive wear reciprocating ball-on-flat tribometer wear coefficient specific wear rate severe and mild plain bushing kilometres pin lost brush wear enamel polyethylene knee slip ring jewel valve wear brake pad wear clutch lining life",
            de="nutzt sich ab gleitschuh abnutzen kilometer verschleiss stift scheibe verschleissrate archard abrieb einlaufen standzeit abnutzung gleitverschleiss verschleisskoeffizient gleitbuchse bremsbelagverschleiss adhäsiver verschleiss lebensdauer buchse gleitlagerverschleiss verschleiss eines gleitlagers",
            fr="usure pion disque taux d'usure archard abrasion durée de vie rodage bille disque usure adhésive coefficient d'usure bague lisse usure des dents plaquette usure d'un palier lisse",
            headline=("worn_volume", "worn_depth", "distance"),
            says={"worn_volume": "{worn_volume} are worn off, {worn_depth} deep"},
            normal={"kind": "force", "force": "100 N"},
            distance=["0 m", "0.1 m", "0.3 m", "1 m"],
            count=100,
            tolerance=1e-3,
            picture=Caption(
                "sliding",
                "Worn by sliding",
                "Profiles, worn depth, pressure; contact, wear volume and mean pressure over the distance.",
            ),
            curves=(("distance", "worn_volume"), ("distance", "radius"), ("distance", "mean_pressure")),
            pictured=PicturedContact.NONE,
            formulas=followed_by(normal_formulas, SLIDING_RATE, UPDATED_SPRINGS),
        ),
        "elliptic_wear": answer(
            "winkler.problems.wear.elliptic:EllipticWear",
            unstressed=WORN_SHAPE,
            question="How deep does a body with two curvatures wear at first, and how deep is its track?",
            page="chapters/ellipses.md#wear",
            en="knee implant wear condyle wheel wear bearing wear raceway wear ellipse crossed cylinder wear test wire rope wires crossed polyethylene tray enamel crossed-cylinder tester",
            de="verschleiss ellipse laufbahn rad gekreuzte zylinder",
            fr="usure ellipse cylindres croisés chemin de roulement",
            headline=("worn_depth", "worn_volume", "track_depth", "track_half_width"),
            says={"worn_depth": "the body has worn {worn_depth} deep, the track {track_depth}"},
            wear={"kind": "pair_wear", "first": {**STEEL, "rate": "1e-8 mm^3/(N m)"}, "second": STEEL},
            load={"kind": "force", "force": "100 N"},
            distance="1 m",
            angle="30 deg",
            picture=Caption(
                "elliptic_wear",
                "Worn by sliding",
                "Worn depth of the slider over the ellipse with the direction of sliding, and the cross-section of "
                "the track.",
            ),
            pictured=PicturedContact.NONE,
            formulas=(ELLIPSE, SLID_ELLIPSE, TRACK, TRACK_WIDTH),
        ),
        "limiting_profile": answer(
            "winkler.problems.wear.limiting_profile:LimitingProfile",
            unstressed=WORN_SHAPE,
            question="Which shape does a fretting joint have in the end?",
            page="chapters/wear.md",
            en="worn surface look after millions of small vibrations final shape after fretting worn end state steady state scar where does wear stop limiting shape",
            de="endform grenzprofil wo hört verschleiss auf endzustand fretting riffelbildung einer schiene",
            fr="forme limite fin de l'usure profil final fretting",
            headline=("worn_volume", "worn_depth", "stick_radius"),
            says={"worn_volume": "{worn_volume} are worn off in the end, {worn_depth} deep"},
            normal={"kind": "depth", "depth": "1 um"},
            amplitude={"kind": "shift", "shift": "0.2 um"},
            picture=Caption(
                "limit",
                "Where wear ends",
                "Final profile, worn depth, and final pressure, which acts in the stick zone only.",
            ),
            pictured=PicturedContact.NONE,
            formulas=followed_by(normal_formulas, CORE, LIMIT),
        ),
    },
)
