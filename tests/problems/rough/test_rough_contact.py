"""Rough squares on lines of springs: scaling laws, seeds, conductance, and the distance to boundary elements."""

from __future__ import annotations

import csv

import numpy as np
import pytest

from winkler.laws.film import SurfaceFilm
from winkler.loading.loads import Depth, Force, Radius
from winkler.materials.conductor import ElectricalConductor, ThermalConductor
from winkler.materials.elastic import Elastic
from winkler.media.conduction.conductors import ElectricalConductors, HeatConductors
from winkler.media.halfspace import HalfSpace
from winkler.problems.rough.line_contact import RoughContact
from winkler.problems.rough.surface_contact import SurfaceContact
from winkler.profiles.rough.random_rough import random_topography
from winkler.profiles.rough.spectrum import SelfAffine
from winkler.profiles.rough.topography import Topography
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.validity import Standing

ONE = HalfSpace(Elastic(1.0, 0.0))
WIDE = SelfAffine(hurst=0.7, rms_height=0.01, longest=1.0, shortest=1.0 / 32)


@pytest.mark.parametrize("hurst", [0.5, 0.7, 0.8])
def test_the_stiffness_grows_with_a_power_of_the_force(hurst):
    """Pohrt and Popov: k ~ F^(1 / (1 + H)) for self-affine surfaces without roll-off; finite bands bend it a little."""
    surface = SelfAffine(hurst=hurst, rms_height=0.01, longest=2.0, shortest=1.0 / 512)
    forces = np.geomspace(1e-6, 1e-3, 13)
    result = RoughContact(surface, ONE, 1.0, Force(forces), realisations=60, count=8192).solve()
    exponent = np.polyfit(np.log(forces), np.log(result.stiffness), 1)[0]
    assert exponent == pytest.approx(1.0 / (1.0 + hurst), abs=0.03)


def test_bands_lie_around_the_median():
    forces = np.geomspace(1e-5, 1e-2, 13)
    result = RoughContact(WIDE, ONE, 1.0, Force(forces), realisations=60).solve()
    assert np.all(result.stiffness_band[0] <= result.stiffness)
    assert np.all(result.stiffness <= result.stiffness_band[1])
    assert np.all(result.depth_band[0] < result.depth_band[1])
    assert np.all(result.force_band == forces)


def test_pressed_flat_it_is_as_stiff_as_the_square():
    """k = 1.1523 E* L, boundary elements (theory 1.3: 1.15229)."""
    result = RoughContact(WIDE, ONE, 2.0, Force(10.0), realisations=3).solve()
    assert float(result.stiffness) == pytest.approx(1.15229 * 2.0, rel=1e-4)


def test_heights_are_those_of_the_spectrum():
    """The line bears the root mean squares of height and slope of the surface (theory 10)."""
    fine = SelfAffine(hurst=0.7, rms_height=0.01, longest=0.5, shortest=1.0 / 32)
    lines = [line.heights for line in RoughContact(fine, ONE, 4.0, Force(1.0), realisations=20).lines()]
    assert np.sqrt(np.mean(np.square(lines))) == pytest.approx(0.01, rel=2e-2)
    slopes = np.diff(lines, axis=1) / (1.1523 * 4.0 / 4096)
    assert np.sqrt(np.mean(slopes**2)) == pytest.approx(fine.rms_slope, rel=2e-2)


def test_seeds_repeat_and_depths_are_met():
    once = RoughContact(WIDE, ONE, 1.0, Depth([0.01, 0.02]), realisations=5, seed=7).solve()
    again = RoughContact(WIDE, ONE, 1.0, Depth([0.01, 0.02]), realisations=5, seed=7).solve()
    assert np.array_equal(once.force, again.force)
    assert once.depth.tolist() == [0.01, 0.02]
    assert np.all(np.diff(once.force) > 0.0)
    other = RoughContact(WIDE, ONE, 1.0, Depth([0.01, 0.02]), realisations=5, seed=8)
    shared = {line.heights.tobytes() for line in other.lines()} & {
        line.heights.tobytes() for line in once.problem.lines()
    }
    assert not shared


def test_conductance_is_in_proportion_to_the_stiffness():
    """Lambda = 2 k / (E* (rho_1 + rho_2)); of heat, one over the conductivity stands for rho."""
    result = RoughContact(WIDE, ONE, 1.0, Force([1e-3, 1e-2]), realisations=5).solve()
    pair = ElectricalConductors(ElectricalConductor(2e-8), ElectricalConductor(3e-8))
    assert result.conductance(pair) == pytest.approx(2.0 * result.stiffness / 5e-8, rel=1e-14)
    heat = HeatConductors(ThermalConductor(100.0, 1e-5), ThermalConductor(25.0, 1e-5))
    assert result.conductance(heat) == pytest.approx(2.0 * result.stiffness / 0.05, rel=1e-14)
    filmed = ElectricalConductors(pair.first, pair.second, SurfaceFilm(1e-12))
    with pytest.raises(OutsideValidity, match="without film or plating"):
        result.conductance(filmed)


