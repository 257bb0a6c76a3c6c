"""One place where two profiles touch: its pressures, size, force and creepages."""

from __future__ import annotations

import math

import numpy as np

from winkler.media.mapped import MappedMedium
from winkler.numerics.pixels.contact_area import contact_area
from winkler.numerics.types import Array
from winkler.problems.pressed_shape.surface_load import SurfaceLoad
from winkler.problems.profile_pair.creepages import creepage_at
from winkler.problems.profile_pair.placing import PlacedBody
from winkler.problems.profile_pair.pressing import Region
from winkler.problems.rolling.creepage import Creepage
from winkler.problems.subsurface.below_surface import BelowSurface
from winkler.values.value import value, words

LEAST_SHARE = 1e-6
"""Part of the force of a window that a patch must bear: less is rounding."""


@value
class ProfilePatch(BelowSurface):
    """One patch on which two bodies touch.

    Parameters
    ----------
    medium : HalfSpace or TransverselyIsotropicHalfSpace
        Both bodies.
    force, lateral_force, vertical_force : float
        Forces on the upper body: the resultant, and its lateral and vertical components [N].
    angle : float
        Contact angle between resultant and vertical [rad], positive where the lower profile rises towards +y.
    x, y, z : float
        Centre of pressure in the axes of the lower body: longitudinal, lateral and vertical [m].
    second_y : float
        Lateral position of the centre of pressure in the profile of the upper body [m].
    depth : float
        Maximum overlap of the undeformed bodies along a normal [m].
    peak_pressure : float
        [Pa].
    area : float
        [m^2].
    longitudinal_length, lateral_length : float
        Length and width of the patch [m], resolved to half a pixel.
    turned : float
        Angle by which the direction of the lower profile turns from end to end [rad].
    creepage : Creepage
        Longitudinal, lateral and spin at the middle of the pressure: slip of the upper body over the lower one.
    along, across : ndarray, (n,) and (m,)
        Centres of the pixels along x, and along the arc of the lower profile [m], from the centre of pressure.
    pressure : ndarray, (n, m)
        [Pa].
    """

    __words__ = words(
        lateral_force=("F_y", "N", "force on the upper body, across"),
        vertical_force=("F_z", "N", "force on the upper body, up"),
        angle=(r"\alpha", "rad", "contact angle: direction of the force against the vertical"),
        x=("x", "m", "middle of the pressure, along"),
        y=("y", "m", "middle of the pressure, across"),
        z=("z", "m", "middle of the pressure, up"),
        second_y=("y_2", "m", "middle of the pressure across in the profile of the upper body"),
        depth=("d", "m", "greatest overlap of the undeformed bodies along a normal"),
        longitudinal_length=("", "m", "length of the patch along"),
        lateral_length=("", "m", "length of the patch across, along its arc"),
        turned=("", "rad", "angle by which the lower profile turns within the patch"),
        along=("x", "m", "middles of the pixels along, from the middle of the pressure"),
        across=("s", "m", "middles of the pixels along the arc, from the middle of the pressure"),
        creepage=("", None, "slip of the upper body over the lower one while they roll"),
    )

    medium: MappedMedium
    force: float
    lateral_force: float
    vertical_force: float
    angle: float
    x: float
    y: float
    z: float
    second_y: float
    depth: float
    peak_pressure: float
    area: float
    longitudinal_length: float
    lateral_length: float
    turned: float
    creepage: Creepage
    along: Array
    across: Array
    pressure: Array

    @property
    def surface_load(self) -> SurfaceLoad:
        """The pressures, with x along and y along the arc from the middle of the pressure."""
        pixel = np.array([self.along[1] - self.along[0], self.across[1] - self.across[0]])
        corner = np.array([self.along[0], self.across[0]]) - 0.5 * pixel
        return SurfaceLoad(self.pressure, pixel * self.pressure.shape, corner=corner)

    @property
    def _medium(self) -> MappedMedium:
        return self.medium


def patches_of(
    lower: PlacedBody, upper: PlacedBody, region: Region, medium: MappedMedium, rolled_radius: float
) -> list[ProfilePatch]:
    """Return the patches of one window: parts of it whose pixels touch each other."""
    from scipy.ndimage import label

    whole = float(np.sum(region.pressure))
    numbers, count = label(region.pressure > 0.0, structure=np.ones((3, 3)))
    found = []
    for number in range(1, count + 1):
        pressure = np.where(numbers == number, region.pressure, 0.0)
        if float(np.sum(pressure)) > LEAST_SHARE * whole:
            found.append(_patch(lower, upper, region, pressure, medium, rolled_radius))
    return found


def _patch(
    lower: PlacedBody,
    upper: PlacedBody,
    region: Region,
    pressure: Array,
    medium: MappedMedium,
    rolled_radius: float,
) -> ProfilePatch:
    gaps, touching = region.gaps, pressure > 0.0
    dx, ds = gaps.pixel
    arc = (np.arange(gaps.y.size) + 0.5) * ds
    across, up = (gaps.normal @ pressure.sum(axis=0) * dx * ds).tolist()
    whole = float(np.sum(pressure))
    x = float(np.sum(pressure.sum(axis=1) * gaps.x)) / whole
    middle = float(np.sum(pressure.sum(axis=0) * arc)) / whole
    y, z = float(np.interp(middle, arc, gaps.y)), float(np.interp(middle, arc, gaps.z))
    place = np.array([x, y, z])
    i, j = np.argmin(np.abs(gaps.x - x)), np.argmin(np.abs(arc - middle))
    gap = float(gaps.gap[i, j])
    return ProfilePatch(
        medium=medium,
        force=math.hypot(across, up),
        lateral_force=across,
        vertical_force=up,
        angle=math.atan2(-across, up),
        x=x,
        y=y,
        z=z,
        second_y=float(upper.own(place)[1]),
        depth=-float(np.min(gaps.gap[touching])),
        peak_pressure=float(np.max(pressure)),
        area=contact_area(touching, gaps.pixel, False)[0],
        longitudinal_length=dx * float(np.count_nonzero(touching.any(axis=1))),
        lateral_length=ds * float(np.count_nonzero(touching.any(axis=0))),
        turned=float(np.ptp(np.arctan2(*gaps.normal)[touching.any(axis=0)])),
        creepage=creepage_at(lower, upper, place, gap, rolled_radius),
        along=gaps.x - x,
        across=arc - middle,
        pressure=pressure,
    )
