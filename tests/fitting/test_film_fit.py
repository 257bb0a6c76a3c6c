"""Fits of soft films on glass: modulus, thickness and contact point at once, as of a cell layer or a gel.

The curves are those of the coated problem (checked in tests/media/layered/test_thin_films.py), with noise.
"""

from __future__ import annotations

import dataclasses

import numpy as np
import pytest

import winkler as wk
from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.fit import fit

LAYER = "bed.medium.layers[0]"
WANTED = {f"{LAYER}.solid.young": 1.2e3, f"{LAYER}.thickness": 2e-6, "contact_point": 3e-6}


def model(shape, young: float, thickness: float) -> wk.Indentation:
    medium = wk.CoatedHalfSpace([wk.Layer(wk.Elastic(young, 0.5), thickness)], on=wk.Rigid())
    return wk.Indentation(wk.Foundation(shape, medium), wk.Depth(0.0))


@pytest.mark.few(0, slow=1)
@pytest.mark.parametrize(
    "shape",
    [wk.Cone(1.2), wk.Paraboloid(5e-6), pytest.param(wk.Sphere(5e-6), marks=pytest.mark.long)],
    ids=["cone", "ball", "sphere"],
)
def test_modulus_thickness_and_contact_point(shape):
    """2,000 points up to half the thickness; the answer lies within four of its own standard errors."""
    position = np.linspace(-1e-6, 1e-6, 2000)
    force = dataclasses.replace(model(shape, 1.2e3, 2e-6), load=wk.Depth(position)).solve().force
    noise = 1e-3 * np.max(force) * np.random.default_rng(4).standard_normal(2000)
    found = fit(ForceCurve(position + 3e-6, force + noise), model(shape, 5e3, 4e-6), free=list(WANTED))
    for name, wanted in WANTED.items():
        error = float(found.standard_errors[found.names.index(name)])
        assert abs(found.value(name) - wanted) < 4.0 * error
        assert error < 0.05 * wanted
