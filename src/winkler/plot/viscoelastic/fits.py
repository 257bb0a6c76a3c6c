"""Pictures of fits of relaxing contacts: the curve over time and over depth, residuals, and the relaxation."""

from __future__ import annotations

from typing import Any

import numpy as np

from winkler.fitting.outcome import AnyFit, CreepFit, ViscoelasticFit
from winkler.fitting.viscoelastic.band import observed_times, relaxation_band
from winkler.media.relaxing.layered import ViscoelasticCoatedHalfSpace
from winkler.media.relaxing.viscoelastic import ViscoelasticHalfSpace
from winkler.numerics.types import Array
from winkler.plot import style
from winkler.plot.dispatch import without_extent
from winkler.plot.fitting.fits import fit_panels, measured_dots, origin_of
from winkler.plot.panel import Area, Band, Line, Panel, PanelAxis, Sheet
from winkler.plot.series import Series, common_scale, middle_scale
from winkler.values.vocabulary import Word

TIME_FACTOR_BEYOND = 3.0
"""Factor by which the drawn times extend beyond the observed ones."""
WIDEST_INTERVAL_RATIO = 1e3
"""Intervals with a greater ratio of their ends are not drawn."""


@without_extent(ViscoelasticFit, CreepFit)
def relaxing_fit_sheet(item: ViscoelasticFit | CreepFit) -> Sheet:
    """Return the fitted quantity over time with residuals, force over depth, and the relaxation with its interval."""
    left = Sheet(fit_panels(item), 1, heights=(2.6, 1.0), shared="x")
    right = Sheet((relaxing_loop(item), _relaxation(item)), 1)
    return Sheet((left, right), width=4.3, height=5.0, widths=(1.35, 1.0))


def _of(one: Series, which: Array) -> Series:
    return Series(one.name, one.word, one.content[which])


def relaxing_loop(item: AnyFit, some: Array | None = None) -> Panel:
    """Return the force of the contact over the depth, as measured and as fitted.

    Parameters
    ----------
    item
        A fit.
    some : ndarray, optional
        Indices of the drawn points; all if left out.
    """
    creep = isinstance(item, CreepFit)
    borne = item.curve.force - _constant_force(item)
    force = Series("force", Word("F_N", "N", "force"), borne if creep else item.curve.force)
    deflection = item.curve.compliance * borne
    deep = Series("depth", Word("d", "m", "depth"), item.curve.position - origin_of(item) - deflection)
    model = Series("force", force.word, item.model.path.across if isinstance(item, CreepFit) else item.predicted)
    near = item.depth > -0.3 * float(item.depth.max())
    near &= item.radius > 0.0 if creep else True  # the depth of a free tip is arbitrary
    drawn = np.arange(near.size) if some is None else some
    measured = (part[drawn] for part in (deep.content, force.content, item.curve.direction, near))
    marks: list[Any] = measured_dots(item, *measured, named=False)
    x, y = (np.where(near, part, np.nan)[drawn] for part in (item.depth, model.content))
    marks.append(Line(x, y, style.RED, width=1.2))
    across = PanelAxis.of(deep, _of(deep, near).scale, margin=0.03)
    return Panel(
        tuple(marks), across, PanelAxis.of(force, common_scale(_of(force, near), _of(model, near)), margin=0.06)
    )


def _constant_force(item: AnyFit) -> Array:
    """Return the constant part of the force that the contact does not bear [N]."""
    return np.full(item.curve.count, item.value("baseline") if "baseline" in item.names else 0.0)


def _relaxation(item: ViscoelasticFit | CreepFit) -> Panel:
    """Return E*(t) with its interval, times outside the observed range in grey, and the single terms."""
    shortest, longest = observed_times(item)
    t = np.geomspace(shortest / TIME_FACTOR_BEYOND, longest * TIME_FACTOR_BEYOND, 160)
    band = relaxation_band(item, t)
    layered = isinstance(item.model.bed.medium, ViscoelasticCoatedHalfSpace)
    of_moduli = layered or isinstance(item.model.bed.medium, ViscoelasticHalfSpace)
    symbol, unit = ("E^*(t)", "Pa") if of_moduli else (r"\varphi(t)", "")
    time = Series("time", Word("t", "s", "time"), t)
    whose = "fitted solid" if layered else "contact"
    modulus = Series("relaxation", Word(symbol, unit, f"relaxation of the {whose}"), band.modulus)
    narrow = band.high < WIDEST_INTERVAL_RATIO * band.low
    marks = (
        Area(t[narrow], band.low[narrow], band.high[narrow], alpha=0.25),
        Line(t, band.modulus, name=f"${symbol}$, 95 %"),
        *(Band(low, high, style.MUTED, 0.15) for low, high in ((t[0], shortest), (longest, t[-1]))),
        *_terms(item),
    )
    upright = PanelAxis.of(modulus, middle_scale(unit, band.modulus), low=0.0)
    return Panel(marks, PanelAxis.of(time, log=True, margin=0.0), upright, legend="best")


def _terms(item: ViscoelasticFit | CreepFit) -> list[Line]:
    """Return the fitted terms: modulus over relaxation time, with both intervals."""
    own = [name.rpartition(".")[0] for name in item.names if name.startswith("bed.medium.")]
    lead = f"{own[0]}." if own else ""
    pairs = [(f"{lead}shears[{i}]", f"{lead}relaxation_times[{i}]") for i in range(len(item.names))]
    pairs = [pair for pair in [*pairs, (f"{lead}shear", f"{lead}relaxation_time")] if set(pair) <= set(item.names)]
    medium = item.model.bed.medium
    solid = getattr(medium, "first", None)
    if isinstance(medium, ViscoelasticCoatedHalfSpace):
        solid = medium.relaxing_solids[0]
    poisson = getattr(solid, "poisson", 0.5)
    contact = 2.0 / (1.0 - poisson)
    lines = []
    for number, (shear, time) in enumerate(pairs):
        (low, high), (early, late) = item.interval(shear), item.interval(time)
        middle, at = item.value(shear), item.value(time)
        if high > WIDEST_INTERVAL_RATIO * low or late > WIDEST_INTERVAL_RATIO * early:
            continue
        term = Line(
            np.array([at]),
            np.array([middle * contact]),
            style.RED,
            width=1.2,
            marker="o",
            size=4.0,
            name="" if number else r"terms $2G_i/(1-\nu)$ at $\tau_i$",
            error_x=np.array([[at - early], [late - at]]),
            error_y=contact * np.array([[middle - low], [high - middle]]),
        )
        lines.append(term)
    return lines
