r"""Two conducting bodies that touch in many pixels of a grid: their resistance, through platings and a film.

All pixels in contact have one voltage between the bodies,

.. math:: V = \frac{\rho_1+\rho_2}{2}\,G\,J + \sigma_f\,J ,

with the flux density J, the response G of the surface to a flux as to a pressure over E*, layered where there are
platings (`winkler.media.conduction.disc_resistance`), and the area resistance of the film.
"""

from __future__ import annotations

import dataclasses
from typing import NamedTuple

import numpy as np

from winkler.materials.conducting_body import ConductingBody, Plated, Rod, parts_of, resistivity_of, surface_of
from winkler.media.conduction.disc_resistance import PlatedResponse
from winkler.numerics.pixels.layered import LayeredSurface
from winkler.numerics.surfaces.punched_grid import punch
from winkler.numerics.surfaces.surface_grid import SurfaceGrid
from winkler.numerics.types import Array

VOLTAGE_TOLERANCE = 1e-4
"""Error of the voltage of a pixel; that of the resistance is of its square, those of its parts of its order."""


class SpotResistances(NamedTuple):
    """Parts of the resistance of a contact, in series [ohm or K/W].

    Parameters
    ----------
    first, second
        Constriction in either body, platings included.
    film
        Its area resistance over the area of the contact; that it spreads the current is counted in the constriction.
    bare
        Constriction in both bodies without platings, and without the film.
    least_share, greatest_share
        Of the first body in the voltage over both constrictions, over all pixels [-]; they differ between bodies whose
        platings respond differently.
    """

    first: float
    second: float
    film: float
    bare: float
    least_share: float
    greatest_share: float


def spot_resistances(
    touching: Array,
    pixel: tuple[float, float],
    bodies: tuple[ConductingBody, ConductingBody],
    area_resistance: float,
    *,
    periodic: bool,
) -> SpotResistances:
    """Return the resistance to a current through the pixels of a contact.

    Parameters
    ----------
    touching
        Where the bodies touch, (nx, ny), somewhere.
    pixel
        (dx, dy) [m].
    bodies
        First and second: thick ones, plated or not.
    area_resistance
        Of a film between them [ohm m^2 or m^2 K/W].
    periodic
        Whether the contact is repeated without end; the resistance is then that of one period beyond that of the same
        bodies in full contact without film.

    Raises
    ------
    NotConverged
        If the flux is not found.
    OutsideValidity
        If the pixels are too coarse for the platings.
    """
    patch = pixel[0] * pixel[1]
    if periodic and touching.all():
        return SpotResistances(0.0, 0.0, area_resistance / (patch * touching.size), 0.0, 0.5, 0.5)
    rho = [resistivity_of(surface_of(body)) for body in bodies]
    both, film = sum(rho), 2.0 * area_resistance / sum(rho)
    layers = plated_surface(*bodies)

    def flux(below: LayeredSurface | None, softness: float) -> Array:
        return np.asarray(
            punch(touching, pixel, periodic=periodic, tolerance=VOLTAGE_TOLERANCE, layers=below, film=softness)
        )

    flow = flux(layers, film)
    total = float(np.sum(flow))
    whole = both / (2.0 * patch * total)
    lost = area_resistance / (patch * float(np.count_nonzero(touching)))
    voltages = [
        part * _voltages(flow, pixel, plated_surface(body, body), periodic)[touching]
        for part, body in zip(rho, bodies, strict=True)
    ]
    falls = [float(np.sum(flow[touching] * part)) for part in voltages]
    parts = [(whole - lost) * fall / sum(falls) for fall in falls]
    shares = voltages[0] / (voltages[0] + voltages[1])
    bare = flow if layers is None and film == 0.0 else flux(None, 0.0)
    under = sum(resistivity_of(parts_of(body)[-1]) for body in bodies)
    uncovered = under / (2.0 * patch * float(np.sum(bare)))
    return SpotResistances(parts[0], parts[1], lost, uncovered, float(np.min(shares)), float(np.max(shares)))


def plated_surface(first: ConductingBody, second: ConductingBody) -> LayeredSurface | None:
    """Return how the platings of two bodies respond to a flux, together; nothing without platings.

    Over the sum of the resistivities at both surfaces, and with lengths in units of the thinner plating.
    """
    plated = [body for body in (first, second) if isinstance(body, Plated)]
    if all(len({resistivity_of(part) for part in parts_of(body)}) == 1 for body in plated):
        return None
    unit = min(body.thickness for body in plated)

    def scaled(body: ConductingBody) -> ConductingBody:
        if not isinstance(body, Plated):
            return body
        below = scaled(body.on)
        assert not isinstance(below, Rod)  # no plating lies on one
        return dataclasses.replace(body, thickness=body.thickness / unit, on=below)

    return LayeredSurface(PlatedResponse(scaled(first), scaled(second)), unit)


def _voltages(flow: Array, pixel: tuple[float, float], layers: LayeredSurface | None, periodic: bool) -> Array:
    """Return the voltage over one body at each pixel, in units that are the same for both bodies."""
    shape = (flow.shape[0], flow.shape[1])
    below = layers.in_units_of(pixel[0]) if layers else None
    grid = SurfaceGrid.of(shape, (1.0, pixel[1] / pixel[0]), periodic=periodic, layers=below)
    return np.asarray(grid.displaced(flow))
