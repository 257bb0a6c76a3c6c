"""Seeded histories: of each engine, medium and control twenty problems at random, from microns to metres.

A group is named problem/medium/control.  A seed gives bodies, profile, law, loads and path, all by its own generator.
"""

from __future__ import annotations

import functools
from collections.abc import Callable
from itertools import product
from typing import Any

import numpy as np

import winkler as wk
from golden import Found, found_in
from winkler.problems.ring_slip.ring_path import ANGLE_TOLERANCE
from winkler.problems.row import CURVED_STEP_TOLERANCE

SEEDS, POINTS, MARCHED, KEPT = 20, 6, 3, 1
"""Seeds of a group, points of a path, points of one along which both loads change, and numbers that are stored
of each quantity: that at the end."""
MARCHED_LINE = 1e-3
"""Error of slip and stick zone of a line contact beside a bulk stress out of phase, as the manual states it."""
Random = np.random.Generator
Problem = Callable[..., Any]


class World:
    """The bodies of a seed, at one length and one modulus."""

    def __init__(self, seed: int) -> None:
        self.rng = np.random.default_rng(seed)
        self.length, self.size = 10.0 ** self.rng.uniform(-6.0, 0.0), 10.0 ** self.rng.uniform(3.0, 11.0)
        self.radius = 10.0 ** self.rng.uniform(-2.0, -0.7) * self.length

    def elastic(self, strength: bool = False) -> wk.Elastic:
        young = self.size * 10.0 ** self.rng.uniform(-1.0, 1.0)
        return wk.Elastic(young, self.rng.uniform(0.0, 0.5), **({"strength": 1e-2 * young} if strength else {}))

    def transverse(self) -> wk.TransverselyIsotropic:
        c11, c33, c44 = self.size * self.rng.uniform(0.5, 2.0, 3)
        return wk.TransverselyIsotropic(c11, 0.3 * c11, 0.2 * np.sqrt(c11 * c33), c33, c44)

    def layers(self, count: int) -> list[wk.Layer]:
        return [wk.Layer(self.elastic(), self.radius * 10.0 ** self.rng.uniform(-1.0, 1.0)) for _ in range(count)]

    def solid(self) -> wk.StandardSolid:
        return wk.StandardSolid(
            *(self.size * 10.0 ** self.rng.uniform(-1.0, 1.0, 2)), 10.0 ** self.rng.uniform(-2.0, 2.0)
        )

    def profile(self) -> Any:
        shapes = (wk.Paraboloid(self.length), wk.Cone(1.4), wk.PowerLaw(self.length**-2.0, 3.0), wk.Sphere(self.length))
        return shapes[self.rng.integers(4)]

    def walk(self, count: int = POINTS) -> np.ndarray:
        """Return points between minus one and one, the first of them zero."""
        return np.concatenate([[0.0], self.rng.uniform(-1.0, 1.0, count - 1)])

    def shares(self, count: int) -> np.ndarray:
        """Return shares of the greatest load."""
        return self.rng.uniform(0.3, 1.0, count)

    def law(self) -> wk.Coulomb:
        return wk.Coulomb(self.rng.uniform(0.1, 0.9))


MEDIA: dict[str, Callable[[World], Any]] = {
    "half_space": lambda w: wk.HalfSpace(w.elastic(), w.elastic() if w.rng.random() < 0.5 else wk.Rigid()),
    "transverse": lambda w: wk.TransverselyIsotropicHalfSpace(w.transverse(), w.elastic()),
    "power_law": lambda w: wk.GradedHalfSpace(
        wk.PowerLawGraded(w.size, w.length, w.rng.uniform(-0.4, 0.7), w.rng.uniform(0.0, 0.5)), wk.Rigid()
    ),
    "coated": lambda w: wk.CoatedHalfSpace(w.layers(int(w.rng.integers(1, 3))), on=w.elastic()),
    "film": lambda w: wk.CoatedHalfSpace(w.layers(1), on=wk.Rigid()),
    "stacked": lambda w: wk.StackedHalfSpace([wk.StackLayer(w.transverse(), w.radius), *w.layers(1)], on=w.elastic()),
    "sliding": lambda w: wk.SlidingFilm(w.layers(1), on=w.elastic()),
    "relaxing": lambda w: wk.ViscoelasticHalfSpace(w.solid()),
}


