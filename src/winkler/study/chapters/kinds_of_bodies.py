"""Kinds of bodies and beds: profiles, solids, layers, media, foundations."""

from __future__ import annotations

from winkler.foundation.elliptic import EllipticFoundation
from winkler.foundation.foundation import Foundation
from winkler.foundation.measured import MeasuredBed
from winkler.foundation.plane import PlaneFoundation
from winkler.io.tables.bed_table import read_bed
from winkler.io.tables.grading_table import read_grading
from winkler.io.tables.profile_table import read_profile
from winkler.materials.depth_grading import ExponentialGrading, SigmoidalGrading, TabulatedGrading
from winkler.materials.elastic import Elastic, Rigid, TransverselyIsotropic
from winkler.materials.graded import PowerLawGraded
from winkler.materials.layered import Layer
from winkler.materials.named import NamedElastic
from winkler.media.graded.power_law import GradedHalfSpace
from winkler.media.halfspace import HalfSpace
from winkler.media.layered.coated import CoatedHalfSpace
from winkler.media.layered.depth_graded import DepthGradedHalfSpace
from winkler.media.transverse import TransverselyIsotropicHalfSpace
from winkler.profiles.area import AreaFunction
from winkler.profiles.conical import Berkovich, Cone, CubeCorner, RoundedCone, SpheroConical, TruncatedCone, Vickers
from winkler.profiles.designed import Designed
from winkler.profiles.flat import CappedCylinder, FlatPunch
from winkler.profiles.formula import Formula
from winkler.profiles.measured import Measured
from winkler.profiles.power import Paraboloid, PowerLaw
from winkler.profiles.profile import Sum
from winkler.profiles.rounded import CappedParaboloid, RoundedPunch, TruncatedParaboloid
from winkler.profiles.socket import BallInSocket
from winkler.profiles.sphere import Ellipsoid, Hyperboloid, Sphere
from winkler.profiles.wavy import Wavy
from winkler.study.chapters.kind import Kind, kind

__all__ = ["BODIES"]

WAVY_BALL = {
    "kind": "sum",
    "parts": [
        {"kind": "paraboloid", "curvature_radius": "10 mm"},
        {"kind": "wavy", "amplitude": "0.1 um", "wavelength": "1 mm"},
    ],
}
"""A wave alone touches again at its next trough; on a ball it does not."""

