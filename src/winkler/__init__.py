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
from winkler.foundation.foundation import Foundation
from winkler.foundation.plane import PlaneFoundation
from winkler.foundation.springs import Springs
from winkler.io.profile_table import read_profile
from winkler.loading import Depth, Force, Radius
from winkler.materials.elastic import Elastic, Rigid, TransverselyIsotropic
from winkler.media.halfspace import HalfSpace
from winkler.media.transverse import TransverselyIsotropicHalfSpace
from winkler.problems.indentation import Indentation, IndentationSolution
from winkler.problems.yielding import YieldOnset, YieldOnsetSolution
from winkler.profiles.area import AreaFunction
from winkler.profiles.composite import Sum
from winkler.profiles.conical import Berkovich, Cone, CubeCorner, RoundedCone, SpheroConical, TruncatedCone, Vickers
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
    "AreaFunction",
    "Berkovich",
    "CappedCylinder",
    "CappedParaboloid",
    "Cone",
    "CubeCorner",
    "Cylinder",
    "Depth",
    "Elastic",
    "Ellipsoid",
    "FlatPunch",
    "Force",
    "Formula",
    "Foundation",
    "HalfSpace",
    "Hyperboloid",
    "Indentation",
    "IndentationSolution",
    "InvalidInput",
    "Measured",
    "NotConverged",
    "Note",
    "OutsideValidity",
    "Paraboloid",
    "PeakStress",
    "PlaneFoundation",
    "PowerLaw",
    "Radius",
    "Rigid",
    "RoundedCone",
    "RoundedPunch",
    "Shape",
    "Sphere",
    "SpheroConical",
    "Springs",
    "Staircase",
    "Standing",
    "SubsurfaceFields",
    "Sum",
    "SurfaceFields",
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
    "peak_stress",
    "read_profile",
    "restore",
    "staircase",
]

__version__ = version("winkler")
