"""Random problems whose stated errors have a true one beside them: from refinement, or a closed form.

Each case takes a random generator and returns the stated error and the true one; of several numbers one, and the
greatest ratio of the true to the stated one.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable
from typing import Any

import numpy as np
from scipy.interpolate import CubicHermiteSpline
from scipy.optimize import brentq
from scipy.special import ellipe, ellipk

import winkler as wk
from winkler.exporting.choose import law_of
from winkler.materials.spring_and_dashpot import StandardSolid
from winkler.numerics.fields.disc_charges import currents
from winkler.problems.conduction.spots import SpotClusterSolution
from winkler.problems.line_rolling.rolled_strip import creepage_error, loss_error, rolled_strip
from winkler.problems.rolling.linear_theory import _forces, linear_creep_coefficients
from winkler.problems.viscoelastic.layered_path import stepped

ROUNDING = 1e-14
UNIT = wk.HalfSpace(wk.Elastic(1.0, 0.0))
STEEL = wk.HalfSpace.between(wk.Elastic(210e9, 0.28), wk.Elastic(210e9, 0.28))
CASES: dict[str, Callable[[np.random.Generator], tuple[float, float]]] = {}
"""Case by its name."""
ANSWERS: dict[str, str] = {}
"""Stated error, ``Class.name`` or a module with notes, by the case that tries it."""
QUICK: list[str] = []
"""Cases of which a few problems are solved by default."""


def states(*errors: str, quick: bool = False) -> Callable[[Any], Any]:
    """Return what enters a case with the errors that it tries."""

    def enter(case: Any) -> Any:
        CASES[case.__name__] = case
        ANSWERS.update(dict.fromkeys(errors, case.__name__))
        QUICK.extend([case.__name__] if quick else [])
        return case

    return enter


def change(found, true, scale=None):
    """Return the greatest difference over a scale, the greatest of the true numbers unless given."""
    return float(np.max(np.abs(np.asarray(found) - true)) / (np.max(np.abs(true)) if scale is None else scale))


def exceeded(*pairs):
    """Return one, and the greatest ratio of a true error to the stated one."""
    return 1.0, max(float(true) / float(stated) if true > 0.0 else 0.0 for stated, true in pairs)


@states("problems.viscoelastic.layered_notes")
def relaxing_layers(rng):
    """Force of a relaxation test, depth of a creep test; the note names their error."""
    film = StandardSolid(1.0, 10.0 ** rng.uniform(-1, 1.5), 10.0 ** rng.uniform(-1, 1), poisson=rng.uniform(0.2, 0.5))
    base = wk.Elastic(10.0 ** rng.uniform(-1, 3), rng.uniform(0.1, 0.45)) if rng.random() < 0.7 else wk.Rigid()
    thickness, shape = 10.0 ** rng.uniform(-2, 0), rng.integers(3)
    layers = wk.ViscoelasticCoatedHalfSpace([wk.ViscoelasticLayer(film, thickness)], on=base)
    bed = wk.Foundation((wk.Paraboloid(1.0), wk.Cone(1.4), wk.FlatPunch(0.1))[shape], layers)
    times, depth = np.sort(10.0 ** rng.uniform(-2, 2, 4)), rng.uniform(0.02, 0.3) * thickness
    if rng.random() < 0.4:
        load = wk.Force(float(wk.Indentation(wk.Foundation(bed.profile, layers.glassy), wk.Depth(depth)).solve().force))
        test, name, place = wk.CreepTest(bed, load.force, times), "depth", 0
    else:
        load, test, name, place = wk.Depth(depth), wk.RelaxationTest(bed, depth, times), "force", 1
    found = test.solve()
    stated = next(re.search(r"change force or depth by (\S+) of", note.statement) for note in found.validity[::-1]
                  if "Half as many" in note.statement)  # fmt: skip
    return float(stated[1]), change(getattr(found, name), stepped("", bed, times, load, 768)[place])


def random_bed(rng):
    """Return a smooth or sharp body on a half-space, and how deep it is pressed."""
    angle, radius = rng.uniform(0.8, 1.5), 10.0 ** rng.uniform(-4, -2)
    shape = (wk.Sphere(radius), wk.Cone(angle), wk.SpheroConical(radius, angle), wk.RoundedPunch(radius, radius))
    return wk.Foundation(shape[rng.integers(4)], wk.HalfSpace(wk.Elastic(1e9, 0.3))), rng.uniform(0.01, 0.1) * radius


@states("ContactLawSolution.hermite_error", "ContactLawSolution.linear_error", quick=True)
def contact_law(rng):
    """Forces between the rows of a table, by cubics and by straight lines."""
    bed, deepest = random_bed(rng)
    law = wk.ContactLaw(bed, deepest, tolerance=10.0 ** rng.uniform(-6, -2)).solve()
    between = np.sort(rng.uniform(0.0, law.depth[-1], 4000))
    true = np.asarray(wk.Indentation(bed, wk.Depth(between)).solve().force)
    cubic = CubicHermiteSpline(law.depth, law.force, law.stiffness)(between)
    straight = np.interp(between, law.depth, law.force)
    errors = [change(each, true, law.force[-1]) for each in (cubic, straight)]
    return exceeded((law.hermite_error + ROUNDING, errors[0]), (law.linear_error + ROUNDING, errors[1]))


def said_of_law(law):
    """Return by how much an exported law says that its force is off."""
    return float(re.search(r"off by at most (\S+) of the greatest", " ".join(law.notes))[1])


@states("exporting.laws.normal", quick=True)
def exported_table(rng):
    """Forces of an exported contact without friction, which its note states."""
    bed, deepest = random_bed(rng)
    law = law_of(wk.Indentation(bed, wk.Depth(deepest)), tolerance=10.0 ** rng.uniform(-6, -2), count=2)
    depth = np.sort(rng.uniform(0.0, deepest, 500))
    true = np.asarray(wk.Indentation(bed, wk.Depth(np.append(depth, deepest))).solve().force)
    # the note has two digits
    return 1.05 * said_of_law(law), change(law.trace(depth[:, None])[:, 0], true[:-1], true[-1])


@states("exporting.laws.relaxing")
def exported_springs(rng):
    """Forces of an exported sum over springs, pressed at once into a solid that flows: three times its G of an E."""
    radius, shear = 10.0 ** rng.uniform(-4, -2), 1e6
    shape = (wk.Paraboloid(radius), wk.Cone(1.2), wk.RoundedPunch(0.3 * radius, radius))[rng.integers(3)]
    flowing = wk.ViscoelasticHalfSpace(wk.Maxwell(shear=shear, relaxation_time=0.3))
    deepest, count = 0.05 * radius, int(10.0 ** rng.uniform(1.0, 2.0))
    path = wk.Path([0.0, 1.0, 1.5], wk.Depth([0.0, deepest, 0.5 * deepest]))
    law = law_of(wk.ViscoelasticIndentation(wk.Foundation(shape, flowing), path), tolerance=1e-6, count=count)
    depth = np.append(rng.uniform(0.02, 1.0, 60), 1.0) * deepest
    bed = wk.Foundation(shape, wk.HalfSpace(wk.Elastic(3.0 * shear, 0.5)))
    true = np.asarray(wk.Indentation(bed, wk.Depth(depth)).solve().force)
    found = [law.trace(np.array([[each, 0.0]]))[0, 0] for each in depth]
    return 1.05 * said_of_law(law), change(found, true, true[-1])


@states("RollerNumbers.grid_error", "problems.rollers.roller_contact")
def roller(rng):
    """Depth, force and pressures of a roller, on layers every second time."""
    logarithmic = wk.LogarithmicEnds(10.0 ** rng.uniform(-4, -3), load_factor=1.5, crowned_share=0.7)
    ends = (wk.CrownedEnds(10.0 ** rng.uniform(0, 2)), wk.RoundedEnds(rng.uniform(0.05, 0.5)), logarithmic)
    load = wk.Force(10.0 ** rng.uniform(-4.5, -3))
    length, kind = rng.uniform(1.5, 4.0), rng.integers(3)
    film = wk.Layer(
        wk.Elastic(10.0 ** rng.uniform(-1, 1), rng.uniform(0.0, 0.45)), thickness=10.0 ** rng.uniform(-3, -0.5)
    )
    body = (UNIT, wk.CoatedHalfSpace([film], on=wk.Elastic(1.0, 0.2)))[rng.integers(2)]
    rough, fine = (wk.RollerContact(1.0, length, ends[kind], body, load, elements=count).solve() for count in (64, 256))
    names = ("depth", "peak_pressure", "middle_pressure")
    return rough.grid_error, max(abs(getattr(rough, name) / getattr(fine, name) - 1.0) for name in names)


@states("ProfilePairSolution.grid_error", "problems.profile_pair.notes", quick=True)
def profile_pair(rng):
    """Force and greatest pressure of two profiles."""
    y = np.linspace(-2e-3, 2e-3, 81)
    radius, wavy = rng.uniform(5e-3, 30e-3), 1e-7 * rng.uniform(0.0, 1.0) * np.cos(y / 2e-4 + rng.uniform(0.0, 6.0))
    flat, ball = wk.CrossProfile(y, 0.0 * y), wk.CrossProfile(y, y**2 / (2.0 * radius) + wavy)
    depth = wk.Depth(10.0 ** rng.uniform(-6, -5.3))
    rough, fine = (
        wk.ProfilePair(flat, ball, STEEL, depth, second_radius=10e-3, pixels=pixels).solve() for pixels in (24, 128)
    )
    return rough.grid_error, max(
        abs(rough.force / fine.force - 1.0), abs(rough.peak_pressure / fine.peak_pressure - 1.0)
    )


@states("ProfilePairRollingSolution.grid_error", "problems.profile_pair.pair_rolling")
def rolling_pair(rng):
    """Forces of a barrel that rolls and drifts on a flat rail."""
    y = np.linspace(-4e-3, 4e-3, 81)
    flat, barrel = wk.CrossProfile(y, 0.0 * y), wk.CrossProfile(y, y**2 / (2.0 * rng.uniform(5e-3, 30e-3)))
    load, drift = 10.0 ** rng.uniform(1.5, 2.5), 3e-3 * rng.uniform(-1.0, 1.0)
    turned = 20e-3 * (1.0 + rng.choice([-1.0, 1.0]) * 10.0 ** rng.uniform(-4, -2))

    def forces(pixels):
        pair = wk.ProfilePair(
            flat, barrel, STEEL, wk.Force(load), second_radius=20e-3, rolled_radius=turned, pixels=pixels
        )
        return wk.ProfilePairRolling(pair, wk.Coulomb(0.3), lateral_drift=drift).solve()

    rough, fine = forces(32), forces(96)
    differences = [getattr(rough, name) - getattr(fine, name) for name in ("x_force", "y_force", "z_force")]
    return rough.grid_error, change(differences, 0.0, 0.3 * load)


def pressed_ellipse(rng):
    """Return what draws an ellipse of Hertz's pressure with friction on so many pixels; its edge lies between them."""
    a, b = 1e-3, 1e-3 * rng.uniform(0.4, 2.0)
    x_middle, y_middle = 1e-4 * rng.uniform(-1.0, 1.0, 2)

    def load(count):
        pixel = 4.4 * np.array([a, b]) / count
        x, y = ((np.arange(count) - 0.5 * (count - 1)) * each for each in pixel)
        inside = 1.0 - ((x[:, None] - x_middle) / a) ** 2 - ((y[None, :] - y_middle) / b) ** 2
        pressure = 1e9 * np.sqrt(np.maximum(inside, 0.0))
        return wk.SurfaceLoad(pressure, pixel * count, 0.2 * pressure)

    return load


