"""What fits say beyond their numbers, as sentences for terminal and report."""

from __future__ import annotations

import functools
import math
import re
from collections.abc import Iterator, Sequence

import numpy as np

from winkler.fitting.flag_meanings import REFUSING_FLAGS
from winkler.fitting.several.groups import ratio_of
from winkler.fitting.several.joint import JointFit
from winkler.fitting.several.population import Population, population, quantile
from winkler.study.batch.fit_further import common_calibration, compared, contact_correlation
from winkler.study.batch.fit_outcome import CONFIDENCE, FitOutcome, Fitted, Refused
from winkler.study.language.fit_study import Free
from winkler.values.errors import InvalidInput
from winkler.values.readable import with_unit

FEWEST_TOGETHER = 3
"""Curves from which a mean is stated."""
MOST_NAMES = 5
MOST_GROUPS = 6
FLAGGED = re.compile(rf"curve '.*': ({'|'.join(REFUSING_FLAGS)}): ")
"""Beginning of the reason why a curve with a refusing flag was not fitted."""


def further_sentences(outcome: FitOutcome) -> Iterator[str]:
    """Yield what depths, calibration, models, curves together and shared numbers say."""
    if len(outcome.fitted) == 1:
        yield from _of_one(outcome, outcome.fitted[0])
    else:
        for free in outcome.study.own_numbers:
            yield from _of_many(outcome, free)
        yield from _counts(outcome)
    yield from _shared(outcome)
    for result in outcome.fitted:
        where = f"{result.name}, " if len(outcome.results) > 1 else ""
        yield from (f"Not done: {where}{reason}" for reason in result.further.refused)


def _of_one(outcome: FitOutcome, result: Fitted) -> Iterator[str]:
    study, found = outcome.study, result.fit
    correlation = contact_correlation(study, found)
    if np.isfinite(correlation):
        yield f"{study.own_numbers[0].label} and contact point are correlated by {correlation:.2f}."
    for shares in result.further.shares:
        for free in study.own_numbers:
            number = abs(found.value(free.path)) or 1.0
            by_noise, by_calibration = found.error(free.path) / number, shares.error(free.path) / number
            yield (
                f"Standard error of {free.label}: {by_noise:.2%} by noise, {by_calibration:.2%} by the calibration; "
                "the interval holds both."
            )
    for series in result.further.depths:
        yield f"{study.own_numbers[0].label} over depth: {series.verdict}."
    if study.models:
        yield compared(study, found, result.further).verdict


def population_of(outcome: FitOutcome, free: Free, results: Sequence[Fitted] = ()) -> Population | tuple[()]:
    """Return the mean of a number over curves; empty for fewer than three."""
    results = results or outcome.independent
    fits = [result.fit for result in results]
    values, errors = np.array([[fit.value(free.path), fit.error(free.path)] for fit in fits]).T
    logarithmic = all(fit.logarithmic[fit.index(free.path)] for fit in fits) and bool(np.all(values > 0.0))
    if len(fits) < FEWEST_TOGETHER or not np.all(np.isfinite(errors)):
        return ()
    shared = common_calibration(fits, [one.further for one in results], free.path)
    try:
        return population(values, errors, logarithmic=logarithmic, calibration=shared if logarithmic else 0.0)
    except InvalidInput:
        return ()


def _of_many(outcome: FitOutcome, free: Free) -> Iterator[str]:
    made = population_of(outcome, free)
    if not isinstance(made, Population):
        return
    unit = outcome.study.word(free.key).unit
    shown = functools.partial(with_unit, unit=unit, digits=4)
    low, high = made.interval()
    between, within = ((f"{part:.1%}" if made.logarithmic else shown(part)) for part in (made.between, made.within))
    calibrated = f", with {made.calibration:.1%} by the calibration that they share" if made.calibration else ""
    yield (
        f"Mean of {free.label} over {made.count} curves: {shown(made.mean)} (95 %: {shown(low)} to "
        f"{shown(high)}{calibrated}); they scatter by {between} beyond their errors of {within}."
    )
    if made.overstated:
        yield f"The curves scatter less in {free.label} than their errors allow: the interval is that of the scatter."
    if made.doubted:
        yield (
            f"The error of {free.label} is less than a tenth of the others', or unknown. It was replaced by theirs, "
            f"since it would decide the mean: {_names(outcome, made.doubted)}."
        )
    for place in made.decisive:
        name, share = outcome.independent[place].name, made.weights[place]
        yield f"{name} alone has {share:.0%} of the weight in the mean of {free.label}."
    if made.logarithmic:
        yield from _groups(outcome, free)


