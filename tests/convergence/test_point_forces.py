"""The usual method as a reference: superposed point forces, Eqs. (1) and (2) of the paper the package grew from.

The restored pressure p(r), put through u = 1/(pi E*) IInt p/s dA, must give the displacement that was restored from
the springs: inside the contact the body's own shape, outside the free surface.  The superposition uses nothing of
springs.  By how much it is off is what both together are off.
"""

from __future__ import annotations

import numpy as np
import pytest

import winkler as wk
from winkler.reference.point_forces import displacement, point_force_displacement

STEEL, GLASS = wk.Elastic(210e9, 0.3), wk.Elastic(70e9, 0.22)
CRYSTAL = wk.TransverselyIsotropic(c11=162e9, c12=92e9, c13=69e9, c33=181e9, c44=47e9)
CASES = {
    # shape, contact radius, exponent of the pressure at the edge
    "sphere": (wk.Sphere(1e-2), 4e-3, 0.5),
    "paraboloid": (wk.Paraboloid(1e-2), 4e-3, 0.5),
    "cone": (wk.Cone(1.3), 4e-3, 0.5),
    "blunt": (wk.PowerLaw(1e5, 4.0), 4e-3, 0.5),
    "truncated cone": (wk.TruncatedCone(1.3, 1.5e-3), 4e-3, 0.5),
    "rounded punch": (wk.RoundedPunch(1.5e-3, 1e-2), 4e-3, 0.5),
    "rounded cone": (wk.RoundedCone(5e-3, 1.2), 4e-3, 0.5),
    "sphero-conical": (wk.SpheroConical(2e-3, 1.0), 4e-3, 0.5),
    "capped paraboloid": (wk.CappedParaboloid(1e-2, 5e-2, 1.5e-3), 4e-3, 0.5),
    "flat punch": (wk.FlatPunch(4e-3), None, -0.5),
    "capped cylinder": (wk.CappedCylinder(4e-3, wk.Paraboloid(1e-2)), None, -0.5),
}
MEDIA = {
    "rigid on glass": wk.HalfSpace(GLASS),
    "steel on glass": wk.HalfSpace(STEEL, GLASS),
    "crystal": wk.TransverselyIsotropicHalfSpace(CRYSTAL),
}
PLACES = np.array([0.0, 0.1, 0.3, 0.375, 0.5, 0.8, 0.99, 1.0, 1.01, 1.3, 2.0, 5.0])


def press(name: str, medium) -> wk.IndentationSolution:
    shape, radius, _ = CASES[name]
    load = wk.Depth(2.5e-3) if radius is None else wk.Radius(radius)
    return wk.Indentation(wk.Foundation(shape, medium), load).solve()


def superposed(contact: wk.IndentationSolution, r, edge: float) -> np.ndarray:
    bed = contact.problem.bed
    breaks = [b for b, _ in bed.kinks if b < contact.radius]
    return displacement(
        lambda s: wk.restore(contact, s).pressure, contact.radius, r, bed.medium.modulus, edge=edge, breaks=breaks
    )


# the media differ by a modulus only
PAIRS = [(name, "steel on glass") for name in CASES] + [
    (name, medium) for name in ("sphere", "truncated cone", "flat punch") for medium in ("rigid on glass", "crystal")
]


@pytest.mark.few(1)
@pytest.mark.parametrize(("name", "medium"), PAIRS)
def test_point_forces_move_the_surface_as_the_springs_say(name, medium):
    contact, edge = press(name, MEDIA[medium]), CASES[name][2]
    r = PLACES * contact.radius
    u = superposed(contact, r, edge)
    np.testing.assert_allclose(u, wk.restore(contact, r).displacement, rtol=1e-9)
    inside = r <= contact.radius
    fit = contact.depth - contact.problem.bed.height(r[inside])
    np.testing.assert_allclose(u[inside], fit, rtol=0.0, atol=1e-9 * contact.depth)


@pytest.mark.parametrize("name", ["sphere", "truncated cone", "flat punch"])
def test_far_away_the_contact_is_one_point_force(name):
    """Eq. (1): u = F / (pi E* r); what is left falls with the square of the distance."""
    contact = press(name, MEDIA["steel on glass"])
    modulus = contact.problem.bed.medium.modulus
    r = contact.radius * np.array([20.0, 40.0, 80.0, 160.0])
    point = point_force_displacement(contact.force, r, modulus=modulus)
    left = superposed(contact, r, CASES[name][2]) / point - 1.0
    assert np.all(left > 0.0)
    assert np.polyfit(np.log(r), np.log(left), 1)[0] == pytest.approx(-2.0, abs=0.01)
    np.testing.assert_allclose(wk.restore(contact, r).displacement / point - 1.0, left, rtol=1e-5)


@pytest.mark.slow
def test_a_coarse_sum_of_point_forces_goes_to_the_same_displacement():
    """Eq. (2) taken at its word: squares of a grid, each a point force; no transform of any kind."""
    contact = press("sphere", MEDIA["steel on glass"])
    bed, a = contact.problem.bed, contact.radius
    place = 2.0 * a
    exact = float(wk.restore(contact, place).displacement)
    errors = []
    for count in (50, 100, 200, 400):
        step = 2.0 * a / count
        line = (np.arange(count) + 0.5) * step - a
        x, y = np.meshgrid(line, line)
        distance = np.hypot(x, y)
        pressure = np.where(distance < a, wk.restore(contact, np.minimum(distance, a)).pressure, 0.0)
        moved = point_force_displacement(pressure * step**2, np.hypot(place - x, y), modulus=bed.medium.modulus)
        errors.append(abs(float(np.sum(moved)) / exact - 1.0))
    assert errors[-1] < 1e-4
    assert errors[-1] < 0.2 * errors[0]