@states(
    "SurfaceFrictionHeatingSolution.grid_error",
    "SurfaceHeatState.grid_error",
    "problems.surface_heating.notes",
    quick=True,
)
def sliding_heat(rng):
    """Greatest temperature of bodies that slide."""
    load, speeds = pressed_ellipse(rng), 10.0 ** rng.uniform(-3, 1, 2)
    pair = wk.HeatConductors(wk.ThermalConductor(50.0, 1.4e-5), wk.ThermalConductor(10.0 ** rng.uniform(0, 2), 1e-5))
    rough, fine = (
        wk.SurfaceFrictionHeating(load(count), pair, float(-speeds[0]), float(speeds[1])).solve() for count in (24, 96)
    )
    return rough.grid_error, abs(rough.max_temperature / fine.max_temperature - 1.0)


@states("MapStressSolution.grid_error", "problems.subsurface.map_stress")
def stress_below(rng):
    """Greatest stress below a map of pressures and tractions."""
    load, steel = pressed_ellipse(rng), wk.Elastic(210e9, rng.uniform(0.1, 0.45))
    rough, fine = (wk.MapStress(load(count), steel).solve() for count in (24, 96))
    return rough.grid_error, abs(rough.von_mises / fine.von_mises - 1.0)


def fractional_relaxation(time, exponent, terms=32):
    """Return Mittag-Leffler's E(-t^alpha), by Talbot's contour around its transform."""
    theta = (2.0 * np.arange(terms) + 1.0) * np.pi / terms - np.pi
    cotangent = 1.0 / np.tan(0.6407 * theta)
    z = terms * (0.5017 * theta * cotangent - 0.6122 + 0.2645j * theta)
    slope = terms * (0.5017 * cotangent - 0.5017 * 0.6407 * theta / np.sin(0.6407 * theta) ** 2 + 0.2645j)
    s = z / time[:, None]
    return np.real(np.sum(np.exp(z) * slope / (s * (1.0 + s**-exponent)), axis=1) / (1j * terms)) / time


