"""Normal contact without adhesion: loads, problems, and their formulas."""

from __future__ import annotations

import math
from typing import Any

from winkler.media.offers import PowerOfDepth, PressedWaves, offers
from winkler.study.chapters.answer import Caption, Chapter, Equation, PicturedContact, answer, followed_by
from winkler.study.chapters.kind import kind
from winkler.values.checks.contract import is_a

STRONG = {"first": {"kind": "elastic", "young": "210 GPa", "poisson": 0.3, "strength": "700 MPa"}}
OVAL = [{"kind": "paraboloid", "curvature_radius": radius} for radius in ("10 mm", "12 mm", "10 mm", "12 mm")]

MODULUS = Equation(
    "Effective modulus of the two bodies",
    r"\frac{1}{E^*} = \frac{1-\nu_1^2}{E_1} + \frac{1-\nu_2^2}{E_2}",
)
TRANSVERSE = Equation(
    "Effective modulus of a transversely isotropic body (Elliott)",
    r"E^*_{TI} = \frac{2\sqrt{C_{44}}\,(C_{11}C_{33}-C_{13}^2)}"
    r"{\sqrt{C_{11}}\,\sqrt{(\sqrt{C_{11}C_{33}}-C_{13})(C_{13}+2C_{44}+\sqrt{C_{11}C_{33}})}}",
)
PLANE = Equation(
    "Equivalent plane profile of the shape f(r)",
    r"g(x) = x\int_0^x \frac{f'(r)}{\sqrt{x^2-r^2}}\,\mathrm{d}r",
)
BACK = Equation(
    "The plane profile g(x) was given; the corresponding body is",
    r"f(r) = \frac{2}{\pi}\int_0^r \frac{g(x)}{\sqrt{r^2-x^2}}\,\mathrm{d}x",
)
SPRINGS = Equation(
    "Springs of the stiffness E* per length are compressed by d − g(x); that of the outermost spring is zero",
    r"q_z(x) = E^*\,\left(d-g(x)\right), \quad |x| < a, \quad g(a) = d",
)
PINNED = Equation(
    "Springs of the stiffness E* per length are compressed by d − g(x), up to the rim that limits the contact",
    r"q_z(x) = E^*\,\left(d-g(x)\right), \quad |x| < a, \quad g(a) \le d",
)
FORCE = Equation(
    "The sum of the spring forces is the normal force; stiffness and energy follow",
    r"F_N = 2E^*\int_0^a \left(d-g(x)\right)\,\mathrm{d}x, \quad k = 2E^*a, \quad "
    r"U = E^*\int_0^a \left(d-g(x)\right)^2\,\mathrm{d}x",
)
PRESSURE = Equation(
    "Pressure of the three-dimensional contact, from the load of the springs",
    r"p(r) = \frac{E^*}{\pi}\left[\int_r^a \frac{g'(x)}{\sqrt{x^2-r^2}}\,\mathrm{d}x + "
    r"\frac{d-g(a)}{\sqrt{a^2-r^2}}\right]",
)
SURFACE = Equation(
    "and displacement of the surface inside and outside the contact",
    r"u_z(r) = \frac{2}{\pi}\int_0^{\min(r,a)} \frac{d-g(x)}{\sqrt{r^2-x^2}}\,\mathrm{d}x",
)
MISES = Equation(
    "Subsurface stresses are sums over flat punches of all radii; the von Mises stress is",
    r"\sigma_{vM} = \sqrt{\frac{1}{2}\left[(\sigma_r-\sigma_\theta)^2+(\sigma_\theta-\sigma_z)^2+"
    r"(\sigma_z-\sigma_r)^2\right]+3\tau_{rz}^2}",
)
ONSET = Equation("Condition for the onset of yield", r"\max\sigma_{vM} = \sigma_Y")
TOP = MODULUS._replace(says="The uppermost solid and the other body alone would act with the effective modulus")
COMPLIANCE = Equation(
    "Surface displacement C per amplitude of a pressure wave; the deeper layers affect long waves",
    r"C(\xi) = \frac{2}{E^*\xi}\left(1+M(\xi)\right)",
)
PUNCHES = Equation(
    "This compliance gives the flat punch of radius a",
    r"\phi(x) + \int_0^a K(x,t)\,\phi(t)\,\mathrm{d}t = 1, \quad "
    r"K(x,t) = \frac{2}{\pi}\int_0^\infty M\,\cos(\xi x)\,\cos(\xi t)\,\mathrm{d}\xi",
)
LAYERED_SPRINGS = Equation(
    "and the springs, whose stiffness varies with x",
    r"c_N(x) = E^*\,\phi(x;x)^2, \quad k(a) = 2E^*\int_0^a \phi\,\mathrm{d}x",
)
LAYERED_PROFILE = Equation(
    "The shape f(r) becomes the equivalent plane profile g; h is that of a homogeneous half-space, and ϱ solves the "
    "same equation with K(x, a) on the right",
    r"g(a)\,\phi(a;a) = h(a) - \int_0^a \rho(x;a)\,h(x)\,\mathrm{d}x, \quad "
    r"h(x) = x\int_0^x \frac{f'(r)}{\sqrt{x^2-r^2}}\,\mathrm{d}r",
)
GRADED_SPRINGS = Equation(
    "The modulus is a power of the depth, and the stiffness of the springs a power of x",
    r"E(z) = E_0\left(\frac{z}{c_0}\right)^k, \quad c_N(x) = E^*\left(\frac{x}{c_0}\right)^k, \quad "
    r"\frac{1}{E^*} = \frac{1-\nu_1^2}{h_1E_{0,1}} + \frac{1-\nu_2^2}{h_2E_{0,2}}",
)
GRADED_PROFILE = Equation(
    "The shape f(r) becomes the equivalent plane profile (here k is the exponent)",
    r"g(x) = x^{1-k}\int_0^x \frac{f'(r)}{(x^2-r^2)^{(1-k)/2}}\,\mathrm{d}r",
)
GRADED_PRESSURE = Equation(
    "The pressure of the three-dimensional contact is the sum over flat punches of all radii",
    r"p(r) = \frac{E^*}{\pi c_0^k}\left[\int_r^a \frac{g'(x)}{(x^2-r^2)^{(1-k)/2}}\,\mathrm{d}x + "
    r"\frac{d-g(a)}{(a^2-r^2)^{(1-k)/2}}\right]",
)
MEASURED = Equation(
    "Stiffness and depth were measured at many contact radii; the springs follow from both",
    r"k(a) = \frac{\mathrm{d}F}{\mathrm{d}d}, \quad c_N(x) = \frac{k'(x)}{2}, \quad g(a) = d",
)
VARIED = Equation(
    "Every spring is compressed by d − g(x); the compression of the outermost spring is zero",
    r"q_z(x) = c_N(x)\,\left(d-g(x)\right), \quad |x| < a, \quad g(a) = d",
)
VARIED_PINNED = Equation(
    "Every spring is compressed by d − g(x), up to the rim that limits the contact",
    r"q_z(x) = c_N(x)\,\left(d-g(x)\right), \quad |x| < a, \quad g(a) \le d",
)
VARIED_FORCE = Equation(
    "The sum of the spring forces is the normal force; stiffness and energy follow",
    r"F_N = 2\int_0^a c_N\left(d-g\right)\,\mathrm{d}x, \quad k = 2\int_0^a c_N\,\mathrm{d}x, \quad "
    r"U = \int_0^a c_N\left(d-g\right)^2\,\mathrm{d}x",
)
SUPERPOSED = Equation(
    "Flat punches of all radii x, with the pressure p₁ at unit depth, add up to that of the three-dimensional contact; "
    "it does not follow from the load of the springs alone",
    r"p(r) = \int_r^a p_1(r;x)\,g'(x)\,\mathrm{d}x + p_1(r;a)\left(d-g(a)\right)",
)
STRESSES = MISES._replace(says="Stresses in every layer are sums over waves; the von Mises stress is")
ELLIPSE = Equation(
    "The contact is an ellipse, the pressure a half-ellipsoid (Hertz)",
    r"p = \frac{3F_N}{2\pi ab}\sqrt{1-\frac{x^2}{a^2}-\frac{y^2}{b^2}}",
)
BALL = Equation("Force and depth are those of a ball with the radius", r"R_{eq} = \frac{9F_N^2}{16E^{*2}d^3}")
POTENTIALS = Equation(
    "The stresses follow from its potential and the integrals of the potential along z (once: H, twice: K)",
    r"\Phi = \frac{\pi abp_0}{2}\int_\lambda^\infty \frac{1-\frac{x^2}{a^2+s}-\frac{y^2}{b^2+s}-\frac{z^2}{s}}"
    r"{\sqrt{(a^2+s)(b^2+s)s}}\,\mathrm{d}s, \quad "
    r"2\pi\sigma_x = 2\nu\Phi_z - (1-2\nu)H_{xx} - z\Phi_{xx}",
)
TRACTION = Equation(
    "A sliding contact adds the stresses of the traction μ p, here along x (Sackfield and Hills)",
    r"2\pi\sigma_x = \mu\,[2(1+\nu)\Phi_x + 2\nu K_{xxx} - zH_{xxx}]",
)
BETTI = Equation(
    "Every direction has its own profile g; the force is the mean over all directions",
    r"F_N = 2E^*\frac{\langle aI\rangle}{\langle a\rangle}, \quad I = \int_0^a(d-g)\,\mathrm{d}x",
)
GREATEST = Equation(
    "The contact contour is that with the maximum force (Barber)", r"I + a\,(d-g(a)) = \frac{F_N}{2E^*}"
)

