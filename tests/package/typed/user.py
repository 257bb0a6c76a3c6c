"""Lines of a user, which type checkers accept without a cast: a number for one load, arrays for many."""

from __future__ import annotations

from typing import assert_type

import numpy as np
from numpy.typing import NDArray

import winkler as wk

steel = wk.Elastic(young=210e9, poisson=0.3)
ball = wk.Sphere(curvature_radius=10e-3)
bed = wk.Foundation(ball, wk.HalfSpace.between(steel, steel))

contact = wk.Indentation(bed, wk.Force(100.0)).solve()
depth: float = contact.depth
pressures: list[float] = [contact.mean_pressure, contact.peak_pressure]
assert_type(contact.force, float)
assert_type(contact.stiffness, float)
print(f"{1e6 * depth:.3f} um", round(contact.radius * 1e6, 2), max(pressures))

many = wk.Indentation(bed, wk.Depth(np.linspace(0.0, 1e-6, 11))).solve()
assert_type(many.force, NDArray[np.float64])
forces: NDArray[np.float64] = many.force
print(forces.max(), many.radius[-1], np.diff(many.energy))
last = many.at(10)
assert_type(last.depth, float)
assert_type(last.problem.load, wk.Force[float] | wk.Depth[float] | wk.Radius[float])

for load in (wk.Force(1.0), wk.Force(2.0)):
    stiffness: float = wk.Indentation(bed, load).solve().stiffness
    print(stiffness)

jkr = wk.ShortRange(work=0.05)
rubber = wk.Foundation(wk.Paraboloid(curvature_radius=5e-3), wk.HalfSpace(wk.Elastic(young=2e6, poisson=0.5)))
stuck = wk.AdhesiveIndentation(rubber, jkr, wk.Force(1e-3)).solve()
reach: float = stuck.depth + stuck.radius
assert_type(stuck.energy_release_rate, float)
curve = wk.AdhesiveIndentation(rubber, jkr, wk.Depth(np.array([1e-6, 2e-6]))).solve()
assert_type(curve.at(0).force, float)
print(reach, curve.force.min(), stuck.energy, stuck.stress_intensity)

groove = wk.CurvedBodies(longitudinal_curvature_radius=10e-3, lateral_curvature_radius=20e-3)
ellipse = wk.EllipticIndentation(groove, wk.HalfSpace.between(steel, steel), wk.Force(50.0)).solve()
axes: tuple[float, float] = (ellipse.longitudinal_semi_axis, ellipse.lateral_semi_axis)
assert_type(ellipse.peak_pressure, float)
print(axes, ellipse.area, max(ellipse.stiffness, 1.0))
loads = wk.EllipticIndentation(groove, wk.HalfSpace.between(steel, steel), wk.Force(np.array([1.0, 2.0]))).solve()
print(loads.peak_pressure.max(), loads.at(1).depth + 0.0)


def deepest(solution: wk.IndentationSolution) -> float:
    """A solution of which nobody knows how many loads it has: numbers or arrays."""
    return float(np.max(solution.depth))


print(deepest(contact), deepest(many))
ratios: list[float] = [one.force / one.depth for one in (contact, stuck, ellipse)]
print(sum(ratios))
