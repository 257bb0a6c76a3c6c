"""Line contacts: their loads, beds, problems, and formulas."""

from __future__ import annotations

from typing import Any

from winkler.study.chapters.answer import TENSE, Caption, Chapter, Equation, PicturedContact, answer
from winkler.study.chapters.kind import kind
from winkler.study.chapters.normal import MODULUS, ONSET, STRONG
from winkler.values.checks.contract import is_a

ROLLER = {"kind": "line_foundation", "profile": {"kind": "paraboloid"}}
WAVES = {
    "kind": "line_foundation",
    "profile": {"kind": "wavy", "amplitude": "1 um", "wavelength": "1 mm"},
}
STICKY_ROLLER = {
    **ROLLER,
    "medium": {"kind": "half_space", "first": {"kind": "elastic", "young": "2 MPa", "poisson": 0.5}},
}

LOAD_PROFILE = Equation(
    "The two-dimensional profile f(x) gives the load profile w",
    r"w(a) = \int_0^a \frac{x\,f'(x)}{\sqrt{a^2-x^2}}\,\mathrm{d}x",
)
LOAD = Equation("which is the force per length divided by E*", r"P = E^*\,w(a)")
PRESSURE = Equation(
    "Flat punches of all half-widths c add up to the pressure",
    r"p(x) = \frac{E^*}{\pi}\int_{|x|}^a \frac{w'(c)}{\sqrt{c^2-x^2}}\,\mathrm{d}c",
)
LAYERED_RESPONSE = Equation(
    "Compliance of the layers for a pressure wave; M vanishes for waves much shorter than the thickness of the "
    "uppermost layer",
    r"C(k) = \frac{2}{E^*k}\,(1+M(k))",
)
LAYERED_MODES = Equation(
    "The layers add modes with the loads β to the pressure of a half-plane, whose transform is E* G",
    r"p_n = \frac{E^*\beta_nT_{2n}(x/a)}{\pi\sqrt{a^2-x^2}}, \quad "
    r"\beta_m + 4m\sum_n(-1)^{m+n}\beta_n\int_0^\infty\frac{M}{k}J_{2m}J_{2n}\,\mathrm{d}k = "
    r"-4m(-1)^m\int_0^\infty\frac{M}{k}J_{2m}(ka)\,G\,\mathrm{d}k",
)
LAYERED_LOAD = Equation(
    "where β₀ makes the pressure vanish at the edge; the force per length is", r"P = E^*\,(w(a)+\beta_0)"
)
POTENTIAL = Equation(
    "At ζ = x + iz below the surface their potential is",
    r"F(\zeta) = \frac{E^*}{\pi}\int_0^a \frac{w'(c)}{\sqrt{\zeta^2-c^2}}\,\mathrm{d}c",
)
STRESSES = Equation(
    "which gives the stresses due to the pressure, and in full sliding to the traction μ p",
    r"\sigma_x = \mathrm{Im}\,F + z\,\mathrm{Re}\,F' - \mu\,(2\,\mathrm{Re}\,F - z\,\mathrm{Im}\,F'), \quad "
    r"\sigma_z = \mathrm{Im}\,F - z\,\mathrm{Re}\,F' - \mu z\,\mathrm{Im}\,F', \quad "
    r"\tau_{xz} = -z\,\mathrm{Im}\,F' + \mu\,(\mathrm{Im}\,F + z\,\mathrm{Re}\,F')",
)
UP_AND_DOWN = (100, 500, 1000, 2000, 3000, 4000, 3000, 2000, 1000, 300, 0)
"""Forces per length [kN/m]."""
ROLLER_YIELDS = Equation(
    "Each body fills the fraction s of the gap at which the mean pressure of both is equal; p_el is the pressure "
    "without yielding",
    r"p = p_{el}\,e^{-L(p_{el}/Y)}, \quad p_{el} = \frac{\pi E_i s_i a}{8R}, \quad P = 2ap, \quad "
    r"d_0 = \frac{a^2}{2R}\left(s_1D_1+s_2D_2\right)",
)
ROLLER_RETURNS = Equation(
    "Load of a dent of the half-width a on narrower strips of the half-width c",
    r"\frac{P(c)}{P} = \theta\frac{c^2}{a^2} + (1-\theta)\left(1-\sqrt{1-\frac{c^2}{a^2}}\right)",
)
ROLLER_GAP = Equation(
    "Pressures and gaps of a roller with the drop z(x) of its ends and the tilt θ are never negative, and one of the "
    "two is zero on every element",
    r"w = z(x)+\frac{y^2}{2R}-\theta x-d+\frac{1}{\pi E^*}\int\frac{p\,\mathrm{d}A}{\sqrt{(x-x_i)^2+(y-y_i)^2}}, "
    r"\quad p \ge 0, \; w \ge 0, \; p\,w = 0",
)
ROLLER_SUMS = Equation("Force and moment are sums", r"F_N = \int p\,\mathrm{d}A, \quad M = \int p\,x\,\mathrm{d}A")
ROLLER_CROWN = Equation(
    "A logarithmic crown beyond a straight part of the half-length s drops by (after Lundberg, with the parameters of "
    "Fujiwara and Kawase)",
    r"z = K_1A\ln\frac{1}{1-\left(1-e^{-z_m/(K_1A)}\right)\left(\frac{|x|-s}{L/2-s}\right)^2}, \quad "
    r"A = \frac{P}{\pi E^*}",
)
SINE = Equation(
    "Strips at the pitch λ correspond to one strip over u, under the profile f(x(u))",
    r"u = \frac{\lambda}{\pi}\sin\frac{\pi x}{\lambda}, \quad \bar p = \frac{P}{\lambda}",
)
PERIODIC_WAVES = Equation(
    "The layers feel the waves k = 2πm/λ alone; what they add to the pressure over u, the transforms of which are G, "
    "are modes of the loads β, with the transforms B of T₂ₙ(u/a)/√(a²-u²) over π",
    r"\beta_j + 4j\sum_n\beta_n\sum_m\frac{2\pi M}{\lambda k_m}B_jB_n = "
    r"-4j\sum_m\frac{2\pi M}{\lambda k_m}B_j(m)\,G(m)",
)
PERIODIC_PRESSURE = Equation(
    "with u(a) in the place of a; its pressure p₁(u) is that of each strip but for a cosine, up to full contact",
    r"p(x) = p_1(u)\,\cos\frac{\pi x}{\lambda}",
)
STICKING = Equation(
    "The tension at the edges is that of a flat punch; its energy release rate equals the work of adhesion γ",
    r"P = E^*\,w(a) - \sqrt{2\pi a E^*\gamma}, \quad K_I = \sqrt{2E^*\gamma}",
)
STRETCHED = Equation(
    "and it reduces the pressure of the profile", r"p(x) = p_w(x) - \sqrt{\frac{2E^*\gamma a}{\pi(a^2-x^2)}}"
)
LAYERED_STICKING = Equation(
    "The edges pull like those of a flat punch on the layers, s times as steep as on half-planes of the uppermost one, "
    "until the stress intensity releases the work of adhesion γ",
    r"P = E^*\,(w(a)+\beta_0) - \frac{\sqrt{2\pi a E^*\gamma}}{s(a)}, \quad K_I = \sqrt{2E^*\gamma}",
)
LAYERED_RANGED = Equation(
    "Outside the contact, up to c, the adhesive stress acts; G is then the transform of pressure and adhesive stress",
    r"P = E^*\,(w(a)+\beta_0) - 2\sigma_0\sqrt{c^2-a^2}",
)
RANGED = Equation("Outside the contact, up to c, the adhesive stress acts", r"P = E^*\,w(a) - 2\sigma_0\sqrt{c^2-a^2}")
RANGE_END = Equation("which ends where the gap equals the range of the attraction", r"h(c) = \frac{\gamma}{\sigma_0}")
GRADED_LOAD = Equation(
    "Load per length of the profile on bodies graded by the power k",
    r"P(a) = \frac{E^*}{c_0^k}\frac{\Gamma(\frac{1+k}{2})}{\sqrt{\pi}\,\Gamma(1+\frac{k}{2})}"
    r"\int_0^a \frac{x\,f'(x)\,\mathrm{d}x}{(a^2-x^2)^{(1-k)/2}}",
)
GRADED_PRESSURE = Equation(
    "and the pressure of the flat punches of all half-widths c",
    r"p(x) = \int_{|x|}^a \frac{P'(c)\,\mathrm{d}c}{c^k\,\mathrm{B}(\frac{1}{2},\frac{1+k}{2})\,(c^2-x^2)^{(1-k)/2}}",
)
STABLE = Equation("A state is stable under a dead load where", r"\frac{\mathrm{d}P}{\mathrm{d}a} > 0")
PLANE_STRAIN = Equation("and in the direction of the strip, in plane strain", r"\sigma_y = \nu\,(\sigma_x+\sigma_z)")
SHAKEDOWN = Equation(
    "The best residual stresses, along and across the direction of rolling, leave at most the strength (Melan)",
    r"\max_z\,\min_{\rho_x,\rho_y}\,\max_x\,\sigma_{\mathrm{vM}}(\sigma + \rho) = \sigma_Y",
)


