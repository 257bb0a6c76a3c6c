"""Area functions of calibrated tips whose coefficients have both signs: near the apex they fall, or are negative."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import brentq

from winkler.fitting.nanoindentation.touch import TouchByArea, apex_of, fitted_touch

# of a Hysitron, in nm^(2 - 2^(1-n)); negative from 2.257 to 3.376 nm, falling from 0 to 2.76 nm
HYSITRON = np.array([24.5, 2460.555732, -185073.933454, 2197392.23639, -5682984.151049, 3678718.2292])
POWERS = np.array([2.0, 1.0, 0.5, 0.25, 0.125, 0.0625])


def _area(height):
    return HYSITRON @ np.asarray(height, dtype=float) ** POWERS[:, None]


def test_a_tip_is_a_cone_where_its_area_function_is_negative():
    """`winkler fit` answered "invalid value encountered in sqrt", for areas far below the calibrated depths."""
    end = brentq(lambda h: (HYSITRON * (POWERS - 2.0)) @ h**POWERS, 3.4, 100.0)  # above, A grows slower than h^2
    rim, contact = 0.02, np.linspace(0.0, 250.0, 400)
    size = np.where(contact > end, _area(np.maximum(contact, end)), _area([end])[0] * (contact / end) ** 2)
    depth = np.r_[np.arange(-100.0, 0.0), contact + rim * np.sqrt(size)] * 1e-9
    force = np.r_[np.zeros(100), 3e-9 * size]
    noise = np.random.default_rng(3).standard_normal((2, force.size))
    found = fitted_touch(
        depth + 7e-9 + 1e-10 * noise[0], force + 1e-7 * noise[1], HYSITRON * 1e-9 ** (2.0 - POWERS), rim
    )
    assert 0.0 < found.error < 0.5e-9
    assert abs(found.position - 7e-9) < 3.0 * found.error
    depths, exponent = np.array(apex_of(HYSITRON * 300.0 ** (POWERS - 2.0)))
    assert depths * 300.0 == pytest.approx(end, rel=0.06)  # nodes are 5 % apart
    assert exponent == pytest.approx(2.0, abs=0.07)  # it falls by 1 over ln h


def test_the_law_of_such_a_tip_is_smooth():
    law = TouchByArea.of(HYSITRON * 300.0 ** (POWERS - 2.0), 0.02)
    gap, step = np.geomspace(1e-4, 1.0, 30), 1e-7
    course, slope, _ = law.course(gap, np.array([0.1, 0.02]))
    ahead, behind = (law.course(gap + sign * step * gap, np.array([0.1, 0.02]))[0] for sign in (1.0, -1.0))
    assert np.all(course > 0.0)
    assert slope == pytest.approx((ahead - behind) / (2.0 * step * gap), rel=1e-4)


def test_a_tip_whose_area_grows_is_taken_as_it_is():
    assert apex_of(np.array([24.5, 3.0, 0.2])) == (0.0, 1.0)
