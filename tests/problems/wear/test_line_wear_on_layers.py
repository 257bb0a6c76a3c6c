"""Lines that wear on layers: other routes, half-planes as limits, the substrate, energy, refinement, what wears."""

from __future__ import annotations

import dataclasses
import functools

import numpy as np
import pytest
from slip_of_layers import SlippingCylinder
from wear_on_layers import LoneCore, WornOnLayers

import winkler as wk
from winkler.io.wear_states import read_wear, write_wear
from winkler.numerics.transforms.strips import strip_punches
from winkler.problems.wear.grids import wear_grid

MU, NU = 0.4, 0.3
SHEAR = 0.5 * (1.0 - NU)
"""E* = 1 of the layer under a rigid body."""
CYLINDER = wk.Paraboloid(1.0)
LAYER = [(SHEAR, NU, 1.0)]


def solid(share=1.0, **given):
    return wk.Elastic(2.0 * SHEAR * (1.0 + NU) * share, NU, **given)


def layered(contrast, thickness=1.0):
    return wk.LayeredLineFoundation(CYLINDER, wk.CoatedHalfSpace([wk.Layer(solid(), thickness)], solid(contrast)))


def plain(share=1.0):
    return wk.LineFoundation(CYLINDER, wk.HalfSpace(solid(share)))


def force(bed, half_width=1.0):
    return bed.medium.modulus * float(bed.load_profile(np.array([half_width]))[0])


def fretting(bed, load, swing, cycles, **given):
    rig = {"wear": wk.Archard(1.0), "count": 60} | given
    return wk.LineFrettingWear(
        bed, law=wk.Coulomb(MU), normal=wk.LineForce(load), amplitude=wk.LineShearForce(swing), cycles=cycles, **rig
    )


def limiting(bed, load, swing):
    return wk.LineLimitingProfile(bed, wk.Coulomb(MU), wk.LineForce(load), wk.LineShearForce(swing)).solve()


def sliding(bed, load, distance, **given):
    return wk.LineSlidingWear(
        bed, normal=wk.LineForce(load), distance=distance, **({"wear": wk.Archard(1.0), "count": 60} | given)
    )


@functools.cache
def by_equations(contrast, a):
    return SlippingCylinder(LAYER, (contrast * SHEAR, NU), a, 0.7 * a)


CASES = {(0.1, 0.3): 1.0, (0.1, 3.0): 50.0, (0.1, 10.0): 300.0, (10.0, 0.3): 1.0, (10.0, 3.0): 5.0, (10.0, 10.0): 15.0}
"""Contrast and a/h, and cycles in which about half of what can wear does."""


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize(("contrast", "a"), CASES)
def test_before_wear_a_cylinder_slips_as_singular_integral_equations_say(contrast, a):
    expected = by_equations(contrast, a)
    losses = []
    for count in (50, 200):
        worn = fretting(layered(contrast), expected.load, MU * expected.shear, [0.0, 1e-9], count=count).solve()
        losses.append(abs(worn.dissipation_per_length[0] / (4.0 * MU**2 * expected.loss()) - 1.0))
    assert worn.half_width[0] == pytest.approx(a, rel=1e-5)
    assert worn.stick_half_width[0] == pytest.approx(0.7 * a, rel=3e-5)
    assert losses[0] < 6e-3
    assert losses[1] < min(4e-4, 0.6 * losses[0])


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize(("contrast", "a"), CASES)
def test_fretting_is_that_of_boundary_elements(contrast, a):
    load, amount = by_equations(contrast, a).load, CASES[contrast, a] / a**2
    rig = fretting(layered(contrast), load, 0.6 * MU * load, [0.0, amount], count=200, tolerance=1e-4)
    last = rig.solve().states[-1]
    elements = WornOnLayers(LAYER, (contrast * SHEAR, NU), np.linspace(0.0, 1.3 * a, 57), load, MU, a)
    worn, pressure = elements.fret(0.6 * MU * load, amount, 40)
    assert 2.0 * elements.h @ worn == pytest.approx(last.worn_volume_per_length, rel=1.5e-2)
    inside = elements.x < 0.4 * a
    there = np.interp(elements.x**2, last.places**2, last.pressure)
    np.testing.assert_allclose(pressure[inside], there[inside], atol=2e-3 * pressure[0])


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize(("contrast", "a"), CASES)
def test_sliding_is_that_of_boundary_elements(contrast, a):
    load = by_equations(contrast, a).load
    amount = 0.2 * a * a / load * a
    last = sliding(layered(contrast), load, [0.0, amount], count=200, tolerance=1e-4).solve().states[-1]
    assert last.half_width > 1.05 * a
    elements = WornOnLayers(LAYER, (contrast * SHEAR, NU), np.linspace(0.0, 2.0 * a, 51), load, MU, a)
    worn, _ = elements.slide(amount, 40)
    there = np.interp(elements.x**2, last.places**2, last.worn)
    np.testing.assert_allclose(worn, there, atol=5e-3 * last.worn_depth)


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize(("contrast", "a"), CASES)
def test_a_core_that_bears_alone_is_that_of_integral_equations(contrast, a):
    """Where it is the narrower one, wear ends with it; its surroundings lie below its pressure."""
    core = LoneCore(LAYER, (contrast * SHEAR, NU), 0.6 * a, load := by_equations(contrast, a).load)
    limit = limiting(layered(contrast), load, MU * core.shear)
    slip = next(note for note in limit.validity if "kernels of the layers" in note.statement)
    if contrast > 1.0:
        assert limit.stick_half_width == pytest.approx(0.6 * a, rel=1e-9)
        x = np.linspace(1.05 * 0.6 * a, 0.999 * limit.half_width, 5)
        np.testing.assert_allclose(
            limit.worn(x) - limit.worn(x[:1]), core.worn_less(x, x[0]), atol=1e-8 * limit.worn_depth
        )
        assert slip.standing is wk.Standing.EXACT
    else:
        assert limit.stick_half_width < 0.6 * a
        assert f"less than {0.6 * a:.4g} m" in slip.statement
        assert slip.standing is wk.Standing.APPROXIMATE


