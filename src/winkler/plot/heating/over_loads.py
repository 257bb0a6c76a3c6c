"""Flash temperature and shares of heat of many loads or speeds, over what was varied."""

from __future__ import annotations

import dataclasses
from typing import Any

import numpy as np

from winkler.numerics.types import Quantity
from winkler.plot import style
from winkler.plot.panel import Panel, PanelAxis, Sheet, among, titled
from winkler.plot.series import middle_scale, scale_of, series
from winkler.values.errors import OutsideValidity

COLUMNS = ("first_max_temperature", "second_max_temperature", "first_share")


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
        along = series("peclet", np.ravel(pe))
    heated = dataclasses.replace(along, content=along.content[is_heated])
    order = np.argsort(heated.content, kind="stable")
    logarithmic = bool(np.min(heated.content) > 0.0 and np.max(heated.content) > 20.0 * np.min(heated.content))
    label = PanelAxis.of(heated).label.replace("peclet", "Peclet number")
    across = PanelAxis(label, middle_scale(heated.word.unit, heated.content), margin=0.03, log=logarithmic)
    columns = {name: np.ravel(np.asarray(getattr(item, name))) for name in COLUMNS}
    columns["fast_temperature"] = np.ravel(np.broadcast_to(estimate, pe.shape))
    panels = []
    for names in (("first_max_temperature", "second_max_temperature", "fast_temperature"), ("first_share",)):
        many = [series(name, columns[name][is_heated], type(item)) for name in names]
        finite = [one for one in many if np.all(np.isfinite(one.content))]
        scale = scale_of(many[0].word.unit, *(one.content for one in finite))
        looks = zip((style.RED, style.BLUE, style.GREEN), ("first", "second", estimated), strict=False)
        lines = [
            among(place, heated.content[order], one.content[order], name, colour=colour, size=3.0)
            for place, (one, (colour, name)) in enumerate(zip(many, looks, strict=False))
            if np.all(np.isfinite(one.content))
        ]
        share = names == ("first_share",)
        upright = PanelAxis.of(many[0], scale, low=0.0, high=1.0)
        if not share:
            upright = PanelAxis(
                "greatest rise of temperature", scale, low=None if logarithmic else 0.0, log=logarithmic
            )
        panels.append(Panel(tuple(lines), across, upright, legend="" if share else "upper left"))
    titles = ("temperature of the bodies", "part of the heat for the first body")
    return Sheet(titled(panels, *titles), width=4.6, height=3.3)