def test_what_the_line_leaves_out_is_stated():
    fine = RoughContact(WIDE, ONE, 1.0, Force(1e-3), realisations=2).solve()
    limit = 0.2 * ONE.modulus * WIDE.rms_slope  # [N] on 1 m^2
    for force, standing in ((0.99 * limit, Standing.APPROXIMATE), (1.01 * limit, Standing.OUTSIDE)):
        heavy = RoughContact(WIDE, ONE, 1.0, Force([1e-3, force]), realisations=2).solve()
        assert [note.standing for note in heavy.validity if "Persson's" in note.statement] == [standing]
    assert not any("are not represented" in note.statement for note in fine.validity)
    coarse = RoughContact(WIDE, ONE, 0.5, Force(1e-3), realisations=2, count=16).solve()
    (statements,) = [note.statement for note in coarse.validity if "are not represented" in note.statement]
    assert "longer than the line (0.5762 m)" in statements
    assert "shorter than two springs (0.07202 m" in statements


def surfaces(spectrum, pixels, forces, seeds):
    """Return the stiffness and depth of stamps, by boundary elements."""
    rows = []
    for seed in seeds:
        heights = random_topography(spectrum, (pixels, pixels), [1.0, 1.0], seed).heights
        result = SurfaceContact(Topography(heights, [1.0, 1.0]), ONE, Force(forces)).solve()
        rows.append((result.stiffness, result.depth))
    return np.median(rows, axis=0)


def test_against_boundary_elements():
    """The stiffness within 40 per cent, as the note states: four surfaces of 64 x 64 pixels."""
    surface = SelfAffine(hurst=0.8, rms_height=0.01, longest=1.0, shortest=0.125)
    forces = 0.01 * np.array([0.1, 1.0, 10.0])
    stiffness, depth = surfaces(surface, 64, forces, range(4))
    line = RoughContact(surface, ONE, 1.0, Force(forces), realisations=100).solve()
    assert np.all(np.abs(np.log(line.stiffness / stiffness)) < np.log(1.4))
    assert np.all(np.abs(np.log(line.depth / depth)) < np.log(1.4))


def test_against_the_curve_of_another_code(shared_data):
    """One stamp of 512 x 512 pixels and root mean square slope 1, by Tamaas: median lines are this far from it."""
    with (shared_data / "reference" / "rough_free.csv").open() as file:
        table = [row for row in csv.DictReader(file) if row["n"] == "512"]
    force, stiffness, depth = (
        np.array([float(row[word]) for row in table])
        for word in ("F/(E*L^2)", "k=dF/dd/(E*L)", "d_from_highest_point/L")
    )
    slope = SelfAffine(hurst=0.8, rms_height=1.0, longest=0.5, shortest=1.0 / 64).rms_slope
    surface = SelfAffine(hurst=0.8, rms_height=1.0 / slope, longest=0.5, shortest=1.0 / 64)
    line = RoughContact(surface, ONE, 1.0, Force(force), realisations=200).solve()
    expected = [0.90, 0.86, 1.00, 1.08, 1.11, 1.20, 1.27, 1.13, 1.04]
    assert line.stiffness / stiffness == pytest.approx(expected, abs=0.01)
    assert line.depth / depth == pytest.approx([0.88, 0.94, 0.97, 0.98, 0.97, 0.95, 0.89, 0.88, 0.90], abs=0.01)
    assert np.all(line.stiffness_band[0, :4] < stiffness[:4])
    assert np.all(stiffness[:4] < line.stiffness_band[1, :4])


@pytest.mark.long
def test_a_row_of_the_table():
    """One row of the table in the manual: twelve surfaces of 256 x 256 pixels with 32 waves along a side."""
    surface = SelfAffine(hurst=0.8, rms_height=0.01, longest=1.0, shortest=1.0 / 32)
    forces = 0.01 * np.geomspace(0.02, 20.0, 7)
    stiffness, depth = surfaces(surface, 256, forces, range(12))
    line = RoughContact(surface, ONE, 1.0, Force(forces), realisations=200).solve()
    assert line.stiffness / stiffness == pytest.approx([0.86, 0.82, 0.96, 1.17, 1.22, 1.04, 1.00], abs=0.02)
    assert line.depth / depth == pytest.approx([1.15, 1.18, 1.20, 1.10, 0.97, 0.94, 0.97], abs=0.02)


@pytest.mark.parametrize(
    ("numbers", "sentence"),
    [
        ({"side": 0.0}, "side is 0.0"),
        ({"load": Force(-1.0)}, "is not positive"),
        ({"load": Radius(1.0)}, "load is a Radius"),
        ({"realisations": 0}, "realisations is 0"),
        ({"count": 4.5}, "count is 4.5"),
        ({"seed": -1}, "seed is -1"),
        ({"medium": "steel"}, "medium is a str"),
        ({"spectrum": "rough"}, "spectrum is a str; give a spectrum: SelfAffine"),
    ],
)
def test_wrong_questions_are_refused(numbers, sentence):
    prescribed = {"spectrum": WIDE, "medium": ONE, "side": 1.0, "load": Force(1.0)} | numbers
    with pytest.raises(InvalidInput, match=sentence):
        RoughContact(**prescribed)
