r"""A rough surface made at random, as a value: its parameters are fields, and can be written into a study."""

from __future__ import annotations

import dataclasses

import numpy as np

from winkler.numerics.types import Array
from winkler.profiles.rough.random_rough import random_topography
from winkler.profiles.rough.spectrum import Spectrum
from winkler.profiles.rough.topography import Topography
from winkler.values.checks.number_checks import Seed
from winkler.values.errors import InvalidInput
from winkler.values.value import value

MOST_PIXELS_PER_SIDE = 2**13
"""Pixels along one side; more would not fit the memory of most machines."""


@value
class RandomTopography(Topography):
    """A height map with a given spectrum and random phases.

    Parameters
    ----------
    lengths : array_like, (2,)
        Lengths [m] of the map.
    spectrum : Spectrum
        C(q): SelfAffine or PowerSpectrum; waves longer than the map, or shorter than two pixels, are omitted.
    shape : tuple of int
        Pixels along both directions, (nx, ny).
    seed : int, optional
        Seed of the random phases; equal seeds give equal surfaces.
    periodic : bool, optional
        Whether the map is repeated without end (the default), or consists of one period only.

    Raises
    ------
    InvalidInput
        If lengths, shape or seed are out of range, or no wave of the spectrum fits the map.

    Examples
    --------
    >>> from winkler.profiles.rough.spectrum import SelfAffine
    >>> blasted = SelfAffine(hurst=0.8, rms_height=1e-6, longest=1e-3, shortest=2e-5)
    >>> surface = RandomTopography([1e-3, 1e-3], blasted, (128, 128), seed=1)
    >>> surface.heights.shape, surface.periodic, surface == RandomTopography([1e-3, 1e-3], blasted, (128, 128), seed=1)
    ((128, 128), True, True)
    """

    heights: Array = dataclasses.field(init=False, repr=False, default_factory=lambda: np.zeros((2, 2)))
    periodic: bool = dataclasses.field(default=True, kw_only=True)
    tip_radius: float = dataclasses.field(init=False, repr=False, default=0.0)
    removed: str = dataclasses.field(init=False, repr=False, default="")
    reading: str = dataclasses.field(init=False, repr=False, default="")
    spectrum: Spectrum = dataclasses.field()
    shape: tuple[int, int] = (256, 256)
    seed: Seed = 0

    def __post_init__(self) -> None:
        sides = self.shape if isinstance(self.shape, tuple | list) else ()
        whole = len(sides) == 2 and all(
            isinstance(n, int) and not isinstance(n, bool) and n <= MOST_PIXELS_PER_SIDE for n in sides
        )
        if not whole:
            raise InvalidInput(
                f"RandomTopography: shape is {self.shape!r}; give two whole numbers, at most {MOST_PIXELS_PER_SIDE}."
            )
        try:
            made = random_topography(self.spectrum, self.shape, self.lengths, self.seed)
        except InvalidInput as error:
            raise InvalidInput(str(error).replace("random_topography: ", "RandomTopography: ", 1)) from None
        object.__setattr__(self, "heights", made.heights)
        object.__setattr__(self, "lengths", made.lengths)
