"""Large height maps: time, memory and steps from 256 x 256 pixels on, beside other boundary-element codes.

Rows for measure.py.  Every cell is a process of its own, so that its peak of memory is its own; clocks start when the
map is there and the model of a peer is set up.

The map is a self-affine surface whose shortest waves span eight pixels, so that larger maps hold more of them; the
force presses some five per cent of it into contact.  What a code leaves is measured by one rule for all: displacements
under its pressures by transforms in double digits, the greatest |gap| where it presses and overlap where it does not,
over the depth.

`pytest benchmarks/bench_map_scale.py -m bench -n 0 --benchmark-only` keeps limits on two of the cells.
"""

from __future__ import annotations

import importlib
import importlib.util
import json
import math
import resource
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pytest

pytestmark = pytest.mark.bench

HEAD = ["map", "code", "time", "processor time", "per pixel", "memory", "steps", "left", "contact"]
SIDE, FORCE = 1e-3, 2e-9
GIB = 2.0**30


class Pressed(NamedTuple):
    """What a code has found: pressures over E*, and its steps on the finest grid; zero if it does not tell them."""

    pressure: np.ndarray
    steps: int


def heights(count: int) -> np.ndarray:
    """Return the map, up towards the flat body."""
    import winkler as wk

    spectrum = wk.SelfAffine(hurst=0.8, rms_height=1e-6, longest=0.25 * SIDE, shortest=8.0 * SIDE / count)
    return wk.random_topography(spectrum, (count, count), [SIDE, SIDE], seed=1).heights.copy()


def by_winkler(surface: np.ndarray, periodic: bool) -> Callable[[], Pressed]:
    """Return a run from the map to depth, stiffness, area, pressures and gaps."""
    import winkler as wk
    from winkler.numerics.surfaces.pressed_box import BoxContact

    steps, solve = [0], BoxContact.solve

    def counted(self: BoxContact, tolerance: float) -> int:
        count = solve(self, tolerance)
        steps[0] = count if tuple(self.p.shape) != steps[1:] or len(steps) == 1 else steps[0] + count
        steps[1:] = self.p.shape
        return count

    BoxContact.solve = counted  # type: ignore[method-assign]
    problem = wk.SurfaceContact(
        wk.Topography(surface, [SIDE, SIDE], periodic), wk.HalfSpace(wk.Elastic(1.0, 0.0)), wk.Force(FORCE)
    )

    def run() -> Pressed:
        found = problem.solve()
        return Pressed(found.last.pressure, steps[0])

    return run


def by_tamaas(surface: np.ndarray, periodic: bool) -> Callable[[], Pressed]:
    """Return a run of the solver of Polonsky and Keer: pressures and gaps."""
    import tamaas

    tamaas.set_log_level(tamaas.LogLevel.error)
    model = tamaas.ModelFactory.createModel(tamaas.model_type.basic_2d, [SIDE, SIDE], list(surface.shape))
    model.E, model.nu = 1.0, 0.0
    pressure = tamaas.PolonskyKeerRey.pressure
    if not periodic:
        tamaas.ModelFactory.registerNonPeriodic(model, "dcfft")
    solver = tamaas.PolonskyKeerRey(model, surface, 1e-6, pressure, pressure)
    if not periodic:
        solver.setIntegralOperator("dcfft")

    def run() -> Pressed:
        solver.solve(FORCE / SIDE**2)
        return Pressed(np.array(model.traction), 0)

    return run


def by_contact_mechanics(surface: np.ndarray, periodic: bool) -> Callable[[], Pressed]:
    """Return a run of the constrained conjugate gradients, with its own tolerances: pressures and gaps."""
    from ContactMechanics import FreeFFTElasticHalfSpace, PeriodicFFTElasticHalfSpace
    from ContactMechanics.Systems import NonSmoothContactSystem
    from SurfaceTopography import Topography

    body = PeriodicFFTElasticHalfSpace if periodic else FreeFFTElasticHalfSpace
    substrate = body(surface.shape, 1.0, (SIDE, SIDE))
    system = NonSmoothContactSystem(substrate, Topography(surface, (SIDE, SIDE), periodic=periodic))

    def run() -> Pressed:
        result = system.minimize_proxy(external_force=FORCE)
        if not result.success:
            raise RuntimeError(f"ContactMechanics did not converge: {result.message}")
        pixel = SIDE**2 / surface.size
        nx, ny = surface.shape
        return Pressed(np.asarray(result.jac)[:nx, :ny] / pixel, int(getattr(result, "nit", 0)))

    return run