@states("FittedSolid.series_error", quick=True)
def fractional_series(rng):
    """Relaxation of a springpot, and of a fractional Zener solid, by closed form and from its transform."""
    exponent, tolerance = rng.uniform(0.1, 0.9), 10.0 ** rng.uniform(-8, -2)
    span = 10.0 ** np.sort(rng.uniform(-6, 6, 2))
    t = np.exp(rng.uniform(*np.log(span), 3000))
    relaxed = rng.uniform(0.0, 2.0)
    power = wk.PowerLawSolid(2.0, 1.0, exponent, *span, tolerance=tolerance)
    zener = wk.FractionalZener(relaxed, 1.0, 1.0, exponent, *span, tolerance=tolerance)
    known = 2.0 * t**-exponent, relaxed + fractional_relaxation(t, exponent)
    return exceeded(
        *(
            (solid.series_error + 1e-11, np.max(np.abs(solid.relaxation(t) / true - 1.0)))
            for solid, true in zip((power, zener), known, strict=True)
        )
    )


@states("FittedSolid.series_error", quick=True)
def measured_series(rng):
    """What the series of a measured solid misses of its rows: of a series of five times."""
    times, moduli, relaxed = 10.0 ** rng.uniform(-2, 2, 5), rng.uniform(0.1, 2.0, 5), rng.uniform(0.5, 2.0)
    t = np.geomspace(1e-3, 1e3, 60)
    noise = 1.0 + 10.0 ** rng.uniform(-6, -2) * rng.standard_normal(60)
    relaxation = noise * (relaxed + np.exp(-t[:, None] / times) @ moduli)
    found = wk.RelaxationData(t, relaxation)
    creep = wk.CreepData(t, np.maximum.accumulate(1.0 / np.minimum.accumulate(relaxation)))
    wt = t[:, None] * times
    storage, loss = (relaxed + wt**2 / (1.0 + wt**2) @ moduli) * noise, (wt / (1.0 + wt**2)) @ moduli
    swings = wk.DynamicData(t, storage, loss)
    series = swings.series
    by_time = t[:, None] * series.times
    swung = series.relaxed + by_time**2 / (1.0 + by_time**2) @ series.moduli
    lost = by_time / (1.0 + by_time**2) @ series.moduli + series.viscosity * t
    size = np.hypot(storage, loss)
    return exceeded(
        (found.series_error + 1e-9, change(found.relaxation(t) / relaxation, 1.0)),
        (creep.series_error + 1e-9, change(creep.creep(t) / creep.compliance, 1.0)),
        (swings.series_error + 1e-9, max(np.max(np.abs(swung - storage) / size), np.max(np.abs(lost - loss) / size))),
    )


