r"""How much of a height map touches, how hard, in how many patches: with the error that two grids show.

The area is that of the pixels less what their edge counts too much (Yastrebov and others),

.. math:: A = A_\mathrm{pixels} - 0.9\,\frac{\pi-1+\ln 2}{24}\,S\,\Delta x ,

with the length S of the edge along the sides of the pixels; the factor 0.9 is measured
(`winkler.numerics.pixels.contact_area`).  The contact is solved again on every second point of the
map: by as much as area and peak pressure change, so far may they be from those of a fine grid.
"""

from __future__ import annotations

from typing import ClassVar

import numpy as np

from winkler.loading.path import numbers_of
from winkler.numerics.films.joined import islands
from winkler.numerics.types import Array, ArrayLike, PerLoad, Q, shaped
from winkler.problems.assumptions.declared import MAPPED
from winkler.problems.pressed_maps.second_points import (
    measured,
    on_second_points,
    refuse_without_second_points,
    spread,
)
from winkler.problems.rough.surface_contact import SurfaceContact, SurfaceContactSolution
from winkler.problems.rough.surface_notes import YASTREBOV
from winkler.problems.rough.surface_states import SurfaceState
from winkler.values.validity import Assumption, Note, standing_of
from winkler.values.value import value, words

SMALL_CHANGE, LARGE_CHANGE = 0.02, 0.5
"""Relative change of the area or peak pressure from every second point at which the grid is no more fine, and lost."""


@value
class TrueArea(PerLoad[Q]):
    """True contact area, pressure and number of patches of a pressed height map.

    Parameters
    ----------
    contact : SurfaceContact
        How the map is pressed.

    Raises
    ------
    InvalidInput
        If the map has fewer than eight pixels along a side, or is periodic with an odd number of them.

    References
    ----------
    V. A. Yastrebov, G. Anciaux, J.-F. Molinari, Tribol. Int. 114 (2017) 161-171, doi:10.1016/j.triboint.2017.04.023

    Examples
    --------
    A wave pressed half flat (Westergaard: half of it touches at half the pressure that closes it).

    >>> import numpy as np
    >>> from winkler.loading.loads import Force
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.profiles.rough.topography import Topography
    >>> x = np.arange(64) / 64
    >>> wave = Topography(0.01 * np.cos(2.0 * np.pi * x[:, None]) + 0.0 * x, [1.0, 1.0], periodic=True)
    >>> contact = SurfaceContact(wave, HalfSpace(Elastic(1.0, 0.0)), Force(0.5 * np.pi * 0.01))
    >>> touching = TrueArea(contact).solve()
    >>> round(touching.area, 1), int(touching.patch_count)
    (0.5, 1)
    """

    __words__ = words(contact=("", None, "how the surface is pressed"))

    contact: SurfaceContact[Q]

    references: ClassVar[tuple[str, ...]] = ("yastrebov_2017", "polonsky_keer_1999")
    assumptions: ClassVar[frozenset[Assumption]] = MAPPED

    def __post_init__(self) -> None:
        refuse_without_second_points("TrueArea", self.contact)

    def solve(self) -> TrueAreaSolution[Q]:
        """Return area, pressure and patches under every load.

        Raises
        ------
        InvalidInput
            If every second height of a periodic map is the same.
        NotConverged
            If a contact is not solved to its tolerance.
        """

        def peaks_and_patches(state: SurfaceState) -> tuple[float, int, float]:
            areas = patch_areas(state, self.contact)
            return float(np.max(state.pressure)), areas.size, float(areas[0])

        contact, found = measured(self.contact, peaks_and_patches)
        coarse = [
            measured(second, lambda state: float(np.max(state.pressure)))
            for second in on_second_points(self.contact, contact.force)
        ]
        shape = numbers_of(self.contact.load).shape
        peak = np.array([row[0] for row in found]).reshape(shape)
        return TrueAreaSolution(
            self, contact,
            *(contact.depth, contact.force, contact.area),
            shaped(spread(contact.area, (second.area for second, _ in coarse))), shaped(peak),
            shaped(spread(peak, (np.array(peaks).reshape(shape) for _, peaks in coarse))), contact.mean_gap,
            shaped(np.array([row[1] for row in found], dtype=float).reshape(shape)),
            shaped(np.array([row[2] for row in found]).reshape(shape)),
        )  # fmt: skip


