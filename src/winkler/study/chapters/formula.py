"""A formula of the report."""

from __future__ import annotations

from typing import NamedTuple

__all__ = ["Formula"]


class Formula(NamedTuple):
    """A formula and what it says.

    Parameters
    ----------
    says
        One sentence.
    latex
        For `winkler.study.report.mathml.formula`.
    """

    says: str
    latex: str
