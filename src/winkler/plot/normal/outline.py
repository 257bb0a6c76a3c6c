"""The outline of a shape: its height f(r), the equivalent plane profile g(x), and measured points."""

from __future__ import annotations

import numpy as np

from winkler.plot import style
from winkler.plot.extent import outline_end
from winkler.plot.panel import Line, Panel, PanelAxis
from winkler.plot.series import places, scale_of
from winkler.profiles.measured import Measured
from winkler.profiles.profile import Profile


@np.errstate(divide="ignore", invalid="ignore")  # g is infinite at the equator of a ball
def profile_panel(profile: Profile, extent: float) -> Panel:
    """Return f(r) and g(x) of a shape, and the points of a measured one.

    Parameters
    ----------
    profile : Profile
    extent : float
        Drawn up to this distance [m].
    """
    end = min(extent, outline_end(profile))
    r = np.concatenate([[0.0], places(end, tuple(b for b, _ in profile.kinks)), [end]])
    f, g = (np.asarray(part, dtype=float) for part in (profile.height(r), profile.gap(r)))
    g = np.where(np.isfinite(g), g, np.nan)
    top = 1.25 * max(float(np.max(f)), min(float(np.nanmax(g)), 2.2 * float(np.max(f)))) or 0.3 * extent
    has_wall = profile.rim <= end
    r, f, g = np.append(r, r[-1]), np.append(f, top if has_wall else f[-1]), np.append(g, g[-1])
    marks = []
    if isinstance(profile, Measured):
        points = Line(
            profile.radii,
            profile.heights - profile.curve.derivatives[0, 0],
            style.ORANGE,
            width=0.0,
            marker=".",
            size=2.5,
            order=4.0,
            name=f"{profile.radii.size} measured points",
            coarse=profile.radii.size > 2000,
        )
        marks.append(points)
    marks.append(Line(r, f, style.INK, name="shape $f(r)$"))
    marks.append(Line(r, g, dash=style.DASHES[1], name="equivalent profile $g(x)$"))
    across = PanelAxis("$r$, $x$", scale_of("m", [extent]), low=0.0, high=(1.25 if has_wall else 1.0) * extent)
    upright = PanelAxis("height", scale_of("m", [top]), low=-0.02 * top, high=top)
    return Panel(tuple(marks), across, upright, legend="upper left")
