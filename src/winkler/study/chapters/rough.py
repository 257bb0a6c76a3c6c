"""Measured and rough surfaces: height maps, spectra, problems, and their formulas."""

from __future__ import annotations

from typing import Any

from winkler.study.chapters.answer import TENSE, Caption, Chapter, Equation, PicturedContact, answer
from winkler.study.chapters.kind import kind

BLASTED = {
    "kind": "self_affine",
    "hurst": 0.8,
    "rms_height": "0.3 um",
    "longest": "0.5 mm",
    "shortest": "160 um",
}
STAMP = {"kind": "random_topography", "spectrum": BLASTED, "shape": [64, 64], "periodic": False}
PYRAMID = [
    ["0 um", "0 um", "0 um", "0 um", "0 um", "0 um"],
    ["0 um", "2 um", "2 um", "2 um", "2 um", "0 um"],
    ["0 um", "2 um", "5 um", "4 um", "2 um", "0 um"],
    ["0 um", "2 um", "4 um", "4 um", "2 um", "0 um"],
    ["0 um", "2 um", "2 um", "2 um", "2 um", "0 um"],
    ["0 um", "0 um", "0 um", "0 um", "0 um", "0 um"],
]
SOFT_BALL = {
    "kind": "sampled_profile",
    "lengths": ["240 um", "240 um"],
    "shape": [48, 48],
    "profile": {"kind": "sphere", "curvature_radius": "1 mm"},
}
TO_AND_FRO = [{"from": "-3 um", "to": "0.5 um", "count": 8}, {"from": "0 um", "to": "-3 um", "count": 7}]
LOADS = {"kind": "force", "force": {"from": "10 N", "to": "200 N", "count": 5, "spacing": "log"}}

ELEMENTS = Equation(
    "Pressures and gaps are never negative, and one of the two is zero in every pixel",
    r"w = h(x,y)-d+\frac{1}{\pi E^*}\int\frac{p\,\mathrm{d}A}{\sqrt{(x-x_i)^2+(y-y_i)^2}}, "
    r"\quad p \ge 0, \; w \ge 0, \; p\,w = 0",
)
ATTRACTED = Equation(
    "The surface is in a local minimum of elastic and adhesive energy, reached from the previous minimum",
    r"E = \frac{1}{2}\int p\,u\,\mathrm{d}A + \int\phi(g)\,\mathrm{d}A, \quad g = h(x,y)-d+u \ge 0",
)
LOST = Equation(
    "Between jumps the work of the machine is stored; in a jump the decrease of the energy is dissipated",
    r"\mathrm{d}W = F_N\,\mathrm{d}d = \mathrm{d}E",
)
SPAN = Equation("The cohesive zone at the edge must be several pixels wide", r"\ell = \frac{E^* w}{\sigma^2}")
SAME_AREA = Equation(
    "The stiffness is that of a flat punch with the shape of the contact (Barber)",
    r"k = \frac{\mathrm{d}F_N}{\mathrm{d}d}",
)
PROPORTION = Equation(
    "The conductance is proportional to the stiffness, for any contact shape (Barber)",
    r"\frac{1}{R} = \frac{2k}{E^*(\rho_1+\rho_2)}",
)
BOUNDS = Equation(
    "The map lies between two flats at the distance s; k with the index ∞ is the stiffness of a flat",
    r"\frac{F_N}{F_N/k_\infty+s} \le k \le k_\infty",
)
DISC = Equation(
    "A disc with the stiffness of the contact has the radius a; the equivalent profile is g",
    r"a = \frac{k}{2E^*}, \quad g(a) = d",
)
SPREAD = Equation(
    "With platings or elastic layers the conductance is not proportional to the stiffness: all pixels in contact "
    "have the same voltage, with the response G to the flux J",
    r"V = \frac{\rho_1+\rho_2}{2}\,G\,J + \sigma_f\,J, \quad R = \frac{V}{\int J\,\mathrm{d}A}",
)
SPECTRUM = Equation("Spectrum of the one-dimensional profile, from that of the surface", r"C_1(q) = \pi\,q\,C(q)")
LINE = Equation(
    "The springs, sorted by their gaps, give the force at every depth",
    r"F_N = E^*\Delta x\sum_{\gamma_i<d}(d-\gamma_i), \quad k = E^*\Delta x\,n(d)",
)
PERSSON = Equation(
    "Contact fraction of the square, by Persson's theory",
    r"\frac{A}{A_0} = \mathrm{erf}\left(\frac{\sqrt{2}\,p}{E^* h'}\right)",
)
ON_BODY = Equation("The heights are added to the profile of the body", r"z(x) = h(x) - g(|x|)")
SHEARED_WAVES = Equation(
    "Every wave of the roughness deforms the elastomer at the frequency q v",
    r"\mu = h'\,\frac{\int q^3C\,\frac{G''(qv)}{|G(qv)|}\,\mathrm{d}q}{\int q^3C\,\mathrm{d}q}",
)


