"""What `import winkler` offers, each name from the module where it is defined.

The package reads these imports without running them: a name is loaded from its module when it is first used.
"""

from winkler.errors import InvalidInput, NotConverged, OutsideValidity, WinklerError
from winkler.fields import SubsurfaceFields, SurfaceFields, restore, restore_body, restore_shift
from winkler.fitting.compare import Comparison, compare
from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.curves.segments import Segment, SegmentKind
from winkler.fitting.fit import Fit, fit, fit_steps
from winkler.fitting.outcome import CreepFit, ViscoelasticFit
from winkler.fitting.relaxation_terms import compare_terms
from winkler.fitting.search import FitState
from winkler.fitting.unloading.contact_reading import (
    CalibratedArea,
    ContactReading,
    contact_reading,
    intercept_factor,
    sample_young,
)
from winkler.fitting.unloading.oliver_pharr import OliverPharr, OliverPharrSolution
from winkler.fitting.viscoelastic.band import relaxation_band
from winkler.foundation.elliptic import EllipticFoundation
from winkler.foundation.foundation import Foundation
from winkler.foundation.layered_line import LayeredLineFoundation
from winkler.foundation.line import LineFoundation
from winkler.foundation.measured import MeasuredBed
from winkler.foundation.plane import PlaneFoundation
from winkler.foundation.sheared_fields import BodyFields, ShearedFields
from winkler.foundation.springs import Springs
from winkler.io.contact_state import read_contacts, write_contacts
from winkler.io.curves import PlacedCurve, read_curve, read_curves
from winkler.io.tables.bed_table import read_bed
from winkler.io.tables.cross_profile_file import read_cross_profile
from winkler.io.tables.grading_table import read_grading
from winkler.io.tables.law_table import write_law
from winkler.io.tables.path_table import read_path
from winkler.io.tables.profile_table import read_profile, read_section
from winkler.io.tables.relaxation_table import read_creep, read_dynamic, read_relaxation
from winkler.io.tables.scan_table import read_scan
from winkler.io.tables.spectrum_table import read_spectrum
from winkler.io.tables.surface_load_table import read_surface_load
from winkler.io.topography_file import read_topography
from winkler.io.traces import write_trace
from winkler.io.vtk import write_vtk
from winkler.laws.adhesion import DerjaguinMullerToporov, Dugdale, ShortRange
from winkler.laws.crack import RateDependentWork, SaturatingWork
from winkler.laws.current import Current, Voltage, WiedemannFranz
from winkler.laws.film import SurfaceFilm, ThermalInterface
from winkler.laws.friction import Coulomb, StaticKinetic
from winkler.laws.heat import EqualMaximum, EqualMean, FixedShare
from winkler.laws.wear import Archard, PairWear
from winkler.loading import (
    Angle,
    Depth,
    Force,
    HalfWidth,
    LineForce,
    LineOfAction,
    LineShearForce,
    MeanPressure,
    Moment,
    NominalPressure,
    Radius,
    ShearForce,
    Shift,
    Tilt,
    Torque,
)
from winkler.materials.at_temperature import AtTemperature
from winkler.materials.conducting_body import Plated, Rod
from winkler.materials.conductor import ElectricalConductor, ThermalConductor
from winkler.materials.depth_grading import ExponentialGrading, SigmoidalGrading, TabulatedGrading
from winkler.materials.elastic import Elastic, Rigid, TransverselyIsotropic
from winkler.materials.fractional import FractionalZener, PowerLawSolid
from winkler.materials.graded import PowerLawGraded
from winkler.materials.layered import Layer
from winkler.materials.named import (
    NamedElastic,
    NamedElectricalConductor,
    NamedMaterial,
    NamedThermalConductor,
    material,
    material_names,
)
from winkler.materials.relaxation_data import CreepData, DynamicData, RelaxationData
from winkler.materials.spring_and_dashpot import KelvinVoigt, Maxwell, StandardSolid
from winkler.materials.temperature import Arrhenius, WilliamsLandelFerry
from winkler.materials.viscoelastic import GeneralisedKelvin, Prony
from winkler.media.conduction.conductors import ElectricalConductors, HeatConductors
from winkler.media.graded.power_law import GradedHalfSpace
from winkler.media.halfspace import HalfSpace
from winkler.media.layered.coated import CoatedHalfSpace
from winkler.media.layered.depth_graded import DepthGradedHalfSpace
from winkler.media.relaxing.proportional import RelaxingInProportion
from winkler.media.relaxing.viscoelastic import ViscoelasticHalfSpace
from winkler.media.transverse import TransverselyIsotropicHalfSpace
from winkler.path import Path
from winkler.path_steps import Circle, Follow, Hold, Oscillate, Ramp, Start
from winkler.peaks import PeakStress, PlacedStress, peak_stress
from winkler.problems.adhesion.cycle import AdhesiveCycle, AdhesiveCycleSolution
from winkler.problems.adhesion.equilibrium import Equilibrium, EquilibriumCurve
from winkler.problems.adhesion.indentation import AdhesiveIndentation, AdhesiveSolution
from winkler.problems.adhesion.model_choice import which_model
from winkler.problems.adhesion.pull_off import PullOff, PullOffSolution
from winkler.problems.adhesion.shear import AdhesiveShear, AdhesiveShearSolution
from winkler.problems.adhesion.tabor import maugis_parameter, tabor_parameter
from winkler.problems.conduction.bounds import ConductanceBounds, ConductanceBoundsSolution
from winkler.problems.conduction.constriction import Constriction, ConstrictionSolution
from winkler.problems.conduction.fields import CurrentFields, HeatFields, restore_conduction
from winkler.problems.conduction.joule_heating import JouleHeating, JouleHeatingSolution
from winkler.problems.conduction.line_constriction import LineConstriction, LineConstrictionSolution
from winkler.problems.conduction.spots import SpotCluster, SpotClusterSolution
from winkler.problems.conduction.thermal_constriction import ThermalConstriction, ThermalConstrictionSolution
from winkler.problems.friction.bimodal_damping import BimodalDamping, BimodalDampingSolution
from winkler.problems.friction.damping import FrictionDamping, FrictionDampingSolution
from winkler.problems.friction.relaxation_damping import RelaxationDamper, RelaxationDamperSolution
from winkler.problems.friction.spring_march import SpringMarch, SpringTrace
from winkler.problems.friction.tangential import Tangential, TangentialSolution
from winkler.problems.friction.torsion import Torsion, TorsionSolution
from winkler.problems.friction.torsion_fields import TwistedFields
from winkler.problems.heating.elliptic_heating import EllipticFrictionHeating, EllipticFrictionHeatingSolution
from winkler.problems.heating.fretting import FrettingHeat, FrettingHeatSolution
from winkler.problems.heating.line_heating import LineFrictionHeating, LineFrictionHeatingSolution
from winkler.problems.heating.steady import FrictionHeating, FrictionHeatingSolution
from winkler.problems.heating.transient import TransientHeating, TransientHeatingSolution
from winkler.problems.impact.adhesive_impact import AdhesiveImpact, AdhesiveImpactSolution
from winkler.problems.impact.impact import Impact, ImpactSolution
from winkler.problems.line.adhesion import LineAdhesion, LineAdhesionSolution
from winkler.problems.line.indentation import LayeredLineSolution, LineIndentation, LineSolution
from winkler.problems.line.layered_stress import LayerStress
from winkler.problems.line.references import PlateBase, RollerCentre
from winkler.problems.line.shakedown import LineShakedown, LineShakedownSolution
from winkler.problems.line.stress import LineFields
from winkler.problems.line.yielding import LineYieldOnset, LineYieldOnsetSolution
from winkler.problems.line_friction.path import LinePath
from winkler.problems.line_friction.tangential import LineTangential, LineTangentialSolution
from winkler.problems.line_rolling.resistance import LineRollingResistance, LineRollingResistanceSolution
from winkler.problems.line_rolling.start import LineRollingStart, LineRollingStartSolution
from winkler.problems.line_rolling.steady import LineRolling, LineRollingSolution
from winkler.problems.line_strips.periodic import PeriodicIndentation, PeriodicSolution
from winkler.problems.line_strips.profile_contact import LineProfileContact, LineProfileSolution
from winkler.problems.line_viscoelastic.indentation import LineViscoelasticIndentation, LineViscoelasticSolution
from winkler.problems.line_viscoelastic.path import LineForcePath
from winkler.problems.normal.design import design_for_pressure, design_profile
from winkler.problems.normal.elliptic import EllipticIndentation, EllipticSolution
from winkler.problems.normal.elliptic_fields import EllipticFields
from winkler.problems.normal.elliptic_yielding import EllipticYieldOnset, EllipticYieldOnsetSolution
from winkler.problems.normal.indentation import Indentation, IndentationSolution
from winkler.problems.normal.near_round import NearlyRoundIndentation, NearlyRoundSolution
from winkler.problems.normal.yielding import YieldOnset, YieldOnsetSolution
from winkler.problems.particles.contact_law import ContactLaw, ContactLawSolution
from winkler.problems.particles.contacts import Contacts
from winkler.problems.particles.elastic_plastic import ElasticPlasticParticle, ParticleSolution
from winkler.problems.particles.impacts import BallImpacts, BallImpactsSolution
from winkler.problems.particles.trace import ContactTrace
from winkler.problems.profile_pair.patch import ProfilePatch
from winkler.problems.profile_pair.profile_pair import ProfilePair, ProfilePairSolution
from winkler.problems.rollers.roller_contact import RollerContact, RollerSolution
from winkler.problems.rolling.calibration import Kalker, Uncalibrated
from winkler.problems.rolling.creepage import Creepage
from winkler.problems.rolling.kalker import creep_coefficients
from winkler.problems.rolling.oscillating import OscillatingRolling, OscillatingRollingSolution
from winkler.problems.rolling.simplified_theory import SimplifiedRolling, SimplifiedRollingSolution
from winkler.problems.rolling.start import RollingStart, RollingStartSolution
from winkler.problems.rolling.steady import Rolling, RollingSolution
from winkler.problems.rough.elastomer_friction import ElastomerFriction, ElastomerFrictionSolution
from winkler.problems.rough.line_contact import RoughContact, RoughContactSolution
from winkler.problems.rough.line_indentation import RoughIndentation, RoughIndentationSolution
from winkler.problems.rough.persson import area_fraction, mean_separation
from winkler.problems.rough.reduce import Reduction, ReductionSolution, reduce
from winkler.problems.rough.reduced_bed import ReducedBed
from winkler.problems.rough.spring_line import RoughLine
from winkler.problems.rough.surface_conduction import SurfaceConduction, SurfaceConductionSolution
from winkler.problems.rough.surface_contact import SurfaceContact, SurfaceContactSolution
from winkler.problems.subsurface.map_stress import MapStress, MapStressSolution
from winkler.problems.subsurface.surface_load import SurfaceLoad
from winkler.problems.surface_friction.tangential import SurfaceTangential, SurfaceTangentialSolution
from winkler.problems.surface_heating.rolling import SurfaceRollingHeating, SurfaceRollingHeatingSolution
from winkler.problems.surface_heating.sliding import SurfaceFrictionHeating, SurfaceFrictionHeatingSolution
from winkler.problems.surface_rolling.start import SurfaceRollingStart, SurfaceRollingStartSolution
from winkler.problems.surface_rolling.steady import SurfaceRolling, SurfaceRollingSolution
from winkler.problems.viscoelastic.adhesion import ViscoelasticAdhesion, ViscoelasticAdhesionSolution
from winkler.problems.viscoelastic.impact import ViscoelasticImpact, ViscoelasticImpactSolution
from winkler.problems.viscoelastic.indentation import ViscoelasticIndentation, ViscoelasticSolution
from winkler.problems.viscoelastic.material_tests import CreepTest, RelaxationTest
from winkler.problems.viscoelastic.oscillation import HarmonicIndentation
from winkler.problems.viscoelastic.sliding import SlidingResistance, SlidingResistanceSolution
from winkler.problems.viscoelastic.tangential import ViscoelasticTangential, ViscoelasticTangentialSolution
from winkler.problems.wear.elliptic import EllipticWear, EllipticWearSolution
from winkler.problems.wear.fretting import FrettingSolution, FrettingWear
from winkler.problems.wear.limiting_profile import LimitingProfile, LimitingSolution
from winkler.problems.wear.line_fretting import LineFrettingSolution, LineFrettingWear
from winkler.problems.wear.line_limiting_profile import LineLimitingProfile, LineLimitingSolution
from winkler.problems.wear.line_sliding import LineSlidingSolution, LineSlidingWear
from winkler.problems.wear.sliding import SlidingSolution, SlidingWear
from winkler.profiles.area import AreaFunction
from winkler.profiles.conical import Berkovich, Cone, CubeCorner, RoundedCone, SpheroConical, TruncatedCone, Vickers
from winkler.profiles.curved_pair import CurvedPair
from winkler.profiles.designed import Designed
from winkler.profiles.ellipse import ContactEllipse, CurvedBodies
from winkler.profiles.flat import CappedCylinder, Cylinder, FlatPunch
from winkler.profiles.formula import Formula
from winkler.profiles.measured import Measured
from winkler.profiles.power import Paraboloid, PowerLaw
from winkler.profiles.profile import Shape, Sum
from winkler.profiles.roller_ends import CrownedEnds, LogarithmicEnds, RoundedEnds, SharpEnds
from winkler.profiles.rough.line_scan import LineScan
from winkler.profiles.rough.map_spectrum import spectrum_of
from winkler.profiles.rough.random_rough import random_topography
from winkler.profiles.rough.random_surface import RandomTopography
from winkler.profiles.rough.sampled_profile import SampledProfile
from winkler.profiles.rough.spectrum import PowerSpectrum, SelfAffine
from winkler.profiles.rough.spikes import Spikes
from winkler.profiles.rough.topography import Topography
from winkler.profiles.rounded import CappedParaboloid, RoundedPunch, TruncatedParaboloid
from winkler.profiles.sections.cross_profile import CrossProfile
from winkler.profiles.sections.measured_section import FormulaSection, MeasuredSection
from winkler.profiles.sections.mirrored_section import MirroredSection
from winkler.profiles.sections.section import CylinderRow, PunchRow
from winkler.profiles.socket import BallInSocket
from winkler.profiles.sphere import Ellipsoid, Hyperboloid, Sphere
from winkler.profiles.wavy import Wavy
from winkler.program import Program
from winkler.punch_staircase import Staircase, staircase
from winkler.study.report.exchange import to_pandas, to_xarray
from winkler.validity import Assumption, Note, Standing