BODIES: dict[str, dict[str, Kind]] = {
    "profile": {
        "sphere": kind(Sphere, "hertz_1882", "popov_hess_2015", curvature_radius="10 mm"),
        "paraboloid": kind(Paraboloid, "hertz_1882", curvature_radius="10 mm"),
        "power_law": kind(PowerLaw, "galin_1946", "sneddon_1965", coefficient="1e6 m^-3", exponent=4.0),
        "cone": kind(Cone, "love_1939", "sneddon_1965", half_angle="70.3 deg"),
        "ellipsoid": kind(Ellipsoid, "popov_hess_willert_2019", radial_semi_axis="10 mm", axial_semi_axis="5 mm"),
        "ball_in_socket": kind(
            BallInSocket, "popov_hess_willert_2019", curvature_radius="10 mm", socket_radius="10.1 mm"
        ),
        "hyperboloid": kind(Hyperboloid, "popov_hess_willert_2019", curvature_radius="1 mm", half_angle="70 deg"),
        "flat_punch": kind(FlatPunch, "boussinesq_1885", "sneddon_1965", radius="1 mm"),
        "rounded_punch": kind(RoundedPunch, "ciavarella_1998", flat_radius="0.5 mm", edge_radius="1 mm"),
        "truncated_cone": kind(TruncatedCone, "briscoe_1994", half_angle="80 deg", flat_radius="0.1 mm"),
        "truncated_paraboloid": kind(
            TruncatedParaboloid, "maugis_barquins_1983", curvature_radius="10 mm", flat_radius="0.2 mm"
        ),
        "capped_paraboloid": kind(
            CappedParaboloid,
            "maugis_barquins_1983",
            curvature_radius="10 mm",
            cap_curvature_radius="20 mm",
            cap_radius="0.1 mm",
        ),
        "rounded_cone": kind(RoundedCone, "maugis_barquins_1983", curvature_radius="1 mm", half_angle="70.3 deg"),
        "sphero_conical": kind(SpheroConical, "briscoe_1994", curvature_radius="1 mm", half_angle="60 deg"),
        "berkovich": kind(Berkovich, "oliver_pharr_1992"),
        "vickers": kind(Vickers, "oliver_pharr_1992"),
        "cube_corner": kind(CubeCorner, "oliver_pharr_1992"),
        "area_function": kind(AreaFunction, "oliver_pharr_1992", coefficients=["24.5", "2 um", "3e-6 m^1.5"]),
        "capped_cylinder": kind(
            CappedCylinder,
            "popov_hess_willert_2019",
            radius="0.2 mm",
            cap={"kind": "sphere", "curvature_radius": "10 mm"},
        ),
        "wavy": kind(Wavy, "guduru_2007", within=WAVY_BALL, amplitude="0.1 um", wavelength="1 mm"),
        "sum": kind(Sum, "guduru_2007", parts=WAVY_BALL["parts"]),
        "formula": kind(Formula, "popov_hess_2015", expression="r**2/(2*R) + r**4/(8*R**3)", constants={"R": "10 mm"}),
        "measured": kind(
            Measured,
            "popov_hess_2015",
            reader=read_profile,
            radii={"from": "0 mm", "to": "1 mm", "count": 6},
            heights=["0 um", "2 um", "8 um", "18 um", "32 um", "50 um"],
        ),
        "designed": kind(
            Designed,
            "popov_hess_2015",
            edges=["0 mm", "0.5 mm", "1 mm"],
            slopes=[[0.025, 0.025], [0.075, 0.025]],
            tolerance=1e-10,
        ),
    },
    "solid": {
        "elastic": kind(Elastic, young="210 GPa", poisson=0.3),
        "rigid": kind(Rigid),
        "named_elastic": kind(NamedElastic, name="fused silica"),
        "transversely_isotropic": kind(
            TransverselyIsotropic, c11="162 GPa", c12="92 GPa", c13="69 GPa", c33="181 GPa", c44="47 GPa"
        ),
        "power_law_graded": kind(
            PowerLawGraded, "booker_1985", young="220 GPa", depth_scale="1 mm", exponent=0.15, poisson=0.25
        ),
    },
    "medium": {
        "half_space": kind(HalfSpace, "johnson_1985"),
        "transversely_isotropic_half_space": kind(TransverselyIsotropicHalfSpace, "elliott_1949"),
        "graded_half_space": kind(GradedHalfSpace, "booker_1985", "giannakopoulos_suresh_1997", "hess_2016"),
        "coated_half_space": kind(CoatedHalfSpace, "barber_1974", "hayes_1972", "hess_2023"),
        "depth_graded_half_space": kind(DepthGradedHalfSpace, "barber_1974", "hess_2023", tolerance=1e-2),
    },
    "layer": {
        "layer": kind(Layer, solid={"kind": "elastic", "young": "450 GPa", "poisson": 0.25}, thickness="50 um"),
    },
    "grading": {
        "exponential_grading": kind(
            ExponentialGrading, surface_young="380 GPa", deep_young="210 GPa", depth_scale="0.2 mm", poisson=0.3
        ),
        "sigmoidal_grading": kind(
            SigmoidalGrading,
            surface_young="380 GPa",
            deep_young="210 GPa",
            transition_depth="0.2 mm",
            transition_width="0.1 mm",
            poisson=0.3,
        ),
        "tabulated_grading": kind(
            TabulatedGrading,
            reader=read_grading,
            depths=["0 mm", "0.1 mm", "0.3 mm", "0.6 mm"],
            youngs=["380 GPa", "340 GPa", "240 GPa", "210 GPa"],
            poissons=[0.24, 0.26, 0.29, 0.3],
        ),
    },
    "bed": {
        "foundation": kind(Foundation, "popov_hess_2015"),
        "plane_foundation": kind(PlaneFoundation, "popov_hess_2015"),
        "elliptic_foundation": kind(EllipticFoundation, "johnson_1985"),
        "measured_bed": kind(
            MeasuredBed,
            "barber_1974",
            reader=read_bed,
            radii={"from": "0.05 mm", "to": "0.3 mm", "count": 6},
            stiffnesses={"from": "11.5 MN/m", "to": "69 MN/m", "count": 6},
            depths=["0.25 um", "1 um", "2.25 um", "4 um", "6.25 um", "9 um"],
        ),
    },
}
"""Slot -> kind -> class."""
