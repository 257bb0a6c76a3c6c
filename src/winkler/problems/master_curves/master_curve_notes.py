"""How far a master curve can be trusted: superposition, overlap, determined times."""

from __future__ import annotations

import math

import numpy as np

from winkler.numerics.springs.spectrum_response import Measurements
from winkler.numerics.types import Array
from winkler.problems.master_curves.temperature_groups import reached_times
from winkler.values.validity import Assumption, Note, Standing, standing_of

SIGNIFICANT = 3.0
"""Standard errors by which the correlation of neighbouring residuals differs from zero."""
NOTICED = 0.5
"""Correlation of neighbours from which the intervals are markedly too narrow."""
FALSE_ALARM = 1e-3
"""Probability at which storage and loss of one body are said to contradict each other."""
DECADES_APART = 0.3
"""Gap between neighbouring temperatures, in decades, from which their shift rests on the smoothness of the spectrum."""


def master_curve_notes(
    measured: tuple[Measurements, ...],
    temperature: Array,
    shifts: Array,
    residuals: Array,
    determined: tuple[float, float],
) -> tuple[Note, ...]:
    """Return the notes.

    Parameters
    ----------
    measured : tuple of Measurements
    temperature, shifts : ndarray, (m,)
        T [K] and ln a_T [-].
    residuals : ndarray
        Of the logarithms of all measurements, one kind after the other.
    determined : tuple of float
        Shortest and longest determined relaxation time [s].
    """
    ends = np.cumsum([0, *(one.modulus.size for one in measured)])
    products, squares, pairs = 0.0, 0.0, 0
    for one, first, last in zip(measured, ends[:-1], ends[1:], strict=True):
        for group in range(temperature.size):
            own = one.group == group
            row = residuals[first:last][own][np.argsort(one.abscissa[own], kind="stable")]
            products += float(row[1:] @ row[:-1])
            squares += float(0.5 * (row[1:] @ row[1:] + row[:-1] @ row[:-1]))
            pairs += max(row.size - 1, 0)
    correlation = products / squares if squares > 0.0 else 0.0
    trend = correlation if correlation * math.sqrt(max(pairs, 1)) > SIGNIFICANT else 0.0
    superposed = Note(
        Assumption.RESPONSE,
        Standing.ASYMPTOTIC if trend == 0.0 else Standing.APPROXIMATE,
        "Temperature is assumed to multiply all times by one factor. Residuals of neighbouring rows of one "
        "temperature "
        + (
            "are not correlated beyond chance."
            if trend == 0.0
            else f"are correlated by {correlation:.2f}: the curves do not superpose within their scatter"
            + (", and the intervals are too narrow." if correlation > NOTICED else ".")
        ),
        "correlation of the residuals",
    )
    return (superposed, _overlap(measured, temperature, shifts), determined_note(determined))


def contradiction_notes(temperature: Array, differences: Array, errors: Array) -> tuple[Note, ...]:
    """Return a note where storage and loss ask for other shifts; none where they do not or were not compared.

    Parameters
    ----------
    temperature : ndarray, (m,)
        T [K].
    differences, errors : ndarray, (m,) or (0,)
        Logarithms of the shifts of the loss over those of the storage [-], and their standard errors.
    """
    from scipy.special import ndtri

    known = errors > 0.0
    if not np.any(known):
        return ()
    apart = np.where(known, np.abs(differences) / np.where(known, errors, 1.0), 0.0)
    worst = int(np.argmax(apart))
    if apart[worst] < -float(ndtri(0.5 * FALSE_ALARM / np.count_nonzero(known))):
        return ()
    decades, error = differences[worst] / math.log(10.0), errors[worst] / math.log(10.0)
    text = (
        f"Storage and loss modulus contradict each other. At {temperature[worst]:.4g} K log10 of the shift of the "
        f"loss modulus is that of the storage modulus {decades:+.2g} +- {error:.1g}. Use by = 'storage' or by = "
        "'loss' to shift by one of them alone."
    )
    return (Note(Assumption.RESPONSE, Standing.APPROXIMATE, text, "score of a shift of the loss alone"),)


def shifted_by_note(kind: str, scatter: Array) -> Note:
    """Return by which moduli the sweeps were shifted, and what is left of both."""
    storage, loss = (100.0 * scatter).tolist()
    text = (
        f"The shifts are those of the {kind} modulus alone; the spectrum is that of both moduli with these "
        f"shifts. The remaining scatter is {storage:.2g} % (storage) and {loss:.2g} % (loss)."
    )
    return Note(Assumption.RESPONSE, Standing.ASYMPTOTIC, text, "shifts of one kind of modulus")


def _overlap(measured: tuple[Measurements, ...], temperature: Array, shifts: Array) -> Note:
    places = np.concatenate([reached_times(one, shifts) for one in measured]) / math.log(10.0)
    groups = np.concatenate([one.group for one in measured])
    spans = [(places[groups == g].min(), places[groups == g].max()) for g in range(temperature.size)]
    gaps = np.array([max(b[0] - a[1], a[0] - b[1]) for a, b in zip(spans[:-1], spans[1:], strict=True)])
    worst = int(np.argmax(gaps))
    gap = float(gaps[worst])
    between = f"between {temperature[worst]:.4g} K and {temperature[worst + 1]:.4g} K"
    text = (
        f"Neighbouring temperatures overlap by {-gap:.2g} decades at least, {between}"
        if gap <= 0.0
        else f"There is a gap of {gap:.2g} decades {between}, which only the smoothness of the spectrum bridges: "
        "measure a temperature in between"
    )
    return Note(
        Assumption.CURVE, standing_of(gap, 0.0, math.inf if gap < DECADES_APART else gap), f"{text}.", "overlap"
    )


def determined_note(determined: tuple[float, float]) -> Note:
    """Return between which relaxation times the spectrum is determined."""
    low, high = determined
    if not high > low:
        return Note(
            Assumption.KNOWN_TIMES,
            Standing.OUTSIDE,
            "The scatter is too large: at no relaxation time the modulus is known within a factor of two.",
            "standard errors of the spectrum",
        )
    return Note(
        Assumption.KNOWN_TIMES,
        Standing.ASYMPTOTIC,
        f"The spectrum is determined within a factor of two from {low:.3g} s to {high:.3g} s; beyond this range "
        "it is a smooth extrapolation.",
        "standard errors of the spectrum",
    )
