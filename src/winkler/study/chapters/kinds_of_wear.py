"""Kinds of wear: how surfaces wear, and what is asked."""

from __future__ import annotations

from winkler.study.chapters.kind import Kind, kind

__all__ = ["WEAR"]

STEEL = {"kind": "archard", "rate": "1e-5 mm^3/(N m)"}
GROWING = [0.0, 100.0, 1000.0, 3000.0, 10000.0]

WEAR: dict[str, dict[str, Kind]] = {
    "wear": {
        "archard": kind("winkler.laws.wear:Archard", "archard_1953", rate="1e-5 mm^3/(N m)"),
        "pair_wear": kind(
            "winkler.laws.wear:PairWear",
            problem="fretting_wear",
            first=STEEL,
            second={"kind": "archard", "rate": "2e-5 mm^3/(N m)"},
        ),
    },
    "problem": {
        "fretting_wear": kind(
            "winkler.problems.wear.fretting:FrettingWear",
            normal={"kind": "force", "force": "100 N"},
            amplitude={"kind": "shift", "shift": "0.5 um"},
            cycles=GROWING,
            count=100,
            tolerance=1e-3,
        ),
        "sliding_wear": kind(
            "winkler.problems.wear.sliding:SlidingWear",
            normal={"kind": "force", "force": "100 N"},
            distance=["0 m", "0.1 m", "0.3 m", "1 m"],
            count=100,
            tolerance=1e-3,
        ),
        "limiting_profile": kind(
            "winkler.problems.wear.limiting_profile:LimitingProfile",
            normal={"kind": "depth", "depth": "1 um"},
            amplitude={"kind": "shift", "shift": "0.2 um"},
        ),
    },
}
"""Slot -> kind -> its line of the catalogue."""
