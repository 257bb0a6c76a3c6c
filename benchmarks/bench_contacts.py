"""Many contacts at once: oblique impacts, and steps of a discrete element code.

Run it:  pytest benchmarks -m bench -n 0 --benchmark-only
"""

from __future__ import annotations

import time

import numpy as np
import pytest

import winkler as wk

pytestmark = pytest.mark.bench

GLASS = wk.HalfSpace.between(wk.Elastic(70e9, 0.22), wk.Elastic(70e9, 0.22))
RADIUS = 1e-3
MASS = 2500.0 * 4.0 / 3.0 * np.pi * RADIUS**3
MANY = 100_000


def bench_impacts(benchmark, below):
    """100,000 oblique impacts of 200 steps, 32 springs each; a thread on every core."""
    sliding = np.random.default_rng(2).normal(size=(MANY, 2))
    problem = wk.BallImpacts(GLASS, RADIUS, 0.3, MASS, 3.5 / MASS, 1.0, sliding)
    parted = benchmark.pedantic(problem.solve, rounds=2, warmup_rounds=1)
    assert np.max(np.abs(parted.balance - 1.0)) < 1e-4
    below(20.0, "100,000 oblique impacts of 200 steps")


def bench_step(benchmark, below):
    """One step of 100,000 contacts with their memory: shear, twist and rolling."""
    apart = wk.Contacts.apart(GLASS, curvature_radius=np.full(MANY, RADIUS), coefficient=0.3, reach=1e-6)
    contacts = apart.moved(np.full(MANY, 5e-7), motion=np.full((MANY, 2), 1e-8))
    depth, motion, twist = np.full(MANY, 6e-7), np.full((MANY, 2), 1e-8), np.full(MANY, 1e-5)
    benchmark.pedantic(lambda: contacts.moved(depth, motion=motion, twist=twist), rounds=5, warmup_rounds=1)
    below(0.5, "a step of 100,000 contacts")


BEAD = wk.Contacts.apart(GLASS, curvature_radius=RADIUS, coefficient=0.3, reach=2e-6, rolling_arm=1e-5, count=8)
BED = wk.Foundation(wk.Paraboloid(RADIUS), GLASS)
TIMES = np.arange(2.0)
LAWS = {
    "hertz": wk.Indentation(BED, wk.Depth(2e-6)),
    "balls": BEAD,
    "friction": wk.Tangential(BED, wk.Coulomb(0.3), wk.Path(TIMES, wk.Depth([0.0, 2e-6]), wk.Shift([0.0, 1e-7]))),
    "adhesion": wk.AdhesiveCycle(BED, wk.ShortRange(work_closing=0.1, work_opening=0.2), wk.Depth([2e-6, -1e-6])),
    "yield": wk.ElasticPlasticParticle(RADIUS, wk.Elastic(70e9, 0.22, strength=1e9), wk.Depth([2e-6, 0.0])),
}


def moved(contacts, seed=1):
    """Return steps of all contacts, as they come in a code of particles: small motions, a tenth of them open."""
    rng = np.random.default_rng(seed)
    depth = rng.uniform(-0.2e-6, 2e-6, contacts.size)
    motion = rng.normal(scale=1e-8, size=(contacts.size, 2))
    frictional = "shear_x" in contacts.names
    return [{"depth": depth * (1.0 - 0.02 * k), **({"motion": motion} if frictional else {})} for k in range(4)]


@pytest.mark.parametrize("law", LAWS)
def bench_array(benchmark, law):
    """Four steps of contacts in arrays, 8 springs each; processor time of one contact and step is in extra_info."""
    contacts = wk.ContactArray(LAWS[law], MANY, count=8)
    steps = moved(contacts)

    def march():
        for step in steps:
            contacts.step(**step)

    march()
    start = time.process_time()
    march()
    spent = (time.process_time() - start) / (len(steps) * MANY)
    benchmark.extra_info.update(processor_ns=1e9 * spent, bytes_each=contacts.bytes_for(MANY) / MANY)
    benchmark.pedantic(march, rounds=3)


@pytest.mark.parametrize("precision", ["double", "single"])
def bench_ten_million(benchmark, precision):
    """One step of ten million contacts with 8 springs each; they take 1.8 GiB, in single precision 1.2."""
    contacts = wk.ContactArray(BEAD, 10_000_000, answers=("force", "shear_x", "shear_y"), precision=precision)
    step = moved(contacts)[0]
    contacts.step(**step)
    start = time.process_time()
    benchmark.pedantic(lambda: contacts.step(**step), rounds=2)
    spent = (time.process_time() - start) / (2 * contacts.size)
    benchmark.extra_info.update(processor_ns=1e9 * spent, bytes_each=contacts.bytes_for(10**7) / 1e7)
    assert contacts.bytes_for(10**7) <= 200 * 10**7