@functools.lru_cache(maxsize=512)
def bed_of(medium: str, seed: int) -> tuple[World, Any, float]:
    """Return a world, springs, and the depth of its contact; the state of its generator is that after them."""
    world = World(seed)
    bed = wk.Foundation(world.profile(), MEDIA[medium](world))
    elastic = wk.Foundation(bed.profile, bed.medium.elastic) if medium == "relaxing" else bed
    return world, bed, float(wk.Indentation(elastic, wk.Radius(world.radius)).solve().depth)


def pushed(problem: Problem, medium: str, control: str, seed: int, **more: Any) -> Any:
    """Return a problem of slip or twist: about half of the motions reach sliding, no load exceeds friction."""
    normal, lateral, how = control.split("-")
    _, bed, depth = bed_of(medium, seed)
    world = World(seed + 1000)
    law, count = world.law(), POINTS if how == "steady" else MARCHED
    depths, walk = depth * (np.ones(count) if how == "steady" else world.shares(count)), world.walk(count)
    elastic = wk.Foundation(bed.profile, bed.medium.elastic) if medium == "relaxing" else bed
    contact = wk.Indentation(elastic, wk.Depth(depths)).solve()
    across = wk.Depth(depths) if normal == "depth" else wk.Force(contact.force)
    least, radius = law.coefficient * float(np.min(contact.force)), float(np.max(contact.radius))
    along = {
        "shift": lambda: wk.Shift(1.5 * law.coefficient * depth * walk),
        "shear": lambda: wk.ShearForce(0.9 * least * walk),
        "angle": lambda: wk.Angle(law.coefficient * depth / radius * walk),
        "torque": lambda: wk.Torque(0.4 * least * float(np.min(contact.radius)) * walk),
    }[lateral]()
    return problem(bed, law, wk.Path.through(across, along), **more)


def swung(problem: Problem, medium: str, control: str, seed: int) -> Any:
    """Return a problem of damping at three amplitudes."""
    normal, lateral = control.split("-")
    _, bed, depth = bed_of(medium, seed)
    world = World(seed + 2000)
    law = world.law()
    if problem is wk.BimodalDamping:
        how = {"depth": depth / 1.5, "depth_amplitude": 0.4 * depth, "phase": world.rng.uniform(-3.0, 3.0)}
        return problem(bed, law, shift_amplitude=law.coefficient * depth * np.array([0.1, 0.5]), **how)
    force = float(wk.Indentation(bed, wk.Depth(depth)).solve().force)
    across = wk.Depth(depth) if normal == "depth" else wk.Force(force)
    parts = law.coefficient * np.array([0.1, 0.5, 0.95])
    return problem(bed, law, across, wk.Shift(parts * depth) if lateral == "shift" else wk.ShearForce(parts * force))


def pressed(problem: Problem, medium: str, control: str, seed: int) -> Any:
    """Return an indentation at three loads."""
    _, bed, depth = bed_of(medium, seed)
    depths = depth * np.array([0.1, 0.5, 1.0])
    loads = {
        "depth": lambda: wk.Depth(depths),
        "radius": lambda: wk.Radius(bed_of(medium, seed)[0].radius * depths / depth),
    }
    force = lambda: wk.Force(wk.Indentation(bed, wk.Depth(depths)).solve().force)  # noqa: E731
    return problem(bed, loads.get(control, force)())


def worn(problem: Problem, medium: str, control: str, seed: int) -> Any:
    """Return a march of wear, on a coarse grid."""
    normal = control
    _, bed, depth = bed_of(medium, seed)
    law = World(seed + 3000).law()
    contact = wk.Indentation(bed, wk.Depth(depth)).solve()
    across = wk.Depth(depth) if normal == "depth" else wk.Force(float(contact.force))
    pressure = float(contact.force) / (np.pi * float(contact.radius) ** 2)
    rate, swing = 1e-3 * depth / (pressure * float(contact.radius)), wk.Shift(0.4 * law.coefficient * depth)
    if problem is wk.SlidingWear:
        return problem(
            bed, wk.Archard(rate), across, 100.0 * float(contact.radius) * np.array([0.0, 0.3, 1.0]), count=80
        )
    if problem is wk.LimitingProfile:
        return problem(bed, law, across, swing)
    cycles = 30.0 * float(contact.radius) / swing.shift * np.array([0.0, 0.1, 1.0])
    return problem(bed, wk.Archard(rate), law, across, swing, cycles, count=80)


