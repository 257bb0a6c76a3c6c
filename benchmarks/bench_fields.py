"""Restoring the body: pressure on 1,000 radii, and all stresses on a map of 100 x 100 points, nothing cached.

Run it:  pytest benchmarks -m bench -n 0 --benchmark-only
"""

from __future__ import annotations

import importlib
import pkgutil

import numpy as np
import pytest

import winkler.media
from winkler.fields.peaks import peak_stress
from winkler.fields.restoration import restore
from winkler.foundation.foundation import Foundation
from winkler.loading.loads import Radius
from winkler.problems.normal.indentation import Indentation
from winkler.profiles.conical import SpheroConical
from winkler.profiles.power import Paraboloid
from winkler.reference.hertz import hertz_peak_pressure, hertz_pressure, hertz_subsurface

pytestmark = pytest.mark.bench

CURVATURE_RADIUS, CONTACT_RADIUS = 10e-3, 200e-6
MODULES = [
    importlib.import_module(f"winkler.media.{item.name}") for item in pkgutil.iter_modules(winkler.media.__path__)
]


def forget():
    """Empty every cache of the media: tables of this contact that a second call would find."""
    for module in MODULES:
        for item in vars(module).values():
            if hasattr(item, "cache_clear") and getattr(item, "__module__", "").startswith("winkler.media"):
                item.cache_clear()


@pytest.fixture
def hertz(steel_on_steel):
    return Indentation(Foundation(Paraboloid(CURVATURE_RADIUS), steel_on_steel), Radius(CONTACT_RADIUS)).solve()


@pytest.fixture
def tip(steel_on_steel):
    """A contact that reaches beyond the blend of tip and cone."""
    shape = SpheroConical(curvature_radius=1e-6, half_angle=np.radians(70.0))
    return Indentation(Foundation(shape, steel_on_steel), Radius(0.6e-6)).solve()


def bench_pressure(benchmark, hertz, steel_on_steel):
    r = np.linspace(0.0, 2.0, 1000) * CONTACT_RADIUS
    fields = benchmark.pedantic(lambda: restore(hertz, r), setup=forget, rounds=100, warmup_rounds=3)
    exact = hertz_pressure(r, CONTACT_RADIUS, curvature_radius=CURVATURE_RADIUS, modulus=steel_on_steel.modulus)
    np.testing.assert_allclose(fields.pressure, exact, rtol=1e-8, atol=1e-8 * exact[0])
    benchmark.extra_info.update(what="pressure, displacement and gap at 1,000 radii, Hertz")


def bench_stress_map_hertz(benchmark, hertz, steel_on_steel):
    r, z = (grid.ravel() for grid in np.meshgrid(np.linspace(0.0, 2.0, 100), np.linspace(0.0, 2.0, 100)))
    r, z = r * CONTACT_RADIUS, z * CONTACT_RADIUS
    fields = benchmark.pedantic(lambda: restore(hertz, r, z), setup=forget, rounds=10, warmup_rounds=1)
    peak = float(hertz_peak_pressure(CONTACT_RADIUS, curvature_radius=CURVATURE_RADIUS, modulus=steel_on_steel.modulus))
    body = steel_on_steel.first
    exact = hertz_subsurface(r, z, CONTACT_RADIUS, peak_pressure=peak, poisson=body.poisson, shear=body.shear)
    inside = z > 0.0
    np.testing.assert_allclose(fields.axial_stress[inside], exact.axial_stress[inside], rtol=0.0, atol=1e-8 * peak)
    benchmark.extra_info.update(what="all stresses on a map of 100 x 100 points, Hertz")


def bench_stress_map_tip(benchmark, tip):
    r, z = np.meshgrid(np.linspace(0.0, 2.0, 100) * tip.radius, np.linspace(0.0, 2.0, 100) * tip.radius)
    fields = benchmark.pedantic(lambda: restore(tip, r, z), setup=forget, rounds=10, warmup_rounds=1)
    assert np.all(np.isfinite(fields.von_mises[1:]))
    benchmark.extra_info.update(what="the same, sphero-conical tip")


def bench_peak_stress(benchmark, hertz):
    place = benchmark.pedantic(lambda: peak_stress(hertz), setup=forget, rounds=10, warmup_rounds=1)
    assert place.z / CONTACT_RADIUS == pytest.approx(0.4808644853, rel=1e-5)
    benchmark.extra_info.update(what="greatest von Mises stress and its place, Hertz")
