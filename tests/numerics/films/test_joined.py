"""Islands across seams, paths through, and the narrowest place of the widest path by another route."""

from __future__ import annotations

import heapq

import numpy as np
import pytest

from winkler.numerics.films.joined import islands, through, widest_path


def by_flooding(where, wraps, corners):
    """Islands by flooding from pixel to pixel."""
    sides = [(1, 0), (-1, 0), (0, 1), (0, -1)] + ([(1, 1), (1, -1), (-1, 1), (-1, -1)] if corners else [])
    found, count, shape = np.zeros(where.shape, int), 0, where.shape
    for start in zip(*np.nonzero(where), strict=True):
        if found[start]:
            continue
        count += 1
        found[start] = count
        heap = [start]
        while heap:
            place = heap.pop()
            for side in sides:
                new = [place[0] + side[0], place[1] + side[1]]
                if any(not 0 <= new[a] < shape[a] and not wraps[a] for a in (0, 1)):
                    continue
                spot = (new[0] % shape[0], new[1] % shape[1])
                if where[spot] and not found[spot]:
                    found[spot] = count
                    heap.append(spot)
    return found, count


@pytest.mark.parametrize("corners", [False, True])
@pytest.mark.parametrize("wraps", [(False, False), (True, True), (False, True), (True, False)])
def test_islands_by_flooding(wraps, corners):
    for seed, share in ((0, 0.25), (1, 0.4), (2, 0.55)):
        where = np.random.default_rng(seed).random((13, 11)) < share
        labels, count = islands(where, wraps, corners=corners)
        flooded, expected = by_flooding(where, wraps, corners)
        assert count == expected
        assert set(np.unique(labels)) == set(range(count + 1)) if not where.all() else True
        pairs = {(int(a), int(b)) for a, b in zip(labels.ravel(), flooded.ravel(), strict=True)}
        assert len(pairs) == count + 1  # one name for one name


def by_dijkstra(gap, wraps):
    """The greatest smallest width of all paths, by the widest place first."""
    nx, ny = gap.shape
    best = np.zeros(gap.shape)
    heap = [(-gap[0, j], 0, j) for j in range(ny) if gap[0, j] > 0.0]
    while heap:
        width, i, j = heapq.heappop(heap)
        if -width <= best[i, j]:
            continue
        best[i, j] = -width
        for di, dj in ((1, 0), (-1, 0), (0, 1), (0, -1)):
            ii, jj = i + di, j + dj
            if not 0 <= ii < nx or (not 0 <= jj < ny and not wraps):
                continue
            new = min(-width, gap[ii, jj % ny])
            if new > best[ii, jj % ny]:
                heapq.heappush(heap, (-new, ii, jj % ny))
    return float(best[-1].max())


@pytest.mark.parametrize("wraps", [False, True])
def test_the_widest_path(wraps):
    for seed in range(6):
        gap = np.maximum(np.random.default_rng(seed).random((17, 14)) - 0.3, 0.0)
        found = widest_path(gap, wraps=wraps)
        assert found.gap == by_dijkstra(gap, wraps)
        if found.gap > 0.0:
            assert gap[found.place] == found.gap
            without = gap.copy()
            without[found.place] = 0.0
            assert by_dijkstra(without, wraps) < found.gap


def test_no_way():
    gap = np.ones((6, 5))
    gap[3] = 0.0
    assert widest_path(gap, wraps=True) == (0.0, (-1, -1))
    assert not through(gap > 0.0, wraps=True).any()
