"""Fretting wear on layers: limits without layers, rings without a grid, Archard's law, and where it ends."""

import numpy as np
import pytest

import winkler as wk
from winkler.foundation.bed import PressedSprings

STEEL = wk.Elastic(210e9, 0.3)
BALL = wk.Paraboloid(10e-3)
MU, RATE = 0.5, 1e-14
DEPTH, SWING = wk.Depth(1e-6), wk.Shift(0.455e-6)
HARD = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(420e9, 0.25), 50e-6)], on=STEEL, second=STEEL)
SOFT = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(21e9, 0.3), 30e-6)], on=STEEL, second=STEEL)
BOTH = pytest.mark.parametrize("medium", [HARD, SOFT], ids=["hard", "soft"])


def fretting(medium, **changes):
    given = {
        "bed": wk.Foundation(BALL, medium), "wear": wk.Archard(RATE), "law": wk.Coulomb(MU), "normal": DEPTH,
        "amplitude": SWING, "cycles": np.array([0.0, 1e5, 1e6]), "count": 40,
    }  # fmt: skip
    return wk.FrettingWear(**(given | changes))


def limiting(medium):
    return wk.LimitingProfile(wk.Foundation(BALL, medium), wk.Coulomb(MU), DEPTH, SWING).solve()


def stack(solid, thickness, base):
    return wk.CoatedHalfSpace([wk.Layer(solid, thickness)], on=base, second=STEEL)


@pytest.mark.slow
@pytest.mark.parametrize("medium", [
    stack(STEEL, 50e-6, STEEL), stack(STEEL, 100.0, wk.Elastic(3e9, 0.4)),
], ids=["of the same solid", "thick"])  # fmt: skip
def test_layers_that_change_nothing_wear_as_none(medium):
    plain, coated = fretting(wk.HalfSpace(STEEL, STEEL)).solve(), fretting(medium).solve()
    for word in ("force", "radius", "worn_volume", "shear_force"):
        np.testing.assert_allclose(getattr(coated, word), getattr(plain, word), rtol=2e-4, err_msg=word)
    np.testing.assert_allclose(coated.stick_radius, plain.stick_radius, rtol=1e-3)


@pytest.mark.slow
@BOTH
def test_a_cycle_before_wear_is_that_of_rings_without_a_grid(medium):
    """Those of Tangential, on panels: errors fall with the square of the cells."""
    path = wk.Path.through(DEPTH, wk.Shift([0.0, SWING.shift, -SWING.shift, SWING.shift]))
    rings = wk.Tangential(wk.Foundation(BALL, medium), wk.Coulomb(MU), path).solve()
    loss = rings.dissipation[3] - rings.dissipation[1]
    for count, close in ((40, 4e-3), (160, 2.5e-4)):
        state = next(fretting(medium, count=count).steps())
        assert state.shear_force == pytest.approx(rings.shear_force[1], rel=close / 10.0)
        assert state.stick_radius == pytest.approx(rings.stick_radius[1], rel=close / 10.0)
        assert state.loss_per_cycle == pytest.approx(loss, rel=close)


@BOTH
def test_what_is_worn_off_is_the_rate_times_the_loss_over_the_friction(medium):
    """Simpson's rule over the cycles, of the pressure times the slip that the state loses."""
    worn = fretting(medium, cycles=np.linspace(0.0, 2e5, 9), tolerance=1e-4).solve()
    weights = np.array([1, 4, 2, 4, 2, 4, 2, 4, 1]) * (2e5 / 8 / 3)
    assert worn.worn_volume[-1] == pytest.approx(RATE / MU * weights @ worn.loss_per_cycle, rel=2e-4)
    np.testing.assert_array_equal(worn.first_volume, 0.0)


@pytest.mark.slow
def test_a_core_that_shrinks_ends_where_it_sticks_as_it_bears_alone():
    """The singular traction at its edge is then the coefficient times the singular pressure."""
    limit = limiting(SOFT)
    bed, c = limit.problem.bed, np.array([limit.stick_radius])
    close = c * (1.0 - 1e-8)
    pressure = SOFT.punch_pressure(close, c) * (DEPTH.depth - bed.gap(c))
    flat = wk.Foundation(wk.FlatPunch(float(c[0])), SOFT)
    path = wk.Path([0.0, 1.0], wk.Depth(1.0), wk.Shift([0.0, SWING.shift]))
    stuck = wk.Tangential(flat, wk.Coulomb(10.0), path).solve().states[1]
    assert stuck.stick_radius == pytest.approx(float(c[0]))
    assert float(stuck.traction(close)[0] / pressure[0]) == pytest.approx(MU, rel=1e-3)
    worn = fretting(SOFT, cycles=np.array([0.0, 2e7]), count=60).solve()
    assert worn.stick_radius[0] > 1.08 * limit.stick_radius
    assert worn.stick_radius[1] == pytest.approx(limit.stick_radius, rel=1e-4)
    assert worn.force[1] == pytest.approx(limit.force, rel=3e-3)
    assert worn.worn_volume[1] == pytest.approx(limit.worn_volume, rel=0.016)