def line_bed(medium: str, world: World) -> tuple[Any, float]:
    """Return a line contact, of which each body has a strength, and its force per length."""
    strong = wk.HalfSpace(world.elastic(True), world.elastic(True))
    kind = wk.LayeredLineFoundation if medium in ("coated", "film", "sliding") else wk.LineFoundation
    profile = (wk.Paraboloid(world.length), wk.PowerLaw(world.length**-2.0, 3.0))[world.rng.integers(2)]
    bed = kind(profile, strong if medium == "half_space" else MEDIA[medium](world))
    if medium == "relaxing":
        elastic = wk.LineFoundation(profile, bed.medium.elastic)
        return bed, float(wk.LineIndentation(elastic, wk.HalfWidth(world.radius)).solve().force_per_length)
    return bed, float(wk.LineIndentation(bed, wk.HalfWidth(world.radius)).solve().force_per_length)


def line(problem: Problem, medium: str, control: str, seed: int) -> Any:
    """Return a problem of line contact."""
    world = World(seed + 4000)
    bed, force = line_bed(medium, world)
    law, load, width = world.law(), wk.LineForce(force), world.radius
    swing = wk.LineShearForce(world.rng.uniform(0.2, 0.8) * law.coefficient * force)
    wear = wk.Archard(1e-2 * width / force)
    cylinder = (
        wk.LineFoundation(wk.Paraboloid(world.length), bed.medium) if medium in ("half_space", "relaxing") else bed
    )
    width_load = wk.HalfWidth(width)
    if problem is wk.LineTangential:
        forces = force * (world.shares(POINTS) if control == "varying" else np.ones(POINTS))
        shears = 0.9 * law.coefficient * np.min(forces) * world.walk()
        strain = 0.2 * law.coefficient * force / width
        bed = cylinder if control == "bulk" else bed
        bulk = {"bulk": strain, "phase": strain * world.walk()}.get(control, 0.0)
        return problem(bed, law, wk.LinePath(forces, shears, bulk_stress=bulk))
    if problem in (wk.LineRolling, wk.LineRollingStart):
        creepage = wk.Creepage(longitudinal=world.rng.uniform(0.1, 0.9) * law.coefficient * width / world.length)
        part = float(wk.LineIndentation(cylinder, width_load).solve().force_per_length) / force
        drive = creepage if control == "creepage" else wk.LineShearForce(swing.shear_force_per_length * part)
        if problem is wk.LineRolling:
            return problem(cylinder, law, drive, width_load, coupled=control == "coupled")
        reference = {"reference": 10.0 * width} if control == "creepage" else {}
        return problem(cylinder, law, drive, width_load, distance=3.0 * width, points=POINTS, count=40, **reference)
    steel = wk.ThermalConductor(45.0, 12e-6)
    copper = wk.ElectricalConductor(2e-8)
    speeds = 12e-6 / width * 10.0 ** world.rng.uniform(-1.0, 2.0, 2)
    loads = {
        "force": wk.LineForce(force * np.array([0.1, 0.5, 1.0])),
        "width": wk.HalfWidth(width * np.array([0.1, 0.5, 1.0])),
        "pressure": wk.MeanPressure(force / (2.0 * width)),
    }
    made: dict[Any, Callable[[], Any]] = {
        wk.LineIndentation: lambda: problem(bed, loads[control]),
        wk.LineAdhesion: lambda: problem(bed, wk.ShortRange(0.1 * force * width / world.length), loads[control]),
        wk.LineYieldOnset: lambda: problem(bed, wk.Coulomb(0.2) if control == "sliding" else wk.Coulomb(0.0)),
        wk.LineShakedown: lambda: problem(bed, wk.Coulomb(0.2) if control == "sliding" else wk.Coulomb(0.0)),
        wk.LineLimitingProfile: lambda: problem(bed, law, load, swing),
        wk.LineFrettingWear: lambda: problem(bed, wear, law, load, swing, [0.0, 1e3, 1e4], count=80),
        wk.LineSlidingWear: lambda: problem(bed, wear, load, width * np.array([0.0, 0.1, 1.0]), count=80),
        wk.LineConstriction: lambda: problem(
            wk.LineIndentation(bed, loads[control]),
            wk.ElectricalConductors(copper, copper),
            30.0 * width,
            50.0 * width,
        ),
        wk.LineFrictionHeating: lambda: problem(
            wk.LineIndentation(bed, loads[control]), law, wk.HeatConductors(steel, steel), *speeds
        ),
        wk.LineRollingResistance: lambda: problem(cylinder, width_load, width * np.array([1e-2, 1.0, 1e2])),
        wk.LineViscoelasticIndentation: lambda: problem(
            bed, wk.LineForcePath(np.arange(float(POINTS)), force * world.shares(POINTS)), count=100
        ),
    }
    return made[problem]()


