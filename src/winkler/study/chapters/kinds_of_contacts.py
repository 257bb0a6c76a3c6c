"""Kinds of contacts without friction: loads, adhesion, and what is asked."""

from __future__ import annotations

from winkler.study.chapters.kind import Kind, kind

__all__ = ["CONTACTS"]

THERE_AND_BACK = [
    {"from": "-5 nm", "to": "5 nm", "count": 41},
    {"from": "5 nm", "to": "-5 nm", "count": 41},
]
STRONG = {"first": {"kind": "elastic", "young": "210 GPa", "poisson": 0.3, "strength": "700 MPa"}}

CONTACTS: dict[str, dict[str, Kind]] = {
    "law": {
        "short_range": kind("winkler.laws.adhesion:ShortRange", "johnson_kendall_roberts_1971", work="50 mJ/m^2"),
        "dugdale": kind("winkler.laws.adhesion:Dugdale", "maugis_1992", work="50 mJ/m^2", strength="1 MPa"),
        "derjaguin_muller_toporov": kind(
            "winkler.laws.adhesion:DerjaguinMullerToporov", "derjaguin_1975", work="50 mJ/m^2"
        ),
    },
    "load": {
        "force": kind("winkler.loading:Force", force="100 N"),
        "depth": kind("winkler.loading:Depth", depth="5 um"),
        "radius": kind("winkler.loading:Radius", radius="0.1 mm"),
    },
    "problem": {
        "indentation": kind(
            "winkler.problems.normal.indentation:Indentation",
            "popov_hess_2015",
            "galin_1946",
            "sneddon_1965",
            "jaeger_1995",
        ),
        "yield_onset": kind(
            "winkler.problems.normal.yielding:YieldOnset",
            "johnson_1985",
            "popov_hess_2015",
            bed={"kind": "foundation", "medium": {"kind": "half_space", **STRONG}},
        ),
        "adhesive_indentation": kind(
            "winkler.problems.adhesion.indentation:AdhesiveIndentation",
            "popov_hess_2015",
            "johnson_kendall_roberts_1971",
            "maugis_1992",
        ),
        "pull_off": kind(
            "winkler.problems.adhesion.pull_off:PullOff", "popov_hess_2015", "johnson_kendall_roberts_1971"
        ),
        "equilibrium": kind(
            "winkler.problems.adhesion.equilibrium:Equilibrium",
            "popov_hess_2015",
            "johnson_kendall_roberts_1971",
            "guduru_2007",
            reach="10 um",
            count=200,
        ),
        "adhesive_cycle": kind(
            "winkler.problems.adhesion.cycle:AdhesiveCycle",
            "popov_hess_2015",
            "johnson_kendall_roberts_1971",
            "guduru_2007",
            path={"kind": "depth", "depth": THERE_AND_BACK},
        ),
        "adhesive_shear": kind(
            "winkler.problems.adhesion.shear:AdhesiveShear",
            "popov_hess_2015",
            "savkoor_briggs_1977",
            normal={"kind": "force", "force": "100 N"},
            lateral={"kind": "shear_force", "shear_force": "1 mN"},
        ),
    },
}
"""Slot -> kind -> class."""
