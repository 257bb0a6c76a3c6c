"""Make measured_tip.csv: the profile of an AFM tip with the scatter of a measurement.

The tip is not a real one.  Its geometry is known, so that what comes out of winkler can be checked against it: a
sphere of radius 120 nm that goes over tangentially into a cone of 35 degrees half-angle (`SpheroConical`).  What a
measurement adds is imitated: normally distributed scatter of 0.2 nm in height and 0.05 nm in position, an apex that
lies 3.7 nm beside the zero of the scan, and an arbitrary zero of the heights.  The random numbers are seeded, so that
the file is the same every time.

Run it in the folder where the file is wanted:  python make_measured_tip.py
"""

from pathlib import Path

import numpy as np

import winkler as wk

CURVATURE_RADIUS = 120e-9
HALF_ANGLE = np.radians(35.0)
REACH = 150e-9
APEX = 3.7e-9
ZERO = 11.2e-9
SCATTER_HEIGHT = 0.2e-9
SCATTER_POSITION = 0.05e-9
SEED = 1957

HEADER = """\
# Profile of an AFM tip, along a line across its apex; heights rise away from the apex.
# NOT a real measurement: made by examples/data/make_measured_tip.py from a known geometry,
# a sphere of radius 120 nm with a tangent cone of 35 degrees half-angle, with seeded random scatter
# (0.2 nm in height, 0.05 nm in position), the apex 3.7 nm beside the zero of the scan.
x [nm], height [nm]
"""


def scan() -> tuple[np.ndarray, np.ndarray]:
    """Return position and height of every point of the scan [m]."""
    random = np.random.default_rng(SEED)
    place = np.arange(-REACH, REACH + 0.5e-9, 1.5e-9)
    tip = wk.SpheroConical(curvature_radius=CURVATURE_RADIUS, half_angle=HALF_ANGLE)
    height = tip.height(np.abs(place - APEX)) + ZERO
    return place + SCATTER_POSITION * random.standard_normal(place.size), height + SCATTER_HEIGHT * (
        random.standard_normal(place.size)
    )


if __name__ == "__main__":
    rows = (f"{1e9 * x:.2f}, {1e9 * z:.2f}\n" for x, z in zip(*scan(), strict=True))
    Path("measured_tip.csv").write_text(HEADER + "".join(rows), encoding="utf-8")
    print("Written measured_tip.csv")
