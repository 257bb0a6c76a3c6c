"""The glossary: each physical name once, with symbol, unit and one line.

Axis labels, result attributes, study files, forms and the manual read it; a test refuses a public field that is
not in it.  A name may mean something else for one owner (the exponent of a shape, of a grading); such words are
keyed by ``(class, field)`` and found first.  A unit of ``None`` marks a field that is no quantity.
"""

from __future__ import annotations

from typing import NamedTuple

__all__ = ["GLOSSARY", "Word", "word"]


class Word(NamedTuple):
    """One entry of the glossary: symbol (LaTeX, without dollars), SI unit (None if no quantity), one line."""

    symbol: str
    unit: str | None
    meaning: str


GLOSSARY: dict[str, Word] = {
    # the contact
    "depth": Word("d", "m", "indentation depth: how far the bodies have approached since first touch"),
    "force": Word("F_N", "N", "normal force, compression positive"),
    "radius": Word("a", "m", "radius of the contact"),
    "stiffness": Word("k", "N/m", "incremental normal stiffness dF/dd"),
    "energy": Word("U", "J", "elastic energy stored in the contact"),
    "line_load": Word("q_z", "N/m", "load of the springs per length"),
    "gap": Word("g", "m", "equivalent plane profile g(x) of the springs"),
    "gap_slope": Word("g'", "", "slope of the equivalent plane profile"),
    "pressure": Word("p", "Pa", "contact pressure, compression positive"),
    "mean_pressure": Word("p_m", "Pa", "force over contact area"),
    "displacement": Word("u_z", "m", "normal displacement of the surface, sum over both bodies"),
    "separation": Word("h", "m", "distance of the deformed surfaces"),
    "normal_stiffness": Word("c_N", "Pa", "normal stiffness of the springs per length"),
    "tangential_stiffness": Word("c_T", "Pa", "tangential stiffness of the springs per length"),
    "modulus": Word("E^*", "Pa", "effective modulus of the pair, 1/E* = sum of (1-nu^2)/E"),
    "shear_modulus": Word("G^*", "Pa", "effective tangential modulus of the pair, 1/G* = sum of (2-nu)/(4G)"),
    # shapes
    "height": Word("f", "m", "height f(r) of the profile above its apex"),
    "slope": Word("f'", "", "slope of the profile"),
    "curvature": Word("f''", "1/m", "second derivative of the profile"),
    "curvature_radius": Word("R", "m", "radius of curvature of the body at its apex"),
    "cap_curvature_radius": Word("R_1", "m", "radius of curvature of the cap"),
    "cap_radius": Word("b", "m", "radius where the cap ends"),
    "half_angle": Word(r"\theta", "rad", "half of the opening angle, measured from the axis"),
    "flat_radius": Word("b", "m", "radius of the flat end"),
    "edge_radius": Word("R", "m", "radius of curvature of the rounded edge"),
    "radial_semi_axis": Word("A", "m", "semi-axis of the ellipsoid in the plane of the surface"),
    "axial_semi_axis": Word("B", "m", "semi-axis of the ellipsoid along the axis of revolution"),
    "coefficient": Word("c", "", "coefficient of a law"),
    "exponent": Word("n", "", "exponent of a law"),
    "coefficients": Word("C_i", None, "C0 [-], C1 [m], C2 [m^(3/2)], C3 [m^(7/4)] ... of the area function"),
    "amplitude": Word("h", "m", "amplitude of a wave or an oscillation"),
    "wavelength": Word(r"\lambda", "m", "wavelength"),
    "reach": Word("L", "m", "radius up to which a shape is known"),
    "rim": Word("b", "m", "radius of the first vertical wall, where the contact is pinned"),
    "size": Word("R", "m", "radius of the body itself"),
    "cap": Word("f", None, "profile of the end face"),
    "parts": Word("f_i", None, "profiles whose heights add up"),
    "expression": Word("f(r)", None, "formula of the height in terms of r [m] and the constants"),
    "constants": Word("", None, "named constants of the formula"),
    "corners": Word("b_i", "m", "radii at which the slope of a formula jumps"),
    "kinks": Word("", None, "radii where the profile is not smooth"),
    # solids
    "young": Word("E", "Pa", "Young's modulus"),
    "poisson": Word(r"\nu", "", "Poisson's ratio"),
    "shear": Word("G", "Pa", "shear modulus"),
    "strength": Word(r"\sigma_Y", "Pa", "yield strength in uniaxial tension"),
    "c11": Word("C_{11}", "Pa", "elastic stiffness in the plane of the surface"),
    "c12": Word("C_{12}", "Pa", "elastic stiffness that couples both directions of the plane"),
    "c13": Word("C_{13}", "Pa", "elastic stiffness that couples plane and axis"),
    "c33": Word("C_{33}", "Pa", "elastic stiffness along the axis"),
    "c44": Word("C_{44}", "Pa", "shear stiffness in planes that contain the axis"),
    "first": Word("1", None, "the body below (z > 0)"),
    "second": Word("2", None, "the body above (z < 0), rigid unless stated"),
    # values that hold others
    "profile": Word("f(r)", None, "the gap profile of the undeformed bodies"),
    "plane_profile": Word("g(x)", None, "the equivalent plane profile, given directly"),
    "medium": Word("", None, "the pair of bodies behind the contact"),
    "bed": Word("", None, "the foundation: springs under an equivalent plane profile"),
    "load": Word("", None, "what is prescribed: a force, a depth or a contact radius"),
    "pressed": Word("u(x)", None, "the displacement of the springs"),
    "problem": Word("", None, "what was asked"),
    "solution": Word("", None, "what was answered"),
    "validity": Word("", None, "how far the result can be trusted"),
    "notes": Word("", None, "what must be said about a shape or medium"),
    # fields
    "r": Word("r", "m", "distance from the axis"),
    "x": Word("x", "m", "place along the line of springs"),
    "z": Word("z", "m", "depth below the surface; positive in the first body, negative in the second"),
    "radial_stress": Word(r"\sigma_r", "Pa", "radial stress, tension positive"),
    "hoop_stress": Word(r"\sigma_\theta", "Pa", "hoop stress, tension positive"),
    "axial_stress": Word(r"\sigma_z", "Pa", "stress along the axis, tension positive"),
    "shear_stress": Word(r"\tau_{rz}", "Pa", "shear stress in planes that contain the axis"),
    "radial_displacement": Word("u_r", "m", "radial displacement, outward positive"),
    "axial_displacement": Word("u_z", "m", "displacement along the axis, into the body positive"),
    "von_mises": Word(r"\sigma_{vM}", "Pa", "equivalent stress after von Mises"),
    "principal": Word(r"\sigma_i", "Pa", "principal stresses, greatest first"),
    "max_shear": Word(r"\tau_{max}", "Pa", "greatest shear stress, half the spread of the principal stresses"),
    # springs
    "position": Word("x_i", "m", "places of the springs"),
    "width": Word(r"\Delta x_i", "m", "length of line that each spring stands for"),
    "count": Word("n", "", "how many"),
}

OWNED: dict[tuple[str, str], Word] = {
    ("Radius", "radius"): Word("a", "m", "prescribed radius of the contact"),
    ("FlatPunch", "radius"): Word("b", "m", "radius of the punch"),
    ("CappedCylinder", "radius"): Word("b", "m", "radius of the cylinder, where the contact is pinned"),
    ("Measured", "radii"): Word("r_i", "m", "measured distances from the axis"),
    ("Measured", "heights"): Word("f_i", "m", "measured heights above the apex"),
    ("PowerLaw", "coefficient"): Word("c", "m^(1-n)", "coefficient of the shape f = c r^n"),
    ("PowerLaw", "exponent"): Word("n", "", "exponent of the shape f = c r^n"),
    ("SurfaceFields", "gap"): Word("h", "m", "distance of the deformed surfaces"),
}


def word(owner: str, field: str) -> Word:
    """Return the glossary's entry for `field` of the class named `owner`.

    Raises
    ------
    KeyError
        If the glossary does not know the field: a house test keeps that from happening.
    """
    return OWNED.get((owner, field)) or GLOSSARY[field]
