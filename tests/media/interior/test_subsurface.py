"""The field below any axisymmetric contact, against integrals at 30 digits, closed forms and the laws of elasticity."""

from __future__ import annotations

import itertools
from dataclasses import dataclass
from functools import cache

import mpmath as mp
import numpy as np
import pytest

from winkler.media.interior.subsurface import field
from winkler.numerics.integrals.quadrature import tanh_sinh
from winkler.values.errors import InvalidInput, NotConverged

POISSON, SHEAR = 0.3, 0.7
MODULUS = 2.0 * SHEAR / (1.0 - POISSON)  # a rigid second body: u_z at the surface is the displacement of the contact


@dataclass(frozen=True)
class Hertz:
    """Paraboloid f = r^2/2R."""

    radius: float = 0.5
    curvature_radius: float = 1.0
    kinks: tuple = ()
    edge: float = 0.0

    def value(self, x):
        return (self.radius - x) * (self.radius + x) / self.curvature_radius

    def slope(self, x):
        return -2.0 * x / self.curvature_radius


@dataclass(frozen=True)
class Cone:
    """f = r tan."""

    radius: float = 0.5
    tan: float = 0.1
    kinks: tuple = ()
    edge: float = 0.0

    def value(self, x):
        return mp.pi / 2 * self.tan * (self.radius - x)

    def slope(self, x):
        return np.full(np.shape(x), -0.5 * np.pi * self.tan)


@dataclass(frozen=True)
class TruncatedCone:
    """A cone with a flat of radius b."""

    radius: float = 0.5
    flat: float = 0.2
    tan: float = 0.1
    edge: float = 0.0

    @property
    def kinks(self):
        return ((self.flat, self.tan * self.flat),)

    def gap(self, x):
        return self.tan * x * mp.acos(self.flat / x) if x > self.flat else mp.mpf(0)

    def value(self, x):
        return self.gap(mp.mpf(self.radius)) - self.gap(x)

    def slope(self, x):
        root = np.sqrt(np.maximum(x - self.flat, 0.0) * (x + self.flat))
        above = x > self.flat
        rise = np.arctan2(root, self.flat) + self.flat / np.where(above, root, 1.0)
        return np.where(above, -self.tan * rise, 0.0)


@dataclass(frozen=True)
class Power:
    """g = x^n."""

    exponent: float
    radius: float = 0.5
    kinks: tuple = ()
    edge: float = 0.0

    def value(self, x):
        return mp.mpf(self.radius) ** self.exponent - x**self.exponent

    def slope(self, x):
        return -self.exponent * x ** (self.exponent - 1.0)


@dataclass(frozen=True)
class Pinned:
    """Another displacement, pressed deeper by `edge` at a fixed radius."""

    other: Hertz | TruncatedCone
    edge: float

    @property
    def radius(self):
        return self.other.radius

    @property
    def kinks(self):
        return self.other.kinks

    def value(self, x):
        return self.other.value(x) + self.edge

    def slope(self, x):
        return self.other.slope(x)


@dataclass(frozen=True)
class Flat:
    """A flat punch."""

    radius: float
    edge: float
    kinks: tuple = ()

    def value(self, x):
        return self.edge + 0 * x

    def slope(self, x):
        return np.zeros(np.shape(x))


@dataclass(frozen=True)
class Scallops:
    """Many kinks, where half powers start: u = sum of c (a^2 - b^2)^(3/2) - c (x^2 - b^2)^(3/2)."""

    places: tuple
    factors: tuple
    radius: float = 0.5
    edge: float = 0.0

    @property
    def kinks(self):
        return tuple((b, 0.0) for b in self.places)

    def slope(self, x):
        return sum(
            -3.0 * c * x * np.sqrt(np.maximum(x - b, 0.0) * (x + b))
            for b, c in zip(self.places, self.factors, strict=True)
        )


CASES = {
    "hertz": Hertz(),
    "cone": Cone(),
    "truncated cone": TruncatedCone(),
    "tiny flat": TruncatedCone(flat=0.004),
    "pinned truncated cone": Pinned(TruncatedCone(), 0.01),
    "power 1.5": Power(1.5),
    "flat": Flat(0.5, 0.02),
}


