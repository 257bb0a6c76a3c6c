"""Sheets of what stands beside the boundary elements: rough lines, nearly round and elliptic contacts, rubber."""

from __future__ import annotations

import math
from typing import TYPE_CHECKING, Any

import numpy as np

from winkler.plot import style
from winkler.plot.draw import draw
from winkler.plot.rough.roughness import Band, draw_map, draw_models, draw_spectrum
from winkler.plot.series import scale_of, series, told
from winkler.plot.viscoelastic.contacts import refuse_extent
from winkler.problems.normal.elliptic import EllipticSolution
from winkler.problems.normal.near_round import NearlyRoundSolution
from winkler.problems.rough.elastomer_friction import ElastomerFrictionSolution
from winkler.problems.rough.line_contact import RoughContactSolution
from winkler.problems.rough.line_indentation import RoughIndentationSolution
from winkler.profiles.rough.topography import Topography

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from winkler.numerics.types import Array
    from winkler.plot.picture import Picture
    from winkler.plot.series import Series

__all__ = ["contour_sheet", "elastomer_sheet", "ellipse_sheet", "lines_sheet"]

PIXELS = 201
MOST = 6
"""Contours shown."""
TURNS = 256
"""Directions in which they are drawn."""


def _flat(item: Any, name: str) -> Series:
    return series(type(item), name, np.ravel(np.asarray(getattr(item, name), dtype=float)))


def _banded(item: Any, name: str) -> Band:
    low, high = np.asarray(getattr(item, f"{name}_band"), dtype=float).reshape(2, -1)
    return Band(low, high, "eight lines of ten", style.BLUE)


@draw.register(RoughContactSolution)
@draw.register(RoughIndentationSolution)
def lines_sheet(item: RoughContactSolution | RoughIndentationSolution, *, extent: float | None = None) -> Picture:
    """Return the spectrum, and depth, stiffness and true area over the force, with bands."""
    refuse_extent(item, extent)
    count = np.size(item.force)
    with style.styled():
        figure = style.figure(2, 2, width=4.4, height=3.1)
        panels = figure.subplots(2, 2).ravel()
        draw_spectrum(panels[0], [(item.problem.spectrum, "")])
        panels[0].set_title("power spectrum")
        force = _flat(item, "force")
        smooth = isinstance(item, RoughIndentationSolution)
        area = [(_flat(item, "area"), "Persson")]
        if count < 2:
            _draw_one(panels[1:], item)
            return figure
        draw_models(panels[1], force, [(_flat(item, "depth"), "median")], [_banded(item, "depth")])
        stiffness = [(_flat(item, "stiffness"), "median")]
        stiffness += [(_flat(item, "smooth_stiffness"), "smooth body")] if smooth else []
        draw_models(panels[2], force, stiffness, [_banded(item, "stiffness")])
        draw_models(panels[3], force, area)
        for axes, title in zip(panels[1:], ("depth", "stiffness", "true contact area"), strict=True):
            axes.set_title(f"{title} over force")
    return figure


def _draw_one(panels: Any, item: Any) -> None:
    """Write the numbers of a single load."""
    for axes, name in zip(panels, ("depth", "stiffness", "area"), strict=True):
        of = _flat(item, name)
        low, high = (
            (float(part.ravel()[0]) for part in np.asarray(getattr(item, f"{name}_band")))
            if hasattr(item, f"{name}_band")
            else (of.content[0], of.content[0])
        )
        middle = float(of.content[0])
        factor = of.scale.factor
        axes.errorbar(
            [0.0],
            [middle / factor],
            yerr=[[(middle - low) / factor], [(high - middle) / factor]],
            fmt="o",
            color=style.BLUE,
            capsize=6.0,
        )
        axes.set_ylim(0.0, 1.3 * max(high, middle) / factor)
        axes.set_xlim(-1.0, 1.0)
        axes.set_xticks([])
        axes.set_ylabel(of.label())
        axes.set_title(f"{name} under {told(float(np.ravel(item.force)[0]), 'N')}")


def _rounded(contour: Array) -> Array:
    """Return a contour in many directions, by the harmonics of the given ones."""
    if contour.size >= TURNS:
        return contour
    waves = np.fft.rfft(contour)
    if contour.size % 2 == 0:
        waves[-1] *= 0.5
    return np.asarray(np.fft.irfft(waves, TURNS) * TURNS / contour.size)


