r"""A height map pressed against a flat, and the fluid that leaks between them.

The film between the bodies is as wide as the gap h of the contact, and zero where they touch; Reynolds' equation

.. math:: \nabla\cdot\left(\frac{h^3}{12\eta}\,\nabla p\right) = 0

is solved on its pixels between two opposite sides of the map.
"""

from __future__ import annotations

from typing import ClassVar

import numpy as np

from winkler.loading.path import numbers_of
from winkler.numerics.films.thin_film import FilmFlow
from winkler.numerics.types import Array, PerLoad, Q, shaped
from winkler.problems.assumptions.declared import MAPPED
from winkler.problems.pressed_maps.seal_states import FilmPassage, factor_of, gap_of, passage
from winkler.problems.pressed_maps.second_points import (
    measured,
    on_second_points,
    refuse_without_second_points,
    spread,
)
from winkler.problems.rough.surface_contact import SurfaceContact, SurfaceContactSolution
from winkler.problems.rough.surface_notes import YASTREBOV
from winkler.problems.rough.surface_states import SurfaceState
from winkler.values.checks.number_checks import Positive, affordable
from winkler.values.limits import MOST_FILM_PIXELS
from winkler.values.validity import Assumption, Note, Standing, standing_of
from winkler.values.value import value, words


@value
class Seal(PerLoad[Q]):
    """Leakage of a fluid between a height map and a flat pressed together.

    Parameters
    ----------
    contact : SurfaceContact
        The mechanical contact.
    viscosity : float
        Dynamic viscosity of the fluid [Pa s].
    pressure_drop : float
        Pressure difference between two opposite sides of the map [Pa].

    Raises
    ------
    InvalidInput
        If a number is not positive, or the map has more than 2048 x 2048 pixels or fewer than eight along a side. If
        the map is periodic with an odd number of pixels.

    References
    ----------
    N. Patir, H. S. Cheng, J. Lubr. Technol. 100 (1978) 12-17, doi:10.1115/1.3453103; W. B. Dapp, A. Luecke,
    B. N. J. Persson, M. H. Mueser, Phys. Rev. Lett. 108 (2012) 244301, doi:10.1103/PhysRevLett.108.244301

    Examples
    --------
    Grooves that are hardly pressed, water under 1 bar: along them it flows with the mean cube of the gap, across them
    with its harmonic mean, which is zero where they touch.

    >>> import numpy as np
    >>> from winkler.loading.loads import Force
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.profiles.rough.topography import Topography
    >>> y = np.arange(64) / 64
    >>> grooves = Topography(1e-6 * np.cos(2.0 * np.pi * y) + 0.0 * y[:, None], [1e-3, 1e-3], periodic=True)
    >>> contact = SurfaceContact(grooves, HalfSpace(Elastic(210e9, 0.3)), Force(1.0))
    >>> seal = Seal(contact, viscosity=1e-3, pressure_drop=1e5).solve()
    >>> round(seal.flow_factor, 1), seal.lateral_flow_factor
    (2.5, 0.0)
    """

    __words__ = words(
        contact=("", None, "how the surface is pressed"),
        viscosity=(r"\eta", "Pa s", "dynamic viscosity of the fluid"),
        pressure_drop=(r"\Delta p", "Pa", "pressure of the fluid between two opposite sides"),
    )

    contact: SurfaceContact[Q]
    viscosity: Positive
    pressure_drop: Positive

    references: ClassVar[tuple[str, ...]] = ("patir_cheng_1978", "dapp_2012", "polonsky_keer_1999")
    assumptions: ClassVar[frozenset[Assumption]] = MAPPED

    def __post_init__(self) -> None:
        affordable("Seal", "pixels", self.contact.topography.heights.size, MOST_FILM_PIXELS)
        refuse_without_second_points("Seal", self.contact)

    def solve(self) -> SealSolution[Q]:
        """Return the leak rate under every load.

        Raises
        ------
        InvalidInput
            If every second height of a periodic map is the same.
        NotConverged
            If a contact is not solved to its tolerance.
        """

        def both_ways(state: SurfaceState) -> tuple[FilmPassage, FilmPassage]:
            gap = gap_of(state.pressure, state.separation)
            return _passage(gap, self.contact, False), _passage(gap, self.contact, True)

        contact, rows = measured(self.contact, both_ways)

        def along(second: SurfaceContact) -> tuple[SurfaceContactSolution, list[float]]:
            return measured(
                second, lambda state: _passage(gap_of(state.pressure, state.separation), second, False).flow.rate
            )

        coarse = [along(second) for second in on_second_points(self.contact, contact.force)]
        shape = numbers_of(self.contact.load).shape
        leak = self.pressure_drop / (12.0 * self.viscosity)

        def column(numbers: list[float]) -> Q:
            return shaped(np.array(numbers).reshape(shape))

        rate = np.array([x.flow.rate for x, _ in rows])
        return SealSolution(
            self, contact,
            *(contact.depth, contact.force, contact.area),
            *(shaped(spread(contact.area, (second.area for second, _ in coarse))), contact.mean_gap),
            column([leak * x.flow.rate for x, _ in rows]),
            column((leak * spread(rate, (np.array(rates) for _, rates in coarse))).tolist()),
            column([leak * y.flow.rate for _, y in rows]),
            column([leak * x.medium for x, _ in rows]),
            column([factor_of(x) for x, _ in rows]),
            column([factor_of(y) for _, y in rows]),
            column([x.path.gap for x, _ in rows]),
            column([y.path.gap for _, y in rows]),
            column([max(x.flow.imbalance, y.flow.imbalance) for x, y in rows]),
        )  # fmt: skip


