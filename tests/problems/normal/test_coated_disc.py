"""A ball on a coated disc: each part's onset of yield at contacts much wider than the coating, against own waves.

The stresses of the test are Hankel integrals of matrix exponentials; the limit of thin layers is a closed form: a layer
takes the strains along the surface of the base, and the pressure.
"""

import numpy as np
import pytest
from layer_waves import _plane
from layer_waves import base as decaying
from scipy.linalg import expm
from scipy.special import j0

import winkler as wk
from winkler.fields.peaks import peak_stress
from winkler.foundation.bed import PressedSprings
from winkler.media.layered import hankel_waves
from winkler.problems.normal.onset.search import greatest_in
from winkler.problems.normal.strong_parts import strong_parts

CARBON = wk.Elastic(180e9, 0.22, strength=8e9)
CHROMIUM = wk.Elastic(279e9, 0.21, strength=1.5e9)
STEEL = wk.Elastic(210e9, 0.3, strength=2e9)
BALL, R = wk.Elastic(310e9, 0.27), 1.5e-3


def disc(on=STEEL, scale=1.0, second=BALL):
    layers = [wk.Layer(CARBON, 2e-6 * scale), wk.Layer(CHROMIUM, 0.5e-6 * scale)]
    return wk.Foundation(wk.Paraboloid(R), wk.CoatedHalfSpace(layers, on=on, second=second))


def pressed(bed, a):
    return PressedSprings(bed, float(bed.gap(np.array([a]))[0]), a)


def mises_on_axis(bed, springs, z, part):
    """|axial - radial| at a depth on the axis, from fields that were carried up from there by matrix exponentials."""
    places, shares = np.polynomial.legendre.leggauss(900)
    angle, area = 0.25 * np.pi * (places + 1.0), 0.25 * np.pi * shares
    a = springs.radius
    r = a * np.sin(angle)
    load = area * a * np.cos(angle) * r * bed.medium.pressure(springs, r)
    nodes, weights = np.polynomial.legendre.leggauss(40)
    cuts = np.unique(np.concatenate([[0.0], np.geomspace(0.02, 1.0, 6) / z, np.arange(1.0, 26.0 * a / z, 12.0) / a]))
    xi = (cuts[:-1, None] + 0.5 * np.diff(cuts)[:, None] * (nodes + 1.0)).ravel()
    wave = np.concatenate([j0(np.outer(some, r)) @ load for some in np.array_split(xi, 40)])
    shares = (0.5 * np.diff(cuts)[:, None] * weights).ravel()
    rows, top = [], 0.0
    for layer in bed.medium.layers:
        rows.append((layer.solid, top, top + layer.thickness))
        top += layer.thickness
    solid = ([layer.solid for layer in bed.medium.layers] + [bed.medium.on])[part]
    fields = np.broadcast_to(decaying((bed.medium.on.shear, bed.medium.on.poisson)), (xi.size, 4, 2))
    steps = [(bed.medium.on, z - top)] if z > top else []
    for of, start, end in reversed(rows):
        steps += [(of, end - max(z, start))] if start < z < end else []
        steps += [(of, min(z, end) - start)] if z > start else [(of, end - start)]
    here = fields if z > top else None
    depth = max(z, top)
    for of, thickness in steps:
        if here is None and depth <= z * (1.0 + 1e-12):
            here = fields
        scale = np.array([1.0, 1.0, of.shear, of.shear])[:, None]
        fields = scale * (expm(-_plane(of.poisson) * (xi * thickness)[:, None, None]) @ (fields / scale))
        depth -= thickness
    amplitudes = np.linalg.solve(fields[:, 2:], np.array([0.0, -1.0])[None, :, None] * wave[:, None, None])
    moved = (here @ amplitudes)[..., 0]
    axial, strain = np.sum(shares * xi * moved[:, 3]), 0.5 * np.sum(shares * xi * moved[:, 0])
    radial = (2.0 * solid.shear * strain * (1.0 + solid.poisson) + solid.poisson * axial) / (1.0 - solid.poisson)
    return abs(axial - radial)


@pytest.mark.slow
def test_the_stresses_in_the_layers_at_28_thicknesses():
    """Under 20 N 1.49, 1.20 and 1.956 GPa, on the lower faces of the layers and in the steel."""
    bed = disc()
    contact = wk.Indentation(bed, wk.Force(20.0)).solve()
    found = [greatest_in(bed, part, contact.radius, True, 0.0) for part in strong_parts(bed.medium)]
    assert [one.value for one in found] == [pytest.approx(level, rel=3e-3) for level in (1.49e9, 1.20e9, 1.956e9)]
    springs = pressed(bed, contact.radius)
    for number, one in enumerate(found):
        assert one.x == 0.0
        assert one.value == pytest.approx(mises_on_axis(bed, springs, one.z, number), rel=1e-6)
    assert peak_stress(contact).von_mises == pytest.approx(max(one.value for one in found), rel=1e-7)


@pytest.mark.slow
def test_each_part_of_a_coated_disc_has_its_load():
    """About 21 N of the steel; the chromium by the waves of this test; the carbon at 157 thicknesses."""
    onset = wk.YieldOnset(disc()).solve()
    carbon, chromium, steel = onset.onsets
    assert (onset.force, onset.z) == (steel.force, steel.z)
    assert steel.force == pytest.approx(21.4, abs=0.1)
    assert [one.name for one in onset.onsets] == ["layer 1", "layer 2", "body under the layers"]
    for number, (one, solid) in enumerate(zip(onset.onsets, (CARBON, CHROMIUM, STEEL), strict=True)):
        springs = pressed(onset.problem.bed, one.radius)
        level = mises_on_axis(onset.problem.bed, springs, one.z, number)
        assert level == pytest.approx(solid.strength, rel=2e-6)
    assert chromium.force < carbon.force
    assert carbon.radius > 100.0 * 2e-6
    assert "the layer 2 at 45.4" in onset.validity[-1].statement
    assert onset.validity[-1].standing is wk.Standing.EXACT
    assert "at the onset in the layer 1 the contact is so wide" in onset.validity[-1].statement


