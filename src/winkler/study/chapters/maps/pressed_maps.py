"""True areas, patches, leak and heat of pressed height maps: their problems and formulas."""

from __future__ import annotations

from winkler.study.chapters.answer import Caption, Chapter, Equation, PicturedContact, answer
from winkler.study.chapters.conduction import STEEL_PAIR
from winkler.study.chapters.rough import ELEMENTS, STAMP

PRESSED = {"kind": "surface_contact", "topography": {**STAMP, "seed": 1}}

CORRECTED = Equation(
    "Area of the pixels in contact, minus the excess along their edge of the length S (Yastrebov)",
    r"A = A_{pixels}-\frac{\pi-1+\ln 2}{24}\,S\,\Delta x",
)
SECOND_POINTS = Equation(
    "Error estimate: the maximum difference between this area and those of the four maps of every second point",
    r"\Delta A = \max_{i,j\le4}|A_i-A_j| , \quad A_0 = A(\Delta x) , \quad A_1\dots A_4 = A(2\Delta x)",
)
REYNOLDS = Equation(
    "Flow of the fluid through the gap h: Reynolds' equation",
    r"q_i = -\frac{h^3}{12\eta}\,\frac{\partial p}{\partial x_i}, "
    r"\quad \frac{\partial q_x}{\partial x}+\frac{\partial q_y}{\partial y} = 0",
)
FACTOR = Equation(
    "The flow factor is the ratio to the flow through a uniform film of the mean gap (Patir and Cheng)",
    r"\phi_x = \frac{12\eta L_x Q}{L_y\,\bar{u}^3\,\Delta p}",
)
MEDIUM = Equation(
    "Bruggeman's effective medium theory needs only the distribution of the gaps",
    r"\left\langle\frac{h^3-s}{h^3+s}\right\rangle = 0, \quad Q_e = \frac{L_y\,s\,\Delta p}{12\eta L_x}",
)

JOINT = Equation(
    "Thermal resistance r of contact spots or of the medium in the gap u, and spreading of heat in both bodies",
    r"r\,q + \frac{1}{2\pi}\left(\frac{1}{\lambda_1}+\frac{1}{\lambda_2}\right)\int\frac{q}{s}\,\mathrm{d}A' = "
    r"\Delta T, \quad r = \frac{1}{h_i} \text{ or } \frac{u+M}{\lambda_g}",
)

PRESSED_MAPS = Chapter(
    "true areas and seals",
    kinds={},
    answers={
        "true_area": answer(
            "winkler.problems.pressed_maps.true_area:TrueArea",
            question="How much of a rough surface really touches, in how many patches, and how large is the error of the grid?",
            page="chapters/surfaces/seals.md",
            en="real contact area true contact greenwood williamson persson bearing area how much touches contact patches percentage in contact asperity number of spots gw model plasticity index bearing area curve abbott-firestone nayak bush gibson thomas plasticity index sandblasted fraction of nominal area in touch fingertip print percentage touching bowden tabor junctions",
            de="wahre kontaktfläche reale kontaktfläche greenwood williamson traganteil wie viel berührt persson materialtraganteil abbott-kurve bruchteil scheinbare fläche",
            fr="aire réelle de contact greenwood williamson persson combien touche portance taux de contact taux de portance courbe d'abbott surface réelle fraction de la surface",
            headline=("area", "area_error", "peak_pressure", "patch_count"),
            says={"area": "the surfaces touch on {contact_share:%} of the area, {area}"},
            contact=PRESSED,
            picture=Caption(
                "patches",
                "Patches of contact, gaps and pressures",
                "Contact patches coloured by area, distributions of gap, pressure and patch area under the last "
                "load; for many loads also area and maximum pressure, with the differences from maps of every second "
                "point.",
            ),
            curves=(("force", "area"), ("force", "peak_pressure"), ("force", "patch_count"), ("force", "mean_gap")),
            pictured=PicturedContact.NONE,
            formulas=(ELEMENTS, CORRECTED, SECOND_POINTS),
        ),
        "seal": answer(
            "winkler.problems.pressed_maps.seal:Seal",
            question="How much leaks through a pressed surface, and where is the gap narrowest?",
            page="chapters/surfaces/seals.md",
            key="leak gasket",
            en="oil leaks out leaking oil seal leak leakage gasket o-ring seal percolation tightness flow through gap does my seal leak flange helium valve seat vacuum fluid leak rate washer sealing pressure water gets through bridgman seal face seal mechanical seal leak rate of a metal seal metal-to-metal sealing surface finish percolation threshold closed gap valve gas passes between ground faces seal class leak per length lapped faces compressor valve plate flat gasket",
            de="öl läuft durch flansch verspannte flansche öl tritt aus dichtung leckage undicht leckrate flansch dicht percolation ist die dichtung dicht wasser tritt durch dichtfläche ventilsitz dichtheit gleitringdichtung gas strömt zwischen geschliffenen flächen metallische dichtung leckstrom ventilplatte",
            fr="fuite d'huile joint fuite étanchéité débit de fuite bride percolation est-ce que mon joint fuit eau traverse siège de soupape étanchéité métal-métal garniture mécanique soupape",
            headline=("leak_rate", "leak_rate_error", "flow_factor", "critical_gap"),
            says={"leak_rate": "the seal leaks {leak_rate}, through a narrowest gap of {critical_gap}"},
            contact=PRESSED,
            viscosity="1 mPa s",
            pressure_drop="100 kPa",
            picture=Caption(
                "leak",
                "Flow through the gap",
                "Gap under the last load with the flow along x and the narrowest point of the widest path, pressure "
                "of the fluid, and distribution of the gap; for many loads also leak rate and flow factors.",
            ),
            curves=(("force", "leak_rate"), ("force", "flow_factor"), ("force", "critical_gap")),
            pictured=PicturedContact.NONE,
            formulas=(ELEMENTS, REYNOLDS, FACTOR, MEDIUM),
        ),
        "thermal_joint": answer(
            "winkler.problems.pressed_maps.thermal_joint:ThermalJoint",
            question="How much heat passes through the spots and the gap of a joint?",
            page="chapters/surfaces/seals.md#heat-through-spots-and-gap",
            en="thermal joint conductance gap gas heat through interface thermal paste grease cpu heat sink vacuum thermal contact conductance rough cooper mikic yovanovich bolted joint heat tim cooper-mikic-yovanovich satellite bolted plates vacuum processor radiator chip cold plate interstitial gas mounting pressure led aluminium joints heat crosses a pressed joint",
            de="wärmeübergang zwischen kontaktflächen wärmeleitpaste fuge wärmedurchgang spalt gas kühlkörper thermischer kontakt rau wärmeübergangskoeffizient raue fugen wärmeübergangswiderstand prozessor chip kühlkörper",
            fr="chaleur traverse plaques boulonnées joint thermique pâte thermique conductance interface gaz dissipateur résistance thermique rugueuse processeur radiateur puce plaque froide",
            headline=("conductance", "spot_conductance", "gap_conductance", "joint_conductance"),
            contact=PRESSED,
            conductors={"kind": "heat_conductors", **STEEL_PAIR},
            gap_conductivity="0.026 W/(m K)",
            picture=Caption(
                "joint",
                "Heat through spots and gap",
                "Heat flux per kelvin in every pixel and gap under the last load; for many loads the conductance of "
                "the spots, of the gap, and of both.",
            ),
            curves=(("force", "conductance"), ("force", "spot_conductance"), ("force", "gap_conductance")),
            pictured=PicturedContact.NONE,
            formulas=(ELEMENTS, JOINT),
        ),
    },
)
