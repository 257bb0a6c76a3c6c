"""The headline of an outcome as HTML: one sentence, the sought numbers as cards, the elastic contact beside them."""

from __future__ import annotations

import dataclasses
import math
import re
from typing import Any

import numpy as np

from winkler.media.halfspace import HomogeneousMedium
from winkler.problems.normal.strong_parts import strong_parts
from winkler.study.batch.outcome import Outcome
from winkler.study.chapters.contents import answer_of
from winkler.study.language.catalogue import CATALOGUE
from winkler.study.report.describe import settings_text
from winkler.study.report.figure import capital
from winkler.study.report.headline.advice import ADVICE, Doubt, worst_doubt
from winkler.study.report.headline.elastic_state import ElasticState, elastic_state, unknown_because
from winkler.study.report.headline.numbers import SoughtNumber, as_share, sought_numbers
from winkler.study.report.headline.shown_contact import (
    medium_of,
    most_pressed,
    shown_contact,
    shown_point,
)
from winkler.study.report.headline.summary import WORDS, numbers_of_contact
from winkler.study.report.markup import badge, safe, with_fixed_units
from winkler.study.report.mathml import symbol
from winkler.values.errors import WinklerError
from winkler.values.readable import with_readable_numbers, with_unit
from winkler.values.validity import Assumption, Standing

MOST_POINTS = 24
"""Points of a sweep up to which all of them are compared with their strength."""
VON_MISES = r"\sigma_{vM}"
YIELDED = f"What to do: {ADVICE[Assumption.ELASTIC]}."


def headline_section(outcome: Outcome) -> str:
    """Return the headline of an outcome; nothing where no number was found.

    Parameters
    ----------
    outcome
        Outcome of a study.
    """
    numbers = sought_numbers(outcome)
    if not numbers:
        return ""
    verdict, sentence = _verdict(outcome), _lead(outcome, numbers)
    if verdict:
        sentence = f"The verdict on the body: {verdict}. {sentence}"
    outside = doubt_of(outcome).standing is Standing.OUTSIDE
    mark = f" {badge(outcome.validity)}" if outside else ""
    lead = f'<p class="{"" if outside else "lead "}sought-line">{with_fixed_units(sentence)}{mark}</p>'
    counts = not verdict and not outside  # what is not to be used is never the large number
    cards = "".join(_card(one, mark, first=counts and place == 0) for place, one in enumerate(numbers))
    if verdict:
        large = f'<div class="value">{safe(verdict)}</div><div class="name">verdict on the body</div>'
        cards = f'<div class="card sought">{large}</div>{cards}'
    shown = {one.name for one in numbers if not one.is_range}
    if "z" in outcome.answers:  # the answer itself is a place of the greatest stress
        shown |= {"von_mises"}
    return f'{lead}<div class="cards">{cards}</div>{_beside(outcome, shown)}'


def headline(outcome: Outcome) -> str:
    """Return the headline of an outcome as text: the sought number, and how far the contact is from yielding.

    Parameters
    ----------
    outcome
        Outcome of a study.
    """
    numbers = sought_numbers(outcome)
    if not numbers:
        return ""
    return with_readable_numbers(_lead(outcome, numbers))


def _lead(outcome: Outcome, numbers: tuple[SoughtNumber, ...]) -> str:
    """Return the sought number in a sentence, and how far the contact is from yielding unless that was sought."""
    is_sought = bool(answer_of(shown_point(outcome).problem).event)
    is_sought |= any(one.name == "von_mises" for one in numbers)
    return f"{_sentence(outcome, numbers)} {'' if is_sought else _margin(outcome)}".rstrip()


def _state(outcome: Outcome) -> ElasticState | None:
    return None if outcome.study.sweep else elastic_state(shown_point(outcome))


