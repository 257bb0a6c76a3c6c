"""The solver of steady rolling: coarser grids first, work that hardly grows with the grid, near starts."""

from __future__ import annotations

import numpy as np
import pytest

from winkler.numerics.surfaces import rolled_surface
from winkler.numerics.surfaces.rolled_surface import doubled_traction, halved_grid, halved_means, roll
from winkler.numerics.surfaces.traction_grid import Compliance, TractionGrid
from winkler.values.errors import NotConverged

SOFT = Compliance(1.0, 0.3 / 0.7)


def hertz(count: int, reach: float = 1.1) -> tuple[TractionGrid, np.ndarray, np.ndarray, np.ndarray]:
    """Return a grid, the bound 0.3 p over E*, and places, of a ball with `count` pixels across its contact."""
    wide = int(reach * count)
    place = (np.arange(wide) - 0.5 * (wide - 1)) * 2.0 / count
    x, y = np.meshgrid(place, place, indexing="ij")
    bound = 0.3 * 2.0 / np.pi * 1e-2 * np.sqrt(np.maximum(1.0 - x**2 - y**2, 0.0))
    return TractionGrid.of((wide, wide), (1.0, 1.0), SOFT, periodic=False), bound, x, y


def rolled(count: int, creepage: tuple[float, float, float], **more: float) -> rolled_surface.RolledSurface:
    grid, bound, x, y = hertz(count)
    xi, eta, phi = creepage
    return roll(grid, bound, np.stack((xi - phi * y, eta + phi * x)), np.zeros((2, *bound.shape)), **more)


CREEPAGES = {"along": (1.5e-3, 0.0, 0.0), "across": (0.0, 3e-3, 0.0), "spin": (5e-4, -5e-4, 2e-3)}


@pytest.mark.few(1)
@pytest.mark.parametrize("creepage", CREEPAGES.values(), ids=CREEPAGES)
def test_coarser_grids_only_begin(creepage, monkeypatch):
    begun, rounds = rolled(64, creepage, tolerance=1e-11), rolled(64, creepage).rounds
    monkeypatch.setattr(rolled_surface, "COARSEST_PIXELS", 10**6)
    straight = rolled(64, creepage, tolerance=1e-11)
    np.testing.assert_allclose(begun.traction, straight.traction, atol=1e-6 * np.max(np.abs(straight.traction)))
    assert rounds < rolled(64, creepage).rounds


@pytest.mark.few(1, slow=2)
@pytest.mark.parametrize("finest", [128, pytest.param(256, marks=pytest.mark.long)])
@pytest.mark.parametrize("creepage", CREEPAGES.values(), ids=CREEPAGES)
def test_the_work_hardly_grows_with_the_grid(creepage, finest, monkeypatch):
    """Applications of the elasticity on the finest grid: the power of the time is that of the transforms."""
    shapes = []
    passed = rolled_surface._passed
    monkeypatch.setattr(
        rolled_surface, "_passed", lambda grid, traction: shapes.append(traction.shape) or passed(grid, traction)
    )
    found = {}
    for count in (finest // 2, finest):
        shapes.clear()
        done = rolled(count, creepage)
        found[count] = shapes.count(done.traction.shape)
        assert done.misfit <= 1e-7
        assert done.rounds <= 8
    assert found[finest] <= 1.4 * found[finest // 2]
    assert found[finest] <= 60


def test_narrow_tolerances_do_not_wait_for_single_digits():
    """Single digits leave a misfit of about 1e-10: sixteen steps of Newton were taken, now thirteen."""
    done = rolled(36, CREEPAGES["spin"], tolerance=1e-12)
    assert done.misfit <= 1e-12
    assert done.rounds <= 14


def test_a_near_start_needs_no_coarser_grid(monkeypatch):
    grid, bound, _, _ = hertz(72)
    rigid = np.zeros((2, *bound.shape))
    rigid[0] = 1.5e-3
    done = roll(grid, bound, rigid, np.zeros_like(rigid))
    monkeypatch.setattr(rolled_surface, "halved_grid", lambda grid: pytest.fail("a coarser grid"))
    again = roll(grid, bound, 1.001 * rigid, done.traction)
    assert again.rounds < done.rounds
    assert np.sum(again.traction[0]) == pytest.approx(np.sum(done.traction[0]), rel=1e-3)
    with pytest.raises(pytest.fail.Exception, match="a coarser grid"):
        roll(grid, bound, 2.0 * rigid, done.traction)


def test_a_coarser_grid_that_fails_is_left_out(monkeypatch):
    def fails(*_: object) -> None:
        raise NotConverged("never")

    wanted = rolled(72, CREEPAGES["along"])
    monkeypatch.setattr(rolled_surface, "halved_grid", fails)
    np.testing.assert_allclose(
        rolled(72, CREEPAGES["along"]).traction.sum((1, 2)), wanted.traction.sum((1, 2)), atol=1e-4 * 0.3e-2 * 72**2
    )


@pytest.mark.parametrize("shape", [(64, 70), (65, 71), (66, 65)])
def test_half_of_the_pixels(shape):
    """Sums stay; linear parts of the bound are met inside; a pixel ahead is free."""
    nx, ny = shape
    rng = np.random.default_rng(7)
    bound = rng.uniform(1.0, 2.0, shape)
    coarse = halved_means(bound)
    grid = halved_grid(TractionGrid.of(shape, (1.0, 1.5), SOFT, periodic=False))
    assert grid.grid.shape == coarse.shape
    assert grid.grid.pixel == (2.0, 3.0)
    assert 4.0 * np.sum(coarse) == pytest.approx(np.sum(bound), rel=1e-12)
    assert np.all(coarse[-1] == 0.0)
    u = (np.arange(coarse.shape[0]) + 0.5)[:, None] / coarse.shape[0]
    part = np.stack((u + 0.0 * coarse, 0.2 - 0.3 * u + 0.0 * coarse))
    fine = doubled_traction(part * coarse, coarse, bound)
    v = (np.arange(nx) + 0.5)[:, None] / (2.0 * coarse.shape[0])
    inner = (slice(1, nx - 3), slice(1, ny - 1))
    np.testing.assert_allclose((fine[0] / bound)[inner], (v + 0.0 * bound)[inner], rtol=1e-12)
    np.testing.assert_allclose((fine[1] / bound)[inner], (0.2 - 0.3 * v + 0.0 * bound)[inner], rtol=1e-12, atol=1e-12)


def test_a_strip_is_too_long_by_a_seventh_of_a_pixel():
    """In plane strain F = pi L w / 4 under a slope w, and acts at -L/4: what pixels make of it, as in the manual."""
    for count in (24, 96):
        grid = TractionGrid.of((count + 4, 1), (1.0, 1e6), Compliance(1.0, 0.0), periodic=False)
        bound = np.zeros((count + 4, 1))
        bound[2:-2] = 1e9
        rigid = np.stack((np.ones_like(bound), np.zeros_like(bound)))
        traction = roll(grid, bound, rigid, np.zeros_like(rigid), tolerance=1e-12).traction[0, :, 0]
        longer = np.sum(traction) / (0.25 * np.pi) - count
        assert longer == pytest.approx(0.151, abs=1e-3)
        middle = np.sum(traction * (np.arange(count + 4) - 0.5 * (count + 3))) / np.sum(traction)
        assert middle + 0.25 * (count + longer) == pytest.approx(0.25, abs=1e-3)
