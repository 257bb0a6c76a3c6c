"""Contact mechanics by the method of dimensionality reduction.

A body pressed, rubbed, rolled or heated against another one is replaced by a line of independent springs under a
transformed profile; solved there, exactly where the method is exact; and brought back to pressures and stresses.

>>> import winkler as wk
>>> steel = wk.Elastic(young=210e9, poisson=0.3)
>>> bed = wk.Foundation(wk.Paraboloid(curvature_radius=10e-3), wk.HalfSpace.between(steel, steel))
>>> contact = wk.Indentation(bed, wk.Force(100.0)).solve()
>>> round(contact.radius * 1e6, 3), round(contact.depth * 1e6, 4)
(186.626, 3.4829)
"""

from importlib.metadata import version

from winkler.errors import InvalidInput, NotConverged, OutsideValidity, WinklerError
from winkler.fields import (
    PeakStress,
    PlacedStress,
    SubsurfaceFields,
    SurfaceFields,
    peak_stress,
    restore,
    restore_body,
    restore_shift,
)
from winkler.fitting.compare import Comparison, compare
from winkler.fitting.curve import ForceCurve
from winkler.fitting.fit import Fit, fit
from winkler.fitting.oliver_pharr import OliverPharr, OliverPharrSolution, intercept_factor, sample_young
from winkler.foundation.foundation import Foundation
from winkler.foundation.measured import MeasuredBed
from winkler.foundation.plane import PlaneFoundation
from winkler.foundation.sheared_fields import BodyFields, ShearedFields
from winkler.foundation.springs import Springs
from winkler.io.bed_table import read_bed
from winkler.io.contact_state import read_contacts, write_contacts
from winkler.io.curves import PlacedCurve, read_curve, read_curves
from winkler.io.grading_table import read_grading
from winkler.io.path_table import read_path
from winkler.io.profile_table import read_profile
from winkler.io.traces import write_trace
from winkler.laws.adhesion import DerjaguinMullerToporov, Dugdale, ShortRange
from winkler.laws.friction import Coulomb, StaticKinetic
from winkler.loading import Angle, Depth, Force, Radius, ShearForce, Shift, Torque
from winkler.materials.depth_grading import ExponentialGrading, SigmoidalGrading, TabulatedGrading
from winkler.materials.elastic import Elastic, Rigid, TransverselyIsotropic
from winkler.materials.fractional import FractionalZener, PowerLawSolid
from winkler.materials.graded import PowerLawGraded
from winkler.materials.layered import Layer
from winkler.materials.relaxation_data import CreepData, DynamicData, RelaxationData
from winkler.materials.temperature import Arrhenius, WilliamsLandelFerry
from winkler.materials.viscoelastic import GeneralisedKelvin, KelvinVoigt, Maxwell, Prony, StandardSolid
from winkler.media.coated import CoatedHalfSpace
from winkler.media.depth_graded import DepthGradedHalfSpace
from winkler.media.graded import GradedHalfSpace
from winkler.media.halfspace import HalfSpace
from winkler.media.transverse import TransverselyIsotropicHalfSpace
from winkler.media.viscoelastic import ViscoelasticHalfSpace
from winkler.path import Path
from winkler.path_steps import Circle, Follow, Hold, Oscillate, Ramp, Start
from winkler.problems.adhesion_model import maugis_parameter, tabor_parameter, which_model
from winkler.problems.adhesive import AdhesiveIndentation, AdhesiveSolution
from winkler.problems.adhesive_cycle import AdhesiveCycle, AdhesiveCycleSolution
from winkler.problems.adhesive_shear import AdhesiveShear, AdhesiveShearSolution
from winkler.problems.bimodal import BimodalDamping, BimodalDampingSolution
from winkler.problems.contact_impacts import BallImpacts, BallImpactsSolution
from winkler.problems.contact_trace import ContactTrace
from winkler.problems.contacts import Contacts
from winkler.problems.damping import FrictionDamping, FrictionDampingSolution
from winkler.problems.design import design_for_pressure, design_profile
from winkler.problems.equilibrium import Equilibrium, EquilibriumCurve
from winkler.problems.impact import Impact, ImpactSolution
from winkler.problems.impact_adhesive import AdhesiveImpact, AdhesiveImpactSolution
from winkler.problems.indentation import Indentation, IndentationSolution
from winkler.problems.particle import ElasticPlasticParticle, ParticleSolution
from winkler.problems.pull_off import PullOff, PullOffSolution
from winkler.problems.relaxation import RelaxationDamper, RelaxationDamperSolution
from winkler.problems.tangential import Tangential, TangentialSolution
from winkler.problems.torsion import Torsion, TorsionSolution
from winkler.problems.torsion_fields import TwistedFields
from winkler.problems.viscoelastic import ViscoelasticIndentation, ViscoelasticSolution
from winkler.problems.viscoelastic_impact import ViscoelasticImpact, ViscoelasticImpactSolution
from winkler.problems.viscoelastic_tests import CreepTest, HarmonicIndentation, RelaxationTest
from winkler.problems.yielding import YieldOnset, YieldOnsetSolution
from winkler.profiles.area import AreaFunction
from winkler.profiles.composite import Sum
from winkler.profiles.conical import Berkovich, Cone, CubeCorner, RoundedCone, SpheroConical, TruncatedCone, Vickers
from winkler.profiles.designed import Designed
from winkler.profiles.flat import CappedCylinder, Cylinder, FlatPunch
from winkler.profiles.formula import Formula
from winkler.profiles.measured import Measured
from winkler.profiles.power import Paraboloid, PowerLaw
from winkler.profiles.profile import Shape
from winkler.profiles.rounded import CappedParaboloid, RoundedPunch, TruncatedParaboloid
from winkler.profiles.sphere import Ellipsoid, Hyperboloid, Sphere
from winkler.profiles.wavy import Wavy
from winkler.program import Program
from winkler.staircase import Staircase, staircase
from winkler.validity import Note, Standing

