"""The problems that `import winkler` offers, each name from the module where it is defined; see `winkler.public`."""

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
from winkler.problems.friction.spring_march import SpringMarch, SpringTrace
from winkler.problems.friction.tangential import Tangential, TangentialSolution
from winkler.problems.friction.torsion import Torsion, TorsionSolution
from winkler.problems.friction.torsion_fields import TwistedFields
from winkler.problems.heating.band_heating import BandHeating, BandHeatingSolution
from winkler.problems.heating.elliptic_heating import EllipticFrictionHeating, EllipticFrictionHeatingSolution
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
from winkler.problems.plastic.strength_from_dent import StrengthFromDent, StrengthFromDentSolution
from winkler.problems.poroelastic.held import PoroelasticRelaxation, PoroelasticSolution
from winkler.problems.pressed_maps.flow_factors import FlowFactors, flow_factors
from winkler.problems.pressed_maps.seal import Seal, SealSolution
from winkler.problems.pressed_maps.thermal_joint import ThermalJoint, ThermalJointSolution
from winkler.problems.pressed_maps.true_area import TrueArea, TrueAreaSolution
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
from winkler.problems.subsurface.surface_load import SurfaceLoad
from winkler.problems.surface_adhesion.adhesion import SurfaceAdhesion, SurfaceAdhesionSolution
from winkler.problems.surface_current.constriction import SurfaceConstriction, SurfaceConstrictionSolution
from winkler.problems.surface_friction.joint import JointStiffness, JointStiffnessSolution
from winkler.problems.surface_friction.reduced import ReducedFriction, ReducedFrictionSolution
from winkler.problems.surface_friction.tangential import SurfaceTangential, SurfaceTangentialSolution
from winkler.problems.surface_heating.rolling import SurfaceRollingHeating, SurfaceRollingHeatingSolution
from winkler.problems.surface_heating.sliding import SurfaceFrictionHeating, SurfaceFrictionHeatingSolution
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

