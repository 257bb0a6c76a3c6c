"""Rolling line contacts: their loads, problems, and formulas."""

from __future__ import annotations

from winkler.study.chapters.answer import Caption, Chapter, Equation, PicturedContact, answer
from winkler.study.chapters.kind import kind
from winkler.study.chapters.lines.line import ROLLER
from winkler.study.chapters.normal import MODULUS

STEEL = {"kind": "elastic", "young": "210 GPa", "poisson": 0.3}
STEEL_ON_STEEL = {**ROLLER, "medium": {"kind": "half_space", "first": STEEL, "second": STEEL}}
RELAXING = {**ROLLER, "medium": {"kind": "viscoelastic_half_space"}}
PRESSED = {"kind": "line_force", "force_per_length": "100 N/mm"}
CREEPAGES = {"kind": "creepages", "longitudinal": {"from": 0.0, "to": 0.004, "count": 25}}

HERTZ = Equation(
    "A cylinder is pressed on half-planes to the half-width and pressure of Hertz",
    r"a = \sqrt{\frac{4PR}{\pi E^*}}, \quad p = p_0\,\sqrt{1-\frac{x^2}{a^2}}, \quad p_0 = \frac{2P}{\pi a}",
)
STICK = Equation(
    "The stick zone extends from the leading edge a to a − 2c; c follows from the force per length or the creepage",
    r"\frac{Q}{\mu P} = 1-\frac{c^2}{a^2}, \quad \xi = \frac{\mu\,(a-c)}{R}",
)
TRACTION = Equation(
    "The traction is that of full sliding, minus the second term in the stick zone",
    r"q(x) = \mu p_0\,\left[\sqrt{1-\frac{x^2}{a^2}}-\frac{c}{a}\sqrt{1-\frac{(x-a+c)^2}{c^2}}\right]",
)
SLIP = Equation(
    "and behind the stick zone the slip velocity over the rolling speed is",
    r"s(x) = \frac{\mu}{R}\sqrt{(x-a+c)^2-c^2}, \quad x < a-2c",
)

PARTICLE = Equation(
    "A particle of the surface that is now at x was at x + h one element ago, and slips by",
    r"S = W-u(x)+u_0(x+h)-\frac{2\beta}{E^*}\int_x^{x+h}p\,\mathrm{d}x', \quad \xi = \frac{W}{h}",
)
DISPLACED = Equation(
    "with Dundurs' constant β for dissimilar bodies; tractions displace the surfaces by",
    r"u(x) = -\frac{2}{\pi E^*}\int_{-a}^a q(s)\,\ln\left|x-s\right|\,\mathrm{d}s",
)
FRICTION = Equation(
    "Conditions of stick and slip",
    r"S = 0, \quad \left|q\right| \le \mu p, \quad q\,S = \mu p\left|S\right|",
)
CREEP = Equation("Creep function for a step of pressure", r"C(t) = C_0+\sum_k C_k\left(1-e^{-t/\lambda_k}\right)")
TRANSFORM = Equation(
    "In an elastic body the slope of the surface follows from the pressure by",
    r"g(x) = \frac{1}{\pi}\int \frac{p(s)}{x-s}\,\mathrm{d}s",
)
SLOPE = Equation(
    "Surface particles enter from the front at the speed v and follow the cylinder in the strip",
    r"2\left[C_0\,g(x)+\sum_k C_k\int_0^\infty \frac{e^{-s/v\lambda_k}}{v\lambda_k}\,g(x+s)\,"
    r"\mathrm{d}s\right] = \frac{x}{R}",
)
RESISTANCE = Equation(
    "Resistance due to the pressure in front of the lowest point",
    r"Q = \int p(x)\,\frac{x}{R}\,\mathrm{d}x, \quad f = \frac{Q}{P}",
)

COUPLED = Equation(
    "Coupled equations of pressure and traction for dissimilar bodies",
    r"\frac{x}{R} = \frac{2}{\pi E^*}\int\frac{p(s)}{x-s}\,\mathrm{d}s-\frac{2\beta}{E^*}\,q, \quad "
    r"s(x) = \xi-\frac{2}{\pi E^*}\int\frac{q(s)}{x-s}\,\mathrm{d}s-\frac{2\beta}{E^*}\,p",
)

LAYERED = Equation(
    "On layers the kernels are those of the responses to pressure (N) and shear (A), and of their coupling (C)",
    r"\frac{x-m}{R} = \int N(x-s)\,p\,\mathrm{d}s-\int C(x-s)\,q\,\mathrm{d}s, \quad "
    r"s(x) = \xi-\int A(x-s)\,q\,\mathrm{d}s-\int C(x-s)\,p\,\mathrm{d}s",
)

