"""A paraboloid with two curvatures pressed into a half-space: Hertz's elliptic contact, in mpmath.

With the semi-axes a > b of the ellipse, m = 1 - b^2/a^2 and the peak pressure p (Hertz 1882; Johnson 1985, section 4.2)

    1/(2 R_a) = (p/E*) (b/(a^2 m)) (K - E),   1/(2 R_b) = (p/E*) (b/(a^2 m)) ((a/b)^2 E - K),   d = (p/E*) b K,

and F = (2/3) pi a b p: all similar, F = C d^(3/2).
"""

from __future__ import annotations

import mpmath as mp


def parameter(ratio: mp.mpf) -> mp.mpf:
    """m of the ellipse for R_a/R_b = ratio > 1."""

    def mismatch(m: mp.mpf) -> mp.mpf:
        k, e = mp.ellipk(m), mp.ellipe(m)
        return (e / (1 - m) - k) / (k - e) - ratio

    return mp.findroot(mismatch, (mp.mpf("0.3"), mp.mpf("0.9")), solver="anderson")


def force(depth: mp.mpf, long: mp.mpf, short: mp.mpf, modulus: mp.mpf) -> mp.mpf:
    """F at a depth; `long` and `short` are the radii of curvature R_a > R_b."""
    m = parameter(long / short)
    k, e = mp.ellipk(m), mp.ellipe(m)
    # d = 2 R_a (K/(K - E)) ... : eliminate p between the first and the last equation
    a = mp.sqrt(2 * long * depth * (k - e) / (m * k))
    b = a * mp.sqrt(1 - m)
    return 2 * mp.pi / 3 * a * b * modulus * depth / (b * k)
