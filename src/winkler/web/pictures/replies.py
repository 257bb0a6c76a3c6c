"""What the process of a page replies with; the page imports these alone, and nothing that solves or draws."""

from __future__ import annotations

from typing import NamedTuple


class NamedNumber(NamedTuple):
    """One number of an answer: name, LaTeX symbol, unit, and the number in SI units."""

    name: str
    symbol: str
    unit: str
    number: float


class AnswerText(NamedTuple):
    """The results as text.

    Parameters
    ----------
    standing
        The worst standing of all notes.
    trust
        What a user may do with the results, as the page shows it.
    answers, notes, papers
        Sections of a page.
    text
        The study as a file.
    moments, moment
        Number of moments of the results, zero without a history; and the first one shown.
    points
        Of a sweep.
    doubt
        The worst statement on the results, and what to do about it; empty where nothing is doubtful.
    numbers
        For comparing this answer with another one: the last row of its table.
    curves
        Of several fitted curves, a list of them.
    labels
        What each moment is: its time, or another number with its unit; or the name of a fitted curve.
    """

    standing: str
    trust: str
    answers: str
    notes: str
    papers: str
    text: str
    moments: int
    moment: int
    points: int = 1
    doubt: str = ""
    numbers: tuple[NamedNumber, ...] = ()
    curves: str = ""
    labels: tuple[str, ...] = ()


class InteractivePicture(NamedTuple):
    """One interactive picture, or the reason for its absence.

    Parameters
    ----------
    name, title, sentence
        Name, title and caption.
    chart
        The figure for plotly.js as JSON; empty where there is none.
    missing
        The reason for its absence.
    """

    name: str
    title: str
    sentence: str
    chart: str
    missing: str = ""


class MomentComplete(NamedTuple):
    """Marks the end of the interactive pictures of one moment.

    Parameters
    ----------
    total
        Their number.
    remark
        Remark on all of them.
    """

    total: int
    remark: str


class DrawnSheet(NamedTuple):
    """One sheet as SVG, or the reason for its absence."""

    title: str
    sentence: str
    svg: str
    missing: str = ""


class File(NamedTuple):
    """A file for download."""

    name: str
    content: bytes


class InspectedFile(NamedTuple):
    """What an uploaded file is taken for.

    Parameters
    ----------
    name
        Of the file.
    html
        The page that says it.
    study
        A study to start from; empty where there is none.
    shown
        Whether the form of the app can show that study.
    """

    name: str
    html: str
    study: str
    shown: bool
