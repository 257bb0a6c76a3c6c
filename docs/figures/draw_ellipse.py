"""Draw the figure of docs/chapters/ellipses.md: Hertz's ellipse over the ratio of the radii of curvature.

::

    python docs/figures/draw_ellipse.py

writes docs/figures/ellipse.png, and prints the table of the page.
"""

from __future__ import annotations

import math
from pathlib import Path
from typing import NamedTuple

import matplotlib.pyplot as plt
import numpy as np

import winkler as wk
from winkler.plot import style
from winkler.plot.picture import styled

HERE = Path(__file__).resolve().parent
RATIOS = (1.0, 1.25, 1.5, 2.0, 3.0, 5.0, 10.0, 20.0, 50.0, 100.0, 1000.0, 10000.0)
UNIT = wk.HalfSpace(wk.Elastic(young=0.91, poisson=0.3))


class Row(NamedTuple):
    """Numbers of one ratio of the radii, over those of the ball of their geometric mean, and over p0 and b."""

    ratio: float
    larger: float
    smaller: float
    pressure: float
    depth: float
    shear: float
    shear_depth: float
    von_mises: float
    von_mises_depth: float
    orthogonal: float
    orthogonal_depth: float


def row(ratio: float) -> Row:
    """Return the numbers of the radii sqrt(ratio) and 1 / sqrt(ratio), nu = 0.3."""
    bodies = wk.CurvedBodies(math.sqrt(ratio), 1.0 / math.sqrt(ratio))
    ball, contact = (
        wk.EllipticIndentation(each, UNIT, wk.Force(1.0)).solve() for each in (wk.CurvedBodies(1.0, 1.0), bodies)
    )
    a, b = contact.longitudinal_semi_axis, contact.lateral_semi_axis
    unit = ball.longitudinal_semi_axis
    found = [a / unit, b / unit, contact.peak_pressure / ball.peak_pressure, contact.depth / ball.depth]
    for measure in ("max_shear", "von_mises", "orthogonal_shear"):
        place = contact.greatest_stress(measure=measure)
        found += [place.value / contact.peak_pressure, place.z / b]
    return Row(ratio, *(float(number) for number in found))


def table() -> str:
    """Return the table of the page."""
    lines = [
        "| $R_x/R_y$ | $b/a$ | $a/a_0$ | $b/a_0$ | $p_0/p_{00}$ | $d/d_0$ | $\\tau_{max}/p_0$ | $z/b$ | "
        "$\\sigma_{vM}/p_0$ | $z/b$ | $\\tau_0/p_0$ | $z/b$ |",
        "|---" * 12 + "|",
    ]
    for one in map(row, RATIOS):
        numbers = [f"{one.ratio:g}", f"{one.smaller / one.larger:.4f}", f"{one.larger:.4f}"]
        numbers += [f"{number:.4f}" for number in one[2:]]
        lines.append(f"| {' | '.join(numbers)} |")
    return "\n".join(lines)


def main() -> None:
    """Draw the numbers over the ratio of the radii."""
    rows = [row(ratio) for ratio in np.geomspace(1.0, 1e3, 41)]
    ratio = [one.ratio for one in rows]
    with styled():
        figure, (sizes, stresses, depths) = plt.subplots(1, 3, figsize=(10.5, 3.3), layout="constrained")
        for name, label, colour in (
            ("larger", "semi-axis $a/a_0$", style.BLUE),
            ("smaller", "semi-axis $b/a_0$", style.GREEN),
            ("pressure", "pressure $p_0/p_{00}$", style.RED),
            ("depth", "depth $d/d_0$", style.INK),
        ):
            sizes.loglog(ratio, [getattr(one, name) for one in rows], color=colour, label=label)
        sizes.set(title="ellipse beside the circle", ylabel="over the ball of $\\sqrt{R_xR_y}$ [-]")
        for name, label, colour in (
            ("von_mises", "von Mises", style.RED),
            ("shear", "greatest shear", style.BLUE),
            ("orthogonal", "orthogonal shear", style.GREEN),
        ):
            stresses.semilogx(ratio, [getattr(one, name) for one in rows], color=colour, label=label)
            places = [getattr(one, f"{name}_depth" if name != "orthogonal" else "orthogonal_depth") for one in rows]
            depths.semilogx(ratio, places, color=colour, label=label)
        stresses.set(title="greatest stresses", ylabel="over $p_0$ [-]", ylim=(0.0, 0.7))
        depths.set(title="and their depths", ylabel="over $b$ [-]", ylim=(0.0, 0.9))
        for axes in (sizes, stresses, depths):
            axes.set(xlabel="ratio of the radii $R_x/R_y$ [-]", xlim=(1.0, 1e3))
            axes.legend(frameon=False)
        figure.savefig(HERE / "ellipse.png", dpi=100)


if __name__ == "__main__":
    main()
    print(table())
