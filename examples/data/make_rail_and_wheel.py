"""Make rail_head.prr and wheel_tread.csv: the profiles of a rail and of a wheel, of arcs and straight parts.

They are not measured, and no standard: a head of arcs of 300, 80 and 13 mm, leaning by 1 in 40, and a tread of 1 in 40
that goes over arcs of 500, 100 and 13.5 mm into a flange of 65 degrees.  One file has the format of Simpack, the other
is a table.

Run it in the folder where the files are wanted:  python make_rail_and_wheel.py
"""

from pathlib import Path

import numpy as np

STEP = 0.05e-3
EACH = 5


def profile(start: float, parts: list[tuple[float, float]]) -> tuple[np.ndarray, np.ndarray]:
    """Return y and z of parts (length, curvature) that go over smoothly, from a direction in radians on."""
    curvature = np.concatenate([np.full(round(length / STEP), bend) for length, bend in parts])
    turn = start + np.concatenate([[0.0], np.cumsum(curvature) * STEP])
    middle = 0.5 * (turn[1:] + turn[:-1])
    y, z = (np.concatenate([[0.0], np.cumsum(part) * STEP]) for part in (np.cos(middle), np.sin(middle)))
    return y[::EACH], z[::EACH]


# the rail: its gauge side at -y, symmetric about its middle
half = [(10.25e-3, 1 / 0.3), (15.5e-3, 1 / 0.08), (13.5e-3, 1 / 0.013)]
turned = sum(length * bend for length, bend in half)
y, z = profile(
    turned, [(length, -bend) for length, bend in reversed(half)] + [(length, -bend) for length, bend in half]
)
middle = y.size // 2
y, z = y - y[middle], z - z[middle]
lean = np.arctan(1 / 40)
y, z = y * np.cos(lean) - z * np.sin(lean), y * np.sin(lean) + z * np.cos(lean)
z -= z.max()
lines = ["header.begin", "  version = 1", "  type = 0", "header.end", "spline.begin"]
lines += ["  comment = 'a rail of arcs'", "  units.len.f = 1000.", "  point.begin"]
lines += [f"    {a:.6f} {b:.6f}" for a, b in zip(1e3 * y, -1e3 * z, strict=True)]  # z counts downwards there
Path("rail_head.prr").write_text("\n".join([*lines, "  point.end", "spline.end", ""]), encoding="utf-8")

# the wheel: from the flange at -y to the field side; its zero on the tread
bends = [(65.0, 12.0, 13.5e-3), (12.0, 3.2, 0.1), (3.2, np.degrees(np.arctan(1 / 40)), 0.5)]
arcs = [(np.radians(first - last) * radius, -1 / radius) for first, last, radius in bends]
y, z = profile(np.radians(65.0), [(14e-3, 0.0), *arcs, (55e-3, 0.0)])
zero = int(np.argmin(np.abs(y - 43e-3)))
y, z = y - y[zero], z - z[zero]
rows = ["# a wheel of arcs and straight parts", "y [mm],z [mm]"]
rows += [f"{a:.6f},{b:.6f}" for a, b in zip(1e3 * y, 1e3 * z, strict=True)]
Path("wheel_tread.csv").write_text("\n".join([*rows, ""]), encoding="utf-8")
