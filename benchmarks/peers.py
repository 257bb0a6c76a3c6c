"""Hertz' contact by winkler and by boundary-element codes, side by side in one run.

The task is the same for all: a paraboloid of R = 1 on a half-space of E* = 1 is pressed with the force that gives a
contact radius of 0.1; the depth is prescribed.  The error is that of the force against Hertz' closed form at the depth
that was found.  What is counted: for the peers the solve alone, their grids, height maps and transforms having been set
up before; for winkler everything, from the shape to the result.

The peers compute any height map; winkler uses that this one is a body of revolution.  The table therefore shows what
it costs to use a tool for everything where the special one exists, and not that the peers are slow.  winkler's own
height maps (`SurfaceContact`) stand beside them on the same grids.

Tables for measure.py, of the codes that are installed (pip install ".[peers]").  ASPHER is measured as well where
`pip install aspher` has built it, which takes a compiler of C++ and Eigen's sources.
"""

from __future__ import annotations

import os

os.environ["OMP_NUM_THREADS"] = "1"  # neither wheel gains from a second thread; must be set before they are imported

import importlib.util
import math
import statistics
import time
from collections.abc import Callable
from importlib.metadata import version
from typing import NamedTuple

import numpy as np
from pages import in_words, table

import winkler as wk
from winkler.numerics.surfaces import surface_grid
from winkler.reference.hertz import hertz_force

RADIUS, CONTACT, SHARE = 1.0, 0.1, 0.4
"""R, a, and a over the side of the grid: 80 % of the grid's width is in contact, which spares the peers idle pixels."""
FORCE = float(hertz_force(CONTACT, curvature_radius=RADIUS, modulus=1.0))
SIDE = CONTACT / SHARE
GRIDS = (64, 128, 256, 512)
REPEATS = 100
"""Of one contact, whose time is less than a tick of the clock."""
PIXELWISE = "p, u at every pixel"


class Row(NamedTuple):
    """One code at one resolution."""

    code: str
    points: int
    times: list[float]
    error: float
    what: str

    @property
    def median(self) -> float:
        """The usual time [s]."""
        return statistics.median(self.times)


def force_error(depth: float) -> float:
    """Return the relative error of the force, F over Hertz' force at the depth that was found, less one."""
    return FORCE / float(hertz_force(math.sqrt(RADIUS * depth), curvature_radius=RADIUS, modulus=1.0)) - 1.0


def heights(points: int) -> np.ndarray:
    """Return the height map of the paraboloid, its apex between the four middle pixels, falling away from it."""
    x = (np.arange(points) + 0.5) * SIDE / points - 0.5 * SIDE
    return -(x[:, None] ** 2 + x**2) / (2.0 * RADIUS)


def by_winkler() -> float:
    """Return the depth by winkler."""
    medium = wk.HalfSpace.between(wk.Elastic(young=1.0, poisson=0.0))
    return wk.Indentation(wk.Foundation(wk.Paraboloid(RADIUS), medium), wk.Force(FORCE)).solve().depth


def by_winkler_without_closed_form() -> float:
    """Return the depth by winkler for the same shape given as a formula, of which it has no closed form."""
    medium = wk.HalfSpace.between(wk.Elastic(young=1.0, poisson=0.0))
    shape = wk.Formula("r**2 / (2*R)", R=RADIUS)
    return wk.Indentation(wk.Foundation(shape, medium), wk.Force(FORCE)).solve().depth


def by_winkler_with_fields() -> float:
    """Return the depth by winkler, and compute pressure, displacement and gap at 512 radii as well."""
    medium = wk.HalfSpace.between(wk.Elastic(young=1.0, poisson=0.0))
    contact = wk.Indentation(wk.Foundation(wk.Paraboloid(RADIUS), medium), wk.Force(FORCE)).solve()
    wk.restore(contact, np.linspace(0.0, 0.5 * SIDE, 512))
    return contact.depth


def by_height_map(points: int) -> Callable[[], tuple[float, float]]:
    """Return a run of winkler's boundary elements, from the height map to depth, stiffness, pressures and gaps."""
    medium = wk.HalfSpace.between(wk.Elastic(young=1.0, poisson=0.0))
    surface = wk.Topography(heights(points), [SIDE, SIDE])

    def run() -> tuple[float, float]:
        surface_grid._cached_grid.cache_clear()
        start = time.process_time()
        contact = wk.SurfaceContact(surface, medium, wk.Force(FORCE)).solve()
        elapsed = time.process_time() - start
        return elapsed, contact.depth - float(surface.heights.max())  # the apex lies above the highest pixel

    return run


def by_tamaas(points: int) -> Callable[[], tuple[float, float]]:
    """Return a run of Tamaas: the solver of Polonsky and Keer, free boundaries; 1e-6 gives nearly the same."""
    import tamaas

    tamaas.set_log_level(tamaas.LogLevel.error)
    surface = heights(points)

    def run() -> tuple[float, float]:
        model = tamaas.ModelFactory.createModel(tamaas.model_type.basic_2d, [SIDE, SIDE], [points, points])
        model.E, model.nu = 1.0, 0.0
        tamaas.ModelFactory.registerNonPeriodic(model, "dcfft")
        pressure = tamaas.PolonskyKeerRey.pressure
        solver = tamaas.PolonskyKeerRey(model, surface, 1e-5, pressure, pressure)
        solver.setIntegralOperator("dcfft")
        start = time.process_time()
        solver.solve(FORCE / SIDE**2)
        elapsed = time.process_time() - start
        model.operators["dcfft"](model.traction, model.displacement)  # the solver leaves the gap there
        depth = np.average(model.displacement - surface, weights=model.traction)
        return elapsed, float(depth)

    return run


