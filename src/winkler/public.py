"""What `import winkler` offers, each name from the module where it is defined.

The package reads these imports without running them: a name is loaded from its module when it is first used.
"""

from winkler.calculators.widget import widget
from winkler.exporting.export import ExportedLaw, export, write_export
from winkler.exporting.many.contact_array import ContactArray
from winkler.fields.peaks import PeakStress, PlacedStress, peak_stress
from winkler.fields.punch_staircase import Staircase, staircase
from winkler.fields.restoration import SubsurfaceFields, SurfaceFields, restore, restore_body, restore_shift
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
from winkler.loading.loads import (
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
from winkler.loading.path import Path
from winkler.loading.path_steps import Circle, Follow, Hold, Oscillate, Ramp, Start
from winkler.loading.program import Program
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
from winkler.problems.adhesion.cycle import AdhesiveCycle, AdhesiveCycleSolution
from winkler.problems.adhesion.equilibrium import Equilibrium, EquilibriumCurve
from winkler.problems.adhesion.indentation import AdhesiveIndentation, AdhesiveSolution
from winkler.problems.adhesion.model_choice import which_model
from winkler.problems.adhesion.pull_off import PullOff, PullOffSolution
from winkler.problems.adhesion.shear import AdhesiveShear, AdhesiveShearSolution
from winkler.problems.adhesion.tabor import maugis_parameter, tabor_parameter
from winkler.problems.assumptions.pyramid_film import pyramid_layer_error
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
from winkler.problems.friction.tangential import Tangential, TangentialSolution
from winkler.problems.friction.torsion import Torsion, TorsionSolution
from winkler.problems.friction.torsion_fields import TwistedFields
from winkler.problems.heating.band_heating import BandHeating, BandHeatingSolution
from winkler.problems.heating.fretting import FrettingHeat, FrettingHeatSolution
from winkler.problems.heating.line_heating import LineFrictionHeating, LineFrictionHeatingSolution
from winkler.problems.heating.steady import FrictionHeating, FrictionHeatingSolution
from winkler.problems.heating.transient import TransientHeating, TransientHeatingSolution
from winkler.problems.impact.adhesive_impact import AdhesiveImpact, AdhesiveImpactSolution
from winkler.problems.impact.impact import Impact, ImpactSolution
from winkler.problems.line.adhesion import LayeredLineAdhesionSolution, LineAdhesion, LineAdhesionSolution
from winkler.problems.line.indentation import (
    LayeredLineSolution,
    LineIndentation,
    LineSolution,
    PowerLawLineSolution,
)
from winkler.problems.line.layered_stress import LayerStress
from winkler.problems.line.references import PlateBase, RollerCentre
from winkler.problems.line.shakedown import LineShakedown, LineShakedownSolution
from winkler.problems.line.stress import LineFields
from winkler.problems.line.yielding import LinePartOnset, LineYieldOnset, LineYieldOnsetSolution
from winkler.problems.line_friction.path import LinePath
from winkler.problems.line_friction.tangential import LineTangential, LineTangentialSolution
from winkler.problems.line_rolling.resistance import LineRollingResistance, LineRollingResistanceSolution
from winkler.problems.line_rolling.start import LineRollingStart, LineRollingStartSolution
from winkler.problems.line_rolling.steady import LineRolling, LineRollingSolution
from winkler.problems.line_strips.periodic import PeriodicIndentation, PeriodicSolution
from winkler.problems.line_strips.profile_contact import LineProfileContact, LineProfileSolution
from winkler.problems.line_viscoelastic.indentation import LineViscoelasticIndentation, LineViscoelasticSolution
from winkler.problems.line_viscoelastic.path import LineForcePath
from winkler.problems.master_curves.master_curve import MasterCurve, MasterCurveSolution, ShiftedBy
from winkler.problems.master_curves.relaxation_spectrum import RelaxationSpectrum, SpectrumSolution
from winkler.problems.method import Method
from winkler.problems.normal.design import design_for_pressure, design_profile
from winkler.problems.normal.elliptic import EllipticIndentation, EllipticSolution
from winkler.problems.normal.elliptic_fields import EllipticFields
from winkler.problems.normal.elliptic_yielding import EllipticYieldOnset, EllipticYieldOnsetSolution
from winkler.problems.normal.indentation import Indentation, IndentationSolution
from winkler.problems.normal.near_round import NearlyRoundIndentation, NearlyRoundSolution
from winkler.problems.normal.onset.part_onset import EllipticPartOnset, PartOnset
from winkler.problems.normal.yielding import YieldOnset, YieldOnsetSolution
from winkler.problems.particles.contact_law import ContactLaw, ContactLawSolution
from winkler.problems.particles.contacts import Contacts
from winkler.problems.particles.elastic_plastic import ElasticPlasticParticle, ParticleSolution
from winkler.problems.particles.impacts import BallImpacts, BallImpactsSolution
from winkler.problems.particles.trace import ContactTrace
from winkler.problems.plastic.dent_limit import DentLimit, DentLimitSolution
from winkler.problems.plastic.impact import PlasticImpact, PlasticImpactSolution
from winkler.problems.plastic.indentation import PlasticIndentation, PlasticSolution
from winkler.problems.plastic.line_indentation import LinePlasticIndentation, LinePlasticSolution
from winkler.problems.plastic.strength_from_dent import (
    Blow,
    Restitution,
    StrengthFromDent,
    StrengthFromDentSolution,
)
from winkler.problems.poroelastic.held import PoroelasticRelaxation, PoroelasticSolution
from winkler.problems.pressed_maps.flow_factors import FlowFactors, flow_factors
from winkler.problems.pressed_maps.seal import Seal, SealSolution
from winkler.problems.pressed_maps.thermal_joint import ThermalJoint, ThermalJointSolution
from winkler.problems.pressed_maps.true_area import TrueArea, TrueAreaSolution
from winkler.problems.pressed_shape.surface_load import SurfaceLoad
from winkler.problems.profile_pair.pair_rolling import ProfilePairRolling, ProfilePairRollingSolution
from winkler.problems.profile_pair.patch import ProfilePatch
from winkler.problems.profile_pair.profile_pair import ProfilePair, ProfilePairSolution
from winkler.problems.profile_pair.rolled_patch import RolledPatch
from winkler.problems.rollers.roller_contact import RollerContact, RollerSolution
from winkler.problems.rolling.calibration import Kalker, Uncalibrated
from winkler.problems.rolling.creepage import Creepage
from winkler.problems.rolling.kalker import creep_coefficients
from winkler.problems.rolling.linear_theory import linear_creep_coefficients
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
from winkler.problems.subsurface.contact_stress import ContactStress, ContactStressSolution
from winkler.problems.subsurface.map_stress import MapStress, MapStressSolution
from winkler.problems.surface_adhesion.adhesion import SurfaceAdhesion, SurfaceAdhesionSolution
from winkler.problems.surface_current.constriction import SurfaceConstriction, SurfaceConstrictionSolution
from winkler.problems.surface_friction.joint import JointStiffness, JointStiffnessSolution
from winkler.problems.surface_friction.reduced import ReducedFriction, ReducedFrictionSolution
from winkler.problems.surface_friction.tangential import SurfaceTangential, SurfaceTangentialSolution
from winkler.problems.surface_heating.steady import SurfaceFrictionHeating, SurfaceFrictionHeatingSolution
from winkler.problems.surface_rolling.creep_force import CreepForce, Spin
from winkler.problems.surface_rolling.start import SurfaceRollingStart, SurfaceRollingStartSolution
from winkler.problems.surface_rolling.steady import SurfaceRolling, SurfaceRollingSolution
from winkler.problems.surface_wear.wear import SurfaceWear, SurfaceWearSolution
from winkler.problems.viscoelastic.adhesion import ViscoelasticAdhesion, ViscoelasticAdhesionSolution
from winkler.problems.viscoelastic.impact import ViscoelasticImpact, ViscoelasticImpactSolution
from winkler.problems.viscoelastic.indentation import ViscoelasticIndentation, ViscoelasticSolution
from winkler.problems.viscoelastic.material_tests import CreepTest, RelaxationTest
from winkler.problems.viscoelastic.oscillation import HarmonicIndentation
from winkler.problems.viscoelastic.sliding import SlidingResistance, SlidingResistanceSolution
from winkler.problems.wear.elliptic import EllipticWear, EllipticWearSolution
from winkler.problems.wear.fretting import FrettingSolution, FrettingWear
from winkler.problems.wear.limiting_profile import LimitingProfile, LimitingSolution
from winkler.problems.wear.line_fretting import LineFrettingSolution, LineFrettingWear
from winkler.problems.wear.line_limiting_profile import (
    LayeredLineLimitingSolution,
    LineLimitingProfile,
    LineLimitingSolution,
)
from winkler.problems.wear.line_sliding import LineSlidingSolution, LineSlidingWear
from winkler.problems.wear.sliding import SlidingSolution, SlidingWear
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
from winkler.study.report.exchange import to_pandas, to_xarray
from winkler.values.errors import InvalidInput, NotConverged, OutsideValidity, WinklerError
from winkler.values.validity import Assumption, Note, Standing

__all__ = [
    "AdhesiveCycle", "AdhesiveCycleSolution", "AdhesiveImpact", "AdhesiveImpactSolution", "AdhesiveIndentation",
    "AdhesiveShear", "AdhesiveShearSolution", "AdhesiveSolution", "Angle", "Archard", "AreaFunction", "Arrhenius",
    "Assumption", "AtTemperature", "BallImpacts", "BallImpactsSolution", "BallInSocket", "BandHeating",
    "BandHeatingSolution", "Berkovich", "BimodalDamping", "BimodalDampingSolution", "Blow", "BodyFields",
    "BounceTimes",
    "CalibratedArea", "CalibratedIndenter", "CalibratedTip", "CalibrationShares", "CappedCylinder",
    "CappedParaboloid", "Circle", "CoatedHalfSpace", "Comparison", "ConductanceBounds", "ConductanceBoundsSolution",
    "Cone", "Constriction", "ConstrictionSolution", "ContactArray", "ContactEllipse", "ContactLaw",
    "ContactLawSolution", "ContactReading", "ContactStress", "ContactStressSolution", "ContactTrace", "Contacts",
    "ContinuousIndentation", "ContinuousIndentationSolution", "ContinuousStiffness", "CorrelationLengths", "Coulomb",
    "CreepData", "CreepFit", "CreepForce", "CreepTest", "Creepage", "CrossProfile", "CrownedEnds", "CubeCorner",
    "Current", "CurrentFields", "CurveEvent", "CurveEvents", "CurvedBodies", "CurvedPair", "Cylinder", "CylinderRow",
    "DentLimit", "DentLimitSolution", "Depth", "DepthGradedHalfSpace", "DepthScaling", "DepthSeries",
    "DerjaguinMullerToporov", "Designed", "Dugdale", "DynamicData", "DynamicSweeps", "Elastic",
    "ElasticPlasticParticle", "ElastomerFriction", "ElastomerFrictionSolution", "ElectricalConductor",
    "ElectricalConductors", "Ellipsoid", "EllipticFields", "EllipticFoundation",
    "EllipticIndentation", "EllipticPartOnset", "EllipticSolution", "EllipticWear",
    "EllipticWearSolution", "EllipticYieldOnset", "EllipticYieldOnsetSolution", "EqualMaximum", "EqualMean",
    "Equilibrium", "EquilibriumCurve", "EventKind", "ExponentialAttraction", "ExponentialGrading",
    "ExponentialSlipWeakening", "ExportedLaw", "FallingFriction", "Fit", "FitState", "FixedShare", "FlatPunch",
    "FlowFactors", "Follow", "Force", "ForceCurve", "Formula", "FormulaSection", "Foundation", "FractionalZener",
    "FrettingHeat", "FrettingHeatSolution", "FrettingSolution", "FrettingWear", "FrictionDamping",
    "FrictionDampingSolution", "FrictionHeating", "FrictionHeatingSolution", "FrictionLog", "FrictionLoops",
    "FrictionLoopsSolution", "GeneralisedKelvin", "GradedHalfSpace", "GroupRatio", "HalfSpace", "HalfWidth",
    "HarmonicIndentation", "HeatConductors", "HeatFields", "HeldContacts", "HeldContactsSolution", "HeldForce",
    "Hold", "Hyperboloid", "Impact", "ImpactSolution", "Indentation", "IndentationQuantities", "IndentationSolution",
    "IndenterCalibration", "InvalidInput", "JointFit", "JointStiffness", "JointStiffnessSolution", "JouleHeating",
    "JouleHeatingSolution", "Kalker", "KelvinVoigt", "Layer", "LayerStress", "LayeredLineAdhesionSolution",
    "LayeredLineFoundation", "LayeredLineLimitingSolution", "LayeredLineSolution", "LennardJones", "LimitingProfile",
    "LimitingSolution", "LineAdhesion", "LineAdhesionSolution", "LineConstriction", "LineConstrictionSolution",
    "LineFields", "LineForce", "LineForcePath", "LineFoundation", "LineFrettingSolution", "LineFrettingWear",
    "LineFrictionHeating", "LineFrictionHeatingSolution", "LineIndentation", "LineLimitingProfile",
    "LineLimitingSolution", "LineOfAction", "LinePartOnset", "LinePath",
    "LinePlasticIndentation", "LinePlasticSolution", "LineProfileContact", "LineProfileSolution",
    "LineRolling", "LineRollingResistance", "LineRollingResistanceSolution", "LineRollingSolution",
    "LineRollingStart", "LineRollingStartSolution", "LineScan", "LineShakedown", "LineShakedownSolution",
    "LineShearForce", "LineSlidingSolution", "LineSlidingWear", "LineSolution", "LineTangential",
    "LineTangentialSolution", "LineViscoelasticIndentation", "LineViscoelasticSolution", "LineYieldOnset",
    "LineYieldOnsetSolution", "LinearHardening", "LinearSlipWeakening", "LogarithmicEnds", "MapStatistics",
    "MapStress", "MapStressSolution", "MasterCurve", "MasterCurveSolution", "Maxwell", "MeanPressure", "Measured",
    "MeasuredBed", "MeasuredConstriction", "MeasuredConstrictionSolution", "MeasuredSection", "Method",
    "MirroredSection", "Moment", "NamedElastic", "NamedElectricalConductor", "NamedMaterial", "NamedThermalConductor",
    "Nanoindentation", "NanoindentationSolution", "NearlyRoundIndentation", "NearlyRoundSolution", "NominalPressure",
    "NotConverged", "Note", "OliverPharr", "OliverPharrSolution", "Oscillate", "OscillatingRolling",
    "OscillatingRollingSolution", "OutsideValidity", "PairWear", "Paraboloid", "PartOnset", "ParticleSolution",
    "Path", "PeakStress", "PeriodicIndentation", "PeriodicSolution", "PinOnDisc", "PlacedCurve", "PlacedStress",
    "PlaneFoundation", "PlasticImpact", "PlasticImpactSolution", "PlasticIndentation", "PlasticSolution", "PlateBase",
    "Plated", "PopInStatistics", "Population", "PoroelasticFilm", "PoroelasticFit", "PoroelasticRelaxation",
    "PoroelasticSolution", "PowerHardening", "PowerLaw", "PowerLawGraded", "PowerLawLineFoundation",
    "PowerLawLineSolution", "PowerLawSolid", "PowerSpectrum", "ProfilePair", "ProfilePairRolling",
    "ProfilePairRollingSolution", "ProfilePairSolution", "ProfilePatch", "Program", "Prony", "PullOff",
    "PullOffSolution", "PunchRow", "Pyramid", "PyramidByEdges", "Radius", "Ramp", "RandomTopography",
    "RateDependentWork", "ReducedBed", "ReducedFriction", "ReducedFrictionSolution", "Reduction", "ReductionSolution",
    "ReferenceSample", "RelaxationDamper", "RelaxationDamperSolution", "RelaxationData", "RelaxationSpectrum",
    "RelaxationSweeps", "RelaxationTest", "RelaxingInProportion", "RepeatedMean", "ResistanceLog", "Restitution",
    "Rigid", "Rod",
    "RolledPatch", "RollerCentre", "RollerContact", "RollerSolution", "Rolling", "RollingSolution", "RollingStart",
    "RollingStartSolution", "RoughContact", "RoughContactSolution", "RoughIndentation", "RoughIndentationSolution",
    "RoughLine", "RoughProfile", "RoundedCone", "RoundedEnds", "RoundedPunch", "RoundedPyramid", "SampledProfile",
    "SaturatingWork", "Seal", "SealSolution", "Segment", "SegmentKind", "SelfAffine", "Shape", "SharpEnds",
    "ShearForce", "ShearedFields", "Shift", "ShiftedBy", "ShortRange", "SigmoidalGrading", "SimplifiedRolling",
    "SimplifiedRollingSolution", "SlidingFilm", "SlidingResistance", "SlidingResistanceSolution", "SlidingSolution",
    "SlidingWear", "SpectrumSolution", "Sphere", "SpheroConical", "Spikes", "Spin", "SpotCluster",
    "SpotClusterSolution", "Springs", "StackLayer", "StackedHalfSpace", "Staircase",
    "StandardSolid", "Standing", "Start", "StaticKinetic", "StrengthFromDent", "StrengthFromDentSolution",
    "SubsurfaceFields", "Sum", "SurfaceAdhesion", "SurfaceAdhesionSolution", "SurfaceConduction",
    "SurfaceConductionSolution", "SurfaceConstriction", "SurfaceConstrictionSolution", "SurfaceContact",
    "SurfaceContactSolution", "SurfaceFields", "SurfaceFilm", "SurfaceFrictionHeating",
    "SurfaceFrictionHeatingSolution", "SurfaceLoad", "SurfaceRolling",
    "SurfaceRollingSolution", "SurfaceRollingStart", "SurfaceRollingStartSolution",
    "SurfaceTangential", "SurfaceTangentialSolution", "SurfaceWear", "SurfaceWearSolution", "TabulatedGrading",
    "TabulatedTip", "Tangential", "TangentialSolution", "ThermalConductor", "ThermalConstriction",
    "ThermalConstrictionSolution", "ThermalDrift", "ThermalInterface", "ThermalJoint", "ThermalJointSolution", "Tilt",
    "Topography", "Torque", "Torsion", "TorsionSolution", "TransientHeating", "TransientHeatingSolution",
    "TransverselyIsotropic", "TransverselyIsotropicHalfSpace", "TrueArea", "TrueAreaSolution", "TruncatedCone",
    "TruncatedParaboloid", "TwistedFields", "Uncalibrated", "Vickers", "ViscoelasticAdhesion",
    "ViscoelasticAdhesionSolution", "ViscoelasticCoatedHalfSpace", "ViscoelasticFit", "ViscoelasticHalfSpace",
    "ViscoelasticImpact", "ViscoelasticImpactSolution", "ViscoelasticIndentation", "ViscoelasticLayer",
    "ViscoelasticSolution", "Voltage", "Wavy", "WiedemannFranz", "WilliamsLandelFerry", "WinklerError", "YieldOnset",
    "YieldOnsetSolution", "ZeroPoint", "area_fraction", "bearing_heights", "calibrate_indenter", "calibration_shares",
    "compare", "compare_terms", "contact_reading", "correlation_length", "correlation_lengths", "creep_coefficients",
    "depth_scaling", "design_for_pressure", "design_profile", "export", "first_yield_stress", "fit",
    "fit_poroelastic", "fit_steps", "fit_together", "flow_factors", "found_drift", "found_zero_point",
    "indentation_quantities", "intercept_factor", "linear_creep_coefficients", "map_statistics", "material",
    "material_names", "maugis_parameter", "mean_separation", "over_depth", "peak_stress", "pop_in_statistics",
    "population", "pyramid_layer_error", "random_topography", "ratio_of", "read_bed", "read_bounces", "read_contacts",
    "read_creep", "read_cross_profile", "read_curve", "read_curves", "read_dynamic", "read_dynamic_sweeps",
    "read_friction_log", "read_grading", "read_held_force", "read_indenter", "read_path", "read_pin", "read_profile",
    "read_profile_pair", "read_relaxation", "read_relaxation_sweeps", "read_resistance_log", "read_scan",
    "read_section", "read_spectrum", "read_surface_load", "read_topography", "reduce", "relaxation_band",
    "repeated_mean", "restore", "restore_body", "restore_conduction", "restore_shift", "sample_young", "spectrum_of",
    "staircase", "tabor_parameter", "tip_limit", "to_pandas", "to_xarray", "which_model", "widget", "write_contacts",
    "write_export", "write_indenter", "write_law", "write_surface_interaction", "write_trace", "write_vtk",
]  # fmt: skip
