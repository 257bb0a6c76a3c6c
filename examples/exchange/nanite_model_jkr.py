"""
JKR in nanite and PyJibe
========================

A model file for `nanite <https://nanite.readthedocs.io>`_ and PyJibe: the retraction of a ball from a soft, sticky
sample (Johnson, Kendall and Roberts). Besides the modulus, nanite then fits the work of adhesion.

Load it with ``nanite.model.load_model_from_file("nanite_model_jkr.py", register=True)`` and fit the segment
``"retract"``: an approach does not follow this branch before the first touch.
"""

import functools

import numpy as np
from scipy.interpolate import CubicSpline

import winkler as wk

POINTS = 300


@functools.lru_cache(maxsize=16)
def unit_branch(deepest):
    """Return forces over depths of JKR with E* = R = w = 1, from the loss of contact to a depth, as a spline."""
    bed = wk.Foundation(wk.Paraboloid(1.0), wk.HalfSpace(wk.Elastic(young=1.0, poisson=0.0)))
    radii = np.geomspace(0.3, 2.0 + np.sqrt(2.0 * deepest), POINTS)
    states = wk.AdhesiveIndentation(bed, wk.ShortRange(1.0), wk.Radius(radii)).solve()
    first = int(np.argmin(states.depth))  # where a pulled contact breaks, however stiff the machine
    return CubicSpline(states.depth[first:], states.force[first:])


def jkr_retraction(delta, E, R, nu, work, contact_point=0, baseline=0):
    """JKR, from contact to its loss

    Parameters
    ----------
    delta: 1d ndarray
        Tip position [m], falling towards the sample
    E: float
        Young's modulus [Pa]
    R: float
        Radius of curvature of the tip [m]
    nu: float
        Poisson's ratio
    work: float
        Work of adhesion [J/m^2]
    contact_point: float
        Tip position where the undeformed bodies touch [m]
    baseline: float
        Force out of contact [N]

    Returns
    -------
    F: float
        Force [N]
    """
    depth = contact_point - np.asarray(delta)
    scale = (work * (1.0 - nu**2) / E) ** (2.0 / 3.0) * R ** (1.0 / 3.0)
    ratio = depth / scale
    unit = unit_branch(float(2.0 ** np.ceil(np.log2(max(float(ratio.max()), 1.0)))))
    within = ratio >= unit.x[0]
    return baseline + work * R * np.where(within, unit(np.where(within, ratio, unit.x[0])), 0.0)


def get_parameter_defaults():
    """Return the parameters of nanite; modulus, work, contact point and baseline are free."""
    import lmfit

    params = lmfit.Parameters()
    params.add("E", value=3e3, min=1e-3)
    params.add("R", value=5e-6, min=0, vary=False)
    params.add("nu", value=0.5, min=0, max=0.5, vary=False)
    params.add("work", value=1e-4, min=1e-9)
    params.add("contact_point", value=0)
    params.add("baseline", value=0)
    return params


model_doc = jkr_retraction.__doc__
model_func = jkr_retraction
model_key = "winkler_jkr"
model_name = "JKR, retraction (winkler)"
parameter_keys = ["E", "R", "nu", "work", "contact_point", "baseline"]
parameter_names = [
    "Young's Modulus",
    "Tip Radius",
    "Poisson's Ratio",
    "Work of Adhesion",
    "Contact Point",
    "Force Baseline",
]
parameter_units = ["Pa", "m", "", "J/m²", "m", "N"]
valid_axes_x = ["tip position"]
valid_axes_y = ["force"]

# %%
# Force of a retraction
# ---------------------
# A ball of 5 um on a gel of 10 kPa: the work of adhesion deepens the pull-off, and moves the point without force.

if __name__ == "__main__":
    import matplotlib.pyplot as plt

    tip = np.linspace(1e-6, -0.6e-6, 800)
    fig, axes = plt.subplots(figsize=(6, 4), layout="constrained")
    for work in (1e-5, 1e-4, 3e-4):
        force = jkr_retraction(tip, 10e3, 5e-6, 0.5, work)
        axes.plot(-1e6 * tip, 1e9 * force, label=f"{1e3 * work:g} mJ/m²")
    axes.axhline(0.0, color="0.7", linewidth=0.8)
    axes.set(xlabel="depth (µm)", ylabel="force (nN)")
    axes.legend()
    plt.show()
