"""What the examples of bodies that relax, conduct, warm up, roll and wear are in Python."""

from __future__ import annotations

import numpy as np

import winkler as wk

BALL = wk.Sphere(10e-3)
BED = wk.Foundation(BALL, wk.HalfSpace(wk.Elastic(210e9, 0.3)))
FRICTION = wk.Coulomb(0.3)

# ------------------------------------------------------------------------------------------------ relaxing

RUBBER = wk.StandardSolid(relaxed_shear=1e6, shear=3e6, relaxation_time=0.1)
ON_RUBBER = wk.Foundation(BALL, wk.ViscoelasticHalfSpace(RUBBER))
GEL_FILM = wk.ViscoelasticCoatedHalfSpace([wk.ViscoelasticLayer(RUBBER, 1e-3)], on=wk.Elastic(3e9, 0.35))
IN_AND_OUT = wk.Program(
    [
        wk.Start(wk.Depth(0.0)),
        wk.Ramp(wk.Depth(100e-6), duration=0.1, count=20),
        wk.Hold(0.2, count=10),
        wk.Ramp(wk.Depth(0.0), duration=0.1, count=20),
    ]
)
RUBBED = wk.Program(
    [
        wk.Start(wk.Depth(0.0)),
        wk.Ramp(wk.Depth(100e-6), duration=0.1, count=20),
        wk.Oscillate(lateral=wk.Shift(50e-6), frequency=5.0, count=16),
        wk.Hold(0.2, count=10),
        wk.Ramp(wk.Depth(0.0), duration=0.1, count=20),
    ]
)
PULLED = wk.Program([wk.Start(wk.Depth(5e-6)), wk.Ramp(wk.Depth(-25e-6), duration=30.0, count=60)])
FILM = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(2.98e6, 0.49), thickness=1e-3)], on=wk.Rigid())
TIMES = np.array([1e-3, 1e-2, 1e-1, 1.0, 10.0])
WLF = wk.WilliamsLandelFerry(reference_temperature=298.15, first_constant=8.86, second_constant=101.6)
ARRHENIUS = wk.Arrhenius(reference_temperature=298.15, activation_energy=80e3)


def relaxing(medium):
    if not isinstance(medium, wk.RelaxingInProportion):
        medium = wk.ViscoelasticHalfSpace(medium)
    return wk.ViscoelasticIndentation(wk.Foundation(BALL, medium), IN_AND_OUT, count=200)


def warm(law):
    return relaxing(wk.AtTemperature(RUBBER, law, 313.15))


MEGA = 1e6
SWEPT = np.repeat([280.0, 300.0, 320.0, 340.0], 5)
STORED = """1.72 2.92 3.71 3.93 3.98  1.11 1.47 2.5 3.53 3.89  1.04 1.15 1.61 2.76 3.65  1.02 1.07 1.29 2.08 3.28"""
LOST = """
0.594 0.716 0.318 0.0922 0.024  0.142 0.449 0.764 0.449 0.142  0.0495 0.183 0.536 0.746 0.367
0.024 0.0922 0.318 0.716 0.594
"""
HELD = "3.97 3.89 3.59 2.84 1.85 3.82 3.4 2.5 1.6 1.18 3.52 2.71 1.75 1.23 1.06 3.15 2.16 1.41 1.11 1.03"
HOLDS = [
    wk.HeldForce(wk.Paraboloid(1e-3), depth, [1.0, 3.0, 9.0, 27.0, 81.0, 240.0, 720.0, 2200.0], force)
    for depth, force in (
        (10e-6, [26.4e-6, 25.9e-6, 24.8e-6, 23e-6, 21.4e-6, 20.3e-6, 19.7e-6, 19.4e-6]),
        (40e-6, [213e-6, 211e-6, 209e-6, 202e-6, 189e-6, 174e-6, 164e-6, 159e-6]),
    )
]
LOOP_WAY = (
    "0.00 -1.00 -2.00 -1.56 -1.11 -0.67 -0.22 0.22 0.67 1.11 1.56 2.00 1.56 1.11 0.67 0.22 -0.22 -0.67 "
    "-1.11 -1.56 -2.00 -1.00 0.00 "
)
LOOP_FORCE = (
    "0.00 -32.63 -50.00 -34.27 -19.17 -4.76 8.82 21.41 32.76 42.42 49.26 50.00 34.27 19.17 4.76 -8.82 "
    "-21.41 -32.76 -42.42 -49.26 -50.00 -15.49 15.25 "
)
OHMS = "589.06 474.08 364.60 298.16 248.02 196.39 165.37 141.44 117.95 103.59 "
SWEEPS = wk.DynamicSweeps(
    SWEPT,
    np.tile([0.1, 1.0, 10.0, 100.0, 1000.0], 4),
    np.array(STORED.split(), dtype=float) * MEGA,
    np.array(LOST.split(), dtype=float) * MEGA,
)
RELAXED = wk.RelaxationSweeps(SWEPT, np.tile(TIMES, 4), np.array(HELD.split(), dtype=float) * MEGA)