def _names(outcome: FitOutcome, places: Sequence[int]) -> str:
    """Return the names of some curves, the first few of many."""
    more = f" and {len(places) - MOST_NAMES} more" if len(places) > MOST_NAMES else ""
    return ", ".join(outcome.independent[place].name for place in places[:MOST_NAMES]) + more


def groups_of(outcome: FitOutcome) -> dict[str, list[Fitted]]:
    """Return the curves of each folder; empty if they lie in one."""
    groups: dict[str, list[Fitted]] = {}
    for result in outcome.independent:
        groups.setdefault(result.name.rpartition("/")[0], []).append(result)
    return groups if len(groups) > 1 else {}


def _groups(outcome: FitOutcome, free: Free) -> Iterator[str]:
    """Yield the ratios of the folders to the first of them."""
    means = {name: population_of(outcome, free, results) for name, results in groups_of(outcome).items()}
    usable = [(name, mean) for name, mean in means.items() if isinstance(mean, Population) and mean.logarithmic]
    for name, mean in usable[1:MOST_GROUPS]:
        first = usable[0]
        found = ratio_of(mean, first[1])
        verdict_ = "they differ" if found.differ else "no difference is shown"
        yield (
            f"{free.label} in {name} over that in {first[0]}: {found.ratio:.3g} (95 %: {found.low:.3g} to "
            f"{found.high:.3g}); {verdict_}."
        )


def _counts(outcome: FitOutcome) -> Iterator[str]:
    """Yield in how many curves a number is constant over depth, and what they say of the models."""
    study = outcome.study
    series = [one for result in outcome.fitted for one in result.further.depths]
    if series:
        constant = sum(one.constant for one in series)
        name = study.own_numbers[0].label
        yield f"{name} over depth is constant within its errors in {constant} of {len(series)} curves."
    if not study.models:
        return
    comparisons = [compared(study, result.fit, result.further) for result in outcome.fitted]
    for name in (study.model, *(one.name for one in study.models)):
        told = sum(one.decided and one.models[0] == name for one in comparisons)
        possible = sum(name in one.possible for one in comparisons)
        unfitted = sum(name in one.unfitted for one in comparisons) + len(outcome.refused)
        more = f", not fitted in {unfitted}" if unfitted else ""
        count = f"{len(comparisons) + len(outcome.refused)} curves"
        yield f"Model '{name}': distinguished from all others in {told}, possible in {possible} of {count}{more}."
    if outcome.refused:
        names = [_refused(one) for one in outcome.refused[:MOST_NAMES]]
        more = f" and {len(outcome.refused) - MOST_NAMES} more" if len(outcome.refused) > MOST_NAMES else ""
        yield f"Not compared, as no model could be fitted: {', '.join(names)}{more}."


def _refused(result: Refused) -> str:
    """Return the name of a curve that could not be fitted, with the flag that says why, if there is one."""
    found = FLAGGED.match(result.reason)
    return f"{result.name} ({found[1]})" if found else result.name


def _shared(outcome: FitOutcome) -> Iterator[str]:
    keys = {free.path: free for free in outcome.study.free}
    for joint in outcome.joint:
        for name in joint.names:
            unit = outcome.study.word(keys[name].key).unit
            fits, furthers = joint.fits, [result.further for result in outcome.independent]
            calibration = common_calibration(fits, furthers, name)
            low, high = (with_unit(end, unit, 5) for end in _with_calibration(joint, name, calibration))
            calibrated = f", with {calibration:.1%} by the calibration that they share" if calibration else ""
            yield (
                f"Shared by {len(fits)} curves: {keys[name].label} is {with_unit(joint.value(name), unit, 5)} "
                f"(95 %: {low} to {high}{calibrated})."
            )
        yield from (str(flag) for flag in joint.flags)
    if outcome.joint_failure:
        yield f"Not done: the curves were not fitted together: {outcome.joint_failure}"


def _with_calibration(joint: JointFit, name: str, calibration: float) -> tuple[float, float]:
    """Return the interval of a shared number with the relative error of the calibration."""
    number, ends = joint.value(name), joint.interval(name)
    if not (calibration and joint.logarithmic[joint.index(name)]):
        return ends
    by_calibration = quantile(math.inf, CONFIDENCE) * calibration
    below, above = (math.hypot(math.log(end / number), by_calibration) for end in ends)
    return number * math.exp(-below), number * math.exp(above)