CONTROLS = [f"{normal}-{{}}-{how}" for how, normal in product(("steady", "varying"), ("depth", "force"))]
BY_FORCES = ("shear", "torque")


def slip_groups(
    problem: Problem, media: str, laterals: str, controls: list[str] = CONTROLS, name: str = "", **more: Any
) -> dict[str, Any]:
    return {
        f"{name or problem.__name__}/{medium}/{control.format(lateral)}": functools.partial(
            pushed, problem, medium, control.format(lateral), **more
        )
        for medium, lateral, control in product(media.split(), laterals.split(), controls)
    }


def groups(make: Callable[..., Any], problems: str, media: str, controls: str) -> dict[str, Any]:
    return {
        f"{problem}/{medium}/{control}": functools.partial(make, getattr(wk, problem), medium, control)
        for problem, medium, control in product(problems.split(), media.split(), controls.split())
    }


STEADY = CONTROLS[:2]
GROUPS: dict[str, Callable[[int], Any]] = {
    **slip_groups(wk.Tangential, "half_space power_law", "shift shear"),
    **slip_groups(wk.Tangential, "transverse", "shift", STEADY),
    **slip_groups(wk.Tangential, "coated", "shift", STEADY[:1], method=wk.Method.SPRINGS),
    **slip_groups(wk.Tangential, "coated", "shift shear", name="CoatedTangential"),
    **slip_groups(wk.Tangential, "stacked film", "shift shear", STEADY, name="CoatedTangential"),
    **slip_groups(
        wk.Tangential, "relaxing", "shift", CONTROLS[1:3], name="ViscoelasticTangential", count=50, tolerance=1e-6
    ),
    **slip_groups(
        wk.Tangential, "relaxing", "shear", CONTROLS[1::2], name="ViscoelasticTangential", count=50, tolerance=1e-6
    ),
    **slip_groups(wk.Torsion, "half_space transverse coated stacked", "angle torque", STEADY),
    **slip_groups(wk.Torsion, "half_space coated", "angle torque", CONTROLS[3:]),
    **groups(swung, "FrictionDamping", "half_space power_law transverse coated stacked", "depth-shift force-shear"),
    **groups(swung, "BimodalDamping", "half_space power_law coated", "depth-shift"),
    **groups(
        pressed, "Indentation", "half_space transverse power_law coated film stacked sliding", "depth force radius"
    ),
    **groups(worn, "FrettingWear SlidingWear", "half_space coated", "depth force"),
    **groups(worn, "LimitingProfile", "half_space power_law coated", "depth"),
    **groups(line, "LineTangential", "half_space", "steady varying bulk phase"),
    **groups(line, "LineRolling", "half_space", "creepage force coupled"),
    **groups(line, "LineRollingStart", "half_space", "creepage force"),
    **groups(line, "LineRollingResistance LineViscoelasticIndentation", "relaxing", "width"),
    **groups(line, "LineIndentation", "half_space transverse coated film sliding", "force width pressure"),
    **groups(line, "LineAdhesion", "half_space transverse", "force width"),
    **groups(line, "LineConstriction LineFrictionHeating", "half_space", "force width"),
    **groups(line, "LineYieldOnset LineShakedown", "half_space", "resting sliding"),
    **groups(line, "LineLimitingProfile LineFrettingWear LineSlidingWear", "half_space", "force"),
}


def history(name: str, seed: int) -> Found:
    """Return the numbers of a group and a seed, of which the last of each is stored."""
    problem = GROUPS[name](seed)
    answers, error = found_in([(problem, problem.solve())])
    return Found(answers, max(error, stated(name)))


def stated(name: str) -> float:
    """Return the error that the module of a march names."""
    problem, _, control = name.split("/")
    if problem in ("CoatedTangential", "Torsion") and control.endswith("varying"):
        return ANGLE_TOLERANCE
    if problem == "Tangential" and control.endswith("varying") and control != "depth-shift-varying":
        return CURVED_STEP_TOLERANCE
    return MARCHED_LINE if name == "LineTangential/half_space/phase" else 0.0
