"""Common style of all figures: colours that colour-blind readers can distinguish."""

from __future__ import annotations

import numpy as np

from winkler.numerics.types import Array

INK = "#22272e"
MUTED = "#6b7480"
PALE = "#d9dee4"
BODY = "#b9c6d3"
SOLID = "#efe3c8"
BLUE, RED, GREEN, ORANGE, PURPLE, SKY = "#0072b2", "#d55e00", "#009e73", "#e69f00", "#a3568a", "#56b4e9"
CYCLE = (BLUE, RED, GREEN, ORANGE, PURPLE, SKY, INK)
"""After Okabe and Ito (2008), the purple a little darker."""

DASHES: tuple[tuple[float, ...], ...] = ((), (5.0, 2.0), (1.2, 1.2), (6.0, 2.0, 1.2, 2.0))
"""Lengths of strokes and gaps in line widths, so that curves can be distinguished in print without colour."""
DOTTED, DASHED = (1.0, 1.65), (4.0, 3.0)

SHADES, RELIEFS, TENSIONS, HEATS = "viridis_r", "cividis", "Reds", "YlOrRd"
"""Colour maps: of stresses and pressures, perceptually even; of heights; of tension; of temperatures."""


MAPS = {
    "viridis_r": (
        "fde725 d5e21a aadc32 81d34d 5cc863 3dbc74 27ad81 1f9f88 21908d 26818e 2c718e 33628d "
        "3b518b 423f85 472c7a 481769 440154"
    ),
    "cividis": (
        "00224e 002e6a 1a386f 32436d 434e6c 535a6d 61656f 6f7073 7d7c78 8c8878 9b9476 aba072 "
        "bcae6c cdbb63 dec958 f0d846 fee838"
    ),
    "Reds": (
        "fff5f0 feeae1 fee0d2 fdcdb9 fcbba1 fca689 fc9272 fb7d5d fb694a f5523a ee3a2c dc2924 "
        "ca181d b71319 a30f15 840711 67000d"
    ),
    "YlOrRd": (
        "ffffcc fff6b6 ffeda0 fee38b fed976 fec561 feb24c fd9f44 fd8c3c fc6c33 fc4d2a ef3323 "
        "e2191c cf0c21 bb0026 9d0026 800026"
    ),
}
"""Colours of the maps at equal distances, red, green and blue of each as six digits."""


def channels(colour: str | tuple[str, float]) -> Array:
    """Return red, green and blue from 0 to 1 of ``#rrggbb``, or of a position on a colour map."""
    if isinstance(colour, str):
        return np.array([int(colour[place : place + 2], 16) for place in (1, 3, 5)]) / 255.0
    stops = np.array([channels(f"#{stop}") for stop in MAPS[colour[0]].split()])
    place = np.linspace(0.0, 1.0, len(stops))
    return np.array([np.interp(colour[1], place, channel) for channel in stops.T])


def pressure_colour(share: float) -> tuple[str, float]:
    """Return the colour of a pressure, or of a tension where it is negative, as a part of the greatest."""
    return (SHADES, share) if share >= 0.0 else (TENSIONS, -share)


def shade(share: float) -> tuple[str, float]:
    """Return a colour of the map of stresses and pressures, by a position on it from 0 to 1."""
    return SHADES, share


def mirrored(along: Array, of: Array, *, odd: bool = False) -> tuple[Array, Array]:
    """Return a curve over positive abscissae together with its mirror image."""
    sign = -1.0 if odd else 1.0
    return np.concatenate([-along[::-1], along]), np.concatenate([sign * of[::-1], of])