def hertzian_ellipse(narrow, wide, force):
    """Return the semi-axes of the contact under a gap of ``narrow x^2 + wide y^2``, E* = 1 (Johnson, sec. 4.2)."""

    def curvatures(ratio):
        m = 1.0 - ratio**2
        return (ellipe(m) / ratio**2 - ellipk(m)) / (ellipk(m) - ellipe(m)) - wide / narrow

    ratio = brentq(curvatures, 1e-3, 1.0 - 1e-6)
    m = 1.0 - ratio**2
    a = np.cbrt(1.5 * force / np.pi * (ellipk(m) - ellipe(m)) / m / narrow)
    return a, ratio * a


AREAS = [
    f"{name}.area_error"
    for name in (
        "SurfaceContactSolution", "SurfaceState", "MapSlip", "MapWear", "MapAdhesion",
    )
]  # fmt: skip


@states(*AREAS, "problems.rough.surface_notes", quick=True)
def elliptic_spot(rng):
    """Area and greatest pressure of an ellipse whose edges and middle fall anywhere between pixels."""
    wide = 10.0 ** rng.uniform(0.02, 1.0)
    a, b = hertzian_ellipse(1.0, wide, 1.0)
    across = int(rng.integers(16, 48))
    pixel = 2.0 * a * 10.0 ** rng.uniform(0.1, 0.4) / across * np.array([1.0, rng.uniform(0.6, 1.6)])
    shape = across, min(int(2.6 * b / pixel[1]) + 4, 64)
    x, y = ((np.arange(n) - 0.5 * (n - 1) + rng.uniform(-0.5, 0.5)) * h for n, h in zip(shape, pixel, strict=True))
    tip = wk.Topography(-(x[:, None] ** 2) - wide * y**2, np.array(shape) * pixel)
    found = wk.SurfaceContact(tip, UNIT, wk.Force(1.0)).solve()
    low = re.search(r"pressure may be up to (\S+) per cent too low", " ".join(map(str, found.validity)))
    highest = 1.5 / (math.pi * a * b)
    return exceeded(
        (found.area_error / found.area, abs(found.area / (math.pi * a * b) - 1.0)),
        (1.05e-2 * float(low[1]), max(0.0, 1.0 - float(np.max(found.last.pressure)) / highest)),
    )


