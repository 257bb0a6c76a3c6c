"""A study with ``[fit]``: measured curves, a problem as their model, and the numbers to be fitted.

::

    [fit]
    curve = "gel/*.csv"
    part = "approach"

    [fit.free]
    "problem.bed.medium.first.young" = ["1 kPa", "10 MPa"]
    contact_point = true

The load of the problem is only a placeholder and may be left out.
"""

from __future__ import annotations

import math
import re
from typing import Any

from winkler.study.language import keys
from winkler.study.language.study import Output
from winkler.values.value import value
from winkler.values.vocabulary import Word

FITTED = ("indentation", "adhesive_indentation", "plastic_indentation", "viscoelastic_indentation")
"""Problems that can be the model of a curve."""
OF_A_CURVE = {
    "contact_point": Word("D_0", "m", "position at which the curve first touches"),
    "baseline": Word("F_0", "N", "force out of contact"),
    "tilt": Word("t", "N/m", "change of the baseline with the position"),
    "inertia": Word("m", "kg", "mass that moves with the probe, over the acceleration of its tip"),
}
OF_A_TIMED_CURVE = OF_A_CURVE | {
    "drift": Word("u", "m/s", "drift of the position"),
    "drag": Word("c_v", "N s/m", "drag of the liquid on the cantilever, over its velocity"),
}
"""Free numbers of a curve where the model relaxes."""


@value
class Free:
    """One line of ``[fit.free]``.

    Parameters
    ----------
    key
        As it stands in the study: ``problem.bed.medium.first.young``, or contact_point, baseline, tilt, inertia; of a
        body that relaxes also drift and drag.
    given : tuple of float
        ``(low, high)``, ``(start,)``, or nothing; SI.
    """

    key: str
    given: tuple[float, ...] = ()

    @property
    def path(self) -> str:
        """Its name in `winkler.fitting.fit.fit`."""
        return re.sub(r"\.(\d+)(?=\.|$)", r"[\1]", self.key.removeprefix("problem."))

    @property
    def label(self) -> str:
        """Its last name, with its number in a row."""
        return re.sub(r"^.*?(\w+(\.\d+)*)$", r"\1", self.key)

    @property
    def start_or_bounds(self) -> tuple[float, ...] | float:
        """Its start or bounds, as `winkler.fitting.fit.fit` takes them."""
        return self.given[0] if len(self.given) == 1 else self.given


@value
class Alternative:
    """Another model of the curves, one line of ``[fit.models]``.

    Parameters
    ----------
    name
        As it stands in the study.
    problem
        The model; its load is a placeholder.
    free : tuple of Free
        What is fitted.
    """

    name: str
    problem: Any
    free: tuple[Free, ...]


@value
class FitStudy:
    """What to fit, and to what.

    Parameters
    ----------
    title
        One line for tables, figures and the report.
    problem
        The model; its load is a placeholder.
    sources : tuple of str
        Files of curves, in the order in which they are fitted.
    free : tuple of Free
        What is fitted.
    part
        approach, hold (with the approach), retract or both.
    segments : tuple of str
        "found", or kinds with their beginnings, as "hold 12 s"; empty: as the file states, or as detected.
    events : tuple of str
        "none", or events with their places, as "pop-in 3.1 s"; empty: as found.
    fitted
        force, or of a body that relaxes position, under the measured forces.
    correct : tuple of str
        Corrections in their order.
    spring_constant, sensitivity
        [N/m] and [m/V], zero where the files state them.
    units : tuple of pairs of str
        Quantity and unit of columns whose unit the files do not state.
    columns : tuple of pairs of str and int
        Quantity and number of columns that the files do not name.
    frame_stiffness
        [N/m].
    noise
        [N], or [m] where positions are fitted; zero: read from the curves.
    noise_spectrum
        unknown, or white if that is known.
    time_limit
        The longest that the fit of one curve may take [s].
    spring_constant_error, sensitivity_error
        Relative standard errors of the calibration.
    spring_constant_by
        thermal, if the spring constant was found from thermal noise with this sensitivity.
    over_depth
        Number of depths up to which each curve is fitted; zero for the whole curve alone.
    shared : tuple of str
        Keys of free numbers that all curves share.
    model
        Name of the problem among the models.
    models : tuple of Alternative
        Other models that are compared with it.
    output
        What is written.
    text
        The study file, word for word.
    folder
        Where it lies; names of curves are relative to it.
    """

    title: str
    problem: Any
    sources: tuple[str, ...]
    free: tuple[Free, ...]
    part: str = "approach"
    segments: tuple[str, ...] = ()
    events: tuple[str, ...] = ()
    fitted: str = "force"
    correct: tuple[str, ...] = ()
    spring_constant: float = 0.0
    sensitivity: float = 0.0
    units: tuple[tuple[str, str], ...] = ()
    columns: tuple[tuple[str, int], ...] = ()
    frame_stiffness: float = math.inf
    noise: float = 0.0
    noise_spectrum: str = "unknown"
    time_limit: float = math.inf
    spring_constant_error: float = 0.0
    sensitivity_error: float = 0.0
    spring_constant_by: str = ""
    over_depth: int = 0
    shared: tuple[str, ...] = ()
    model: str = "the problem"
    models: tuple[Alternative, ...] = ()
    output: Output = Output()
    text: str = ""
    folder: str = "."

    @property
    def spread(self) -> Word:
        """Symbol, unit and meaning of the noise."""
        unit = "N" if self.fitted == "force" else "m"
        return Word("", unit, f"standard deviation of the {self.fitted}")

    @property
    def own_numbers(self) -> tuple[Free, ...]:
        """The free numbers of the problem, without those of the curve."""
        return tuple(free for free in self.free if free.key.startswith("problem."))

    @property
    def is_calibrated(self) -> bool:
        """Whether the calibration has a stated error."""
        return self.spring_constant_error > 0.0 or self.sensitivity_error > 0.0

    def word(self, key: str) -> Word:
        """Return symbol, unit and meaning of a free number."""
        return word_of(self.problem, key)


def word_of(problem: Any, key: str) -> Word:
    """Return symbol, unit and meaning of a number that is free in `problem`, by its key in the study."""
    if key in OF_A_TIMED_CURVE:
        return OF_A_TIMED_CURVE[key]
    from winkler.study.language import quantities

    path = key.removeprefix("problem.")
    owner, field, _ = keys.owner_at(problem, path)
    return keys.word_at(problem, path)._replace(unit=quantities.unit_in(owner, field) or "")
