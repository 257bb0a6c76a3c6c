"""
A bonded film in nanite and PyJibe
==================================

A model file for `nanite <https://nanite.readthedocs.io>`_ and PyJibe: a parabolic tip on a film that is bonded to a
rigid base, such as a gel or a cell on glass. nanite fits modulus, contact point and baseline; winkler gives the force.

Load it with ``nanite.model.load_model_from_file("nanite_model_film.py", register=True)``, or in PyJibe under
*Edit / Preferences / Extensions*. The thickness is a parameter that stays as given.
"""

import functools

import numpy as np
from scipy.interpolate import CubicSpline

import winkler as wk

POINTS = 80


@functools.lru_cache(maxsize=32)
def force_of_unit_modulus(radius, poisson, thickness, deepest):
    """Return F/E over the square root of the depth, divided by the depth to the power 3/2, as a spline."""
    film = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(young=1.0, poisson=poisson), thickness)], on=wk.Rigid())
    roots = np.linspace(0.02, 1.0, POINTS) * np.sqrt(deepest)
    pressed = wk.Indentation(wk.Foundation(wk.Paraboloid(radius), film), wk.Depth(roots**2)).solve()
    return CubicSpline(roots, pressed.force / roots**3)


def bonded_film(delta, E, R, nu, thickness, contact_point=0, baseline=0):
    """Paraboloid on a bonded film (rigid base)

    Parameters
    ----------
    delta: 1d ndarray
        Tip position [m], falling towards the sample
    E: float
        Young's modulus of the film [Pa]
    R: float
        Radius of curvature of the tip [m]
    nu: float
        Poisson's ratio of the film
    thickness: float
        Thickness of the film [m]
    contact_point: float
        Tip position at first touch [m]
    baseline: float
        Force out of contact [N]

    Returns
    -------
    F: float
        Force [N]
    """
    depth = np.maximum(contact_point - np.asarray(delta), 0.0)
    if not np.any(depth > 0.0):
        return np.full(depth.shape, float(baseline))
    # a depth of powers of two, so that steps of the contact point do not solve the film anew
    deepest = thickness * 2.0 ** np.ceil(np.log2(depth.max() / thickness))
    unit = force_of_unit_modulus(float(R), float(nu), float(thickness), float(deepest))
    roots = np.sqrt(depth)
    return E * unit(np.maximum(roots, unit.x[0])) * roots**3 + baseline


def get_parameter_defaults():
    """Return the parameters of nanite, with the modulus, the contact point and the baseline free."""
    import lmfit

    params = lmfit.Parameters()
    params.add("E", value=3e3, min=0)
    params.add("R", value=5e-6, min=0, vary=False)
    params.add("nu", value=0.5, min=0, max=0.5, vary=False)
    params.add("thickness", value=5e-6, min=0, vary=False)
    params.add("contact_point", value=0)
    params.add("baseline", value=0)
    return params


model_doc = bonded_film.__doc__
model_func = bonded_film
model_key = "winkler_film"
model_name = "bonded film (winkler)"
parameter_keys = ["E", "R", "nu", "thickness", "contact_point", "baseline"]
parameter_names = [
    "Young's Modulus",
    "Tip Radius",
    "Poisson's Ratio",
    "Film Thickness",
    "Contact Point",
    "Force Baseline",
]
parameter_units = ["Pa", "m", "", "m", "m", "N"]
valid_axes_x = ["tip position"]
valid_axes_y = ["force"]

# %%
# What the base adds
# ------------------
# Force of a ball of 5 um on a gel of 1 kPa, as a half-space and as films of 10, 5 and 2 um.

if __name__ == "__main__":
    import matplotlib.pyplot as plt

    tip = np.linspace(0.2e-6, -1e-6, 200)
    fig, axes = plt.subplots(figsize=(6, 4), layout="constrained")
    hertz = 4.0 / 3.0 * 1e3 / 0.75 * np.sqrt(5e-6) * np.maximum(-tip, 0.0) ** 1.5
    axes.plot(-1e6 * tip, 1e9 * hertz, "k--", label="half-space (Hertz)")
    for thickness in (10e-6, 5e-6, 2e-6):
        force = bonded_film(tip, 1e3, 5e-6, 0.5, thickness)
        axes.plot(-1e6 * tip, 1e9 * force, label=f"film of {1e6 * thickness:.0f} µm")
    axes.set(xlabel="depth (µm)", ylabel="force (nN)")
    axes.legend()
    plt.show()
