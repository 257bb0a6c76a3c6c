"""Every reader of a measured file, with a table that it reads."""

from __future__ import annotations

import numpy as np

import winkler as wk
from winkler.io.wear_states import read_wear

BED = wk.Foundation(wk.Paraboloid(10e-3), wk.HalfSpace(wk.Elastic(210e9, 0.3)))
R = np.linspace(0.0, 1e-3, 12)
T = np.geomspace(1e-3, 10.0, 12)
X = np.arange(72.0)
Z = 3.0 * np.sin(X / 5.0) + np.sin(2.0 * X)


def rows(header: str, *columns) -> str:
    return header + "\n" + "\n".join(",".join(f"{number:.9g}" for number in row) for row in zip(*columns, strict=True))


READERS = {
    "profile": (wk.read_profile, rows("radius [um],height [nm]", R * 1e6, 0.5e9 * R**2 / 10e-3)),
    "profile across": (
        lambda path: wk.read_profile(path, peak=True),
        rows("x [um],height [nm]", (R - 0.5e-3) * 1e6, -0.5e9 * (R - 0.5e-3) ** 2 / 10e-3),
    ),
    "curve": (wk.read_curve, rows("depth [um],force [mN]", R * 1e3, (R * 1e3) ** 1.5)),
    "bed": (
        wk.read_bed,
        rows("radius [mm],stiffness [MN/m],depth [um]", R[1:] * 1e3, 230e9 * R[1:] * 1e-6, R[1:] ** 2 * 1e8),
    ),
    "grading": (
        lambda path: wk.read_grading(path, poisson=0.3),
        rows("depth [mm],young [GPa]", R * 1e3, 380.0 - 1e5 * R),
    ),
    "path": (wk.read_path, rows("time [s],force [N],shift [um]", T, 10.0 + 0.0 * T, np.sin(T))),
    "relaxation": (wk.read_relaxation, rows("time [s],shear modulus [MPa]", T, 1.0 + 1.0 / (1.0 + T))),
    "creep": (wk.read_creep, rows("time [s],shear compliance [1/MPa]", T, 1.0 + T / (1.0 + T))),
    "dynamic": (
        wk.read_dynamic,
        rows(
            "angular frequency [rad/s],storage modulus [MPa],loss modulus [MPa]", T, 1.0 + T / (1.0 + T), 0.1 + 0.0 * T
        ),
    ),
    "sweeps side by side": (
        wk.read_dynamic_sweeps,
        rows(
            "280 K,,,300 K,,\n" + ",".join(["omega [rad/s],G' [MPa],G'' [MPa]"] * 2),
            *(T, 2.0 + T, 0.2 + 0.0 * T, T, 1.0 + T, 0.1 + 0.0 * T),
        ),
    ),
    "creep and recovery": (
        lambda path: wk.read_creep(path, test=1),
        rows(
            "Meas. Pts.,time [s],J [1/MPa]",
            np.tile(np.arange(1.0, 13.0), 2),
            np.append(T, 10.0 + T),
            np.append(1.0 + T / (1.0 + T), 0.0 * T),
        ),
    ),
    "spectrum": (wk.read_spectrum, rows("wave_number [1/um],density [um^4]", T, 1e-3 / T**3)),
    "scan": (wk.read_scan, rows("x [um],z [nm]", X, Z)),
    "topography": (
        lambda path: wk.read_topography(path, lengths=(5e-6, 2e-6), unit="nm"),
        "\n".join(",".join(f"{height:.6g}" for height in row) for row in Z[:24].reshape(6, 4)),
    ),
    "cross profile": (wk.read_cross_profile, rows("y [um],z [nm]", X, Z)),
    "rail": (
        wk.read_cross_profile,
        "header.begin\nheader.end\nspline.begin\nunits.len.f = 1000.\nshift.y = 1.\nmirror.z = 0\npoint.begin\n"
        + "\n".join(f"{k} {-0.01 * k * k:.3f}" for k in range(-8, 9))
        + "\npoint.end\nspline.end\n",
    ),
    "profile of MiniProf": (
        wk.read_cross_profile,
        "XYPoints=9\nColumnDef=X,Y,A\n\n" + "\n".join(f"{k}\t{-0.01 * k * k:.3f}\t0" for k in range(-4, 5)),
    ),
    "pressures": (
        wk.read_surface_load,
        "x [mm],y [mm],p [MPa],tx [MPa]\n" + "\n".join(f"{k % 4},{k // 4},{k % 3},{k % 5}" for k in range(20)),
    ),
    "curves": (lambda path: list(wk.read_curves(path)), rows("depth [um],force [mN]", R * 1e3, (R * 1e3) ** 1.5)),
    "contacts": (wk.read_contacts, ""),
    "wear": (lambda path: read_wear(path, BED), ""),
}
"""Name -> reader and a table; an empty text where it reads archives only."""
TABLES = {name: text for name, (_, text) in READERS.items() if text}
SUFFIXES = (".csv", ".txt", ".npz", ".npy", ".jpk-force", ".ibw", ".h5", ".nc", ".gwy", ".x3p", ".zip", "")
