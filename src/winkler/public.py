"""What `import winkler` offers beside the problems, each name from the module where it is defined.

The package reads these imports and those of `winkler.public_problems` without running them: a name is loaded from its
module when it is first used.
"""

from winkler.calculators.widget import widget
from winkler.errors import InvalidInput, NotConverged, OutsideValidity, WinklerError
from winkler.exporting.export import ExportedLaw, export, write_export
from winkler.exporting.many.contact_array import ContactArray
from winkler.fields import SubsurfaceFields, SurfaceFields, restore, restore_body, restore_shift
from winkler.fitting.compare import Comparison, compare
from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.curves.events.kinds import CurveEvent, CurveEvents, EventKind
from winkler.fitting.curves.segments import Segment, SegmentKind
from winkler.fitting.examined.calibrated import CalibrationShares, calibration_shares
from winkler.fitting.examined.over_depth import DepthSeries, over_depth
from winkler.fitting.fit import Fit, fit, fit_steps
from winkler.fitting.holds.depth_scaling import DepthScaling, depth_scaling
from winkler.fitting.holds.held_contacts import HeldContacts, HeldContactsSolution
from winkler.fitting.holds.held_force import HeldForce
from winkler.fitting.holds.poroelastic import PoroelasticFit, fit_poroelastic
from winkler.fitting.logs.contact_resistance import MeasuredConstriction, MeasuredConstrictionSolution, ResistanceLog
from winkler.fitting.logs.friction_log import FrictionLog
from winkler.fitting.logs.friction_loops import FrictionLoops, FrictionLoopsSolution
from winkler.fitting.logs.runs import BounceTimes, PinOnDisc
from winkler.fitting.nanoindentation.calibration import calibrate_indenter
from winkler.fitting.nanoindentation.calibration_solution import IndenterCalibration
from winkler.fitting.nanoindentation.continuous import ContinuousIndentation, ContinuousIndentationSolution
from winkler.fitting.nanoindentation.indenter import CalibratedIndenter
from winkler.fitting.nanoindentation.measurement import Nanoindentation, NanoindentationSolution
from winkler.fitting.nanoindentation.pop_ins import PopInStatistics, first_yield_stress, pop_in_statistics
from winkler.fitting.nanoindentation.quantities import IndentationQuantities, indentation_quantities
from winkler.fitting.nanoindentation.reference_samples import ReferenceSample
from winkler.fitting.nanoindentation.repetition import RepeatedMean, repeated_mean
from winkler.fitting.nanoindentation.thermal_drift import ThermalDrift, found_drift
from winkler.fitting.nanoindentation.zero_point import ZeroPoint, found_zero_point
from winkler.fitting.outcome import CreepFit, ViscoelasticFit
from winkler.fitting.relaxation_terms import compare_terms
from winkler.fitting.search import FitState
from winkler.fitting.several.groups import GroupRatio, ratio_of
from winkler.fitting.several.joint import JointFit
from winkler.fitting.several.population import Population, population
from winkler.fitting.several.together import fit_together
from winkler.fitting.unloading.contact_reading import (
    CalibratedArea,
    ContactReading,
    contact_reading,
    intercept_factor,
    sample_young,
)
from winkler.fitting.unloading.continuous_stiffness import ContinuousStiffness
from winkler.fitting.unloading.oliver_pharr import OliverPharr, OliverPharrSolution
from winkler.fitting.viscoelastic.band import relaxation_band
from winkler.foundation.elliptic import EllipticFoundation
from winkler.foundation.foundation import Foundation
from winkler.foundation.layered_line import LayeredLineFoundation
from winkler.foundation.line import LineFoundation
from winkler.foundation.measured import MeasuredBed
from winkler.foundation.plane import PlaneFoundation
from winkler.foundation.power_law_line import PowerLawLineFoundation
from winkler.foundation.sheared_fields import BodyFields, ShearedFields
from winkler.foundation.springs import Springs
from winkler.io.contact_state import read_contacts, write_contacts
from winkler.io.curves import PlacedCurve, read_curve, read_curves
from winkler.io.indenter_file import read_indenter, write_indenter
from winkler.io.logs.log_tables import read_bounces, read_friction_log, read_pin, read_resistance_log
from winkler.io.surface_interaction import write_surface_interaction
from winkler.io.tables.bed_table import read_bed
from winkler.io.tables.cross_profile_file import read_cross_profile
from winkler.io.tables.grading_table import read_grading
from winkler.io.tables.held_force_table import read_held_force
from winkler.io.tables.law_table import write_law
from winkler.io.tables.path_table import read_path
from winkler.io.tables.profile_pair_files import read_profile_pair
from winkler.io.tables.profile_table import read_profile, read_section
from winkler.io.tables.relaxation_table import read_creep, read_dynamic, read_relaxation
from winkler.io.tables.scan_table import read_scan
from winkler.io.tables.spectrum_table import read_spectrum
from winkler.io.tables.surface_load_table import read_surface_load
from winkler.io.tables.sweeps_table import read_dynamic_sweeps, read_relaxation_sweeps
from winkler.io.topography_file import read_topography
from winkler.io.traces import write_trace
from winkler.io.vtk import write_vtk
from winkler.laws.adhesion import DerjaguinMullerToporov, Dugdale, ShortRange
from winkler.laws.attraction import ExponentialAttraction, LennardJones
from winkler.laws.crack import RateDependentWork, SaturatingWork
from winkler.laws.current import Current, Voltage, WiedemannFranz
from winkler.laws.film import SurfaceFilm, ThermalInterface
from winkler.laws.friction import Coulomb, StaticKinetic
from winkler.laws.heat import EqualMaximum, EqualMean, FixedShare
from winkler.laws.varying_friction import ExponentialSlipWeakening, FallingFriction, LinearSlipWeakening
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
from winkler.materials.hardening import LinearHardening, PowerHardening
from winkler.materials.layered import Layer, StackLayer
from winkler.materials.named import (
    NamedElastic,
    NamedElectricalConductor,
    NamedMaterial,
    NamedThermalConductor,
    material,
    material_names,
)
from winkler.materials.relaxation_data import CreepData, DynamicData, RelaxationData
from winkler.materials.relaxing_layer import ViscoelasticLayer
from winkler.materials.spring_and_dashpot import KelvinVoigt, Maxwell, StandardSolid
from winkler.materials.sweeps import DynamicSweeps, RelaxationSweeps
from winkler.materials.temperature import Arrhenius, WilliamsLandelFerry
from winkler.materials.viscoelastic import GeneralisedKelvin, Prony
from winkler.media.conduction.conductors import ElectricalConductors, HeatConductors
from winkler.media.graded.power_law import GradedHalfSpace
from winkler.media.halfspace import HalfSpace
from winkler.media.layered.coated import CoatedHalfSpace, SlidingFilm, StackedHalfSpace
from winkler.media.layered.depth_graded import DepthGradedHalfSpace
from winkler.media.relaxing.layered import ViscoelasticCoatedHalfSpace
from winkler.media.relaxing.poroelastic import PoroelasticFilm
from winkler.media.relaxing.proportional import RelaxingInProportion
from winkler.media.relaxing.viscoelastic import ViscoelasticHalfSpace
from winkler.media.transverse import TransverselyIsotropicHalfSpace
from winkler.path import Path
from winkler.path_steps import Circle, Follow, Hold, Oscillate, Ramp, Start
from winkler.peaks import PeakStress, PlacedStress, peak_stress
from winkler.profiles.area import AreaFunction
from winkler.profiles.calibrated_tip import CalibratedTip, TabulatedTip
from winkler.profiles.conical import Berkovich, Cone, CubeCorner, RoundedCone, SpheroConical, TruncatedCone, Vickers
from winkler.profiles.curved_pair import CurvedPair
from winkler.profiles.designed import Designed
from winkler.profiles.ellipse import ContactEllipse, CurvedBodies
from winkler.profiles.flat import CappedCylinder, Cylinder, FlatPunch
from winkler.profiles.formula import Formula
from winkler.profiles.measured import Measured
from winkler.profiles.power import Paraboloid, PowerLaw
from winkler.profiles.profile import Shape, Sum
from winkler.profiles.pyramids.pyramid import Pyramid, PyramidByEdges
from winkler.profiles.pyramids.rounded_pyramid import RoundedPyramid
from winkler.profiles.roller_ends import CrownedEnds, LogarithmicEnds, RoundedEnds, SharpEnds
from winkler.profiles.rough.correlation import CorrelationLengths, correlation_lengths
from winkler.profiles.rough.line_scan import LineScan
from winkler.profiles.rough.map_spectrum import spectrum_of
from winkler.profiles.rough.map_statistics import MapStatistics, bearing_heights, correlation_length, map_statistics
from winkler.profiles.rough.random_rough import random_topography
from winkler.profiles.rough.random_surface import RandomTopography
from winkler.profiles.rough.rough_profile import RoughProfile
from winkler.profiles.rough.sampled_profile import SampledProfile
from winkler.profiles.rough.spectrum import PowerSpectrum, SelfAffine
from winkler.profiles.rough.spikes import Spikes
from winkler.profiles.rough.tip_limit import tip_limit
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

