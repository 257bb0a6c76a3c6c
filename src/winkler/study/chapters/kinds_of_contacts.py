"""Kinds of contacts without friction: loads, adhesion, and what is asked."""

from __future__ import annotations

from winkler.laws.adhesion import DerjaguinMullerToporov, Dugdale, ShortRange
from winkler.loading import Depth, Force, Radius
from winkler.problems.adhesion.cycle import AdhesiveCycle
from winkler.problems.adhesion.equilibrium import Equilibrium
from winkler.problems.adhesion.indentation import AdhesiveIndentation
from winkler.problems.adhesion.pull_off import PullOff
from winkler.problems.adhesion.shear import AdhesiveShear
from winkler.problems.normal.indentation import Indentation
from winkler.problems.normal.yielding import YieldOnset
from winkler.study.chapters.kind import Kind, kind

__all__ = ["CONTACTS"]

THERE_AND_BACK = [
    {"from": "-5 nm", "to": "5 nm", "count": 41},
    {"from": "5 nm", "to": "-5 nm", "count": 41},
]
STRONG = {"first": {"kind": "elastic", "young": "210 GPa", "poisson": 0.3, "strength": "700 MPa"}}

CONTACTS: dict[str, dict[str, Kind]] = {
    "law": {
        "short_range": kind(ShortRange, "johnson_kendall_roberts_1971", work="50 mJ/m^2"),
        "dugdale": kind(Dugdale, "maugis_1992", work="50 mJ/m^2", strength="1 MPa"),
        "derjaguin_muller_toporov": kind(DerjaguinMullerToporov, "derjaguin_1975", work="50 mJ/m^2"),
    },
    "load": {
        "force": kind(Force, force="100 N"),
        "depth": kind(Depth, depth="5 um"),
        "radius": kind(Radius, radius="0.1 mm"),
    },
    "problem": {
        "indentation": kind(Indentation, "popov_hess_2015", "galin_1946", "sneddon_1965", "jaeger_1995"),
        "yield_onset": kind(
            YieldOnset,
            "johnson_1985",
            "popov_hess_2015",
            bed={"kind": "foundation", "medium": {"kind": "half_space", **STRONG}},
        ),
        "adhesive_indentation": kind(
            AdhesiveIndentation, "popov_hess_2015", "johnson_kendall_roberts_1971", "maugis_1992"
        ),
        "pull_off": kind(PullOff, "popov_hess_2015", "johnson_kendall_roberts_1971"),
        "equilibrium": kind(
            Equilibrium, "popov_hess_2015", "johnson_kendall_roberts_1971", "guduru_2007", reach="10 um", count=200
        ),
        "adhesive_cycle": kind(
            AdhesiveCycle,
            "popov_hess_2015",
            "johnson_kendall_roberts_1971",
            "guduru_2007",
            path={"kind": "depth", "depth": THERE_AND_BACK},
        ),
        "adhesive_shear": kind(
            AdhesiveShear,
            "popov_hess_2015",
            "savkoor_briggs_1977",
            normal={"kind": "force", "force": "100 N"},
            lateral={"kind": "shear_force", "shear_force": "1 mN"},
        ),
    },
}
"""Slot -> kind -> class."""
