r"""Measured contact resistance over the force: resistivity, film, and what lies in series.

.. math:: R(F) = \frac{\rho_1+\rho_2}{4a(F)}\,H + \frac{\sigma_f}{\pi a(F)^2} + R_0

with the spreading :math:`H` by the film that `Constriction` has is fitted to logarithms, as the scatter is relative.
The three parts go with different powers of the force (-1/3, -2/3 and 0 of a ball); a narrow range of forces cannot part
them, and their errors say so.
"""

from __future__ import annotations

import functools
import math
from typing import Annotated, ClassVar

import numpy as np

from winkler.fitting.logs.estimated import Estimate, inflation
from winkler.foundation.bed import Bed
from winkler.laws.film import SurfaceFilm
from winkler.loading.loads import Force
from winkler.materials.conductor import ElectricalConductor
from winkler.media.conduction.conductors import ElectricalConductors
from winkler.numerics.types import Array
from winkler.problems.assumptions.declared import CONDUCTING
from winkler.problems.conduction.constriction import Constriction
from winkler.problems.conduction.disc import resistances_of
from winkler.problems.normal.indentation import Indentation
from winkler.values.checks.number_checks import POSITIVE, NonNegative, Numbers
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.limits import MEASURED_TIMES
from winkler.values.readable import with_unit
from winkler.values.validity import Assumption, Note, Standing, standing_of
from winkler.values.value import value, words

FEWEST_ROWS = 8
PARTS = ("resistivity", "film", "series")
UNITS = ("ohm m", "ohm m^2", "ohm")
SMALL_SCATTER, LARGE_SCATTER = 0.02, 0.1
"""Relative scatter of the resistances about the fitted ones."""
LEAST_PART, START_PART, NOTHING = 1e-12, 1e-3, 1e-9
"""Least resistivity, least part of each number at the start, and what counts as zero, over what alone would make R."""
LEAST_SHARE = 1e-7
"""Least singular value of the derivatives, over the greatest: below it a combination of the numbers has no effect."""
SURE = 3.0
"""Standard errors from which on a difference of loading and unloading is named."""
SOURCE = "least squares of logarithms, with the correlation of neighbours; Student's distribution"


@value
class ResistanceLog:
    """Measured contact resistance versus force, row by row.

    Parameters
    ----------
    force : ndarray, (n,)
        F_N [N], positive.
    resistance : ndarray, (n,)
        R [ohm], positive.

    Raises
    ------
    InvalidInput
        If the columns differ in length, are too short, contain a number that is not positive, or contain only one
        force.
    """

    __words__ = words(
        force=("F_N", "N", "force that presses the bodies together"),
        resistance=("R", "ohm", "measured resistance"),
    )

    force: Annotated[Array, Numbers(POSITIVE, FEWEST_ROWS, MEASURED_TIMES)]
    resistance: Annotated[Array, Numbers(POSITIVE, FEWEST_ROWS, MEASURED_TIMES)]

    def __post_init__(self) -> None:
        if self.force.size != self.resistance.size:
            raise InvalidInput(
                f"ResistanceLog: force has {self.force.size} numbers and resistance {self.resistance.size}; cut both."
            )
        if not float(np.ptp(self.force)) > 0.0:
            raise InvalidInput("ResistanceLog: all forces are the same; give resistances at several forces.")

    @property
    def exponent(self) -> Estimate:
        """Power of the force with which the resistance falls [-]: 1/3 of clean elastic balls, 1/2 of yielding ones."""
        place, level = np.log(self.force), np.log(self.resistance)
        found = _linear(np.stack([np.ones(place.size), -(place - place.mean())], axis=1), level)
        return found[1]


def _linear(rows: Array, samples: Array) -> list[Estimate]:
    numbers, *_ = np.linalg.lstsq(rows, samples, rcond=None)
    return _estimates(rows, samples - rows @ numbers, numbers)


def _estimates(rows: Array, rest: Array, numbers: Array) -> list[Estimate]:
    """Return numbers with errors from the rows of derivatives and the residuals."""
    freedom, wide = rest.size - rows.shape[1], inflation(rest, rows.shape[1])
    variance = np.diag(np.linalg.inv(rows.T @ rows)) * float(rest @ rest) / freedom * wide
    return [
        Estimate(float(number), math.sqrt(float(spread)), max(freedom / wide, 1.0))
        for number, spread in zip(numbers, variance, strict=True)
    ]


