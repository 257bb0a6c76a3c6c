r"""Friction on the patches of two profiles that roll: tractions, creep forces and what friction takes.

On the arc s of the lower profile the rigid slip per distance follows from the motion of both bodies at every place of
it, so that tread and flange, or the bottom and the sides of a groove, slip differently on one patch,

.. math:: w_x = \xi(s) , \qquad w_t = \eta(s) + \varphi(s)\,(x-x_0) ,

and what slips and sticks under it is that of steady rolling (`winkler.numerics.surfaces.rolled_surface`).  Patches of
one window are solved together.
"""

from __future__ import annotations

import math

import numpy as np

from winkler.laws.friction import Coulomb
from winkler.laws.varying_friction import FallingFriction, greatest_coefficient
from winkler.media.mapped import MappedMedium
from winkler.numerics.surfaces.pressed_box import box_around
from winkler.numerics.surfaces.traction_grid import TractionGrid
from winkler.numerics.types import Array
from winkler.problems.pressed_shape.surface_load import SurfaceLoad
from winkler.problems.profile_pair.creepages import Drift, creepages_along
from winkler.problems.profile_pair.gap_map import GapMap
from winkler.problems.profile_pair.patch import ProfilePatch
from winkler.problems.profile_pair.placing import PlacedBody
from winkler.problems.profile_pair.pressed_pair import PlacedPair
from winkler.problems.rolling.creepage import Creepage
from winkler.problems.rough.compliance import compliance_of
from winkler.problems.subsurface.below_surface import BelowSurface
from winkler.problems.surface_rolling.creepages import AHEAD
from winkler.problems.surface_rolling.falling import roll_under
from winkler.values.errors import NotConverged, OutsideValidity
from winkler.values.value import value, words


@value
class RolledPatch(BelowSurface):
    """One patch on which two bodies roll with friction.

    Parameters
    ----------
    patch : ProfilePatch
        Its place, size, pressures and creepages.
    creepage : Creepage
        Longitudinal, lateral and spin at the middle of the pressure, with the drift of the upper body.
    longitudinal_force, lateral_force : float
        Forces on the lower body, along x and along the arc towards +y [N].
    moment : float
        Moment on the lower body about the normal at the centre of pressure [N m].
    x_force, y_force, z_force : float
        Resultant of pressures and friction on the upper body: longitudinal, lateral and upward [N].
    saturation : float
        Resultant of longitudinal and lateral force over mu F_N [-]; mu is that of slow slip if friction falls.
    stick_share : float
        Part of the patch that does not slip [-].
    loss_per_distance : float
        Energy dissipated by friction per distance rolled [J/m]; multiplied by the speed it is the power.
    traction : ndarray, (2, n, m)
        Traction on the lower body along x and along the arc [Pa].
    greatest_rigid_slip : float
        Maximum slip per distance rolled that rigid bodies would have on the patch [-].
    creep : ndarray, (2, n, m)
        Slip of the upper body over the lower one per distance rolled [-].
    slipping : ndarray of bool, (n, m)
        Whether the pixel slips.
    """

    __words__ = words(
        patch=("", None, "its place, size and pressures"),
        moment=("M_n", "N m", "moment of friction about the normal at the middle of the pressure"),
        x_force=("F_{2x}", "N", "force on the upper body, along"),
        y_force=("F_{2y}", "N", "force on the upper body, across"),
        z_force=("F_{2z}", "N", "force on the upper body, up"),
        stick_share=("A_s/A", "", "part of the contact that does not slip"),
        greatest_rigid_slip=("w", "", "greatest slip of rigid bodies on the patch, per distance rolled"),
        creep=("s'", "", "slip of the upper body over the lower one, per distance rolled"),
        slipping=("", None, "which pixels slip"),
    )

    patch: ProfilePatch
    creepage: Creepage
    longitudinal_force: float
    lateral_force: float
    moment: float
    x_force: float
    y_force: float
    z_force: float
    saturation: float
    stick_share: float
    loss_per_distance: float
    greatest_rigid_slip: float
    traction: Array
    creep: Array
    slipping: Array

    @property
    def pressure(self) -> Array:
        """p [Pa], ``(n, m)``."""
        return self.patch.pressure

    @property
    def surface_load(self) -> SurfaceLoad:
        """Pressures and tractions on the lower body, with x along and y along the arc from the middle."""
        pressed = self.patch.surface_load
        return SurfaceLoad(pressed.pressure, pressed.lengths, self.traction[0], self.traction[1], pressed.corner)

    @property
    def _medium(self) -> MappedMedium:
        return self.patch.medium


