"""The picture of the method: a row of springs under the equivalent plane profile."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from winkler.foundation.bed import Bed, Pressed
from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.extent import solid_until
from winkler.plot.medium import OFF_AXIS, is_varied
from winkler.plot.series import Scale, Series, places, scale_of, series

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["at_first_touch", "draw_ground", "draw_springs", "plane_profile", "stretched"]

COILS = 9
SPRINGS = 33
"""How many springs are drawn; the method itself has no such number."""
SEEN = 1e-6
"""Part of the greatest displacement below which a spring is neither pressed nor stretched, but rounded."""


def plane_profile(bed: Bed, end: float) -> tuple[Series, Series]:
    """Return x and g(x) from the axis to `end` [m], or to where the bed is known.

    Parameters
    ----------
    bed : Bed
    end : float
        [m].
    """
    end = min(end, solid_until(bed))
    inner = places(end, tuple(b for b, _ in bed.kinks))
    x = np.concatenate([[0.0], inner, [end]])
    g = np.asarray(bed.gap(x), dtype=float)
    known = np.isfinite(g)
    return series("Foundation", "x", x[known]), series("Foundation", "gap", g[known])


def draw_springs(axes: Axes, pressed: Pressed, extent: float) -> None:
    """Draw the springs, compressed where the plane profile has come down on them.

    Parameters
    ----------
    axes : Axes
        Empty.
    pressed : Pressed
        Bed, depth and contact radius; depth zero shows the bed at first touch.
    extent : float
        Drawn up to this x on both sides [m].
    """
    from matplotlib.ticker import MaxNLocator

    x, g = plane_profile(pressed.bed, extent)
    across = scale_of("m", [extent])
    drop = max(pressed.depth, 0.0)
    pull = _pull(pressed)
    moved = max(drop, pull)
    rise = float(np.max(g.content)) if g.content.size else 0.0
    unit = max(moved, 0.45 * min(rise, 4.0 * moved) if moved > 0.0 else rise, 1e-3 * extent if rise == 0.0 else 0.0)
    bottom = (-2.3 if moved > 0.0 else -1.2) * unit
    top = min(1.05 * max(rise - pressed.depth, 0.0), 2.2 * unit) + (0.55 * unit if rise <= drop else 0.0)
    upright = scale_of("m", [unit])
    if _uneven(pressed.bed, extent):
        style.note(axes, "thicker springs are stiffer", where="upper left")
    if pull > 0.0:
        style.note(axes, "blue springs pull", where="lower left")
    draw_ground(axes, extent / across.factor, bottom / upright.factor, 0.16 * unit / upright.factor)
    _coils(axes, pressed, extent, bottom, across, upright)
    _profile(axes, pressed, (x.content, g.content), top, across, upright)
    axes.axhline(0.0, color=style.MUTED, linewidth=0.8, linestyle=(0, (4, 3)), zorder=1)
    if pressed.radius > 0.0:
        _dimensions(axes, pressed, across, upright, bottom)
    axes.set_xlim(-extent / across.factor, extent / across.factor)
    axes.set_ylim((bottom - 0.16 * unit) / upright.factor, top / upright.factor)
    axes.set_xlabel(x.label(across))
    axes.set_ylabel(f"height [{upright.unit}]")
    ticks = MaxNLocator(5, steps=[1, 2, 2.5, 5, 10]).tick_values(-drop / upright.factor, top / upright.factor)
    axes.set_yticks([tick for tick in ticks if -1.02 * drop <= tick * upright.factor <= top])
    axes.grid(visible=False)


def _pull(pressed: Pressed) -> float:
    """Return how far springs are stretched at most [m]; zero where none is by more than rounding."""
    if pressed.radius == 0.0:
        return 0.0
    x = np.append(places(pressed.radius, (*(b for b, _ in pressed.kinks), pressed.touching)), pressed.radius)
    moved = np.asarray(pressed.value(x))
    return -float(np.min(moved)) if np.any(stretched(moved)) else 0.0


def stretched(moved: Array) -> Array:
    """Return which springs pull: those that are stretched by more than rounding beside the one that moves most.

    Parameters
    ----------
    moved : ndarray
        How far springs are pressed [m], negative where they are stretched.
    """
    return np.asarray(moved < -SEEN * float(np.max(np.abs(moved))))


def draw_ground(axes: Axes, end: float, top: float, thick: float) -> None:
    """Draw what the springs stand on, in the units of the axes."""
    axes.fill_between(
        [-end, end],
        [top, top],
        [top - thick, top - thick],
        facecolor=style.SOLID,
        edgecolor=style.MUTED,
        linewidth=0.0,
        hatch="////",
        zorder=1,
    )
    axes.plot([-end, end], [top, top], color=style.INK, linewidth=1.0, zorder=2)


def _coils(axes: Axes, pressed: Pressed, extent: float, bottom: float, across: Scale, upright: Scale) -> None:
    """Draw zigzags from the ground to where the profile, or the free surface, is."""
    from matplotlib.collections import LineCollection

    step = 2.0 * extent / SPRINGS
    x = (np.arange(SPRINGS) - 0.5 * (SPRINGS - 1)) * step
    place = np.abs(x)
    touched = (place <= pressed.radius) & (pressed.radius > 0.0)
    squeezed = np.zeros(x.shape)
    squeezed[touched] = pressed.value(place[touched])
    most = max(float(np.max(np.abs(squeezed))), 1e-300)
    pulls = stretched(squeezed)
    for one, sunk, hit, pull, thick in zip(x, squeezed, touched, pulls, _thickness(pressed.bed, place), strict=True):
        height = -sunk - bottom
        rungs = np.concatenate([[0.0, 0.1], 0.1 + 0.8 * (np.arange(2 * COILS) + 0.5) / (2 * COILS), [0.9, 1.0]])
        side = np.concatenate([[0.0, 0.0], np.where(np.arange(2 * COILS) % 2 == 0, 1.0, -1.0), [0.0, 0.0]])
        line = np.stack(
            [(one + 0.32 * step * side) / across.factor, (bottom + rungs * height) / upright.factor], axis=-1
        )
        colour = (style.BLUE if pull else style.RED) if hit else style.MUTED
        strength = 0.55 + 0.45 * abs(sunk) / most if hit else 0.55
        axes.add_collection(LineCollection([line], colors=colour, linewidths=thick, alpha=strength, zorder=3))


def _thickness(bed: Bed, place: Array) -> Array:
    """Return how thick springs are drawn: all alike, or by their stiffness where it varies."""
    beside = np.clip(place, OFF_AXIS * np.max(place), bed.reach)
    stiffness = np.asarray(bed.normal_stiffness(beside), dtype=float)
    if not is_varied(stiffness):
        return np.ones(place.shape)
    rest = np.max(np.delete(stiffness, np.argmin(place)))  # that in the middle may be without bounds
    return np.asarray(0.45 + 1.35 * np.minimum(stiffness / rest, 1.0))


def _uneven(bed: Bed, extent: float) -> bool:
    return is_varied(np.asarray(bed.normal_stiffness(min(extent, bed.reach) * np.linspace(0.1, 1.0, 9)), dtype=float))


def _profile(
    axes: Axes, pressed: Pressed, outline: tuple[Array, Array], top: float, across: Scale, upright: Scale
) -> None:
    x, g = outline
    lower = g - pressed.depth
    keep = lower <= top
    if not keep.all():
        last = int(np.argmin(keep))
        crossing = np.interp(top, lower[last - 1 : last + 1], x[last - 1 : last + 1])
        x, lower = np.append(x[:last], crossing), np.append(lower[:last], top)
    elif pressed.bed.rim <= x[-1] * (1.0 + 1e-12):
        x, lower = np.append(x, x[-1]), np.append(lower, top)
    both, line = style.mirrored(x / across.factor, lower / upright.factor)
    axes.fill_between(both, line, np.full(both.shape, top / upright.factor), facecolor=style.BODY, alpha=0.75, zorder=4)
    axes.plot(both, line, color=style.BLUE, linewidth=2.0, zorder=5, label="g(x) − d")


def _dimensions(axes: Axes, pressed: Pressed, across: Scale, upright: Scale, bottom: float) -> None:
    """Mark the contact radius, that of a ring which is pulled, and the depth."""
    a, d = pressed.touching / across.factor, pressed.depth / upright.factor
    outer = pressed.radius / across.factor
    level = 0.86 * bottom / upright.factor
    edge = -float(pressed.edge) / upright.factor
    for side in (-outer, outer):
        axes.plot(
            [side, side], [edge, bottom / upright.factor], color=style.INK, linewidth=0.8, linestyle=":", zorder=6
        )
    arrow = {"arrowstyle": "<->", "color": style.INK, "linewidth": 0.9, "shrinkA": 0, "shrinkB": 0}
    axes.annotate("", (a, level), (0.0, level), arrowprops=arrow, zorder=7)
    box = {"facecolor": "white", "edgecolor": "none", "alpha": 0.85, "pad": 1.2}
    axes.text(0.5 * a, level, "$a$", ha="center", va="center", bbox=box, zorder=8)
    if a < outer:  # a ring around the contact is pulled
        axes.annotate("", (-outer, level), (0.0, level), arrowprops=arrow, zorder=7)
        axes.text(-0.5 * outer, level, "$c$", ha="center", va="center", bbox=box, zorder=8)
    axes.annotate("", (0.0, -d), (0.0, 0.0), arrowprops=arrow, zorder=7)
    axes.text(0.05 * a, -0.45 * d, "$d$", ha="left", va="center", zorder=8)


def at_first_touch(bed: Bed) -> Pressed:
    """Return a bed on which nothing is pressed yet."""
    return Pressed(bed, 0.0, 0.0)
