"""Stresses below maps of pressure and traction: the maps, the problem, and its formulas."""

from __future__ import annotations

from winkler.study.chapters.answer import Caption, Chapter, Equation, PicturedContact, answer
from winkler.study.chapters.kind import kind

HILL = [
    ["0 MPa", "100 MPa", "150 MPa", "100 MPa", "0 MPa"],
    ["100 MPa", "250 MPa", "300 MPa", "250 MPa", "100 MPa"],
    ["150 MPa", "300 MPa", "350 MPa", "300 MPa", "150 MPa"],
    ["100 MPa", "250 MPa", "300 MPa", "250 MPa", "100 MPa"],
    ["0 MPa", "100 MPa", "150 MPa", "100 MPa", "0 MPa"],
]

PIXELS = Equation(
    "Stresses are sums over all pixels; for a uniform pressure on a rectangle with corners at the distances X and Y, "
    "at the depth z,",
    r"\sigma_{zz} = -\frac{p}{2\pi}\left[\arctan\frac{XY}{z\rho}+\frac{XYz}{\rho}"
    r"\left(\frac{1}{X^2+z^2}+\frac{1}{Y^2+z^2}\right)\right], \quad \rho^2 = X^2+Y^2+z^2",
)
MISES = Equation(
    "Yielding begins where the stress of von Mises reaches the strength",
    r"\sigma_{vM}^2 = \frac{1}{2}\left[(\sigma_{xx}-\sigma_{yy})^2+(\sigma_{yy}-\sigma_{zz})^2"
    r"+(\sigma_{zz}-\sigma_{xx})^2\right]+3\left(\sigma_{xy}^2+\sigma_{xz}^2+\sigma_{yz}^2\right)",
)

MAX_SHEAR = Equation(
    "The greatest shear stress is half the difference of the outermost principal stresses",
    r"\tau_{max} = \frac{\sigma_1-\sigma_3}{2}",
)
ORTHOGONAL = Equation(
    "That in planes along the surface, as Hertz's ellipse rolls along its semi-axis b, is after Lundberg and Palmgren",
    r"\tau_0 = p_0\frac{\sqrt{2t-1}}{2t(t+1)}, \quad z_0 = \frac{b}{(t+1)\sqrt{2t-1}}, \quad "
    r"\frac{b}{a} = \sqrt{(t^2-1)(2t-1)}",
)

SUBSURFACE = Chapter(
    "fields",
    kinds={
        "surface_load": {
            "surface_load": kind(
                "winkler.problems.pressed_shape.surface_load:SurfaceLoad",
                reader="winkler.io.tables.surface_load_table:read_surface_load",
                problem="map_stress",
                pressure=HILL,
                lengths=["1 mm", "1 mm"],
            ),
        },
    },
    answers={
        "contact_stress": answer(
            "winkler.problems.subsurface.contact_stress:ContactStress",
            question="How high are the greatest stresses inside a contact, and how deep do they lie?",
            page="chapters/ellipses.md#stresses-inside",
            key="stress",
            en="stresses under gear teeth hertzian stress case depth hardening depth needed how deep must the case be subsurface stress von mises max shear stress below contact where is the highest stress tresca maximum depth stress field principal stress orthogonal shear fatigue initiation how deep is the greatest stress maximum shear stress for sphere on flat plate and its depth case depth gear shaft induction hardened nitriding depth needed stress along the axis depth of the greatest orthogonal shear stress hertz stress field sub-surface spalling from below hertz pitting depth shear at the interface of a coating delaminates stress in a thermal spray layer",
            de="wie hart muss die schicht sein einhärtetiefe spannung unter der oberfläche vergleichsspannung schubspannung maximum tiefe von mises grösste beanspruchung hauptspannung einsatzhärteschicht zahnrad nitrierhärtetiefe grösste schubspannung tiefe randschichthärten druckstelle im laminat",
            fr="contrainte sous la surface cisaillement maximal von mises profondeur contrainte maximale champ de contraintes contraintes en sous-couche profondeur du cisaillement maximal profondeur de cémentation",
            headline=("max_shear", "max_shear_depth", "orthogonal_shear", "orthogonal_shear_depth", "von_mises"),
            says={"max_shear": "the greatest shear stress is {max_shear}, {max_shear_depth:below}"},
            contact={"kind": "indentation"},
            picture=Caption(
                "depths",
                "Stresses below the contact",
                "Maximum stress of each kind at each depth; for an ellipse below its shorter axis.",
            ),
            pictured=PicturedContact.NONE,
            formulas=(MISES, MAX_SHEAR, ORTHOGONAL),
        ),
        "map_stress": answer(
            "winkler.problems.subsurface.map_stress:MapStress",
            question="How high are the stresses below a given map of pressures, such as that of another program?",
            page="chapters/surfaces/subsurface.md#below-a-given-map",
            en="stress below a given pressure map pressure film footprint boussinesq cerruti load patch stress from measured pressure stress under foundation fuji film pressure sensitive paper tekscan uniform pressure patch under a wheel track pad",
            de="spannung unter gegebenem druck druckkarte boussinesq cerruti druckfolie",
            fr="contrainte sous une carte de pression donnée boussinesq cerruti film de pression film fuji répartition de pression mesurée",
            headline=("von_mises", "z", "x", "y", "yield_factor"),
            says={"von_mises": "the greatest von Mises stress is {von_mises}, {z:below}"},
            solid={"kind": "elastic", "strength": "500 MPa"},
            picture=Caption(
                "below",
                "Stresses below the surface",
                "The pressure, and the von Mises stress at the depth of its maximum and on a plane through it.",
            ),
            pictured=PicturedContact.NONE,
            formulas=(PIXELS, MISES),
        ),
    },
)