def _passage(gap: Array, contact: SurfaceContact, lateral: bool) -> FilmPassage:
    return passage(gap, contact.topography, lateral=lateral)


@value
class SealSolution(PerLoad[Q]):
    """The solution of a `Seal`; quantities have the shape of the load.

    Parameters
    ----------
    problem : Seal
        The problem that was solved.
    contact : SurfaceContactSolution
        The contact, with its maps under the last load.
    depth, force, area, mean_gap : float or ndarray
        As in `SurfaceContactSolution` [m], [N], [m^2], [m].
    area_error : float or ndarray
        Error estimate [m^2]: the maximum difference between the areas on the full map and on the four maps of every
        second point.
    leak_rate : float or ndarray
        Volume per time that flows along x through the whole map [m^3/s]; zero if no open path exists.
    leak_rate_error : float or ndarray
        Error estimate [m^3/s]: the maximum difference between the leak rates on the full map and on the four maps of
        every second point.
    lateral_leak_rate : float or ndarray
        The same flow along y [m^3/s].
    medium_leak_rate : float or ndarray
        Leak rate along x by Bruggeman's effective medium theory [m^3/s], for isotropic maps; zero if half of the map
        is in contact.
    flow_factor, lateral_flow_factor : float or ndarray
        Flow along x and y over that of a uniform film with the mean gap (Patir and Cheng).
    critical_gap, lateral_critical_gap : float or ndarray
        Smallest gap on the most open path along x and y [m]; zero if no open path exists.
    imbalance : float or ndarray
        Relative difference of inflow and outflow, the larger one of both directions.
    """

    __words__ = words(
        contact=("", None, "the contact by boundary elements"),
        area_error=(r"\Delta A", "m^2", "greatest difference of areas from every second point of the map"),
        imbalance=(r"\epsilon_Q", "", "difference of the flows in and out, over their mean"),
    )

    problem: Seal[Q]
    contact: SurfaceContactSolution[Q]
    depth: Q
    force: Q
    area: Q
    area_error: Q
    mean_gap: Q
    leak_rate: Q
    leak_rate_error: Q
    lateral_leak_rate: Q
    medium_leak_rate: Q
    flow_factor: Q
    lateral_flow_factor: Q
    critical_gap: Q
    lateral_critical_gap: Q
    imbalance: Q

    def closing_share(self) -> tuple[float, float]:
        """Return the limits of the contact fraction at which the last path along x closes (percolation threshold).

        The first number is the largest fraction with leakage (zero if it never leaks), the second the smallest without
        (one if it always leaks).
        """
        shares = np.ravel(np.asarray(self.area)) / self.problem.contact.topography.area
        leaks = np.ravel(np.asarray(self.leak_rate)) > 0.0
        return float(np.max(shares[leaks], initial=0.0)), float(np.min(shares[~leaks], initial=1.0))

    def last_passage(self, *, lateral: bool = False) -> FilmPassage:
        """Return flow and critical path of the fluid film along x or y, under the last load."""
        state = self.contact.last
        return _passage(gap_of(state.pressure, state.separation), self.problem.contact, lateral)

    def fluid_pressure(self) -> Array:
        """Return the pressure of the fluid under the last load [Pa], (nx, ny), with the drop along x; nan where no
        fluid flows.
        """
        return np.asarray(self.problem.pressure_drop * self.last_flow().pressure)

    def last_flow(self) -> FilmFlow:
        """Return the flow along x under the last load, for a pressure drop of one over 12 viscosities."""
        return self.last_passage().flow

    @property
    def validity(self) -> tuple[Note, ...]:
        """How far the result can be trusted: the contact, the film, its grid, the pressure of the fluid."""
        stated = self.problem
        rough = stated.contact.topography
        return (
            *(note for note in self.contact.validity if note.source != YASTREBOV),
            *seal_notes(
                area=float(np.max(np.asarray(self.area_error) / self.area)),
                squeeze=stated.pressure_drop * rough.area / float(np.min(self.force)),
                leak=np.ravel(np.asarray(self.leak_rate)),
                change=np.ravel(np.asarray(self.leak_rate_error)),
                narrow=np.ravel(np.asarray(self.critical_gap)),
                overlap=np.ravel(np.asarray(self.contact.penetration) * np.asarray(self.depth)),
                periodic=rough.periodic,
            ),
        )


