"""
A measured tip in nanite and PyJibe
===================================

A model file for `nanite <https://nanite.readthedocs.io>`_ and PyJibe: the tip is a profile measured by a tip
characteriser or an electron microscope, here the one of the examples. Write the name of your own table into ``TIP``,
and load the file with ``nanite.model.load_model_from_file("nanite_model_measured_tip.py", register=True)``.

The table has two columns with units, such as ``r [nm], height [nm]``.
"""

import functools
import warnings
from pathlib import Path

import numpy as np

import winkler as wk

HERE = Path(__file__).parent if "__file__" in globals() else Path.cwd()
TIP = HERE.parent / "data" / "measured_tip.csv"
POINTS = 200


@functools.lru_cache(maxsize=4)
def force_of_unit_modulus(tip):
    """Return depths [m] over the reach of the tip, and the forces on a half-space of E* = 1 Pa [N]."""
    profile = wk.read_profile(tip)
    body = wk.HalfSpace(wk.Elastic(young=1.0, poisson=0.0))
    radii = np.linspace(0.0, 0.999, POINTS + 1)[1:] * profile.radii[-1]
    pressed = wk.Indentation(wk.Foundation(profile, body), wk.Radius(radii)).solve()
    return np.concatenate([[0.0], pressed.depth]), np.concatenate([[0.0], pressed.force])


def measured_tip(delta, E, nu, contact_point=0, baseline=0):
    """Measured tip on a half-space

    Parameters
    ----------
    delta: 1d ndarray
        Tip position [m], falling towards the sample
    E: float
        Young's modulus [Pa]
    nu: float
        Poisson's ratio
    contact_point: float
        Tip position at first touch [m]
    baseline: float
        Force out of contact [N]

    Returns
    -------
    F: float
        Force [N]
    """
    depths, forces = force_of_unit_modulus(TIP)
    depth = np.maximum(contact_point - np.asarray(delta), 0.0)
    force = np.interp(depth, depths, forces)
    beyond = depth > depths[-1]
    if np.any(beyond):  # a step of the fit may go there; a result there has no meaning
        warnings.warn(f"the tip is known to a depth of {1e9 * depths[-1]:.0f} nm; fit a shallower range", stacklevel=2)
        slope = (forces[-1] - forces[-2]) / (depths[-1] - depths[-2])
        force[beyond] = forces[-1] + slope * (depth[beyond] - depths[-1])
    return E / (1.0 - nu**2) * force + baseline


def get_parameter_defaults():
    """Return the parameters of nanite, with the modulus, the contact point and the baseline free."""
    import lmfit

    params = lmfit.Parameters()
    params.add("E", value=3e3, min=0)
    params.add("nu", value=0.5, min=0, max=0.5, vary=False)
    params.add("contact_point", value=0)
    params.add("baseline", value=0)
    return params


model_doc = measured_tip.__doc__
model_func = measured_tip
model_key = "winkler_measured_tip"
model_name = "measured tip (winkler)"
parameter_keys = ["E", "nu", "contact_point", "baseline"]
parameter_names = ["Young's Modulus", "Poisson's Ratio", "Contact Point", "Force Baseline"]
parameter_units = ["Pa", "", "m", "N"]
valid_axes_x = ["tip position"]
valid_axes_y = ["force"]

# %%
# The measured tip, and the ball that it was sold as
# --------------------------------------------------
# At small depths the ball describes it; deeper the cone behind it counts.

if __name__ == "__main__":
    import matplotlib.pyplot as plt

    tip = np.linspace(20e-9, -200e-9, 200)
    fig, axes = plt.subplots(figsize=(6, 4), layout="constrained")
    axes.plot(-1e9 * tip, 1e9 * measured_tip(tip, 100e3, 0.5), label="measured tip")
    ball = 4.0 / 3.0 * 100e3 / 0.75 * np.sqrt(120e-9) * np.maximum(-tip, 0.0) ** 1.5
    axes.plot(-1e9 * tip, 1e9 * ball, "k--", label="ball of 120 nm (Hertz)")
    axes.set(xlabel="depth (nm)", ylabel="force (nN)")
    axes.legend()
    plt.show()