@pytest.mark.slow
def test_the_march_ends_in_the_limiting_profile_of_a_soft_base_and_of_a_hard_one():
    """Under a layer on a harder base what sticks shrinks to the lone core; on a softer one it grows, to less."""
    for contrast, cycles in ((10.0, 1e4), (0.1, 1e3)):
        load = by_equations(contrast, 3.0).load
        limit, misses = limiting(layered(contrast), load, 0.6 * MU * load), []
        for count in (40, 80):
            last = fretting(layered(contrast), load, 0.6 * MU * load, [0.0, cycles / 9.0], count=count).solve()
            misses.append(abs(last.worn_volume_per_length[-1] / limit.worn_volume_per_length - 1.0))
        if contrast > 1.0:
            assert last.stick_half_width[-1] == pytest.approx(limit.stick_half_width, rel=1e-6)
            assert misses[1] < 0.01
            assert misses[1] < 0.6 * misses[0]
        else:
            assert limit.stick_half_width < last.stick_half_width[-1] < 0.775 * 3.0
            assert last.worn_volume_per_length[-1] < limit.worn_volume_per_length


@pytest.mark.slow
@pytest.mark.parametrize("contrast", [0.1, 10.0])
def test_flat_punches_of_all_widths_are_those_of_the_strip_equation(contrast):
    """The load profile of layers is that of a half-plane under the kernel; a punch is as steep as its modes say."""
    bed = layered(contrast)
    node, weight = np.polynomial.legendre.leggauss(120)
    for a in (0.3, 3.0, 30.0):
        t, step = 0.5 * a * (node + 1.0), 0.5 * a * weight
        one = np.array([a])
        kernel, edge = (
            strip_punches.kernel(bed.medium.response, t, one)[0],
            strip_punches.edge(bed.medium.response, one),
        )
        taken = float(np.sum(kernel * bed.half_plane.load_profile(t) / t * step))
        found = (float(bed.half_plane.load_profile(one)[0]) - taken) / float(edge[0])
        assert found == pytest.approx(float(bed.load_profile(one)[0]), rel=1e-11)
        assert bed.carried(a, 1.0).edge == pytest.approx(float(edge[0]), rel=1e-11)


def worn_alike(bed):
    load = force(bed)
    swing = 0.6 * MU * load
    frets = fretting(bed, load, swing, [0.0, 1.0]).solve()
    slides = sliding(bed, load, [0.0, 0.5]).solve()
    limit = limiting(bed, load, swing)
    return np.array(
        [frets.worn_volume_per_length[-1], slides.half_width[-1], limit.worn_volume_per_length, limit.half_width]
    )


