"""The headline of an outcome as HTML: one sentence, the sought numbers as cards, the elastic contact beside them."""

from __future__ import annotations

import dataclasses
import math
import re
from typing import Any

import numpy as np

from winkler.media.halfspace import HomogeneousMedium
from winkler.study.batch.outcome import Outcome
from winkler.study.chapters.contents import answer_of
from winkler.study.language.catalogue import CATALOGUE
from winkler.study.report.figure import capital
from winkler.study.report.headline.advice import ADVICE, Doubt, worst_doubt
from winkler.study.report.headline.declared import WORDS, numbers_of_contact
from winkler.study.report.headline.elastic_state import ElasticState, elastic_state
from winkler.study.report.headline.numbers import SoughtNumber, as_share, sought_numbers
from winkler.study.report.headline.shown_contact import shown_contact, shown_point
from winkler.study.report.markup import badge, safe, with_fixed_units
from winkler.study.report.mathml import symbol
from winkler.values.errors import WinklerError
from winkler.values.readable import with_readable_numbers, with_unit
from winkler.values.validity import Assumption, Standing

__all__ = ["doubt_line", "doubt_of", "headline", "headline_section"]

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
    verdict, state = _verdict(outcome), _state(outcome)
    sentence = _lead(outcome, numbers, state)
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
    return f'{lead}<div class="cards">{cards}</div>{_beside(state, shown, _force(numbers))}'


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
    return with_readable_numbers(_lead(outcome, numbers, _state(outcome)))


def _lead(outcome: Outcome, numbers: tuple[SoughtNumber, ...], state: ElasticState | None) -> str:
    """Return the sought number in a sentence, and how far the contact is from yielding unless that was sought."""
    is_sought = bool(answer_of(shown_point(outcome).problem).event)
    margin = _margin(state, _force(numbers)) if state and not is_sought else ""
    return f"{_sentence(outcome, numbers)} {margin}".rstrip()


def _state(outcome: Outcome) -> ElasticState | None:
    return None if outcome.study.sweep else elastic_state(shown_point(outcome))


def _force(numbers: tuple[SoughtNumber, ...]) -> float:
    """Return the one normal force of a headline [N, N/m]; not a number where there are several, or none."""
    forces = [one.last for one in numbers if one.name in ("force", "force_per_length") and not one.many]
    return forces[0] if len(forces) == 1 else math.nan


def _margin(state: ElasticState, force: float) -> str:
    """Return at which multiple of its load a contact yields, and where, as a sentence; empty where it is not known."""
    if not (state.yield_load > 0.0 and force > 0.0):
        return ""
    times = state.yield_load / force
    under = f"{with_unit(state.depth, 'm', 2)} below the surface, {state.body}"
    return (
        f"It yields at {times:.3g} times this load, {under}."
        if times > 1.0
        else (f"It has yielded: this is {1.0 / times:.3g} times the load at which it does, {under}.")
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
    clause = "" if sought.is_range or sought.ends_at_zero else _clause(outcome, record.says.get(sought.name, ""))
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


def _beside(state: ElasticState | None, shown: set[str], force: float) -> str:
    """Return greatest pressure, greatest von Mises stress and load of yield as cards."""
    if state is None:
        return ""
    cards = []
    if "peak_pressure" not in shown:
        pressure = with_unit(state.peak_pressure, "Pa")
        cards.append(_small(pressure, f"greatest pressure {symbol('p_0')}", ""))
    if "von_mises" in shown:
        return f'<div class="cards beside">{"".join(cards)}</div>' if cards else ""
    where = f"{with_unit(state.depth, 'm', 3)} below the surface, {state.body}"
    around = f"; {state.sharp}, and this one is a tenth of the contact radius away" if state.sharp else ""
    stress = f"greatest von Mises stress {symbol(VON_MISES)}"
    cards.append(_small(with_unit(state.von_mises, "Pa"), stress, f"{where}, without friction{around}"))
    cards.append(_yield_card(state, force))
    return f'<div class="cards beside">{"".join(cards)}</div>'


def _yield_card(state: ElasticState, force: float) -> str:
    name = "load at which it yields"
    if math.isinf(state.strength):
        return _small("not known", name, f"set a strength of the {state.body} to see it")
    if math.isnan(state.yield_load):
        share = state.von_mises / state.strength
        return _small("not known", name, f"the greatest stress is {share:.3g} of the strength of the {state.body}")
    if state.sharp:
        return _small(with_unit(0.0, state.unit), name, "a sharp place yields at the first touch")
    times = f"{state.yield_load / force:.3g} times this load; " if force > 0.0 else ""
    return _small(with_unit(state.yield_load, state.unit), name, f"{times}of the {state.body}, by von Mises' criterion")


def _small(text: str, name: str, remark: str) -> str:
    said = f'<div class="name">{safe(remark)}</div>' if remark else ""
    return f'<div class="card"><div class="value">{safe(text)}</div><div class="name">{name}</div>{said}</div>'