@value
class MeasuredConstriction:
    """A contact whose electrical resistance was measured as a function of the force.

    Parameters
    ----------
    bed : Bed
        The foundation: Foundation(profile, medium) or another one with known contact area.
    log : ResistanceLog
        Forces and resistances.
    resistivity : float, optional
        Mean resistivity of both bodies [ohm m]; zero (default) if it is to be fitted.

    Raises
    ------
    InvalidInput
        If an argument has the wrong type.

    References
    ----------
    R. Holm, Electric Contacts, 4th edition, Springer 1967, doi:10.1007/978-3-662-06688-1

    Examples
    --------
    >>> import numpy as np
    >>> from winkler.foundation.foundation import Foundation
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.profiles.power import Paraboloid
    >>> bed = Foundation(Paraboloid(2e-3), HalfSpace(Elastic(young=1e9, poisson=0.3)))
    >>> force = np.geomspace(0.01, 10.0, 40)
    >>> radius = np.cbrt(0.75 * force * 2e-3 / (1e9 / 0.91))
    >>> log = ResistanceLog(force, 16e-9 / (2.0 * radius) + 1e-4)
    >>> found = MeasuredConstriction(bed, log).solve()
    >>> round(found.resistivity * 1e9, 3), round(found.series * 1e6, 2)
    (16.0, 100.0)
    """

    __words__ = words(
        log=("", None, "measured forces and resistances"),
        resistivity=(r"\rho", "ohm m", "mean resistivity of both bodies, where it is known"),
    )

    bed: Bed
    log: ResistanceLog
    resistivity: NonNegative = 0.0

    references: ClassVar[tuple[str, ...]] = ("holm_1967", "barber_2003")
    assumptions: ClassVar[frozenset[Assumption]] = CONDUCTING | {Assumption.CURVE}
    needs_round: ClassVar[str] = ""

    @functools.cached_property
    def _radius(self) -> Array:
        contact = Indentation(self.bed, Force(self.log.force)).solve()
        radius = np.asarray(contact.radius, dtype=float)
        if not np.all(radius > 0.0):
            raise OutsideValidity("MeasuredConstriction: at some forces the bodies do not touch; leave these rows out.")
        return radius

    def resistances(self, resistivity: float, film: float, series: float) -> Array:
        """Return the resistance [ohm] at the forces of the log for given resistivity, film and series resistance.

        Raises
        ------
        OutsideValidity
            If the bodies do not touch at one of the forces.
        """
        body = ElectricalConductor(resistivity)
        between = ElectricalConductors(body, body, SurfaceFilm(film))
        return np.asarray(resistances_of(self.bed, between, self._radius).whole + series)

    def solve(self) -> MeasuredConstrictionSolution:
        """Return resistivity, film and resistance in series.

        Returns
        -------
        MeasuredConstrictionSolution

        Raises
        ------
        OutsideValidity
            If a force exceeds the reach of the profile, or the contact area is not known or does not change with the
            force.
        """
        from scipy.optimize import least_squares, nnls

        log, known, resistances = self.log, self.resistivity, self.resistances
        radius = self._radius
        middle = float(np.median(radius))
        size = known or middle * float(np.median(log.resistance))
        rows = np.stack(
            [
                resistances(size, 0.0, 0.0) / size,
                (resistances(size, size * middle, 0.0) - resistances(size, 0.0, 0.0)) / (size * middle),
                np.ones(radius.size),
            ],
            axis=1,
        )
        free = np.arange(1 if known else 0, 3)
        scale = 1.0 / np.median(rows / log.resistance[:, None], axis=0)
        rest = 1.0 - known * rows[:, 0] / log.resistance
        begun, _ = nnls(rows[:, free] * scale[free] / log.resistance[:, None], np.clip(rest, 0.0, None))

        def left(numbers: Array) -> Array:
            parts = scale[free] * numbers
            modelled = resistances(*(parts if not known else (known, *parts)))
            return np.asarray(np.log(modelled / log.resistance))

        least = np.where(free == 0, LEAST_PART, 0.0)
        found = least_squares(
            left,
            np.maximum(begun, START_PART),
            jac="3-point",
            bounds=(least, np.inf),
            xtol=1e-14,
            ftol=1e-14,
            gtol=1e-14,
        )
        sizes = np.linalg.svd(found.jac / np.linalg.norm(found.jac, axis=0), compute_uv=False)
        if not sizes[-1] > LEAST_SHARE * sizes[0]:
            raise OutsideValidity(
                "MeasuredConstriction: over these forces a film and leads change the resistance equally, as under a "
                "flat "
                "punch, whose area is the same under each force; give a wider range of forces, or a round body."
            )
        numbers, errors = np.array([known, 0.0, 0.0]), np.zeros(3)
        estimates = _estimates(found.jac, found.fun, found.x)
        numbers[free] = np.where((found.x > NOTHING) | (free == 0), scale[free] * found.x, 0.0)
        errors[free] = scale[free] * np.array([one.error for one in estimates])
        return MeasuredConstrictionSolution(
            problem=self,
            resistivity=float(numbers[0]),
            resistivity_error=float(errors[0]),
            film=float(numbers[1]),
            film_error=float(errors[1]),
            series=float(numbers[2]),
            series_error=float(errors[2]),
            exponent=log.exponent.value,
            exponent_error=log.exponent.error,
            scatter=float(np.sqrt(np.sum(found.fun**2) / (log.force.size - free.size))),
            freedom=estimates[0].freedom,
        )