RELAXING = {
    **{kind: relaxing(RUBBER) for kind in ("standard_solid", "viscoelastic_half_space", "viscoelastic_indentation")},
    "maxwell": relaxing(wk.Maxwell(3e6, 0.1)),
    "kelvin_voigt": relaxing(wk.KelvinVoigt(1e6, 100e3)),
    "prony": relaxing(wk.Prony(1e6, [2e6, 0.5e6, 0.5e6], [0.01, 0.1, 1.0])),
    "generalised_kelvin": relaxing(wk.GeneralisedKelvin(2.5e-7, [5e-7, 2.5e-7], [0.05, 0.5])),
    "power_law_solid": relaxing(wk.PowerLawSolid(2e6, 1.0, 0.2, shortest=1e-4, longest=100.0)),
    "fractional_zener": relaxing(wk.FractionalZener(1e6, 3e6, 0.1, 0.5, shortest=1e-4, longest=100.0)),
    "relaxation_data": relaxing(wk.RelaxationData(TIMES, np.array([3.6e6, 2.9e6, 1.9e6, 1.3e6, 1.1e6]))),
    "creep_data": relaxing(wk.CreepData(TIMES, np.array([2.8e-7, 3.4e-7, 5.2e-7, 7.6e-7, 9e-7]))),
    "dynamic_data": relaxing(
        wk.DynamicData(
            np.array([0.1, 1.0, 10.0, 100.0, 1000.0]),
            np.array([1.1e6, 1.3e6, 1.9e6, 2.9e6, 3.6e6]),
            np.array([0.1e6, 0.25e6, 0.5e6, 0.5e6, 0.25e6]),
        )
    ),
    "at_temperature": warm(WLF),
    "williams_landel_ferry": warm(WLF),
    "arrhenius": warm(ARRHENIUS),
    **{
        kind: wk.RelaxationTest(wk.Foundation(BALL, GEL_FILM), depth=100e-6, time=np.geomspace(1e-3, 10.0, 33))
        for kind in ("viscoelastic_coated_half_space", "viscoelastic_layer")
    },
    "poroelastic_film": wk.RelaxationTest(
        wk.Foundation(BALL, wk.PoroelasticFilm(5e3, 0.3, 1e-9, 1e-3)), depth=100e-6, time=np.geomspace(1e-3, 10.0, 33)
    ),
    "relaxing_in_proportion": relaxing(wk.RelaxingInProportion(FILM, RUBBER, shear=1e6)),
    **{
        kind: wk.ViscoelasticAdhesion(ON_RUBBER, wk.RateDependentWork(0.05, 1e-6, 0.6), PULLED)
        for kind in ("rate_dependent_work", "viscoelastic_adhesion")
    },
    "saturating_work": wk.ViscoelasticAdhesion(
        ON_RUBBER, wk.SaturatingWork(work=0.05, fast_work=1.0, reference_speed=1e-3, exponent=0.5), PULLED
    ),
    **{kind: wk.MasterCurve(SWEEPS, 300.0) for kind in ("dynamic_sweeps", "master_curve")},
    "relaxation_sweeps": wk.MasterCurve(RELAXED, 300.0),
    "poroelastic_relaxation": wk.PoroelasticRelaxation(
        wk.Paraboloid(1e-3), 5e3, 0.3, 1e-9, depth=20e-6, time=np.geomspace(0.1, 1000.0, 33)
    ),
    **{kind: wk.HeldContacts(HOLDS) for kind in ("held_force", "held_contacts")},
    "creep_test": wk.CreepTest(ON_RUBBER, force=1.0, time=np.geomspace(1e-3, 10.0, 33)),
    "relaxation_test": wk.RelaxationTest(ON_RUBBER, depth=100e-6, time=np.geomspace(1e-3, 10.0, 33)),
    "harmonic_indentation": wk.HarmonicIndentation(ON_RUBBER, wk.Depth(100e-6), np.geomspace(0.1, 1000.0, 33)),
    "sliding_resistance": wk.SlidingResistance(ON_RUBBER, wk.Force(1.0), np.geomspace(1e-4, 1.0, 17)),
    "viscoelastic_impact": wk.ViscoelasticImpact(ON_RUBBER, mass=30e-3, velocity=1.0, count=100, tolerance=1e-3),
}

# ---------------------------------------------------------------------------------------------- conducting

