"""Many loads of a profile that turns, met and examined together: each verdict is that of the load alone."""

from __future__ import annotations

import re

import numpy as np
import pytest

import winkler as wk
from winkler.numerics.equations.bracketing import between
from winkler.problems.normal.single_contact import refuse_unless_disc

HALF = wk.HalfSpace.between(wk.Elastic(1.0, 0.3))
FILM = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(1.0, 0.5), 0.1)], on=wk.Rigid())
HARD = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(10.0, 0.3), 1.0)], on=wk.Elastic(1.0, 0.3))
WAVES = wk.Paraboloid(1.0) + wk.Wavy(4e-3, 0.2)
SHARPER = wk.CappedParaboloid(1.0, 0.9, 0.1)
CASES = {
    "waves": (WAVES, HALF, np.linspace(0.012, 0.04, 15)),
    "waves on a film": (wk.Paraboloid(1.0) + wk.Wavy(1e-2, 0.2), FILM, np.linspace(0.002, 0.06, 8)),
    "a sharper tip": (SHARPER, HALF, np.linspace(0.002, 0.03, 25)),
    "a sharper tip on a film": (SHARPER, FILM, np.linspace(0.002, 0.05, 12)),
    "a hard coating": (wk.PowerLaw(1.0, 4.0), HARD, np.geomspace(0.05, 600.0, 8)),
}


def alone(bed: wk.Foundation, depth: float) -> float | None:
    """The radius under one load, or none if it is refused."""
    try:
        return float(wk.Indentation(bed, wk.Depth(depth)).solve().radius)
    except wk.OutsideValidity:
        return None


SLOW = {"waves on a film", "a sharper tip on a film", "a hard coating"}


@pytest.mark.parametrize("name", [pytest.param(name, marks=pytest.mark.slow if name in SLOW else ()) for name in CASES])
def test_many_loads_are_checked_as_each_alone(name):
    shape, medium, depths = CASES[name]
    bed = wk.Foundation(shape, medium)
    radii = [alone(bed, float(depth)) for depth in depths]
    discs = np.array([radius is not None for radius in radii])
    assert discs.any()
    assert not discs.all()
    together = wk.Indentation(bed, wk.Depth(depths[discs])).solve()
    np.testing.assert_allclose(together.radius, np.array(radii, dtype=object)[discs].astype(float), rtol=1e-12)
    again = wk.Indentation(bed, wk.Force(together.force)).solve()
    np.testing.assert_allclose(again.depth, together.depth, rtol=1e-9)
    with pytest.raises(wk.OutsideValidity) as refused:
        wk.Indentation(bed, wk.Depth(depths)).solve()
    named = int(re.search(r"load at index (\d+)", str(refused.value)).group(1))  # type: ignore[union-attr]
    assert radii[named] is None
    for index in np.flatnonzero(~discs):
        mixed = np.append(depths[discs], depths[index])
        with pytest.raises(wk.OutsideValidity, match=f"load at index {mixed.size - 1}"):
            wk.Indentation(bed, wk.Depth(mixed)).solve()


@pytest.mark.slow
def test_the_order_of_the_loads_does_not_matter():
    bed = wk.Foundation(SHARPER, FILM)
    wide = wk.Indentation(bed, wk.Depth(np.linspace(0.03, 0.05, 7))).solve()
    turned = wk.Indentation(bed, wk.Depth(np.linspace(0.03, 0.05, 7)[::-1])).solve()
    np.testing.assert_array_equal(turned.radius[::-1], wide.radius)
    for depth, radius in zip(wide.depth, wide.radius, strict=True):
        refuse_unless_disc(bed, float(depth), float(radius), np.inf)


def test_roots_in_brackets():
    """Each to rounding, also where the slope is vertical or the function jumps."""
    powers = np.array([3.0, 1.0, 9.0, 0.5, 1.0 / 3.0])
    wanted = np.array([2.0, 0.3, 1e-30, 0.7, 1e-5])

    def miss(x, which):
        return x ** powers[which] - wanted[which]

    result = between(miss, np.zeros(5), np.full(5, 2.0))
    np.testing.assert_allclose(result, wanted ** (1.0 / powers), rtol=4e-15)
    jump = between(lambda x, _: np.sign(x - 0.3) / np.sqrt(np.abs(x - 0.3) + 1e-300), np.zeros(1), np.ones(1))
    assert jump[0] == pytest.approx(0.3, rel=1e-15)
    assert between(miss, np.zeros(0), np.zeros(0)).size == 0


@pytest.mark.parametrize("kind", [wk.Force, wk.Depth])
@pytest.mark.parametrize("rim", [np.inf, 0.2])
def test_ten_thousand_loads_in_blocks_are_those_alone(kind, rim):
    """Without load, on the free surface, and beyond the load under which the rim is reached; in any order."""
    shape = wk.Paraboloid(1.0) if np.isinf(rim) else wk.Paraboloid(1.0) + wk.FlatPunch(rim)
    bed, rng = wk.Foundation(shape, HALF), np.random.default_rng(2)
    loads = rng.uniform(0.0, 0.02 if kind is wk.Force else 0.06, 10_000)
    loads[rng.integers(0, loads.size, 500)] = 0.0
    found = wk.Indentation(bed, kind(loads)).solve()
    assert np.any(found.radius == rim) == np.isfinite(rim)
    for index in (*rng.integers(0, loads.size, 20).tolist(), int(np.argmin(loads)), int(np.argmax(loads))):
        single = wk.Indentation(bed, kind(float(loads[index]))).solve()
        for word in ("depth", "force", "radius"):
            assert getattr(found, word)[index] == pytest.approx(getattr(single, word), rel=1e-14, abs=0.0)