def _margin(outcome: Outcome) -> str:
    """Return how far a contact is from yielding as a sentence; empty where that is not known.

    Of a sweep it is the point that is nearest to yielding, of one with many points that which is pressed most.
    """
    if not outcome.study.sweep:
        state = elastic_state(shown_point(outcome))
        return _margin_of(state) if state else ""
    strong = [point for point in outcome.solved if strong_parts(medium_of(point.problem))]
    if not strong or outcome.study.design.draws:
        return ""
    points = strong if len(strong) <= MOST_POINTS else [most_pressed(strong, [one.readable for one in strong])]
    states = [(state, point) for point in points if (state := elastic_state(point)) and math.isfinite(state.strength)]
    if not states:
        return ""
    state, nearest = min(states, key=lambda one: one[0].margin)
    which = "nearest to yielding" if len(points) == len(strong) else "pressed most"
    sentence = _margin_of(state)
    return sentence and f"The point {settings_text(outcome.study, nearest.settings)} is {which}: i{sentence[1:]}"


def _margin_of(state: ElasticState) -> str:
    """Return at which multiple of its load a contact yields, or its stress over the strength, and where."""
    if math.isinf(state.strength) or state.sharp or not 0.0 < state.margin < math.inf:
        return ""
    if math.isnan(state.depth):
        return f"Its greatest load is {1.0 / state.margin:.3g} times that of the first yield."
    if math.isnan(state.yield_load) and state.margin > 1.0:
        return f"Its greatest stress is {state.share:.3g} of the strength, {state.place()}."
    if math.isnan(state.yield_load):
        return f"It has yielded: its greatest elastic stress is {state.share:.3g} times the strength, {state.place()}."
    return (
        f"It yields at {state.margin:.3g} times this load, {state.place()}."
        if state.margin > 1.0
        else f"It has yielded: this is {1.0 / state.margin:.3g} times the load at which it does, {state.place()}."
    )


def _verdict(outcome: Outcome) -> str:
    """Return what kind of body a measurement speaks for, as held contacts do; empty where that is not asked."""
    point = shown_point(outcome)
    name = answer_of(point.problem).verdict
    return str(getattr(point.solution, name)) if name else ""


def doubt_of(outcome: Outcome) -> Doubt:
    """Return the worst statement on an outcome, with what to do about it.

    Parameters
    ----------
    outcome
        Outcome of a study.
    """
    point = shown_point(outcome)
    doubt = worst_doubt(outcome.validity, None if outcome.study.sweep else shown_contact(point))
    if doubt.advice != YIELDED or not (further := _followed_beyond_yield(point.problem)):
        return doubt
    return doubt._replace(
        advice=f"What to do: solve it as {further}, which follows the metal beyond its elastic limit."
    )


def _followed_beyond_yield(problem: Any) -> str:
    """Return the kind that answers the same question where a metal yields; empty where none takes these bodies."""
    name = answer_of(problem).beyond
    if not name or not isinstance(problem.bed.medium, HomogeneousMedium):  # dents in layers are not followed
        return ""
    further = CATALOGUE["problem"][name].cls
    given = {field.name: getattr(problem, field.name, None) for field in dataclasses.fields(further)}
    if "path" in given:
        given["path"] = type(problem.load)(np.ravel(*dataclasses.astuple(problem.load)))
    try:
        further(**{name: part for name, part in given.items() if part is not None})
    except WinklerError:
        return ""
    return name


def doubt_line(doubt: Doubt) -> str:
    """Return the worst statement and what to do about it as a line of a page; nothing where nothing is to be said."""
    said = with_fixed_units(capital(doubt.statement))
    if doubt.advice:
        return f'<p class="doubt">{said} <strong>{safe(doubt.advice)}</strong></p>'
    return f'<p class="since">{said}</p>' if said else ""


def _sentence(outcome: Outcome, numbers: tuple[SoughtNumber, ...]) -> str:
    """Return what was sought with its unit in one sentence."""
    sought = numbers[0]
    given = [one for one in numbers[1:] if one.prescribed and not one.many and one.last != 0.0]
    how = "under" if given and "force" in given[0].label else "with"
    under = f" {how} a {' and a '.join(f'{one.label} of {one.text}' for one in given)}" if given else ""
    record = answer_of(shown_point(outcome).problem)
    where, all_points = "", ""
    if sought.is_range:
        where = f"over {len(outcome.points)} points " if outcome.study.sweep else "along the curve "
        if (
            outcome.study.sweep and not under and sought.end.endswith(",")
        ):  # each point has an answer for each of many loads
            where += f"and {sought.end} "
    elif outcome.study.sweep and len(outcome.solved) > 1:
        all_points = f" at all {len(outcome.solved)} points"
    whole = sought.is_range or sought.ends_at_zero or outcome.study.sweep  # of a sweep other numbers may vary
    clause = "" if whole else _clause(outcome, record.says.get(sought.name, ""))
    comma = "," if under and "," in clause else ""
    return capital(f"{where}{sought.sentence(record.event, clause)}{comma}{under}{all_points}.")


