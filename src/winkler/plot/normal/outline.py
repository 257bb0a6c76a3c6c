"""The outline of a shape: its height f(r), what becomes of it in the row of springs, g(x), and what was measured."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from winkler.plot import style
from winkler.plot.extent import solid_until
from winkler.plot.series import places, scale_of
from winkler.profiles.measured import Measured
from winkler.profiles.profile import Profile

if TYPE_CHECKING:
    from matplotlib.axes import Axes

__all__ = ["draw_profile"]


def draw_profile(axes: Axes, profile: Profile, extent: float) -> None:
    """Draw f(r) and g(x) of a shape, and the points of a measured one.

    Parameters
    ----------
    axes : Axes
        Empty.
    profile : Profile
    extent : float
        Drawn up to this distance [m].
    """
    end = min(extent, solid_until(profile))
    r = np.concatenate([[0.0], places(end, tuple(b for b, _ in profile.kinks)), [end]])
    f, g = (np.asarray(part, dtype=float) for part in (profile.height(r), profile.gap(r)))
    g = np.where(np.isfinite(g), g, np.nan)
    top = 1.25 * max(float(np.max(f)), min(float(np.nanmax(g)), 2.2 * float(np.max(f)))) or 0.3 * extent
    wall = profile.rim <= end
    f_r, g_x, f, g = (
        np.append(r, r[-1]),
        np.append(r, r[-1]),
        np.append(f, top if wall else f[-1]),
        np.append(g, g[-1]),
    )
    across, upright = scale_of("m", [extent]), scale_of("m", [top])
    if isinstance(profile, Measured):
        points = profile.heights - profile.curve.derivatives[0, 0]
        axes.plot(
            profile.radii / across.factor,
            points / upright.factor,
            ".",
            color=style.ORANGE,
            markersize=2.5,
            zorder=4,
            label=f"{profile.radii.size} measured points",
            rasterized=profile.radii.size > 2000,
        )
    axes.plot(f_r / across.factor, f / upright.factor, color=style.INK, label="shape $f(r)$")
    axes.plot(
        g_x / across.factor,
        g / upright.factor,
        color=style.BLUE,
        linestyle=style.DASHES[1],
        label="equivalent profile $g(x)$",
    )
    axes.set_xlim(0.0, (1.25 if wall else 1.0) * extent / across.factor)
    axes.set_ylim(-0.02 * top / upright.factor, top / upright.factor)
    axes.set_xlabel(f"$r$, $x$ [{across.unit}]")
    axes.set_ylabel(f"height [{upright.unit}]")
    style.framed_legend(axes, loc="upper left")
