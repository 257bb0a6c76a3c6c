"""Scars of a scan: short or long runs of lines, up to three pixels wide, that leap out of both neighbours and back."""

from __future__ import annotations

import numpy as np

from winkler.numerics.types import Array

WIDEST_SCAR = 3
"""Pixels across a scar."""
BLOCK_PIXELS = 32
"""Pixels along the side of the squares in which steps are compared."""
STEP_RATIO = 1.5
"""So much higher than the steps beside are those of a scar: with 1, ridges and apices would be scars."""
LINE_NEIGHBOURS = np.array([[0, 0, 0], [1, 1, 1], [0, 0, 0]])
LEAST_QUARTILE_RATIO = 1e-9
"""Smallest distance of the quartiles, over the range of all steps."""
LONG_RUN_PIXELS = 8
"""A run of so many pixels counts from half the height on: by chance it has no reason to go on."""


def scars(numbers: Array, times: float, periodic: bool) -> Array:
    """Return where runs of pixels along either direction stand out of the pixels on both sides of the run.

    The steps into and out of a scar both lie beyond Tukey's fences, `times` the distance of the quartiles beyond a
    quartile of the steps around; runs of eight and more pixels, and those that go on from such steps, beyond half of
    it.  Steps beside a scar as high as its own excuse it: so no ridge or apex is one.  At a free border a line has one
    step, and must be long.

    Examples
    --------
    >>> rough = np.sin(np.arange(40.0) ** 2)[:, None] + np.cos(np.arange(30.0) ** 2)[None, :]
    >>> rough[4:16, 7] += 30.0
    >>> [np.flatnonzero(scars(rough, 4.0, False).any(axis)).tolist() for axis in (0, 1)]
    [[7], [4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15]]
    """
    return _across(numbers, times, periodic) | _across(numbers.T, times, periodic).T


def _across(numbers: Array, times: float, periodic: bool) -> Array:
    """Return the scars along the second direction."""
    from scipy.ndimage import binary_closing, label

    n, beyond = numbers.shape[0], WIDEST_SCAR + 2
    around = [(beyond, beyond), (0, 0)]
    steps = np.diff(np.pad(numbers, [(0, 1), (0, 0)], mode="wrap") if periodic else numbers, axis=0)
    middle, scale = _spread(steps)
    framed = np.pad(steps, around, mode="wrap") if periodic else np.pad(steps, around, constant_values=np.nan)
    if not periodic:
        framed = np.concatenate((framed, np.full((1, numbers.shape[1]), np.nan)))
        middle, scale = (np.concatenate((part, part[-1:])) for part in (middle, scale))
    off = framed - np.pad(middle, around, mode="edge")
    size, scale = np.abs(off), np.pad(scale, around, mode="edge")
    marked = np.zeros(numbers.shape, dtype=bool)
    for wide in range(1, min(WIDEST_SCAR, n - 2) + 1):
        rows = np.arange(n if periodic else n - wide + 1) + beyond
        into, out = off[rows - 1], off[rows + wide - 1]
        beside = np.fmax.reduce([size[rows - 2], size[rows + wide], *(size[rows + k] for k in range(wide - 1))])
        for sign in (1.0, -1.0):
            height = (np.fmin if wide == 1 else np.minimum)(sign * into, -sign * out)
            height = np.where(height > STEP_RATIO * np.nan_to_num(beside), height / scale[rows], 0.0)
            part = height > 0.5 + 0.5 * times
            run, count = label(part | binary_closing(part, structure=np.ones((1, 3))), structure=LINE_NEIGHBOURS)
            if not count:
                continue
            long_enough = np.bincount(run.ravel(), minlength=count + 1) >= LONG_RUN_PIXELS
            high = (height > 0.5 + times) & np.isfinite(into) & np.isfinite(out)
            long_enough[np.unique(run[high])] = True
            long_enough[0] = False
            first, along = np.nonzero(long_enough[run])
            for k in range(wide):
                marked[(first + k) % n, along] = True
    return marked


def _spread(steps: Array) -> tuple[Array, Array]:
    """Return the middle of the quartiles of the steps in the square around, and their distance, or the usual one."""
    full = [-(-n // BLOCK_PIXELS) * BLOCK_PIXELS for n in steps.shape]
    padded = np.pad(steps, [(0, m - n) for m, n in zip(full, steps.shape, strict=True)], mode="symmetric")
    squares = padded.reshape(full[0] // BLOCK_PIXELS, BLOCK_PIXELS, full[1] // BLOCK_PIXELS, BLOCK_PIXELS).transpose(
        0, 2, 1, 3
    )
    low, high = np.quantile(squares.reshape(*squares.shape[:2], -1), [0.25, 0.75], axis=-1)
    distance = np.maximum(np.maximum(high - low, np.median(high - low)), LEAST_QUARTILE_RATIO * np.ptp(steps) or 1.0)
    whole = (np.repeat(np.repeat(part, BLOCK_PIXELS, 0), BLOCK_PIXELS, 1) for part in (0.5 * (low + high), distance))
    middle, scale = (part[: steps.shape[0], : steps.shape[1]] for part in whole)
    return middle, scale