def patch_areas(state: SurfaceState, contact: SurfaceContact) -> Array:
    """Return the areas of the patches of contact [m^2], the largest first; pixels that touch at a corner are joined.

    Pixels are counted, and what all patches together have too much along their edges is taken off each in proportion.
    """
    rough = contact.topography
    labels, _ = islands(state.pressure > 0.0, (rough.periodic, rough.periodic), corners=True)
    counts = np.sort(np.bincount(labels.ravel())[1:])[::-1]
    return np.asarray(counts * (float(state.area) / float(np.sum(counts))))


@value
class TrueAreaSolution(PerLoad[Q]):
    """The solution of a `TrueArea`; quantities have the shape of the load.

    Parameters
    ----------
    problem : TrueArea
        The problem that was solved.
    contact : SurfaceContactSolution
        The contact, with its maps under the last load.
    depth, force : float or ndarray
        As in `SurfaceContactSolution` [m], [N].
    area : float or ndarray
        Area of the contact [m^2], corrected along its edge.
    area_error : float or ndarray
        Error estimate [m^2]: the maximum difference between the areas on the full map and on the four maps of every
        second point.
    peak_pressure : float or ndarray
        Maximum pressure of a pixel [Pa].
    peak_pressure_error : float or ndarray
        Error estimate [Pa]: the maximum difference between the values on the full map and on the four maps of every
        second point.
    mean_gap : float or ndarray
        Mean distance of the surfaces over the map [m].
    patch_count : float or ndarray
        Number of patches of contact; pixels that touch at a corner belong to one patch.
    largest_patch : float or ndarray
        Area of the largest one [m^2].
    """

    __words__ = words(
        contact=("", None, "the contact by boundary elements"),
        area_error=(r"\Delta A", "m^2", "greatest difference of areas from every second point of the map"),
        peak_pressure=(r"p_\mathrm{max}", "Pa", "greatest pressure of a pixel"),
    )

    problem: TrueArea[Q]
    contact: SurfaceContactSolution[Q]
    depth: Q
    force: Q
    area: Q
    area_error: Q
    peak_pressure: Q
    peak_pressure_error: Q
    mean_gap: Q
    patch_count: Q
    largest_patch: Q

    def patches(self) -> Array:
        """Return the areas of the patches under the last load [m^2], the largest first, (n,)."""
        return patch_areas(self.contact.last, self.problem.contact)

    def pressure_quantiles(self, shares: ArrayLike) -> Array:
        """Return quantiles of the pressure in the contact pixels [Pa], under the last load."""
        pressure = self.contact.last.pressure
        return np.asarray(np.quantile(pressure[pressure > 0.0], np.asarray(shares, dtype=float)))

    def gap_quantiles(self, shares: ArrayLike) -> Array:
        """Return quantiles of the gap over the whole map [m], contact included, under the last load."""
        state = self.contact.last
        return np.asarray(
            np.quantile(np.where(state.pressure > 0.0, 0.0, state.separation), np.asarray(shares, dtype=float))
        )

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted: the contact, and the change from every second point."""
        area = float(np.max(np.asarray(self.area_error) / self.area))
        peak = float(np.max(np.asarray(self.peak_pressure_error) / self.peak_pressure))
        change = Note(
            Assumption.RESOLUTION,
            standing_of(max(area, peak), SMALL_CHANGE, LARGE_CHANGE),
            f"Computed on all and on every second point of the map, areas differ by up to {100.0 * area:.2g} per "
            f"cent, maximum pressures by {100.0 * peak:.2g} per cent. The difference to a finer map may be about "
            "as large.",
            YASTREBOV,
            max(area, peak),
        )
        # the estimate of the contact itself assumes round spots, this one needs no assumption
        others = (note for note in self.contact.validity if note.source != YASTREBOV)
        return (*others, change)
