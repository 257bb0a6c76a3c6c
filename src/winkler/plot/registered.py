"""``draw`` with every picture: the modules imported here register their pictures."""

from __future__ import annotations

from winkler.plot import beds, restored, sheets  # noqa: F401
from winkler.plot.conduction import constriction, fields, measured, spot_maps, spots  # noqa: F401
from winkler.plot.conduction import line as line_conduction  # noqa: F401
from winkler.plot.dispatch import sheet_of
from winkler.plot.drawing import draw
from winkler.plot.fitting import curve_events, nanoindentation, unloading  # noqa: F401
from winkler.plot.fitting import examined as examined_fits  # noqa: F401
from winkler.plot.fitting import fits as elastic_fits  # noqa: F401
from winkler.plot.friction import damping, loops  # noqa: F401
from winkler.plot.friction import sheets as friction_sheets  # noqa: F401
from winkler.plot.heating import ellipses, heating, strips  # noqa: F401
from winkler.plot.heating import surfaces as heated_surfaces  # noqa: F401
from winkler.plot.impact import impact  # noqa: F401
from winkler.plot.line import adhesion as line_adhesion  # noqa: F401
from winkler.plot.line import contact, periodic, profile_strips, relaxing, roller  # noqa: F401
from winkler.plot.line import friction as line_friction  # noqa: F401
from winkler.plot.line import rolling as line_rolling  # noqa: F401
from winkler.plot.normal import below_contact  # noqa: F401
from winkler.plot.particles import yielding  # noqa: F401
from winkler.plot.rolling import rolling  # noqa: F401
from winkler.plot.rough import (  # noqa: F401
    below_map,
    ellipse,
    joint,
    joints,
    lines,
    map_curves,
    pair_rolling,
    pressed_maps,
    profile_pair,
    reduced_friction,
    roughness,
    shear,
    stuck,
)  # fmt: skip
from winkler.plot.rough import surfaces as rough_surfaces  # noqa: F401
from winkler.plot.rough.film import film
from winkler.plot.viscoelastic import contacts, fits, holds, master_curves, material_tests, poroelastic, solids  # noqa: F401  # noqa: F401
from winkler.plot.viscoelastic import surfaces as viscoelastic_surfaces  # noqa: F401
from winkler.plot.wear import elliptic_wear, line_wear, wear, worn_maps  # noqa: F401

__all__ = ["draw", "film", "sheet_of"]