# packed, a letter a paragraph: one name a line would not fit a page
__all__ = [
    "AdhesiveCycle", "AdhesiveCycleSolution", "AdhesiveImpact", "AdhesiveImpactSolution", "AdhesiveIndentation",
    "AdhesiveShear", "AdhesiveShearSolution", "AdhesiveSolution", "Angle", "Archard", "AreaFunction", "Arrhenius",
    "Assumption", "AtTemperature", "BallImpacts", "BallImpactsSolution", "BallInSocket", "Berkovich", "BimodalDamping",
    "BimodalDampingSolution", "BodyFields", "CalibratedArea", "CappedCylinder", "CappedParaboloid", "Circle",
    "CoatedHalfSpace", "Comparison", "ConductanceBounds", "ConductanceBoundsSolution", "Cone", "Constriction",
    "ConstrictionSolution", "ContactEllipse", "ContactLaw", "ContactLawSolution", "ContactReading", "ContactTrace",
    "Contacts", "Coulomb", "CreepData", "CreepFit", "CreepTest", "Creepage", "CrossProfile", "CrownedEnds",
    "CubeCorner", "Current", "CurrentFields", "CurvedBodies", "CurvedPair", "Cylinder", "CylinderRow", "Depth",
    "DepthGradedHalfSpace", "DerjaguinMullerToporov", "Designed", "Dugdale", "DynamicData", "Elastic",
    "ElasticPlasticParticle", "ElastomerFriction", "ElastomerFrictionSolution", "ElectricalConductor",
    "ElectricalConductors", "Ellipsoid", "EllipticFields", "EllipticFoundation", "EllipticFrictionHeating",
    "EllipticFrictionHeatingSolution", "EllipticIndentation", "EllipticSolution", "EllipticWear",
    "EllipticWearSolution", "EllipticYieldOnset", "EllipticYieldOnsetSolution", "EqualMaximum", "EqualMean",
    "Equilibrium", "EquilibriumCurve", "ExponentialGrading", "Fit", "FitState", "FixedShare", "FlatPunch", "Follow",
    "Force", "ForceCurve", "Formula", "FormulaSection", "Foundation", "FractionalZener", "FrettingHeat",
    "FrettingHeatSolution", "FrettingSolution", "FrettingWear", "FrictionDamping", "FrictionDampingSolution",
    "FrictionHeating", "FrictionHeatingSolution", "GeneralisedKelvin", "GradedHalfSpace", "HalfSpace", "HalfWidth",
    "HarmonicIndentation", "HeatConductors", "HeatFields", "Hold", "Hyperboloid", "Impact", "ImpactSolution",
    "Indentation", "IndentationSolution", "InvalidInput", "JouleHeating", "JouleHeatingSolution", "Kalker",
    "KelvinVoigt", "Layer", "LayerStress", "LayeredLineFoundation", "LayeredLineSolution", "LimitingProfile",
    "LimitingSolution", "LineAdhesion", "LineAdhesionSolution", "LineConstriction", "LineConstrictionSolution",
    "LineFields", "LineForce", "LineForcePath", "LineFoundation", "LineFrettingSolution", "LineFrettingWear",
    "LineFrictionHeating", "LineFrictionHeatingSolution", "LineIndentation", "LineLimitingProfile",
    "LineLimitingSolution", "LineOfAction", "LinePath", "LineProfileContact", "LineProfileSolution", "LineRolling",
    "LineRollingResistance", "LineRollingResistanceSolution", "LineRollingSolution", "LineRollingStart",
    "LineRollingStartSolution", "LineScan", "LineShakedown", "LineShakedownSolution", "LineShearForce",
    "LineSlidingSolution", "LineSlidingWear", "LineSolution", "LineTangential", "LineTangentialSolution",
    "LineViscoelasticIndentation", "LineViscoelasticSolution", "LineYieldOnset", "LineYieldOnsetSolution",
    "LogarithmicEnds", "MapStress", "MapStressSolution", "Maxwell", "MeanPressure", "Measured", "MeasuredBed",
    "MeasuredSection", "MirroredSection", "Moment", "NamedElastic", "NamedElectricalConductor", "NamedMaterial",
    "NamedThermalConductor", "NearlyRoundIndentation", "NearlyRoundSolution", "NominalPressure", "NotConverged",
    "Note", "OliverPharr", "OliverPharrSolution", "Oscillate", "OscillatingRolling", "OscillatingRollingSolution",
    "OutsideValidity", "PairWear", "Paraboloid", "ParticleSolution", "Path", "PeakStress", "PeriodicIndentation",
    "PeriodicSolution", "PlacedCurve", "PlacedStress", "PlaneFoundation", "PlateBase", "Plated", "PowerLaw",
    "PowerLawGraded", "PowerLawSolid", "PowerSpectrum", "ProfilePair", "ProfilePairSolution", "ProfilePatch",
    "Program", "Prony", "PullOff", "PullOffSolution", "PunchRow", "Radius", "Ramp", "RandomTopography",
    "RateDependentWork", "ReducedBed", "Reduction", "ReductionSolution", "RelaxationDamper",
    "RelaxationDamperSolution", "RelaxationData", "RelaxationTest", "RelaxingInProportion", "Rigid", "Rod",
    "RollerCentre", "RollerContact", "RollerSolution", "Rolling", "RollingSolution", "RollingStart",
    "RollingStartSolution", "RoughContact", "RoughContactSolution", "RoughIndentation", "RoughIndentationSolution",
    "RoughLine", "RoundedCone", "RoundedEnds", "RoundedPunch", "SampledProfile", "SaturatingWork", "Segment",
    "SegmentKind", "SelfAffine", "Shape", "SharpEnds", "ShearForce", "ShearedFields", "Shift", "ShortRange",
    "SigmoidalGrading", "SimplifiedRolling", "SimplifiedRollingSolution", "SlidingResistance",
    "SlidingResistanceSolution", "SlidingSolution", "SlidingWear", "Sphere", "SpheroConical", "Spikes", "SpotCluster",
    "SpotClusterSolution", "SpringMarch", "SpringTrace", "Springs", "Staircase", "StandardSolid", "Standing", "Start",
    "StaticKinetic", "SubsurfaceFields", "Sum", "SurfaceConduction", "SurfaceConductionSolution", "SurfaceContact",
    "SurfaceContactSolution", "SurfaceFields", "SurfaceFilm", "SurfaceFrictionHeating",
    "SurfaceFrictionHeatingSolution", "SurfaceLoad", "SurfaceRolling", "SurfaceRollingHeating",
    "SurfaceRollingHeatingSolution", "SurfaceRollingSolution", "SurfaceRollingStart", "SurfaceRollingStartSolution",
    "SurfaceTangential", "SurfaceTangentialSolution", "TabulatedGrading", "Tangential", "TangentialSolution",
    "ThermalConductor", "ThermalConstriction", "ThermalConstrictionSolution", "ThermalInterface", "Tilt", "Topography",
    "Torque", "Torsion", "TorsionSolution", "TransientHeating", "TransientHeatingSolution", "TransverselyIsotropic",
    "TransverselyIsotropicHalfSpace", "TruncatedCone", "TruncatedParaboloid", "TwistedFields", "Uncalibrated",
    "Vickers", "ViscoelasticAdhesion", "ViscoelasticAdhesionSolution", "ViscoelasticFit", "ViscoelasticHalfSpace",
    "ViscoelasticImpact", "ViscoelasticImpactSolution", "ViscoelasticIndentation", "ViscoelasticSolution",
    "ViscoelasticTangential", "ViscoelasticTangentialSolution", "Voltage", "Wavy", "WiedemannFranz",
    "WilliamsLandelFerry", "WinklerError", "YieldOnset", "YieldOnsetSolution", "area_fraction", "compare",
    "compare_terms", "contact_reading", "creep_coefficients", "design_for_pressure", "design_profile", "fit",
    "fit_steps", "intercept_factor", "material", "material_names", "maugis_parameter", "mean_separation",
    "peak_stress", "random_topography", "read_bed", "read_contacts", "read_creep", "read_cross_profile", "read_curve",
    "read_curves", "read_dynamic", "read_grading", "read_path", "read_profile", "read_relaxation", "read_scan",
    "read_section", "read_spectrum", "read_surface_load", "read_topography", "reduce", "relaxation_band", "restore",
    "restore_body", "restore_conduction", "restore_shift", "sample_young", "spectrum_of", "staircase",
    "tabor_parameter", "to_pandas", "to_xarray", "which_model", "write_contacts", "write_law", "write_trace",
    "write_vtk",
]  # fmt: skip
