"""The keys of ``[indentation]``, ``[calibration]`` and ``[indenter]``: their units and meanings."""

from __future__ import annotations

KEYS: dict[str, dict[str, tuple[str | None, str]]] = {
    "indentation": {
        "curve": (None, "a file, a folder or a pattern such as 'steel/*.csv', relative to the study"),
        "poisson": ("", "Poisson's ratio of the sample"),
        "poisson_error": ("", "its standard uncertainty"),
        "indenter": (
            None,
            "indenter.toml of a calibration, or a table of depth and area; or give the section [indenter]",
        ),
        "contact_point": ("m", "position of first touch, with contact_point_error; found if left out"),
        "contact_point_error": ("m", "its standard error"),
        "units": (None, "units that the files do not state: { position = 'nm', force = 'uN', time = 's' }"),
        "columns": (
            None,
            "numbers of columns of a text table without names: { depth = 1, force = 2, time = 3 }",
        ),
        "drift": (None, "'measured' (if left out), 'none', or the rate as a number, with drift_error"),
        "drift_error": ("m/s", "standard error of a given drift"),
        "segments": (None, "'found', or kinds with their beginnings, such as ['loading 2.1 s', 'hold 36 s', ...]"),
        "force_error": ("", "relative standard uncertainty of the force scale"),
        "depth_error": ("", "relative standard uncertainty of the depth scale"),
        "stiffness_error": ("", "relative standard uncertainty of a continuously measured stiffness"),
        "depths": (None, "['75 nm', '85 nm']: continuous stiffness is averaged between these depths"),
        "upper": ("", "part of the force at the peak where the fitted part of an unloading begins; 0.98"),
        "lower": ("", "part of the force at the peak where it ends; 0.4"),
        "pop_ins": (None, "true: the first pop-in of each curve is sought, and first yield evaluated"),
        "tip_radius": ("m", "radius of the tip, for first yield"),
        "tip_radius_error": ("m", "its standard uncertainty"),
    },
    "calibration": {
        "reference": (None, "reference samples, one [[calibration.reference]] each"),
        "units": (None, "units that the files do not state, as in [indentation]"),
        "columns": (None, "numbers of columns of text tables without names, as in [indentation]"),
        "terms": (None, "number of area coefficients, 1 to 8; the mean over 1 to 4 if left out"),
        "frame_stiffness": ("N/m", "of the frame, where it is known and not fitted"),
        "young": ("Pa", "Young's modulus of the tip; 1141 GPa if left out"),
        "poisson": ("", "Poisson's ratio of the tip; 0.07 if left out"),
        "shape_factor": ("", "beta of the tip; 1 if left out"),
    },
    "calibration.reference": {
        "curve": (None, "a file, a folder or a pattern, relative to the study"),
        "young": ("Pa", "Young's modulus of the reference"),
        "poisson": ("", "its Poisson's ratio"),
        "young_error": ("Pa", "standard uncertainty of its modulus"),
        "name": (None, "its name"),
    },
    "indenter": {
        "area": (None, "coefficients C0, C1, ... of the area function, such as [24.5, '1.1 um'], or a table in a file"),
        "header": (None, "of such a file without names: 'depth [nm], area [nm^2]'"),
        "frame_stiffness": ("N/m", "of the frame that the curves still contain"),
        "young": ("Pa", "Young's modulus of the tip; 1141 GPa if left out"),
        "poisson": ("", "Poisson's ratio of the tip; 0.07 if left out"),
        "shape_factor": ("", "beta of the tip; 1 if left out"),
        "shallowest": ("m", "least contact depth of the calibration"),
        "deepest": ("m", "greatest contact depth of the calibration"),
    },
}
UNITS = {section: {key: unit for key, (unit, _) in rows.items()} for section, rows in KEYS.items()}
"""Unit of every key by section; None where it is no quantity."""
MEANINGS = {section: {key: meaning for key, (_, meaning) in rows.items()} for section, rows in KEYS.items()}
"""Meaning of every key by section."""