def limit(layer, base, peak):
    """Von Mises stress in the middle of a thin layer, under the pressure and with the strain of the base along it."""
    strain = -peak / (2.0 * base.young) * (1.0 + base.poisson) * (1.0 - 2.0 * base.poisson)
    along = (layer.young * strain - layer.poisson * peak) / (1.0 - layer.poisson)
    return abs(along + peak)


@pytest.mark.slow
@pytest.mark.parametrize("base", [STEEL, wk.Elastic(70e9, 0.35)])
def test_layers_a_thousand_times_thinner_take_the_strain_of_the_base(base):
    """Half the thickness halves what is left of the limit; so it depends on the base."""
    left = []
    for scale in (0.1, 0.05):
        bed = disc(base, scale)
        a = 2e-4
        peak = 2.0 * a / (np.pi * R) * wk.HalfSpace(base, BALL).modulus
        springs = pressed(bed, a)
        z = np.array([0.0, 2.25e-6 * scale])
        stress = bed.medium.interior(springs, np.zeros(2), z, below=True)
        level = np.abs(stress.axial_stress - stress.radial_stress)
        left.append(level / [limit(layer, base, peak) for layer in (CARBON, CHROMIUM)] - 1.0)
    np.testing.assert_allclose(left[1], 0.5 * left[0], rtol=0.05)
    np.testing.assert_allclose(2.0 * left[1] - left[0], 0.0, atol=2e-3)


@pytest.mark.long
def test_waves_that_fade_round_off_the_edge_alone(monkeypatch):
    """Against twice as many waves: nothing changes below the middle; next to the edge a few per mille of p(0)."""
    bed, a = disc(scale=0.2), 2e-4
    springs, z = pressed(bed, a), np.array([0.4e-6, 0.45e-6, 0.6e-6])
    r = a * np.array([0.0, 0.5, 0.9, 0.98, 1.0])
    places = [part.ravel() for part in np.meshgrid(r, z, indexing="ij")]
    found = bed.medium.interior(springs, *places, below=True)
    monkeypatch.setattr(hankel_waves, "SHORTEST_WAVES", 2.0 * hankel_waves.SHORTEST_WAVES)
    hankel_waves.waves_of.cache_clear()
    finer = bed.medium.interior(springs, *places, below=True)
    hankel_waves.waves_of.cache_clear()
    peak = float(bed.medium.pressure(springs, np.zeros(1))[0])
    change = np.max(np.abs(np.array(found[:4]) - np.array(finer[:4])), axis=0).reshape(5, 3) / peak
    assert np.all(change[:4] < 1e-8)
    assert np.all(change[4] < 5e-3)
    assert np.any(change[4] > 1e-7)
    notes = wk.Indentation(bed, wk.Radius(a)).solve().validity
    said = [note for note in notes if note.assumption is wk.Assumption.ELASTIC]
    assert len(said) == 3
    assert wk.Standing.EXACT not in [note.standing for note in said]


@pytest.mark.long
def test_a_ball_that_is_weaker_than_its_disc_is_in_the_table():
    """The ball and the coated disc, sliding: the ball as below a half-space that carries the same pressure."""
    weak = wk.Elastic(310e9, 0.27, strength=1.2e9)
    onset = wk.YieldOnset(disc(wk.Elastic(210e9, 0.3), second=weak), wk.Coulomb(0.2)).solve()
    ball = onset.onsets[-1]
    assert (ball.name, ball.part) == ("second body", 3)
    assert ball.z <= 0.0
    plain = wk.YieldOnset(
        wk.Foundation(wk.Paraboloid(R), wk.HalfSpace(wk.Elastic(210e9, 0.3), weak)), wk.Coulomb(0.2)
    ).solve()
    assert ball.force == pytest.approx(plain.force, rel=0.05)


def test_both_bodies_are_in_the_table():
    """Two half-spaces under one pressure: forces at the onset go as the cubes of the strengths."""
    pair = wk.HalfSpace.between(wk.Elastic(210e9, 0.3, strength=1e9), wk.Elastic(210e9, 0.3, strength=2e9))
    for onset in (
        wk.YieldOnset(wk.Foundation(wk.Paraboloid(1e-2), pair)).solve(),
        wk.EllipticYieldOnset(wk.CurvedBodies(1e-2, 3e-2), pair).solve(),
    ):
        first, second = onset.onsets
        assert onset.force == first.force
        assert second.force == pytest.approx(8.0 * first.force, rel=1e-9)
        assert (first.name, second.name) == ("first body", "second body")
        assert second.z == pytest.approx(-2.0 * first.z, rel=1e-6)
    rows = wk.LineYieldOnset(wk.LineFoundation(wk.Paraboloid(1e-2), pair)).solve().onsets
    assert rows[1].force_per_length == pytest.approx(4.0 * rows[0].force_per_length, rel=1e-9)


@pytest.mark.slow
def test_a_sharp_body_yields_its_layer_at_the_first_touch_though_the_base_has_a_load():
    medium = wk.CoatedHalfSpace([wk.Layer(CHROMIUM, 1e-4)], on=wk.Elastic(210e9, 0.3, strength=1e7))
    bed = wk.Foundation(wk.Cone(np.radians(5.0)), medium)
    with pytest.raises(wk.OutsideValidity, match="the apex is pointed, so the stress is infinite"):
        wk.YieldOnset(bed).solve()
