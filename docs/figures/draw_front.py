"""Draw the picture of the front page: a measured tip, its springs on a line, and the pressure that they bring back.

::

    python docs/figures/draw_front.py

computes the contact and writes docs/figures/front.png.
"""

from __future__ import annotations

from pathlib import Path

from matplotlib.patches import FancyArrowPatch

import winkler as wk
from winkler.plot import style
from winkler.plot.normal.body import contact_panel
from winkler.plot.normal.curves import pressure_panel
from winkler.plot.normal.springs import springs_panel
from winkler.plot.panel import Sheet
from winkler.plot.picture import styled
from winkler.plot.render import render

HERE = Path(__file__).resolve().parent
TIP = HERE.parents[1] / "examples" / "data" / "measured_tip.csv"
EXTENT = 45e-9  # m, from the axis

TITLES = ("a measured tip in silica", "its springs on a line", "the pressure under the tip")
STEPS = ("transform the profile", "bring the fields back")


def main() -> None:
    """Solve the contact and draw it."""
    silica = wk.HalfSpace.between(wk.Elastic(young=72e9, poisson=0.17))
    contact = wk.Indentation(wk.Foundation(wk.read_profile(TIP), silica), wk.Depth(5e-9)).solve()
    panels = (
        contact_panel(contact, EXTENT),
        springs_panel(contact.pressed, EXTENT),
        pressure_panel(contact, EXTENT),
    )
    with styled():
        figure = render(Sheet(panels, width=3.8, height=3.4))
        for axes, title in zip(figure.axes, TITLES, strict=True):
            axes.set_title("", loc="left")
            axes.set_title(title, loc="center", fontsize=11)
        figure.get_layout_engine().set(w_pad=0.28, rect=(0.0, 0.0, 1.0, 0.94))
        figure.draw_without_rendering()
        spans = [axes.title.get_window_extent().transformed(figure.transFigure.inverted()) for axes in figure.axes]
        for left, right, text in zip(spans, spans[1:], STEPS, strict=False):
            ends = ((left.x1 + 0.015, 0.9), (right.x0 - 0.015, 0.9))
            arrow = FancyArrowPatch(
                *ends, transform=figure.transFigure, mutation_scale=15, arrowstyle="-|>", color=style.RED
            )
            figure.add_artist(arrow)
            figure.text(0.5 * (left.x1 + right.x0), 0.92, text, ha="center", va="bottom", color=style.RED)
        figure.savefig(HERE / "front.png", dpi=105)


if __name__ == "__main__":
    main()