SILVER = wk.ElectricalConductor(15.9e-9, 3.8e-3)
COPPER = wk.ElectricalConductor(16.8e-9, 3.8e-3)
PAIR = wk.ElectricalConductors(SILVER, SILVER)
STEEL = wk.ThermalConductor(45.0, 12e-6)
WARM_PAIR = wk.HeatConductors(STEEL, STEEL)


def resistance(conductors=PAIR):
    return wk.Constriction(BED, conductors, wk.Force(1.0))


def joint(conductors=WARM_PAIR):
    return wk.ThermalConstriction(BED, conductors, wk.Force(100.0), temperature_drop=10.0)


def heated(drive):
    return wk.JouleHeating(BED, PAIR, wk.Force(1.0), drive)


SPOTS = wk.SpotCluster(
    np.array([0.0, 10e-6, 5e-6]), np.array([0.0, 0.0, 8e-6]), np.array([2e-6, 3e-6, 1e-6]), SILVER, SILVER
)
CONDUCTING = {
    **{kind: resistance() for kind in ("constriction", "electrical_conductors")},
    **{
        kind: wk.MeasuredConstriction(
            BED,
            wk.ResistanceLog(
                [0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0], [float(f"{one}e-6") for one in OHMS.split()]
            ),
        )
        for kind in ("resistance_log", "measured_constriction")
    },
    **{
        kind: wk.FrictionLoops(
            BED,
            wk.Force(100.0),
            wk.FrictionLog(
                [float(f"{one}e-6") for one in LOOP_WAY.split()], [float(one) for one in LOOP_FORCE.split()]
            ),
        )
        for kind in ("friction_log", "friction_loops")
    },
    "plated": resistance(wk.ElectricalConductors(wk.Plated(SILVER, thickness=5e-6, on=COPPER), SILVER)),
    "rod": resistance(wk.ElectricalConductors(wk.Rod(SILVER, radius=1e-3, length=10e-3), SILVER)),
    "surface_film": resistance(wk.ElectricalConductors(SILVER, SILVER, wk.SurfaceFilm(1e-12))),
    **{kind: joint() for kind in ("thermal_constriction", "thermal_conductor", "heat_conductors")},
    "thermal_interface": joint(wk.HeatConductors(STEEL, STEEL, wk.ThermalInterface(interface_conductance=1e7))),
    **{kind: heated(wk.Current(5.0)) for kind in ("joule_heating", "current", "wiedemann_franz")},
    "voltage": heated(wk.Voltage(20e-3)),
    **dict.fromkeys(("spot_cluster", "electrical_conductor"), SPOTS),
    "named_electrical_conductor": wk.SpotCluster(
        SPOTS.x, SPOTS.y, SPOTS.radii, wk.NamedElectricalConductor("copper"), SILVER
    ),
    "named_thermal_conductor": joint(wk.HeatConductors(wk.NamedThermalConductor("copper"), STEEL)),
    "conductance_bounds": wk.ConductanceBounds(BED, PAIR, roughness=0.1e-6, force=10.0),
}

# ------------------------------------------------------------------------------------- rolling and heating

CREEPAGES = np.linspace(0.0, 6e-3, 25)
SPINNING = wk.Creepage(longitudinal=0.0005, spin=5.0)


def rolled_wheel(drive, friction=FRICTION):
    return wk.SurfaceRolling(
        wk.SampledProfile([0.6e-3, 0.5e-3], wk.CurvedBodies(20e-3, 10e-3), (54, 45)),
        wk.HalfSpace.between(wk.Elastic(210e9, 0.3), wk.Elastic(210e9, 0.3)),
        wk.Force(100.0),
        friction,
        drive,
        speed=20.0,
    )


def rolling(**more):
    return wk.Rolling(BED, FRICTION, wk.Creepage(longitudinal=CREEPAGES), wk.Force(100.0), **more)


def wheel(footprint):
    return wk.SimplifiedRolling(footprint, BED.medium, FRICTION, SPINNING, wk.Force(100.0))


def rubbing(**more):
    return wk.FrictionHeating(BED, FRICTION, wk.Force(20.0), WARM_PAIR, first_speed=1.0, **more)


