"""Make ground_trace.csv: the trace of a stylus across a ground roller, its form kept.

The trace is not a real one: a roller of 50 mm radius with random waves from 500 to 10 micrometres, of 0.15
micrometres root mean square, every 2 micrometres over 1.6 mm, in whole nanometres.  The random numbers are seeded,
so that the file is the same every time.

Run it in the folder where the file is wanted:  python make_ground_trace.py
"""

import numpy as np

RADIUS, LENGTH, SPACING, RMS = 50e-3, 1.6e-3, 2e-6, 0.15e-6
LONGEST, SHORTEST, HURST, SEED = 500e-6, 10e-6, 0.8, 1958


def trace() -> tuple[np.ndarray, np.ndarray]:
    """Return places and heights [m], peaks upwards."""
    random = np.random.default_rng(SEED)
    x = np.arange(round(LENGTH / SPACING) + 1) * SPACING - 0.5 * LENGTH
    waves = np.arange(int(2.0 * LENGTH / LONGEST) + 1, int(2.0 * LENGTH / SHORTEST))
    phases = 2.0 * np.pi * random.random(waves.size)
    rough = (waves ** (-0.5 - HURST)) @ np.cos(np.pi * np.outer(waves, x) / LENGTH + phases[:, None])
    return x, rough * RMS / np.std(rough) - x**2 / (2.0 * RADIUS)


if __name__ == "__main__":
    places, heights = trace()
    rows = [f"{1e6 * x:.0f},{1e9 * z:.0f}" for x, z in zip(places, heights, strict=True)]
    with open("ground_trace.csv", "w", encoding="utf-8", newline="\n") as file:
        file.write("\n".join(["place [um],height [nm]", *rows]) + "\n")
    print("Written ground_trace.csv")
