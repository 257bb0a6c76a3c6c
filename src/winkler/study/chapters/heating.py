"""Frictional heat: its partition, problems, and their formulas."""

from __future__ import annotations

from typing import Any

from winkler.study.chapters.answer import Caption, Chapter, Equation, PicturedContact, answer
from winkler.study.chapters.friction import tangential_formulas
from winkler.study.chapters.kind import kind
from winkler.study.chapters.lines.line import LOAD, LOAD_PROFILE, PRESSURE, ROLLER
from winkler.study.chapters.normal import ELLIPSE, MODULUS, normal_formulas
from winkler.values.checks.contract import is_a

STEEL = {"kind": "thermal_conductor", "conductivity": "45 W/(m K)", "diffusivity": "12 mm^2/s"}
STEELS: dict[str, Any] = {"kind": "heat_conductors", "first": STEEL, "second": STEEL}
ELLIPTIC = "winkler.problems.normal.elliptic:EllipticIndentation"
COULOMB = {"kind": "coulomb", "coefficient": 0.3}
PRESSED = {"kind": "indentation", "load": {"kind": "force", "force": "20 N"}}
TWO_CYCLES = [
    {"kind": "start", "normal": {"kind": "force", "force": "100 N"}},
    {"kind": "oscillate", "lateral": {"kind": "shift", "shift": "1 um"}, "cycles": 2.0},
]

FLUX = Equation("Frictional heat flux, proportional to the pressure", r"q(r) = \mu\,p(r)\,v, \quad Q = \mu\,F_N\,v")
AT_REST = Equation(
    "On a body at rest, temperature follows from heat flux as displacement follows from pressure",
    r"T(r) = \frac{1}{\pi\lambda}\int_0^r \frac{q_1(x)}{\sqrt{r^2-x^2}}\,\mathrm{d}x, \quad "
    r"q_1(x) = 2\int_x^a \frac{q(r)\,r}{\sqrt{r^2-x^2}}\,\mathrm{d}r",
)
MOVING = Equation(
    "On a body that moves at the speed V the temperature is an integral over all directions, each with its line load",
    r"T(x,y) = \frac{1}{2\pi\lambda}\int_{-\pi/2}^{\pi/2} "
    r"\left[q_1(s)-\int_s^a q_1(t)\,\frac{b}{2}\,D\left(\frac{b}{2}(t-s)\right)\,\mathrm{d}t\right]\,\mathrm{d}\theta",
)
MOVING_KERNEL = Equation(
    "with the direction θ and the kernel",
    r"b = \frac{V}{\kappa}\,\cos\theta, \quad s = x\,\cos\theta+y\,\sin\theta, \quad D(z) = e^{-z}(I_0(z)-I_1(z))",
)
SHARE = Equation(
    "Heat partition; T₁ and T₂ are the maximum (or mean) temperatures of each body if it received all heat",
    r"\alpha = \frac{T_2}{T_1+T_2}, \quad \mathrm{Pe} = \frac{V\,a}{2\kappa}",
)
TRANSIENT = Equation(
    "At the time t a temperature wave has reached a fraction that depends only on its wave number k",
    r"T_k(t) = T_k(\infty)\,\mathrm{erf}\left(k\sqrt{\kappa t}\right)",
)
CYCLE = Equation(
    "Heat generated per area in each cycle, times the frequency f",
    r"w(r) = \oint \tau\,\mathrm{d}s, \quad q(r) = f\,w(r), \quad Q = f\,W",
)
COMMON_SURFACE = Equation(
    "Both bodies are at rest; the heat is divided in proportion to their conductivities",
    r"T(r) = \frac{1}{\pi(\lambda_1+\lambda_2)}\int_0^r \frac{q_1(x)}{\sqrt{r^2-x^2}}\,\mathrm{d}x, \quad "
    r"q_1(x) = 2\int_x^a \frac{q(r)\,r}{\sqrt{r^2-x^2}}\,\mathrm{d}r",
)
BAND = Equation(
    "Temperature under an infinitely long band: the sum of line sources (Jaeger), with the Bessel function K₀",
    r"T(x) = \frac{1}{\pi\lambda}\int_{-a}^a \mu\,p(s)\,v\,\mathrm{e}^{z}\,K_0(|z|)\,\mathrm{d}s, \quad "
    r"z = \frac{V}{2\kappa}\,(x-s)",
)
EVEN_BAND = Equation(
    "The temperature of each body is the sum of line sources (Jaeger), with the Bessel function K₀",
    r"T(x) = \frac{q}{\pi\lambda}\int_{-a}^a \mathrm{e}^{z}\,K_0(|z|)\,\mathrm{d}s, \quad "
    r"z = \frac{V}{2\kappa}\,(x-s), \quad Q = 2\,a\,q",
)
BAND_FLUX = Equation("Frictional heat flux, proportional to the pressure", r"q(x) = \mu\,p(x)\,v, \quad Q = \mu\,P\,v")
ELLIPTIC_FLUX = Equation(
    "Frictional heat is proportional to the pressure; in the direction θ the flux of Hertz' ellipse has the line load",
    r"Q = \mu\,F_N\,v, \quad q_1(s) = \frac{3Q}{4h}\left(1-\frac{s^2}{h^2}\right), \quad "
    r"h = \sqrt{a^2\cos^2\theta+b^2\sin^2\theta}",
)
ELLIPTIC_MOVING = Equation(
    "On a body that moves at the speed V and the angle ψ to x, the temperature is an integral over all directions",
    r"T(x,y) = \frac{3Q}{4\pi\lambda}\int_{\psi-\pi/2}^{\psi+\pi/2} \frac{1}{h^3}\int_s^h "
    r"t\,E\left(\frac{b}{2}(t-s)\right)\,\mathrm{d}t\,\mathrm{d}\theta",
)
ELLIPTIC_KERNEL = Equation(
    "with the rate and the kernel",
    r"b = \frac{V}{\kappa}\,\cos(\theta-\psi), \quad s = x\,\cos\theta+y\,\sin\theta, \quad E(z) = e^{-z}\,I_0(z)",
)


