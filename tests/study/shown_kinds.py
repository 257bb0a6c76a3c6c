"""Which kinds of problems a real browser shows in `.ci/run`; the pictures of the others are among the slow tests."""

from __future__ import annotations

from winkler.study.language.catalogue import CATALOGUE

WHOLE = (
    "line_indentation", "roller_contact", "equilibrium", "tangential", "impact", "creep_test", "constriction",
    "friction_heating", "rolling", "sliding_wear", "surface_contact", "map_stress", "indentation",
)  # fmt: skip
"""A kind of each form of a page: lines, maps, histories, spectra, sheets alone; with the last the next test goes on."""
OTHERS = tuple(kind for kind in CATALOGUE["problem"] if kind not in WHOLE)
SHOWN = (*WHOLE, *OTHERS[::3])
"""They are shown in `.ci/run`, all others before a release."""
