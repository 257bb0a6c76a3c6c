"""Convolutions of grids whose transforms are large: in memory that is kept, by blocks of rows and columns in place.

An array of more than 32 MiB is fetched from the system anew each time, page by page: on 4096 x 4096 pixels that took
about as long as the transforms themselves.
"""

from __future__ import annotations

from concurrent.futures import ThreadPoolExecutor

import numpy as np

from winkler.numerics.types import Array

__all__ = ["LEAST_KEPT_PIXELS", "Room", "convolved"]

LEAST_KEPT_PIXELS = 2**23
"""Pixels of the transform from which on its memory is kept: in single digits 32 MiB."""
BLOCK_ROWS = 64


class Room:
    """Memory of one transform in single digits, kept from one convolution to the next."""

    def __init__(self) -> None:
        self.kept = np.empty((0, 0), dtype=np.complex64)

    def of(self, shape: tuple[int, int], digits: np.dtype[np.complexfloating]) -> Array:
        """Return an array of this shape with any numbers in it; only single digits are kept."""
        if digits != self.kept.dtype:
            return np.empty(shape, dtype=digits)
        if self.kept.shape != shape:
            self.kept = np.empty(shape, dtype=digits)
        return self.kept


def convolved(numbers: Array, factor: Array, padded: tuple[int, int], workers: int, room: Room) -> Array:
    """Return numbers on a grid with each wave of their transform times a factor.

    Parameters
    ----------
    numbers
        On the grid, (nx, ny).
    factor
        Of each wave, (padded[0], padded[1] // 2 + 1).
    padded
        Size of the transform; zeros lie beyond the grid.
    workers
        Threads.
    room
        Where the transform is put.
    """
    import scipy.fft

    rows, columns = numbers.shape
    waves = room.of((padded[0], padded[1] // 2 + 1), np.result_type(numbers.dtype, np.complex64))
    found = np.empty(numbers.shape, dtype=numbers.dtype)

    def forth(part: slice) -> None:
        waves[part] = scipy.fft.rfft(numbers[part], padded[1], axis=-1)

    def times(part: slice) -> None:
        waves[part] *= factor[part]

    def back(part: slice) -> None:
        found[part] = scipy.fft.irfft(waves[part], padded[1], axis=-1)[:, :columns]

    def blocks(count: int) -> list[slice]:
        return [slice(start, min(start + BLOCK_ROWS, count)) for start in range(0, count, BLOCK_ROWS)]

    with ThreadPoolExecutor(workers) as pool:
        list(pool.map(forth, blocks(rows)))
        waves[rows:] = 0.0
        waves = scipy.fft.fft(waves, axis=0, workers=workers, overwrite_x=True)
        list(pool.map(times, blocks(padded[0])))
        waves = scipy.fft.ifft(waves, axis=0, workers=workers, overwrite_x=True)
        list(pool.map(back, blocks(rows)))
    return found