def line_formulas(problem: Any) -> tuple[Equation, ...]:
    """Return the formulas of a line contact on the bodies of a problem."""
    if is_a(problem.bed, "winkler.foundation.layered_line:LayeredLineFoundation"):
        return (MODULUS, LOAD_PROFILE, LAYERED_RESPONSE, LAYERED_MODES, LAYERED_LOAD)
    if is_a(problem.bed, "winkler.foundation.power_law_line:PowerLawLineFoundation"):
        return (GRADED_LOAD, GRADED_PRESSURE)
    return (MODULUS, LOAD_PROFILE, LOAD, PRESSURE)


def line_yield_formulas(problem: Any) -> tuple[Equation, ...]:
    """Return the formulas of a line contact that begins to yield on the bodies of a problem."""
    if is_a(problem.bed, "winkler.foundation.layered_line:LayeredLineFoundation"):
        return (*line_formulas(problem), PLANE_STRAIN, ONSET)
    return (MODULUS, LOAD_PROFILE, LOAD, POTENTIAL, STRESSES, PLANE_STRAIN, ONSET)


def line_shakedown_formulas(problem: Any) -> tuple[Equation, ...]:
    """Return the formulas of a strip that rolls over the bodies of a problem again and again."""
    return (*line_yield_formulas(problem)[:-1], SHAKEDOWN)


