"""Orders of the viscoelastic march: springs, steps under forces, and steps of an impact.

Within a step of prescribed depth nothing is approximate; the error is that of the springs' distance.  Under forces and
under inertia the depth is straight within a step, which costs a power of its length.
"""

from __future__ import annotations

import mpmath as mp
import numpy as np
import pytest
from scipy.integrate import quad
from slopes import order

import winkler as wk
from winkler.foundation.springs import Springs
from winkler.loading.loads import Depth
from winkler.loading.path import Path
from winkler.materials.spring_and_dashpot import Maxwell, StandardSolid
from winkler.materials.viscoelastic import Prony
from winkler.media.relaxing.viscoelastic import ViscoelasticHalfSpace
from winkler.problems.viscoelastic.indentation import ViscoelasticIndentation
from winkler.problems.viscoelastic.march import SpringRow, elastic_like

SOLIDS = {
    "Maxwell": Maxwell(0.25, 0.3),
    "standard": StandardSolid(0.05, 0.2, 0.3),
    "stiff": Prony(0.05, [0.1, 0.1], [1e-4, 1.0]),
}
COUNTS = np.array([25, 50, 100, 200, 400])


def bed(solid, shape):
    return wk.Foundation(shape, ViscoelasticHalfSpace(solid))


def part(tau, power):
    """Return the integral of exp(-(1 - s) / tau) d(s^power) from 0 to 1."""
    return float(mp.hyp1f1(1, mp.mpf(power) + 1, -1 / mp.mpf(tau)))


@pytest.mark.parametrize("name", SOLIDS)
@pytest.mark.parametrize(
    ("shape", "power"),
    [(wk.Paraboloid(1.0), 1.5), (wk.Cone(1.2), 2.0), (wk.PowerLaw(1.0, 4.0), 1.25)],
    ids=["ball", "cone", "blunt"],
)
def test_springs_are_of_second_order(name, shape, power):
    """The force while the contact grows, against the integral of Lee and Radok; the mean over where the edge falls."""
    given = bed(SOLIDS[name], shape)
    series = given.medium.relaxation
    ends = np.append(np.sort(0.2 + 0.05 * (np.arange(1, 13) * 0.6180339887 % 1.0)), 0.25)
    times = ends / 0.25
    elastic = wk.Indentation(elastic_like(given), Depth(ends)).solve().force
    terms = list(zip(series.moduli.tolist(), series.times.tolist(), strict=True))
    exact = elastic * [series.relaxed + sum(m * part(tau / t, power) for m, tau in terms) for t in times]
    errors = []
    for count in COUNTS:
        path = Path(np.append(0.0, times), Depth(np.append(0.0, ends)))
        found = ViscoelasticIndentation(given, path, count=int(count)).solve().force[1:-1]
        errors.append(np.sqrt(np.mean((found / exact[:-1] - 1.0) ** 2)))
    assert 1.85 < order(COUNTS, errors) < 2.2
    assert errors[-1] < 2e-5


@pytest.mark.slow
@pytest.mark.parametrize("name", ["Maxwell", "standard"])
def test_steps_under_a_force_are_of_second_order(name):
    """Fixed steps to the closed depth of creep under a force that pushes an elastic ball in steadily."""
    series = ViscoelasticHalfSpace(SOLIDS[name]).relaxation
    creep = ViscoelasticHalfSpace(SOLIDS[name]).creep
    elastic = elastic_like(bed(SOLIDS[name], wk.Paraboloid(1.0)))
    borne = 0.03 * quad(lambda s: float(creep.at(np.array(1.0 - s))) * np.sqrt(s), 0.0, 1.0)[0]
    springs = Springs.of(elastic, 0.6, 200)
    # the springs' own solution in the limit of no step: an elastic row under the force that creep makes of it
    exact = float(springs.depth(np.array([borne]))[0])
    counts, errors = np.array([8, 16, 32, 64]), []
    for count in counts:
        row, dt, rate = SpringRow(elastic, springs, series), 1.0 / count, 0.0
        for n in range(count):
            change = row.towards(0.02 * ((n + 1) * dt) ** 1.5, dt, rate * dt, 0.02)
            row.march(np.array([change]), np.array([dt]))
            rate = change / dt
        errors.append(abs(row.depth / exact - 1.0))
    assert 1.8 < order(counts, errors) < 2.3
    assert errors[-1] < 3e-4


def test_steps_of_an_impact_are_of_second_order():
    """Two thirds of an impact on a relaxing ball, against sixteen times shorter steps."""
    given = bed(SOLIDS["standard"], wk.Paraboloid(1.0))
    elastic, series = elastic_like(given), given.medium.relaxation
    springs = Springs.of(elastic, 1.3, 100)

    def depth(count: int) -> float:
        row, velocity, dt = SpringRow(elastic, springs, series), 1.0, 2.0 / count
        for _ in range(count):
            mean, _ = row.struck(velocity, 1.0, dt)
            row.march(np.array([mean * dt]), np.array([dt]))
            velocity = 2.0 * mean - velocity
        return row.depth

    counts = np.array([25, 50, 100, 200])
    best = depth(3200)
    errors = [abs(depth(int(count)) - best) for count in counts]
    assert 1.8 < order(counts, errors) < 2.3


@pytest.mark.parametrize("ratio", [1e2, 1e4, 1e6])
def test_no_step_is_too_long(ratio):
    """A step of so many of the shortest relaxation times: the error is that of the springs, whatever the step."""
    solid = Prony(0.05, [0.1, 0.1], [1.0 / ratio, 2.0])
    series = ViscoelasticHalfSpace(solid).relaxation
    found = ViscoelasticIndentation(
        bed(solid, wk.Paraboloid(1.0)), Path([0.0, 1.0], Depth([0.0, 0.25])), count=4000
    ).solve()
    # F = Int E(1 - s) dF_elastic(s), in closed form term by term
    moduli = [(series.relaxed, 1.0), *((m, part(t, 1.5)) for m, t in zip(series.moduli, series.times, strict=True))]
    exact = 4.0 / 3.0 * 0.25**1.5 * sum(m * share for m, share in moduli)
    assert found.force[1] == pytest.approx(exact, rel=2e-7)