@value
class MeasuredConstrictionSolution:
    """The solution of a `MeasuredConstriction`.

    Parameters
    ----------
    problem : MeasuredConstriction
        The problem that was solved.
    resistivity, resistivity_error : float
        Mean of both bodies [ohm m], and its standard error; zero where it was given.
    film, film_error : float
        Resistance of a film times its area [ohm m^2].
    series, series_error : float
        Resistance that does not depend on the force [ohm]: leads, lengths of bodies.
    exponent, exponent_error : float
        Power of the force with which the resistance falls [-].
    scatter : float
        Relative scatter of the resistances about the fitted ones [-].
    freedom : float
        Number of independent rows from which the errors are computed.
    """

    __words__ = words(
        resistivity=(r"\rho", "ohm m", "mean resistivity of both bodies"),
        resistivity_error=("", "ohm m", "standard error of the resistivity"),
        film=(r"\sigma_f", "ohm m^2", "resistance of a film times its area"),
        film_error=("", "ohm m^2", "standard error of the film"),
        series=("R_0", "ohm", "resistance that does not depend on the force"),
        series_error=("", "ohm", "standard error of the resistance in series"),
        exponent=("n", "", "power of the force with which the resistance falls"),
        exponent_error=("", "", "standard error of the exponent"),
        scatter=("", "", "relative scatter of the resistances about the fitted ones"),
        freedom=("", "", "independent rows behind the errors"),
    )

    problem: MeasuredConstriction
    resistivity: float
    resistivity_error: float
    film: float
    film_error: float
    series: float
    series_error: float
    exponent: float
    exponent_error: float
    scatter: float
    freedom: float

    @functools.cached_property
    def fitted(self) -> Array:
        """Fitted resistances at the forces of the log [ohm], ``(n,)``."""
        return self.problem.resistances(self.resistivity, self.film, self.series)

    def interval(self, name: str) -> tuple[float, float]:
        """Return the interval of 95 % of ``"resistivity"``, ``"film"`` or ``"series"``; none ends below zero.

        Raises
        ------
        InvalidInput
            If there is no such number.
        """
        if name not in PARTS:
            raise InvalidInput(f"MeasuredConstriction: there is no interval of {name!r}; give {', '.join(PARTS)}.")
        low, high = Estimate(getattr(self, name), getattr(self, f"{name}_error"), self.freedom).interval
        return max(low, 0.0), high

    @functools.cached_property
    def turned(self) -> Estimate | None:
        """Resistance at rising force over that at falling force, as a natural logarithm [-].

        None if the force only rises or only falls.
        """
        log = self.problem.log
        steps = np.sign(np.gradient(log.force))
        rest = np.log(log.resistance / self.fitted)
        if np.count_nonzero(steps > 0.0) < FEWEST_ROWS // 2 or np.count_nonzero(steps < 0.0) < FEWEST_ROWS // 2:
            return None
        return _linear(np.stack([np.ones(steps.size), steps], axis=1), rest)[1]

    @property
    def validity(self) -> tuple[Note, ...]:
        """Assumptions and doubts about the results; then the notes of the contact itself."""
        notes = [self._numbers()]
        turned = self.turned
        if turned is not None and abs(turned.value) > SURE * turned.error:
            word = "higher" if turned.value > 0.0 else "lower"
            notes.append(
                Note(
                    Assumption.ELASTIC,
                    Standing.OUTSIDE,
                    f"Resistances are {200 * abs(turned.value):.2g} % {word} during loading than during "
                    "unloading: the bodies yielded, or the film broke. Give the rows of loading or of unloading "
                    "only.",
                    SOURCE,
                )
            )
        body, force = ElectricalConductor(self.resistivity), Force(float(np.max(self.problem.log.force)))
        between = ElectricalConductors(body, body, SurfaceFilm(self.film))
        return (*notes, *Constriction(Indentation(self.problem.bed, force), between).solve().validity)

    def _numbers(self) -> Note:
        free = [name for name in PARTS if name != "resistivity" or self.problem.resistivity == 0.0]
        ends = []
        for name in free:
            low, high = self.interval(name)
            unit = UNITS[PARTS.index(name)]
            ends.append(f"{name} {with_unit(low, unit, 3)} to {with_unit(high, unit, 3)}")
        unknown = [name for name in free if self.interval(name)[0] == 0.0]
        rest = f"; the true value of {' and '.join(unknown)} may be zero" if unknown else ""
        return Note(
            Assumption.CONDUCTION,
            standing_of(self.scatter, SMALL_SCATTER, LARGE_SCATTER),
            f"The 95 % intervals of the parameters are {', '.join(ends)}{rest}. Here film is the resistance of the "
            "surface film times its area, and series the resistance that does not depend on the force. The resistance "
            f"falls with the force to the power {self.exponent:.3f} ± {self.exponent_error:.2g}, with a scatter of "
            f"{100 * self.scatter:.2g} %. One smooth contact is assumed. Rough bodies conduct through many "
            "microcontacts; the exponent and the constants of this power law are then different.",
            SOURCE,
        )