def periodic_formulas(problem: Any) -> tuple[Equation, ...]:
    """Return the formulas of strips at a pitch on the bodies of a problem."""
    if is_a(problem.bed, "winkler.foundation.layered_line:LayeredLineFoundation"):
        return (MODULUS, SINE, LOAD_PROFILE, LAYERED_RESPONSE, PERIODIC_WAVES, LAYERED_LOAD, PERIODIC_PRESSURE)
    return (MODULUS, SINE, LOAD_PROFILE, LOAD, PERIODIC_PRESSURE)


def line_adhesion_formulas(problem: Any) -> tuple[Equation, ...]:
    """Return the formulas of a strip that sticks under the law of a problem."""
    if is_a(problem.bed, "winkler.foundation.layered_line:LayeredLineFoundation"):
        ranged = is_a(problem.law, "winkler.laws.adhesion:Dugdale")
        law = (LAYERED_RANGED, RANGE_END) if ranged else (LAYERED_STICKING,)
        return (MODULUS, LOAD_PROFILE, LAYERED_RESPONSE, LAYERED_MODES, *law, STABLE)
    law = (RANGED, RANGE_END) if is_a(problem.law, "winkler.laws.adhesion:Dugdale") else (STICKING, STRETCHED)
    return (MODULUS, LOAD_PROFILE, *law, PRESSURE, STABLE)


