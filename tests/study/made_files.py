"""Small files of each kind that is recognised, written as instruments and programs write them."""

from __future__ import annotations

from pathlib import Path

import numpy as np

DATA = Path(__file__).parents[2] / "examples" / "data"


def table(path: Path, header: str, *columns: np.ndarray) -> Path:
    """Write a table with commas between its cells."""
    np.savetxt(path, np.column_stack(columns), delimiter=",", header=header, comments="")
    return path


def made_files(folder: Path) -> dict[Path, str]:
    """Write one file of each kind; return what each is to be taken for."""
    x = np.linspace(0.0, 1.0, 41)
    omega = np.geomspace(0.1, 100.0, 13)
    storage, loss = 1.0 + 2.0 * omega**2 / (1.0 + omega**2), 2.0 * omega / (1.0 + omega**2)
    time = np.geomspace(0.01, 100.0, 25)
    rng = np.random.default_rng(1)
    rough = np.cumsum(rng.normal(size=512))
    rough -= np.linspace(rough[0], rough[-1], 512)
    q = np.geomspace(1e4, 1e6, 20)
    grid = np.meshgrid(np.arange(8.0), np.arange(8.0), indexing="ij")
    waves = np.cos(2.0 * np.pi * np.arange(32) / 32.0)
    np.savez(folder / "map.npz", heights=50.0 * waves[:, None] * waves, lengths=[1000.0, 1000.0], unit="nm")
    h = np.linspace(0.0, 500.0, 60)
    rows = np.array([(t, f) for t in (0.0, 20.0, 40.0) for f in (0.1, 1.0, 10.0, 100.0)])
    shifted = rows[:, 1] * 10.0 ** (-(rows[:, 0] - 20.0) / 20.0)
    turn = 2.0 * np.pi * x * 2.0
    return {
        table(folder / "moduli.csv", "omega [rad/s], G' [kPa], G'' [kPa]", omega, storage, loss): "storage and loss",
        table(
            folder / "sweeps.csv", "temperature [degC], frequency [Hz], storage [MPa], loss [MPa]", *rows.T,
            1.0 + shifted**2 / (1.0 + shifted**2), 0.05 + shifted / (1.0 + shifted**2),
        ): "storage and loss at several temperatures",
        table(folder / "relaxing.csv", "time [s], shear [kPa]", time, 1.0 + 2.0 * np.exp(-time)): "relaxation",
        table(folder / "creeping.csv", "time [s], compliance [1/kPa]", time, 1.0 - 0.6 * np.exp(-time / 3.0)): "creep",
        table(
            folder / "relaxing_sweeps.csv", "temperature [degC], time [s], shear [MPa]", rows[:, 0], rows[:, 1],
            1.0 + 9.0 / (1.0 + rows[:, 1] * 10.0 ** ((rows[:, 0] - 20.0) / 20.0)),
        ): "relaxation at several temperatures",
        table(folder / "density.csv", "q [1/m], density [m^4]", q, 1e-21 * (q / 1e4) ** -3.6): "power spectrum",
        table(folder / "path.csv", "time [s], force [N], shift [um]", x, 100.0 + 0.0 * x, np.sin(turn)): "path",
        table(folder / "twist.csv", "time [s], force [N], angle [mrad]", x, 100.0 + 0.0 * x, np.sin(turn)): "path",
        table(
            folder / "pressures.csv", "x [mm], y [mm], pressure [MPa]", grid[0].ravel(), grid[1].ravel(),
            100.0 * np.exp(-((grid[0] - 3.5) ** 2 + (grid[1] - 3.5) ** 2) / 4.0).ravel(),
        ): "map of pressures",
        table(folder / "graded.csv", "depth [um], young [GPa]", 500.0 * x, 380.0 - 170.0 * x): "grading",
        table(
            folder / "bed.csv", "radius [um], stiffness [kN/m], depth [nm]", 10.0 * x[1:], 2300.0 * x[1:],
            100.0 * x[1:] ** 2,
        ): "measured bed",
        table(folder / "tip_area.csv", "contact depth [nm], area [nm^2]", h, 24.5 * h**2 + 900.0 * h):
            "area function of a tip",
        table(folder / "body.csv", "radius [um], height [nm]", 20.0 * x, 200.0 * x**2):
            "profile of a body of revolution",
        table(folder / "scan.csv", "x [um], z [nm]", np.arange(512.0), rough): "line scan",
        folder / "map.npz": "height map",
        DATA / "rail_head.prr": "profile across the direction of rolling",
        DATA / "wheel_tread.csv": "profile across the direction of rolling",
        DATA / "gel_holds" / "narrow.csv": "force over time of a hold",
        DATA / "gel_bead.csv": "force curve",
        DATA / "nanoindentation" / "steel_1.csv": "nanoindentation",
    }  # fmt: skip
