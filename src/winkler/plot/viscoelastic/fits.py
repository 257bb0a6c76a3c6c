"""Pictures of fits of relaxing contacts: the curve over time and over depth, what is left over, and the relaxation."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from winkler.fitting.outcome import CreepFit, ViscoelasticFit
from winkler.fitting.viscoelastic.band import relaxation_band, watched
from winkler.media.relaxing.viscoelastic import ViscoelasticHalfSpace
from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.draw import draw
from winkler.plot.series import Series, common_scale, middle_scale
from winkler.plot.viscoelastic.contacts import refuse_extent
from winkler.vocabulary import Word

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from winkler.plot.picture import Picture

__all__ = ["relaxing_fit_sheet"]

DENSE = 400
BEYOND = 3.0
"""The relaxation is shown this much beyond what was watched, at either side."""
NARROW = 1e3
"""A modulus whose interval is wider than this is not told, and not drawn."""
WAYS = ((1.0, style.BLUE, "going in"), (0.0, style.ORANGE, "held"), (-1.0, style.GREEN, "coming out"))


@draw.register(ViscoelasticFit)
@draw.register(CreepFit)
def relaxing_fit_sheet(item: ViscoelasticFit | CreepFit, *, extent: float | None = None) -> Picture:
    """Return the fitted quantity over time with residuals, force over depth, and the relaxation with its interval."""
    refuse_extent(item, extent)
    creep = isinstance(item, CreepFit)
    since = item.curve.time - item.curve.time[0]
    time = Series("time", Word("t", "s", "time"), since)
    if creep:
        origin = item.value("contact_point") if "contact_point" in item.names else 0.0
        name, symbol = "position from first touch", "D - D_0"
        measured = Series(name, Word(symbol, "m", name), item.curve.position - origin)
        model = Series(name, measured.word, item.predicted - origin)
    else:
        measured = Series("force", Word("F_N", "N", "force"), item.curve.force)
        model = Series("force", measured.word, item.predicted)
    fitted = item.weights > 0.0
    left = Series("residual", Word("", measured.word.unit, "measured less fitted"), item.residuals * fitted)
    shown = item.radius > 0.0 if creep else np.ones(fitted.size, dtype=bool)  # a free tip may be anywhere
    with style.styled():
        figure = style.figure(width=8.6, height=5.0)
        grid = figure.add_gridspec(2, 2, height_ratios=(2.6, 1.0), width_ratios=(1.35, 1.0))
        above = figure.add_subplot(grid[0, 0])
        below = figure.add_subplot(grid[1, 0], sharex=above)
        across, upright = time.scale, common_scale(_of(measured, shown), _of(model, shown))
        _dots(above, item, time.shown(across), measured.shown(upright), shown)
        _dots(below, item, time.shown(across), left.shown(), fitted, labels=False)
        line = np.where(shown, model.shown(upright), np.nan)
        above.plot(time.shown(across), line, color=style.RED, lw=1.3, label="fitted")
        below.axhline(0.0, color=style.INK, lw=0.8)
        above.set_ylabel(measured.label(upright))
        above.tick_params(labelbottom=False)
        below.set_xlabel(time.label(across))
        below.set_ylabel(left.label())
        above.margins(x=0.02, y=0.06)
        style.framed_legend(above, loc="best", markerscale=2.0)
        inner = grid[:, 1].subgridspec(2, 1)
        _loop(figure.add_subplot(inner[0]), item, shown)
        _relaxation(figure.add_subplot(inner[1]), item)
        figure.align_ylabels([above, below])
    return figure


def _of(one: Series, which: Array) -> Series:
    return Series(one.name, one.word, one.content[which])


def _dots(
    axes: Axes, item: ViscoelasticFit | CreepFit, x: Array, y: Array, which: Array, *, labels: bool = True
) -> None:
    """Draw measured points in the colour of their way."""
    size = 4.0 if item.curve.count > DENSE else 12.0
    for way, colour, word in WAYS:
        mine = (item.curve.direction == way) & which
        if mine.any():
            axes.scatter(
                x[mine],
                y[mine],
                s=size,
                color=colour,
                alpha=0.45,
                linewidths=0.0,
                rasterized=item.curve.count > DENSE,
                label=f"measured, {word}" if labels else None,
            )


def _loop(axes: Axes, item: ViscoelasticFit | CreepFit, which: Array) -> None:
    """Draw the force of the contact over the depth."""
    creep = isinstance(item, CreepFit)
    borne = item.curve.force - _outside(item)
    force = Series("force", Word("F_N", "N", "force"), borne if creep else item.curve.force)
    origin = item.value("contact_point") if "contact_point" in item.names else 0.0
    gone = item.curve.compliance * borne
    deep = Series("depth", Word("d", "m", "depth"), item.curve.position - origin - gone)
    model = Series("force", force.word, item.model.path.across if creep else item.predicted)
    near = which & (item.depth > -0.3 * float(item.depth.max()))
    scale, upright = _of(deep, near).scale, common_scale(_of(force, near), _of(model, near))
    _dots(axes, item, deep.shown(scale), force.shown(upright), near, labels=False)
    along = Series("depth", deep.word, np.where(near, item.depth, np.nan))
    axes.plot(along.shown(scale), np.where(near, model.shown(upright), np.nan), color=style.RED, lw=1.2)
    axes.set_xlabel(deep.label(scale))
    axes.set_ylabel(force.label(upright))
    axes.margins(x=0.03, y=0.06)


def _outside(item: ViscoelasticFit | CreepFit) -> Array:
    """Return the part of the force that the contact does not bear, as far as it is one number [N]."""
    return np.full(item.curve.count, item.value("baseline") if "baseline" in item.names else 0.0)


def _relaxation(axes: Axes, item: ViscoelasticFit | CreepFit) -> None:
    """Draw E*(t) with its interval, what lies outside of the time that was watched in grey, and the single terms."""
    shortest, longest = watched(item)
    t = np.geomspace(shortest / BEYOND, longest * BEYOND, 160)
    band = relaxation_band(item, t)
    time = Series("time", Word("t", "s", "time"), t)
    half_space = isinstance(item.model.bed.medium, ViscoelasticHalfSpace)
    symbol, unit = ("E^*(t)", "Pa") if half_space else (r"\varphi(t)", "")
    modulus = Series("relaxation", Word(symbol, unit, "relaxation of the contact"), band.modulus)
    across, upright = time.scale, middle_scale(unit, band.modulus)
    x, told = time.shown(across), band.high < NARROW * band.low
    axes.fill_between(
        x[told], band.low[told] / upright.factor, band.high[told] / upright.factor, color=style.BLUE, alpha=0.25, lw=0.0
    )
    axes.plot(x, modulus.shown(upright), color=style.BLUE, label=f"${symbol}$, 95 %")
    for low, high in ((t[0], shortest), (longest, t[-1])):
        axes.axvspan(low / across.factor, high / across.factor, color=style.MUTED, alpha=0.15, lw=0.0)
    _terms(axes, item, across.factor, upright.factor)
    axes.set_xscale("log")
    axes.set_ylim(bottom=0.0)
    axes.margins(x=0.0)
    axes.set_xlabel(time.label(across))
    axes.set_ylabel(modulus.label(upright))
    style.framed_legend(axes, loc="best")


def _terms(axes: Axes, item: ViscoelasticFit | CreepFit, second: float, pascal: float) -> None:
    """Draw the fitted terms: modulus over relaxation time, with both intervals."""
    lead = "bed.medium.first."
    pairs = [(f"{lead}shears[{i}]", f"{lead}relaxation_times[{i}]") for i in range(len(item.names))]
    pairs = [pair for pair in [*pairs, (f"{lead}shear", f"{lead}relaxation_time")] if set(pair) <= set(item.names)]
    poisson = getattr(getattr(item.model.bed.medium, "first", None), "poisson", 0.5)
    contact = 2.0 / (1.0 - poisson) / pascal
    for number, (shear, time) in enumerate(pairs):
        (low, high), (early, late) = item.interval(shear), item.interval(time)
        middle, at = item.value(shear), item.value(time)
        if high > NARROW * low or late > NARROW * early:
            continue
        axes.errorbar(
            at / second,
            middle * contact,
            xerr=[[(at - early) / second], [(late - at) / second]],
            yerr=[[(middle - low) * contact], [(high - middle) * contact]],
            fmt="o",
            ms=4.0,
            lw=1.2,
            color=style.RED,
            label=r"terms $2G_i/(1-\nu)$ at $\tau_i$" if number == 0 else None,
        )
