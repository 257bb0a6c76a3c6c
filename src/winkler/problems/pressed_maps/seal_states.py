"""The film between a pressed height map and the other body, and what it lets through."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from winkler.numerics.films.effective_medium import effective_conductance
from winkler.numerics.films.joined import WidestPath, widest_path
from winkler.numerics.films.thin_film import FilmFlow, film_flow
from winkler.numerics.types import Array
from winkler.profiles.rough.topography import Topography


class FilmPassage(NamedTuple):
    """What a film lets through along one direction.

    Parameters
    ----------
    flow
        Per pressure difference over 12 times the viscosity [m^3].
    path
        The widest path and its narrowest place.
    even
        The same flow of a film of the mean gap everywhere [m^3].
    medium
        The same of the effective medium of the gaps [m^3].
    """

    flow: FilmFlow
    path: WidestPath
    even: float
    medium: float


def factor_of(found: FilmPassage) -> float:
    """Return the flow over that of the mean gap; zero where no film is left."""
    return found.flow.rate / found.even if found.even > 0.0 else 0.0


def gap_of(pressure: Array, separation: Array) -> Array:
    """Return the width of the film [m]: zero in contact."""
    return np.where(pressure > 0.0, 0.0, separation)


def passage(gap: Array, rough: Topography, *, lateral: bool = False) -> FilmPassage:
    """Return what a film lets through along x, or along y if `lateral`.

    Parameters
    ----------
    gap
        Width of the film [m], (nx, ny).
    rough
        The map, whose repetition across the flow is that of the film.
    lateral
        Whether it flows along y.
    """
    width, pixel, lengths = gap, rough.pixel, (float(rough.lengths[0]), float(rough.lengths[1]))
    if lateral:
        width, pixel, lengths = gap.T, pixel[::-1], lengths[::-1]
    unit = float(np.max(width))
    if unit == 0.0:
        return FilmPassage(film_flow(width, pixel, wraps=rough.periodic), WidestPath(0.0, (-1, -1)), 0.0, 0.0)
    conductance = (width / unit) ** 3  # of any unit of length
    flow = film_flow(conductance, pixel, wraps=rough.periodic)
    cube = unit**3
    flow = flow._replace(rate=cube * flow.rate, along=cube * flow.along, across=cube * flow.across)
    across = lengths[1] / lengths[0]
    path = widest_path(width, wraps=rough.periodic)
    if lateral:
        path = WidestPath(path.gap, (path.place[1], path.place[0]))
        flow = flow._replace(pressure=flow.pressure.T, along=flow.across.T, across=flow.along.T)
    even = across * float(np.mean(width)) ** 3
    return FilmPassage(flow, path, even, across * cube * effective_conductance(conductance))
