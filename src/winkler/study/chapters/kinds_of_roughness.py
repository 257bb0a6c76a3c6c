"""Kinds of rough and arbitrary surfaces: height maps, spectra, beds that stand for them, and what is asked."""

from __future__ import annotations

from winkler.study.chapters.kind import Kind, kind

__all__ = ["ROUGHNESS"]

BLASTED = {
    "kind": "self_affine",
    "hurst": 0.8,
    "rms_height": "1 um",
    "longest": "1 mm",
    "shortest": "60 um",
}
STAMP = {"kind": "random_topography", "spectrum": BLASTED, "shape": [64, 64], "periodic": False}
PYRAMID = [
    ["0 um", "0 um", "0 um", "0 um", "0 um", "0 um"],
    ["0 um", "2 um", "2 um", "2 um", "2 um", "0 um"],
    ["0 um", "2 um", "5 um", "4 um", "2 um", "0 um"],
    ["0 um", "2 um", "4 um", "4 um", "2 um", "0 um"],
    ["0 um", "2 um", "2 um", "2 um", "2 um", "0 um"],
    ["0 um", "0 um", "0 um", "0 um", "0 um", "0 um"],
]
LOADS = {"kind": "force", "force": {"from": "1 N", "to": "100 N", "count": 5, "spacing": "log"}}
OVAL = [{"kind": "paraboloid", "curvature_radius": radius} for radius in ("10 mm", "12 mm", "10 mm", "12 mm")]

ROUGHNESS: dict[str, dict[str, Kind]] = {
    "topography": {
        "random_topography": kind(
            "winkler.profiles.rough.random_surface:RandomTopography",
            problem="surface_contact",
            lengths=["1 mm", "1 mm"],
            spectrum=BLASTED,
            shape=[64, 64],
        ),
        "height_map": kind(
            "winkler.profiles.rough.topography:Topography",
            reader="winkler.study.chapters.surfaces:read_surface",
            problem="surface_contact",
            heights=PYRAMID,
            lengths=["1 mm", "1 mm"],
        ),
    },
    "spectrum": {
        "self_affine": kind(
            "winkler.profiles.rough.spectrum:SelfAffine",
            problem="rough_contact",
            hurst=0.8,
            rms_height="1 um",
            longest="1 mm",
            shortest="60 um",
        ),
        "power_spectrum": kind(
            "winkler.profiles.rough.spectrum:PowerSpectrum",
            reader="winkler.io.tables.spectrum_table:read_spectrum",
            problem="rough_contact",
            wave_numbers=["1e4 1/m", "1e5 1/m", "1e6 1/m"],
            densities=["1e-21 m^4", "4e-25 m^4", "1e-28 m^4"],
        ),
    },
    "bed": {
        "reduced_bed": kind(
            "winkler.problems.rough.reduced_bed:ReducedBed", topography={**STAMP, "seed": 1}, depth="3 um"
        ),
    },
    "problem": {
        "surface_contact": kind("winkler.problems.rough.surface_contact:SurfaceContact", load=LOADS),
        "surface_conduction": kind(
            "winkler.problems.rough.surface_conduction:SurfaceConduction",
            contact={"kind": "surface_contact", "topography": {**STAMP, "seed": 1}},
        ),
        "reduction": kind("winkler.problems.rough.reduce:Reduction", topography={**STAMP, "seed": 1}, depth="3 um"),
        "rough_contact": kind(
            "winkler.problems.rough.line_contact:RoughContact", side="1 mm", load=LOADS, realisations=20, count=1024
        ),
        "rough_indentation": kind(
            "winkler.problems.rough.line_indentation:RoughIndentation",
            length="4 mm",
            load=LOADS,
            realisations=20,
            count=2048,
            spectrum=BLASTED,
        ),
        "elliptic_indentation": kind("winkler.problems.normal.elliptic:EllipticIndentation"),
        "nearly_round_indentation": kind(
            "winkler.problems.normal.near_round:NearlyRoundIndentation",
            profiles=OVAL,
            load={"kind": "depth", "depth": "1 um"},
        ),
        "elastomer_friction": kind(
            "winkler.problems.rough.elastomer_friction:ElastomerFriction",
            velocity={"from": "1 um/s", "to": "1 m/s", "count": 25, "spacing": "log"},
        ),
    },
}
"""Slot -> kind -> class."""
