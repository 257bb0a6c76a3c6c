"""Many spots and rough bodies: Greenwood's clusters, Barber's bounds."""

from __future__ import annotations

import math

import numpy as np
import pytest

import winkler as wk

STEEL = wk.Elastic(young=210e9, poisson=0.3)
SILVER, COPPER = wk.ElectricalConductor(15.9e-9), wk.ElectricalConductor(16.8e-9)
PAIR = wk.ElectricalConductors(SILVER, COPPER)


def test_two_spots_of_a_boundary_element_study():
    """R / rho = 1.0080 by boundary elements for radii of three digits (theory 6); Greenwood's formula 1.0055."""
    unit = wk.ElectricalConductor(1.0)
    pair = wk.SpotCluster([0.0, 1.0], [0.0, 0.0], [0.334, 0.255], unit, unit).solve()
    assert pair.resistance == pytest.approx(1.0080, rel=5e-4)
    assert pair.greenwood == pytest.approx(1.0055, rel=5e-4)
    assert pair.alone == pytest.approx(1.0 / (2.0 * 0.589), rel=1e-14)
    assert pair.shares.sum() == pytest.approx(1.0, rel=1e-14)


def test_greenwoods_cluster_has_about_its_holm_radius():
    """Many small spots evenly over a disc crowd like that disc."""
    rings = [(0, 1), (1, 6), (2, 12), (3, 18)]
    x, y = zip(
        *[(k * math.cos(2 * math.pi * i / n), k * math.sin(2 * math.pi * i / n)) for k, n in rings for i in range(n)],
        strict=True,
    )
    unit = wk.ElectricalConductor(1.0)
    cluster = wk.SpotCluster(np.array(x), np.array(y), np.full(37, 0.05), unit, unit).solve()
    assert cluster.holm_radius == pytest.approx(3.9, rel=0.1)
    assert cluster.shares[0] < cluster.shares[-1]
    assert cluster.resistance == pytest.approx(cluster.greenwood, rel=0.02)


def test_spots_that_overlap_are_refused():
    with pytest.raises(wk.InvalidInput, match="overlap"):
        wk.SpotCluster([0.0, 1.0], [0.0, 0.0], [0.6, 0.5], SILVER, SILVER)


def test_barbers_bounds_to_the_digits_of_the_theory():
    bed = wk.Foundation(wk.Paraboloid(1.0), wk.HalfSpace.between(wk.Elastic(1.0, 0.0)))
    unit = wk.ElectricalConductor(1.0)
    bounds = wk.ConductanceBounds(bed, wk.ElectricalConductors(unit, unit), roughness=0.2, force=1.0).solve()
    assert bounds.least_stiffness == pytest.approx(1.076537, abs=1e-6)
    assert bounds.smooth_stiffness == pytest.approx(1.817121, abs=1e-6)
    assert bounds.greatest_stiffness == pytest.approx(2.843533, abs=1e-6)
    assert bounds.least_conductance == bounds.least_stiffness
    smooth = wk.ConductanceBounds(bed, wk.ElectricalConductors(unit, unit), roughness=0.0, force=1.0).solve()
    assert smooth.least_stiffness == smooth.greatest_stiffness == pytest.approx(smooth.smooth_stiffness, rel=1e-12)


@pytest.mark.parametrize(
    "profile", [wk.FlatPunch(1e-4), wk.RoundedPunch(1e-4, 1e-2), wk.Cone(1.4), wk.CappedCylinder(2e-4, wk.Sphere(1e-2))]
)
def test_bounds_by_brute_force(profile):
    """The chords themselves, over a grid of depths."""
    medium = wk.HalfSpace.between(STEEL)
    bed, rough, force = wk.Foundation(profile, medium), 3e-8, 100.0
    bounds = wk.ConductanceBounds(bed, PAIR, roughness=rough, force=force).solve()
    depth = wk.Indentation(bed, wk.Force(force)).solve().depth
    below = np.linspace(0.0, depth, 4001)[1:-1]
    above = depth + rough + np.geomspace(1e-3, 1e3, 4001) * depth
    less = (force - wk.Indentation(bed, wk.Depth(below)).solve().force) / (depth + rough - below)
    more = (wk.Indentation(bed, wk.Depth(above)).solve().force - force) / (above - depth - rough)
    chord = max(float(np.max(less)), force / (depth + rough))
    assert bounds.least_stiffness == pytest.approx(chord, rel=1e-5)
    assert bounds.greatest_stiffness == pytest.approx(float(np.min(more)), rel=1e-4)


def test_a_wavy_ball_keeps_within_the_bounds():
    medium = wk.HalfSpace.between(STEEL)
    wave = wk.Wavy(amplitude=1e-8, wavelength=1e-4)
    wavy = wk.Foundation(wk.Sum([wk.Paraboloid(10e-3), wave]), medium)
    radius = np.linspace(0.0, 3e-4, 4001)
    rough = float(np.ptp(wavy.height(radius) - wk.Paraboloid(10e-3).height(radius)))
    for force in (10.0, 50.0, 200.0):
        bounds = wk.ConductanceBounds(
            wk.Foundation(wk.Paraboloid(10e-3), medium), PAIR, roughness=rough, force=force
        ).solve()
        own = wk.Constriction(wk.Indentation(wavy, wk.Force(force)), PAIR).solve()
        assert bounds.least_conductance < own.conductance < bounds.greatest_conductance
