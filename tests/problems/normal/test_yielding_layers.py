"""Onset of yield in layers: a layer of the base's solid is none, and stresses by matrix exponentials of the test."""

import math

import numpy as np
import pytest
from layer_waves import _plane
from layer_waves import base as decaying
from scipy.linalg import expm
from scipy.special import j0

import winkler as wk

E, R, Y, H = 210e9, 1e-2, 1e9, 5e-5
GAUSS = np.polynomial.legendre.leggauss(48)


def coated(young, thickness, layer=Y, base=Y):
    stack = [wk.Layer(wk.Elastic(young, 0.3, strength=layer), thickness)]
    return wk.Foundation(wk.Paraboloid(R), wk.CoatedHalfSpace(stack, on=wk.Elastic(E, 0.3, strength=base)))


@pytest.mark.slow
@pytest.mark.parametrize(
    ("thickness", "part"), [(1e-4, "layer 1"), pytest.param(2e-5, "body under the layers", marks=pytest.mark.slow)]
)
def test_a_layer_of_the_solid_of_its_base_yields_as_a_half_space(thickness, part):
    plain = wk.YieldOnset(wk.Foundation(wk.Paraboloid(R), wk.HalfSpace(wk.Elastic(E, 0.3, strength=Y)))).solve()
    found = wk.YieldOnset(coated(E, thickness)).solve()
    assert found.force == pytest.approx(plain.force, rel=3e-7)
    assert (found.r, found.z) == (0.0, pytest.approx(plain.z, rel=1e-3))
    assert found.validity[-1].statement.startswith(f"Yielding begins in the {part}, ")


def mises_on_axis(onset, layers, z, base=None, below=0.0):
    """|axial - radial| at a depth, from fields carried up from there; `layers` lie above it, the last one below too.

    Below it may go on to a face on which two states `base` are free.
    """
    solution = wk.Indentation(onset.problem.bed, wk.Radius(onset.radius)).solve()
    angle, area = 0.25 * np.pi * (GAUSS[0] + 1.0), 0.25 * np.pi * GAUSS[1]
    r = onset.radius * np.sin(angle)
    load = area * onset.radius * np.cos(angle) * r * wk.restore(solution, r).pressure
    cuts = np.concatenate([[0.0], np.geomspace(0.02, 1.0, 6), np.arange(2.0, 28.0)]) / z
    xi = (cuts[:-1, None] + 0.5 * np.diff(cuts)[:, None] * (GAUSS[0] + 1.0)).ravel()
    shares = (0.5 * np.diff(cuts)[:, None] * GAUSS[1]).ravel()
    wave = j0(np.outer(xi, r)) @ load
    shear, poisson = layers[-1][:2]  # on the interface the layer, which is stressed more
    here = fields = np.broadcast_to(decaying((E / 2.6, 0.3)) if base is None else base, (xi.size, 4, 2))
    for number, (modulus, nu, thickness) in enumerate([(*layers[-1][:2], below), *reversed(layers)]):
        scale = np.array([1.0, 1.0, modulus, modulus])[:, None]
        fields = scale * (expm(-_plane(nu) * (xi * thickness)[:, None, None]) @ (fields / scale))
        here = fields if number == 0 else here
    amplitudes = np.linalg.solve(fields[:, 2:], np.array([0.0, -1.0])[None, :, None] * wave[:, None, None])
    moved = (here @ amplitudes)[..., 0]  # U, tractions over xi
    axial, strain = np.sum(shares * xi * moved[:, 3]), 0.5 * np.sum(shares * xi * moved[:, 0])
    radial = (2.0 * shear * strain * (1.0 + poisson) + poisson * axial) / (1.0 - poisson)
    return abs(axial - radial)


@pytest.mark.slow
def test_a_stiff_layer_yields_at_its_lower_face_and_a_soft_one_lets_the_base_yield():
    stiff, soft = wk.YieldOnset(coated(3.0 * E, H)).solve(), wk.YieldOnset(coated(E / 3.0, H)).solve()
    assert (stiff.r, stiff.z) == (0.0, pytest.approx(H, rel=1e-12))
    assert mises_on_axis(stiff, [(3.0 * E / 2.6, 0.3, H)], H) == pytest.approx(Y, rel=1e-6)
    assert soft.z > H
    above = [(E / 7.8, 0.3, H), (E / 2.6, 0.3, soft.z - H)]
    assert mises_on_axis(soft, above, soft.z) == pytest.approx(Y, rel=1e-6)