CODES = {
    "winkler": ("winkler", by_winkler),
    "Tamaas": ("tamaas", by_tamaas),
    "ContactMechanics": ("ContactMechanics", by_contact_mechanics),
}
"""Code -> its module, and what makes a run of it."""


def overlap_left(surface: np.ndarray, pressure: np.ndarray, periodic: bool) -> float:
    """Return the greatest |gap| where a map presses, or overlap where it does not, over the depth."""
    n = len(surface)
    side = SIDE / n
    if periodic:
        q = 2.0 * math.pi * np.hypot(np.fft.fftfreq(n, side)[:, None], np.fft.rfftfreq(n, side))
        q[0, 0] = math.inf
        moved = np.fft.irfft2(np.fft.rfft2(pressure) * 2.0 / q, s=surface.shape)
    else:
        edge = np.abs((np.minimum(np.arange(2 * n), 2 * n - np.arange(2 * n)))[:, None] + np.array([-0.5, 0.5])) * side

        def term(x: np.ndarray, y: np.ndarray) -> np.ndarray:
            return x * np.arcsinh(y / x) + y * np.arcsinh(x / y)

        signs = np.where(np.arange(2 * n) == 0, -1.0, 1.0)  # the pixel around the pressure lies on both sides of it
        love = sum(
            a * b * term(edge[:, i, None], edge[None, :, j])
            for i, a in ((0, -signs[:, None]), (1, 1.0))
            for j, b in ((0, -signs[None, :]), (1, 1.0))
        )
        waves = np.fft.rfft2(love / math.pi)
        moved = np.fft.irfft2(np.fft.rfft2(pressure, s=(2 * n, 2 * n)) * waves, s=(2 * n, 2 * n))[:n, :n]
    gap = moved + float(np.max(surface)) - surface
    pressing = pressure > 0.0
    depth = float(np.mean(gap[pressing]))
    gap -= depth
    return max(float(np.max(np.abs(gap[pressing]))), -float(np.min(gap))) / depth


def most_memory() -> float:
    """Return the most memory [byte] that this process has held so far."""
    try:  # the other number counts that of the process which began this one, too
        lines = Path("/proc/self/status").read_text(encoding="ascii").splitlines()
        return 1024.0 * float(next(line.split()[1] for line in lines if line.startswith("VmHWM:")))
    except OSError:
        return 1024.0 * resource.getrusage(resource.RUSAGE_SELF).ru_maxrss


def cell(code: str, saved: str, periodic: bool) -> None:
    """Measure one cell in this process, and print it."""
    surface = np.load(saved)
    importlib.import_module(CODES[code][0])
    before = most_memory()
    run = CODES[code][1](surface, periodic)
    clock, processor = time.perf_counter(), time.process_time()
    found = run()
    elapsed, spent = time.perf_counter() - clock, time.process_time() - processor
    peak = most_memory()
    print(
        json.dumps(
            {
                "elapsed": elapsed,
                "spent": spent,
                "peak": peak,
                "before": before,
                "steps": found.steps,
                "share": float(np.mean(found.pressure > 0.0)),
                "left": overlap_left(surface, found.pressure, periodic),
            }
        )
    )


def measured(code: str, saved: Path, periodic: bool) -> dict[str, float]:
    """Return one cell, measured in another process."""
    command = [sys.executable, __file__, "cell", code, str(saved), str(int(periodic))]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    return dict(json.loads(done.stdout.splitlines()[-1]))


def row(code: str, count: int, periodic: bool, found: dict[str, float]) -> list[str]:
    """Return a row of the table."""
    from pages import in_words

    return [
        f"{count} x {count}, {'periodic' if periodic else 'free'}",
        code,
        in_words(found["elapsed"]),
        in_words(found["spent"]),
        f"{1e6 * found['spent'] / count**2:.2g} µs",
        f"{(found['peak'] - found['before']) / GIB:.2g} GiB" if count >= 1024 else "",
        f"{found['steps']:.0f}" if found["steps"] else "",
        f"{found['left']:.0e}",
        f"{100.0 * found['share']:.2f} %",
    ]


@pytest.mark.parametrize(("periodic", "limit"), [(True, 4.0), (False, 8.0)])
def bench_a_large_map(benchmark, below, periodic, limit):
    run = by_winkler(heights(1024), periodic)
    found = benchmark.pedantic(run, rounds=2)
    assert overlap_left(heights(1024), found.pressure, periodic) < 1e-3
    below(limit, f"{'periodic' if periodic else 'free'} self-affine surface, 1024 x 1024 pixels: all of it")


if __name__ == "__main__":
    cell(sys.argv[2], sys.argv[3], sys.argv[4] == "1")