FRETTED = wk.Program([wk.Start(wk.Force(100.0)), wk.Oscillate(lateral=wk.Shift(1e-6), cycles=2.0)])
ROLLING = {
    **{kind: rolling() for kind in ("rolling", "creepages", "kalker")},
    "uncalibrated": rolling(calibration=wk.Uncalibrated()),
    **{kind: wheel(wk.ContactEllipse(0.2e-3, 0.15e-3)) for kind in ("simplified_rolling", "contact_ellipse")},
    "curved_bodies": wheel(wk.CurvedBodies(20e-3, 10e-3)),
    "rolling_start": wk.RollingStart(BED, FRICTION, wk.Creepage(longitudinal=0.001), wk.Force(100.0), distance=0.6e-3),
    "oscillating_rolling": wk.OscillatingRolling(
        BED, FRICTION, amplitude=40e-6, shear_force=15.0, load=wk.Force(100.0)
    ),
}
HEATING = {
    **{kind: rubbing() for kind in ("friction_heating", "equal_maximum")},
    "equal_mean": rubbing(partition=wk.EqualMean()),
    "fixed_share": rubbing(partition=wk.FixedShare(first_share=0.5)),
    "transient_heating": wk.TransientHeating(
        BED, FRICTION, wk.Force(20.0), WARM_PAIR, speed=10e-3, time=np.geomspace(1e-5, 1.0, 16)
    ),
    "fretting_heat": wk.FrettingHeat(wk.Tangential(BED, FRICTION, FRETTED), frequency=100.0, conductors=WARM_PAIR),
}

# ------------------------------------------------------------------------------------------------- wearing

ARCHARD = wk.Archard(1e-14)


def fretting(wear):
    cycles = np.array([0.0, 100.0, 1000.0, 3000.0, 10000.0])
    return wk.FrettingWear(BED, wear, FRICTION, wk.Force(100.0), wk.Shift(0.5e-6), cycles, count=100)


WEARING = {
    **{kind: fretting(ARCHARD) for kind in ("fretting_wear", "archard")},
    "pair_wear": fretting(wk.PairWear(ARCHARD, wk.Archard(2e-14))),
    "sliding_wear": wk.SlidingWear(BED, ARCHARD, wk.Force(100.0), np.array([0.0, 0.1, 0.3, 1.0]), count=100),
    "limiting_profile": wk.LimitingProfile(BED, FRICTION, wk.Depth(1e-6), wk.Shift(0.2e-6)),
}
STEEL_LINE = wk.LineFoundation(wk.Paraboloid(10e-3), wk.HalfSpace.between(*2 * [wk.Elastic(210e9, 0.3)]))
PRESSED_LINE, SWUNG_LINE = wk.LineForce(100e3), wk.LineShearForce(15e3)
WEARING_LINES = {
    "line_fretting_wear": wk.LineFrettingWear(
        STEEL_LINE, ARCHARD, FRICTION, PRESSED_LINE, SWUNG_LINE, np.array([0.0, 1e4, 1e5, 3e5, 1e6]), count=100
    ),
    "line_sliding_wear": wk.LineSlidingWear(
        STEEL_LINE, ARCHARD, PRESSED_LINE, np.array([0.0, 0.1, 0.3, 1.0]), count=100
    ),
    "line_limiting_profile": wk.LineLimitingProfile(STEEL_LINE, FRICTION, PRESSED_LINE, SWUNG_LINE),
}

# ------------------------------------------------------------------------------------------------ roughness

STEEL_BODY = wk.HalfSpace(wk.Elastic(210e9, 0.3))
BLASTED = wk.SelfAffine(hurst=0.8, rms_height=0.3e-6, longest=0.5e-3, shortest=160e-6)
MILLIMETRES = np.array([1e-3, 1e-3])
SURFACE = wk.RandomTopography(MILLIMETRES, BLASTED, (64, 64))
STAMP = wk.RandomTopography(MILLIMETRES, BLASTED, (64, 64), seed=1, periodic=False)
HILL = 1e6 * np.array(
    [
        [0, 100, 150, 100, 0],
        [100, 250, 300, 250, 100],
        [150, 300, 350, 300, 150],
        [100, 250, 300, 250, 100],
        [0, 100, 150, 100, 0],
    ]
)
PYRAMID = (
    np.array(
        [[0, 0, 0, 0, 0, 0], [0, 2, 2, 2, 2, 0], [0, 2, 5, 4, 2, 0], [0, 2, 4, 4, 2, 0], [0, 2, 2, 2, 2, 0], [0] * 6]
    )
    / 1e6
)
LOADS = wk.Force(np.geomspace(10.0, 200.0, 5))
MEASURED_SPECTRUM = wk.PowerSpectrum(np.array([1e4, 1e5, 1e6]), np.array([1e-21, 4e-25, 1e-28]))
SOFT_BALL = wk.SampledProfile([240e-6, 240e-6], wk.Sphere(1e-3), (48, 48))
SOFT = wk.HalfSpace(wk.Elastic(1e6, 0.5))
TO_AND_FRO = wk.Depth(np.concatenate((np.linspace(-3e-6, 0.5e-6, 8), np.linspace(0.0, -3e-6, 7))))
RIVET = wk.RoughProfile(
    wk.RandomTopography(
        np.array([1e-4, 1e-4]),
        wk.SelfAffine(hurst=0.8, rms_height=50e-9, longest=50e-6, shortest=8e-6),
        (64, 64),
        seed=1,
    ),
    wk.Paraboloid(2e-3),
)
GOLD_ON_BRONZE = wk.Plated(wk.ElectricalConductor(22e-9, 3.8e-3), 2e-6, wk.ElectricalConductor(110e-9, 3.8e-3))
TOUCHING = wk.SurfaceContact(SURFACE, STEEL_BODY, LOADS)
PROFILES = (
    wk.CrossProfile(
        np.arange(-20.0, 21.0, 5.0) / 1e3,
        np.array([-667.4e-6, -375.2e-6, -166.7e-6, -41.7e-6, 0.0, -41.7e-6, -166.7e-6, -375.2e-6, -667.4e-6]),
    ),
    wk.CrossProfile(
        np.arange(-25.0, 26.0, 5.0) / 1e3,
        np.array([-0.0125, -0.1, -0.1375, -0.125, -0.0813, 0.0, 0.1188, 0.275, 0.4625, 0.675, 0.9125]) / 1e3,
    ),
)


