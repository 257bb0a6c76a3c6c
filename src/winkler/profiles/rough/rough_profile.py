"""A rough body: the height map of its roughness on the shape of a profile, such as a rivet's head."""

from __future__ import annotations

import dataclasses

import numpy as np

from winkler.numerics.types import Array
from winkler.profiles.ellipse import CurvedBodies
from winkler.profiles.profile import Profile
from winkler.profiles.rough.sampled_profile import SampledProfile
from winkler.profiles.rough.topography import Topography
from winkler.values.value import value, words


@value
class RoughProfile(Topography):
    """A height map added to a profile: measured or random roughness on a smooth shape.

    The map is not periodic. Its mean plane follows the profile, whose apex is in the middle.

    Parameters
    ----------
    topography : Topography
        The roughness; of a periodic map one period is used.
    profile : Profile or CurvedBodies
        f(r), or the two relative curvatures of bodies with an elliptic contact.

    Raises
    ------
    InvalidInput
        If the profile is undefined or infinite on a part of the map.

    Examples
    --------
    >>> from winkler.profiles.power import Paraboloid
    >>> from winkler.profiles.rough.random_surface import RandomTopography
    >>> from winkler.profiles.rough.spectrum import SelfAffine
    >>> turned = RandomTopography([0.2e-3, 0.2e-3], SelfAffine(0.8, 0.1e-6, 0.1e-3, 10e-6), (64, 64), seed=1)
    >>> rivet = RoughProfile(turned, Paraboloid(2e-3))
    >>> rivet.periodic, round(1e6 * float(np.ptp(rivet.heights)), 1)
    (False, 4.9)
    """

    __words__ = words(topography=("", None, "the roughness on the profile"))

    heights: Array = dataclasses.field(init=False, repr=False, default_factory=lambda: np.zeros((2, 2)))
    lengths: Array = dataclasses.field(init=False, repr=False, default_factory=lambda: np.ones(2))
    periodic: bool = dataclasses.field(init=False, repr=False, default_factory=bool)
    tip_radius: float = dataclasses.field(init=False, repr=False, default=0.0)
    removed: str = dataclasses.field(init=False, repr=False, default="")
    reading: str = dataclasses.field(init=False, repr=False, default="")
    topography: Topography = dataclasses.field()
    profile: Profile | CurvedBodies = dataclasses.field()

    def __post_init__(self) -> None:
        rough = self.topography
        size = rough.heights.shape
        smooth = SampledProfile(rough.lengths, self.profile, (size[0], size[1]))
        made = Topography(smooth.heights + (rough.heights - np.nanmean(rough.heights)), rough.lengths)
        object.__setattr__(self, "heights", made.heights)
        object.__setattr__(self, "lengths", made.lengths)
        object.__setattr__(self, "tip_radius", rough.tip_radius)
        object.__setattr__(self, "removed", rough.removed)
        object.__setattr__(self, "reading", rough.reading)
