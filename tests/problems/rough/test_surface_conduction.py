"""What a height map conducts: Holm's spot, the square stamp, bounds; and springs that stand for a map."""

from __future__ import annotations

import pickle

import numpy as np
import pytest
from scipy.special import beta

import winkler as wk

METAL = wk.ElectricalConductor(16e-9)
PAIR = wk.ElectricalConductors(METAL, METAL)
STEEL = wk.HalfSpace(wk.Elastic(210e9, 0.3))
BLASTED = wk.SelfAffine(hurst=0.8, rms_height=1e-6, longest=1e-3, shortest=60e-6)
STAMP = wk.RandomTopography([1e-3, 1e-3], BLASTED, (48, 48), seed=1, periodic=False)


def map_of(function, side, pixels):
    place = (np.arange(pixels) + 0.5) / pixels * side - side / 2
    return wk.Topography(function(place[:, None], place[None, :]), [side, side])


def test_a_round_spot_has_holms_resistance():
    ball = map_of(lambda x, y: -(x**2 + y**2) / 20e-3, 0.3e-3, 64)
    result = wk.SurfaceConduction(wk.SurfaceContact(ball, STEEL, wk.Depth(1e-6)), PAIR).solve()
    radius = np.sqrt(10e-3 * 1e-6)
    assert result.resistance == pytest.approx(2 * 16e-9 / (4 * radius), rel=5e-3)
    assert result.force == pytest.approx(4 / 3 * STEEL.modulus * np.sqrt(10e-3) * 1e-6**1.5, rel=2e-3)
    assert result.least_resistance <= result.resistance <= result.greatest_resistance


def test_the_lower_bound_is_the_resistance_of_the_stamp():
    """A square punch has the stiffness 1.15229 E* L, by boundary elements extrapolated to no pixels."""
    result = wk.SurfaceConduction(wk.SurfaceContact(STAMP, STEEL, wk.Force([1.0, 10.0])), PAIR).solve()
    assert result.greatest_stiffness == pytest.approx(1.15229 * STEEL.modulus * 1e-3, rel=0.01)
    height = float(np.ptp(STAMP.heights))
    assert result.least_stiffness == pytest.approx(result.force / (result.force / result.greatest_stiffness + height))
    assert np.all(result.least_stiffness <= result.stiffness)
    assert np.all(result.stiffness <= result.greatest_stiffness)
    assert result.resistance == pytest.approx(STEEL.modulus * 32e-9 / (2 * result.stiffness), rel=1e-12)
    assert result.conductance == pytest.approx(1.0 / result.resistance, rel=1e-14)
    assert result.line_resistance == pytest.approx(STEEL.modulus * 32e-9 / (2 * result.line_stiffness), rel=1e-12)


def test_a_film_on_the_spots_is_that_of_their_current():
    """Beside the current solved pixel by pixel; more than the film of an even flux, and all resistances bear it."""
    pair = wk.ElectricalConductors(METAL, METAL, wk.SurfaceFilm(1e-12))
    contact = wk.SurfaceContact(STAMP, STEEL, wk.Force([1.0, 10.0]))
    clean, filmed = (wk.SurfaceConduction(contact, each, realisations=5).solve() for each in (PAIR, pair))
    spots = wk.SurfaceConstriction(contact, pair, wk.Current(1e-6)).solve()
    assert filmed.resistance == pytest.approx(spots.cold_resistance, rel=1e-4)
    pixels = np.asarray(filmed.resistance) - np.asarray(clean.resistance)
    assert pixels == pytest.approx(filmed.film_excess, rel=1e-12)
    assert np.all(pixels >= (1.0 - 1e-4) * spots.film_resistance)
    assert pixels[1] > 1.01 * spots.film_resistance[1]  # of several pixels
    assert np.all(pixels < 1.3 * spots.film_resistance)
    for name in ("line_resistance", "least_resistance", "greatest_resistance"):
        assert getattr(filmed, name) - getattr(clean, name) == pytest.approx(filmed.film_excess, rel=1e-9)
    assert clean.film_excess == pytest.approx([0.0, 0.0], abs=0.0)
    assert "have the same film" in " ".join(note.statement for note in filmed.validity)


GOLD, BRONZE = wk.ElectricalConductor(22e-9), wk.ElectricalConductor(130e-9)
LAYER, BASE = wk.Elastic(80e9, 0.42), wk.Elastic(120e9, 0.34)