HOMOGENEOUS = "winkler.media.halfspace:HomogeneousMedium"
HALF_SPACE = "winkler.media.halfspace:HalfSpace"
TRANSVERSE_HALF_SPACE = "winkler.media.transverse:TransverselyIsotropicHalfSpace"
MEASURED_BED = "winkler.foundation.measured:MeasuredBed"
PLANE_FOUNDATION = "winkler.foundation.plane:PlaneFoundation"


def bed_formulas(
    bed: Any, springs: tuple[Equation, ...] = (), restored: tuple[Equation, ...] = (PRESSURE, SURFACE)
) -> tuple[Equation, ...]:
    """Return the formulas from bodies and shape to springs and fields; none for beds of other packages.

    Parameters
    ----------
    bed
        Of a problem.
    springs
        Formulas of the springs, where they are not compressed by d - g(x) up to an edge that just touches.
    restored
        Formulas of the fields on the surface of a homogeneous medium.
    """
    medium, pinned = getattr(bed, "medium", None), math.isfinite(bed.rim)
    if is_a(medium, HOMOGENEOUS):
        found = (
            MODULUS,
            *((TRANSVERSE,) if is_a(medium, TRANSVERSE_HALF_SPACE) else ()),
            BACK if is_a(bed, PLANE_FOUNDATION) else PLANE,
        )
        if springs:
            return (*found, *springs, *restored)
        stress = (MISES,) if is_a(medium, HALF_SPACE) else ()
        return (*found, PINNED if pinned else SPRINGS, FORCE, *restored, *stress)
    varied = springs or (VARIED_PINNED if pinned else VARIED, VARIED_FORCE)
    if is_a(bed, MEASURED_BED):
        return (MEASURED, *varied)
    if offers(medium, PowerOfDepth):
        return (GRADED_SPRINGS, GRADED_PROFILE, *varied, GRADED_PRESSURE)
    if offers(medium, PressedWaves):
        found = (TOP, COMPLIANCE, PUNCHES, LAYERED_SPRINGS, LAYERED_PROFILE)
        return (*found, *varied, SUPERPOSED, STRESSES)
    return ()


