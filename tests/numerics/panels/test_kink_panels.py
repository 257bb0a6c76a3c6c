"""Panels between kinks: polynomials through their nodes are read and integrated up to any place."""

from __future__ import annotations

import numpy as np

from winkler.numerics.panels.kink_panels import NODES_PER_PANEL, stretches

KINK = 0.4


def test_functions_are_read_and_integrated_at_any_place():
    """x^2 log x, by its integral in closed form: at nodes, at both ends, and in between."""
    panels = stretches(lambda x: np.sqrt(np.maximum(x**2 - KINK**2, 0.0)), [KINK], 1.0)
    values = panels.nodes**2 * np.log(panels.nodes)
    places = np.concatenate([[KINK, 1.0], panels.nodes[[3, -1]].ravel(), np.linspace(0.01, 1.0, 97)])
    np.testing.assert_allclose(panels.value(values, places), places**2 * np.log(places), rtol=0.0, atol=1e-14)
    known = places**3 * (np.log(places) / 3.0 - 1.0 / 9.0)
    np.testing.assert_allclose(panels.integral(values, places), known, rtol=0.0, atol=1e-14)


def test_reading_keeps_polynomials_of_the_order_of_the_nodes():
    panels = stretches(lambda x: x, [], 2.0, halvings=1)
    places = np.random.default_rng(0).uniform(0.0, 2.0, 50)
    for order in (1, NODES_PER_PANEL - 1):
        found = panels.value((0.5 * panels.nodes) ** order, places)
        np.testing.assert_allclose(found, (0.5 * places) ** order, rtol=0.0, atol=1e-14)
