"""Which kinds of problems a real browser draws in `.ci/run`; `test_every_kind.py` computes the pictures of all."""

from __future__ import annotations

from winkler.study.language.catalogue import CATALOGUE

WHOLE = ("line_indentation", "friction_heating", "tangential", "surface_contact", "indentation")
"""A kind of each form of a page: sheets alone, curves, histories, maps; with the last the next test goes on."""
OTHERS = tuple(kind for kind in CATALOGUE["problem"] if kind not in WHOLE)
SHOWN = (*WHOLE, *OTHERS[::3])
"""Their pictures are waited for."""
