"""Moduli of the transversely isotropic half-space, from the equations of elasticity in 40 digits (theory 1.1)."""

from __future__ import annotations

import mpmath as mp
import pytest

from winkler.reference.transverse import transverse_modulus, transverse_shear_modulus

SOLIDS = {
    (10.0, 4.0, 3.5, 12.0, 3.0): (9.558861079, 7.110690701),
    (5.0, 2.0, 2.2, 20.0, 1.2): (8.737080168, 3.324537596),
}


def compliances(c11, c13, c33, c44):
    """Normal and in-plane tangential compliance xi u/(2 p) of the surface harmonics; the first is 1/E*.

    Plane waves u_x = U e^(-s z) sin x, u_z = W e^(-s z) cos x in equilibrium, (C11 - C44 s^2) U = (C13 + C44) s W and
    (C33 s^2 - C44) W = (C13 + C44) s U; the two modes that decay are fitted to the tractions of the surface.
    """
    c11, c13, c33, c44 = (mp.mpf(c) for c in (c11, c13, c33, c44))
    mix = c13 + c44
    half = (c11 * c33 + c44**2 - mix**2) / (2 * c33 * c44)
    root = mp.sqrt(mp.mpc(half**2 - c11 / c33))
    modes = []
    for square in (half + root, half - root):
        s = mp.sqrt(square)
        u, w = mix * s, c11 - c44 * square
        assert abs((c33 * square - c44) * w - mix * s * u) < mp.mpf("1e-30")
        modes.append((u, w, c13 * u - c33 * s * w, -c44 * (s * u + w)))
    (u1, w1, p1, t1), (u2, w2, p2, t2) = modes
    det = p1 * t2 - p2 * t1
    normal = (-t2 * w1 + t1 * w2) / det
    tangential = (p2 * u1 - p1 * u2) / det
    return mp.re(normal) / 2, mp.re(tangential) / 2


@pytest.mark.parametrize("solid", SOLIDS)
def test_moduli_solve_elasticity(solid):
    c11, c12, c13, c33, c44 = solid
    normal, in_plane = compliances(c11, c13, c33, c44)
    given = transverse_modulus(c11=c11, c13=c13, c33=c33, c44=c44)
    assert abs(given * normal - 1) < 1e-14
    anti_plane = 1 / (2 * mp.sqrt(mp.mpf(c44) * (mp.mpf(c11) - mp.mpf(c12)) / 2))
    shear = transverse_shear_modulus(c11=c11, c12=c12, c13=c13, c33=c33, c44=c44)
    assert abs(shear * (in_plane + anti_plane) / 2 - 1) < 1e-14


@pytest.mark.parametrize(("solid", "moduli"), SOLIDS.items())
def test_numbers_of_theory(solid, moduli):
    c11, c12, c13, c33, c44 = solid
    assert transverse_modulus(c11=c11, c13=c13, c33=c33, c44=c44) == pytest.approx(moduli[0], rel=2e-10)
    assert transverse_shear_modulus(c11=c11, c12=c12, c13=c13, c33=c33, c44=c44) == pytest.approx(moduli[1], rel=2e-10)


@pytest.mark.parametrize("poisson", [-0.4, 0.0, 0.3, 0.49])
def test_isotropic_limit(poisson):
    g = 1.7
    lame = 2.0 * g * poisson / (1.0 - 2.0 * poisson)
    c11 = lame + 2.0 * g
    modulus = transverse_modulus(c11=c11, c13=lame, c33=c11, c44=g)
    assert modulus == pytest.approx(2.0 * g / (1.0 - poisson), rel=1e-13)
    shear = transverse_shear_modulus(c11=c11, c12=lame, c13=lame, c33=c11, c44=g)
    assert shear == pytest.approx(4.0 * g / (2.0 - poisson), rel=1e-13)