@states("SurfaceFrictionHeatingSolution.grid_error")
def rolling_heat(rng):
    """Greatest temperature of an elliptic contact that rolls and slips."""
    radii, load = np.sort(10.0 ** rng.uniform(-2.3, -1.3, 2)), 100.0
    semi_axes = np.array(hertzian_ellipse(*(0.5 / radii[::-1]), load / STEEL.modulus))[::-1]
    slip, speed = 10.0 ** rng.uniform(-3, -1.5), 10.0 ** rng.uniform(-1, 1.5)
    conductors = wk.HeatConductors(
        wk.ThermalConductor(50.0, 1.4e-5), wk.ThermalConductor(10.0 ** rng.uniform(0, 2), 1e-5)
    )

    def warm(pixels):
        body = wk.SampledProfile(2.6 * semi_axes, wk.CurvedBodies(*radii), (pixels, pixels))
        rolling = wk.SurfaceRolling(body, STEEL, wk.Force(load), wk.Coulomb(0.3), wk.Creepage(slip), speed=speed)
        return wk.SurfaceFrictionHeating(rolling, conductors).solve()

    rough, fine = warm(20), warm(60)
    return rough.grid_error, abs(rough.max_temperature / fine.max_temperature - 1.0)


def random_waves(rng):
    """Return what draws one random periodic map, without waves shorter than a quarter of so many pixels."""
    waves = int(rng.choice([8, 16]))
    number = np.fft.fftfreq(waves, 1.0 / waves)
    length = np.hypot(number[:, None], number)
    amplitude = np.where((length >= 1.0) & (length < waves / 2), np.maximum(length, 2.0) ** -1.8, 0.0)
    parts = amplitude * np.exp(2j * np.pi * rng.random((waves, waves)))

    def heights(count):
        spectrum = np.zeros((count, count), dtype=complex)
        spectrum[np.ix_(number.astype(int), number.astype(int))] = parts
        drawn = count**2 * np.fft.ifft2(spectrum).real
        return 0.01 * drawn / np.sqrt(0.5 * np.sum(np.abs(parts) ** 2))

    return heights


