"""Picture of the residuals of a fit in units of the noise, and of their spectrum."""

from __future__ import annotations

import numpy as np

from winkler.fitting.compare import AnyFit
from winkler.plot import style
from winkler.plot.panel import Line, Panel, PanelAxis, Rule, Sheet
from winkler.plot.series import Scale, Series
from winkler.values.vocabulary import Word

FEWEST_SPECTRAL, BIN_RATIO = 8, 1.15
MOST_UNEVEN = 0.01
"""Most difference of the times between points, over their mean, for frequencies in Hz."""


def noise_sheet(fit: AnyFit) -> Sheet:
    """Return residuals over their noise point by point, and their power over the frequency.

    Parameters
    ----------
    fit : Fit, ViscoelasticFit or CreepFit
        The power is the squared cosine transform of the residuals over the variance of the noise, as a mean of
        neighbouring frequencies; of white noise it is 1.
    """
    counted = fit.weights > 0.0
    ratio = np.where(counted, fit.residuals * fit.weights / max(fit.noise, np.finfo(float).tiny), np.nan)
    along = Series("point", Word("i", "", "point, in the order of measurement"), np.arange(ratio.size, dtype=float))
    left = Series("residual over noise", Word(r"r/\sigma", "", "residual over noise"), ratio)
    dots = Line(along.content, ratio, style.BLUE, width=0.0, marker="o", size=1.5)
    rules = (Rule(0.0, colour=style.INK), *(Rule(level, dash=style.DASHED) for level in (-2.0, 2.0)))
    residuals = Panel((dots, *rules), PanelAxis.of(along, margin=0.02), PanelAxis.of(left))
    return Sheet((residuals, _spectrum(ratio[counted], _interval(fit, counted))), width=3.6, height=2.4)


def _interval(fit: AnyFit, counted: np.ndarray) -> float:
    """Return the time between two points [s]; zero if the curve has none, or its points are not evenly spaced."""
    steps = np.diff(fit.curve.time[counted]) if fit.curve.timed else np.zeros(0)
    if steps.size == 0 or not np.ptp(steps) <= MOST_UNEVEN * np.mean(steps):
        return 0.0
    return float(np.mean(steps))


def _spectrum(ratio: np.ndarray, interval: float) -> Panel:
    from scipy.fft import dct

    power = dct(ratio, type=2, norm="ortho")[1:] ** 2
    frequency = 0.5 * np.arange(1, ratio.size) / ratio.size
    edges = np.unique(np.concatenate([np.arange(FEWEST_SPECTRAL), _geometric(power.size)]).astype(int))
    starts = edges[edges < power.size]
    sizes = np.diff(np.append(starts, power.size))
    mean, middle = np.add.reduceat(power, starts) / sizes, np.add.reduceat(frequency, starts) / sizes
    per_second = Series("frequency", Word("f", "Hz", "frequency"), middle / (interval or 1.0))
    per_point = PanelAxis("frequency $f$", Scale(1.0, "cycles per point"), log=True)
    across = PanelAxis.of(per_second, log=True) if interval else per_point
    upright = Series("power", Word(r"S/\sigma^2", "", "power over that of white noise"), mean)
    line = Line(per_second.content, np.maximum(mean, 1e-12), style.BLUE, width=1.2, marker="o", size=2.0)
    return Panel(
        (line, Rule(1.0, colour=style.INK)),
        across,
        PanelAxis.of(upright, log=True),
    )


def _geometric(count: int) -> np.ndarray:
    first = min(FEWEST_SPECTRAL, count)
    return np.geomspace(first, count, max(2, 1 + int(np.log(count / first) / np.log(BIN_RATIO))))
