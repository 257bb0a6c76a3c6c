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

damped = wk.FrictionDamping(bed, wk.Coulomb(0.3), wk.Force(10.0), wk.ShearForce(1.0)).solve()
lost: float = damped.loss_per_cycle + damped.loss_factor + damped.contact.radius
pushed = wk.Tangential(bed, wk.Coulomb(0.3), wk.Path.through(wk.Depth(1e-6), wk.Shift(np.array([1e-8, 0.0])))).solve()
pushes: NDArray[np.float64] = pushed.shear_force
twisted = wk.Torsion(bed, wk.Coulomb(0.3), wk.Path.through(wk.Depth(1e-6), wk.Angle(np.array([1e-6])))).solve()
moment: float = twisted.at(0).torque
print(lost, pushes[-1], moment)

strip = wk.LineFoundation(wk.Paraboloid(curvature_radius=10e-3), wk.HalfSpace.between(steel, steel))
roller = wk.LineIndentation(strip, wk.LineForce(1e5)).solve()
mean: float = roller.mean_pressure + roller.force_per_length
held = wk.LineAdhesion(strip, jkr, wk.HalfWidth(np.array([1e-6, 2e-6]))).solve()
assert_type(held.at(1).force_per_length, float)
driven = wk.LineRolling(strip, wk.Coulomb(0.3), wk.Creepage(longitudinal=1e-4), wk.LineForce(1e5)).solve()
traction: float = driven.shear_force_per_length
rolled = wk.Rolling(bed, wk.Coulomb(0.3), wk.Creepage(longitudinal=np.array([1e-5, 1e-4])), wk.Force(10.0)).solve()
creeps: NDArray[np.float64] = rolled.shear_force
print(mean, held.half_width.max(), traction, creeps.max(), rolled.contact.radius + 0.0)

worn = wk.SlidingWear(bed, wk.Archard(1e-14), wk.Force(1.0), np.array([0.0, 1.0]), count=40).solve()
assert_type(worn.states[1].worn_volume, float)
pair = wk.HeatConductors(wk.ThermalConductor(45.0, 12e-6), wk.ThermalConductor(45.0, 12e-6))
warm = wk.FrictionHeating(wk.Indentation(bed, wk.Force(10.0)), wk.Coulomb(0.3), pair, first_speed=0.2).solve()
hottest: float = warm.flash_temperature + warm.first_share
speeds = np.array([0.1, 0.2])
band = wk.BandHeating(1e-4, 1e6, pair, first_speed=speeds, second_speed=-speeds).solve()
print(worn.worn_volume[-1], hottest, np.max(band.flash_temperature))
metal = wk.ElectricalConductor(15.9e-9)
spots = wk.Constriction(
    wk.Indentation(bed, wk.Force(np.array([1.0, 2.0]))), wk.ElectricalConductors(metal, metal)
).solve()
ohms: list[float] = [spots.at(0).resistance, spots.at(1).conductance]
passed = wk.ThermalConstriction(wk.Indentation(bed, wk.Force(1.0)), pair, temperature_drop=10.0).solve()
watts: float = passed.heat_rate
print(spots.constriction.max(), ohms, watts)

solid = wk.StandardSolid(relaxed_shear=1e6, shear=2e6, relaxation_time=0.1)
soft = wk.Foundation(ball, wk.ViscoelasticHalfSpace(solid))
sunk = wk.ViscoelasticIndentation(soft, wk.Path(np.array([0.0, 1.0]), wk.Depth(np.array([0.0, 1e-5])))).solve()
rests: NDArray[np.float64] = sunk.force
swung = wk.HarmonicIndentation(soft, wk.Force(1.0), angular_frequency=10.0).solve()
tangent: float = swung.loss_tangent
slid = wk.SlidingResistance(soft, wk.Force(0.1), speed=1e-3, count=100).solve()
thrown = wk.Impact(bed, wk.Coulomb(0.3), mass=0.03, velocity=0.1, count=11).solve()
assert_type(thrown.restitution, float)
print(rests[-1], tangent, slid.coefficient + 0.0, thrown.restitution, thrown.velocity[-1])
torn = wk.AdhesiveShear(rubber, jkr, wk.Force(1e-3), wk.Shift(np.array([0.0, 1e-7]))).solve()
assert_type(wk.PullOff(rubber, jkr).solve().force, float)
print(torn.radius.min(), torn.limit.force)

x = (np.arange(32) - 15.5) * 1e-5
heights = wk.Topography(-(x[:, None] ** 2 + x**2) / 20e-3, np.array([3.2e-4, 3.2e-4]))
mapped = wk.SurfaceContact(heights, wk.HalfSpace.between(steel, steel), wk.Force(1.0))
seen = mapped.solve()
area: float = seen.area + seen.mean_pressure + wk.TrueArea(mapped).solve().patch_count
rolls = wk.SurfaceRolling(
    heights, wk.HalfSpace.between(steel, steel), wk.Force(1.0), wk.Coulomb(0.3), wk.Creepage(1e-4)
)
creep: float = rolls.solve().longitudinal_force
rough = wk.RoughContact(
    wk.SelfAffine(0.8, 1e-8, longest=1e-4, shortest=1e-6), wk.HalfSpace.between(steel, steel), 1e-3, wk.Force(1.0)
)
print(area, creep, rough.side)
