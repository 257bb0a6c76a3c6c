"""Kinds of elastic bodies, media and beds: profiles, solids, layers, gradings, foundations."""

from __future__ import annotations

from winkler.study.chapters.answer import Kinds
from winkler.study.chapters.kind import kind

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
        "sphere": kind("winkler.profiles.sphere:Sphere", "hertz_1882", "popov_hess_2015", curvature_radius="10 mm"),
        "paraboloid": kind("winkler.profiles.power:Paraboloid", "hertz_1882", curvature_radius="10 mm"),
        "power_law": kind(
            "winkler.profiles.power:PowerLaw", "galin_1946", "sneddon_1965", coefficient="1e6 m^-3", exponent=4.0
        ),
        "cone": kind("winkler.profiles.conical:Cone", "love_1939", "sneddon_1965", half_angle="70.3 deg"),
        "ellipsoid": kind(
            "winkler.profiles.sphere:Ellipsoid",
            "popov_hess_willert_2019",
            radial_semi_axis="10 mm",
            axial_semi_axis="5 mm",
        ),
        "ball_in_socket": kind(
            "winkler.profiles.socket:BallInSocket",
            "popov_hess_willert_2019",
            curvature_radius="10 mm",
            socket_radius="10.1 mm",
        ),
        "hyperboloid": kind(
            "winkler.profiles.sphere:Hyperboloid",
            "popov_hess_willert_2019",
            curvature_radius="1 mm",
            half_angle="70 deg",
        ),
        "flat_punch": kind("winkler.profiles.flat:FlatPunch", "boussinesq_1885", "sneddon_1965", radius="1 mm"),
        "rounded_punch": kind(
            "winkler.profiles.rounded:RoundedPunch",
            "ciavarella_hills_monno_1998",
            flat_radius="0.5 mm",
            edge_radius="1 mm",
        ),
        "truncated_cone": kind(
            "winkler.profiles.conical:TruncatedCone", "briscoe_1994", half_angle="80 deg", flat_radius="0.1 mm"
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
            "winkler.profiles.conical:SpheroConical", "briscoe_1994", curvature_radius="1 mm", half_angle="60 deg"
        ),
        "berkovich": kind("winkler.profiles.conical:Berkovich", "oliver_pharr_1992"),
        "vickers": kind("winkler.profiles.conical:Vickers", "oliver_pharr_1992"),
        "cube_corner": kind("winkler.profiles.conical:CubeCorner", "oliver_pharr_1992"),
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
            sides=4,
            face_angle="70 deg",
            curvature_radius="1 mm",
        ),
        "calibrated_tip": kind(
            "winkler.profiles.calibrated_tip:CalibratedTip",
            "oliver_pharr_1992",
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
            "winkler.profiles.wavy:Wavy", "guduru_2007", within=WAVY_BALL, amplitude="0.1 um", wavelength="1 mm"
        ),
        "sum": kind("winkler.profiles.profile:Sum", "guduru_2007", parts=WAVY_BALL["parts"]),
        "formula": kind(
            "winkler.profiles.formula:Formula",
            "popov_hess_2015",
            expression="r**2/(2*R) + r**4/(8*R**3)",
            constants={"R": "10 mm"},
        ),
        "measured": kind(
            "winkler.profiles.measured:Measured",
            "popov_hess_2015",
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
        "rigid": kind("winkler.materials.elastic:Rigid"),
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
        "half_space": kind("winkler.media.halfspace:HalfSpace", "johnson_1985"),
        "transversely_isotropic_half_space": kind(
            "winkler.media.transverse:TransverselyIsotropicHalfSpace", "elliott_1949"
        ),
        "graded_half_space": kind(
            "winkler.media.graded.power_law:GradedHalfSpace", "booker_1985", "giannakopoulos_suresh_1997", "hess_2016"
        ),
        "coated_half_space": kind(
            "winkler.media.layered.coated:CoatedHalfSpace", "barber_1974", "hayes_1972", "hess_2023"
        ),
        "sliding_film": kind("winkler.media.layered.coated:SlidingFilm", "barber_1974"),
        "stacked_half_space": kind("winkler.media.layered.coated:StackedHalfSpace", "barber_1974", "elliott_1949"),
        "depth_graded_half_space": kind(
            "winkler.media.layered.depth_graded:DepthGradedHalfSpace", "barber_1974", "hess_2023", tolerance=1e-2
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
