"""Kinds of frictional heating: how heat is shared, and what is asked."""

from __future__ import annotations

from typing import Any

from winkler.study.chapters.kind import Kind, kind

__all__ = ["HEATING"]

STEEL = {"kind": "thermal_conductor", "conductivity": "45 W/(m K)", "diffusivity": "12 mm^2/s"}
STEELS: dict[str, Any] = {"kind": "heat_conductors", "first": STEEL, "second": STEEL}
COULOMB = {"kind": "coulomb", "coefficient": 0.3}
TWICE = [
    {"kind": "start", "normal": {"kind": "force", "force": "100 N"}},
    {"kind": "oscillate", "lateral": {"kind": "shift", "shift": "1 um"}, "cycles": 2.0},
]

HEATING: dict[str, dict[str, Kind]] = {
    "partition": {
        "equal_maximum": kind("winkler.laws.heat:EqualMaximum", "blok_1963"),
        "equal_mean": kind("winkler.laws.heat:EqualMean", "jaeger_1942"),
        "fixed_share": kind("winkler.laws.heat:FixedShare", first_share=0.5),
    },
    "problem": {
        "friction_heating": kind(
            "winkler.problems.heating.steady:FrictionHeating",
            law=COULOMB,
            load={"kind": "force", "force": "20 N"},
            conductors=STEELS,
            first_speed="1 m/s",
        ),
        "transient_heating": kind(
            "winkler.problems.heating.transient:TransientHeating",
            law=COULOMB,
            load={"kind": "force", "force": "20 N"},
            conductors=STEELS,
            speed="10 mm/s",
            time={"from": "10 us", "to": "1 s", "count": 16, "spacing": "log"},
        ),
        "fretting_heat": kind(
            "winkler.problems.heating.fretting:FrettingHeat",
            motion={"kind": "tangential", "law": COULOMB, "path": {"kind": "program", "steps": TWICE}},
            frequency="100 Hz",
            conductors=STEELS,
        ),
    },
}
"""Slot -> kind -> class."""
