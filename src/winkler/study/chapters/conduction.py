"""Conduction of current and heat: conductors, films, drives, problems, and their formulas."""

from __future__ import annotations

from typing import Any

from winkler.study.chapters.answer import Caption, Chapter, Equation, PicturedContact, answer, followed_by
from winkler.study.chapters.kind import kind
from winkler.study.chapters.lines.line import LOAD, LOAD_PROFILE, ROLLER
from winkler.study.chapters.normal import HOMOGENEOUS, normal_formulas
from winkler.values.checks.contract import is_a

SILVER = {"kind": "electrical_conductor", "resistivity": "15.9 nohm m"}
STEEL = {"kind": "thermal_conductor", "conductivity": "45 W/(m K)", "diffusivity": "12 mm^2/s"}
COPPER = {"kind": "electrical_conductor", "resistivity": "16.8 nohm m"}
SILVER_PAIR: dict[str, Any] = {"first": SILVER, "second": SILVER}
STEEL_PAIR: dict[str, Any] = {"first": STEEL, "second": STEEL}
PRESSED = {"kind": "indentation", "load": {"kind": "force", "force": "1 N"}}
MEASURED_FORCE = ["0.1 N", "0.2 N", "0.5 N", "1 N", "2 N", "5 N", "10 N", "20 N", "50 N", "100 N"]
MEASURED_RESISTANCE = [
    *("589.06 uohm", "474.08 uohm", "364.60 uohm", "298.16 uohm", "248.02 uohm"),
    *("196.39 uohm", "165.37 uohm", "141.44 uohm", "117.95 uohm", "103.59 uohm"),
]

ANALOGY = Equation(
    "All springs in contact have the same conductance, so the conductance is proportional to the stiffness (Barber)",
    r"\frac{1}{R_c} = \frac{2}{E^*(\rho_1+\rho_2)}\,\frac{\mathrm{d}F_N}{\mathrm{d}d} = \frac{4a}{\rho_1+\rho_2}",
)
DISC = Equation(
    "Constriction resistance of the circular contact (Holm), for any elastic medium",
    r"R_c = \frac{\rho_1+\rho_2}{4a}",
)
IN_SERIES = Equation("Resistances of the leads are in series", r"R(F_N) = R_c + R_f + R_0")
HEAT = Equation(
    "Heat flows like a current, with temperature for voltage and λ for 1/ρ",
    r"Q = \frac{\Delta T}{R}, \quad R_c = \frac{1}{4a}\left(\frac{1}{\lambda_1}+\frac{1}{\lambda_2}\right)",
)
FILM = Equation(
    "A film is in series and makes the current more uniform: H rises from 1 to 32/(3π²) with its resistance",
    r"R = R_c\,H(\beta) + \frac{\sigma_f}{\pi a^2}, \quad \beta = \frac{2\sigma_f}{(\rho_1+\rho_2)\,a}",
)
ROD = Equation(
    "In a rod of the radius b the constriction resistance is smaller, and the resistance of its length is added",
    r"R_1 = \frac{\rho_1}{4a}\,\psi\left(\frac{a}{b}\right) + \frac{\rho_1 l}{\pi b^2}, \quad "
    r"\psi = 1 - 1.40925\,\frac{a}{b} + \dots",
)
PLATING = Equation(
    "A plating of the thickness h changes the response to each Fourier component of the current, like an elastic layer",
    r"1+M(\xi) = \frac{1+\kappa e^{-2\xi h}}{1-\kappa e^{-2\xi h}}, \quad "
    r"\kappa = \frac{\rho_{on}-\rho}{\rho_{on}+\rho}",
)
KOHLRAUSCH = Equation(
    "Along every current line temperature and voltage are related, if λρ = LT (Kohlrausch)",
    r"T_{max}^2 = T_0^2 + \frac{V^2}{4L} \quad (V_f = 0, \; V_1 = V_2)",
)
UNEQUAL_VOLTAGES = Equation(
    "With a film, or with different voltages across the bodies, the temperature of the contact spot is",
    r"T_c^2 = T_0^2 + \frac{2V_1V_2}{L}\left(\frac{1}{2}+\frac{V_f}{V_1+V_2}\right)",
)
HOT_RESISTANCE = Equation(
    "and the resistance along the current line increases to",
    r"I\,\frac{R_1}{\rho_1(T_0)} = \int_0^{V_1}\frac{\mathrm{d}\phi}{\rho_1(T(\phi))}",
)
SPOT_INTERACTION = Equation(
    "All spots have the same voltage, to which the current of every spot contributes",
    r"V = \frac{\rho_1+\rho_2}{2\pi}\sum_j\int_{A_j}\frac{J(s)}{|r-s|}\,\mathrm{d}A",
)
GREENWOOD = Equation(
    "Greenwood's estimate assumes currents proportional to the radii",
    r"R_G = \frac{\rho_1+\rho_2}{4\sum a_i} + "
    r"\frac{\rho_1+\rho_2}{2\pi}\,\frac{\sum_{i\ne j}a_ia_j/s_{ij}}{(\sum a_i)^2}",
)
TANGENTS = Equation(
    "The force curve lies between that of the smooth body and the same moved by s; it is convex, so that its slope is "
    "bound by tangents (after Barber)",
    r"\max_{D<d_0}\frac{F-F_s(D)}{d_0+s-D} \le k \le \min_{D>d_0+s}\frac{F_s(D)-F}{D-d_0-s}",
)
PROPORTION = Equation("Conductance is proportional to stiffness", r"\frac{1}{R} = \frac{2k}{E^*(\rho_1+\rho_2)}")
STRIP = Equation(
    "Resistance between reference points at the depths d₁ and d₂, with the film resistance σ",
    r"R' = \frac{\rho_1}{\pi}\,\ln\left(\frac{d_1}{a}+\sqrt{1+\frac{d_1^2}{a^2}}\right) + "
    r"\frac{\rho_2}{\pi}\,\ln\left(\frac{d_2}{a}+\sqrt{1+\frac{d_2^2}{a^2}}\right) + \frac{\sigma}{2a}",
)


