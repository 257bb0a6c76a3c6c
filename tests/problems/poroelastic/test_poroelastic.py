"""Forces of poroelastic holds against the formula of Lai and Hu, dual integral equations, and limits in closed form."""

from __future__ import annotations

import numpy as np
import pytest
from biot_elements import shares
from biot_solution import Body, lai_hu

import winkler as wk
from winkler.problems.poroelastic.relaxation_table import relaxed_share

TAU = np.geomspace(1e-3, 1e3, 31)


def test_a_flat_punch_relaxes_by_the_formula_of_lai_and_hu():
    assert relaxed_share("flat", TAU, 0.0) == pytest.approx(lai_hu(TAU), abs=0.006)


def test_first_and_last_force_are_those_of_hertz_and_of_the_drained_body():
    gel = wk.PoroelasticRelaxation(wk.Paraboloid(2e-3), 1e3, 0.3, 1e-9, depth=2e-5, time=[1e-7, 1e13])
    found = gel.solve()
    first = 16.0 / 3.0 * 1e3 * 2e-5 * np.sqrt(2e-3 * 2e-5)
    assert found.first_force == pytest.approx(first, rel=1e-12)
    assert found.last_force == pytest.approx(first / 1.4, rel=1e-12)
    assert found.force == pytest.approx([first, first / 1.4], rel=1e-3)
    assert found.relaxation_time == pytest.approx(2e-3 * 2e-5 / 1e-9, rel=1e-12)


@pytest.mark.parametrize("shape", ["flat", "ball", "cone"])
@pytest.mark.parametrize("poisson", [0.0, 0.17, 0.3, 0.49])
def test_the_force_falls_steadily_as_root_of_time_at_the_ends(shape, poisson):
    tau = np.geomspace(1e-6, 1e6, 400)
    share = relaxed_share(shape, tau, poisson)
    assert np.all(np.diff(share) <= 1e-6)
    assert 0.0 < share[-1] < 1e-3
    assert 0.998 < share[0] <= 1.0
    assert share[-1] / share[-91] == pytest.approx(np.sqrt(tau[-91] / tau[-1]), rel=1e-6)


@pytest.mark.slow
def test_the_tables_are_the_solution_of_the_dual_integral_equations():
    body = Body(0.25, 60.0)
    for tau in (0.03, 0.2, 1.0, 7.0):
        for shape, share in body.shares(tau).items():
            assert relaxed_share(shape, np.array([tau]), 0.25)[0] == pytest.approx(share, abs=2e-3), (shape, tau)


@pytest.mark.slow
def test_finite_elements_in_space_and_time_agree_and_decide_against_older_fits():
    tau = np.array([0.03, 0.1, 0.3, 1.0, 3.0])
    found = shares(tau, 0.25, steps=10)
    for shape, share in found.items():
        assert relaxed_share(shape, tau, 0.25) == pytest.approx(share, abs=0.015), shape
    older = 0.491 * np.exp(-0.908 * np.sqrt(tau)) + 0.509 * np.exp(-1.679 * tau)  # Hu et al. 2010, a ball
    assert np.abs(older - found["ball"]).max() > 0.08


@pytest.mark.parametrize(
    ("change", "sentence"),
    [({"poisson": 0.5}, "from 0 to 0.49"), ({"poisson": -0.1}, "from 0 to 0.49"), ({"depth": 0.0}, "depth is 0")],
)
def test_what_cannot_relax_is_refused(change, sentence):
    given = {
        "profile": wk.FlatPunch(1e-3),
        "shear": 1e3,
        "poisson": 0.2,
        "diffusivity": 1e-9,
        "depth": 1e-5,
        "time": [1.0],
    }
    with pytest.raises(wk.InvalidInput, match=sentence):
        wk.PoroelasticRelaxation(**(given | change))