ON_MAPS = (
    *("TrueAreaSolution.area_error", "TrueAreaSolution.peak_pressure_error"),
    *("SealSolution.area_error", "SealSolution.leak_rate_error"),
)


@states(*ON_MAPS, "problems.pressed_maps.true_area", "problems.pressed_maps.seal")
def rough_map(rng):
    """Area, greatest pressure and leak of a random map, whose heights are known on four times as many points."""
    heights, load = random_waves(rng), wk.Force(0.05 * 10.0 ** rng.uniform(-2.5, 0.0))
    rough, fine = (
        wk.SurfaceContact(wk.Topography(heights(count), [1.0, 1.0], periodic=True), UNIT, load) for count in (64, 256)
    )
    touching, leaking = wk.TrueArea(rough).solve(), wk.Seal(rough, 1e-3, 1e5).solve()
    true = wk.Seal(fine, 1e-3, 1e5).solve()
    return exceeded(
        (touching.area_error, abs(touching.area - true.area)),
        (leaking.area_error, abs(leaking.area - true.area)),
        (touching.peak_pressure_error, abs(touching.peak_pressure - np.max(true.contact.last.pressure))),
        (leaking.leak_rate_error, abs(leaking.leak_rate - true.leak_rate)),
    )


@states("LineProfileSolution.strip_error", quick=True)
def cylinder(rng):
    """Width and greatest pressure of refined strips: Hertz's."""
    radius, force = 10.0 ** rng.uniform(-1, 1), 10.0 ** rng.uniform(-6, -2)
    row = wk.CylinderRow([radius], [rng.uniform(-1.0, 1.0)], [0.0])
    found = wk.LineProfileContact(row, UNIT, wk.LineForce(force)).solve()
    width = 4.0 * math.sqrt(force * radius / math.pi)
    pairs = (found.contact_length, width), (found.peak_pressure, 4.0 * force / (math.pi * width))
    return exceeded(*((found.strip_error + ROUNDING, abs(one / true - 1.0)) for one, true in pairs))


@states()
def cylinder_on_layers(rng):
    """The same on a layer, refined, and on a grading, by elements: those of another engine, Chebyshev modes."""
    young, radius = 10.0 ** rng.uniform(-1, 1), 10.0 ** rng.uniform(0, 1)
    grading = wk.ExponentialGrading(1.0, young, 10.0 ** rng.uniform(-1, 0), 0.3)
    coated = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(1.0, 0.3), 10.0 ** rng.uniform(-1, 0))], wk.Elastic(young, 0.4))
    pairs = []
    for medium in (coated, wk.DepthGradedHalfSpace(grading)):
        bed = wk.LayeredLineFoundation(wk.Paraboloid(radius), medium)
        known = wk.LineIndentation(bed, wk.HalfWidth(10.0 ** rng.uniform(-1.5, 0))).solve()
        row, force = wk.CylinderRow([radius], [rng.uniform(-1.0, 1.0)], [0.0]), wk.LineForce(known.force_per_length)
        found = wk.LineProfileContact(row, medium, force).solve()
        pairs += [(found.strip_error + 1e-10, abs(found.contact_length / (2.0 * known.half_width) - 1.0))]
        pairs += [(found.strip_error + 1e-10, abs(found.peak_pressure / known.peak_pressure - 1.0))]
    return exceeded(*pairs)


