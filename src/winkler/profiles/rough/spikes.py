"""Artefacts of a height map: grains and dropouts, and the scars that a scan leaves."""

from __future__ import annotations

import numpy as np

from winkler.numerics.types import Array
from winkler.values.value import frozen_array, value, words


@value
class Spikes:
    """Heights that deviate strongly from their surroundings; as text their number and size.

    Parameters
    ----------
    grains : ndarray of bool, (nx, ny)
        Spots up to about four pixels wide that lie far above or below the surrounding heights.
    scars : ndarray of bool, (nx, ny)
        Runs of pixels along either direction, up to three pixels wide, with a step up and a step back.
    height : ndarray, (nx, ny)
        Deviation of the heights [m] from the surface without spikes; zero elsewhere.
    """

    __words__ = words(
        grains=("", None, "where grains and dropouts stand out of a surface"),
        scars=("", None, "where scars of a scan stand out of a surface"),
        height=("", "m", "by how much heights differ from the surface bridged without them"),
    )

    grains: Array
    scars: Array
    height: Array

    def __post_init__(self) -> None:
        for word in ("grains", "scars", "height"):
            object.__setattr__(self, word, frozen_array(np.asarray(getattr(self, word))))

    @property
    def where(self) -> Array:
        """Whether a pixel belongs to a grain or a scar."""
        return np.asarray(self.grains | self.scars)

    def __str__(self) -> str:
        """Return what was found, in one line."""
        count = int(np.count_nonzero(self.where))
        if not count:
            return "no spikes"
        return (
            f"{count} of {self.where.size} pixels stand out by up to {float(np.max(np.abs(self.height))):.3g} m: "
            f"{int(np.count_nonzero(self.grains))} of grains and dropouts, "
            f"{int(np.count_nonzero(self.scars & ~self.grains))} of scars"
        )