__all__ = [
    "AdhesiveCycle", "AdhesiveCycleSolution", "AdhesiveImpact", "AdhesiveImpactSolution", "AdhesiveIndentation",
    "AdhesiveShear", "AdhesiveShearSolution", "AdhesiveSolution", "BallImpacts", "BallImpactsSolution", "BandHeating",
    "BandHeatingSolution", "BimodalDamping", "BimodalDampingSolution", "ConductanceBounds",
    "ConductanceBoundsSolution", "Constriction", "ConstrictionSolution", "ContactLaw", "ContactLawSolution",
    "ContactStress", "ContactStressSolution", "ContactTrace", "Contacts", "CreepForce", "CreepTest", "Creepage",
    "CurrentFields", "DentLimit", "DentLimitSolution", "ElasticPlasticParticle", "ElastomerFriction",
    "ElastomerFrictionSolution", "EllipticFields", "EllipticFrictionHeating", "EllipticFrictionHeatingSolution",
    "EllipticIndentation", "EllipticPartOnset", "EllipticSolution", "EllipticWear", "EllipticWearSolution",
    "EllipticYieldOnset", "EllipticYieldOnsetSolution", "Equilibrium", "EquilibriumCurve", "FlowFactors",
    "FrettingHeat", "FrettingHeatSolution", "FrettingSolution", "FrettingWear", "FrictionDamping",
    "FrictionDampingSolution", "FrictionHeating", "FrictionHeatingSolution", "HarmonicIndentation", "HeatFields",
    "Impact", "ImpactSolution", "Indentation", "IndentationSolution", "JointStiffness", "JointStiffnessSolution",
    "JouleHeating", "JouleHeatingSolution", "Kalker", "LayerStress", "LayeredLineAdhesionSolution",
    "LayeredLineLimitingSolution", "LayeredLineSolution", "LimitingProfile", "LimitingSolution", "LineAdhesion",
    "LineAdhesionSolution", "LineConstriction", "LineConstrictionSolution", "LineFields", "LineForcePath",
    "LineFrettingSolution", "LineFrettingWear", "LineFrictionHeating", "LineFrictionHeatingSolution",
    "LineIndentation", "LineLimitingProfile", "LineLimitingSolution", "LinePartOnset", "LinePath",
    "LineProfileContact", "LineProfileSolution", "LineRolling", "LineRollingResistance",
    "LineRollingResistanceSolution", "LineRollingSolution", "LineRollingStart", "LineRollingStartSolution",
    "LineShakedown", "LineShakedownSolution", "LineSlidingSolution", "LineSlidingWear", "LineSolution",
    "LineTangential", "LineTangentialSolution", "LineViscoelasticIndentation", "LineViscoelasticSolution",
    "LineYieldOnset", "LineYieldOnsetSolution", "MapStress", "MapStressSolution", "MasterCurve",
    "MasterCurveSolution", "Method", "NearlyRoundIndentation", "NearlyRoundSolution", "OscillatingRolling",
    "OscillatingRollingSolution", "PartOnset", "ParticleSolution", "PeriodicIndentation", "PeriodicSolution",
    "PlasticImpact", "PlasticImpactSolution", "PlasticIndentation", "PlasticSolution", "PlateBase",
    "PoroelasticRelaxation", "PoroelasticSolution", "PowerLawLineSolution", "ProfilePair", "ProfilePairRolling",
    "ProfilePairRollingSolution", "ProfilePairSolution", "ProfilePatch", "PullOff", "PullOffSolution", "ReducedBed",
    "ReducedFriction", "ReducedFrictionSolution", "Reduction", "ReductionSolution", "RelaxationDamper",
    "RelaxationDamperSolution", "RelaxationSpectrum", "RelaxationTest", "RolledPatch", "RollerCentre",
    "RollerContact", "RollerSolution", "Rolling", "RollingSolution", "RollingStart", "RollingStartSolution",
    "RoughContact", "RoughContactSolution", "RoughIndentation", "RoughIndentationSolution", "RoughLine", "Seal",
    "SealSolution", "ShiftedBy", "SimplifiedRolling", "SimplifiedRollingSolution", "SlidingResistance",
    "SlidingResistanceSolution", "SlidingSolution", "SlidingWear", "SpectrumSolution", "Spin", "SpotCluster",
    "SpotClusterSolution", "SpringMarch", "SpringTrace", "StrengthFromDent", "StrengthFromDentSolution",
    "SurfaceAdhesion", "SurfaceAdhesionSolution", "SurfaceConduction", "SurfaceConductionSolution",
    "SurfaceConstriction", "SurfaceConstrictionSolution", "SurfaceContact", "SurfaceContactSolution",
    "SurfaceFrictionHeating", "SurfaceFrictionHeatingSolution", "SurfaceLoad", "SurfaceRolling",
    "SurfaceRollingHeating", "SurfaceRollingHeatingSolution", "SurfaceRollingSolution", "SurfaceRollingStart",
    "SurfaceRollingStartSolution", "SurfaceTangential", "SurfaceTangentialSolution", "SurfaceWear",
    "SurfaceWearSolution", "Tangential", "TangentialSolution", "ThermalConstriction", "ThermalConstrictionSolution",
    "ThermalJoint", "ThermalJointSolution", "Torsion", "TorsionSolution", "TransientHeating",
    "TransientHeatingSolution", "TrueArea", "TrueAreaSolution", "TwistedFields", "Uncalibrated",
    "ViscoelasticAdhesion", "ViscoelasticAdhesionSolution", "ViscoelasticImpact", "ViscoelasticImpactSolution",
    "ViscoelasticIndentation", "ViscoelasticSolution", "YieldOnset", "YieldOnsetSolution", "area_fraction",
    "creep_coefficients", "design_for_pressure", "design_profile", "flow_factors", "linear_creep_coefficients",
    "maugis_parameter", "mean_separation", "pyramid_layer_error", "reduce", "restore_conduction", "tabor_parameter",
    "which_model",
]  # fmt: skip