def stress(displacement, r, z, poisson=POISSON):
    """The six components, stacked."""
    r, z = np.broadcast_arrays(r, z)
    return np.array(field(displacement, r, z, modulus=MODULUS, poisson=poisson, shear=SHEAR))


def mean(displacement) -> float:
    """A pressure that measures the others, E* u(0) / a."""
    return MODULUS * float(displacement.value(mp.mpf(0))) / displacement.radius


# ------------------------------------------------------------------------------------- integrals at 30 digits


@cache
def rule(count: int = 220):
    """Tanh-sinh on [0, 1] in mpmath, independent of the package's."""
    step = mp.mpf(8) / count
    result = []
    for i in range(-count // 2, count // 2 + 1):
        e = mp.exp(-mp.pi * mp.sinh(i * step))
        result.append((1 / (1 + e), step * mp.pi * mp.cosh(i * step) * e / (1 + e) ** 2))
    return result


def direct(displacement, r, z):
    """Theory 1.2 as it stands: potentials of the line load q = E* u, no punches, integrated at 30 digits."""
    with mp.workdps(30):
        r, z, nu = mp.mpf(r), mp.mpf(z), mp.mpf(POISSON)
        a = mp.mpf(displacement.radius)
        cuts = {mp.mpf(0), a, *(mp.mpf(b) for b, _ in displacement.kinks)}
        cuts |= {t for far in (0, 3, 30, 300, 3000) for t in (r - far * z, r + far * z) if 0 < t < a}
        cuts = sorted(cuts)
        total = [mp.mpc(0)] * 6
        for low, high in itertools.pairwise(cuts):
            for node, weight in rule():
                t = low + (high - low) * node
                q = displacement.value(t) * weight * (high - low)
                zeta = mp.mpc(z, t)
                rho = mp.sqrt(r * r + zeta * zeta)
                cube = q / rho**3
                quintic = 3 * cube / rho**2
                kernels = (
                    q / rho,
                    -zeta * cube,
                    -cube + zeta**2 * quintic,
                    r * zeta * quintic,
                    -cube,
                    q / (rho * (rho + zeta)),
                )
                total = [old + new for old, new in zip(total, kernels, strict=True)]
        v, v_z, v_zz, v_rz, v_r_by_r, psi = (2 * MODULUS * mp.re(part) for part in total)
        v_rr, psi_rr = -v_zz - v_r_by_r, -psi - v_z
        return [
            float(number)
            for number in (
                (2 * nu * v_z - z * v_rr - (1 - 2 * nu) * psi_rr) / (2 * mp.pi),
                (2 * nu * v_z - z * v_r_by_r - (1 - 2 * nu) * psi) / (2 * mp.pi),
                (v_z - z * v_zz) / (2 * mp.pi),
                -z * v_rz / (2 * mp.pi),
                -r * ((1 - 2 * nu) * psi + z * v_r_by_r) / (4 * mp.pi * SHEAR),
                (2 * (1 - nu) * v - z * v_z) / (4 * mp.pi * SHEAR),
            )
        ]


def compared(name, places):
    displacement = CASES[name]
    scale = np.array([mean(displacement)] * 4 + [mean(displacement) * displacement.radius / MODULUS] * 2)
    for r, z in places:
        error = np.abs(stress(displacement, np.array(r), np.array(z)) - direct(displacement, r, z)) / scale
        assert np.all(error < 2e-12), (r, z, error)


@pytest.mark.few(0, slow=3)
@pytest.mark.parametrize("name", CASES)
def test_direct_integration(name):
    compared(name, [(0.2 + 1e-7, 1e-3), (0.37, 0.11)])


@pytest.mark.few(0, slow=1)
@pytest.mark.parametrize("name", CASES)
def test_direct_integration_at_random_places(name):
    random = np.random.default_rng(11)
    a = CASES[name].radius
    r = a * np.concatenate(
        [[0.0, 1.0, 0.4, 1.0 - 1e-9], random.uniform(0.0, 1.2, 3), 10.0 ** random.uniform(-3, 1.7, 3)]
    )
    z = a * 10.0 ** random.uniform(-6.0, 1.7, r.size)
    compared(name, zip(r, z, strict=True))


# ------------------------------------------------------------------------------------------- published numbers


def test_hertz_on_the_axis():
    z = np.concatenate([[0.0], np.geomspace(1e-9, 50.0, 40)])
    p0 = 2.0 * MODULUS * 0.5 / np.pi
    radial, hoop, axial, shear, outward, _ = stress(Hertz(), np.zeros(z.size), 0.5 * z)
    with mp.workdps(30):
        want = [
            float(-(1 + mp.mpf(POISSON)) * (1 - x * (mp.pi / 2 - mp.atan(x))) + 1 / (2 * (1 + mp.mpf(x) ** 2)))
            for x in z
        ]
    assert np.allclose(axial / p0, -1.0 / (1.0 + z * z), rtol=0.0, atol=2e-14)
    assert np.allclose(radial / p0, want, rtol=0.0, atol=2e-14)
    assert np.array_equal(radial, hoop)
    assert np.all(shear == 0.0)
    assert np.all(outward == 0.0)


@pytest.mark.parametrize(
    ("poisson", "most", "depth"),
    [
        (0.0, 0.384821111, 0.3819362007),
        (0.25, 0.3216784032, 0.464313193),
        (0.3, 0.310020502, 0.4808644853),
        (0.5, 0.2663485631, 0.5478684611),
    ],
)
def test_greatest_shear_stress_of_hertz(poisson, most, depth):
    z = 0.5 * (depth + 1e-4 * np.array([-1.0, 0.0, 1.0]))
    radial, hoop, axial, shear, *_ = stress(Hertz(), np.zeros(3), z, poisson) / (MODULUS / np.pi)
    tau = 0.5 * np.abs(axial - radial)
    assert abs(tau[1] - most) < 5e-10
    assert tau[1] > tau[0]
    assert tau[1] > tau[2]
    parabola = 0.5e-4 * (tau[0] - tau[2]) / (tau[0] - 2.0 * tau[1] + tau[2])
    assert abs(parabola) < 2e-8  # the place of the greatest, relative to the radius
    mises = np.sqrt(0.5 * ((radial - hoop) ** 2 + (hoop - axial) ** 2 + (axial - radial) ** 2) + 3.0 * shear**2)
    assert np.allclose(mises, 2.0 * tau, rtol=1e-13)


def test_published_point_below_a_flat_punch():
    r, z = np.array(0.6), np.array(0.5)
    got = field(Flat(1.0, 1.0), r, z, modulus=1.0, poisson=0.3, shear=0.35)
    want = (-0.111543335814, -0.138748156999, -0.409245048135, -0.0193774365764)
    assert np.allclose(got[:4], want, rtol=0.0, atol=6e-13)


# ------------------------------------------------------------------------------------------------- the surface


def test_surface_of_hertz():
    """Johnson, Contact Mechanics, eqs. (3.42), (3.43): the stresses of the surface, inside and outside."""
    x = np.array([1e-9, 0.1, 0.5, 0.999, 1.0 - 1e-12, 1.0, 1.0 + 1e-12, 1.001, 2.0, 30.0])
    p0, nu = MODULUS / np.pi, POISSON
    pressure = np.sqrt(np.maximum(1.0 - x, 0.0) * (1.0 + x))
    lateral = (1.0 - 2.0 * nu) / (3.0 * x * x) * -np.where(x < 1e-4, -1.5 * x * x, pressure**3 - 1.0)
    radial, hoop, axial, shear, outward, inward = stress(Hertz(), 0.5 * x, np.zeros(x.size))
    assert np.allclose(axial / p0, -pressure, rtol=0.0, atol=1e-13)
    assert np.allclose(radial / p0, lateral - pressure, rtol=0.0, atol=1e-13)
    assert np.allclose(hoop / p0, -lateral - 2.0 * nu * pressure, rtol=0.0, atol=1e-13)
    assert np.isclose(radial[5] / p0, (1.0 - 2.0 * nu) / 3.0, rtol=1e-13)
    assert np.all(shear == 0.0)
    outside = np.maximum(x, 1.0)
    tail = (2.0 - outside**2) * np.arcsin(1.0 / outside) + np.sqrt(outside**2 - 1.0)
    want = np.where(x < 1.0, 0.25 * (1.0 - 0.5 * x * x), 0.25 / np.pi * tail)
    assert np.allclose(inward, want, rtol=0.0, atol=1e-14)
    # Johnson, eq. (3.41c)
    sunk = -(1.0 - 2.0 * nu) / (3.0 * 2.0 * SHEAR) * p0 * 0.5 / x * np.where(x < 1e-4, 1.5 * x * x, 1.0 - pressure**3)
    assert np.allclose(outward, sunk, rtol=1e-12, atol=1e-15)


def test_surface_of_a_cone():
    x = np.array([1e-12, 1e-6, 0.2, 0.9, 1.0])
    _, _, axial, _, _, inward = stress(Cone(), 0.5 * x, np.zeros(x.size))
    assert np.allclose(axial, -0.05 * MODULUS * np.arccosh(1.0 / x), rtol=1e-13, atol=1e-15)
    assert np.allclose(inward, 0.05 * (0.5 * np.pi - x), rtol=0.0, atol=1e-15)


def truncated_cone_pressure(r):
    """Int_r^a g'(x) / sqrt(x^2 - r^2) dx over y = sqrt(x^2 - max(r, b)^2)."""
    b, a, tan = mp.mpf(0.2), mp.mpf(0.5), mp.mpf(0.1)
    start = max(r, b)

    def integrand(y):
        x = mp.sqrt(start**2 + y * y)
        slope = tan * (mp.acos(b / x) + b / mp.sqrt(start**2 - b * b + y * y))
        return slope / mp.sqrt(start**2 - r * r + y * y) * y / x

    top = mp.sqrt(a * a - start**2)
    return mp.quad(integrand, [0, *(top * mp.mpf(10) ** -k for k in range(8, 0, -1)), top])


@pytest.mark.slow
def test_surface_of_a_truncated_cone():
    """T4 by 30-digit integration, to the sides of the kink as well."""
    u = TruncatedCone()
    for r in (0.0, 0.1, 0.2 * (1 - 1e-6), 0.2 * (1 + 1e-6), 0.45):
        with mp.workdps(30):
            want = truncated_cone_pressure(mp.mpf(r))
        axial = stress(u, np.array(r), np.array(0.0))[2]
        assert np.isclose(axial, -MODULUS / np.pi * float(want), rtol=1e-11), r


def test_pressure_at_the_tip_of_a_power():
    """p(0) = (E*/pi) Int_0^a n x^(n-2) dx = (E*/pi) n a^(n-1) / (n - 1)."""
    for n in (1.2, 1.5, 2.0, 2.5, 4.0):
        axial = stress(Power(n), np.array(0.0), np.array(0.0))[2]
        assert np.isclose(axial, -MODULUS / np.pi * n * 0.5 ** (n - 1.0) / (n - 1.0), rtol=1e-10), n


@pytest.mark.parametrize("name", CASES)
def test_the_depth_passes_into_the_surface(name):
    displacement = CASES[name]
    a = displacement.radius
    scale = mean(displacement)
    r = a * np.array([1e-3, 0.1, 0.39, 0.41, 0.75, 0.99, 1.01, 1.5, 20.0])
    on = stress(displacement, r, np.zeros(r.size))
    for z, far in ((1e-6, 2e-3), (1e-8, 2e-5), (1e-12, 2e-9)):
        assert np.max(np.abs(stress(displacement, r, np.full(r.size, z * a)) - on)) < far * scale


def test_lateral_stresses_of_the_surface():
    """sigma_r + sigma_theta = -(1 + 2 nu) p below the contact, 0 beside it."""
    for displacement in CASES.values():
        r = displacement.radius * np.array([0.0, 1e-7, 0.3, 0.8, 1.2, 9.0])
        radial, hoop, axial, *_ = stress(displacement, r, np.zeros(r.size))
        finite = np.isfinite(axial)
        assert np.allclose((radial + hoop)[finite], (1.0 + 2.0 * POISSON) * axial[finite], rtol=1e-13, atol=1e-16)
        assert np.all(axial[-2:] == 0.0)


def test_where_the_surface_stress_is_infinite():
    minus = -np.inf
    assert np.all(stress(Cone(), np.array(0.0), np.array(0.0))[:3] == minus)
    assert np.all(stress(TruncatedCone(), np.array(0.2), np.array(0.0))[:3] == minus)
    assert np.all(stress(Pinned(Hertz(), 0.01), np.array(0.5), np.array(0.0))[:3] == minus)
    pulled = stress(Pinned(Hertz(), -0.01), np.array(0.5), np.array(0.0))  # an adhesive edge
    assert np.all(pulled[:3] == np.inf)
    # ... and nowhere else, displacements never
    r = np.array([0.0, 0.2, 0.5])
    assert np.all(np.isfinite(stress(Pinned(TruncatedCone(), 0.01), r, np.full(3, 1e-30))))
    assert np.all(np.isfinite(stress(Pinned(TruncatedCone(), 0.01), r, np.zeros(3))[4:]))
    assert np.all(np.isfinite(stress(Hertz(), r, np.zeros(3))))


# -------------------------------------------------------------------------------------------- laws of elasticity

# eighth-order central differences
OFFSETS = np.array([-4, -3, -2, -1, 1, 2, 3, 4])
FACTORS = np.array([1 / 280, -4 / 105, 1 / 5, -4 / 5, 4 / 5, -1 / 5, 4 / 105, -1 / 280])


def slopes(displacement, r, z):
    """The derivatives of all six components with r and z."""
    step = 0.02 * z
    along_r = stress(displacement, r + np.outer(OFFSETS, step), z)
    along_z = stress(displacement, r, z + np.outer(OFFSETS, step))
    return (np.einsum("k,ckn->cn", FACTORS, part) / step for part in (along_r, along_z))


@pytest.mark.parametrize("name", CASES)
def test_equilibrium_and_hooke(name):
    displacement = CASES[name]
    random = np.random.default_rng(2)
    a = displacement.radius
    z = a * 10.0 ** random.uniform(-2.0, 1.0, 40)
    r = np.maximum(a * 10.0 ** random.uniform(-1.0, 0.7, 40), 0.2 * z)
    radial, hoop, axial, shear, outward, _ = stress(displacement, r, z)
    by_r, by_z = slopes(displacement, r, z)
    scale = mean(displacement)
    assert np.max(np.abs(by_r[0] + by_z[3] + (radial - hoop) / r) * z) < 1e-9 * scale
    assert np.max(np.abs(by_r[3] + by_z[2] + shear / r) * z) < 1e-9 * scale
    volume = by_r[4] + outward / r + by_z[5]
    lame = 2.0 * SHEAR * POISSON / (1.0 - 2.0 * POISSON)
    for got, strain in ((radial, by_r[4]), (hoop, outward / r), (axial, by_z[5])):
        assert np.max(np.abs(lame * volume + 2.0 * SHEAR * strain - got)) < 1e-9 * scale
    assert np.max(np.abs(SHEAR * (by_z[4] + by_r[5]) - shear)) < 1e-9 * scale


@pytest.mark.parametrize("name", CASES)
@pytest.mark.parametrize("depth", [1e-3, 0.05, 0.5, 3.0, 40.0])
def test_every_plane_carries_the_force(name, depth):
    """F = -2 pi Int sigma_z r dr over any plane z = const equals 2 E* Int_0^a u dx."""
    displacement = CASES[name]
    a = displacement.radius
    z = depth * a
    nodes, complements, weights = tanh_sinh(161)
    cuts = [0.0, *(b for b, _ in displacement.kinks), a, a + 3.0 * z]
    total = 0.0
    for low, high in itertools.pairwise(cuts):
        r = np.where(nodes < 0.5, low + (high - low) * nodes, high - (high - low) * complements)
        total += (high - low) * np.sum(weights * stress(displacement, r, np.full(r.size, z))[2] * r)
    start = cuts[-1]
    inverse = nodes[nodes > 1e-12]  # r = start/x to infinity, where sigma_z falls like r^-5
    r = start / inverse
    total += np.sum(weights[nodes > 1e-12] * stress(displacement, r, np.full(r.size, z))[2] * r * start / inverse**2)
    with mp.workdps(20):
        cuts = [0, *(b for b, _ in displacement.kinks), a]
        force = 2.0 * MODULUS * float(mp.quad(displacement.value, cuts))
    assert np.isclose(-2.0 * np.pi * total, force, rtol=1e-9)


# -------------------------------------------------------------------------------------------- how it is computed


@pytest.mark.slow
def test_many_kinks_are_the_sum_of_few():
    """Far from a point neighbouring panels are lumped together; superposition shows whether that costs digits."""
    random = np.random.default_rng(4)
    places, factors = tuple(np.linspace(0.0, 0.49, 60)), tuple(random.uniform(-1.0, 1.0, 60))
    r = np.concatenate([[0.0, 0.5, places[7]], 10.0 ** random.uniform(-3.0, 1.0, 60)])
    z = 10.0 ** random.uniform(-6.0, 1.0, r.size)
    z[:2] = 0.0
    whole = stress(Scallops(places, factors), r, z)
    parts = [stress(Scallops((b,), (c,)), r, z) for b, c in zip(places, factors, strict=True)]
    assert np.allclose(whole, sum(parts), rtol=0.0, atol=1e-13 * np.abs(factors).sum())


def test_a_kink_that_nobody_stated_is_found():
    class Unstated(Scallops):
        @property
        def kinks(self):
            return ()

    r, z = np.array([0.0, 0.1, 0.2, 0.3, 0.7]), np.array([0.0, 1e-3, 0.1, 0.0, 0.2])
    stated, unstated = (stress(kind((0.2,), (1.0,)), r, z) for kind in (Scallops, Unstated))
    assert np.allclose(stated, unstated, rtol=0.0, atol=1e-11)


def test_lengths_scale():
    """A contact of nanometres has the stresses of one of metres."""
    r, z = np.array([0.0, 0.2, 0.4999, 0.5, 3.0]), np.array([0.0, 1e-3, 1e-7, 0.5, 9.0])
    big = stress(TruncatedCone(), r, z)
    small = stress(TruncatedCone(radius=0.5e-9, flat=0.2e-9), 1e-9 * r, 1e-9 * z)
    assert np.allclose(small[:4], big[:4], rtol=1e-7, atol=1e-15)
    assert np.allclose(small[4:], 1e-9 * big[4:], rtol=1e-7, atol=1e-24)


def test_shapes():
    got = field(
        Hertz(), np.linspace(0.0, 1.0, 4)[:, None], np.array([0.0, 0.1, 5.0]), modulus=1.0, poisson=0.3, shear=1.0
    )
    assert {part.shape for part in got} == {(4, 3)}
    one = field(Hertz(), np.array(0.1), np.array(0.1), modulus=1.0, poisson=0.3, shear=1.0)
    assert {part.shape for part in one} == {()}
    none = field(Hertz(), np.zeros(0), np.zeros(0), modulus=1.0, poisson=0.3, shear=1.0)
    assert {part.shape for part in none} == {(0,)}


def test_no_contact_no_stress():
    assert np.all(stress(Hertz(radius=0.0), np.array([0.0, 0.1]), np.array([0.0, 0.2])) == 0.0)


@pytest.mark.parametrize("bad", [-1e-9, np.nan, np.inf])
def test_places_outside_the_body_are_refused(bad):
    for r, z, word in (([0.1, bad], [0.0, 0.0], "r"), ([0.1, 0.2], [0.1, bad], "z")):
        with pytest.raises(InvalidInput, match=rf"^{word}: \S+ m is not a place in the body"):
            stress(Hertz(), np.array(r), np.array(z))


def test_a_rough_slope_is_refused():
    @dataclass(frozen=True)
    class Rough(Hertz):
        def slope(self, x):
            return np.sign(np.sin(1e7 * x))

    with pytest.raises(NotConverged, match=r"u'\(x\) is not smooth near x = "):
        stress(Rough(), np.array(0.1), np.array(0.1))


def test_a_slope_that_is_no_number_is_refused():
    @dataclass(frozen=True)
    class Broken(Hertz):
        def slope(self, x):
            return np.where(x > 0.3, np.nan, x)

    with pytest.raises(NotConverged):
        stress(Broken(), np.array(0.1), np.array(0.1))