def rough(spectrum):
    return wk.RoughContact(spectrum, STEEL_BODY, 1e-3, LOADS, realisations=20, count=1024)


ROUGHNESS = {
    **dict.fromkeys(("surface_contact", "random_topography"), TOUCHING),
    **dict.fromkeys(
        ("profile_pair", "cross_profile"),
        wk.ProfilePair(
            *PROFILES, wk.HalfSpace(wk.Elastic(210e9, 0.3)), wk.Force(50e3), yaw=5e-3, second_radius=0.46, pixels=64
        ),
    ),
    "profile_pair_rolling": wk.ProfilePairRolling(
        wk.ProfilePair(
            *PROFILES,
            wk.HalfSpace(wk.Elastic(210e9, 0.3)),
            wk.Force(50e3),
            yaw=1e-3,
            second_radius=0.46,
            rolled_radius=0.4602,
            pixels=48,
        ),
        FRICTION,
    ),
    "contact_stress": wk.ContactStress(wk.Indentation(BED, wk.Force(100.0))),
    **dict.fromkeys(
        ("map_stress", "surface_load"),
        wk.MapStress(
            wk.SurfaceLoad(
                HILL,
                [1e-3, 1e-3],
            ),
            wk.Elastic(210e9, 0.3, strength=500e6),
        ),
    ),
    "height_map": wk.SurfaceContact(wk.Topography(PYRAMID, MILLIMETRES), STEEL_BODY, LOADS),
    "sampled_profile": wk.SurfaceContact(wk.SampledProfile(MILLIMETRES, wk.Sphere(10e-3), (65, 65)), STEEL_BODY, LOADS),
    "surface_rolling": rolled_wheel(wk.Creepage(longitudinal=np.geomspace(0.0002, 0.004, 6))),
    "falling_friction": rolled_wheel(
        wk.Creepage(longitudinal=np.geomspace(0.0002, 0.004, 6)), wk.FallingFriction(0.4, 0.16, 0.1)
    ),
    **{kind: rolled_wheel(wk.CreepForce(15.0, twist=wk.Spin(5.0))) for kind in ("creep_forces", "spin")},
    "surface_rolling_heating": wk.SurfaceRollingHeating(
        wk.SurfaceRolling(
            wk.SampledProfile([0.6e-3, 0.5e-3], wk.CurvedBodies(20e-3, 10e-3), (42, 35)),
            wk.HalfSpace.between(wk.Elastic(210e9, 0.3), wk.Elastic(210e9, 0.3)),
            wk.Force(100.0),
            FRICTION,
            wk.Creepage(longitudinal=np.geomspace(0.001, 0.01, 6)),
            speed=20.0,
        ),
        wk.HeatConductors(wk.ThermalConductor(45.0, 12e-6), wk.ThermalConductor(45.0, 12e-6)),
    ),
    "surface_friction_heating": wk.SurfaceFrictionHeating(
        wk.SurfaceLoad(HILL, [1e-3, 1e-3], x_traction=HILL / -10.0 + 0.0),
        wk.HeatConductors(wk.ThermalConductor(45.0, 12e-6), wk.ThermalConductor(45.0, 12e-6)),
        first_speed=2.0,
    ),
    "surface_rolling_start": wk.SurfaceRollingStart(
        wk.SampledProfile([0.6e-3, 0.5e-3], wk.CurvedBodies(20e-3, 10e-3), (54, 45)),
        wk.HalfSpace.between(wk.Elastic(210e9, 0.3), wk.Elastic(210e9, 0.3)),
        wk.Force(100.0),
        FRICTION,
        wk.ShearForce(15.0),
        distance=0.5e-3,
    ),
    **dict.fromkeys(
        ("surface_adhesion", "exponential_attraction"),
        wk.SurfaceAdhesion(SOFT_BALL, SOFT, wk.ExponentialAttraction(50e-3, 0.65e-6), TO_AND_FRO),
    ),
    "lennard_jones": wk.SurfaceAdhesion(SOFT_BALL, SOFT, wk.LennardJones(50e-3, 0.8e-6), TO_AND_FRO),
    "surface_tangential": wk.SurfaceTangential(
        wk.SampledProfile(np.array([0.6e-3, 0.6e-3]), wk.Sphere(10e-3), (65, 65)),
        wk.HalfSpace.between(wk.Elastic(210e9, 0.3), wk.Elastic(210e9, 0.3)),
        FRICTION,
        wk.Program(
            [
                wk.Start(wk.Force(100.0)),
                wk.Oscillate(lateral=wk.Shift(1e-6), cycles=1.25, count=12),
            ]
        ),
    ),
    "linear_slip_weakening": wk.SurfaceTangential(
        wk.SampledProfile(np.array([0.6e-3, 0.6e-3]), wk.Sphere(10e-3), (65, 65)),
        wk.HalfSpace.between(wk.Elastic(210e9, 0.3), wk.Elastic(210e9, 0.3)),
        wk.LinearSlipWeakening(0.4, 0.3, 10e-6),
        wk.Program(
            [
                wk.Start(wk.Force(100.0)),
                wk.Oscillate(lateral=wk.Shift(1e-6), cycles=1.25, count=12),
            ]
        ),
    ),
    "exponential_slip_weakening": wk.SurfaceTangential(
        wk.SampledProfile(np.array([0.6e-3, 0.6e-3]), wk.Sphere(10e-3), (65, 65)),
        wk.HalfSpace.between(wk.Elastic(210e9, 0.3), wk.Elastic(210e9, 0.3)),
        wk.ExponentialSlipWeakening(0.4, 0.3, 10e-6),
        wk.Program(
            [
                wk.Start(wk.Force(100.0)),
                wk.Oscillate(lateral=wk.Shift(1e-6), cycles=1.25, count=12),
            ]
        ),
    ),
    "rough_profile": wk.SurfaceContact(
        wk.RoughProfile(STAMP, wk.Sphere(10e-3)),
        STEEL_BODY,
        LOADS,
    ),
    "surface_constriction": wk.SurfaceConstriction(
        wk.SurfaceContact(RIVET, STEEL_BODY, wk.Force([0.1, 1.0]), hardness=1e9),
        wk.ElectricalConductors(GOLD_ON_BRONZE, GOLD_ON_BRONZE),
        wk.Current(2.0),
        softening_temperature=373.0,
        melting_temperature=1336.0,
    ),
    "surface_wear": wk.SurfaceWear(
        wk.SurfaceContact(
            wk.RandomTopography(MILLIMETRES, BLASTED, (32, 32), seed=1, periodic=False), STEEL_BODY, wk.Force(100.0)
        ),
        wk.Archard(1e-14),
        np.array([0.0, 0.01, 0.05, 0.2]),
    ),
    "true_area": wk.TrueArea(wk.SurfaceContact(STAMP, STEEL_BODY, LOADS)),
    "seal": wk.Seal(wk.SurfaceContact(STAMP, STEEL_BODY, LOADS), viscosity=1e-3, pressure_drop=1e5),
    "thermal_joint": wk.ThermalJoint(wk.SurfaceContact(STAMP, STEEL_BODY, LOADS), WARM_PAIR, gap_conductivity=0.026),
    "surface_conduction": wk.SurfaceConduction(wk.SurfaceContact(STAMP, STEEL_BODY, LOADS), PAIR),
    "reduced_friction": wk.ReducedFriction(
        wk.SampledProfile(np.array([0.52e-3, 0.26e-3]), wk.CurvedBodies(20e-3, 5e-3), (65, 65)),
        wk.HalfSpace.between(wk.Elastic(210e9, 0.3), wk.Elastic(210e9, 0.3)),
        FRICTION,
        1.5e-6,
    ),
    "joint_stiffness": wk.JointStiffness(
        STAMP, wk.HalfSpace.between(wk.Elastic(210e9, 0.3), wk.Elastic(210e9, 0.3)), FRICTION, wk.Force(100.0)
    ),
    "reduction": wk.Reduction(STAMP, STEEL_BODY, 1e-6),
    "elliptic_foundation": wk.Indentation(
        wk.EllipticFoundation(wk.CurvedBodies(20e-3, 10e-3), STEEL_BODY), wk.Force(100.0)
    ),
    "reduced_bed": wk.Indentation(wk.ReducedBed(STAMP, STEEL_BODY, 1e-6), wk.Force(100.0)),
    **{kind: rough(BLASTED) for kind in ("rough_contact", "self_affine")},
    "power_spectrum": rough(MEASURED_SPECTRUM),
    "rough_indentation": wk.RoughIndentation(BLASTED, BED, 4e-3, LOADS, realisations=20, count=2048),
    "elliptic_indentation": wk.EllipticIndentation(wk.CurvedBodies(20e-3, 10e-3), STEEL_BODY, wk.Force(100.0)),
    "curved_pair": wk.EllipticIndentation(wk.CurvedPair(5e-3, 5e-3, 26e-3, -5.2e-3), STEEL_BODY, wk.Force(100.0)),
    "plastic_indentation": wk.PlasticIndentation(
        wk.Foundation(BALL, wk.HalfSpace(wk.Elastic(210e9, 0.3, strength=700e6))), wk.Force([100.0, 500.0, 0.0])
    ),
    "elliptic_yield_onset": wk.EllipticYieldOnset(
        wk.CurvedBodies(20e-3, 10e-3), wk.HalfSpace(wk.Elastic(210e9, 0.3, strength=700e6)), wk.Coulomb(0.1)
    ),
    "elliptic_wear": wk.EllipticWear(
        wk.CurvedBodies(20e-3, 10e-3),
        STEEL_BODY,
        wk.PairWear(wk.Archard(1e-17), wk.Archard(1e-14)),
        wk.Force(100.0),
        distance=1.0,
        angle=np.radians(30.0),
    ),
    "nearly_round_indentation": wk.NearlyRoundIndentation(
        tuple(wk.Paraboloid(radius) for radius in (10e-3, 12e-3, 10e-3, 12e-3)), STEEL_BODY, wk.Depth(1e-6)
    ),
    "elastomer_friction": wk.ElastomerFriction(BLASTED, RUBBER, np.geomspace(1e-6, 1.0, 25)),
}
# ------------------------------------------------------------------------------------------------ lines