def electric_formulas(problem: Any, *more: Equation) -> tuple[Equation, ...]:
    """Return the formulas of a contact that conducts a current."""
    parts = _constriction_formulas(problem, problem.conductors.film)
    return followed_by(normal_formulas, *parts, *more)(problem.contact)


def thermal_formulas(problem: Any) -> tuple[Equation, ...]:
    """Return the formulas of a contact that conducts heat."""
    parts = _constriction_formulas(problem, problem.conductors.interface, HEAT)
    return followed_by(normal_formulas, *parts)(problem.contact)


def joule_formulas(problem: Any) -> tuple[Equation, ...]:
    """Return the formulas of a contact heated by a current."""
    return electric_formulas(problem, KOHLRAUSCH, UNEQUAL_VOLTAGES, HOT_RESISTANCE)


def _constriction_formulas(problem: Any, film: Any, *more: Equation) -> tuple[Equation, ...]:
    bodies, bed = (problem.conductors.first, problem.conductors.second), problem.contact.bed
    alike = not is_a(bed.footprint, "winkler.foundation.footprint:RoundOutline") or is_a(bed.medium, HOMOGENEOUS)
    return (
        ANALOGY if alike else DISC,
        *more,
        *((FILM,) if film.area_resistance > 0.0 else ()),
        *((ROD,) if any(is_a(body, "winkler.materials.conducting_body:Rod") for body in bodies) else ()),
        *((PLATING,) if any(is_a(body, "winkler.materials.conducting_body:Plated") for body in bodies) else ()),
    )


