"""Sections that touch in many strips: their shapes, the problem, and formulas."""

from __future__ import annotations

from winkler.study.chapters.answer import Caption, Chapter, Equation, PicturedContact, answer
from winkler.study.chapters.kind import kind
from winkler.study.chapters.normal import MODULUS

STRIP_GAP = Equation(
    "Pressures and gaps of a section f(x), tilted by θ, are never negative, and one of the two is zero everywhere",
    r"h(x) = f(x)-\theta x-C-\frac{2}{\pi E^*}\int p(s)\,\ln|x-s|\,\mathrm{d}s, \quad p \ge 0, \; h \ge 0, \; p\,h = 0",
)
STRIP_SUMS = Equation(
    "Force per length and line of action are integrals of the pressure",
    r"P = \int p\,\mathrm{d}x, \quad P\,x_P = \int p\,x\,\mathrm{d}x",
)
STRIP_SERIES = Equation(
    "The pressure of each strip of a smooth section is a series over t from -1 to 1",
    r"p = \frac{E^*}{2}\sqrt{1-t^2}\,\sum_k c_k U_k(t)",
)
STRIP_POTENTIAL = Equation(
    "whose potential gives the gaps outside the strip and the stresses below",
    r"F(z) = \frac{E^*}{2}\sum_k c_k\left(z-\sqrt{z^2-1}\right)^{k+1}",
)

LINE_PROFILES = Chapter(
    "line contact",
    kinds={
        "section": {
            "cylinder_row": kind(
                "winkler.profiles.sections.section:CylinderRow",
                curvature_radii={"values": [10, 10], "unit": "mm"},
                places={"values": [-0.25, 0.25], "unit": "mm"},
                drops={"values": [0, 2], "unit": "um"},
            ),
            "punch_row": kind(
                "winkler.profiles.sections.section:PunchRow",
                starts={"values": [-1, 0.4], "unit": "mm"},
                ends={"values": [-0.4, 1], "unit": "mm"},
                drops={"values": [0, 0], "unit": "um"},
            ),
            "mirrored_section": kind(
                "winkler.profiles.sections.mirrored_section:MirroredSection",
                profile={"kind": "wavy", "amplitude": "1 um", "wavelength": "1 mm"},
                width="4.5 mm",
            ),
            "formula_section": kind(
                "winkler.profiles.sections.measured_section:FormulaSection",
                expression="(x-m)**2/(2*R) + h*cos(2*pi*x/l)",
                width="4 mm",
                constants={"m": "1.9 mm", "R": "100 mm", "h": "0.5 um", "l": "0.4 mm"},
            ),
            "measured_section": kind(
                "winkler.profiles.sections.measured_section:MeasuredSection",
                reader="winkler.io.tables.profile_table:read_section",
                places={"from": "-0.6 mm", "to": "0.6 mm", "count": 25},
                heights={
                    "values": [
                        36,
                        31,
                        25,
                        20,
                        18,
                        13,
                        9,
                        9,
                        4,
                        2,
                        3,
                        0,
                        1,
                        1,
                        0,
                        4,
                        3,
                        7,
                        10,
                        11,
                        17,
                        20,
                        24,
                        31,
                        35,
                    ],
                    "unit": "um",
                },
            ),
        },
        "alignment": {
            "line_of_action": kind(
                "winkler.loading.loads:LineOfAction", problem="line_profile_contact", place="0.02 mm"
            ),
        },
    },
    answers={
        "line_profile_contact": answer(
            "winkler.problems.line_strips.profile_contact:LineProfileContact",
            "polonsky_keer_1999",
            "johnson_1985",
            question="Where does a measured, tilted or many-crested section touch, in how many strips, and how hard?",
            page="chapters/line-strips.md",
            en="measured section cross-section several strips sealing lip profilometer trace gasket ridge groove seal lip multiple contacts cylinder row pin rows lip seal wiper blade pressure seal edge pressure pin in hole of measured form several contact strips tilted punch",
            de="gemessener schnitt profilschnitt dichtlippe mehrere streifen querschnitt dichtkante rauheitsprofil linie dichtkante kontaktdruck dichtlippe",
            fr="section mesurée lèvre de joint plusieurs bandes profil mesuré coupe profilomètre lèvre pression de contact",
            headline=("peak_pressure", "contact_length", "strip_count", "mean_pressure", "tilt"),
            section={"kind": "cylinder_row"},
            load={"kind": "line_force", "force_per_length": "200 N/mm"},
            picture=Caption(
                "strips",
                "The strips of contact",
                "Pressure, gap and force of each strip; for many loads contact length, pressures and number of strips.",
            ),
            curves=(("force_per_length", "contact_length"), ("force_per_length", "peak_pressure")),
            pictured=PicturedContact.NONE,
            formulas=(MODULUS, STRIP_GAP, STRIP_SUMS, STRIP_SERIES, STRIP_POTENTIAL),
        ),
    },
)