@pytest.mark.slow
def test_layers_of_one_solid_wear_as_a_half_plane():
    np.testing.assert_allclose(worn_alike(layered(1.0)), worn_alike(plain()), rtol=2e-6)


def volume(bed, load):
    return limiting(bed, load, 0.6 * MU * load).worn_volume_per_length


@pytest.mark.slow
def test_the_substrate_is_felt():
    """At a / h = 3, under equal forces: without the substrate all would wear as on the layer's own half-plane."""
    load = force(layered(0.1), 3.0)
    soft, hard, own = (volume(bed, load) for bed in (layered(0.1), layered(10.0), plain()))
    assert hard < 0.75 * own
    assert own < 0.25 * soft


@pytest.mark.long
@pytest.mark.parametrize("answer", ["ends", "slid"])
@pytest.mark.parametrize("contrast", [0.5, 2.0])
def test_the_base_decides_under_a_thin_layer(contrast, answer):
    """What sticks, where wear ends and how far sliding widens the contact: as h ln(1/h)."""

    def ends(bed):
        load = force(bed)
        limit = limiting(bed, load, 0.6 * MU * load)
        return np.array([limit.stick_half_width, limit.half_width])

    def slid(bed):
        return sliding(bed, force(bed), [0.0, 0.5], count=80).solve().half_width[-1:]

    read, thicknesses = {"ends": (ends, (0.04, 0.02, 0.01)), "slid": (slid, (0.32, 0.16, 0.08))}[answer]
    base = read(plain(contrast))
    away = [np.abs(read(layered(contrast, h)) / base - 1.0) for h in thicknesses]
    assert np.all(away[0] < 0.1)
    assert np.all(away[2] < 0.85 * away[1])
    assert np.all(away[1] < 0.9 * away[0])


@pytest.mark.slow
@pytest.mark.parametrize("contrast", [0.1, 10.0])
def test_pressures_about_the_nodes_converge_on_those_without_a_grid(contrast):
    """At least by the first power of the width of the cells; loads are kept but for rounding."""
    bed, errors = layered(contrast), []
    load = force(bed, 10.0)
    for count in (40, 80, 160):
        state = next(sliding(bed, load, [0.0, 1.0], count=count).steps())
        transforms = wear_grid(bed, state.nodes).transforms
        exact = bed.mean_pressures(np.append(transforms.borders, state.nodes[-1]), 10.0, 0.0)
        errors.append(float(np.max(np.abs(state.pressure - exact)) / exact[0]))
        assert transforms.areas @ state.pressure == pytest.approx(load, rel=1e-11)
    assert errors[0] < 0.03
    assert errors[1] < 0.5 * errors[0]
    assert errors[2] < 0.5 * errors[1]


def test_what_a_cycle_wears_off_is_its_energy_times_the_rate_over_friction():
    load = force(layered(0.1), 3.0)
    few = fretting(layered(0.1), load, 0.6 * MU * load, [0.0, 1e-3], count=100).solve()
    expected = few.dissipation_per_length[0] / MU * 1e-3
    assert few.worn_volume_per_length[-1] == pytest.approx(expected, rel=1e-3)
    np.testing.assert_allclose(few.force_per_length, load, rtol=1e-12)


def test_sliding_wears_off_rate_times_force_times_distance():
    bed = wk.LayeredLineFoundation(CYLINDER, wk.SlidingFilm([wk.Layer(solid(), 1.0)], solid(0.2)))
    worn = sliding(bed, 1.0, [0.0, 0.5, 5.0]).solve()
    np.testing.assert_allclose(worn.worn_volume_per_length, np.array([0.0, 0.5, 5.0]), rtol=1e-6, atol=1e-12)


@pytest.mark.parametrize("problem", [lambda bed: fretting(bed, 1.0, 0.1, [1.0]), lambda bed: limiting(bed, 1.0, 0.1)])
def test_layers_that_slide_on_one_another_bear_no_fretting(problem):
    with pytest.raises(wk.OutsideValidity, match="slides on its base and carries no shear"):
        problem(wk.LayeredLineFoundation(CYLINDER, wk.SlidingFilm([wk.Layer(solid(), 1.0)], solid(0.2))))


