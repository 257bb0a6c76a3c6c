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
from winkler.fields import PeakStress, SubsurfaceFields, SurfaceFields, peak_stress, restore
from winkler.fitting.compare import Comparison, compare
from winkler.fitting.curve import ForceCurve
from winkler.fitting.fit import Fit, fit
from winkler.fitting.oliver_pharr import OliverPharr, OliverPharrSolution, intercept_factor, sample_young
from winkler.foundation.foundation import Foundation
from winkler.foundation.measured import MeasuredBed
from winkler.foundation.plane import PlaneFoundation
from winkler.foundation.springs import Springs
from winkler.io.bed_table import read_bed
from winkler.io.curves import PlacedCurve, read_curve, read_curves
from winkler.io.grading_table import read_grading
from winkler.io.profile_table import read_profile
from winkler.laws.adhesion import DerjaguinMullerToporov, Dugdale, ShortRange
from winkler.loading import Depth, Force, Radius, ShearForce, Shift
from winkler.materials.depth_grading import ExponentialGrading, SigmoidalGrading, TabulatedGrading
from winkler.materials.elastic import Elastic, Rigid, TransverselyIsotropic
from winkler.materials.graded import PowerLawGraded
from winkler.materials.layered import Layer
from winkler.media.coated import CoatedHalfSpace
from winkler.media.depth_graded import DepthGradedHalfSpace
from winkler.media.graded import GradedHalfSpace
from winkler.media.halfspace import HalfSpace
from winkler.media.transverse import TransverselyIsotropicHalfSpace
from winkler.problems.adhesion_model import maugis_parameter, tabor_parameter, which_model
from winkler.problems.adhesive import AdhesiveIndentation, AdhesiveSolution
from winkler.problems.adhesive_cycle import AdhesiveCycle, AdhesiveCycleSolution
from winkler.problems.adhesive_shear import AdhesiveShear, AdhesiveShearSolution
from winkler.problems.design import design_for_pressure, design_profile
from winkler.problems.equilibrium import Equilibrium, EquilibriumCurve
from winkler.problems.indentation import Indentation, IndentationSolution
from winkler.problems.pull_off import PullOff, PullOffSolution
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
from winkler.staircase import Staircase, staircase
from winkler.validity import Note, Standing

__all__ = [
    "AdhesiveCycle",
    "AdhesiveCycleSolution",
    "AdhesiveIndentation",
    "AdhesiveShear",
    "AdhesiveShearSolution",
    "AdhesiveSolution",
    "AreaFunction",
    "Berkovich",
    "CappedCylinder",
    "CappedParaboloid",
    "CoatedHalfSpace",
    "Comparison",
    "Cone",
    "CubeCorner",
    "Cylinder",
    "Depth",
    "DepthGradedHalfSpace",
    "DerjaguinMullerToporov",
    "Designed",
    "Dugdale",
    "Elastic",
    "Ellipsoid",
    "Equilibrium",
    "EquilibriumCurve",
    "ExponentialGrading",
    "Fit",
    "FlatPunch",
    "Force",
    "ForceCurve",
    "Formula",
    "Foundation",
    "GradedHalfSpace",
    "HalfSpace",
    "Hyperboloid",
    "Indentation",
    "IndentationSolution",
    "InvalidInput",
    "Layer",
    "Measured",
    "MeasuredBed",
    "NotConverged",
    "Note",
    "OliverPharr",
    "OliverPharrSolution",
    "OutsideValidity",
    "Paraboloid",
    "PeakStress",
    "PlacedCurve",
    "PlaneFoundation",
    "PowerLaw",
    "PowerLawGraded",
    "PullOff",
    "PullOffSolution",
    "Radius",
    "Rigid",
    "RoundedCone",
    "RoundedPunch",
    "Shape",
    "ShearForce",
    "Shift",
    "ShortRange",
    "SigmoidalGrading",
    "Sphere",
    "SpheroConical",
    "Springs",
    "Staircase",
    "Standing",
    "SubsurfaceFields",
    "Sum",
    "SurfaceFields",
    "TabulatedGrading",
    "TransverselyIsotropic",
    "TransverselyIsotropicHalfSpace",
    "TruncatedCone",
    "TruncatedParaboloid",
    "Vickers",
    "Wavy",
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
    "read_curve",
    "read_curves",
    "read_grading",
    "read_profile",
    "restore",
    "sample_young",
    "staircase",
    "tabor_parameter",
    "which_model",
]

__version__ = version("winkler")
