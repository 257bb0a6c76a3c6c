"""Kinds of elastic bodies, media and beds: profiles, solids, layers, gradings, foundations."""

from __future__ import annotations

from winkler.study.chapters.answer import Kinds
from winkler.study.chapters.kind import Words, kind

__all__ = ["BODIES"]

WAVY_BALL = {
    "kind": "sum",
    "parts": [
        {"kind": "paraboloid", "curvature_radius": "10 mm"},
        {"kind": "wavy", "amplitude": "0.1 um", "wavelength": "1 mm"},
    ],
}
"""A wave alone would touch at its next trough too; on a ball it does not."""

BODIES: Kinds = {
    "profile": {
        "sphere": kind(
            "winkler.profiles.sphere:Sphere",
            "hertz_1882",
            "popov_hess_2015",
            words=Words(
                en="ball bead spherical glass bead colloidal probe ruby",
                de="kugel kugelförmig",
                fr="sphère bille",
            ),
            curvature_radius="10 mm",
        ),
        "paraboloid": kind("winkler.profiles.power:Paraboloid", "hertz_1882", curvature_radius="10 mm"),
        "power_law": kind(
            "winkler.profiles.power:PowerLaw", "galin_1946", "sneddon_1965", coefficient="1e6 m^-3", exponent=4.0
        ),
        "cone": kind(
            "winkler.profiles.conical:Cone",
            "love_1939",
            "sneddon_1965",
            words=Words(
                en="conical tip rockwell cone indenter sharp tip afm",
                de="kegel kegelspitze",
                fr="cône pointe conique",
            ),
            half_angle="70.3 deg",
        ),
        "ellipsoid": kind(
            "winkler.profiles.sphere:Ellipsoid",
            "popov_hess_willert_2019",
            radial_semi_axis="10 mm",
            axial_semi_axis="5 mm",
        ),
        "ball_in_socket": kind(
            "winkler.profiles.socket:BallInSocket",
            "popov_hess_willert_2019",
            words=Words(
                en="ball in a cup abutment ball head cup hip joint conformal ball joint spherical bearing socket acetabular implant conforming hemispherical seat conforming contact spherical plain bearing shoulder dual mobility press-fit acetabular hollow sphere concave clearance ball joint",
                de="kugelgelenk hüftgelenk pfanne gelenk anschmiegend hohlkugel kugel in kalotte gelenklager",
                fr="rotule prothèse de hanche articulation cotyle conforme contact conforme rotule sphère creuse cotyle",
            ),
            curvature_radius="10 mm",
            socket_radius="10.1 mm",
        ),
        "hyperboloid": kind(
            "winkler.profiles.sphere:Hyperboloid",
            "popov_hess_willert_2019",
            curvature_radius="1 mm",
            half_angle="70 deg",
        ),
        "flat_punch": kind(
            "winkler.profiles.flat:FlatPunch",
            "boussinesq_1885",
            "sneddon_1965",
            words=Words(
                en="cylinder end flat end pin probe needle stamp foot pad flat cylinder flat-ended indenter rigid flat cylinder pressure distribution under a punch torsional loading circular region uniform displacement",
                de="stempel flacher zylinder stift flachstempel",
                fr="poinçon plat cylindre pion",
            ),
            radius="1 mm",
        ),
        "rounded_punch": kind(
            "winkler.profiles.rounded:RoundedPunch",
            "ciavarella_hills_monno_1998",
            words=Words(
                en="flat punch with rounded edges chamfered edge radius of the edge fillet worn flat cylinder rounded corners",
                de="stempel mit verrundeter kante fase kantenradius",
                fr="poinçon à bord arrondi chanfrein congé",
            ),
            flat_radius="0.5 mm",
            edge_radius="1 mm",
        ),
        "truncated_cone": kind(
            "winkler.profiles.conical:TruncatedCone",
            "briscoe_1994",
            words=Words(
                en="blunted cone flat topped cone chamfered cylinder frustum worn cone",
                de="kegelstumpf gefaste kante abgestumpfter kegel",
                fr="tronc de cône cône tronqué chanfrein",
            ),
            half_angle="80 deg",
            flat_radius="0.1 mm",
        ),
        "truncated_paraboloid": kind(
            "winkler.profiles.rounded:TruncatedParaboloid",
            "maugis_barquins_1983",
            curvature_radius="10 mm",
            flat_radius="0.2 mm",
        ),
        "capped_paraboloid": kind(
            "winkler.profiles.rounded:CappedParaboloid",
            "maugis_barquins_1983",
            curvature_radius="10 mm",
            cap_curvature_radius="20 mm",
            cap_radius="0.1 mm",
        ),
        "rounded_cone": kind(
            "winkler.profiles.conical:RoundedCone",
            "maugis_barquins_1983",
            curvature_radius="1 mm",
            half_angle="70.3 deg",
        ),
        "sphero_conical": kind(
            "winkler.profiles.conical:SpheroConical",
            "briscoe_1994",
            words=Words(
                en="real afm tip rounded cone blunt tip tip radius rockwell diamond stylus conospherical rockwell c indenter brale record stylus phonograph needle gramophone",
                de="afm spitze verrundeter kegel stumpfe spitze tastnadel rockwell",
                fr="pointe afm cône arrondi pointe émoussée stylet pointe rockwell",
            ),
            curvature_radius="1 mm",
            half_angle="60 deg",
        ),
        "berkovich": kind(
            "winkler.profiles.conical:Berkovich",
            "oliver_pharr_1992",
            words=Words(
                en="nanoindenter tip three-sided pyramid berkovich indenter triangular diamond three-sided diamond equivalent cone angle",
                de="berkovich dreiseitige pyramide nanoindenter",
                fr="berkovich pyramide à trois faces indenteur",
            ),
        ),
        "vickers": kind(
            "winkler.profiles.conical:Vickers",
            "oliver_pharr_1992",
            words=Words(
                en="vickers hardness hv diamond pyramid microhardness knoop meyer microindentation",
                de="vickers härte mikrohärte diamantpyramide",
                fr="vickers dureté microdureté pyramide",
            ),
        ),
        "cube_corner": kind(
            "winkler.profiles.conical:CubeCorner",
            "oliver_pharr_1992",
            words=Words(
                en="sharp nanoindenter cube corner tip three faces",
                de="würfelecke scharfe spitze",
                fr="coin de cube pointe aiguë",
            ),
        ),
        "pyramid": kind(
            "winkler.profiles.pyramids.pyramid:Pyramid", "bilodeau_1992", "love_1939", sides=4, face_angle="68 deg"
        ),
        "pyramid_by_edges": kind(
            "winkler.profiles.pyramids.pyramid:PyramidByEdges",
            "bilodeau_1992",
            "love_1939",
            sides=3,
            edge_angle="54.7356 deg",
        ),
        "rounded_pyramid": kind(
            "winkler.profiles.pyramids.rounded_pyramid:RoundedPyramid",
            "rico_2005",
            "bilodeau_1992",
            words=Words(
                en="blunt pyramid afm tip bilodeau silicon nitride cantilever pyramidal tip",
                de="stumpfe pyramide afm spitze",
                fr="pyramide émoussée pointe afm",
            ),
            sides=4,
            face_angle="70 deg",
            curvature_radius="1 mm",
        ),
        "calibrated_tip": kind(
            "winkler.profiles.calibrated_tip:CalibratedTip",
            "oliver_pharr_1992",
            words=Words(
                en="area function tip shape calibration oliver pharr coefficients",
                de="flächenfunktion spitze kalibriert",
                fr="fonction d'aire pointe étalonnée",
            ),
            coefficients=["24.5", "40 um"],
            shallowest="1 um",
            deepest="200 um",
        ),
        "tabulated_tip": kind(
            "winkler.profiles.calibrated_tip:TabulatedTip",
            "oliver_pharr_1992",
            depths=["1 um", "3 um", "10 um", "30 um", "100 um", "200 um"],
            areas=["64.5 um^2", "340.5 um^2", "2850 um^2", "23250 um^2", "249000 um^2", "988000 um^2"],
        ),
        "area_function": kind(
            "winkler.profiles.area:AreaFunction", "oliver_pharr_1992", coefficients=["24.5", "2 um", "3e-6 m^1.5"]
        ),
        "capped_cylinder": kind(
            "winkler.profiles.flat:CappedCylinder",
            "popov_hess_willert_2019",
            radius="0.2 mm",
            cap={"kind": "sphere", "curvature_radius": "10 mm"},
        ),
        "wavy": kind(
            "winkler.profiles.wavy:Wavy",
            "guduru_2007",
            words=Words(
                en="waviness waves ripples concentric",
                de="wellen welligkeit",
                fr="ondulation vagues",
            ),
            within=WAVY_BALL,
            amplitude="0.1 um",
            wavelength="1 mm",
        ),
        "sum": kind("winkler.profiles.profile:Sum", "guduru_2007", parts=WAVY_BALL["parts"]),
        "formula": kind(
            "winkler.profiles.formula:Formula",
            "popov_hess_2015",
            words=Words(
                en="own shape equation function of r custom profile user defined expression arbitrary shape",
                de="eigene form formel gleichung beliebige form",
                fr="forme propre équation formule forme quelconque",
            ),
            expression="r**2/(2*R) + r**4/(8*R**3)",
            constants={"R": "10 mm"},
        ),
        "measured": kind(
            "winkler.profiles.measured:Measured",
            "popov_hess_2015",
            words=Words(
                en="measured tip shape worn tip profile scanned tip own shape table of points fill in the shape of my stylus from a list of points table points",
                de="gemessene form profil punkte eigene form",
                fr="forme mesurée profil points",
            ),
            reader="winkler.io.tables.profile_table:read_profile",
            radii={"from": "0 mm", "to": "1 mm", "count": 6},
            heights=["0 um", "2 um", "8 um", "18 um", "32 um", "50 um"],
        ),
        "designed": kind(
            "winkler.profiles.designed:Designed",
            "popov_hess_2015",
            edges=["0 mm", "0.5 mm", "1 mm"],
            slopes=[[0.025, 0.025], [0.075, 0.025]],
            tolerance=1e-10,
        ),
    },
    "solid": {
        "elastic": kind("winkler.materials.elastic:Elastic", young="210 GPa", poisson=0.3),
        "rigid": kind(
            "winkler.materials.elastic:Rigid",
            words=Words(
                en="rigid body stiff indenter undeformable",
                de="starr",
                fr="rigide",
            ),
        ),
        "named_elastic": kind("winkler.materials.named:NamedElastic", name="fused silica"),
        "transversely_isotropic": kind(
            "winkler.materials.elastic:TransverselyIsotropic",
            c11="162 GPa",
            c12="92 GPa",
            c13="69 GPa",
            c33="181 GPa",
            c44="47 GPa",
        ),
        "power_law_graded": kind(
            "winkler.materials.graded:PowerLawGraded",
            "booker_1985",
            young="220 GPa",
            depth_scale="1 mm",
            exponent=0.15,
            poisson=0.25,
        ),
    },
    "medium": {
        "half_space": kind(
            "winkler.media.halfspace:HalfSpace",
            "johnson_1985",
            words=Words(
                en="bulk solid thick block elastic body semi-infinite substrate",
                de="halbraum dicker körper vollmaterial",
                fr="demi-espace massif corps épais",
            ),
        ),
        "transversely_isotropic_half_space": kind(
            "winkler.media.transverse:TransverselyIsotropicHalfSpace",
            "elliott_1949",
            words=Words(
                en="wood grain along the grain anisotropic fibre composite wood graphite mica crystal zinc transversely isotropic lekhnitskii anisotropic materials fibre composite laminate wooden floor dent bone hexagonal crystal timber grain direction",
                de="anisotrop transversal isotrop faserverbund holz graphit kristall anisotrope werkstoffe knochen parkett faserrichtung",
                fr="anisotrope isotrope transverse composite fibres bois graphite cristal os parquet matériaux anisotropes",
            ),
        ),
        "graded_half_space": kind(
            "winkler.media.graded.power_law:GradedHalfSpace",
            "booker_1985",
            "giannakopoulos_suresh_1997",
            "hess_2016",
            words=Words(
                en="power law graded gibson soil modulus grows with depth sand booker foundation on soil stiffness grows with depth footing sand",
                de="potenzgesetz gradiert boden gibson gründung sand",
                fr="gradient en loi de puissance sol gibson fondation sable",
            ),
        ),
        "coated_half_space": kind(
            "winkler.media.layered.coated:CoatedHalfSpace",
            "barber_1974",
            "hayes_1972",
            "hess_2023",
            words=Words(
                key="coating layer",
                en="tin layer crn layer plating thickness hard layer on shaft coating thin film layer dlc tin hard coating paint varnish lacquer multilayer plated substrate effect gel on glass film changes stiffness influence of the film sample thickness finite thickness bottom effect thin sample layered solids layer on a base oxide layer hard chrome plating nickel plate eggshell effect paint layer thin layer rubber bonded to steel sample on glass skin polymer film on silicon bonded layer soft layer on rigid base glass below thin sample",
                de="beschichtung schicht dünnfilm hartstoffschicht lack dünne probe substrateinfluss schichtdicke dünnschicht hartchrom vernickelt lackschicht",
                fr="revêtement couche mince film dépôt vernis effet de substrat épaisseur échantillon mince couche dure sur acier chrome dur couche d'oxyde solide stratifié",
            ),
        ),
        "sliding_film": kind(
            "winkler.media.layered.coated:SlidingFilm",
            "barber_1974",
            words=Words(
                en="loose film unbonded layer membrane not glued sheet on base frictionless interface pad liner",
                de="lose schicht nicht verklebt folie gleitet unterlage",
                fr="film libre non collé feuille posée glissante",
            ),
        ),
        "stacked_half_space": kind(
            "winkler.media.layered.coated:StackedHalfSpace",
            "barber_1974",
            "elliott_1949",
            words=Words(
                en="laminate composite layers multilayer anisotropic stack sandwich plies several films layered solids paint system printed circuit board",
                de="schichtstapel verbund laminat mehrlagig sandwich",
                fr="empilement stratifié multicouche sandwich",
            ),
        ),
        "depth_graded_half_space": kind(
            "winkler.media.layered.depth_graded:DepthGradedHalfSpace",
            "barber_1974",
            "hess_2023",
            words=Words(
                en="functionally graded case hardened nitrided hardness gradient modulus changes with depth skin carburised ion implanted soil nitrided layer induction hardened gradient residual layer hardness profile functionally graded coating",
                de="gradiert gradientenwerkstoff einsatzgehärtet nitriert modul ändert sich mit tiefe randschicht einhärtung nitrierschicht",
                fr="gradient fonctionnel cémenté nitruré module variant avec la profondeur gradient de dureté couche nitrurée",
            ),
            tolerance=1e-2,
        ),
    },
    "layer": {
        "layer": kind(
            "winkler.materials.layered:Layer",
            solid={"kind": "elastic", "young": "450 GPa", "poisson": 0.25},
            thickness="50 um",
        ),
        "stack_layer": kind(
            "winkler.materials.layered:StackLayer",
            solid={"kind": "elastic", "young": "450 GPa", "poisson": 0.25},
            thickness="50 um",
            bonded=False,
        ),
    },
    "grading": {
        "exponential_grading": kind(
            "winkler.materials.depth_grading:ExponentialGrading",
            surface_young="380 GPa",
            deep_young="210 GPa",
            depth_scale="0.2 mm",
            poisson=0.3,
        ),
        "sigmoidal_grading": kind(
            "winkler.materials.depth_grading:SigmoidalGrading",
            surface_young="380 GPa",
            deep_young="210 GPa",
            transition_depth="0.2 mm",
            transition_width="0.1 mm",
            poisson=0.3,
        ),
        "tabulated_grading": kind(
            "winkler.materials.depth_grading:TabulatedGrading",
            reader="winkler.io.tables.grading_table:read_grading",
            depths=["0 mm", "0.1 mm", "0.3 mm", "0.6 mm"],
            youngs=["380 GPa", "340 GPa", "240 GPa", "210 GPa"],
            poissons=[0.24, 0.26, 0.29, 0.3],
        ),
    },
    "bed": {
        "foundation": kind("winkler.foundation.foundation:Foundation", "popov_hess_2015"),
        "plane_foundation": kind("winkler.foundation.plane:PlaneFoundation", "popov_hess_2015"),
        "elliptic_foundation": kind("winkler.foundation.elliptic:EllipticFoundation", "johnson_1985"),
        "measured_bed": kind(
            "winkler.foundation.measured:MeasuredBed",
            "barber_1974",
            reader="winkler.io.tables.bed_table:read_bed",
            radii={"from": "0.05 mm", "to": "0.3 mm", "count": 6},
            stiffnesses={"from": "11.5 MN/m", "to": "69 MN/m", "count": 6},
            depths=["0.25 um", "1 um", "2.25 um", "4 um", "6.25 um", "9 um"],
        ),
    },
}
