"""Flash temperature and shares of heat of many loads or speeds, over what was varied."""

from __future__ import annotations

import dataclasses
from collections.abc import Sequence
from typing import Any

import numpy as np

from winkler.numerics.types import Array, Quantity
from winkler.plot import style
from winkler.plot.curves import curves_panel
from winkler.plot.panel import Band, Panel, Sheet, titled
from winkler.plot.series import Series, series
from winkler.values.errors import OutsideValidity


def both_panel(rows: Sequence[tuple[Array, str]], along: Series, half: float) -> Panel:
    """Return rises of temperature [K] of the first and the second body along the motion, the contact shaded."""
    lines = [(series("temperature", rise), name) for rise, name in rows]
    panel = curves_panel(along, lines, label="rise of temperature $T$")
    return panel.plus(Band(-half, half, style.MUTED, 0.12))


def refuse_cold(temperature: Quantity) -> None:
    """Refuse to draw a contact in which no heat is released; its greatest temperatures [K]."""
    if not np.any(np.asarray(temperature) > 0.0):
        raise OutsideValidity(
            "draw: no heat is released, so there is nothing to show; give a load and a sliding speed."
        )


def curves_sheet(item: Any, estimate: Quantity, estimated: str) -> Sheet:
    """Return flash temperature and heat partition over the varied quantity: Peclet number or heat.

    Parameters
    ----------
    item
        A solution of steady frictional heat.
    estimate : float or ndarray
        Of its flash temperature [K], to compare with.
    estimated : str
        Its name in the legend.
    """
    pe = np.maximum(np.asarray(item.first_peclet), np.asarray(item.second_peclet))
    heat = np.ravel(np.asarray(getattr(item, item.per_load)))
    is_heated = heat > 0.0
    along = series(item.per_load, heat, type(item))
    if np.ptp(pe) > 0.0:
        along = dataclasses.replace(series("peclet", np.ravel(pe)), name="Peclet number")
    heated = dataclasses.replace(along, content=along.content[is_heated])
    temperatures = {
        "first": item.first_max_temperature, "second": item.second_max_temperature, estimated: estimate,
    }  # fmt: skip
    rows = [
        (series("temperature", np.ravel(np.broadcast_to(each, pe.shape))[is_heated]), name)
        for name, each in temperatures.items()
    ]
    rows = [(of, name) for of, name in rows if np.all(np.isfinite(of.content))]
    share = series("first_share", np.ravel(item.first_share)[is_heated], type(item))
    panels = curves_panel(heated, rows, label="greatest rise of temperature"), curves_panel(heated, [(share, "")])
    titles = ("temperature of the bodies", "part of the heat for the first body")
    return Sheet(titled(panels, *titles), width=4.6, height=3.3)