__all__ = [
    "Angle", "Archard", "AreaFunction", "Arrhenius", "Assumption", "AtTemperature", "BallInSocket", "Berkovich",
    "BodyFields", "BounceTimes", "CalibratedArea", "CalibratedIndenter", "CalibratedTip", "CalibrationShares",
    "CappedCylinder", "CappedParaboloid", "Circle", "CoatedHalfSpace", "Comparison", "Cone", "ContactArray",
    "ContactEllipse", "ContactReading", "ContinuousIndentation", "ContinuousIndentationSolution", "ContinuousStiffness",
    "CorrelationLengths", "Coulomb", "CreepData", "CreepFit", "CrossProfile", "CrownedEnds", "CubeCorner", "Current",
    "CurveEvent", "CurveEvents", "CurvedBodies", "CurvedPair", "Cylinder", "CylinderRow", "Depth",
    "DepthGradedHalfSpace", "DepthScaling", "DepthSeries", "DerjaguinMullerToporov", "Designed", "Dugdale",
    "DynamicData", "DynamicSweeps", "Elastic", "ElectricalConductor", "ElectricalConductors", "Ellipsoid",
    "EllipticFoundation", "EqualMaximum", "EqualMean", "EventKind", "ExponentialAttraction", "ExponentialGrading",
    "ExponentialSlipWeakening", "ExportedLaw", "FallingFriction", "Fit", "FitState", "FixedShare", "FlatPunch",
    "Follow", "Force", "ForceCurve", "Formula", "FormulaSection", "Foundation", "FractionalZener", "FrictionLog",
    "FrictionLoops", "FrictionLoopsSolution", "GeneralisedKelvin", "GradedHalfSpace", "GroupRatio", "HalfSpace",
    "HalfWidth", "HeatConductors", "HeldContacts", "HeldContactsSolution", "HeldForce", "Hold", "Hyperboloid",
    "IndentationQuantities", "IndenterCalibration", "InvalidInput", "JointFit", "KelvinVoigt", "Layer",
    "LayeredLineFoundation", "LennardJones", "LineForce", "LineFoundation", "LineOfAction", "LineScan",
    "LineShearForce", "LinearHardening", "LinearSlipWeakening", "LogarithmicEnds", "MapStatistics", "Maxwell",
    "MeanPressure", "Measured", "MeasuredBed", "MeasuredConstriction", "MeasuredConstrictionSolution",
    "MeasuredSection", "MirroredSection", "Moment", "NamedElastic", "NamedElectricalConductor", "NamedMaterial",
    "NamedThermalConductor", "Nanoindentation", "NanoindentationSolution", "NominalPressure", "NotConverged", "Note",
    "OliverPharr", "OliverPharrSolution", "Oscillate", "OutsideValidity", "PairWear", "Paraboloid", "Path",
    "PeakStress", "PinOnDisc", "PlacedCurve", "PlacedStress", "PlaneFoundation", "Plated", "PopInStatistics",
    "Population", "PoroelasticFilm", "PoroelasticFit", "PowerHardening", "PowerLaw", "PowerLawGraded",
    "PowerLawLineFoundation", "PowerLawSolid", "PowerSpectrum", "Program", "Prony", "PunchRow", "Pyramid",
    "PyramidByEdges", "Radius", "Ramp", "RandomTopography", "RateDependentWork", "ReferenceSample", "RelaxationData",
    "RelaxationSweeps", "RelaxingInProportion", "RepeatedMean", "ResistanceLog", "Rigid", "Rod", "RoughProfile",
    "RoundedCone", "RoundedEnds", "RoundedPunch", "RoundedPyramid", "SampledProfile", "SaturatingWork", "Segment",
    "SegmentKind", "SelfAffine", "Shape", "SharpEnds", "ShearForce", "ShearedFields", "Shift", "ShortRange",
    "SigmoidalGrading", "SlidingFilm", "Sphere", "SpheroConical", "Spikes", "Springs", "StackLayer", "StackedHalfSpace",
    "Staircase", "StandardSolid", "Standing", "Start", "StaticKinetic", "SubsurfaceFields", "Sum", "SurfaceFields",
    "SurfaceFilm", "TabulatedGrading", "TabulatedTip", "ThermalConductor", "ThermalDrift", "ThermalInterface", "Tilt",
    "Topography", "Torque", "TransverselyIsotropic", "TransverselyIsotropicHalfSpace", "TruncatedCone",
    "TruncatedParaboloid", "Vickers", "ViscoelasticCoatedHalfSpace", "ViscoelasticFit", "ViscoelasticHalfSpace",
    "ViscoelasticLayer", "Voltage", "Wavy", "WiedemannFranz", "WilliamsLandelFerry", "WinklerError", "ZeroPoint",
    "bearing_heights", "calibrate_indenter", "calibration_shares", "compare", "compare_terms", "contact_reading",
    "correlation_length", "correlation_lengths", "depth_scaling", "export", "first_yield_stress", "fit",
    "fit_poroelastic", "fit_steps", "fit_together", "found_drift", "found_zero_point", "indentation_quantities",
    "intercept_factor", "map_statistics", "material", "material_names", "over_depth", "peak_stress",
    "pop_in_statistics", "population", "random_topography", "ratio_of", "read_bed", "read_bounces", "read_contacts",
    "read_creep", "read_cross_profile", "read_curve", "read_curves", "read_dynamic", "read_dynamic_sweeps",
    "read_friction_log", "read_grading", "read_held_force", "read_indenter", "read_path", "read_pin", "read_profile",
    "read_profile_pair", "read_relaxation", "read_relaxation_sweeps", "read_resistance_log", "read_scan",
    "read_section", "read_spectrum", "read_surface_load", "read_topography", "relaxation_band", "repeated_mean",
    "restore", "restore_body", "restore_shift", "sample_young", "spectrum_of", "staircase", "tip_limit", "to_pandas",
    "to_xarray", "widget", "write_contacts", "write_export", "write_indenter", "write_law", "write_surface_interaction",
    "write_trace", "write_vtk",
]  # fmt: skip