@pytest.mark.slow
def test_a_core_that_grows_ends_between_the_stated_radii():
    limit = limiting(HARD)
    (note,) = (note for note in limit.validity if "the half-width of the stick zone before wear is" in note.statement)
    assert note.standing is wk.Standing.APPROXIMATE
    worn = fretting(HARD, cycles=np.array([0.0, 2e7])).solve()
    assert limit.stick_radius < worn.stick_radius[1] < 4.2e-5
    assert "less than 4.2e-05 m" in note.statement
    assert worn.worn_volume[1] == pytest.approx(limit.worn_volume, rel=0.04)


@pytest.mark.slow
def test_which_body_wears():
    layer = fretting(HARD, layer_wears=True, cycles=np.array([1e4])).solve()
    other = fretting(HARD, cycles=np.array([1e4])).solve()
    pair = fretting(
        HARD, wear=wk.PairWear(wk.Archard(0.5 * RATE), wk.Archard(0.5 * RATE)), cycles=np.array([1e4])
    ).solve()
    assert (layer.second_volume[0], other.first_volume[0]) == (0.0, 0.0)
    assert layer.first_volume[0] == pytest.approx(other.second_volume[0], rel=1e-12)
    assert pair.first_volume[0] == pytest.approx(0.5 * other.worn_volume[0], rel=1e-6)
    assert any("wear of the uppermost layer is" in note.statement for note in pair.validity)
    thin = stack(wk.Elastic(420e9, 0.25), 4e-6, STEEL)
    with pytest.raises(wk.OutsideValidity, match=r"within .* cycles more than 5 per cent"):
        fretting(thin, layer_wears=True, cycles=np.array([1e7]), count=20).solve()
    with pytest.raises(wk.InvalidInput, match="no layers"):
        fretting(wk.HalfSpace(STEEL, STEEL), layer_wears=True)
    with pytest.raises(wk.InvalidInput, match="leave layer_wears out"):
        fretting(HARD, layer_wears=True, wear=wk.PairWear(wk.Archard(RATE), wk.Archard(RATE)))


def test_a_shear_force_finds_its_shift_on_layers():
    state = next(fretting(SOFT).steps())
    again = next(fretting(SOFT, amplitude=wk.ShearForce(state.shear_force)).steps())
    assert again.shift == pytest.approx(SWING.shift, rel=1e-4)
    assert again.shear_force == pytest.approx(state.shear_force, rel=1e-12)


def test_layers_that_slide_are_refused():
    with pytest.raises(wk.OutsideValidity, match="slides on its base"):
        fretting(wk.SlidingFilm([wk.Layer(STEEL, 1e-6)], on=STEEL))


@pytest.mark.slow
@pytest.mark.parametrize(("count", "standing"), [(20, "OUTSIDE"), (60, "OUTSIDE"), (240, "APPROXIMATE")])
def test_a_stiff_layer_says_how_far_cells_miss_the_pressure(count, standing):
    """Rings under a layer a hundred times stiffer than its base, beside flat punches superposed without a grid."""
    stiff = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(100e9, 0.2), 2e-6)], on=wk.Elastic(1e9, 0.3))
    bed = wk.Foundation(wk.Paraboloid(1e-3), stiff)
    run = wk.SlidingWear(bed, wk.Archard(1e-13), wk.Force(0.1), np.array([0.0, 1e-9]), count=count).solve()
    fresh, exact = run.states[0], wk.Indentation(bed, wk.Force(0.1)).solve()
    half = np.sqrt(0.5) * fresh.radii[1]
    radii = half * np.sqrt((np.arange(24) + 0.5) / 24.0)
    springs = PressedSprings(bed, float(exact.depth), float(exact.radius))
    (note,) = (note for note in run.validity if f"grid of {count} cells" in note.statement)
    missed = abs(fresh.pressure[0] - np.mean(stiff.pressure(springs, radii))) / np.max(fresh.pressure)
    assert note.error == pytest.approx(missed, rel=1e-2) if count > 20 else note.error > missed  # there the edge
    assert note.standing is wk.Standing[standing]
    assert run.force[1] == pytest.approx(0.1, rel=1e-6)