LINE = Chapter(
    "line contact",
    kinds={
        "line_load": {
            "line_force": kind(
                "winkler.loading.loads:LineForce", problem="line_indentation", force_per_length="100 N/mm"
            ),
            "half_width": kind("winkler.loading.loads:HalfWidth", problem="line_indentation", half_width="0.1 mm"),
            "mean_pressure": kind(
                "winkler.loading.loads:MeanPressure", problem="line_indentation", mean_pressure="500 MPa"
            ),
            "nominal_pressure": kind(
                "winkler.loading.loads:NominalPressure", problem="periodic_indentation", nominal_pressure="100 MPa"
            ),
        },
        "roller_ends": {
            "sharp_ends": kind("winkler.profiles.roller_ends:SharpEnds", problem="roller_contact"),
            "crowned_ends": kind(
                "winkler.profiles.roller_ends:CrownedEnds", problem="roller_contact", crown_radius="0.5 m"
            ),
            "rounded_ends": kind(
                "winkler.profiles.roller_ends:RoundedEnds", problem="roller_contact", edge_radius="1 mm"
            ),
            "logarithmic_ends": kind(
                "winkler.profiles.roller_ends:LogarithmicEnds",
                "lundberg_1939",
                "fujiwara_kawase_2007",
                en="lundberg profile logarithmic roller profile",
                problem="roller_contact",
                design_force_per_length="1 kN/mm",
            ),
        },
        "alignment": {
            "tilt": kind("winkler.loading.loads:Tilt", problem="roller_contact", tilt="0.5 mrad"),
            "moment": kind("winkler.loading.loads:Moment", problem="roller_contact", moment="2 N m"),
        },
        "line_bed": {
            "line_foundation": kind(
                "winkler.foundation.line:LineFoundation",
                "johnson_1985",
                problem="line_indentation",
                profile={"kind": "paraboloid"},
                medium={"kind": "half_space"},
            ),
            "layered_line_foundation": kind(
                "winkler.foundation.layered_line:LayeredLineFoundation",
                "meijers_1968",
                "johnson_1985",
                problem="line_indentation",
                profile={"kind": "paraboloid"},
                medium={"kind": "coated_half_space"},
            ),
            "power_law_line_foundation": kind(
                "winkler.foundation.power_law_line:PowerLawLineFoundation",
                "giannakopoulos_suresh_1997",
                problem="line_indentation",
                profile={"kind": "paraboloid"},
                medium={"kind": "graded_half_space"},
            ),
        },
    },
    answers={
        "line_indentation": answer(
            "winkler.problems.line.indentation:LineIndentation",
            "johnson_1985",
            "jaeger_1995",
            question="How wide is the contact of a roller, a wedge or another long body, on layers too, and how high is the pressure?",
            page="chapters/line.md",
            key="gear roller cylinder hertz",
            en="plastic gear on a metal gear cylinder on flat roller shaft in plain bearing hertz line contact gear tooth flank pair gears teeth cam follower roller bearing knife edge two-dimensional plane strain half-width roll nip cylinders pressed flattening of two cylinders parallel cylinders shaft on shaft follower tappet valve lifter cam pressure gear contact stress pitch point pressure roller on plane bridge bearing hinge pin joint pin in a hole lug clearance rack and pinion needle bearing worm sprocket roller chain pressing knife edge loading wheel tread flat cylinder wheel calender cross roller bearing preload roller stiffness geneva drive pin rotary table mast roller hertz line wedge pressure beneath a wedge piston pin boss how wide is the strip of contact",
            de="flächenpressung zylinder linienkontakt linienberührung walze rolle zylinder auf ebene zahnrad zahnflanke zahnräder rollenlager nadellager wälzpressung nocken stempel welle abplattung zweier zylinder kurvenrolle stössel nockenfolger brückenlager auflagerolle wälzpressung stribecksche wälzkontakt rolle auf schiene kettenrolle bolzen in bohrung kegelrollenlager keil",
            fr="deux cylindres parallèles surface de contact contact linéique cylindre sur plan galet rouleau denture engrenage dent came roulement à rouleaux roulement à aiguilles arbre écrasement de deux cylindres pression superficielle galet came poussoir axe dans un alésage denture rouleau sur plan coin axe de piston",
            headline=("peak_pressure", "half_width", "force_per_length", "mean_pressure"),
            beyond="line_plastic_indentation",
            says={"peak_pressure": "the peak pressure is {peak_pressure}, on a contact of {half_width} half-width"},
            bed=ROLLER,
            picture=Caption(
                "line",
                "The contact",
                "Pressure and deformed shape; for many loads half-width, pressures and (on a rigid base) depth.",
            ),
            curves=(("force_per_length", "half_width"), ("force_per_length", "peak_pressure")),
            pictured=PicturedContact.NONE,
            live=True,
            formulas=line_formulas,
        ),
        "roller_contact": answer(
            "winkler.problems.rollers.roller_contact:RollerContact",
            question="How high is the pressure under a roller of finite length that is crowned, sharp at its ends or tilted?",
            page="chapters/rollers.md",
            key="roller bearing",
            en="pressure between roller and raceway roller bearing edge stress crowning crowned roller finite length misalignment tilt logarithmic profile lundberg edge loading end relief needle cylindrical roller tapered roller end drop dub-off edge stress concentration roller deflection skewed roller load distribution along a roller palmgren uniform pressure along the length barrelled roller bearing overload cross roller roller with rounded corners",
            de="flächenpressung zylinder rollenlager kantenpressung balligkeit ballige rolle kantentragen schiefstellung verkippung logarithmisches profil nadel zylinderrolle endliche länge kegelrollenlager kegelrolle nadelkranz kantenspannung pressungsverteilung entlang der rolle",
            fr="roulement à rouleaux surpression de bord bombé rouleau bombé désalignement profil logarithmique longueur finie rouleau conique répartition de pression le long du rouleau bombé surcharge en bout",
            headline=("peak_pressure", "edge_factor", "depth", "force", "tilt"),
            radius="10 mm",
            length="10 mm",
            ends={"kind": "logarithmic_ends"},
            load={"kind": "force", "force": {"from": "2 kN", "to": "12 kN", "count": 6}},
            alignment={"kind": "tilt"},
            elements=48,
            picture=Caption(
                "roller",
                "Pressure along the roller",
                "Pressure on the contact and along the roller, and force per length; for many loads also depth and "
                "pressures.",
            ),
            curves=(("force", "depth"), ("force", "peak_pressure"), ("force", "edge_factor"), ("force", "moment")),
            pictured=PicturedContact.NONE,
            formulas=(MODULUS, ROLLER_GAP, ROLLER_SUMS, ROLLER_CROWN),
        ),
        "line_adhesion": answer(
            "winkler.problems.line.adhesion:LineAdhesion",
            "barquins_1988",
            "chaudhury_1996",
            "baney_hui_1997",
            unstressed=TENSE,
            question="How strongly does a roller, a fibre or another long body stick?",
            page="chapters/line-adhesion.md",
            en="sticky cylinder fibre fiber nanowire nanotube roller adhesion jkr cylinder peel line gecko adhering strip crossed nanotubes fibres carbon nanotube on a substrate cylinder jkr rod sticks",
            de="klebender zylinder faser haftung linienkontakt adhäsion walze klebt nanoröhre stäbchen",
            fr="adhésion cylindre fibre collant contact linéique adhésif",
            headline=("pull_off_force_per_length", "half_width", "force_per_length"),
            says={"pull_off_force_per_length": "the body pulls off at {pull_off_force_per_length:size}"},
            bed=STICKY_ROLLER,
            load={"kind": "line_force", "force_per_length": "1 N/m"},
            picture=Caption("line_adhesion", "The contact", "Pressure and shape; for many loads the half-width."),
            curves=(("force_per_length", "half_width"),),
            pictured=PicturedContact.NONE,
            formulas=line_adhesion_formulas,
        ),
        "periodic_indentation": answer(
            "winkler.problems.line_strips.periodic:PeriodicIndentation",
            "westergaard_1939",
            "johnson_1985",
            question="How much of a wavy, turned or milled surface touches under a mean pressure?",
            page="chapters/line-waves.md",
            en="ridge pattern regular pattern pillars wavy surface westergaard ripples ridges grooves grating texture knurl sinusoidal periodic many strips full contact closure pressure flattening waviness stamp corrugated rail washboard stamp with lines close the gap completely machined lay turning marks",
            de="welligkeit wellige oberfläche riefen rillen gitter periodisch sinus textur stempel drehriefen",
            fr="surface ondulée ondulation stries rainures réseau sinusoïdal périodique texture tampon stries d'usinage",
            headline=("contact_share", "peak_pressure", "half_width", "closure_pressure"),
            says={"contact_share": "the surfaces touch on {contact_share:%} of the area"},
            bed=WAVES,
            pitch="1 mm",
            load={"kind": "nominal_pressure", "nominal_pressure": "100 MPa"},
            picture=Caption("waves", "The contact", "Pressure and shape; for many loads width and pressures."),
            curves=(("nominal_pressure", "contact_share"), ("nominal_pressure", "peak_pressure")),
            pictured=PicturedContact.NONE,
            formulas=periodic_formulas,
        ),
        "line_yield_onset": answer(
            "winkler.problems.line.yielding:LineYieldOnset",
            "johnson_1985",
            question="At which force per length does a body below a roller begin to yield, also while it slides?",
            page="chapters/line.md#onset-of-yield",
            en="roller yields shaft yield gear flank strength plastic cylinder plastic line contact von mises rail head cam yields roller follower survives tread yields crane wheel groove in the rail roller marks rail allowable roller load allowable line load contact stress limit of cam",
            de="walze fliesst zahnflanke festigkeit zylinder plastisch rolle fliessgrenze laufrolle zulässige pressung nocken kranrad zulässige linienlast",
            fr="galet plastifie limite élastique cylindre rouleau plastique flanc de dent charge limite galet galet marque le rail pression admissible galet",
            event="at which a body begins to yield",
            says={"force_per_length": "a body begins to yield at {force_per_length}, {z:below}"},
            headline=("force_per_length", "half_width", "z", "mean_pressure"),
            bed={**ROLLER, "medium": {"kind": "half_space", **STRONG}},
            friction={"kind": "coulomb", "coefficient": 0.1},
            picture=Caption("line_yield", "Onset of yield", "The von Mises stress at the onset of yield."),
            pictured=PicturedContact.NONE,
            formulas=line_yield_formulas,
        ),
        "line_plastic_indentation": answer(
            "winkler.problems.plastic.line_indentation:LinePlasticIndentation",
            "johnson_1985",
            question="Which dent does a roller leave in a metal, and under which force per length?",
            page="chapters/metals.md#lines",
            en="cylinder pressed beyond yield permanent groove under a roller",
            de="eindruck einer walze bleibende rille rolle überlastet plastischer linienkontakt zylinder elastisch-plastisch",
            fr="empreinte d'un rouleau contact linéique plastique rainure permanente cylindre élastoplastique",
            headline=("residual_depth", "largest_half_width", "dissipation"),
            says={"residual_depth": "a dent {residual_depth} deep is left"},
            bed={**ROLLER, "medium": {"kind": "half_space", **STRONG}},
            path={"kind": "line_force", "force_per_length": [f"{force} kN/m" for force in UP_AND_DOWN]},
            picture=Caption(
                "line_dent",
                "The strip along its path, and the dent",
                "Half-width and mean pressure over the force per length during loading and unloading (dotted: onset "
                "of yield), and the surface after the path.",
            ),
            curves=(("force_per_length", "half_width"),),
            pictured=PicturedContact.NONE,  # an elastic contact bears pressures that a metal does not
            formulas=(ROLLER_YIELDS, ROLLER_RETURNS),
        ),
        "line_shakedown": answer(
            "winkler.problems.line.shakedown:LineShakedown",
            "johnson_1985",
            question="Up to which load does a body stay elastic after a roller has passed many times?",
            page="chapters/line.md#shakedown",
            en="shakedown rolling contact fatigue ratcheting ratchetting rail life repeated rolling overrolling cyclic plasticity melan safe load spalling pitting limit shakedown map rcf elastic in the end rail squat head checks rolling contact fatigue limit residual stresses after shakedown repeated passes is the load above shakedown ratchet limit plastic flow of rail accumulates crack on rail surface from rolling case hardened roller endurance limit pressure cyclic rolling spalls pitting",
            de="einspielen shakedown ratcheting wälzfestigkeit wälzermüdung wiederholtes überrollen dauerfest schiene grübchen überrollung rollkontaktermüdung schiene squat schädigung überrollungen dauerhafte pressung wälzermüdung grübchenbildung",
            fr="adaptation plastique shakedown rochet fatigue de roulement chargement répété passages répétés rail écaillage fatigue de contact de roulement squat rail limite d'adaptation écaillage",
            event="up to which the body shakes down",
            says={"force_per_length": "the body shakes down up to {force_per_length}; yielding begins {z:below}"},
            headline=("force_per_length", "half_width", "z", "mean_pressure"),
            bed={**ROLLER, "medium": {"kind": "half_space", **STRONG}},
            friction={"kind": "coulomb", "coefficient": 0.1},
            picture=Caption("line_shakedown", "Shakedown limit", "Shear stress parallel to the surface."),
            pictured=PicturedContact.NONE,
            formulas=line_shakedown_formulas,
        ),
    },
)
