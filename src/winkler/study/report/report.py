"""The report of a study: figures as files, and one page that holds everything and needs nothing else."""

from __future__ import annotations

import re
from pathlib import Path

from winkler.plot.series import told
from winkler.problems.adhesion.cycle import AdhesiveCycleSolution
from winkler.problems.adhesion.equilibrium import EquilibriumCurve
from winkler.problems.adhesion.pull_off import PullOffSolution
from winkler.problems.adhesion.shear import AdhesiveShearSolution
from winkler.problems.friction.bimodal_damping import BimodalDampingSolution
from winkler.problems.friction.damping import FrictionDampingSolution
from winkler.problems.friction.relaxation_damping import RelaxationDamperSolution
from winkler.problems.friction.tangential import TangentialSolution
from winkler.problems.friction.torsion import TorsionSolution
from winkler.problems.impact.adhesive_impact import AdhesiveImpactSolution
from winkler.problems.impact.impact import ImpactSolution
from winkler.problems.rolling.oscillating import OscillatingRollingSolution
from winkler.problems.rolling.start import RollingStartSolution
from winkler.problems.rolling.steady import RollingSolution
from winkler.study.batch.outcome import Outcome
from winkler.study.chapters.answer_curves import WITHOUT_CONTACT
from winkler.study.chapters.formulas import formulas_of
from winkler.study.language.reading import study_text
from winkler.study.report import page_parts as parts
from winkler.study.report.archive import CSV, NETCDF
from winkler.study.report.figures import Shown, figures_of, shown_contact, shown_point
from winkler.study.report.markup import safe, section
from winkler.study.report.tables import answered, asked, expected, failures, settings_told
from winkler.validity import Standing, worst

__all__ = ["page", "write"]

OF_MANY: dict[type, str] = {
    AdhesiveCycleSolution: "the widest contact of the cycle",
    EquilibriumCurve: "the widest stable contact of the curve",
    PullOffSolution: "the contact just before it comes apart",
    AdhesiveShearSolution: "the contact under the last load, its springs along the surface left out",
    FrictionDampingSolution: "the contact under its normal load, its springs along the surface left out",
    BimodalDampingSolution: "the contact at its greatest depth, its springs along the surface left out",
    RelaxationDamperSolution: "the contact at its greatest depth, its springs along the surface left out",
    TangentialSolution: "the contact at its greatest depth, its springs along the surface left out",
    TorsionSolution: "the contact at its greatest depth, its twist left out",
    ImpactSolution: "the contact at its greatest depth, its springs along the surface left out",
    AdhesiveImpactSolution: "the contact at its greatest depth, without the attraction",
    RollingSolution: "the contact under its normal load, its springs along the surface left out",
    RollingStartSolution: "the contact under its normal load, its springs along the surface left out",
    OscillatingRollingSolution: "the contact under its normal load, its springs along the surface left out",
}
"""Which contact is shown of an answer that holds many."""


def write(outcome: Outcome, folder: Path) -> None:
    """Write the figures of a study and its report.

    Parameters
    ----------
    outcome
        What a study came to.
    folder
        Must exist. Figures go into its folder ``figures``, in the formats that the study's output names; the report,
        unless the study's output declines it, into ``report.html``.
    """
    parts.write_page(outcome, folder, figures_of(outcome), page)


def page(outcome: Outcome, shown: tuple[Shown, ...] | None = None) -> str:
    """Return the report as one HTML page.

    Parameters
    ----------
    outcome
        What a study came to.
    shown
        Its figures; drawn if left out.
    """
    study = outcome.study
    title = safe(study.title or outcome.provenance.source or "A study")
    pictures = figures_of(outcome) if shown is None else shown
    notes = outcome.validity
    body = [
        f"<header><h1>{title}</h1>{_standing_line(outcome, worst(notes))}</header>",
        asked(outcome),
        answered(outcome),
        failures(outcome),
        expected(outcome),
        _pictures(outcome, pictures),
        _formulas(outcome),
        parts.trust(notes),
        parts.papers(outcome.study),
        _provenance(outcome),
    ]
    return parts.framed(title, outcome.provenance.version, body)


def _standing_line(outcome: Outcome, standing: Standing) -> str:
    made = outcome.provenance
    counts = f"{len(outcome.points)} points" if len(outcome.points) > 1 else "one point"
    return (
        f"<p>{parts.badge(standing)} <span class='small'>{parts.MEANINGS[standing]} (the worst of all statements "
        f"below). Solved with winkler {safe(made.version)}, {safe(made.created[:10])}, {counts}.</span></p>"
    )


# ------------------------------------------------------------------------------------------------------ pictures


def _pictures(outcome: Outcome, shown: tuple[Shown, ...]) -> str:
    answers = [one for one in shown if not one.of_method]
    method = [one for one in shown if one.of_method]
    sections = []
    if answers:
        sections.append(section("The answers as curves", parts.figure_elements(answers)))
    if method:
        sections.append(section("The method in pictures", _which(outcome), parts.figure_elements(method)))
    point = shown_point(outcome)
    if shown_contact(point) is None and not isinstance(point.solution, WITHOUT_CONTACT):
        kind = type(point.problem).__name__
        sentence = (
            f"There are no pictures of the method for {kind}: its answer does not tell how the springs are pressed."
        )
        sections.append(section("The method in pictures", f'<p class="missing">{safe(sentence)}</p>'))
    return "\n".join(sections)


def _which(outcome: Outcome) -> str:
    point = shown_point(outcome)
    contact = shown_contact(point)
    where = [settings_told(outcome, point.settings)] if outcome.study.sweep else []
    which = OF_MANY.get(point.answer_type)
    if which and contact is not None:
        where.append(f"{which}, at a depth of {told(float(contact.depth), 'm')}")
    if len(point.each) > 1 and contact is not None and not which:
        where.append(f"load {len(point.each)} of {len(point.each)}, a force of {told(float(contact.force), 'N')}")
    return f"<p>Shown is {safe('; '.join(where))}.</p>" if where else ""


# --------------------------------------------------------------------------------------- formulas, trust, sources


def _formulas(outcome: Outcome) -> str:
    found = formulas_of(shown_point(outcome).problem)
    if not found:
        return section(
            "The formulas", "<p>For this problem the report knows no formulas; the papers below have them.</p>"
        )
    return section("The formulas", parts.formula_list(found))


def _readable(text: str) -> str:
    """Return the text of a study without packed height maps, which nobody reads."""
    return re.sub(r'packed = "([^"]*)"', lambda found: f'packed = "... {len(found[1])} letters, in study.toml"', text)


def _provenance(outcome: Outcome) -> str:
    text = parts.folded("The study as a file; it gives the same numbers again", _readable(study_text(outcome.study)))
    files = f"<p class='small'>All numbers with all digits: {CSV} and {NETCDF}, beside this page.</p>"
    return parts.origin(outcome.provenance, "the question", text, files)