LINE_ROLLING = Chapter(
    "line contact",
    kinds={
        "line_lateral": {
            "line_shear_force": kind(
                "winkler.loading.loads:LineShearForce", problem="line_rolling", shear_force_per_length="15 N/mm"
            ),
        },
    },
    answers={
        "line_rolling": answer(
            "winkler.problems.line_rolling.steady:LineRolling",
            "carter_1926",
            "johnson_1985",
            "bentall_johnson_1967",
            question="How much does a driving or braking cylinder creep, and where does it slip?",
            page="chapters/line-rolling.md",
            en="creep forces carter driving roller traction creepage cylinder traction coefficient driven wheel roller drive friction drive transmission microslip belt variator two-dimensional rolling paper feed roller drive cvt traction drive tangential force of rollers paper feed cylinder nip drive creep of belt on pulley microslip carter creep of a belt",
            de="carter reibrad walze schlupf treibrolle antrieb zylinder rollen traktion übertragung reibradgetriebe wälzen reibradantrieb papiervorschub wälzgetriebe schlupfwelle",
            fr="carter rouleau entraîneur glissement cylindre roulant transmission par friction pseudo-glissement galet moteur galet tracteur entraînement par galet variateur",
            headline=("shear_force_per_length", "stick_share", "traction_ratio", "longitudinal_creepage"),
            bed=STEEL_ON_STEEL,
            drive=CREEPAGES,
            load=PRESSED,
            picture=Caption("line_creep", "Rolling", "Force over creepage, and the traction at the largest creepage."),
            curves=(("longitudinal_creepage", "shear_force_per_length"), ("longitudinal_creepage", "stick_share")),
            pictured=PicturedContact.NONE,
            formulas=(MODULUS, HERTZ, STICK, TRACTION, SLIP, COUPLED, LAYERED),
        ),
        "line_rolling_start": answer(
            "winkler.problems.line_rolling.start:LineRollingStart",
            "kalker_1970",
            "carter_1926",
            "bentall_johnson_1967",
            question="How does a cylinder begin to roll, and after which distance is it steady?",
            page="chapters/line-rolling.md#from-rest",
            en="starting to roll roller from rest transient creepage kalker two-dimensional start-up cylinder",
            de="anrollen anfahren walze instationär schlupf zylinder",
            fr="démarrage du roulement cylindre transitoire départ galet",
            headline=("shear_force_per_length", "stick_share", "distance"),
            bed=STEEL_ON_STEEL,
            drive={"kind": "line_shear_force", "shear_force_per_length": "19.2 N/mm"},
            load=PRESSED,
            distance="0.4 mm",
            picture=Caption(
                "line_start",
                "From rest to rolling",
                "Creepage or force over the rolling distance, and tractions at several distances.",
            ),
            curves=(("distance", "longitudinal_creepage"), ("distance", "stick_share")),
            pictured=PicturedContact.NONE,
            formulas=(MODULUS, HERTZ, DISPLACED, PARTICLE, FRICTION),
        ),
        "line_rolling_resistance": answer(
            "winkler.problems.line_rolling.resistance:LineRollingResistance",
            "hunter_1961",
            question="What resistance does a cylinder meet when it rolls or slides over rubber?",
            page="chapters/line-rolling.md#bodies-that-relax",
            en="rolling loss of rubber roller conveyor belt indentation resistance rubber tyre hysteresis cylinder energy loss roller drag conveyor idler hunter conveyor belt power drawn by belt idlers pressing rubber energy needed to roll polyurethane wheel rolling friction coefficient of a roller",
            de="rollwiderstand gummiwalze förderband eindrückrollwiderstand tragrolle hysterese verlust walze reifen rollreibungszahl förderband leistung",
            fr="énergie perdue par un pneu en roulant perd énergie roule résistance au roulement rouleau caoutchouc bande transporteuse convoyeur hystérésis perte pneu puissance convoyeur",
            headline=("coefficient", "shear_force_per_length", "peak_pressure", "half_width"),
            bed=RELAXING,
            load={"kind": "line_force", "force_per_length": "0.1 N/mm"},
            speed={"from": "0.1 mm/s", "to": "1 m/s", "count": 17, "spacing": "log"},
            picture=Caption(
                "line_resistance",
                "Rolling resistance",
                "Coefficient of rolling resistance over the speed, and pressures at three speeds.",
            ),
            curves=(("speed", "coefficient"), ("speed", "half_width")),
            pictured=PicturedContact.NONE,
            formulas=(CREEP, TRANSFORM, SLOPE, RESISTANCE),
        ),
    },
)
