"""Make rough_surface.npz: the height map of a blasted surface, as a microscope would store it.

The surface is not a real one.  Its spectrum is known, so that what comes out of winkler can be checked against it: a
self-affine surface with Hurst exponent 0.8 between 250 and 20 micrometres and a root mean square height of 0.6
micrometres, on a square millimetre of 96 x 96 pixels.  What a measurement adds is imitated: the sample is tilted, forty
pixels are missing, and heights are whole nanometres.  The random numbers are seeded, so that the file is the same every
time.

Run it in the folder where the file is wanted:  python make_rough_surface.py
"""

import numpy as np

import winkler as wk

SIDE = 1e-3
PIXELS = 96
TILT = (2e-3, -1e-3)
MISSING = 40
SEED = 1966


def scan() -> np.ndarray:
    """Return heights [m], nan where they are missing."""
    blasted = wk.SelfAffine(hurst=0.8, rms_height=0.6e-6, longest=SIDE, shortest=20e-6, roll_off=250e-6)
    # twice as wide, and cut out of it: what an instrument sees is never periodic
    made = wk.random_topography(blasted, (2 * PIXELS, 2 * PIXELS), [2 * SIDE, 2 * SIDE], SEED).heights[:PIXELS, :PIXELS]
    place = (np.arange(PIXELS) + 0.5) / PIXELS * SIDE
    heights = made + TILT[0] * place[:, None] + TILT[1] * place[None, :]
    random = np.random.default_rng(SEED)
    heights[random.integers(0, PIXELS, MISSING), random.integers(0, PIXELS, MISSING)] = np.nan
    return heights


if __name__ == "__main__":
    nanometres = np.round(1e9 * scan())
    np.savez_compressed("rough_surface.npz", heights=nanometres.astype(np.float32), lengths=[1e9 * SIDE, 1e9 * SIDE])
    print("Written rough_surface.npz")
