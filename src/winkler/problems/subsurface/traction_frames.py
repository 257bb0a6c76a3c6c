"""What sticks and slips at states along a history, small enough to be kept: the film of a contact."""

from __future__ import annotations

from typing import Any

import numpy as np

from winkler.numerics.surfaces.pressed_box import box_around
from winkler.numerics.types import Array
from winkler.values.value import value, words

MOST_BYTES = 32_000_000
"""Memory of all frames of a history; beyond it every second one is left out."""


@value
class TractionFrame:
    """The part of a map around the contact, in one state of a history.

    Parameters
    ----------
    index : int
        Which state, from zero.
    corner : tuple of int
        First pixel of the part along x and along y.
    touching, slipping : ndarray of bool, (n, m)
        Which pixels touch, and which of them slip.
    traction : ndarray, (2, n, m)
        (tau_x, tau_y) [Pa] in single precision, with which the second body drags the first.
    """

    __words__ = words(
        index=("", "", "which state, from zero"),
        corner=("", None, "first pixel of the part around the contact"),
        touching=("", None, "which pixels touch"),
        slipping=("", None, "which pixels slip"),
    )

    index: int
    corner: tuple[int, int]
    touching: Array
    slipping: Array
    traction: Array


class FrameKeeper:
    """Keeps frames of a history, all of them or every second, fourth, ... where they are large."""

    def __init__(self) -> None:
        self._frames: list[TractionFrame] = []
        self._stride, self._bytes = 1, 0

    def add(self, index: int, state: Any) -> None:
        """Keep the frame of a state, if it is one of those that are kept."""
        if index % self._stride:
            return
        touching = state.pressure > 0.0
        box = box_around(touching) if touching.any() else (slice(0, 1), slice(0, 1))
        frame = TractionFrame(
            index,
            (box[0].start, box[1].start),
            touching[box],
            state.slipping[box].copy(),
            state.traction[(slice(None), *box)].astype(np.float32),
        )
        self._frames.append(frame)
        self._bytes += _size(frame)
        while self._bytes > MOST_BYTES and len(self._frames) > 1:
            self._frames, self._stride = self._frames[::2], 2 * self._stride
            self._bytes = sum(_size(each) for each in self._frames)

    def kept(self) -> tuple[TractionFrame, ...]:
        """Return the frames that are kept, in their order."""
        return tuple(self._frames)


def _size(frame: TractionFrame) -> int:
    return int(frame.touching.nbytes + frame.slipping.nbytes + frame.traction.nbytes)


def frame_at(frames: tuple[TractionFrame, ...], index: int) -> TractionFrame:
    """Return the last frame that is not after a state."""
    return max((frame for frame in frames if frame.index <= index), key=lambda frame: frame.index, default=frames[0])