@draw.register(NearlyRoundSolution)
def contour_sheet(item: NearlyRoundSolution, *, extent: float | None = None) -> Picture:
    """Return the contour of the contact, and the force over the depth."""
    refuse_extent(item, extent)
    contours = np.reshape(item.contour, (-1, np.shape(item.contour)[-1]))
    shown = contours[np.unique(np.linspace(0, len(contours) - 1, min(MOST, len(contours))).astype(int))]
    with style.styled():
        many = len(contours) > 1
        figure = style.figure(2 if many else 1, width=4.4, height=3.6)
        panels = figure.subplots(1, 2 if many else 1, squeeze=False)[0]
        scale = scale_of("m", shown)
        for place, contour in enumerate(shown):
            colour = style.shades()(0.25 + 0.7 * (place + 1) / len(shown))
            for radii, mark in ((_rounded(contour), "-"), (contour, "o" if contour.size <= TURNS // 8 else "")):
                turns = np.linspace(0.0, 2.0 * math.pi, radii.size, endpoint=False)
                x, y = radii * np.cos(turns) / scale.factor, radii * np.sin(turns) / scale.factor
                if mark == "-":
                    panels[0].plot(np.append(x, x[0]), np.append(y, y[0]), color=colour)
                elif mark:
                    panels[0].plot(x, y, mark, color=colour, markersize=3.5)
        panels[0].set_aspect("equal")
        panels[0].margins(0.08)
        panels[0].set_xlabel(f"$x$ [{scale.unit}]")
        panels[0].set_ylabel(f"$y$ [{scale.unit}]")
        panels[0].set_title("contour of the contact")
        if many:
            draw_models(panels[1], _flat(item, "depth"), [(_flat(item, "force"), "")])
            panels[1].set_title("force over depth")
    return figure


@draw.register(EllipticSolution)
def ellipse_sheet(item: EllipticSolution, *, extent: float | None = None) -> Picture:
    """Return the pressure over the ellipse; of many loads force and semi-axes over the depth."""
    refuse_extent(item, extent)
    with style.styled():
        if np.ndim(item.depth) == 0:
            figure = style.figure(width=4.8, height=3.4)
            _draw_ellipse(figure.subplots(), item)
            figure.suptitle(f"{told(float(item.force), 'N')} at a depth of {told(float(item.depth), 'm')}")
            return figure
        figure = style.figure(2, height=3.2)
        left, right = figure.subplots(1, 2)
        depth = _flat(item, "depth")
        draw_models(left, depth, [(_flat(item, "force"), "")])
        left.set_title("force over depth")
        axes_of = [
            (_flat(item, f"{way}_semi_axis"), f"${axis}$") for way, axis in (("longitudinal", "a"), ("lateral", "b"))
        ]
        draw_models(right, depth, axes_of, label="semi-axes")
        right.set_title("semi-axes over depth")
    return figure


def _draw_ellipse(axes: Axes, item: EllipticSolution) -> None:
    wide = 1.2 * max(float(item.longitudinal_semi_axis), float(item.lateral_semi_axis))
    step = 2.0 * wide / PIXELS
    x = (np.arange(PIXELS) + 0.5) * step - wide
    pressure = item.pressure(x[:, None], x[None, :])
    shown = series("SurfaceFields", "pressure", np.where(pressure > 0.0, pressure, np.nan))
    square = Topography(np.zeros((PIXELS, PIXELS)), np.array([2.0 * wide, 2.0 * wide]))
    draw_map(axes, square, shown, style.shades())
    edge = wide / scale_of("m", square.lengths).factor
    axes.images[0].set_extent((-edge, edge, -edge, edge))
    axes.set_title("pressure over the ellipse")


@draw.register(ElastomerFrictionSolution)
def elastomer_sheet(item: ElastomerFrictionSolution, *, extent: float | None = None) -> Picture:
    """Return the coefficient of friction over the velocity, and the spectrum behind it."""
    refuse_extent(item, extent)
    with style.styled():
        figure = style.figure(2, height=3.2)
        left, right = figure.subplots(1, 2)
        velocity = series("ElastomerFriction", "velocity", np.ravel(item.problem.velocity))
        draw_models(left, velocity, [(_flat(item, "coefficient"), "")])
        left.set_title("friction over velocity: a trend")
        draw_spectrum(right, [(item.problem.spectrum, "")])
        right.set_title("power spectrum of the surface")
    return figure