PATIR = "N. Patir, H. S. Cheng, J. Lubr. Technol. 100 (1978) 12-17, doi:10.1115/1.3453103"
DAPP = (
    "W. B. Dapp, A. Luecke, B. N. J. Persson, M. H. Mueser, Phys. Rev. Lett. 108 (2012) 244301, "
    "doi:10.1103/PhysRevLett.108.244301"
)
SMALL_CHANGE, LARGE_CHANGE = 0.05, 0.5
SMALL_SQUEEZE, LARGE_SQUEEZE = 0.1, 1.0
"""Pressure of the fluid over the mean pressure of the contact."""


def seal_notes(
    *, area: float, squeeze: float, leak: Array, change: Array, narrow: Array, overlap: Array, periodic: bool
) -> tuple[Note, ...]:
    """Return what was assumed of a film.

    Parameters
    ----------
    area
        Relative change of the area of contact from every second point, the greatest of all loads.
    squeeze
        Pressure drop over force per area of the map, the greatest of all loads.
    leak, change
        Leak rate of every load and its change from every second point.
    narrow
        Critical gap of every load.
    overlap
        Overlap that the solver of the contact left [m].
    periodic
        Whether the map is repeated.
    """
    sides = "the map is repeated across the flow" if periodic else "the sides along the flow are closed"
    notes = [
        Note(
            Assumption.RESPONSE,
            Standing.EXACT,
            "Reynolds' equation for a laminar film of a Newtonian, incompressible fluid that fills the gap "
            f"without slip at both bodies; {sides}.",
            PATIR,
        ),
        Note(
            Assumption.EQUILIBRIUM,
            standing_of(squeeze, SMALL_SQUEEZE, LARGE_SQUEEZE),
            "The contact is computed without the fluid, whose pressure does not separate the bodies. The fluid "
            f"pressure is up to {squeeze:.2g} of the mean contact pressure.",
            "comparison of both pressures",
        ),
        Note(
            Assumption.RESOLUTION,
            standing_of(area, SMALL_CHANGE, LARGE_CHANGE),
            "Computed on all and on every second point of the map, the contact areas differ by up to "
            f"{100.0 * area:.2g} per cent.",
            DAPP,
            area,
        ),
    ]
    open_loads = leak > 0.0
    if not np.all(open_loads):
        notes.append(
            Note(
                Assumption.RESOLUTION,
                Standing.APPROXIMATE,
                f"Under {int(np.count_nonzero(~open_loads))} of {leak.size} loads no path of pixels passes "
                "through the seal; paths narrower than a pixel are not resolved.",
                DAPP,
            )
        )
    if np.any(open_loads):
        worst = float(np.max(change[open_loads] / leak[open_loads]))
        lost = bool(np.any(narrow[open_loads] <= overlap[open_loads]))
        notes.append(
            Note(
                Assumption.RESOLUTION,
                Standing.OUTSIDE if lost else standing_of(worst, SMALL_CHANGE, LARGE_CHANGE),
                "Computed on all and on every second point of the map, the leak rates differ by up to "
                f"{100.0 * worst:.2g} per cent"
                + (
                    "; the narrowest gap is below the tolerance of the solver: give a smaller tolerance."
                    if lost
                    else "."
                ),
                DAPP,
                worst,
            )
        )
    return tuple(notes)
