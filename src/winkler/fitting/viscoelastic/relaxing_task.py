"""What the fits of relaxing contacts share beside the response: starts, doubts, and the order of their terms."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

import numpy as np

from winkler.fitting.curves.checks import Flag, Outline
from winkler.fitting.parameters import each
from winkler.fitting.task import Prediction
from winkler.fitting.viscoelastic.doubts import unidentified
from winkler.fitting.viscoelastic.response import elastic_table
from winkler.fitting.viscoelastic.start import starts
from winkler.fitting.viscoelastic.task import Driven
from winkler.numerics.types import Array
from winkler.problems.viscoelastic.march import elastic_like

__all__ = ["RelaxingTask"]


class RelaxingTask(Driven):
    """A contact that relaxes; its subclasses say what drives, and what is fitted."""

    def starts(self, coarse: Driven, strokes: Outline | None) -> Iterable[Array]:
        """Yield coordinates for some contact points, times and exponents, moduli by linear least squares."""
        return starts(self, coarse, strokes)

    def doubts(self, numbers: dict[str, float], errors: Array) -> list[Flag]:
        """Return what the curve cannot tell about the solid."""
        return unidentified(self, numbers, dict(zip(numbers, errors.tolist(), strict=True)))

    def final(self, coordinates: Array) -> Array:
        """Return coordinates whose terms are sorted by their times, where nothing but their order would change."""
        rows: dict[str, list[int]] = {}
        for index, parameter in enumerate(self.parameters):
            if parameter.name.endswith("]"):
                rows.setdefault(parameter.name.rpartition("[")[0], []).append(index)
        ordered = coordinates.copy()
        for name, places in rows.items():
            partner = name.replace("relaxation_times", "shears").replace("retardation_times", "compliances")
            if partner == name or len(rows.get(partner, ())) != len(places):
                continue
            alike = all(len({self.parameters[i][1:3] for i in row}) == 1 for row in (places, rows[partner]))
            if alike and len(places) == len(each(self.model, name)):
                turn = np.argsort(coordinates[places])
                for row in (places, rows[partner]):
                    ordered[row] = coordinates[row][turn]
        return coordinates if np.array_equal(ordered, coordinates) else ordered

    def relaxing_fields(self, numbers: dict[str, float], prediction: Prediction) -> dict[str, Any]:
        """Return what is found about the contact: which numbers are logarithmic, depths and radii [m]."""
        contact = prediction.contact
        table = elastic_table(elastic_like(self.with_numbers(numbers).bed), float(contact.edge.max()))
        return {
            "logarithmic": tuple(p.logarithmic for p in self.parameters),
            "depth": contact.depth,
            "radius": np.where(prediction.touched, table.radius_at(contact.edge), 0.0),
        }