def heating_formulas(problem: Any) -> tuple[Equation, ...]:
    """Return the formulas of a contact that slides steadily: round, or of two curvatures."""
    if is_a(problem.contact, ELLIPTIC):
        return (ELLIPSE, ELLIPTIC_FLUX, ELLIPTIC_MOVING, ELLIPTIC_KERNEL, SHARE)
    before = normal_formulas(problem.contact)
    return (*before, FLUX, AT_REST, MOVING, MOVING_KERNEL, SHARE) if before else ()


def transient_formulas(problem: Any) -> tuple[Equation, ...]:
    """Return the formulas of a contact that begins to slide."""
    if is_a(problem.contact, ELLIPTIC):
        return (ELLIPSE, ELLIPTIC_FLUX, TRANSIENT, SHARE)
    before = normal_formulas(problem.contact)
    return (*before, FLUX, AT_REST, TRANSIENT, SHARE) if before else ()


def fretting_formulas(problem: Any) -> tuple[Equation, ...]:
    """Return the formulas of a periodic motion, and of its heat."""
    return (*tangential_formulas(problem.contact), CYCLE, COMMON_SURFACE)


HEATING = Chapter(
    "frictional heat",
    kinds={
        "partition": {
            "equal_maximum": kind("winkler.laws.heat:EqualMaximum", "blok_1963"),
            "equal_mean": kind("winkler.laws.heat:EqualMean", "jaeger_1942"),
            "fixed_share": kind("winkler.laws.heat:FixedShare", first_share=0.5),
        },
    },
    answers={
        "friction_heating": answer(
            "winkler.problems.heating.steady:FrictionHeating",
            question="How hot do two rubbing bodies get, round or of two curvatures, that slide in any direction?",
            page="chapters/heating.md",
            key="hot temperature flash",
            en="flash temperature friction heat how hot does it get hot temperature rise sliding brake dry bearing pin on disc temperature jaeger archard blok heat partition frictional heating burn grinding temperature peclet heat partition coefficient charron peclet number bulk temperature brake pad ice skate snow ski melting by friction asperity temperature pad on disc hot sliding shoe temperature at asperities clutch lining burn locked brake wheel flat pv limit clutch judder hot spots slip ring brush sandpaper burn wheel rail temperature bearing flash temperature skidding ball smearing spinning traction heat ellipse wheel slide heat ball bearing hot skidding in high speed bearings slides on rail smearing damage heat smearing marks roller",
            de="blitztemperatur reibwärme wie heiss temperatur erwärmung gleiten bremse stift scheibe reibungshitze heiss bremsbelag reibfläche bremstemperatur kontakterwärmung kupplungsbelag eis schlittschuh rad schiene wälzlager anschmierung ellipse schlupf blockiertes rad flachstelle anschmierungen",
            fr="température éclair chaleur de frottement échauffement quelle température frein pion disque chaud patin de frein garniture température flash patinage glace roue rail roulement ellipse enrayage roue bloquée",
            headline=("flash_temperature", "first_mean_temperature", "heat_rate", "first_share"),
            says={
                "flash_temperature": "the hottest place of the contact is {flash_temperature} warmer than the bodies"
            },
            contact=PRESSED,
            law=COULOMB,
            conductors=STEELS,
            first_speed="1 m/s",
            picture=Caption(
                "heating",
                "Temperatures of the bodies",
                "Surface temperature of the body with the higher Peclet number, temperatures of both surfaces along "
                "its motion, and the flash temperature over the speed; for many loads or speeds, temperatures and "
                "heat partition over the varied quantity.",
            ),
            formulas=heating_formulas,
        ),
        "line_friction_heating": answer(
            "winkler.problems.heating.line_heating:LineFrictionHeating",
            "johnson_1985",
            question="How hot does a sliding roller, gear tooth or cam get?",
            page="chapters/flash.md#lines",
            en="gear flash temperature blok scuffing tooth hot roller frictional heat line contact disc machine twin disc traction heat piston ring seizure cam temperature scuffing load scuffing criterion integral temperature gear mesh heat scoring bulk temperature plus flash plain bearing seizure third rail shoe pantograph strip heat smearing marks roller",
            de="blitztemperatur zahnrad fressen blok zwei-scheiben rolle reibwärme linienkontakt kolbenring temperatur nocken fresstragfähigkeit fressen blitztemperatur zahneingriff verzahnung anschmierungen an rollen",
            fr="température éclair engrenage grippage rouleau échauffement contact linéique segment de piston bi-disque grippage température de denture",
            headline=("flash_temperature", "first_mean_temperature", "heat_per_length", "first_share"),
            says={
                "flash_temperature": "the hottest place of the contact is {flash_temperature} warmer than the bodies"
            },
            contact={
                "kind": "line_indentation",
                "bed": ROLLER,
                "load": {"kind": "line_force", "force_per_length": "400 N/mm"},
            },
            law={"kind": "coulomb", "coefficient": 0.05},
            conductors=STEELS,
            first_speed="6 m/s",
            second_speed="4 m/s",
            picture=Caption(
                "heating",
                "Temperatures of the bodies",
                "Temperatures of both surfaces across the strip, and the flash temperature over the speed; for many "
                "loads or speeds, temperatures and heat partition over the varied quantity.",
            ),
            pictured=PicturedContact.NONE,
            formulas=(MODULUS, LOAD_PROFILE, LOAD, PRESSURE, BAND_FLUX, BAND, SHARE),
        ),
        "band_heating": answer(
            "winkler.problems.heating.band_heating:BandHeating",
            question="How hot does an even band of heat, such as a line of laser light, make a body that moves past it?",
            page="chapters/flash.md#an-even-band",
            en="moving heat source strip laser grinding band jaeger carslaw moving band brake pad belt heat source wheel grinding burn workpiece wheel zone heat flux strip cutting zone brake band",
            de="wandernde wärmequelle bandquelle streifen schleifen laser jaeger schleifbrand",
            fr="source de chaleur mobile bande laser rectification jaeger meulage brûlure de rectification",
            headline=("flash_temperature", "first_mean_temperature", "heat_per_length", "first_share"),
            says={
                "flash_temperature": "the hottest place of the contact is {flash_temperature} warmer than the bodies"
            },
            half_width="0.1 mm",
            heat_flux="100 W/mm^2",
            conductors=STEELS,
            first_speed="6 m/s",
            second_speed="4 m/s",
            picture=Caption(
                "heating",
                "Temperatures of the bodies",
                "Temperatures of both surfaces across the band, and the flash temperature over the speed; for many "
                "half-widths, fluxes or speeds, temperatures and heat partition over the varied quantity.",
            ),
            pictured=PicturedContact.NONE,
            formulas=(EVEN_BAND, SHARE),
        ),
        "transient_heating": answer(
            "winkler.problems.heating.transient:TransientHeating",
            question="How fast do two bodies warm up after they begin to slide slowly?",
            page="chapters/heating.md#when-it-begins",
            en="warm up in time start of sliding thermal transient how long until hot heating up start-stop warming time heat builds up with time spin welding friction stir dwell heating clutch engagement short slide",
            de="aufwärmen anlauf instationär wie lange bis heiss zeitlicher verlauf erwärmung einkuppeln aufheizzeit",
            fr="échauffement transitoire démarrage temps de chauffe montée en température embrayage",
            headline=("flash_temperature", "stationary_temperature", "time"),
            says={
                "flash_temperature": "the hottest place of the contact is {flash_temperature} warmer than the bodies"
            },
            contact=PRESSED,
            law=COULOMB,
            conductors=STEELS,
            speed="10 mm/s",
            time={"from": "10 us", "to": "1 s", "count": 16, "spacing": "log"},
            picture=Caption(
                "heating",
                "Heating of the contact",
                "The flash temperature over time, and the surface temperature of the first body at several times.",
            ),
            curves=(("time", "flash_temperature"), ("time", "first_share")),
            formulas=transient_formulas,
        ),
        "fretting_heat": answer(
            "winkler.problems.heating.fretting:FrettingHeat",
            question="How hot does a contact get that is pushed back and forth?",
            page="chapters/heating.md#fretting",
            en="small oscillation warms up the contact plug vibrates warm heat by vibration fretting temperature ultrasonic welding reciprocating heat oscillating contact warm linear friction welding",
            de="reibschweissen fretting temperatur schwingend erwärmung ultraschallschweissen hin und her",
            fr="échauffement par vibration fretting soudage par friction ultrasons va-et-vient",
            headline=("max_temperature", "mean_temperature", "heat_rate", "loss_per_cycle"),
            contact={"kind": "tangential", "law": COULOMB, "path": {"kind": "program", "steps": TWO_CYCLES}},
            frequency="100 Hz",
            conductors=STEELS,
            picture=Caption(
                "heating",
                "Temperature of the contact",
                "Distribution of the heat generated in a cycle, and the mean temperature of the surfaces.",
            ),
            formulas=fretting_formulas,
        ),
    },
)
