"""The curves with which the form of a fit begins: made ones, a ball on a gel, a body that relaxes, and a metal."""

from __future__ import annotations

from typing import Any

import numpy as np

SAMPLE, RELAXING_SAMPLE, METAL_SAMPLE = "sample_curve.csv", "sample_relaxing_curve.csv", "sample_metal_curve.csv"
RADIUS, YOUNG, POISSON, NOISE = 5e-6, 4e3, 0.5, 2e-11
"""Of the tip [m], E [Pa] and Poisson's ratio of the gel, and the standard deviation of the force [N]."""
SHEAR, EXPONENT, SPEED, DEEPEST, HOLD = 1.5e3, 0.15, 1e-6, 8e-7, 3.0
"""G after a second [Pa], its exponent, speed [m/s] and greatest depth [m] of the approach, time of the hold [s]."""

SAMPLE_REMARKS = {
    SAMPLE: "A made curve, not a measurement: a ball of 5 um on a gel of 4 kPa, with noise. Upload your own.",
    RELAXING_SAMPLE: (
        "A made curve, not a measurement: a ball of 5 um on a body of G = 1.5 kPa (t / 1 s)^-0.15, approach and hold, "
        "with noise. Upload your own."
    ),
    METAL_SAMPLE: (
        "A made curve, not a measurement: a ball of 5 um on a metal of 210 GPa that yields at 400 MPa, pressed and "
        "let go, with noise. Upload your own."
    ),
}
"""File -> what it is."""


def sample_of(curve: Any, own: str) -> Any:
    """Return the sample of a model in place of another sample; other curves stay."""
    return own if curve in SAMPLE_REMARKS else curve


def sample_curve() -> bytes:
    """Return the text of the curve: Hertz's force over the depth, with white noise."""
    depth = np.linspace(-1e-6, 8e-7, 300)
    force = 4.0 / 3.0 * YOUNG / (1.0 - POISSON**2) * np.sqrt(RADIUS) * np.maximum(depth, 0.0) ** 1.5
    force = force + NOISE * np.random.default_rng(1).standard_normal(depth.size)
    rows = (f"{1e9 * d:.2f}, {1e9 * f:.5f}" for d, f in zip(depth, force, strict=True))
    lines = ("# NOT a measurement: a ball of 5 um on a gel of 4 kPa, with noise", "depth [nm], force [nN]", *rows)
    return ("\n".join(lines) + "\n").encode()


def relaxing_sample_curve() -> bytes:
    """Return the text of the curve of a power-law body: the approach at constant speed, and the hold, with white noise.

    The force is Hertz's with the modulus inside an integral over time (E. H. Lee, J. R. M. Radok, J. Appl. Mech. 27
    (1960) 438, doi:10.1115/1.3644020): of an incompressible body, with G(t) = G (t / 1 s)^-a and depth v t, it is
    8 G sqrt(R) v^(3/2) t^(3/2 - a) B(3/2, 1 - a) in the approach, and an incomplete beta function in the hold.
    """
    from scipy.special import beta, betainc

    begun = -2e-7 / SPEED
    touched = DEEPEST / SPEED
    time = np.concatenate([np.linspace(begun, touched, 120), np.linspace(touched, touched + HOLD, 120)[1:]])
    since = np.maximum(time, 1e-9)
    share = betainc(1.5, 1.0 - EXPONENT, np.minimum(1.0, touched / since)) * beta(1.5, 1.0 - EXPONENT)
    loaded = 8.0 * SHEAR * np.sqrt(RADIUS) * SPEED**1.5 * since ** (1.5 - EXPONENT) * share
    force = np.where(time > 0.0, loaded, 0.0) + NOISE * np.random.default_rng(2).standard_normal(time.size)
    depth = SPEED * np.minimum(time, touched)
    rows = (f"{t - begun:.6f}, {1e9 * d:.3f}, {1e9 * f:.5f}" for t, d, f in zip(time, depth, force, strict=True))
    head = "# NOT a measurement: a ball of 5 um on a body of G = 1.5 kPa (t / 1 s)^-0.15, with noise"
    return ("\n".join((head, "time [s], depth [nm], force [nN]", *rows)) + "\n").encode()


def metal_sample_curve() -> bytes:
    """Return the text of the curve of a metal: the forces of `PlasticIndentation` over the depth, with white noise."""
    from winkler.foundation.foundation import Foundation
    from winkler.loading.loads import Depth
    from winkler.materials.elastic import Elastic
    from winkler.media.halfspace import HalfSpace
    from winkler.problems.plastic.indentation import PlasticIndentation
    from winkler.profiles.power import Paraboloid

    depth = np.concatenate([np.linspace(-8e-9, 2e-8, 180), np.linspace(2e-8, -2e-9, 120)])
    bed = Foundation(Paraboloid(RADIUS), HalfSpace(Elastic(210e9, 0.3, strength=400e6)))
    force = PlasticIndentation(bed, Depth(depth)).solve().force
    force = force + 1e-3 * force.max() * np.random.default_rng(3).standard_normal(depth.size)
    rows = (f"{1e9 * d:.4f}, {1e6 * f:.4f}" for d, f in zip(depth, force, strict=True))
    head = "# NOT a measurement: a ball of 5 um on a metal of 210 GPa that yields at 400 MPa, with noise"
    return ("\n".join((head, "depth [nm], force [uN]", *rows)) + "\n").encode()


SAMPLES = {SAMPLE: sample_curve, RELAXING_SAMPLE: relaxing_sample_curve, METAL_SAMPLE: metal_sample_curve}
"""File -> what makes it."""
