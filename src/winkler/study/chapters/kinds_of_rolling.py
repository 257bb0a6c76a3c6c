"""Kinds of contacts that roll: creepages, calibrations, elliptic contacts, and what is asked of them."""

from __future__ import annotations

from winkler.study.chapters.kind import Kind, kind

__all__ = ["ROLLING"]

PRESSED = {"kind": "force", "force": "100 N"}
# a kind is not named like the key it stands at: an input model could not tell them apart
CREEPING = {"kind": "creepages", "longitudinal": 0.001}
CURVE = {"kind": "creepages", "longitudinal": {"from": 0.0, "to": 0.006, "count": 25}}

ROLLING: dict[str, dict[str, Kind]] = {
    "creepage": {
        "creepages": kind("winkler.problems.rolling.creepage:Creepage", problem="rolling", longitudinal=0.001),
    },
    "calibration": {
        "kalker": kind("winkler.problems.rolling.calibration:Kalker", "kalker_1990", problem="rolling"),
        "uncalibrated": kind("winkler.problems.rolling.calibration:Uncalibrated", problem="rolling"),
    },
    "footprint": {
        "curved_bodies": kind(
            "winkler.profiles.ellipse:CurvedBodies",
            "johnson_1985",
            problem="simplified_rolling",
            longitudinal_curvature_radius="20 mm",
            lateral_curvature_radius="10 mm",
        ),
        "contact_ellipse": kind(
            "winkler.profiles.ellipse:ContactEllipse",
            problem="simplified_rolling",
            longitudinal_semi_axis="0.2 mm",
            lateral_semi_axis="0.15 mm",
        ),
    },
    "problem": {
        "rolling": kind("winkler.problems.rolling.steady:Rolling", creepage=CURVE, load=PRESSED),
        "simplified_rolling": kind(
            "winkler.problems.rolling.simplified_theory:SimplifiedRolling",
            medium={"kind": "half_space"},
            creepage={"kind": "creepages", "longitudinal": 0.0005, "spin": "5 1/m"},
            load=PRESSED,
        ),
        "rolling_start": kind(
            "winkler.problems.rolling.start:RollingStart", creepage=CREEPING, load=PRESSED, distance="0.6 mm"
        ),
        "oscillating_rolling": kind(
            "winkler.problems.rolling.oscillating:OscillatingRolling",
            amplitude="40 um",
            shear_force="15 N",
            load=PRESSED,
        ),
    },
}
"""Slot -> kind -> class."""