def rolled_patches(
    placed: PlacedPair,
    medium: MappedMedium,
    friction: Coulomb | FallingFriction,
    rolled: float,
    drift: Drift,
    tolerance: float,
    speed: float,
) -> tuple[list[RolledPatch], float]:
    """Return all patches with their tractions, and the greatest `RolledSurface.misfit`.

    Parameters
    ----------
    placed : PlacedPair
        The bodies and their pressures.
    medium : MappedMedium
        Both bodies, which bear tractions of pixels.
    friction : Coulomb or FallingFriction
        Law of friction.
    rolled : float
        Rolled radius [m].
    drift : Drift
        Of the upper body.
    tolerance : float
        As in `roll`.
    speed : float
        Of rolling [m/s], for friction that falls with the velocity of slip.

    Raises
    ------
    OutsideValidity
        If friction falls too steeply with the velocity of slip.
    NotConverged
        If stick and slip are not found to the tolerance.
    """
    compliance, found, misfit = compliance_of(medium)._replace(coupling=0.0), [], 0.0
    for region, patches in zip(placed.windows.regions, placed.patches, strict=True):
        box = box_around(region.pressure > 0.0)
        pressure = region.pressure[box] / medium.modulus
        dx, ds = region.gaps.pixel
        creeps = [_creepages(placed.lower, placed.down, region.gaps, patch, rolled, drift) for patch in patches]
        rigid = np.zeros((2, *region.pressure.shape))
        for patch, (xi, eta, spin) in zip(patches, creeps, strict=True):
            ahead = (patch.along + AHEAD * dx)[:, None]
            slip = np.stack(np.broadcast_arrays(xi, eta + spin * ahead))
            rigid = np.where(patch.pressure > 0.0, slip, rigid)
        grid = TractionGrid.of(pressure.shape, (1.0, ds / dx), compliance.in_units_of(dx), periodic=False)
        start, here = np.zeros((2, *pressure.shape)), (slice(None), *box)
        try:
            slip = rigid[here] * (pressure > 0.0)
            solved = roll_under(friction, speed, grid, pressure, slip, start, tolerance=tolerance)
        except (NotConverged, OutsideValidity) as error:
            way_out = "; allow a larger tolerance, or use more pixels" if isinstance(error, NotConverged) else ""
            raise type(error)(
                f"ProfilePairRolling: on the patch at y = {patches[0].y:.6g} m, {error}{way_out}."
            ) from None
        misfit = max(misfit, solved.misfit)
        traction, creep = np.zeros(rigid.shape), np.zeros(rigid.shape)
        traction[here] = medium.modulus * solved.traction
        creep[here] = np.where(solved.slipping, solved.slip, 0.0)
        found += [
            _rolled(patch, region.gaps, greatest_coefficient(friction), rigid, traction, creep, creepages)
            for patch, creepages in zip(patches, creeps, strict=True)
        ]
    return found, misfit


def _creepages(
    lower: PlacedBody, upper: PlacedBody, gaps: GapMap, patch: ProfilePatch, rolled: float, drift: Drift
) -> Array:
    """Return xi, eta and phi along the arc, through the middle of the pressure."""
    places = np.stack([np.full(gaps.y.shape, patch.x), gaps.y, gaps.z])
    normal = np.stack([np.zeros(gaps.y.shape), *gaps.normal])
    gap = upper.distance(places, normal)
    return creepages_along(lower, upper, places, np.where(np.isfinite(gap), gap, 0.0), rolled, drift)


def _rolled(
    patch: ProfilePatch,
    gaps: GapMap,
    coefficient: float,
    rigid: Array,
    traction: Array,
    creep: Array,
    creepages: Array,
) -> RolledPatch:
    inside = patch.pressure > 0.0
    area = gaps.pixel[0] * gaps.pixel[1]
    tau, slip = traction * inside, creep * inside
    slipping = inside & (np.hypot(slip[0], slip[1]) > 0.0)
    along, lateral = (area * np.sum(tau, axis=(1, 2))).tolist()
    x = patch.along[:, None] - AHEAD * gaps.pixel[0] * ~slipping
    up, across = gaps.normal[1], -gaps.normal[0]  # of the direction of the arc: across and up
    drawn = area * tau[1].sum(axis=0)
    pushed = area * patch.pressure.sum(axis=0)
    xi, eta, spin = creepages
    middle = [float(np.interp(0.0, patch.across, row)) for row in creepages]
    return RolledPatch(
        patch=patch,
        creepage=Creepage(*middle),
        longitudinal_force=along,
        lateral_force=lateral,
        moment=area * float(np.sum(x * tau[1] - patch.across * tau[0])),
        x_force=-along,
        y_force=float(gaps.normal[0] @ pushed - up @ drawn),
        z_force=float(gaps.normal[1] @ pushed - across @ drawn),
        saturation=math.hypot(along, lateral) / (coefficient * float(np.sum(pushed))),
        stick_share=float(np.count_nonzero(inside & ~slipping)) / float(np.count_nonzero(inside)),
        loss_per_distance=area * float(np.sum(tau[0] * xi + tau[1] * (eta + spin * x))),
        greatest_rigid_slip=float(np.max(np.hypot(rigid[0], rigid[1]) * inside)),
        traction=tau,
        creep=slip,
        slipping=slipping,
    )
