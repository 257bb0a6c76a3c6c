"""Elements of a picture: curves, points, areas, lines, text, maps; coordinates are SI numbers.

Text may contain LaTeX symbols between dollars.
"""

from __future__ import annotations

from typing import Any

from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.axis import PanelAxis
from winkler.values.value import value


@value
class Line:
    """A curve, or points.

    Parameters
    ----------
    x, y
        Coordinates [SI]; a curve is interrupted at NaN.
    colour, width, dash, alpha
        Of the curve; the colour is ``#rrggbb``, or a colour map and a position on it from 0 to 1; width zero: points
        alone. Dashes are lengths of strokes and gaps in line widths.
    marker, size, hollow
        Of the points, as matplotlib names them; empty for none.
    name
        In the legend; empty for none.
    order
        Drawing order: greater numbers are drawn later.
    clipped, beside, coarse
        Whether it is clipped at the frame; whether it belongs to the second upright axis; whether vector formats
        store it as pixels.
    edge, blunt
        Colour around points; whether the curve ends without round caps.
    error_x, error_y
        Lengths of error bars, below and above, ``(2, n)``; empty for none.
    error_colour, cap
        Of the error bars, and the width of their ends.
    """

    x: Array
    y: Array
    colour: str | tuple[str, float] = style.BLUE
    width: float = 1.8
    dash: tuple[float, ...] = ()
    alpha: float = 1.0
    marker: str = ""
    size: float = 5.0
    hollow: bool = False
    name: str = ""
    order: float = 2.0
    clipped: bool = True
    beside: bool = False
    coarse: bool = False
    edge: str = ""
    blunt: bool = False
    error_x: Array | None = None
    error_y: Array | None = None
    error_colour: str = ""
    cap: float = 0.0


@value
class Dots:
    """Points without lines; `size` is their area in square points."""

    x: Array
    y: Array
    colour: str = style.BLUE
    size: float = 12.0
    alpha: float = 1.0
    name: str = ""
    coarse: bool = False


@value
class Strokes:
    """Many short lines ``(n, points)``, each in its colour, width and opacity."""

    x: Array
    y: Array
    colours: tuple[str, ...]
    widths: Array
    alphas: Array
    order: float = 3.0


@value
class Area:
    """Shaded area between two curves over x; `across`: between two curves over y, given as x."""

    x: Array
    low: Any
    high: Any
    colour: str | tuple[str, float] = style.BLUE
    alpha: float = 0.14
    name: str = ""
    order: float = 1.0
    hatch: str = ""
    across: bool = False


@value
class Polygon:
    """A closed outline, filled."""

    x: Array
    y: Array
    colour: str | tuple[Any, ...] = style.BLUE
    alpha: float = 1.0
    edge: str | tuple[Any, ...] = ""
    width: float = 0.0
    order: float = 1.0


@value
class Rule:
    """A straight line through the whole panel: at a height, or `upright` at a place; through `point` with a slope."""

    at: float = 0.0
    upright: bool = False
    colour: str = style.MUTED
    width: float = 0.8
    dash: tuple[float, ...] = ()
    name: str = ""
    order: float = 2.0
    point: tuple[float, float] | None = None
    slope: float = 0.0


@value
class Band:
    """A shaded vertical band between two abscissae."""

    low: float
    high: float
    colour: str = style.GREEN
    alpha: float = 0.13
    name: str = ""


@value
class Text:
    """Text at a position [SI], or in parts of the frame where `framed` is true for that direction."""

    x: float
    y: float
    text: str
    across: str = "center"
    upright: str = "center"
    colour: str = style.INK
    size: float = 8.5
    boxed: float = 0.0
    pad: float = 1.5
    framed: tuple[bool, bool] = (False, False)
    order: float = 8.0
    turned: bool = False
    spacing: float = 1.2
    right: float = 0.0


@value
class Arrow:
    """An arrow between two points; `both`: with a head at either end."""

    start: tuple[float, float]
    stop: tuple[float, float]
    colour: str = style.RED
    width: float = 1.0
    both: bool = False
    order: float = 6.0
    clipped: bool = True


@value
class Bars:
    """Horizontal bars with their lengths and starts."""

    places: Array
    lengths: Array
    colour: str | tuple[str, ...] = style.BLUE
    thick: float = 0.62
    start: float = 0.0
    name: str = ""
    ends: Array | None = None


@value
class Map:
    """One quantity over a plane.

    Parameters
    ----------
    x, y
        Coordinates [SI]: of the points, ``(n, m)`` or ``(m,)`` and ``(n,)``; of cells their edges.
    z
        The quantity [SI], NaN where it is undefined.
    bar
        Label, unit, ends and scale of the colours.
    kind
        ``contours`` between levels, ``cells`` of one colour each, ``smooth``, ``pixels`` of an image.
    colours
        A colour map, or single colours for contours.
    levels
        Of the contours [SI]; one number: their approximate count.
    lines, line_width, line_alpha
        Of the contour lines.
    extend
        Ends of the colours that include all values beyond: ``min``, ``max``, ``both``, ``neither``.
    place
        Of the colour bar: ``inset`` beside the panel, ``beside``, or none.
    shrink, pad
        Height of the colour bar in that of the panel, and its distance.
    ground
        Colour where the quantity is undefined.
    centres
        x and y of the middles of cells, for lines between them.
    """

    x: Array
    y: Array
    z: Array
    bar: PanelAxis = PanelAxis()
    kind: str = "contours"
    colours: str | tuple[str, ...] = "viridis_r"
    levels: Any = 12
    alpha: float = 1.0
    line_colour: str = "white"
    line_width: float = 0.0
    line_alpha: float = 1.0
    lines: Any = ()
    extend: str = "neither"
    place: str = "beside"
    shrink: float = 1.0
    pad: float | None = None
    ground: str = ""
    centres: tuple[Any, ...] = ()


@value
class Vectors:
    """Arrows in a field: at (x, y) along (u, v)."""

    x: Array
    y: Array
    u: Array
    v: Array
    colour: str = style.INK


@value
class Facets:
    """Polygons ``(n, corners, 2)`` with colours ``(n, 3)``, drawn in order."""

    corners: Array
    colours: Array
    order: float = 2.0


Mark = Line | Dots | Strokes | Area | Polygon | Rule | Band | Text | Arrow | Bars | Map | Vectors | Facets