def test_anisotropic_bodies_slip_by_their_own_compliance_along_the_surface():
    """Slip and rate of wear scale with E*/m_L; the limit does not know it."""
    wood = wk.TransverselyIsotropicHalfSpace(wk.TransverselyIsotropic(11.0, 4.0, 4.0, 20.0, 3.0))
    like = wk.HalfSpace(wk.Elastic(wood.modulus * (1.0 - NU**2), NU))
    beds = [wk.LineFoundation(CYLINDER, medium) for medium in (wood, like)]
    load = force(beds[0], 0.3)
    share = wood.modulus / wood.along_modulus
    assert abs(share - 1.0) > 0.1
    frets = [
        fretting(bed, load, 0.6 * MU * load, [0.0, cycles]).solve()
        for bed, cycles in zip(beds, (1.0, share), strict=True)
    ]
    ratio = frets[0].dissipation_per_length / frets[1].dissipation_per_length
    assert ratio[0] == pytest.approx(share, rel=1e-12)
    np.testing.assert_allclose(frets[0].worn_volume_per_length, frets[1].worn_volume_per_length, rtol=2e-5)
    assert volume(beds[0], load) == pytest.approx(volume(beds[1], load), rel=1e-12)


def test_which_body_wears_and_how_much_of_a_layer_may():
    bed, load = layered(0.1), force(layered(0.1), 0.5)
    other, own = (sliding(bed, load, [0.0, 0.02], layer_wears=wears).solve() for wears in (False, True))
    assert other.states[-1].first_worn.max() == 0.0
    assert own.states[-1].second_worn.max() == 0.0
    np.testing.assert_allclose(own.worn_volume_per_length, other.worn_volume_per_length, rtol=1e-12)
    (thinned,) = (note for note in own.validity if "If the layer were thinner" in note.statement)
    assert "stiffer" not in thinned.statement.split("contact would be")[1]  # a soft base comes nearer
    with pytest.raises(wk.OutsideValidity, match="per cent of the uppermost layer"):
        sliding(bed, load, [0.0, 10.0], layer_wears=True).solve()
    with pytest.raises(wk.InvalidInput, match="has no layers"):
        sliding(plain(), load, [1.0], layer_wears=True)


@pytest.mark.slow
def test_notes_speak_of_layers_and_of_no_half_plane():
    bed = dataclasses.replace(layered(0.1), medium=wk.CoatedHalfSpace([wk.Layer(solid(strength=5.0), 1.0)], solid(0.1)))
    load = force(bed, 3.0)
    runs = (
        fretting(bed, load, 0.6 * MU * load, [0.0, 1.0], count=40).solve(),
        limiting(bed, load, 0.6 * MU * load),
        sliding(bed, load, [0.0, 1e-2], count=20).solve(),
    )
    for run in runs:
        words = " ".join(note.statement for note in run.validity)
        assert "half-plane" not in words
        assert "Linear elastic layers in plane strain" in words
    coarse = next(note for note in runs[2].validity if "Before wear the mean pressures" in note.statement)
    exact = bed.pressure(runs[2].states[0].places[:1], 3.0, 0.0)
    off = abs(float(runs[2].states[0].pressure[0] / exact[0]) - 1.0)
    assert 0.002 < off < 0.05
    assert coarse.standing is wk.Standing.APPROXIMATE


def test_a_march_on_layers_that_was_stopped_and_kept_goes_on_with_the_same_numbers(tmp_path):
    load = force(layered(0.1))
    problem = fretting(layered(0.1), load, 0.6 * MU * load, [0.0, 0.5, 1.0], count=40)
    whole = list(problem.steps())
    kept = read_wear(write_wear(whole[:2], tmp_path / "states.npz"), problem.bed)
    assert list(kept) == whole[:2]
    assert list(problem.steps(start=kept[-1])) == whole[2:]


@pytest.mark.slow
def test_stresses_of_the_end_are_those_in_the_layers():
    """Along the surface of the core the pressure; the layers and what carries them are in equilibrium below it."""
    bed = layered(0.1)
    load = force(bed, 2.0)
    limit = limiting(bed, load, 0.6 * MU * load)
    x = np.linspace(-40.0, 40.0, 4001)
    assert np.trapezoid(limit.stresses(x, 2.0).zz_stress, x) == pytest.approx(-load, rel=2e-3)


def test_bodies_that_relax_are_refused():
    with pytest.raises(wk.WinklerError, match="relax|changes in time|LayeredLineFoundation"):
        sliding(wk.LineFoundation(CYLINDER, wk.ViscoelasticHalfSpace(wk.StandardSolid(0.05, 0.2, 0.5))), 1.0, [1.0])
