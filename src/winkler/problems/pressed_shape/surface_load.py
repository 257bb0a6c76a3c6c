"""Pressures and tractions on a surface, pixel by pixel, as a contact or another program gives them."""

from __future__ import annotations

import dataclasses
from typing import Annotated

import numpy as np

from winkler.media.interior.map_field import MapField
from winkler.media.interior.periodic_map_field import PeriodicMapField
from winkler.numerics.types import Array
from winkler.values.checks.number_checks import POSITIVE, Advice, Numbers, affordable
from winkler.values.errors import InvalidInput
from winkler.values.limits import MOST_NUMBERS
from winkler.values.value import value, words

PADDING = 4
"""Numbers of a transform over the pixels of a map that stands alone."""

FARTHEST = 1e9
"""Distance of the corner from zero, in pixels, beyond which rounding of places matters."""

MAP = Numbers(fewest=0, any_shape=True)


def _none() -> Array:
    return np.zeros(0)


def _corner() -> Array:
    return np.zeros(2)


@value
class SurfaceLoad:
    """Pressures and tractions on the surface of a body, constant in every pixel.

    Parameters
    ----------
    pressure : array_like, (nx, ny)
        p [Pa], compression positive, of the pixels around x = x0 + (i + 1/2) dx and y = y0 + (j + 1/2) dy.
    lengths : array_like, (2,)
        Lengths [m] of the map along its two directions: pixels are lengths / (nx, ny).
    x_traction, y_traction : array_like, (nx, ny), optional
        Tractions on the body along x and y [Pa]; zero by default.
    corner : array_like, (2,), optional
        Position x0, y0 of the corner of the map [m]; zero by default.
    periodic : bool, optional
        Whether the map is repeated without end, or is surrounded by a surface without loads (the default).

    Raises
    ------
    InvalidInput
        If the maps differ in shape, are not finite, or contain no load.

    Examples
    --------
    A square of 1 mm under 10 MPa bears 10 N.

    >>> import numpy as np
    >>> SurfaceLoad(np.full((4, 4), 10e6), [1e-3, 1e-3]).force
    10.0
    """

    __words__ = words(
        x_traction=(r"\tau_x", "Pa", "traction along x that acts on the body"),
        y_traction=(r"\tau_y", "Pa", "traction along y that acts on the body"),
        loads=("", "Pa", "pressure and tractions along x and y"),
        pixel=("", "m", "size of one pixel"),
        places=("", "m", "middles of the pixels along x and along y"),
        x_force=("F_x", "N", "sum of the tractions along x"),
        y_force=("F_y", "N", "sum of the tractions along y"),
        corner=("x_0, y_0", "m", "where the map begins"),
    )

    pressure: Annotated[Array, MAP]
    lengths: Annotated[Array, Numbers(POSITIVE), Advice("two positive lengths in m")]
    x_traction: Annotated[Array, MAP] = dataclasses.field(default_factory=_none)
    y_traction: Annotated[Array, MAP] = dataclasses.field(default_factory=_none)
    corner: Array = dataclasses.field(default_factory=_corner)
    periodic: bool = False

    def __post_init__(self) -> None:
        shape = np.shape(self.pressure)
        if len(shape) != 2 or min(shape) < 1:
            raise InvalidInput(f"SurfaceLoad: the pressure has the shape {shape}; give a map (nx, ny) in Pa.")
        affordable("SurfaceLoad", "pixels with their surroundings", PADDING * self.pressure.size, MOST_NUMBERS)
        if self.lengths.shape != (2,):
            raise InvalidInput(f"SurfaceLoad: lengths are {self.lengths!r}; give two positive lengths in m.")
        if np.shape(self.corner) != (2,) or not np.all(np.isfinite(self.corner)):
            raise InvalidInput(f"SurfaceLoad: the corner is {self.corner!r}; give two places in m.")
        if np.any(np.abs(self.corner) > FARTHEST * np.array(self.pixel)):
            raise InvalidInput(
                f"SurfaceLoad: the map begins at ({self.corner[0]:.6g}, {self.corner[1]:.6g}) m, so far away that "
                f"pixels of {min(self.pixel):.6g} m cannot be distinguished; give a corner nearer to zero."
            )
        for name in ("x_traction", "y_traction"):
            part = np.shape(getattr(self, name))
            if part not in (shape, (0,)):
                raise InvalidInput(
                    f"SurfaceLoad: {name} has the shape {part} and the pressure {shape}; give maps of the same pixels."
                )
        if not np.any(self.loads):
            raise InvalidInput("SurfaceLoad: all pressures and tractions are zero; give a load.")

    @classmethod
    def of_map(cls, lengths: Array, pressure: Array, traction: Array, *, periodic: bool = False) -> SurfaceLoad:
        """Return the pressures ``(nx, ny)`` and tractions ``(2, nx, ny)`` [Pa] on the first body, over a map."""
        return cls(pressure, lengths, traction[0], traction[1], periodic=periodic)

    @property
    def loads(self) -> Array:
        """Pressure and tractions along x and y [Pa], (3, nx, ny)."""
        still = np.zeros(self.pressure.shape)
        return np.stack([self.pressure, *(part if part.size else still for part in (self.x_traction, self.y_traction))])

    @property
    def pixel(self) -> tuple[float, float]:
        """Size of one pixel [m]."""
        return float(self.lengths[0] / self.pressure.shape[0]), float(self.lengths[1] / self.pressure.shape[1])

    @property
    def places(self) -> tuple[Array, Array]:
        """Centres of the pixels along x and along y [m]."""
        nx, ny = self.pressure.shape
        x, y = self.corner
        return x + (np.arange(nx) + 0.5) * self.pixel[0], y + (np.arange(ny) + 0.5) * self.pixel[1]

    @property
    def force(self) -> float:
        """Sum of the pressures [N]; for a periodic map on one period."""
        return self._sum(self.pressure)

    @property
    def x_force(self) -> float:
        """Sum of the tractions along x [N]."""
        return self._sum(self.x_traction)

    @property
    def y_force(self) -> float:
        """Sum of the tractions along y [N]."""
        return self._sum(self.y_traction)

    def _sum(self, part: Array) -> float:
        return float(np.sum(part)) * self.pixel[0] * self.pixel[1]

    def field(self, poisson: float) -> MapField | PeriodicMapField:
        """Return the stress field in a body with this Poisson's ratio."""
        kind = PeriodicMapField if self.periodic else MapField
        return kind(self.loads, self.pixel, poisson)

    def reversed(self) -> SurfaceLoad:
        """Return the load on the other body in the same tangential axes: tractions change their sign."""
        return dataclasses.replace(self, x_traction=-self.x_traction + 0.0, y_traction=-self.y_traction + 0.0)

    def turned(self) -> SurfaceLoad:
        """Return the map with x and y exchanged."""
        return SurfaceLoad(
            self.pressure.T, self.lengths[::-1], self.y_traction.T, self.x_traction.T, self.corner[::-1], self.periodic
        )

    def halved(self) -> SurfaceLoad:
        """Return the means over two by two pixels; an odd last row is padded with zeros."""
        nx, ny = (-(-n // 2) for n in self.pressure.shape)
        padded = np.zeros((3, 2 * nx, 2 * ny))
        padded[:, : self.pressure.shape[0], : self.pressure.shape[1]] = self.loads
        means = padded.reshape(3, nx, 2, ny, 2).mean(axis=(2, 4))
        lengths = 2.0 * np.array(self.pixel) * (nx, ny)
        return SurfaceLoad(means[0], lengths, means[1], means[2], self.corner, self.periodic)