def _clause(outcome: Outcome, template: str) -> str:
    """Return a clause of the record with the last numbers of an outcome; empty where one of them is not known."""
    answers = numbers_of_contact(outcome.solved[-1])
    said = template
    for whole, name, how in re.findall(r"({(\w+):?([%\w]*)})", template):
        if name in answers:
            entry = outcome.word(name) if name in outcome.answers else WORDS[name]
            number, unit = float(np.ravel(answers[name])[-1]), entry.unit or ""
        else:
            number = math.nan
        if math.isnan(number):
            return ""
        if how == "%":
            text = as_share(number)
        elif how == "below":
            text = f"{with_unit(abs(number), 'm', 2)} below the surface" if number else "at the surface"
        else:
            text = with_unit(abs(number) if how == "size" else number, unit)
        said = said.replace(whole, text)
    return said


def _card(one: SoughtNumber, mark: str, *, first: bool) -> str:
    meaning = f'<div class="name">{safe(one.word.meaning)}</div>' if first else ""
    remark = f'<div class="name">{safe(one.remark)}</div>' if one.remark else ""
    return (
        f'<div class="{"card sought" if first else "card"}"><div class="value">{safe(one.text)}{mark}</div>'
        f'<div class="name">{safe(one.label)} {symbol(one.word.symbol)}</div>{remark}{meaning}</div>'
    )


def _beside(outcome: Outcome, shown: set[str]) -> str:
    """Return greatest pressure, greatest von Mises stress and load of yield as cards, or why they are not known."""
    state = _state(outcome)
    if state is None:
        reason = "" if outcome.study.sweep or "von_mises" in shown else unknown_because(shown_point(outcome))
        card = _small("not computed", "stresses in the bodies", reason)
        return f'<div class="cards beside">{card}</div>' if reason else ""
    cards = []
    if "peak_pressure" not in shown and not math.isnan(state.peak_pressure):
        pressure = with_unit(state.peak_pressure, "Pa")
        cards.append(_small(pressure, f"greatest pressure {symbol('p_0')}", ""))
    if "von_mises" in shown:
        return f'<div class="cards beside">{"".join(cards)}</div>' if cards else ""
    around = f"; {state.sharp}, and this one is a tenth of the contact radius away" if state.sharp else ""
    stress = f"greatest von Mises stress {symbol(VON_MISES)}"
    cards.append(_small(with_unit(state.von_mises, "Pa"), stress, f"{state.place(3)}, {state.under}{around}"))
    cards.append(_yield_card(state))
    return f'<div class="cards beside">{"".join(cards)}</div>'


def _yield_card(state: ElasticState) -> str:
    name = "load at which it yields"
    if math.isinf(state.strength):
        what = "how much of it is reached" if math.isnan(state.load) else "it"
        return _small("not known", name, f"set a strength of the {state.body} to see {what}")
    if math.isnan(state.yield_load):
        said = f"the greatest stress is {state.share:.3g} of the strength of the {state.body}"
        return _small("not known", name, said)
    if state.sharp:
        return _small(with_unit(0.0, state.unit), name, "a sharp place yields at the first touch")
    times = f"{state.margin:.3g} times this load; " if math.isfinite(state.margin) else ""
    return _small(with_unit(state.yield_load, state.unit), name, f"{times}of the {state.body}, by von Mises' criterion")


def _small(text: str, name: str, remark: str) -> str:
    said = f'<div class="name">{safe(remark)}</div>' if remark else ""
    return f'<div class="card"><div class="value">{safe(text)}</div><div class="name">{name}</div>{said}</div>'