@states("problems.line_strips.profile_notes", quick=True)
def measured_section(rng):
    """Contact length and greatest pressure of points measured across a wavy cylinder, sixteen times as many."""
    waves, phase, height = rng.integers(3, 20, 6), rng.uniform(0.0, 6.0, 6), 1e-6 * rng.uniform(0.0, 1.0, 6)
    radius, count = 10.0 ** rng.uniform(-0.5, 0.5), int(rng.integers(200, 1200))
    force = wk.LineForce(10.0 ** rng.uniform(-6.5, -5.0))

    def solved(cells):
        x = np.linspace(-5e-3, 5e-3, cells + 1)
        z = x**2 / (2.0 * radius) + np.cos(200.0 * np.pi * x[:, None] * waves + phase) @ height
        return wk.LineProfileContact(wk.MeasuredSection(x, z), UNIT, force).solve()

    rough, fine = solved(count), solved(16 * count)
    names = ("contact_length", "peak_pressure")
    return rough.strip_error, max(abs(getattr(rough, name) / getattr(fine, name) - 1.0) for name in names)


@states("LineRollingSolution.loss_error", "problems.line_rolling.strip_stresses")
def coupled_roller(rng):
    """Creepage, force and loss of dissimilar cylinders, extrapolated from twice as many elements."""
    slope, beta, friction = 10.0 ** rng.uniform(-5, -1), rng.uniform(-0.5, 0.5), 10.0 ** rng.uniform(-3, 0.3)
    kind, used, load = rng.integers(3), rng.uniform(-1.0, 1.0), 0.25 * np.pi * slope
    drives = {"force": 0.0}, {"force": used * friction * load}, {"creepage": 1.2 * used * friction * slope}
    soft = wk.Elastic(1.0, (0.5 - abs(beta)) / (1.0 - abs(beta)))
    pair = (soft, wk.Rigid()) if beta > 0.0 else (wk.Rigid(), soft)
    bed = wk.LineFoundation(wk.Paraboloid(1.0 / slope), wk.HalfSpace(*pair))
    rough, fine = (rolled_strip(bed, 1.0, friction, **drives[kind], count=count) for count in (400, 800))
    true = {
        name: (4.0 * getattr(fine, name) - getattr(rough, name)) / 3.0 for name in ("creepage", "force", "loss")
    }  # of the second order
    eta = np.arctanh(abs(beta)) / np.pi
    stuck = 2.0 * eta * slope / math.sqrt(1.0 + 4.0 * eta**2)
    off = {name: abs(getattr(rough, name) - number) for name, number in true.items()}
    return exceeded(
        (creepage_error(rough) * max(abs(true["creepage"]), stuck), off["creepage"]),
        (creepage_error(rough) * friction * load, off["force"]),
        (loss_error(rough, slope), off["loss"]),
    )


@states("LinearCreepCoefficients.error")
def creep_coefficients(rng):
    """Kalker's coefficients by polynomials of twice the degree or more."""
    ratio, poisson = 10.0 ** rng.uniform(-0.7, 0.7), rng.uniform(0.0, 0.5)
    found, (c11, c22, c23, _, c33) = linear_creep_coefficients(ratio, poisson), _forces(ratio, poisson, 128)
    fine = np.array([c11, c22, c23, c33])
    return found.error, change(np.array([found.longitudinal, found.lateral, found.spin, found.turning]) / fine, 1.0)