def conduction_formulas(problem: Any) -> tuple[Equation, ...]:
    """Return the formulas of a `SurfaceConduction`."""
    current = (SAME_AREA, PROPORTION, BOUNDS) if problem.in_proportion else (SAME_AREA, SPREAD)
    return (ELEMENTS, *current, SPECTRUM, LINE, PERSSON)


ROUGH = Chapter(
    "measured and rough surfaces",
    kinds={
        "topography": {
            "random_topography": kind(
                "winkler.profiles.rough.random_surface:RandomTopography",
                en="generate random rough surface synthetic roughness artificial surface",
                de="zufällige rauheit erzeugen",
                fr="surface aléatoire générer",
                problem="surface_contact",
                lengths=["1 mm", "1 mm"],
                spectrum=BLASTED,
                shape=[64, 64],
            ),
            "height_map": kind(
                "winkler.profiles.rough.topography:Topography",
                en="measured heights afm scan interferometer image topography file",
                de="gemessene höhen",
                fr="hauteurs mesurées rugosité mesurée topographie",
                reader="winkler.study.chapters.surfaces:read_surface",
                problem="surface_contact",
                heights=PYRAMID,
                lengths=["1 mm", "1 mm"],
            ),
            "sampled_profile": kind(
                "winkler.profiles.rough.sampled_profile:SampledProfile",
                problem="surface_contact",
                lengths=["1 mm", "1 mm"],
                shape=[65, 65],
            ),
        },
        "law": {
            "exponential_attraction": kind(
                "winkler.laws.attraction:ExponentialAttraction",
                "rey_2017",
                problem="surface_adhesion",
                work="50 mJ/m^2",
                range="0.65 um",
            ),
            "lennard_jones": kind(
                "winkler.laws.attraction:LennardJones",
                "greenwood_1997",
                en="lennard-jones potential surface potential attraction",
                fr="potentiel",
                problem="surface_adhesion",
                work="50 mJ/m^2",
                spacing="0.8 um",
            ),
        },
        "spectrum": {
            "self_affine": kind(
                "winkler.profiles.rough.spectrum:SelfAffine",
                en="self-affine fractal surface hurst exponent spectrum of roughness roll-off cut-off",
                de="selbstaffin fraktal",
                fr="auto-affine fractale",
                problem="rough_contact",
                hurst=0.8,
                rms_height="0.3 um",
                longest="0.5 mm",
                shortest="160 um",
            ),
            "power_spectrum": kind(
                "winkler.profiles.rough.spectrum:PowerSpectrum",
                en="power spectral density psd of a surface as input",
                de="leistungsdichtespektrum",
                fr="densité spectrale",
                reader="winkler.io.tables.spectrum_table:read_spectrum",
                problem="rough_contact",
                wave_numbers=["1e4 1/m", "1e5 1/m", "1e6 1/m"],
                densities=["1e-21 m^4", "4e-25 m^4", "1e-28 m^4"],
            ),
        },
        "bed": {
            "reduced_bed": kind(
                "winkler.problems.rough.reduced_bed:ReducedBed", topography={**STAMP, "seed": 1}, depth="1 um"
            ),
        },
    },
    answers={
        "surface_contact": answer(
            "winkler.problems.rough.surface_contact:SurfaceContact",
            question="Where does a measured or rough surface touch, how hard, and how stiff is the contact?",
            page="chapters/rough.md",
            key="roughness rough",
            en="rough surface contact boundary element height map asperities real contact area topography bem polonsky keer measured surface pressed scan profilometer gap interfacial separation boundary element method real surface scan pressed nominal pressure sandblasted bead blasted gap distribution gap height close the rough gap contact area under pressure sandpaper fingertip",
            de="raue oberfläche kontakt höhenkarte topographie randelemente rauheit reale kontaktfläche asperiten messung sandgestrahlt spaltverteilung",
            fr="surface rugueuse contact carte de hauteurs topographie éléments de frontière rugosité aire réelle aspérités sablé distribution des jeux",
            headline=("area", "depth", "force", "mean_gap"),
            says={"area": "the surfaces touch on {contact_share:%} of the area, {area}"},
            load=LOADS,
            picture=Caption(
                "contact",
                "Where the surfaces touch",
                "Contact, pressure and gap under the last load, by boundary elements; for many loads also force, "
                "stiffness and contact area.",
            ),
            curves=(("depth", "force"), ("force", "stiffness"), ("force", "area"), ("force", "mean_gap")),
            pictured=PicturedContact.NONE,
            formulas=(ELEMENTS, SAME_AREA),
        ),
        "surface_adhesion": answer(
            "winkler.problems.surface_adhesion.adhesion:SurfaceAdhesion",
            unstressed=TENSE,
            question="Where does a measured or rough surface snap in, which force pulls it off, and what does a loop lose?",
            page="chapters/surfaces/surface-adhesion.md",
            en="rough adhesion sticky rough surface roughness kills adhesion attraction of a map lennard-jones rough wafer bonding does roughness stop sticking fuller tabor roughness reduces adhesion gauge blocks wring wringing lennard-jones dahlquist criterion",
            de="haftung rauer oberflächen adhäsion rauheit waferbonden endmasse ansprengen",
            fr="adhésion surface rugueuse rugosité collage de plaquettes cales étalons adhérence",
            headline=("pull_off_force", "dissipation", "force", "area", "attracted_area", "loss_per_cycle"),
            says={"pull_off_force": "the surfaces pull off at {pull_off_force:size}"},
            topography=SOFT_BALL,
            medium={"kind": "half_space", "first": {"kind": "elastic", "young": "1 MPa", "poisson": 0.5}},
            law={"kind": "exponential_attraction"},
            path={"kind": "depth", "depth": TO_AND_FRO},
            picture=Caption(
                "stuck",
                "Approach and retraction of the attracted surface",
                "Tension, pressure and gap at the largest tensile force; force, areas, work and energy along the path.",
            ),
            curves=(("depth", "force"), ("depth", "area"), ("depth", "energy")),
            pictured=PicturedContact.NONE,
            formulas=(ATTRACTED, LOST, SPAN),
        ),
        "surface_conduction": answer(
            "winkler.problems.rough.surface_conduction:SurfaceConduction",
            question="How much current does a measured or rough surface conduct?",
            page="chapters/rough.md",
            en="electrical contact of rough surface current through asperities map current density rough contact resistance",
            de="elektrischer kontakt raue oberfläche strom durch rauheit",
            fr="contact électrique rugueux courant à travers les aspérités",
            headline=("resistance", "conductance", "least_resistance", "greatest_resistance"),
            contact={"kind": "surface_contact", "topography": {**STAMP, "seed": 1}},
            picture=Caption(
                "conductance",
                "Stiffness, conductance and contact area over the load",
                "Boundary elements, and one-dimensional foundations with the same power spectrum. The grey band lies "
                "between Barber's bounds, which hold for every surface of this height. With platings or elastic "
                "layers the only bound of the conductance is that of full contact.",
            ),
            curves=(("force", "stiffness"), ("force", "conductance"), ("force", "resistance")),
            pictured=PicturedContact.NONE,
            formulas=conduction_formulas,
        ),
        "reduction": answer(
            "winkler.problems.rough.reduce:Reduction",
            question="Which springs replace a measured or rough surface, and how large is their error?",
            page="chapters/rough.md#springs-in-place-of-a-surface",
            en="equivalent springs of a rough surface reduce map to line equivalent profile of a height map fast model",
            de="ersatzfedern reduktion höhenkarte ersatzprofil",
            fr="ressorts équivalents réduction de carte profil équivalent",
            headline=("stiffness", "depth", "force", "misfit"),
            topography={**STAMP, "seed": 1},
            depth="1 um",
            picture=Caption(
                "reduction",
                "Springs in place of the surface",
                "Points: boundary elements. Lines: the springs, with the same forces.",
            ),
            curves=(("depth", "force"), ("depth", "stiffness")),
            pictured=PicturedContact.NONE,
            formulas=(ELEMENTS, SAME_AREA, DISC),
        ),
        "rough_contact": answer(
            "winkler.problems.rough.line_contact:RoughContact",
            question="How stiff is a rough square of which only the power spectrum is known, within about 25 %?",
            page="chapters/rough.md",
            en="power spectral density topography rough contact stiffness lines of springs self-affine fractal roughness stiffness of a rough square hurst power law stiffness persson compliance of rough bodies",
            de="rauer kontakt steifigkeit fraktal selbstaffin hurst rauheit",
            fr="contact rugueux raideur fractal auto-affine hurst rugosité",
            headline=("area", "mean_gap", "stiffness"),
            says={"area": "the surfaces touch on {contact_share:%} of the area, {area}"},
            side="1 mm",
            load=LOADS,
            realisations=20,
            count=1024,
            picture=Caption(
                "lines",
                "Rough lines of springs",
                "Spectrum, depth and stiffness (band: 80 % of the random profiles); area by Persson's theory.",
            ),
            curves=(("depth", "force"), ("force", "stiffness"), ("force", "area"), ("force", "mean_gap")),
            pictured=PicturedContact.NONE,
            formulas=(SPECTRUM, LINE, PERSSON),
        ),
        "rough_indentation": answer(
            "winkler.problems.rough.line_indentation:RoughIndentation",
            question="How deep does a rough ball or another rough body of revolution sink in?",
            page="chapters/rough.md",
            en="rough ball roughness on a sphere greenwood tripp rough indenter pressed rough tip rough bead surface roughness of spheres effective hertz radius",
            de="raue kugel rauheit auf kugel rauer eindringkörper",
            fr="bille rugueuse rugosité sur sphère",
            headline=("depth", "force", "area"),
            length="4 mm",
            load=LOADS,
            realisations=20,
            count=2048,
            spectrum=BLASTED,
            picture=Caption(
                "lines",
                "Rough lines of springs under the body",
                "Spectrum, depth and stiffness (band: 80 % of the random profiles); area by Persson's theory.",
            ),
            curves=(("depth", "force"), ("force", "stiffness"), ("force", "area")),
            pictured=PicturedContact.NONE,
            formulas=(SPECTRUM, ON_BODY, LINE, PERSSON),
        ),
        "elastomer_friction": answer(
            "winkler.problems.rough.elastomer_friction:ElastomerFriction",
            question="How does the friction of rubber on a rough surface change with speed and temperature, as a trend?",
            page="chapters/rough.md#rough-rubber-a-trend",
            en="rubber friction tyre grip tire road asphalt sole shoe floor hysteresis friction persson rubber grip on rough road mu of rubber slip resistance wiper wet grip dry grip sole slip grosch tyre on smooth road texture macrotexture pavement skid shoe sole windscreen wiper blade squeal rubber lip on glass",
            de="gummireibung reifen strasse griffigkeit schuhsohle asphalt reibwert elastomer haftung reifen nassgriff profil fahrbahn textur rutschhemmung finger auf glas fingerabdruck wischerblatt",
            fr="frottement du caoutchouc pneu route adhérence semelle chaussure élastomère adhérence sur route mouillée texture",
            headline=("coefficient", "velocity"),
            velocity={"from": "1 um/s", "to": "1 m/s", "count": 25, "spacing": "log"},
            picture=Caption(
                "friction",
                "Friction of the rough surface on the elastomer",
                "Trend of friction with velocity (not a prediction), and the spectrum of contributing waves.",
            ),
            curves=(("velocity", "coefficient"),),
            pictured=PicturedContact.NONE,
            formulas=(SHEARED_WAVES,),
        ),
    },
)
