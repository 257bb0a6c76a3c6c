"""A reading needs A(h_c) alone: NanoSuite's own numbers, of tips whose polynomials dip near the apex."""

from __future__ import annotations

import math

import numpy as np
import pytest

import winkler as wk
from winkler.fitting.curves.curve import ForceCurve
from winkler.fitting.unloading.contact_reading import CalibratedArea, contact_reading, sample_young
from winkler.fitting.unloading.oliver_pharr import OliverPharr
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.validity import Standing

DIAMOND = wk.Elastic(young=1141e9, poisson=0.07)


def in_metres(*nanometres):
    return tuple(c * 1e-9 ** (2.0 - 2.0 ** (1 - n)) for n, c in enumerate(nanometres))


SILICA = {
    "coefficients": in_metres(24.8204, 402.507, -3070.91, 3699.87),
    "stiffness": 25731.8375827836,
    "force": 0.987624311132669e-3,
    "depth": 88.2388854303261e-9,
    "poisson": 0.18,
    "young": 75.1620054287519e9,
    "hardness": 10.0514655820034e9,
    "rounding": 3e-6,  # the area, of coefficients with six digits
}
COPPER = {
    "coefficients": in_metres(32.9049, -6418.303798, 288484.8518, -989287.0625, 103588.5588, 675977.3345),
    "stiffness": 159111.704268288,
    "force": 0.491297865144331e-3,
    "depth": 111.172457420282e-9,
    "poisson": 0.35,
    "young": 190.257729329881e9,
    "hardness": 0.82150309678705e9,
    "rounding": 3e-7,  # its area of contact, 598047.490101769 nm^2, differs by that from its own coefficients
}
"""Agilent NanoSuite's input and output, as the verification of the program micromechanics lists them; its constants are
beta = 1, epsilon = 3/4, and diamond with 1141 GPa and 0.07."""


@pytest.mark.parametrize("given", [SILICA, COPPER], ids=["fused silica", "copper"])
@pytest.mark.parametrize("kind", [wk.AreaFunction, CalibratedArea])
def test_the_numbers_of_nanosuite(given, kind):
    found = contact_reading(given["stiffness"], given["force"], given["depth"], kind(given["coefficients"]))
    assert found.hardness == pytest.approx(given["hardness"], rel=given["rounding"])
    assert sample_young(found.modulus, given["poisson"], DIAMOND) == pytest.approx(
        given["young"], rel=given["rounding"]
    )


def test_the_rounded_numbers_of_nanosuite():
    tip = wk.AreaFunction(SILICA["coefficients"])
    found = contact_reading(25731.84, 0.98762e-3, 88.239e-9, tip)
    assert sample_young(found.modulus, 0.18, DIAMOND) == pytest.approx(75.162e9, rel=2e-5)
    assert found.hardness == pytest.approx(10.0515e9, rel=2e-5)


@pytest.mark.parametrize("kind", [wk.AreaFunction, CalibratedArea])
def test_an_unloading_with_the_numbers_of_nanosuite(kind):
    """m = 3/2 has epsilon = 3/4; the unloading with this stiffness at this peak ends at h - 1.5 F/S."""
    final = SILICA["depth"] - 1.5 * SILICA["force"] / SILICA["stiffness"]
    depth = np.linspace(SILICA["depth"], final, 500)
    force = SILICA["force"] * ((depth - final) / (SILICA["depth"] - final)) ** 1.5
    found = OliverPharr(ForceCurve(depth, force), kind(SILICA["coefficients"])).solve()
    assert found.hardness == pytest.approx(SILICA["hardness"], rel=SILICA["rounding"])
    assert sample_young(found.modulus, 0.18, DIAMOND) == pytest.approx(SILICA["young"], rel=SILICA["rounding"])
    (dip,) = [note for note in found.validity if "decreases at depths" in note.statement]
    assert dip.standing is Standing.ASYMPTOTIC


def test_a_polynomial_that_is_negative_near_the_apex():
    """No body of revolution, but a calibration all the same: A = 24.5 h^2 - 1e-7 m h."""
    with pytest.raises(InvalidInput, match="does not grow from the apex on"):
        wk.AreaFunction((24.5, -1e-7))
    area = 24.5 * 92.5e-9**2 - 1e-7 * 92.5e-9
    found = contact_reading(1e5, 1e-3, 100e-9, CalibratedArea((24.5, -1e-7)))
    assert found.contact_depth == pytest.approx(92.5e-9, rel=1e-12)
    assert found.area == pytest.approx(area, rel=1e-12)
    assert found.modulus == pytest.approx(0.5 * math.sqrt(math.pi / area) * 1e5, rel=1e-12)
    assert found.hardness == pytest.approx(1e-3 / area, rel=1e-12)
    with pytest.raises(OutsideValidity, match=r"the area function is -.* m\^2 at the contact depth"):
        contact_reading(1e5, 1e-3, 100e-9, CalibratedArea((24.5, -1e-5)))


def test_a_calibration_that_makes_no_sense():
    with pytest.raises(InvalidInput, match="give finite numbers C0, C1"):
        CalibratedArea(())
    with pytest.raises(InvalidInput, match="give two depths that grow"):
        CalibratedArea((24.5,), 2e-6, 1e-6)
    with pytest.raises(InvalidInput, match="contact_reading: force is -1.0; it must be positive"):
        contact_reading(1e5, -1.0, 1e-7, CalibratedArea((24.5,)))
