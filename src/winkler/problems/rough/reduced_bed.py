"""A bed that stands for a height map: measured springs, computed by boundary elements when the bed is made."""

from __future__ import annotations

import dataclasses
import functools
from typing import ClassVar

import numpy as np

from winkler.foundation.directional import DirectionalBed
from winkler.foundation.footprint import UnknownOutline
from winkler.media.mapped import MappedMedium
from winkler.numerics.types import Array
from winkler.problems.rough.reduce import Reduction
from winkler.profiles.rough.topography import Topography
from winkler.values.value import value, words

SMOOTHNESS = 1e-3
UNKNOWN_OUTLINE = UnknownOutline(
    "a height map",
    "use SurfaceContact(topography, medium, load) for its pressure and area, SurfaceConduction for what it conducts, "
    "or give Foundation(profile, medium)",
)


def _none() -> Array:
    return np.zeros(0)


@value
class ReducedBed(DirectionalBed):
    """A spring foundation with the force-depth curve of a height map.

    It is computed from some ten contact solutions by boundary elements. After that each force or depth is computed in
    milliseconds.

    Parameters
    ----------
    topography : Topography
        A non-periodic map.
    pressed_into : HalfSpace, TransverselyIsotropicHalfSpace, CoatedHalfSpace, DepthGradedHalfSpace or GradedHalfSpace
        Both bodies.
    depth : float
        Maximum depth d [m] of the springs.
    tolerance : float, optional
        Maximum error of F between the computed contacts, over the maximum F.

    Raises
    ------
    InvalidInput, OutsideValidity, NotConverged
        As `Reduction`.
    """

    __words__ = words(
        directional=("", "", "greatest difference of both ratios of stiffness"),
        certain=("", None, "whether every contact is known to be one disc"),
        rising=("", None, "whether the depth rises with the radius"),
        depth=("d", "m", "greatest depth up to which the springs are known"),
        tolerance=(r"\epsilon", "", "error of the force between the computed contacts"),
    )

    radii: Array = dataclasses.field(init=False, repr=False, default_factory=_none)
    stiffnesses: Array = dataclasses.field(init=False, repr=False, default_factory=_none)
    depths: Array = dataclasses.field(init=False, repr=False, default_factory=_none)
    scatter: float = dataclasses.field(init=False, repr=False, default=0.0)
    mindlin_ratio: float = dataclasses.field(init=False, repr=False, default=0.0)
    disc: bool = dataclasses.field(init=False, repr=False, default=False)
    ratios_along: Array = dataclasses.field(init=False, repr=False, default_factory=_none)
    ratios_across: Array = dataclasses.field(init=False, repr=False, default_factory=_none)
    shift_error: float = dataclasses.field(init=False, repr=False, default=0.0)
    loss_error: float = dataclasses.field(init=False, repr=False, default=0.0)
    homogeneous: bool = dataclasses.field(init=False, repr=False, default=True)
    topography: Topography = dataclasses.field()
    pressed_into: MappedMedium = dataclasses.field()
    depth: float = dataclasses.field()
    tolerance: float = SMOOTHNESS

    references: ClassVar[tuple[str, ...]] = Reduction.references

    @property
    def footprint(self) -> UnknownOutline:
        """Not known: the contact consists of spots of any outline."""
        return UNKNOWN_OUTLINE

    def __post_init__(self) -> None:
        reduced = _springs(Reduction(self.topography, self.pressed_into, self.depth, self.tolerance))
        for field in dataclasses.fields(DirectionalBed):
            object.__setattr__(self, field.name, getattr(reduced, field.name))


@functools.lru_cache(maxsize=16)
def _springs(problem: Reduction) -> DirectionalBed:
    """Return the springs; equal surfaces are pressed once."""
    return problem.solve().bed