ROLLER = wk.LineFoundation(wk.Paraboloid(10e-3), STEEL_BODY)
STRONG_ROLLER = wk.LineFoundation(wk.Paraboloid(10e-3), wk.HalfSpace(wk.Elastic(210e9, 0.3, strength=700e6)))


def crowned_roller(ends=None, alignment=None):
    """Return the roller of the examples."""
    ends, alignment = ends or wk.LogarithmicEnds(1e6), alignment or wk.Tilt(0.5e-3)
    return wk.RollerContact(10e-3, 10e-3, ends, STEEL_BODY, wk.Force(np.linspace(2e3, 12e3, 6)), alignment, 48)


def pressed_section(section=None, alignment=None):
    """Return the section of the examples under its load."""
    section = section or wk.CylinderRow([10e-3, 10e-3], [-0.25e-3, 0.25e-3], [0.0, 2e-6])
    return wk.LineProfileContact(section, STEEL_BODY, wk.LineForce(200e3), alignment or wk.Tilt(0.0))


SECTION_HEIGHTS = [36, 31, 25, 20, 18, 13, 9, 9, 4, 2, 3, 0, 1, 1, 0, 4, 3, 7, 10, 11, 17, 20, 24, 31, 35]
SECTIONS = {
    **dict.fromkeys(("line_profile_contact", "cylinder_row"), pressed_section()),
    "punch_row": pressed_section(wk.PunchRow([-1e-3, 0.4e-3], [-0.4e-3, 1e-3], [0.0, 0.0])),
    "mirrored_section": pressed_section(wk.MirroredSection(wk.Wavy(1e-6, 1e-3), 4.5e-3)),
    "formula_section": pressed_section(
        wk.FormulaSection("(x-m)**2/(2*R) + h*cos(2*pi*x/l)", 4e-3, m=1.9e-3, R=0.1, h=0.5e-6, l=0.4e-3)
    ),
    "measured_section": pressed_section(
        wk.MeasuredSection(np.linspace(-0.6e-3, 0.6e-3, 25), np.array(SECTION_HEIGHTS) / 1e6)
    ),
    "line_of_action": pressed_section(alignment=wk.LineOfAction(0.02e-3)),
}
STICKY_ROLLER = wk.LineFoundation(wk.Paraboloid(10e-3), wk.HalfSpace(wk.Elastic(2e6, 0.5)))
LINES = {
    **dict.fromkeys(
        ("line_indentation", "line_foundation", "line_force"), wk.LineIndentation(ROLLER, wk.LineForce(100e3))
    ),
    "half_width": wk.LineIndentation(ROLLER, wk.HalfWidth(0.1e-3)),
    "layered_line_foundation": wk.LineIndentation(
        wk.LayeredLineFoundation(
            wk.Paraboloid(10e-3),
            wk.CoatedHalfSpace([wk.Layer(wk.Elastic(450e9, 0.25), 50e-6)], wk.Elastic(210e9, 0.3)),
        ),
        wk.LineForce(100e3),
    ),
    "power_law_line_foundation": wk.LineIndentation(
        wk.PowerLawLineFoundation(wk.Paraboloid(10e-3), wk.GradedHalfSpace(wk.PowerLawGraded(220e9, 1e-3, 0.15, 0.25))),
        wk.LineForce(100e3),
    ),
    **dict.fromkeys(("roller_contact", "logarithmic_ends", "tilt"), crowned_roller()),
    "sharp_ends": crowned_roller(ends=wk.SharpEnds()),
    "crowned_ends": crowned_roller(ends=wk.CrownedEnds(0.5)),
    "rounded_ends": crowned_roller(ends=wk.RoundedEnds(1e-3)),
    "moment": crowned_roller(alignment=wk.Moment(2.0)),
    "line_yield_onset": wk.LineYieldOnset(STRONG_ROLLER, wk.Coulomb(0.1)),
    "line_shakedown": wk.LineShakedown(STRONG_ROLLER, wk.Coulomb(0.1)),
    **dict.fromkeys(
        ("line_tangential", "line_path"),
        wk.LineTangential(
            wk.LineFoundation(
                wk.Paraboloid(10e-3), wk.HalfSpace.between(wk.Elastic(210e9, 0.3), wk.Elastic(210e9, 0.3))
            ),
            FRICTION,
            wk.LinePath(100e3, [0.0, 20e3, -20e3, 20e3], count=20),
        ),
    ),
    "elliptic_friction_heating": wk.EllipticFrictionHeating(
        wk.CurvedBodies(20e-3, 10e-3),
        STEEL_BODY,
        wk.Coulomb(0.1),
        wk.Force(200.0),
        WARM_PAIR,
        first_speed=2.0,
        first_direction=np.radians(30.0),
    ),
    "line_constriction": wk.LineConstriction(ROLLER, PAIR, wk.LineForce(100e3), first_depth=5e-3, second_depth=5e-3),
    "line_friction_heating": wk.LineFrictionHeating(
        ROLLER, wk.Coulomb(0.05), wk.LineForce(400e3), WARM_PAIR, first_speed=6.0, second_speed=4.0
    ),
    "band_heating": wk.BandHeating(0.1e-3, 100e6, WARM_PAIR, first_speed=6.0, second_speed=4.0),
    "line_adhesion": wk.LineAdhesion(STICKY_ROLLER, wk.ShortRange(50e-3), wk.LineForce(1.0)),
    **dict.fromkeys(
        ("periodic_indentation", "nominal_pressure"),
        wk.PeriodicIndentation(wk.LineFoundation(wk.Wavy(1e-6, 1e-3), STEEL_BODY), 1e-3, wk.NominalPressure(100e6)),
    ),
    "mean_pressure": wk.LineIndentation(ROLLER, wk.MeanPressure(500e6)),
}
STEEL_ON_STEEL = wk.LineFoundation(wk.Paraboloid(10e-3), wk.HalfSpace.between(*2 * [wk.Elastic(210e9, 0.3)]))
RELAXING_LINES = dict.fromkeys(
    ("line_viscoelastic_indentation", "line_force_path"),
    wk.LineViscoelasticIndentation(
        wk.LineFoundation(wk.Paraboloid(10e-3), wk.ViscoelasticHalfSpace(RUBBER)),
        wk.LineForcePath([0.0, 1.0, 2.0, 2.5], [0.0, 1e3, 1e3, 0.0], count=20),
        count=200,
    ),
)
ROLLING_LINES = {
    "line_rolling": wk.LineRolling(
        STEEL_ON_STEEL, FRICTION, wk.Creepage(longitudinal=np.linspace(0.0, 0.004, 25)), wk.LineForce(100e3)
    ),
    "line_shear_force": wk.LineRolling(STEEL_ON_STEEL, FRICTION, wk.LineShearForce(15e3), wk.LineForce(100e3)),
    "line_rolling_start": wk.LineRollingStart(
        STEEL_ON_STEEL, FRICTION, wk.LineShearForce(19.2e3), wk.LineForce(100e3), distance=0.4e-3
    ),
    "line_rolling_resistance": wk.LineRollingResistance(
        wk.LineFoundation(wk.Paraboloid(10e-3), wk.ViscoelasticHalfSpace(RUBBER)),
        wk.LineForce(100.0),
        np.geomspace(1e-4, 1.0, 17),
    ),
}
NEWER = {
    **LINES,
    **SECTIONS,
    **RELAXING_LINES,
    **ROLLING_LINES,
    **RELAXING,
    **CONDUCTING,
    **ROLLING,
    **HEATING,
    **WEARING,
    **WEARING_LINES,
    **ROUGHNESS,
}
