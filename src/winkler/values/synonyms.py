"""Words that are usual elsewhere, in papers and other programs, and the names that winkler has for them.

Where several names are listed, the first that is offered at that place is meant: the radius of a ball is its
``curvature_radius``, that of a contact its ``radius``.
"""

from __future__ import annotations

__all__ = ["SYNONYMS"]

SYNONYMS: dict[str, tuple[str, ...]] = {
    # symbols
    "a": ("radius",),
    "d": ("depth",),
    "delta": ("depth",),
    "e": ("young", "modulus"),
    "e_star": ("modulus",),
    "estar": ("modulus",),
    "f": ("force", "coefficient"),
    "fn": ("force",),
    "fx": ("shear_force",),
    "g": ("shear", "shear_modulus"),
    "g_star": ("shear_modulus",),
    "gamma": ("work",),
    "h": ("depth", "thickness"),
    "k": ("stiffness", "normal_stiffness", "rate"),
    "m": ("mass",),
    "mu": ("coefficient",),
    "n": ("force", "count", "cycles", "exponent"),
    "nu": ("poisson",),
    "p": ("force", "pressure"),
    "phi": ("angle",),
    "r": ("curvature_radius", "flat_radius", "radius"),
    "sigma_y": ("strength",),
    "sigma_zz": ("pressure",),
    "tau": ("traction", "relaxation_time"),
    "theta": ("half_angle",),
    "ux": ("shift",),
    "v": ("velocity", "speed"),
    "w12": ("work",),
    # words
    "adhesion_energy": ("work",),
    "alpha": ("half_angle",),
    "angle": ("half_angle",),
    "approach": ("depth",),
    "contact_size": ("radius",),
    "creepage": ("drive",),
    "creepages": ("drive",),
    "dist": ("stroke", "distance"),
    "elastic_modulus": ("young", "modulus"),
    "extent": ("reach",),
    "force_density": ("line_load",),
    "friction": ("coefficient", "law"),
    "geometry": ("profile",),
    "indentation": ("depth",),
    "indenter": ("profile",),
    "load": ("force", "normal"),
    "material": ("medium", "first"),
    "model": ("law",),
    "npts": ("count",),
    "penetration": ("depth",),
    "radius": ("curvature_radius", "flat_radius"),
    "rigid_profile": ("gap",),
    "shape": ("profile",),
    "solid": ("medium", "first"),
    "substrate": ("on", "medium"),
    "surface_energy": ("work",),
    "tip": ("profile",),
    "yield_stress": ("strength",),
    # public names
    "Ball": ("Sphere",),
    "DMT": ("DerjaguinMullerToporov",),
    "Hertz": ("Indentation",),
    "JKR": ("ShortRange",),
    "Maugis": ("Dugdale",),
    "Mindlin": ("Tangential",),
    "Punch": ("FlatPunch",),
    "Substrate": ("HalfSpace",),
}
"""Symbols and words are looked up in small letters; public names as they are written."""