@states("SpotClusterSolution.uncertainty", "problems.conduction.spots", quick=True)
def spot_cluster(rng):
    """Resistance of a few spots, some of which nearly touch, expanded to twice the degree."""
    count, gaps = int(rng.integers(2, 9)), np.zeros((1, 1))
    while np.min(gaps) <= 0.0:
        x, y, radius = *rng.uniform(0.0, 1.0, (2, count)), 10.0 ** rng.uniform(-2.0, -0.6, count)
        gaps = np.hypot(np.subtract.outer(x, x), np.subtract.outer(y, y)) - 1.02 * np.add.outer(radius, radius)
        np.fill_diagonal(gaps, 1.0)
    unit = wk.ElectricalConductor(resistivity=1.0)
    found: SpotClusterSolution = wk.SpotCluster(x, y, radius, unit, unit).solve()
    true = 1.0 / (math.pi * float(np.sum(currents(x, y, radius, 12)[0])))
    return found.uncertainty + ROUNDING, abs(found.resistance / true - 1.0)


@states("problems.friction.spring_states", quick=True)
def springs_under_a_sphere(rng):
    """The shear force of a march of springs against the rule for one direction of motion, which needs none."""
    bed, count = wk.Foundation(wk.Paraboloid(1.0), UNIT), int(10.0 ** rng.uniform(1.3, 2.5))
    top = wk.Indentation(bed, wk.Radius(0.4)).solve()
    slide = 0.4 * top.depth * UNIT.modulus / UNIT.shear_modulus
    depth, shift = top.depth * rng.uniform(0.2, 1.0, 12), 0.7 * slide * rng.uniform(-1.0, 1.0, 12)
    path = wk.Path(np.arange(12.0), wk.Depth(depth), wk.Shift(shift))
    marched = wk.Tangential(bed, wk.Coulomb(0.4), path, wk.Method.SPRINGS, count).solve()
    known = wk.Tangential(bed, wk.Coulomb(0.4), path).solve()
    stated = next(re.search(r"is below (\S+) of", str(note)) for note in marched.validity if "springs: " in str(note))
    return float(stated[1]), change(marched.shear_force, known.shear_force, 0.4 * np.max(known.force))


@states("EllipticSolution.grid_error", "EllipticSolution.edge_error", "NearlyRoundSolution.grid_error",
        "NearlyRoundSolution.edge_error", "problems.pressed_shape.notes")  # fmt: skip
def shapes_by_pixels(rng):
    """Balls pressed by pixels on random coatings; the round engine has the true numbers."""
    layer, base = wk.Elastic(10.0 ** rng.uniform(-1.5, 1.3), rng.uniform(0.0, 0.45)), wk.Elastic(1.0, 0.3)
    coat = wk.CoatedHalfSpace([wk.Layer(layer, 0.1 * 10.0 ** rng.uniform(-1, 0.7))], on=base)
    ball = wk.Indentation(wk.Foundation(wk.Paraboloid(10.0), coat), wk.Radius(0.1)).solve()
    load = wk.Force(float(ball.force)) if rng.random() < 0.5 else wk.Depth(float(ball.depth))
    if rng.random() < 0.5:
        found = wk.NearlyRoundIndentation((wk.Paraboloid(10.0),) * 8, coat, load).solve()
        errors, edges = (found.depth / ball.depth, found.force / ball.force), found.contour / 0.1
    else:
        found = wk.EllipticIndentation(wk.CurvedBodies(10.0, 10.0), coat, load).solve()
        errors = found.depth / ball.depth, found.force / ball.force, found.peak_pressure / ball.peak_pressure
        edges = np.array(
            [found.longitudinal_semi_axis / 0.1, found.lateral_semi_axis / 0.1, found.area * 100.0 / math.pi]
        )
    edges = np.append(edges, found.stiffness / ball.stiffness)
    return exceeded((found.grid_error, change(errors, 1.0)), (found.edge_error, change(edges, 1.0)))