@pytest.mark.slow
def test_a_round_spot_through_elastic_layers_and_platings():
    """Beside springs on layers, and the integral equation of a disc through platings."""
    body = wk.Plated(GOLD, 3e-6, BRONZE)
    pair, coated = wk.ElectricalConductors(body, BRONZE), wk.CoatedHalfSpace([wk.Layer(LAYER, 3e-6)], on=BASE)
    disc = wk.Constriction(wk.Indentation(wk.Foundation(wk.Paraboloid(2e-3), coated), wk.Radius(10e-6)), pair).solve()
    ball = map_of(lambda x, y: -((x + 0.1e-6) ** 2 + (y - 0.1e-6) ** 2) / 4e-3, 40e-6, 65)
    contact = wk.SurfaceContact(ball, coated, wk.Force(disc.force))
    found = wk.SurfaceConduction(contact, pair, realisations=2).solve()
    assert found.resistance == pytest.approx(disc.resistance, rel=2e-3)
    bare = wk.Constriction(
        wk.Indentation(disc.problem.contact.bed, wk.Radius(10e-6)), wk.ElectricalConductors(BRONZE, BRONZE)
    ).solve()
    assert disc.resistance < 0.75 * bare.resistance  # what the plating does is no trifle here
    assert found.least_resistance < 0.8 * found.resistance
    assert np.isinf(found.greatest_resistance)
    assert np.isnan(found.line_resistance)
    assert found.stiffness < found.greatest_stiffness
    statements = " ".join(note.statement for note in found.validity)
    assert "not proportional to stiffness" in statements
    assert "platings conduct as flat layers" in statements


@pytest.mark.slow
@pytest.mark.parametrize("periodic", [True, False])
def test_layers_of_the_same_solids_change_nothing(periodic):
    """The current through the pixels beside the stiffness of the homogeneous bodies; a film adds the same."""
    rough = wk.Topography(STAMP.heights, STAMP.lengths, periodic)
    layered = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(210e9, 0.3), 50e-6)], on=wk.Elastic(210e9, 0.3))
    body = wk.Plated(METAL, 30e-6, METAL)
    film = wk.SurfaceFilm(1e-12)
    plain, same = (
        wk.SurfaceConduction(
            wk.SurfaceContact(rough, medium, wk.Force([1.0, 10.0])), wk.ElectricalConductors(one, one, film),
            realisations=2,
        ).solve()
        for medium, one in ((STEEL, METAL), (layered, body))
    )  # fmt: skip
    assert same.resistance == pytest.approx(plain.resistance, rel=2e-4)
    assert same.film_excess == pytest.approx(plain.film_excess, rel=1e-3)
    square = 0.0 if periodic else 32e-9 / (2.0 * 1.15229e-3)  # what the stamp constricts in full contact
    film_alone = 1e-12 / 1e-6
    assert np.all(np.asarray(same.least_resistance) >= (film_alone + square) * (1.0 - 1e-6))
    assert np.all(np.asarray(same.least_resistance) <= film_alone + 1.09 * square + 1e-12)  # that spreads the current


def test_a_periodic_map_has_no_upper_bound_of_the_stiffness():
    rough = wk.RandomTopography([1e-3, 1e-3], BLASTED, (32, 32))
    result = wk.SurfaceConduction(wk.SurfaceContact(rough, STEEL, wk.Force(3.0)), PAIR, realisations=5).solve()
    assert np.isinf(result.greatest_stiffness)
    assert result.least_resistance == 0.0
    assert result.least_stiffness == pytest.approx(3.0 / np.ptp(rough.heights), rel=1e-5)


def test_the_line_is_that_of_the_spectrum():
    prescribed = wk.SurfaceConduction(wk.SurfaceContact(STAMP, STEEL, wk.Force(5.0)), PAIR, realisations=7, seed=3)
    line = wk.RoughContact(wk.spectrum_of(STAMP), STEEL, 1e-3, wk.Force(5.0), realisations=7, seed=3).solve()
    result = prescribed.solve()
    assert result.line_stiffness == pytest.approx(float(line.stiffness), rel=1e-5)
    notes = [note.statement for note in result.validity]
    assert len(notes) == len(set(notes))
    assert any("Rigorous bounds" in note for note in notes)
    assert not any("no true contact area" in note for note in notes)


