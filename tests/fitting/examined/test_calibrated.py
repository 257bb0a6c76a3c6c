"""Errors of a calibration, against fits of Hertz' law to recalibrated readings, written with scipy alone."""

import numpy as np
import pytest
from scipy.optimize import least_squares
from synthetic import hertz, hertz_on_spring

import winkler as wk
from winkler.fitting.examined.calibrated import calibration_shares
from winkler.values.errors import InvalidInput

YOUNG, RADIUS, SPRING = 2e4, 5e-6, 0.05
E = "bed.medium.first.young"
MODEL = wk.Indentation(wk.Foundation(wk.Paraboloid(RADIUS), wk.HalfSpace.between(wk.Elastic(1e4, 0.5))), wk.Depth(0.0))
POSITION = np.linspace(-1e-6, 1.5e-6, 400)
VOLTS = hertz_on_spring(POSITION, YOUNG / 0.75, RADIUS, SPRING) / SPRING / 6e-8  # sensitivity 60 nm/V
VOLTS = VOLTS + 1e-4 * np.random.default_rng(3).standard_normal(VOLTS.size)


def own_fit(position, force, compliance):
    """Logarithm of Young's modulus, and contact point, by scipy."""

    def misfit(numbers):
        along, modulus = position - 1e-6 * numbers[1], np.exp(numbers[0]) / 0.75
        if compliance == 0.0:
            return (hertz(along, modulus, RADIUS) - force) / 1e-10
        return (hertz_on_spring(along, modulus, RADIUS, 1.0 / compliance) - force) / 1e-10

    found = least_squares(misfit, [np.log(YOUNG), 0.0], xtol=1e-13, ftol=1e-13, x_scale="jac", diff_step=1e-6)
    return found.x * [1.0, 1e-6]


def rates(thermal, travel):
    """Change of ln E and contact point per relative change of the sensitivity."""
    ends = []
    for change in (3e-3, -3e-3):
        deflection = 6e-8 * (1.0 + change) * VOLTS
        spring = SPRING * (1.0 + change) ** (-2 * thermal)
        position = POSITION - deflection if travel else POSITION
        ends.append(own_fit(position, spring * deflection, 0.0 if travel else 1.0 / spring))
    return (ends[0] - ends[1]) / 6e-3


def as_measured(travel):
    force = SPRING * 6e-8 * VOLTS
    return wk.ForceCurve(POSITION - 6e-8 * VOLTS, force) if travel else wk.ForceCurve(POSITION, force, SPRING)


@pytest.mark.few(1)
@pytest.mark.parametrize("travel", [False, True], ids=["position of the piezo", "travel of the tip"])
@pytest.mark.parametrize("thermal", [False, True])
def test_sensitivity(thermal, travel):
    found = wk.fit(as_measured(travel), MODEL, free=[E, "contact_point"])
    shares = calibration_shares(
        found, spring_constant_error=0.1, sensitivity_error=0.03, thermal=thermal, spring_constant=SPRING
    )
    of_modulus, of_place = rates(thermal, travel)
    assert shares.spring_constant[0] == pytest.approx(0.1 * found.value(E), rel=2e-3)
    assert abs(shares.spring_constant[1]) < 1e-3 * 5e-10
    # a wrong travel bends the curve, and generalised least squares weigh the bend otherwise than plain ones
    assert shares.sensitivity[0] == pytest.approx(0.03 * of_modulus * found.value(E), rel=0.07)
    assert shares.sensitivity[1] == pytest.approx(0.03 * of_place, rel=0.12)


def test_thermal_calibration_partly_compensates():
    """A wrong sensitivity changes a force found by thermal noise the other way."""
    plain, thermal = rates(False, True)[0], rates(True, True)[0]
    assert plain > 1.5
    assert thermal == pytest.approx(plain - 2.0, abs=0.01)


def test_interval_holds_both_shares():
    found = wk.fit(as_measured(False), MODEL, free=[E, "contact_point"])
    shares = calibration_shares(found, spring_constant_error=0.1)
    low, high = shares.interval(found, E)
    by_noise = np.log(found.interval(E)[1] / found.value(E))
    whole = np.hypot(by_noise, 1.959964 * 0.1)
    assert np.log([low, high]) - np.log(found.value(E)) == pytest.approx([-whole, whole], rel=2e-3)
    assert shares.interval(found, "contact_point") == pytest.approx(found.interval("contact_point"), rel=1e-6)


def test_frame_stays():
    """The compliance of a frame does not change with the spring constant of the cantilever."""
    frame = 2.0
    curve = wk.ForceCurve(POSITION + SPRING * 6e-8 * VOLTS * frame, SPRING * 6e-8 * VOLTS, 1.0 / (1.0 / SPRING + frame))
    found = wk.fit(curve, MODEL, free=[E, "contact_point"])
    shares = calibration_shares(found, spring_constant_error=0.1, frame_compliance=frame)
    ends = [
        own_fit(curve.position, (1.0 + change) * curve.force, frame + 1.0 / (SPRING * (1.0 + change)))
        for change in (3e-3, -3e-3)
    ]
    rate = float((ends[0] - ends[1])[0] / 6e-3)
    assert rate > 1.1
    assert shares.error(E) == pytest.approx(0.1 * rate * found.value(E), rel=0.04)


def test_refused():
    found = wk.fit(as_measured(True), MODEL, free=[E, "contact_point"])
    with pytest.raises(InvalidInput, match="give spring_constant"):
        calibration_shares(found, sensitivity_error=0.03)
    with pytest.raises(InvalidInput, match="spring_constant_error"):
        calibration_shares(found, spring_constant_error=-0.1)