__all__ = [
    "AdhesiveCycle",
    "AdhesiveCycleSolution",
    "AdhesiveImpact",
    "AdhesiveImpactSolution",
    "AdhesiveIndentation",
    "AdhesiveShear",
    "AdhesiveShearSolution",
    "AdhesiveSolution",
    "Angle",
    "AreaFunction",
    "Arrhenius",
    "BallImpacts",
    "BallImpactsSolution",
    "Berkovich",
    "BimodalDamping",
    "BimodalDampingSolution",
    "BodyFields",
    "CappedCylinder",
    "CappedParaboloid",
    "Circle",
    "CoatedHalfSpace",
    "Comparison",
    "Cone",
    "ContactTrace",
    "Contacts",
    "Coulomb",
    "CreepData",
    "CreepTest",
    "CubeCorner",
    "Cylinder",
    "Depth",
    "DepthGradedHalfSpace",
    "DerjaguinMullerToporov",
    "Designed",
    "Dugdale",
    "DynamicData",
    "Elastic",
    "ElasticPlasticParticle",
    "Ellipsoid",
    "Equilibrium",
    "EquilibriumCurve",
    "ExponentialGrading",
    "Fit",
    "FlatPunch",
    "Follow",
    "Force",
    "ForceCurve",
    "Formula",
    "Foundation",
    "FractionalZener",
    "FrictionDamping",
    "FrictionDampingSolution",
    "GeneralisedKelvin",
    "GradedHalfSpace",
    "HalfSpace",
    "HarmonicIndentation",
    "Hold",
    "Hyperboloid",
    "Impact",
    "ImpactSolution",
    "Indentation",
    "IndentationSolution",
    "InvalidInput",
    "KelvinVoigt",
    "Layer",
    "Maxwell",
    "Measured",
    "MeasuredBed",
    "NotConverged",
    "Note",
    "OliverPharr",
    "OliverPharrSolution",
    "Oscillate",
    "OutsideValidity",
    "Paraboloid",
    "ParticleSolution",
    "Path",
    "PeakStress",
    "PlacedCurve",
    "PlacedStress",
    "PlaneFoundation",
    "PowerLaw",
    "PowerLawGraded",
    "PowerLawSolid",
    "Program",
    "Prony",
    "PullOff",
    "PullOffSolution",
    "Radius",
    "Ramp",
    "RelaxationDamper",
    "RelaxationDamperSolution",
    "RelaxationData",
    "RelaxationTest",
    "Rigid",
    "RoundedCone",
    "RoundedPunch",
    "Shape",
    "ShearForce",
    "ShearedFields",
    "Shift",
    "ShortRange",
    "SigmoidalGrading",
    "Sphere",
    "SpheroConical",
    "Springs",
    "Staircase",
    "StandardSolid",
    "Standing",
    "Start",
    "StaticKinetic",
    "SubsurfaceFields",
    "Sum",
    "SurfaceFields",
    "TabulatedGrading",
    "Tangential",
    "TangentialSolution",
    "Torque",
    "Torsion",
    "TorsionSolution",
    "TransverselyIsotropic",
    "TransverselyIsotropicHalfSpace",
    "TruncatedCone",
    "TruncatedParaboloid",
    "TwistedFields",
    "Vickers",
    "ViscoelasticHalfSpace",
    "ViscoelasticImpact",
    "ViscoelasticImpactSolution",
    "ViscoelasticIndentation",
    "ViscoelasticSolution",
    "Wavy",
    "WilliamsLandelFerry",
    "WinklerError",
    "YieldOnset",
    "YieldOnsetSolution",
    "__version__",
    "compare",
    "design_for_pressure",
    "design_profile",
    "fit",
    "intercept_factor",
    "maugis_parameter",
    "peak_stress",
    "read_bed",
    "read_contacts",
    "read_curve",
    "read_curves",
    "read_grading",
    "read_path",
    "read_profile",
    "restore",
    "restore_body",
    "restore_shift",
    "sample_young",
    "staircase",
    "tabor_parameter",
    "which_model",
    "write_contacts",
    "write_trace",
]

__version__ = version("winkler")
