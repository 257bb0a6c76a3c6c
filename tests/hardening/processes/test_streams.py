"""A march is a stream: whoever does not keep its states needs no more memory after many steps than after a few."""

from __future__ import annotations

import gc
import os
import tracemalloc
from pathlib import Path

import numpy as np
import pytest

import winkler as wk

BALL = wk.Sphere(10e-3)
BED = wk.Foundation(BALL, wk.HalfSpace(wk.Elastic(210e9, 0.3)))
RUBBER = wk.StandardSolid(relaxed_shear=1e6, shear=3e6, relaxation_time=0.1)
SOFT = wk.Foundation(BALL, wk.ViscoelasticHalfSpace(RUBBER))
FRICTION = wk.Coulomb(0.3)


def times(count):
    return np.linspace(0.0, 0.01 * count, count)


def wave(count, size):
    return size * np.sin(np.arange(count) * 0.3)


def deep(count):
    return 1e-4 * (1.0 - np.cos(np.arange(count) * 0.2))


MARCHES = {
    "tangential": lambda count: wk.Tangential(
        BED, FRICTION, wk.Path(times(count), wk.Force(100.0), wk.Shift(wave(count, 5e-7)))
    ),
    "torsion": lambda count: wk.Torsion(
        BED, FRICTION, wk.Path(times(count), wk.Force(100.0), wk.Angle(wave(count, 1e-3)))
    ),
    "viscoelastic": lambda count: wk.ViscoelasticIndentation(
        SOFT, wk.Path(times(count), wk.Depth(deep(count))), count=50
    ),
    "viscoelastic tangential": lambda count: wk.Tangential(
        SOFT, FRICTION, wk.Path(times(count), wk.Depth(1e-4 + deep(count)), wk.Shift(wave(count, 5e-5))), count=50
    ),
    "sliding wear": lambda count: wk.SlidingWear(
        BED, wk.Archard(1e-16), wk.Force(10.0), np.linspace(0.0, 1.0, count), count=20
    ),
}
ALLOWED = 200_000
"""Bytes that are no growth: caches, and numpy's own lists of small pieces."""


def grown(problem, early: int, late: int) -> int:
    """Return by how many bytes the memory in use has grown from one step of a march to another."""
    steps = problem.steps()
    for _ in range(early):
        next(steps)
    gc.collect()
    tracemalloc.start()
    try:
        before = tracemalloc.get_traced_memory()[0]
        tracemalloc.reset_peak()
        for _ in range(late - early):
            next(steps)
        gc.collect()
        return tracemalloc.get_traced_memory()[0] - before
    finally:
        tracemalloc.stop()


@pytest.mark.slow
def test_some_hundred_steps():
    """Before caches were bounded, a sheared contact kept a kilobyte for each step."""
    assert grown(MARCHES["tangential"](1400), 600, 1300) < ALLOWED


@pytest.mark.few(0, slow=3)
@pytest.mark.parametrize("name", MARCHES)
def test_a_thousand_steps(name):
    assert grown(MARCHES[name](1200), 200, 1190) < ALLOWED


GEL = wk.Foundation(wk.Paraboloid(1e-3), wk.HalfSpace(wk.Elastic(1e6, 0.5)))
CRACK = wk.RateDependentWork(work=0.05, reference_speed=1e-6, exponent=0.6)
LONG = {
    "tangential": (MARCHES["tangential"], 3000, 10_000),
    "viscoelastic": (MARCHES["viscoelastic"], 1000, 6000),
    "start of rolling": (
        lambda count: wk.RollingStart(
            BED, FRICTION, wk.Creepage(longitudinal=1e-3), wk.Force(100.0), 1.0, points=count, count=20
        ),
        1000,
        80_000,
    ),
    "adhesive cycle": (
        lambda count: wk.AdhesiveCycle(GEL, wk.ShortRange(0.05), wk.Depth(0.05 * deep(count))),
        3000,
        15_000,
    ),
    "springs": (
        lambda count: wk.Tangential(
            BED,
            FRICTION,
            wk.Path(times(count), wk.Depth(np.full(count, 1e-6)), wk.Shift(wave(count, 5e-7))),
            wk.Method.SPRINGS,
            count=50,
        ),
        2000,
        10_000,
    ),
    "fretting wear": (
        lambda count: wk.FrettingWear(
            BED, wk.Archard(1e-16), FRICTION, wk.Force(10.0), wk.Shift(1e-7), np.linspace(0.0, 1e3, count), count=20
        ),
        600,
        1400,
    ),
    "viscoelastic adhesion": (
        lambda count: wk.ViscoelasticAdhesion(GEL, CRACK, wk.Path(10.0 * times(count), wk.Depth(0.05 * deep(count)))),
        400,
        1000,
    ),
}
"""March -> what makes it, and the steps between which it may not grow."""
RESIDENT = 2_000_000
"""Bytes of the whole process that are no growth: where a state were stored at every step, there would be many more."""


def resident() -> int:
    """Return how many bytes of memory the process has."""
    gc.collect()
    return int(Path("/proc/self/statm").read_text(encoding="ascii").split()[1]) * os.sysconf("SC_PAGE_SIZE")


@pytest.mark.few(0, slow=3)
@pytest.mark.skipif(not Path("/proc/self/statm").exists(), reason="the system does not tell the size of a process")
@pytest.mark.parametrize("name", LONG)
def test_many_thousand_steps(name):
    make, early, late = LONG[name]
    steps = make(late + 10).steps()
    for _ in range(early):
        next(steps)
    before = resident()
    for _ in range(late - early):
        next(steps)
    assert resident() - before < RESIDENT
