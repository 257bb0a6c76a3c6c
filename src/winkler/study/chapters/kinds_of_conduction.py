"""Kinds of conduction: conductors, films, what drives a current, and what is asked."""

from __future__ import annotations

from typing import Any

from winkler.study.chapters.kind import Kind, kind

__all__ = ["CONDUCTION"]

SILVER = {"kind": "electrical_conductor", "resistivity": "15.9 nohm m"}
STEEL = {"kind": "thermal_conductor", "conductivity": "45 W/(m K)", "diffusivity": "12 mm^2/s"}
COPPER = {"kind": "electrical_conductor", "resistivity": "16.8 nohm m"}
SILVERS: dict[str, Any] = {"first": SILVER, "second": SILVER}
STEELS: dict[str, Any] = {"first": STEEL, "second": STEEL}

CONDUCTION: dict[str, dict[str, Kind]] = {
    "conductor": {
        "electrical_conductor": kind(
            "winkler.materials.conductor:ElectricalConductor",
            resistivity="15.9 nohm m",
            temperature_coefficient="3.8e-3 1/K",
        ),
        "thermal_conductor": kind(
            "winkler.materials.conductor:ThermalConductor",
            problem="thermal_constriction",
            conductivity="45 W/(m K)",
            diffusivity="12 mm^2/s",
        ),
        "named_electrical_conductor": kind("winkler.materials.named:NamedElectricalConductor", name="copper"),
        "named_thermal_conductor": kind(
            "winkler.materials.named:NamedThermalConductor", problem="thermal_constriction", name="copper"
        ),
        "plated": kind("winkler.materials.conducting_body:Plated", plating=SILVER, thickness="5 um", on=COPPER),
        "rod": kind("winkler.materials.conducting_body:Rod", conductor=SILVER, radius="1 mm", length="10 mm"),
    },
    "pair": {
        "electrical_conductors": kind("winkler.media.conduction.conductors:ElectricalConductors", **SILVERS),
        "heat_conductors": kind("winkler.media.conduction.conductors:HeatConductors", **STEELS),
    },
    "film": {
        "surface_film": kind("winkler.laws.film:SurfaceFilm", area_resistance="1e-12 ohm m^2"),
        "thermal_interface": kind("winkler.laws.film:ThermalInterface", interface_conductance="1e7 W/(m^2 K)"),
    },
    "drive": {
        "voltage": kind("winkler.laws.current:Voltage", voltage="20 mV"),
        "current": kind("winkler.laws.current:Current", current="5 A"),
    },
    "law": {
        "wiedemann_franz": kind(
            "winkler.laws.current:WiedemannFranz", "kohlrausch_1900", lorenz_number="2.44e-8 V^2/K^2"
        ),
    },
    "problem": {
        "constriction": kind(
            "winkler.problems.conduction.constriction:Constriction", load={"kind": "force", "force": "1 N"}
        ),
        "thermal_constriction": kind(
            "winkler.problems.conduction.thermal_constriction:ThermalConstriction",
            conductors={"kind": "heat_conductors", **STEELS},
            temperature_drop="10 K",
        ),
        "joule_heating": kind(
            "winkler.problems.conduction.joule_heating:JouleHeating", load={"kind": "force", "force": "1 N"}
        ),
        "spot_cluster": kind(
            "winkler.problems.conduction.spots:SpotCluster",
            x=["0 um", "10 um", "5 um"],
            y=["0 um", "0 um", "8 um"],
            radii=["2 um", "3 um", "1 um"],
            first=SILVER,
            second=SILVER,
        ),
        "conductance_bounds": kind(
            "winkler.problems.conduction.bounds:ConductanceBounds", roughness="0.1 um", force="10 N"
        ),
    },
}
"""Slot -> kind -> class."""