def by_contact_mechanics(points: int) -> Callable[[], tuple[float, float]]:
    """Return a run of ContactMechanics: its constrained conjugate gradients, free boundaries, default tolerances."""
    from ContactMechanics import FreeFFTElasticHalfSpace
    from ContactMechanics.Systems import NonSmoothContactSystem
    from SurfaceTopography import Topography

    surface = heights(points)

    def run() -> tuple[float, float]:
        half_space = FreeFFTElasticHalfSpace((points, points), 1.0, (SIDE, SIDE))
        system = NonSmoothContactSystem(half_space, Topography(surface, (SIDE, SIDE)))
        start = time.process_time()
        result = system.minimize_proxy(external_force=FORCE)
        elapsed = time.process_time() - start
        if not result.success:
            raise RuntimeError(f"ContactMechanics did not converge: {result.message}")
        return elapsed, float(system.offset)

    return run


def by_aspher(points: int) -> Callable[[], tuple[float, float]]:
    """Return a run of ASPHER: nested grids, its own hierarchical operator, which it builds anew in every run."""
    import aspher

    fallen = -heights(points)

    def run() -> tuple[float, float]:
        start = time.process_time()
        found = aspher.solve_nested(points, fallen, FORCE / SIDE**2, SIDE, 1.0, coarsest=min(64, points // 2), tol=1e-5)
        elapsed = time.process_time() - start
        if not found.converged:
            raise RuntimeError(f"ASPHER did not converge: {found.status}")
        weights = np.reshape(found.pressure, fallen.shape)
        return elapsed, float(np.average(np.reshape(found.displacement, fallen.shape) + fallen, weights=weights))

    return run


PEERS = {
    "Tamaas": ("tamaas", by_tamaas),
    "ContactMechanics": ("ContactMechanics", by_contact_mechanics),
    "ASPHER": ("aspher", by_aspher),
}
"""Code -> its module, and what makes a run of it."""


def present() -> list[str]:
    """Return the peers that are installed."""
    return [code for code, (module, _) in PEERS.items() if importlib.util.find_spec(module)]


def measure(rounds: int) -> list[Row]:
    """Return all rows; the rounds of all codes alternate, so that a busy moment of the machine meets all of them."""
    peers = {(code, points): PEERS[code][1](points) for points in GRIDS for code in present()}
    peers |= {("winkler, height map", points): by_height_map(points) for points in GRIDS}
    times: dict[tuple[str, int], list[float]] = {key: [] for key in peers}
    depths: dict[tuple[str, int], float] = {}
    ours = {
        ("winkler", 0): by_winkler,
        ("winkler, by quadrature", 0): by_winkler_without_closed_form,
        ("winkler, with fields", 0): by_winkler_with_fields,
    }
    for solve in ours.values():
        for _ in range(50):
            solve()
    times |= {key: [] for key in ours}
    for _ in range(rounds):
        for key, run in peers.items():
            elapsed, depths[key] = run()
            times[key].append(elapsed)
        for key, solve in ours.items():
            start = time.process_time()
            for _ in range(REPEATS):
                depths[key] = solve()
            times[key].append((time.process_time() - start) / REPEATS)
    what = {
        "winkler": "depth, radius, stiffness",
        "winkler, by quadrature": "the same; the shape given as a formula, g by quadrature",
        "winkler, with fields": "the same, and p, u, gap at 512 radii",
        "winkler, height map": "p, u at every pixel, and the stiffness",
    }
    return [
        Row(code, points, times[code, points], force_error(depths[code, points]), what.get(code, PIXELWISE))
        for code, points in times
    ]


def written(rows: list[Row]) -> str:
    """Return the table and the ratio that is claimed."""
    ours = next(row for row in rows if row.code == "winkler")
    lines = [
        [
            row.code if not row.points else f"{row.code}, {row.points} × {row.points}",
            version(row.code.split(",")[0]),
            in_words(row.median),
            in_words(min(row.times)),
            f"{abs(row.error):.1e}" if abs(row.error) > 1e-15 else "< 1e-15",
            f"{row.median / ours.median:,.0f}",
            row.what,
        ]
        for row in sorted(rows, key=lambda row: (row.points, row.code))
    ]
    return table(["code", "version", "median", "fastest", "error of F", "time / winkler", "what is known then"], lines)


def equally_accurate(rows: list[Row]) -> str:
    """Return a table of the time that each code takes for an error: on the coarsest of its grids that reaches it."""
    codes = ["winkler", "winkler, height map", *present()]
    lines = []
    for requested in (1e-4, 1e-5, 5e-6):
        cells = [f"{requested:.0e}"]
        for code in codes:
            enough = [row for row in rows if row.code == code and abs(row.error) <= requested]
            best = min(enough, key=lambda row: row.points, default=None)
            grid = f" ({best.points}²)" if best and best.points else ""
            cells.append(f"{in_words(best.median)}{grid}" if best else f"not on {GRIDS[-1]}²")
        lines.append(cells)
    return table(["error of F at most", *codes], lines)