def normal_formulas(problem: Any) -> tuple[Equation, ...]:
    """Return the formulas of a normal contact without adhesion; none for a problem without a bed of this package."""
    bed = getattr(problem, "bed", None)
    return () if bed is None else bed_formulas(bed)


def plane_profile_formula(problem: Any) -> Equation:
    """Return the formula of shape and plane profile."""
    return BACK if is_a(problem.bed, PLANE_FOUNDATION) else PLANE


NORMAL = Chapter(
    "normal contact",
    kinds={
        "load": {
            "force": kind("winkler.loading.loads:Force", force="100 N"),
            "depth": kind("winkler.loading.loads:Depth", depth="5 um"),
            "radius": kind("winkler.loading.loads:Radius", radius="0.1 mm"),
        },
    },
    answers={
        "indentation": answer(
            "winkler.problems.normal.indentation:Indentation",
            "popov_hess_2015",
            "galin_1946",
            "sneddon_1965",
            "jaeger_1995",
            question="How deep does a body sink in, how wide is the contact, and how stiff is it?",
            page="method.md",
            key="hertz ball tip depth contact",
            en="loading curve exponent 1.5 hertzian stress contact patch of a ball on a flat plate rubber foot sinks under weight sink in under load floor flattening of a ball hertz hertzian contact pressure sneddon boussinesq galin ball on flat sphere on plane point contact penetration approach contact radius area stiffness compliance normal load press squeeze how deep does my tip go how hard is it pressed contact size footprint dent elastic bearing ball deflection hertz contact stress sphere on flat two spheres touching spheres actual size of a touching point weight flattens circle of contact compression of spheres stylus force on a surface dimple effective radius elastic foundation doubling the load force goes with depth to the three halves contact spring spring constant of a contact dent depth under weight finger pressing probe needle on skin jewel kinematic mount bead pressed colloid pressed gauge block measurement force stylus deformation correction flat-ended indenter pressure under a rigid flat cylinder hertz contact of two curved bodies jack screw pad on concrete contact circle diameter contact radius of a ball",
            de="abplattung einer kugel auf einer platte einfedern einsinken gewicht hertzsche pressung kontakt flächenpressung eindringtiefe kugel auf ebene kontaktradius kontaktfläche steifigkeit wie tief dringt die spitze ein druck anpressen eindrücken punktkontakt abplattung annäherung zwei kugeln abplattung eindrückung federsteifigkeit des kontakts kugel zwischen platten messkraft taster abflachung gewölbte körper messkraftabplattung kontaktradius kugel",
            fr="contact de hertz pression bille sur plan enfoncement profondeur d'indentation rayon de contact raideur aire jusqu'où pénètre la pointe écrasement appui ponctuel raideur d'un contact bille plan deux billes empreinte élastique palpeur",
            headline=("depth", "force", "radius", "peak_pressure"),
            beyond="plastic_indentation",
            says={
                "depth": "the body sinks in by {depth}, on a contact of {radius} radius",
                "force": "{force} press the body in, on a contact of {radius} radius",
            },
            formulas=normal_formulas,
        ),
        "yield_onset": answer(
            "winkler.problems.normal.yielding:YieldOnset",
            "johnson_1985",
            "popov_hess_2015",
            question="At which load does a body, or a layer of it, begin to yield, pressed or sliding?",
            page="chapters/coatings.md#when-a-coating-yields",
            key="strength yield",
            en="will it yield plastic yielding strength von mises tresca first plastic deformation limit load safety margin permanent dent coating failure of layers overload static capacity max load shear stress below surface ball on coated disc when does it deform for good brinelling proof yield point indent left in a plate mark remains dented permanent set static strength of a ball contact brinell mark load at which a ball leaves an indentation yield at the interface of a coating hard layer protects substrate onset of yielding allowable contact pressure safety against yield plastic limit stiletto heel mark overloaded damage scratch load of paint indentation from debris over-rolled particles handling damage",
            de="schicht fliesst zapfen fliesst nicht härte der schicht fliessen fliessgrenze plastische verformung beginnt wann fliesst es streckgrenze vergleichsspannung festigkeit bleibende verformung tragfähigkeit statische grenzlast sicherheit eindruck bleibt eindruck hinterlässt bleibender eindruck zulässige pressung zulässige last kugel hinterlässt eindruck sicherheit gegen fliessen",
            fr="plastification limite d'élasticité début de plasticité va-t-il plastifier déformation permanente résistance seuil de plasticité charge limite empreinte capacité statique marque une empreinte reste charge admissible pression admissible empreinte permanente couche dure",
            event="at which a body begins to yield",
            headline=("force", "depth", "radius", "z"),
            says={"force": "a body begins to yield at {force}, {z:below}"},
            bed={"kind": "foundation", "medium": {"kind": "half_space", **STRONG}},
            formulas=followed_by(normal_formulas, ONSET),
        ),
        "elliptic_indentation": answer(
            "winkler.problems.normal.elliptic:EllipticIndentation",
            question="How large is the contact of two bodies with two curvatures each, such as a ball in a race, and how high is the pressure?",
            page="chapters/ellipses.md",
            key="bearing hertz lager roulement",
            en="contact ellipse of a ball bearing race hertz ellipse crossed cylinders ball in groove raceway bearing osculation conformity wheel on rail toroid barrel two radii of curvature general hertz contact ball bearing race semi-axes footprint elliptical thread guide cam angular contact ball bearing contact angle ball groove v groove kinematic coupling vee deep groove thrust ball bearing four-point bearing gothic arch linear guide ball screw spherical roller barrel wheel crown ellipticity ratio principal radii skew cylinders conformity of raceway curvature sum curvature difference contact in a bearing ring joint of two tori crowned gear worm truncation of the ellipse at a shoulder race shoulder ball and ring rotary table ball screw preload stiffness of ball bearing",
            de="elliptischer kontakt kugellager laufbahn rille schmiegung gekreuzte zylinder rad schiene hertz ellipse halbachsen wälzlager laufring tonnenrolle druckellipse kugelgewindetrieb linearführung schrägkugellager vierpunktlager tonnenlager hauptkrümmung krümmungssumme kugel in rille berührellipse wälzkontakt kreuzzylinder kugelumlaufspindel gewölbte körper",
            fr="contact elliptique roulement à billes chemin de roulement gorge cylindres croisés ellipse de hertz roue rail demi-axes bague vis à billes guidage linéaire roulement à rotule rayons principaux bille dans une gorge contact oblique bille dans une gorge",
            headline=("peak_pressure", "depth", "force", "longitudinal_semi_axis", "lateral_semi_axis"),
            says={
                "peak_pressure": "the peak pressure is {peak_pressure}, on a contact of semi-axes {longitudinal_semi_axis} and {lateral_semi_axis}"
            },
            picture=Caption(
                "ellipse",
                "The contact",
                "Pressure on the ellipse and stress below both axes; for many loads force and semi-axes.",
            ),
            curves=(("depth", "force"), ("depth", "longitudinal_semi_axis"), ("depth", "lateral_semi_axis")),
            pictured=PicturedContact.NONE,
            live=True,
            formulas=(ELLIPSE, BALL, POTENTIALS),
        ),
        "elliptic_yield_onset": answer(
            "winkler.problems.normal.elliptic_yielding:EllipticYieldOnset",
            "johnson_1985",
            question="At which force does a ball in a race or a wheel on a rail begin to yield, also while it slides?",
            page="chapters/ellipses.md#onset-of-yield",
            en="ball bearing static load rating raceway yield brinelling of bearing race strength of ball in groove crossed cylinders plastic wheel rail yield iso 76 true brinelling static safety factor of a bearing dropped bearing shock load mark on the ring static capacity guideway wheel crushes rail crane wheel groove overload of a rolling bearing indentation from handling debris dents raceway",
            de="statische tragzahl kugellager laufbahn fliessen eindrückung rad schiene plastisch kranrad laufrad tragsicherheit linearführung eindrücke stillstand überlast wälzlager",
            fr="charge statique roulement plastification du chemin de roulement roue rail marques sur la bague capacité statique guidage galet marque le rail",
            event="at which a body begins to yield",
            headline=("force", "peak_pressure", "depth", "z"),
            says={"force": "a body begins to yield at {force}, {z:below}"},
            medium={"kind": "half_space", **STRONG},
            friction={"kind": "coulomb", "coefficient": 0.1},
            picture=Caption(
                "ellipse_yield",
                "Onset of yield",
                "The von Mises stress below both axes at the onset; on layers pressure and position of onset.",
            ),
            pictured=PicturedContact.NONE,
            live=True,
            formulas=(ELLIPSE, POTENTIALS, TRACTION, ONSET),
        ),
        "nearly_round_indentation": answer(
            "winkler.problems.normal.near_round:NearlyRoundIndentation",
            question="Which force does a nearly round punch, such as a pyramid or an oval, need, approximately?",
            page="chapters/rough.md",
            en="not quite round slightly oval imperfect shape square pyramid punch polygon triangular berkovich non-axisymmetric almost circular square cross section punch stiffness square pad non-circular punch rectangular foot",
            de="nicht ganz rund fast rund unrund pyramide stempel vieleck quadratischer stempel",
            fr="presque rond ovale pas tout à fait rond poinçon carré pyramide polygone section carrée",
            headline=("force", "depth", "stiffness"),
            profiles=OVAL,
            load={"kind": "depth", "depth": "1 um"},
            picture=Caption("contour", "The contact", "Computed in the directions of the points."),
            curves=(("depth", "force"),),
            pictured=PicturedContact.NONE,
            live=True,
            formulas=(BETTI, GREATEST),
        ),
    },
)