CONDUCTION = Chapter(
    "current and heat",
    kinds={
        "conductor": {
            "electrical_conductor": kind(
                "winkler.materials.conductor:ElectricalConductor",
                resistivity="15.9 nohm m",
                temperature_coefficient="3.8e-3 1/K",
            ),
            "thermal_conductor": kind(
                "winkler.materials.conductor:ThermalConductor",
                problem="thermal_constriction",
                conductivity="45 W/(m K)",
                diffusivity="12 mm^2/s",
            ),
            "named_electrical_conductor": kind("winkler.materials.named:NamedElectricalConductor", name="copper"),
            "named_thermal_conductor": kind(
                "winkler.materials.named:NamedThermalConductor", problem="thermal_constriction", name="copper"
            ),
            "plated": kind("winkler.materials.conducting_body:Plated", plating=SILVER, thickness="5 um", on=COPPER),
            "rod": kind("winkler.materials.conducting_body:Rod", conductor=SILVER, radius="1 mm", length="10 mm"),
        },
        "pair": {
            "electrical_conductors": kind("winkler.media.conduction.conductors:ElectricalConductors", **SILVER_PAIR),
            "heat_conductors": kind("winkler.media.conduction.conductors:HeatConductors", **STEEL_PAIR),
        },
        "film": {
            "surface_film": kind(
                "winkler.laws.film:SurfaceFilm",
                en="sulphide film tarnish oxide film insulating film on contacts",
                de="fremdschicht",
                fr="film d'oxyde",
                area_resistance="1e-12 ohm m^2",
            ),
            "thermal_interface": kind(
                "winkler.laws.film:ThermalInterface",
                en="kapitza boundary resistance thermal film thermal paste layer",
                interface_conductance="1e7 W/(m^2 K)",
            ),
        },
        "log": {
            "resistance_log": kind(
                "winkler.fitting.logs.contact_resistance:ResistanceLog",
                reader="winkler.io.logs.log_tables:read_resistance_log",
                problem="measured_constriction",
                force=MEASURED_FORCE,
                resistance=MEASURED_RESISTANCE,
            ),
        },
        "drive": {
            "voltage": kind("winkler.laws.current:Voltage", voltage="20 mV"),
            "current": kind("winkler.laws.current:Current", current="5 A"),
        },
        "law": {
            "wiedemann_franz": kind(
                "winkler.laws.current:WiedemannFranz",
                "kohlrausch_1900",
                en="wiedemann-franz lorenz number",
                lorenz_number="2.44e-8 V^2/K^2",
            ),
        },
    },
    answers={
        "constriction": answer(
            "winkler.problems.conduction.constriction:Constriction",
            question="What is the resistance of an electric contact that is clean, tarnished, plated or made of rods?",
            page="chapters/conduction.md",
            en="contact resistance electrical holm relay switch connector plug a-spot plating gold ohm constriction milliohm terminal pin electrical connection spreading resistance voltage drop sharvin sharvin resistance ballistic crimp connection sulphide film on silver slip ring brush carbon brush commutator clamping force of copper bars contact force and resistance four-wire voltage drop battery tab fritting tarnish oxide film earthing clamp pogo pin tunnel film resistance electrical contact of gold spring contact milliohms of closed contacts separable interface normal force mating bulk resistance screw clamp copper bar joint losses",
            de="kontaktwiderstand elektrisch holm relais stecker engewiderstand übergangswiderstand schalter steckverbinder vergoldung ohm fremdschichtwiderstand kohlebürste kommutator schleifring klemmkraft kupferschiene anlaufschicht durchgangswiderstand kontaktnormalkraft",
            fr="résistance de contact électrique holm relais connecteur interrupteur constriction dorure ohm fiche balai collecteur connexion électrique pince film d'oxyde",
            headline=("resistance", "conductance", "film_resistance", "radius"),
            contact=PRESSED,
            picture=Caption(
                "contact_resistance",
                "The contact resistance",
                "Over the force, and its parts: the constriction, a film, the length of rods.",
            ),
            formulas=electric_formulas,
        ),
        "measured_constriction": answer(
            "winkler.fitting.logs.contact_resistance:MeasuredConstriction",
            question="Which resistivity and which film explain a resistance measured over the force?",
            page="experiments/logs.md",
            en="measured contact resistance over force resistivity from measurement film resistance tarnish leads four wire log of resistance connector test",
            de="gemessener kontaktwiderstand über der kraft fremdschicht zuleitung spezifischer widerstand aus messung",
            fr="résistance de contact mesurée en fonction de la force film résistivité mesure",
            headline=("resistivity", "film", "series", "exponent"),
            log={"kind": "resistance_log", "force": MEASURED_FORCE, "resistance": MEASURED_RESISTANCE},
            picture=Caption(
                "measured_resistance",
                "The measured contact resistance",
                "Measured and fitted resistances over the force, and their differences.",
            ),
            pictured=PicturedContact.NONE,
            formulas=(DISC, FILM, IN_SERIES),
        ),
        "line_constriction": answer(
            "winkler.problems.conduction.line_constriction:LineConstriction",
            question="What is the resistance per length of a roller or an edge that carries a current?",
            page="chapters/conduction.md#lines",
            en="busbar edge bar contact resistance per length wire on plane rail shunt brush roller contact resistance line electrical copper bar joint losses",
            de="sammelschiene stromschiene engewiderstand linienkontakt draht übergangswiderstand je länge",
            fr="barre conductrice résistance linéique fil sur plan contact électrique linéaire",
            headline=("resistance_per_length", "film_resistance_per_length", "half_width"),
            contact={"kind": "line_indentation", "bed": ROLLER},
            first_depth="5 mm",
            second_depth="5 mm",
            picture=Caption(
                "contact_resistance",
                "The contact resistance",
                "Resistance times contact length over the force per length, with its parts.",
            ),
            curves=(("force_per_length", "resistance_per_length"),),
            pictured=PicturedContact.NONE,
            formulas=(LOAD_PROFILE, LOAD, STRIP),
        ),
        "thermal_constriction": answer(
            "winkler.problems.conduction.thermal_constriction:ThermalConstriction",
            question="How much heat flows between two parts that are pressed together?",
            page="chapters/conduction.md#heat",
            en="heat flows from a hot part to a cold one pressed against it in vacuum thermal contact resistance heat flow conductance heat transfer thermal interface heat sink cooling spot how much heat passes tcr steady heat kapitza resistance boundary resistance interface satellite structure support ball support cryogenic",
            de="wärmeübergang zwischen kontaktflächen wärmeübergang thermischer kontaktwiderstand wärmestrom wärmeleitung kühlkörper wärmedurchgang",
            fr="chaleur traverse résistance thermique de contact flux de chaleur transfert thermique refroidissement dissipateur conductance liaison thermique cryogénie",
            headline=("conductance", "resistance", "heat_rate"),
            conductors={"kind": "heat_conductors", **STEEL_PAIR},
            temperature_drop="10 K",
            picture=Caption(
                "heat",
                "Heat through the contact",
                "Temperature around the contact, heat flux over the surface, and the resistance over the force.",
            ),
            formulas=thermal_formulas,
        ),
        "joule_heating": answer(
            "winkler.problems.conduction.joule_heating:JouleHeating",
            question="How hot does a current make a contact, and when would it weld?",
            page="chapters/conduction.md",
            key="hot",
            en="plug contact heats up current heats hot current welding softening voltage contact temperature kohlrausch fuse overheating connector melting voltage ampacity resistance welding electric heating spot weld hot spot ampere amperage spring probe overheats ampacity of a pin current carrying capacity softening voltage melting voltage inrush current welds contact glows overload battery tab heats crimp overheats how many amps can it handle runs hot interface temperature of connector power connector",
            de="stromwärme joule schweissen kontakttemperatur erweichungsspannung überhitzung strom heiss stecker schmelzspannung punktschweissen stromtragfähigkeit kontakterwärmung überlast stecker heizt sich auf verschweisst schmelzspannung",
            fr="effet joule température de contact soudage courant surchauffe tension de ramollissement fusion ampère chaud échauffement d'une connexion électrique surcharge soudure des contacts courant d'appel",
            headline=("max_temperature", "rise", "voltage", "current", "resistance"),
            says={"max_temperature": "the greatest temperature is {max_temperature}, {rise} above that of the bodies"},
            contact=PRESSED,
            picture=Caption(
                "joule",
                "Heating of the contact by a current",
                "Temperature around the contact, current density over the surface, and temperature over voltage.",
            ),
            formulas=joule_formulas,
        ),
        "spot_cluster": answer(
            "winkler.problems.conduction.spots:SpotCluster",
            question="What is the resistance of many round spots side by side?",
            page="chapters/conduction.md#many-spots",
            en="several touching points side by side current through many points a-spots greenwood many spots interaction of spots multi-spot contact resistance holm radius cluster constriction many small spots conduct better than one large group of contacts",
            de="viele kontaktstellen holm radius a-spots wechselwirkung greenwood",
            fr="plusieurs points de contact interaction rayon de holm spots",
            headline=("resistance", "conductance", "holm_radius"),
            x=["0 um", "10 um", "5 um"],
            y=["0 um", "0 um", "8 um"],
            radii=["2 um", "3 um", "1 um"],
            first=SILVER,
            second=SILVER,
            picture=Caption(
                "spots",
                "The spots",
                "Currents of the spots compared with others of their size, and the total resistance.",
            ),
            formulas=(SPOT_INTERACTION, GREENWOOD),
        ),
        "conductance_bounds": answer(
            "winkler.problems.conduction.bounds:ConductanceBounds",
            question="Between which bounds do the stiffness and the conductance of rough bodies lie?",
            page="chapters/rough.md",
            en="bounds of conductance barber stiffness and conductance rough limits analogy upper lower bound",
            de="schranken leitwert steifigkeit rau barber grenzen",
            fr="bornes conductance raideur rugueux encadrement barber",
            headline=("least_conductance", "greatest_conductance", "smooth_conductance"),
            roughness="0.1 um",
            force="10 N",
            picture=Caption(
                "bounds",
                "Bounds from two smooth bodies",
                "The force curve of the rough body lies in the shaded band; its slope lies between those of the lines.",
            ),
            formulas=(TANGENTS, PROPORTION),
        ),
    },
)
