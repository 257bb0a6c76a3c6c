"""Studies that the tests of archive and report have in common."""

from __future__ import annotations

import dataclasses

import numpy as np

import winkler as wk
from winkler.study.language.designs import Zipped
from winkler.study.language.study import Expectation, Fields, Output, Places, Study
from winkler.study.language.varied import Axis

STEEL = wk.Elastic(210e9, 0.3)
STRONG = wk.Elastic(210e9, 0.3, 700e6)
MEDIUM = wk.HalfSpace(STRONG, STEEL)
CRYSTAL = wk.TransverselyIsotropicHalfSpace(wk.TransverselyIsotropic(162e9, 92e9, 69e9, 181e9, 47e9))
FORCES = Axis("problem.load.force", (1.0, 10.0, 100.0, 1000.0))
RADII = Axis("problem.bed.profile.curvature_radius", (5e-3, 10e-3))
PLACES = Places(np.array([0.0, 0.5, 1.0, 2.0]), relative=True)


def pressed(profile=None, load=None, medium=None):
    """Return the question of a ball, or of another shape, pressed into steel."""
    bed = wk.Foundation(profile or wk.Paraboloid(10e-3), medium or wk.HalfSpace(STEEL, STEEL))
    return wk.Indentation(bed, load or wk.Force(20.0))


SAMPLES = {
    "one load": Study("A ball", pressed(medium=MEDIUM), expect=(Expectation("depth", 1.191e-6, 1e-3),)),
    "two keys": Study("Two keys", pressed(), sweep=(FORCES, RADII)),
    "together": Study(
        "Together",
        pressed(),
        sweep=(FORCES, Axis("problem.bed.medium.first.young", (1e9, 2e9, 4e9, 8e9))),
        design=Zipped(),
    ),
    "many loads": Study("Many loads", pressed(load=wk.Depth(np.linspace(0.0, 3e-6, 30)))),
    "many loads, varied": Study(
        "Many loads, varied", pressed(load=wk.Depth(np.linspace(0.0, 3e-6, 5))), sweep=(RADII,)
    ),
    "fields": Study("Fields", pressed(), sweep=(FORCES,), fields=Fields(PLACES, Places(np.array([0.1, 1.0]), True))),
    "fields at lengths": Study(
        "Fields", pressed(load=wk.Force(np.array([1.0, 2.0]))), fields=Fields(Places(np.array([0.0, 1e-4])))
    ),
    "shapes": Study(
        "Shapes",
        pressed(),
        sweep=(Axis("problem.bed.profile", (wk.Paraboloid(1e-2), wk.Cone(1.5), wk.FlatPunch(1e-3))),),
    ),
    "some fail": Study(
        "Some fail",
        pressed(wk.CappedCylinder(1e-3, wk.Sphere(1e-2)), wk.Radius(1e-4)),
        sweep=(Axis("problem.load.radius", (1e-4, 5e-4, 2e-3)),),
    ),
    "onset of yield": Study("Onset", wk.YieldOnset(wk.Foundation(wk.Paraboloid(1e-2), MEDIUM))),
    "crystal": Study("Crystal", pressed(medium=CRYSTAL)),
    "no contact": Study("No contact", pressed(load=wk.Depth(-1e-6))),
    "plane profile": Study("Plane", wk.Indentation(wk.PlaneFoundation(wk.PowerLaw(1e2, 2.0), MEDIUM), wk.Force(1.0))),
    "pinned": Study("Pinned", pressed(wk.FlatPunch(1e-3), wk.Force(1e3))),
    "formula": Study(
        "Constants",
        pressed(wk.Formula("r**2/(2*my__R)", my__R=1e-2)),
        sweep=(Axis("problem.bed.profile.constants.my__R", (1e-3, 1e-2)),),
    ),
    "sum": Study("Sum", pressed(wk.Paraboloid(1e-2) + wk.Wavy(1e-8, 1e-3))),
    "area function": Study("Area", pressed(wk.AreaFunction([24.5, 2e-6]), wk.Force(0.01))),
    "only figures": Study("Only figures", pressed(), output=Output(figures=("pdf",), report=False)),
    "hostile": Study('<script>alert("1")</script> & <b>bold</b> $x_{$ 10 N', pressed(), sweep=(FORCES,)),
}

SAMPLES = {
    name: study if name in ("one load", "only figures") else dataclasses.replace(study, output=Output(figures=("svg",)))
    for name, study in SAMPLES.items()
}
"""One of them writes all formats; for the others one is enough."""
