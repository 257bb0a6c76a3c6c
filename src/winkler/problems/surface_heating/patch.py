"""Two bodies that touch on a map of pixels, and share the heat that friction makes there."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from winkler.materials.conductor import ThermalConductor
from winkler.numerics.surfaces.heated_grid import HeatedGrid
from winkler.numerics.surfaces.shared_heat import HeatSharing
from winkler.numerics.types import Array
from winkler.problems.surface_heating.state import SurfaceHeatState
from winkler.values.errors import NotConverged

Pair = tuple[float, float]
COARSEST = 4
"""Pixels of the contact below which no coarser map is compared."""
ALIKE = 1e-5
"""Part of the greatest rise within which pixels count as equally hot: the middle of them is its place; what pressures
leave of symmetry is of this order."""
NEARLY = 0.05
"""Part of it by which that middle may be colder; else the place is that of one of them and of those beside it."""


class HeatedPatch(NamedTuple):
    """Two bodies that touch on a map, each passing at its own velocity along x.

    Parameters
    ----------
    owner
        Name of the problem, for messages.
    sharing
        The bodies and where they touch.
    pressure
        p [Pa].
    places
        Centres of the pixels along x and along y [m].
    bulk
        Temperatures of the bodies far away [K].
    exchanged
        What flows into the first and the second body because these differ [W/m^2].
    coarse
        The same on pixels of twice the size; none where the contact has too few.
    """

    owner: str
    sharing: HeatSharing
    pressure: Array
    places: tuple[Array, Array]
    bulk: Pair
    exchanged: tuple[Array, Array]
    coarse: HeatedPatch | None

    @classmethod
    def of(
        cls,
        owner: str,
        pressure: Array,
        places: tuple[Array, Array],
        bodies: tuple[ThermalConductor, ThermalConductor],
        speeds: Pair,
        bulk: Pair,
        *,
        compared: bool = True,
    ) -> HeatedPatch:
        """Return the bodies under a map of pressures, `compared` with pixels of twice the size.

        Raises
        ------
        NotConverged
            If the temperatures are not made to agree.
        """
        pixel = _step(places[0]), _step(places[1])
        shape = pressure.shape[0], pressure.shape[1]
        grids = [
            HeatedGrid.of(shape, pixel, body.conductivity, speed / body.diffusivity)
            for body, speed in zip(bodies, speeds, strict=True)
        ]
        sharing = HeatSharing(grids[0], grids[1], pressure > 0.0)
        exchanged = _solved(owner, sharing, np.zeros(shape), bulk[1] - bulk[0])
        coarse = None
        if compared and np.count_nonzero(sharing.touching) >= COARSEST:
            doubled = tuple(_doubled(row) for row in places)
            coarse = cls.of(owner, _halved(pressure), (doubled[0], doubled[1]), bodies, speeds, bulk, compared=False)
        return cls(owner, sharing, pressure, places, bulk, exchanged, coarse)

    def heated(self, flux: Array) -> SurfaceHeatState:
        """Return temperatures and fluxes under the heat of friction [W/m^2], zero where nothing touches.

        Raises
        ------
        NotConverged
            If the temperatures are not made to agree.
        """
        first, second, touching = self.sharing
        area = _step(self.places[0]) * _step(self.places[1])
        rubs = bool(np.any(flux > 0.0))
        shared = _solved(self.owner, self.sharing, flux if rubs else self.pressure, 0.0)
        share = float(np.sum(shared[0]) / np.sum(flux if rubs else self.pressure))
        inflow, outflow = ((into if rubs else 0.0) + due for into, due in zip(shared, self.exchanged, strict=True))
        warm = self.bulk[0] + first.warmed(inflow), self.bulk[1] + second.warmed(outflow)
        hottest = np.where(touching, np.maximum(*warm), -np.inf)
        peak, low = float(np.max(hottest)), min(self.bulk)
        x, y = _middle(self.places, hottest, peak - low)
        change = 0.0
        if self.coarse is not None and peak > low:
            change = abs((self.coarse.heated(_halved(flux)).max_temperature - low) / (peak - low) - 1.0)
        return SurfaceHeatState(
            heat_rate=area * float(np.sum(flux)),
            first_share=share,
            exchanged_heat_rate=area * float(np.sum(self.exchanged[0])),
            max_temperature=peak,
            x=x,
            y=y,
            mean_temperature=float(np.mean(0.5 * (warm[0] + warm[1])[touching])),
            mismatch=float(np.max(np.abs(warm[0] - warm[1])[touching])),
            grid_error=change,
            pressure=self.pressure,
            flux=flux,
            first_flux=inflow,
            first_temperature=warm[0],
            second_temperature=warm[1],
        )


def half_length(touching: Array, pixel: float) -> float:
    """Return half the length of the contact along x [m], from its first to its last pixel."""
    (columns,) = np.nonzero(touching.any(axis=1))
    return 0.5 * pixel * float(columns[-1] - columns[0] + 1) if columns.size else 0.0


def _solved(owner: str, sharing: HeatSharing, flux: Array, difference: float) -> tuple[Array, Array]:
    try:
        return sharing.fluxes(flux, difference)
    except NotConverged as error:
        raise NotConverged(f"{owner}: {error}; give a map of fewer pixels, or of pixels nearer to squares.") from None


def _step(places: Array) -> float:
    """Return the distance of middles of pixels [m]."""
    return float((places[-1] - places[0]) / (places.size - 1))


def _middle(places: tuple[Array, Array], hottest: Array, rise: float) -> tuple[float, float]:
    """Return the middle of the hottest pixels; where it is not hot itself, of the first one and of those beside it."""
    i, j = np.unravel_index(int(np.argmax(hottest)), hottest.shape)
    rows, columns = np.nonzero(hottest >= hottest[i, j] - ALIKE * rise)
    if hottest[round(float(rows.mean())), round(float(columns.mean()))] < hottest[i, j] - NEARLY * rise:
        near = (np.abs(rows - i) <= 1) & (np.abs(columns - j) <= 1)
        rows, columns = rows[near], columns[near]
    return float(np.mean(places[0][rows])), float(np.mean(places[1][columns]))


def _doubled(places: Array) -> Array:
    """Return the middles of pixels of twice the size."""
    step = _step(places)
    return np.asarray(places[0] + 0.5 * step + 2.0 * step * np.arange(-(-places.size // 2)))


def _halved(content: Array) -> Array:
    """Return means over two by two pixels; a row that is left over stands with zeros."""
    nx, ny = (-(-n // 2) for n in content.shape)
    padded = np.zeros((2 * nx, 2 * ny))
    padded[: content.shape[0], : content.shape[1]] = content
    return np.asarray(padded.reshape(nx, 2, ny, 2).mean(axis=(1, 3)))