@pytest.mark.slow
def test_a_film_that_slides_on_a_rigid_base_yields_inside():
    """Below it neither shear nor sinking: states U and S alone."""
    film = wk.SlidingFilm([wk.Layer(wk.Elastic(E, 0.3, strength=Y), H)], on=wk.Rigid())
    found = wk.YieldOnset(wk.Foundation(wk.Paraboloid(R), film)).solve()
    above, free = [(E / 2.6, 0.3, found.z)], np.eye(4)[:, [0, 3]]
    assert found.r == 0.0
    assert mises_on_axis(found, above, found.z, free, H - found.z) == pytest.approx(Y, rel=1e-6)
    stack = wk.StackedHalfSpace([wk.StackLayer(wk.Elastic(E, 0.3, strength=Y), H, bonded=False)], on=wk.Rigid())
    assert wk.YieldOnset(wk.Foundation(wk.Paraboloid(R), stack)).solve().force == pytest.approx(found.force, rel=1e-12)
    with pytest.raises(wk.OutsideValidity, match="layer 1 slides on its base and carries no shear"):
        wk.YieldOnset(wk.Foundation(wk.Paraboloid(R), stack), wk.Coulomb(0.1)).solve()


def test_media_and_parts_without_an_onset_are_refused():
    with pytest.raises(wk.InvalidInput, match="no body has a strength"):
        wk.YieldOnset(coated(E, H, layer=math.inf, base=math.inf))
    with pytest.raises(wk.InvalidInput, match="the strength of a graded body varies with depth"):
        wk.YieldOnset(wk.Foundation(wk.Paraboloid(R), wk.GradedHalfSpace.between(wk.PowerLawGraded(E, 0.3, H, 0.3))))


@pytest.mark.long
def test_a_stiff_layer_that_bends_away_says_so():
    """A million times as stiff as its base: it bends away under contacts of 3.4 to 8 thicknesses, not under wider ones.

    At 32 thicknesses, where a ball of its modulus would yield, the contact is a disc again; its pressure cancels.
    """
    layer = wk.Layer(wk.Elastic(1e9, 0.3, strength=1e7), 1.0)
    bed = wk.Foundation(wk.Paraboloid(1e4), wk.CoatedHalfSpace([layer], on=wk.Elastic(1e3, 0.3)))
    with pytest.raises(wk.OutsideValidity, match="a round contact of .* m would need tension .* the layers bend away"):
        wk.YieldOnset(bed).solve()


def test_a_stress_that_is_not_found_says_at_which_radius(monkeypatch):
    def lost(*_, **__):
        raise wk.NotConverged("u'(x) is not smooth.")

    monkeypatch.setattr("winkler.problems.normal.onset.search.greatest_stress", lost)
    with pytest.raises(wk.NotConverged, match="at a contact radius of .* m the stress in the layer 1 is not found"):
        wk.YieldOnset(coated(E, H)).solve()


@pytest.mark.long
@pytest.mark.parametrize("places", [12, 60])
def test_a_base_that_yields_far_below_a_stiff_layer(places):
    """An incompressible base under a layer a million times as stiff: nowhere on the axis more than its strength."""
    base = wk.Elastic(1e3, 0.5, strength=10.0)
    bed = wk.Foundation(wk.Paraboloid(100.0), wk.CoatedHalfSpace([wk.Layer(wk.Elastic(1e9, 0.3), 1.0)], on=base))
    found = wk.YieldOnset(bed).solve()
    z = np.concatenate([np.geomspace(1.001, 300.0, places), [found.z]])
    springs = wk.Indentation(bed, wk.Depth(found.depth)).solve().pressed
    stress = bed.medium.interior(springs, np.zeros(z.size), z, below=True)
    mises = np.abs(stress.axial_stress - stress.radial_stress)
    assert np.max(mises) == pytest.approx(10.0, rel=1e-6)
    assert mises[-1] == pytest.approx(10.0, rel=1e-6)


def test_a_sharp_body_does_not_yield_what_lies_below_a_layer():
    base = wk.Elastic(E, 0.3, strength=1e8)
    medium = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(3e9, 0.4), H)], on=base)
    for sharp in (wk.FlatPunch(2e-5), wk.CappedCylinder(2e-5, wk.Paraboloid(1e-3))):
        with pytest.raises(wk.OutsideValidity, match=r"body under the layers stays elastic until .* rim \(2e-05 m\)"):
            wk.YieldOnset(wk.Foundation(sharp, medium)).solve()


@pytest.mark.slow
def test_a_cone_on_a_thick_layer_presses_on_the_base_like_a_point_force():
    base = wk.Elastic(E, 0.3, strength=1e8)
    medium = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(E, 0.3), H)], on=base)
    found = wk.YieldOnset(wk.Foundation(wk.Cone(math.radians(5.0)), medium)).solve()
    assert (found.r, found.z) == (0.0, pytest.approx(H, rel=1e-6))
    # Boussinesq on the axis: sigma_z = -3F / (2 pi z^2), sigma_r = (1 - 2 nu) F / (4 pi z^2)
    boussinesq = found.force / (2.0 * math.pi * H**2) * (3.0 + 0.5 * (1.0 - 0.6))
    assert found.radius < 0.01 * H
    assert boussinesq == pytest.approx(1e8, rel=1e-3)
