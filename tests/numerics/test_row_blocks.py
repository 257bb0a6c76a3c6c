"""Blocks of rows give what the whole grid gives, in one order, whatever the number of threads."""

from __future__ import annotations

import numpy as np
import pytest

from winkler.numerics.row_blocks import BLOCK_PIXELS, LEAST_PIXELS, RowBlocks

SHAPE = (700, 513)


def test_blocks_are_all_rows_once_and_small():
    rows = RowBlocks(np.empty(SHAPE), 2)
    assert np.array_equal(np.concatenate([np.arange(SHAPE[0])[part] for part in rows.slices]), np.arange(SHAPE[0]))
    assert all((part.stop - part.start) * SHAPE[1] <= BLOCK_PIXELS for part in rows.slices)
    assert [part for run in rows.runs for part in run] == rows.slices
    assert len(RowBlocks(np.empty((2, LEAST_PIXELS)), 2).slices) == 2  # a row is never cut
    assert len(RowBlocks(np.empty((8, 8)), 2).slices) == 1


@pytest.mark.parametrize("workers", [1, 2, 3, 50])
def test_sums_and_changes_are_those_of_the_whole(workers):
    one, other = np.random.default_rng(2).random((2, *SHAPE))
    rows, changed = RowBlocks(one, workers), one.copy()

    def work(part):
        changed[part] *= 2.0
        return float(np.sum(one[part])), int(np.count_nonzero(other[part] > 0.5))

    total, count = rows.total(work)
    assert np.array_equal(changed, 2.0 * one)
    assert total == pytest.approx(one.sum(), rel=1e-13)
    assert count == np.count_nonzero(other > 0.5)
    assert rows.dot(one, other) == pytest.approx(np.vdot(one, other), rel=1e-13)
    assert rows.dot(one, other) == RowBlocks(one, 1).dot(one, other)  # bit by bit


def test_an_error_in_a_block_is_raised():
    def work(part):
        raise ValueError("here")

    with pytest.raises(ValueError, match="here"):
        RowBlocks(np.empty(SHAPE), 2).each(work)