@pytest.mark.parametrize(
    ("make", "error", "sentence"),
    [
        (lambda c: wk.SurfaceConduction(STAMP, PAIR), wk.InvalidInput, "the contact is a RandomTopography; give"),
        (lambda c: wk.SurfaceConduction(c, METAL), wk.InvalidInput, "conductors is a ElectricalConductor; give"),
        (lambda c: wk.SurfaceConduction(c, PAIR, realisations=0), wk.InvalidInput, "realisations is 0; give a whole"),
        (lambda c: wk.SurfaceConduction(c, PAIR, seed=-1), wk.InvalidInput, "seed is -1; give a whole number"),
        (
            lambda c: wk.SurfaceConduction(c, wk.ElectricalConductors(wk.Rod(METAL, 1e-3, 1e-2), METAL)),
            wk.OutsideValidity,
            "SurfaceConduction: a rod constricts the current of one round contact",
        ),
        (
            lambda c: wk.SurfaceConduction(c, wk.ElectricalConductors(wk.Plated(METAL, 1e-20, METAL), METAL)),
            wk.OutsideValidity,
            "SurfaceConduction: a plating of 1e-20 m is less than",
        ),
        (
            lambda c: wk.SurfaceConduction(
                wk.SurfaceContact(wk.Topography(np.zeros((16, 16)), [1e-3, 1e-3]), STEEL, wk.Force(1.0)), PAIR
            ).solve(),
            wk.InvalidInput,
            "flat",
        ),
    ],
)
def test_refused(make, error, sentence):
    with pytest.raises(error, match=sentence):
        make(wk.SurfaceContact(STAMP, STEEL, wk.Force(1.0)))


# ------------------------------------------------------------------------------------------- made at random


def test_a_random_surface_is_a_value_and_a_map():
    again = wk.RandomTopography(np.array([1e-3, 1e-3]), BLASTED, (48, 48), seed=1, periodic=False)
    assert again == STAMP
    assert hash(again) == hash(STAMP)
    assert pickle.loads(pickle.dumps(STAMP)) == STAMP
    assert wk.RandomTopography([1e-3, 1e-3], BLASTED, (48, 48), seed=2, periodic=False) != STAMP
    made = wk.random_topography(BLASTED, (48, 48), [1e-3, 1e-3], 1)
    np.testing.assert_array_equal(STAMP.heights, made.heights)
    assert not STAMP.periodic
    assert STAMP.detrended(1).rms_height <= STAMP.rms_height


@pytest.mark.parametrize(
    ("more", "sentence"),
    [
        ({"shape": (10**6, 10**6)}, "shape is .* at most 8192"),
        ({"shape": (2, 2)}, "RandomTopography: shape is"),
        ({"shape": (4.0, 4.0)}, "RandomTopography: shape is"),
        ({"lengths": [1e-3, -1e-3]}, "RandomTopography: lengths is"),
        ({"seed": -1}, "RandomTopography: seed is -1"),
        ({"lengths": [1e-6, 1e-6]}, "RandomTopography: no wave"),
    ],
)
def test_a_random_surface_refuses(more, sentence):
    with pytest.raises(wk.InvalidInput, match=sentence):
        wk.RandomTopography(**{"lengths": [1e-3, 1e-3], "spectrum": BLASTED, "shape": (16, 16), **more})


# ---------------------------------------------------------------------------------------- springs for a map


def test_a_reduced_bed_bears_what_the_map_bears():
    rough = wk.RandomTopography([1e-3, 1e-3], BLASTED, (64, 64), seed=1, periodic=False)
    bed = wk.ReducedBed(rough, STEEL, depth=3e-6)
    reference = wk.SurfaceContact(rough, STEEL, wk.Depth([0.9e-6, 2.2e-6, 3e-6])).solve().force
    result = wk.Indentation(bed, wk.Depth(np.array([0.9e-6, 2.2e-6, 3e-6]))).solve()
    np.testing.assert_allclose(result.force, reference, rtol=0.0, atol=2e-3 * reference[-1])
    assert result.validity  # slopes of a body that nobody has are integrated, too
    assert bed.mindlin_ratio == pytest.approx(STEEL.shear_modulus / STEEL.modulus)
    assert pickle.loads(pickle.dumps(bed)) == bed


@pytest.mark.parametrize("power", [0.35, 0.6, 1.0, 2.0])
def test_a_measured_bed_of_a_broken_power_has_its_body(power):
    """g = c x^n belongs to the body f = (c/pi) B((n+1)/2, 1/2) r^n, integrated analytically."""
    radii = np.geomspace(20e-6, 200e-6, 12)
    depths = 1e-6 * (radii / 100e-6) ** power
    bed = wk.MeasuredBed(radii, 2.0 * STEEL.modulus * radii, depths)
    r = np.array([5e-6, 20e-6, 33e-6, 150e-6])
    expected = beta(0.5 * power + 0.5, 0.5) / np.pi * 1e-6 * (r / 100e-6) ** power
    np.testing.assert_allclose(bed.height(r), expected, rtol=1e-9)
    np.testing.assert_allclose(bed.slope(r), power * expected / r, rtol=1e-8)
