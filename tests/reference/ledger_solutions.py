"""The numbers of the cases that came last, computed without winkler: one function a case, in the order of [[expect]].

Point forces summed over a disc, closed forms and integrals by mpmath, equations solved by scipy.  Units are those in
which E* = R = 1, unless a case states more.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import mpmath as mp
import numpy as np
import strip_solution
from reference_solutions import ReferenceSolutions, frac
from scipy.optimize import brentq

Numbers = list[Any]
REFERENCES = ReferenceSolutions()
of_case = REFERENCES.of_case


# ---------------------------------------------------------------------------------------------------------------------
# stresses inside, of point forces


def boussinesq(x: Any, y: Any, z: float, nu: float) -> np.ndarray:
    """Stresses of a unit force into the body (Johnson 3.18), xx, yy, zz, xy, xz, yz."""
    big = np.sqrt(x * x + y * y + z * z)
    square, soft = x * x + y * y, 1.0 - 2.0 * nu
    near = 1.0 / (big * (big + z))  # (1 - z/rho)/r^2
    xx = soft * (near * (x * x - y * y) + z * y * y / big**3) / square - 3.0 * z * x * x / big**5
    yy = soft * (near * (y * y - x * x) + z * x * x / big**3) / square - 3.0 * z * y * y / big**5
    xy = soft * (2.0 * near - z / big**3) * x * y / square - 3.0 * x * y * z / big**5
    rest = (-3.0 * z**3 / big**5, xy, -3.0 * x * z * z / big**5, -3.0 * y * z * z / big**5)
    return np.array([xx, yy, *rest]) / (2.0 * np.pi)


def cerruti(x: Any, y: Any, z: float, nu: float) -> np.ndarray:
    """Stresses of a unit force along x on the body (Johnson 3.76)."""
    big = np.sqrt(x * x + y * y + z * z)
    soft, one = 1.0 - 2.0 * nu, 1.0 / (big + z)
    both = one**2 / big**3 + 2.0 * one**3 / big**2
    xx = soft * (x / big**3 - 3.0 * x * one**2 / big + x**3 * both) - 3.0 * x**3 / big**5
    yy = soft * (x / big**3 - x * one**2 / big + x * y * y * both) - 3.0 * x * y * y / big**5
    xy = soft * (-y * one**2 / big + x * x * y * both) - 3.0 * x * x * y / big**5
    rest = (-3.0 * x * z * z / big**5, xy, -3.0 * x * x * z / big**5, -3.0 * x * y * z / big**5)
    return np.array([xx, yy, *rest]) / (2.0 * np.pi)


def over_the_disc(kernel: Callable[..., np.ndarray], x: float, y: float, z: float, nu: float) -> np.ndarray:
    """A kernel times sqrt(1 - r^2), summed over the unit disc: r = sin t by Gauss, angles evenly."""
    node, weight = np.polynomial.legendre.leggauss(160)
    t, weight = 0.25 * np.pi * (node + 1.0), 0.25 * np.pi * weight
    turn = 2.0 * np.pi * (np.arange(400) + 0.5) / 400
    r = np.sin(t)
    found = kernel(x - r[:, None] * np.cos(turn), y - r[:, None] * np.sin(turn), z, nu)
    return np.einsum("kij,i->k", found, weight * np.cos(t) ** 2 * r) * 2.0 * np.pi / 400


@of_case
def sliding_ball_inside() -> Numbers:
    """p0 = mu = a = 1, nu = 0.3: pressure and traction sqrt(1 - r^2), at (0.5, 0.2, 0.4)."""
    place = (0.5, 0.2, 0.4, 0.3)
    return list(over_the_disc(boussinesq, *place) + over_the_disc(cerruti, *place))


# ---------------------------------------------------------------------------------------------------------------------
# shear in the plane: mu = 0.3, b = mu (1 - x^2), half of the shift of sliding is 0.15


@of_case
def two_strokes_overshoot() -> Numbers:
    """At r = 0.71 every spring has slid along x, then turns on its bound: b (sech(s/b), tanh(s/b))."""
    stroke, mu, r = frac("0.15"), frac("0.3"), frac("0.71")

    def along(x: mp.mpf) -> mp.mpf:
        far = stroke / (mu * (1 - x * x))
        return -2 * mu * x * mp.sech(far) * (1 + far * mp.tanh(far))

    def across(x: mp.mpf) -> mp.mpf:
        far = stroke / (mu * (1 - x * x))
        return -2 * mu * x * (mp.tanh(far) - far * mp.sech(far) ** 2)

    end = frac("0.9999999")  # the springs at the edge have long turned, with slopes that no longer count
    whole = mp.acosh(end / r)
    found = [-mp.quad(lambda w, f=f: f(r * mp.cosh(w)), mp.linspace(0, whole, 5)) / mp.pi for f in (along, across)]
    rim = mp.quad(lambda w: 2 * mu * r * mp.cosh(w), [whole, mp.acosh(1 / r)]) / mp.pi
    return [found[0], found[1] + rim]


@of_case
def steady_circle_overshoot() -> Numbers:
    """A spring of the bound b is displaced ahead of the motion by an angle with the cosine b/0.15; at r = 0.7."""
    r, stick = frac("0.7"), mp.sqrt(frac("0.5"))

    def ahead(v: mp.mpf) -> mp.mpf:
        """u_y' dx/dv / sqrt(x^2 - r^2) at x = c + (1 - c) v^2, where u_y' is like 1/v."""
        x = stick + (1 - stick) * v * v
        part, less = 2 * (1 - x * x), 2 * (1 - stick) * v * v * (x + stick)
        root = mp.sqrt(less * (1 + part))
        return -frac("0.6") * x * (root - part**2 / root) * 2 * (1 - stick) * v / mp.sqrt(x * x - r * r)

    along = mp.quad(
        lambda x: frac("-2.4") * x * (1 - x * x) / mp.sqrt(x * x - r * r), [stick, frac("0.72"), frac("0.8"), 1]
    )
    return [-along / mp.pi, -mp.quad(ahead, [0, frac("0.1"), frac("0.3"), 1]) / mp.pi]


# ---------------------------------------------------------------------------------------------------------------------
# an even pressure: springs under an ellipsoid, q = E* d sqrt(1 - x^2), p = E* d/2; steel, d = 1 um, a = 1 mm

PRESSED = frac("210e9") / (2 * frac("0.91")) * frac("1e-6") / frac("2e-3")


@of_case
def even_pressure() -> Numbers:
    """F = pi p a^2, q = 2 p sqrt(a^2 - x^2); E* = d = a = 1, p = 1/2."""
    return [mp.pi / 2, mp.mpf(1), frac("0.8")]


def _even_heat(speed: str) -> mp.mpf:
    """mu p v over lambda/a [K]."""
    return frac("0.3") * PRESSED * frac(speed) * frac("1e-3") / 45


@of_case
def even_heat_at_rest() -> Numbers:
    """T = (2 q a/(pi lambda)) E(r^2/a^2): q a/lambda in the middle, 2/pi of it at the rim, 8/(3 pi) in the mean."""
    unit = _even_heat("1e-9")
    return [unit, 8 / (3 * mp.pi) * unit, 2 / mp.pi * mp.ellipe(frac("0.25")) * unit, 2 / mp.pi * unit]


def even_moving(peclet: float, x: float) -> float:
    """T over q a/lambda at x under an even flux: sources in polar coordinates, their lines in closed form."""
    turn = 2.0 * np.pi * (np.arange(4000) + 0.5) / 4000
    chord = x * np.cos(turn) + np.sqrt(1.0 - (x * np.sin(turn)) ** 2)
    rate = peclet * (1.0 - np.cos(turn))
    return float(np.mean(chord * np.where(rate * chord > 1e-12, -np.expm1(-rate * chord) / (rate * chord), 1.0)))


@of_case
def even_heat_speeds() -> Numbers:
    """The greatest temperature along the line of motion, and the excess of the rule at rest."""
    tops = []
    for peclet in (0.01, 0.05, 0.1, 0.5, 1.0, 5.0, 10.0):
        place, width = 0.5, 0.49
        for _ in range(5):
            x = place + width * np.linspace(-1.0, 1.0, 41)
            height = [even_moving(peclet, each) for each in x]
            best = int(np.argmax(height))
            place, width = float(np.clip(x[best], 0.0, 0.999)), 0.1 * width
        tops.append(max(height))
    speeds = ("2.4e-4", "1.2e-3", "2.4e-3", "1.2e-2", "2.4e-2", "0.12", "0.24")
    units = [float(_even_heat(speed)) for speed in speeds]
    return [[top * unit for top, unit in zip(tops, units, strict=True)], [1.0 / top - 1.0 for top in tops]]


@of_case
def even_heat_begins() -> Numbers:
    """T/T_ss = 2 sqrt(tau) (1/sqrt(pi) - ierfc(1/(2 sqrt(tau)))) in the middle, tau = kappa t/a^2 = 1, 10, 31.8."""

    def reached(tau: mp.mpf) -> mp.mpf:
        part = 1 / (2 * mp.sqrt(tau))
        lag = mp.exp(-part * part) / mp.sqrt(mp.pi) - part * mp.erfc(part)
        return 2 * mp.sqrt(tau) * (1 / mp.sqrt(mp.pi) - lag)

    return [[_even_heat("1e-6") * reached(frac(tau)) for tau in ("1", "10", "31.8")]]


@of_case
def hertz_heat_edge() -> Numbers:
    """Under Hertz' flux 3Q/(8 lambda a) in the middle and 3Q/(16 lambda a) at the edge; heating_at_rest's ball."""
    modulus = frac("210e9") / (2 * frac("0.91"))
    heat = frac("0.3") * 4 * modulus * frac("1e-12") / (3 * frac("1e-2")) * frac("1e-9")
    return [3 * heat / (8 * 45 * frac("1e-4")), 3 * heat / (16 * 45 * frac("1e-4"))]


# ---------------------------------------------------------------------------------------------------------------------
# losses of small motions, twist, particles


@of_case
def damping_cone_cubic() -> Numbers:
    """W = (4/3) G*^2 U^3/(mu E* g'), of a cone exact until it slides; g' = pi/2 tan, G* = 0.82352941 E*, mu = 0.3."""
    ratio, slope = 2 * frac("0.7") / frac("1.7"), mp.pi / 2 / mp.tan(mp.radians(80))
    return [[4 * ratio**2 * frac(u) ** 3 / (3 * frac("0.3") * slope) for u in ("0.01", "0.1", "0.3")]]


@of_case
def damping_small_amplitude() -> Numbers:
    """Q^3/(9 a G* mu F) of a ball; a = 1, F = 4/3, mu = 0.3, Q = 1e-3 mu F."""
    ratio, limit = 2 * frac("0.7") / frac("1.7"), frac("0.3") * 4 / 3
    return [(limit / 1000) ** 3 / (9 * ratio * limit)]


@of_case
def deresiewicz_small_twist() -> Numbers:
    """phi = mu F/(G a^2) (1 - s)(3 - s)/8, s = sqrt(1 - 3 M/(2 mu F a)); the ball of lubkin_table, mu F = 0.8."""
    found = []
    for text in ("0.002", "0.01", "0.05"):
        s = mp.sqrt(1 - 3 * frac(text) / 2)
        found.append(frac("0.8") * (1 - s) * (3 - s) / 8)
    return [found]


@of_case
def particle_small_press() -> Numbers:
    """E_c (A B/4) [acos(1 - 2 d/A) - (1 - 2 d/A) sqrt(4 d/A - 4 d^2/A^2)] with A = 4 R, B = 2 R, d = R/100."""
    ec, x = frac("5e6") / (1 - frac("0.16")), frac("0.01") / 4
    return [ec * 2 * (mp.acos(1 - 2 * x) - (1 - 2 * x) * mp.sqrt(4 * x - 4 * x * x))]


# ---------------------------------------------------------------------------------------------------------------------
# functions


def carter_creepages() -> Numbers:
    """mu a/R (1 - sqrt(1 - Q/(mu P))); mu = 0.3, a = 1 mm, R = 0.1 m."""
    return [[frac("3e-3") * (1 - mp.sqrt(1 - frac(q))) for q in ("0.25", "0.5", "0.75", "1")]]


def carter_stick_zones() -> Numbers:
    return [[frac("1e-3") * mp.sqrt(1 - frac(q)) for q in ("0.25", "0.5", "0.75")]]


def _kuwabara(ratio: str) -> mp.mpf:
    """v dv/dy = -(2/3) (4/3 y^(2/3) + 2 tau v), y = d^(3/2), by Taylor series in time after a change of variable.

    With d = s^2: s' = v/(2 s).  Time t = u^2 makes both smooth at the start: s ~ u.
    """
    tau = float(ratio)

    def motion(u: float, y: Any) -> list[float]:
        s, v = y
        # d(s)/du = 2 u v/(2 s), v' 2 u = -2 u (4/3 s^3 + 2 tau s v)
        return [u * v / s if s > 0.0 else 1.0, -2.0 * u * (4.0 / 3.0 * s**3 + 2.0 * tau * s * v)]

    from scipy.integrate import solve_ivp

    def pulled(u: float, y: Any) -> float:
        return float(y[0] ** 2 + 1.5 * tau * y[1])

    pulled.terminal, pulled.direction = True, -1.0  # type: ignore[attr-defined]
    start = 1e-4  # s = u - (2 tau/5) u^4 ..., v = 1 - (4 tau/3) u^3 ...
    begin = [start - 4.0 * tau / 15.0 * start**4, 1.0 - 4.0 * tau / 3.0 * start**3]
    found = solve_ivp(motion, (start, 10.0), begin, method="LSODA", rtol=1e-12, atol=1e-14, events=pulled)
    return mp.mpf(-float(found.y[1, -1]))


def kuwabara_kono_weak() -> Numbers:
    return [_kuwabara("0.1")]


def kuwabara_kono_strong() -> Numbers:
    return [_kuwabara("0.5")]


def worn_punch_bulge() -> Numbers:
    """(4 p a/(pi E*)) (pi/2 - 1) as the difference of 4 p a/(pi E*) E(r^2/a^2) between middle and rim."""
    return [4 * frac("1e8") * frac("1e-3") / (mp.pi * frac("1e11")) * (mp.ellipe(0) - mp.ellipe(1))]


@of_case
def persson_small_pressure() -> Numbers:
    """erf(sqrt(2) p/(E* h')), about sqrt(8/pi) p/(E* h')."""
    return [[mp.erf(mp.sqrt(2) * frac(p)) for p in ("1e-4", "0.01", "0.5")]]


@of_case
def maugis_parameter_unit() -> Numbers:
    """lambda = 2 sigma_0 (R/(pi w K^2))^(1/3), K = 4 E*/3; E* = 0.75, R = pi w = 1, sigma_0 = 1/2."""
    return [mp.mpf(1)]


# ---------------------------------------------------------------------------------------------------------------------
# bodies that are not round, E* = 1


def ellipse(ratio: mp.mpf, within: tuple[str, str] = ("0.2", "0.9")) -> tuple[mp.mpf, mp.mpf, mp.mpf]:
    """m, K and E of Hertz's ellipse for B/A."""
    m = mp.findroot(
        lambda m: (mp.ellipe(m) / (1 - m) - mp.ellipk(m)) / (mp.ellipk(m) - mp.ellipe(m)) - ratio,
        (frac(within[0]), frac(within[1])),
        solver="anderson",
    )
    return m, mp.ellipk(m), mp.ellipe(m)


@of_case
def elliptic_hertz_one_to_three() -> Numbers:
    """a^3 = 3F(K - E)/(2 pi E* m A), b = a sqrt(1 - m), d = 3 F K/(2 pi E* a); A = 0.25, B = 0.75."""
    m, k, e = ellipse(mp.mpf(3))
    a = mp.cbrt(3 * (k - e) / (2 * mp.pi * m * frac("0.25")))
    b, depth = a * mp.sqrt(1 - m), 3 * k / (2 * mp.pi * a)
    return [a, b, depth, (frac("0.75") / depth ** frac("1.5")) ** 2, 3 / (2 * mp.pi * a * b), mp.pi * a / k]


@of_case
def profiles_of_a_ball() -> Numbers:
    """F = 4/3 sqrt(R d^3), p0 = 2/pi sqrt(d/R), area pi R d; E* = R = 1, d = 1e-4."""
    d = frac("0.0001")
    return [frac("4/3") * mp.sqrt(d**3), 2 / mp.pi * mp.sqrt(d), mp.pi * d]


@of_case
def profiles_slide_on_a_slope() -> Numbers:
    """F = F_N (cos a - mu sin a), upwards; mu F_N along the slope, all of the friction; tan a = 0.1."""
    slope, mu = frac("0.1"), frac("0.3")
    cosine = 1 / mp.sqrt(1 + slope**2)
    normal = 1000 / (cosine * (1 - mu * slope))
    return [normal, mu * normal, mp.mpf(1)]


@of_case
def love_square() -> Numbers:
    """Square of side 2, p = 1, nu = 0.3: point forces along rays; sigma_xx - sigma_zz on the axis."""
    soft = 1 - 2 * frac("0.3")

    def apart(z: Any) -> Any:
        def along(turn: Any) -> Any:
            c = z / mp.sqrt(z * z + mp.sec(turn) ** 2)
            return (soft * (1 - c) - 2 + 3 * c - c**3) / 2 + 1 - c**3

        return 4 / mp.pi * mp.quad(along, [0, mp.pi / 4])

    z = mp.findroot(lambda z: mp.diff(apart, z), (frac("0.70"), frac("0.72")))
    return [mp.mpf(4), apart(z), z]


@of_case
def line_cylinder() -> Numbers:
    """a = 2 sqrt(P R/(pi E*)), p0 = 2P/(pi a), P/(2a)."""
    a = 2 / mp.sqrt(mp.pi)
    return [a, 2 / (mp.pi * a), 1 / (2 * a)]


@of_case
def line_strip_030() -> Numbers:
    """Collocation on the closed compliance of a bonded layer: E* = h = a = R = 1."""
    return list(strip_solution.cylinder(strip_solution.bonded(frac("0.3")), rigid_base=True))


@of_case
def line_strip_050() -> Numbers:
    """The same, incompressible."""
    return list(strip_solution.cylinder(strip_solution.bonded(frac("0.5")), rigid_base=True))


@of_case
def line_coated() -> Numbers:
    """The same on a half-plane, the compliance from Burmister's stress function."""
    stack = strip_solution.coating(frac("2.5"), frac("0.3"), frac("0.4"))
    return list(strip_solution.cylinder(stack, rigid_base=False)[:2])


@of_case
def roller_crowned_ellipse() -> Numbers:
    """As elliptic_hertz_one_to_three, A = 1/200, B = 1/2, 2e-4 N: depth, p0, edge factor 1, moment 0, 3F/(2d), area."""
    force = frac("0.0002")
    m, k, e = ellipse(mp.mpf(100), ("0.99", "0.9999"))
    a = mp.cbrt(3 * force * (k - e) / (2 * mp.pi * m * frac("0.005")))
    b, depth = a * mp.sqrt(1 - m), 3 * force * k / (2 * mp.pi * a)
    return [depth, 3 * force / (2 * mp.pi * a * b), mp.mpf(1), 3 * force / (2 * depth), mp.pi * a * b]


@of_case
def roller_lundberg() -> Numbers:
    """Even P = 1: p0 = sqrt(P/(pi R)), d = P/pi (2 ln(2L/a) + 1), a = 2 sqrt(P R/pi); P = pi a^2/(4 R), a = 0.01."""
    a = frac("0.01")
    load = mp.pi * a**2 / 4
    return [load / mp.pi * (2 * mp.log(4 / a) + 1), mp.sqrt(load / mp.pi)]


def line_adhesion_cylinder() -> Numbers:
    """P = pi E* a^2/(4R) - sqrt(2 pi a E* gamma): its zero, and its least value; E* = 1e6, R = gamma = 1."""
    e = mp.mpf(10) ** 6

    def force(a: Any) -> Any:
        return mp.pi * e * a * a / 4 - mp.sqrt(2 * mp.pi * a * e)

    rest = mp.findroot(force, frac("0.0215"))
    least = mp.findroot(lambda a: mp.pi * e * a / 2 - mp.sqrt(mp.pi * e / (2 * a)), frac("0.0086"))
    return [rest, least, force(least)]


@of_case
def line_maugis_cylinder() -> Numbers:
    """The surfaces are gamma/sigma_0 apart at c = m a; P = pi E* a^2/(4R) - 2 sigma_0 a sqrt(m^2 - 1)."""
    a, s, g = frac("0.1"), frac("0.01"), frac("0.0001")

    def apart(m: Any) -> Any:
        root = mp.sqrt(m * m - 1)
        pulled = 4 * s * a / mp.pi * (root * mp.acosh(m) - m * mp.log(m))
        return a * a / 2 * (m * root - mp.acosh(m)) + pulled - g / s

    m = mp.findroot(apart, frac("1.9"))
    return [m * a, mp.pi * a * a / 4 - 2 * s * a * mp.sqrt(m * m - 1)]


@of_case
def wavy_half_plane() -> Numbers:
    """p/p* = sin^2(pi a/lambda), p0 = 2 sqrt(p p*), p* = pi E* h/lambda."""
    full, nominal = mp.pi * frac("0.004"), frac("0.003")
    return [mp.asin(mp.sqrt(nominal / full)) / mp.pi, 2 * mp.sqrt(nominal * full), full]


@of_case
def line_two_cylinders() -> Numbers:
    """Over x^2 both strips are one: 2 c K(m) = pi b, P = pi (a^2 + b^2)/4 - c b E(m), m = 1 - a^2/b^2, c = 1/2."""
    c, load = frac("0.5"), frac("0.1")

    def outer(m: mp.mpf) -> mp.mpf:
        return 2 * c * mp.ellipk(m) / mp.pi

    m = mp.findroot(
        lambda m: mp.pi / 4 * outer(m) ** 2 * (2 - m) - c * outer(m) * mp.ellipe(m) - load,
        (frac("0.3"), frac("0.9")),
        solver="anderson",
    )
    length = 2 * outer(m) * (1 - mp.sqrt(1 - m))
    return [length, load / length, mp.mpf(2)]


@of_case
def line_tilted_wedge() -> Numbers:
    """Slopes s + t on the left, s - t on the right: cos(pi (s + t)/(2 s)) places the tip, P = E* s h sin(...)."""
    s, tilt = mp.cot(frac("1.4")), frac("0.05")
    angle = mp.pi * (s + tilt) / (2 * s)
    half = frac("0.01") / (s * mp.sin(angle))
    return [2 * half, -half * mp.cos(angle) / 2]


@of_case
def line_yield_cylinder() -> Numbers:
    """McEwen's axis: von Mises' stress over p0 at its maximum, in plane strain, is the strength over p0."""

    def mises(d: Any) -> Any:
        root = mp.sqrt(1 + d * d)
        x, z = 2 * d - (1 + 2 * d * d) / root, -1 / root
        y = frac("0.3") * (x + z)
        return mp.sqrt(((x - y) ** 2 + (y - z) ** 2 + (z - x) ** 2) / 2)

    depth = mp.findroot(lambda d: mp.diff(mises, d), frac("0.7"))
    p0 = frac("0.01") / mises(depth)
    return [mp.pi * p0**2, 2 * p0, 2 * p0 * depth]


@of_case
def elliptic_yield_one_to_three() -> Numbers:
    """Love's integrals on the axis below Hertz's ellipse, nu = 0.3: the greatest von Mises stress is the strength."""
    m, k, e = ellipse(mp.mpf(3))
    ratio, nu = mp.sqrt(1 - m), frac("0.3")

    def mises(z: Any) -> Any:
        def over(power: int, axis: Any) -> Any:  # s^2 = t, a = 1
            def shell(s: Any) -> Any:
                both = mp.sqrt((1 + s * s) * (ratio**2 + s * s))
                return 2 * (s - z if power == 0 else 1) / (both * (s * s + axis))

            return mp.quad(shell, [z, z + ratio, z + 1, mp.inf])

        along, across, deep = over(1, mp.mpf(1)), over(1, ratio**2), over(1, mp.mpf(0))
        free = ratio / 2
        x = free * (-2 * nu * z * deep - (1 - 2 * nu) * over(0, mp.mpf(1)) + z * along)
        y = free * (-2 * nu * z * deep - (1 - 2 * nu) * over(0, ratio**2) + z * across)
        down = free * (-z * deep - z * (along + across))
        return mp.sqrt(((x - y) ** 2 + (y - down) ** 2 + (down - x) ** 2) / 2)

    depth = mp.findroot(
        lambda z: mises(z + frac("1e-8")) - mises(z - frac("1e-8")), (frac("0.2"), frac("0.4")), tol=1e-36
    )
    p0 = frac("0.01") / mises(depth)
    unit = (3 * (k - e) / (2 * mp.pi * m * frac("0.25"))) ** (mp.mpf(1) / 3)
    force = (p0 * 2 * mp.pi * unit**2 * ratio / 3) ** 3
    a = unit * mp.cbrt(force)
    return [force, p0, a, 3 * force * k / (2 * mp.pi * a), a * depth]


@of_case
def lundberg_palmgren_one_to_three() -> Numbers:
    """b/a = sqrt((t^2 - 1)(2t - 1)) as an ellipse rolls along b: tau = p0 sqrt(2t - 1)/(2t (t + 1)), also along a."""
    m, k, e = ellipse(mp.mpf(3))
    ratio, force = mp.sqrt(1 - m), frac("0.0002")
    a = mp.cbrt(force * 3 * (k - e) / (2 * mp.pi * m * frac("0.25")))
    p0 = 3 * force / (2 * mp.pi * a * a * ratio)

    def rolled(axis: mp.mpf, over: mp.mpf) -> Numbers:
        t = mp.findroot(lambda t: (t * t - 1) * (2 * t - 1) - over**2, (mp.mpf(1), 2 + over), solver="anderson")
        return [p0 * mp.sqrt(2 * t - 1) / (2 * t * (t + 1)), axis / ((t + 1) * mp.sqrt(2 * t - 1))]

    return [*rolled(ratio * a, ratio), *rolled(a, 1 / ratio), p0]


@of_case
def line_shakedown_cylinder() -> Numbers:
    """p0 = 4 k, at half of a half-width below the surface."""
    p0 = 4 * frac("0.01") / mp.sqrt(3)
    return [mp.pi * p0**2, 2 * p0, p0]


def _slipped(bulk: str) -> tuple[Any, Any, Any]:
    """Return c, e and the loss of the first half cycle: E* = R = P = 1, mu = 0.4, Q = 0.25, p0 = a/2.

    The traction is mu p in the slip zones, and the slip mu times the distance that a cylinder on (e - c, e + c) leaves
    open, (s sqrt(s^2 - c^2) - c^2 arcosh(s/c))/2 at s from its middle.
    """
    mu, a = frac("0.4"), 2 / mp.sqrt(mp.pi)
    c, e = a * mp.sqrt(1 - frac("0.25") / mu), frac(bulk) / (2 * mu)

    def rubbed(s: Any, middle: Any) -> Any:
        return mu**2 * mp.sqrt(a**2 - (s + middle) ** 2) / 4 * (s * mp.sqrt(s**2 - c**2) - c**2 * mp.acosh(s / c))

    sides = ((m, a - m) for m in (e, -e))
    return c, e, sum(mp.quad(lambda s, m=m: rubbed(s, m), [c, (c + end) / 2, end]) for m, end in sides)


@of_case
def line_cattaneo() -> Numbers:
    """From Q to -Q the slip is twice as great as at first, in the same zones."""
    c, _, lost = _slipped("0")
    return [[c, c], [lost, 3 * lost]]


@of_case
def line_bulk_stress() -> Numbers:
    """e = sigma a/(4 mu p0), the other way at -Q."""
    c, e, lost = _slipped("0.2")
    return [[c, c], [lost, 3 * lost], [e, e]]


@of_case
def line_bulk_quartic() -> Numbers:
    """f = x^4, E* = P = 1: what sticks, m +- c, is a contact under P - Q/mu whose profile is tilted by strain/mu.

    With x = m + c cos(t): the mean of f' is the tilt, and (c/2) times the integral of f' cos(t) over t is the load.
    """
    tilt, load = frac("0.15") / frac("0.4"), 1 - frac("0.2") / frac("0.4")
    m, c = mp.findroot(
        lambda m, c: (
            4 * (m**3 + mp.mpf(3) / 2 * m * c**2) - tilt,
            c / 2 * mp.pi * 4 * (mp.mpf(3) / 2 * m**2 * c + mp.mpf(3) / 8 * c**3) - load,
        ),
        (mp.mpf("0.1"), mp.mpf("0.6")),
    )
    return [[c], [m]]


@of_case
def surface_cattaneo() -> Numbers:
    """Shift and loss of a ball, R = F_N = E* = G* = 1 and mu = 0.3, in one direction: what is spent and not stored."""
    mu = frac("0.3")
    depth = mp.cbrt(frac("0.75")) ** 2
    shifts, losses = [], []
    for part in (frac("0.5"), frac("0.75"), frac("0.875")):
        shift = mu * depth * (1 - mp.cbrt(1 - part) ** 2)
        spent = mp.quad(lambda u: mu * (1 - (1 - u / (mu * depth)) ** frac("1.5")), [0, shift])
        edges = [0, mp.sqrt(depth - shift / mu), mp.sqrt(depth)]
        stored = mp.quad(lambda x, most=shift: min(most, mu * (depth - x * x)) ** 2, edges)
        shifts.append(shift)
        losses.append(spent - stored)
    return [shifts, losses]


@of_case
def surface_rolling_free() -> Numbers:
    """xi of E* = R = 1, beta = 1/2, F_N = 0.001 and hardly any friction; lengths over a, slopes over 2 beta p0/(3 E*).

    What pressures draw along is u = -(h x, h y) at r = (1 - s^2)^(1/2), h = (1 + s + s^2)/(1 + s), so that the slip is
    (k - n cos^2, -n sin cos) of the angle, with k = xi - h and n = r h'; its direction, summed up over the angle with
    the pressure s, is a sum of complete elliptic integrals.
    """

    def pushed(xi: mp.mpf) -> mp.mpf:
        def part(s: mp.mpf) -> mp.mpf:
            k, n = xi - (1 + s + s * s) / (1 + s), (s + 2) * (s - 1) / (1 + s)
            if k == n:
                return s * s * n / abs(k)
            m = 1 - (k / (k - n)) ** 2
            if m == 1:
                return s * s * mp.sign(k - n)
            whole = mp.ellipk(m)
            rest = (whole - mp.ellipe(m)) / m if abs(m) > frac("1e-12") else mp.pi / 4
            return s * s * mp.sign(k - n) * (whole + n / (k - n) * rest)

        still = ((xi - 1) + mp.sqrt((xi - 1) * (xi + 3))) / 2  # where nothing slips: across, along the rolling
        other = ((xi - 2) + mp.sqrt((xi - 2) ** 2 + 8 * (1 + xi))) / 4
        return mp.quad(part, [0, *sorted((still, other)), 1])

    xi = mp.findroot(pushed, (frac("1.24"), frac("1.26")), tol=frac("1e-14"))
    a = mp.cbrt(frac("0.75") * frac("0.001"))
    return [xi * 2 / 3 * 2 / mp.pi * a / 2]


def reduced_friction_ellipse() -> Numbers:
    """Depth 0.04, mu = 0.3, G* = E*: at 0.9 of the friction, and back at 0.45; the same along both axes."""
    most = frac("0.3") * frac("0.04")
    pushed = most * (1 - mp.cbrt(1 - frac("0.9")) ** 2)
    back = pushed - 2 * most * (1 - mp.cbrt(1 - (frac("0.9") - frac("0.45")) / 2) ** 2)
    return [pushed, back] * 4


def _oval(bend: str) -> Numbers:
    """F, and the semi-axes, of A x^2 + (1 - A) y^2 at d = 0.01 after Hertz."""
    small = frac(bend)
    m, k, e = ellipse((1 - small) / small)
    a = mp.sqrt(frac("0.01") * (k - e) / (k * m * small))
    return [2 * mp.pi * a * frac("0.01") / (3 * k), a, a * mp.sqrt(1 - m)]


@of_case
def nearly_round_ellipse_122() -> Numbers:
    return _oval("0.45")


@of_case
def nearly_round_ellipse_150() -> Numbers:
    return _oval("0.4")


@of_case
def nearly_round_ellipse_300() -> Numbers:
    return _oval("0.25")[:1]


def _pyramid(faces: int, per_face: int) -> mp.mpf:
    """F/d^2 of I + a (d - g) = C, I = d a - s a^2/2, g = s a in every direction, F = 2 <a I>/<a> = 2 C."""
    angle = ((np.arange(per_face) + 0.5) / per_face - 0.5) * 2.0 * np.pi / faces
    s = 0.5 * np.pi * np.cos(angle)

    def excess(c: float) -> float:
        a = (2.0 + np.sqrt(4.0 - 6.0 * s * c)) / (3.0 * s)
        return float(np.mean(a * (a - 0.5 * s * a * a)) / np.mean(a) - c)

    return mp.mpf(2.0 * brentq(excess, 0.1, 4.0 / (6.0 * s.max()) * (1.0 - 1e-12), xtol=1e-15))


@of_case
def nearly_round_pyramid_3() -> Numbers:
    return [_pyramid(3, 32) * frac("1e-4")]


@of_case
def nearly_round_pyramid_4() -> Numbers:
    return [_pyramid(4, 24) * frac("1e-4")]


@of_case
def nearly_round_pyramid_6() -> Numbers:
    return [_pyramid(6, 12) * frac("1e-4")]


# ---------------------------------------------------------------------------------------------------------------------
# wear without a core, and rough lines


@of_case
def limiting_profile_no_core() -> Numbers:
    """With hardly any core the profile ends at sqrt(2) a0; c = 0.001 a0."""
    c = frac("0.001")

    def shape(r: mp.mpf) -> mp.mpf:
        unworn = (r * r * mp.asin(c / r) - c * mp.sqrt(r * r - c * c)) / 2
        return 2 / mp.pi * (unworn + mp.acos(c / r)) - r * r / 2

    return [c * frac("1e-4"), mp.findroot(shape, (frac("1.40"), frac("1.42")), solver="anderson") * frac("1e-4")]


@of_case
def rough_line_stiffness() -> Numbers:
    """Medians of 4000 lines z = Sum 2 B cos(q x + phi), H = 0.7; B^2 is Int C_1D dq about q, C_1D ~ q^(-2 H - 1)."""
    chance, count, modes = np.random.default_rng(20261121), 4096, np.arange(1, 33)
    fall = np.arange(0.5, 33.0) ** -1.4
    size = 2.0 * np.sqrt(0.5e-4 * -np.diff(fall) / (fall[0] - fall[-1]))  # 2 Sum B^2 = h_rms^2
    forces = np.array([3e-4, 1e-3, 3e-3])
    rows = []
    for _ in range(4000):
        raw = np.zeros(count // 2 + 1, dtype=complex)
        raw[modes] = 0.5 * count * size * np.exp(2j * np.pi * chance.random(32))
        heights = np.sort(np.fft.irfft(raw, count))[::-1]
        gap = heights[0] - heights
        come = np.concatenate(([0.0], np.cumsum(np.arange(1.0, count) * np.diff(gap)))) / count
        rows.append(np.searchsorted(come, forces, side="right") / count)
    return [list(np.median(rows, axis=0))]


def lubkin(share: float) -> tuple[float, float]:
    """Torque over mu F a and G a^2 phi/(mu F) of a ball whose disc of c = share a sticks, by Lubkin's integrals."""
    c = mp.mpf(share)
    angle = 3 / (4 * mp.pi) * (mp.ellipk(1 - c * c) - mp.ellipe(1 - c * c))
    slid = mp.quad(lambda x: x * x * (mp.ellipk(1 - x * x) - mp.ellipe(1 - x * x)), [c, (1 + c) / 2, 1])
    return float(2 * (8 * angle * c**3 / 3 + 4 * 3 / (2 * mp.pi) * slid)), float(angle)


# ---------------------------------------------------------------------------------------------------------------------
# two spots of one height map, pixel by pixel


def two_hills(count: int = 40) -> np.ndarray:
    """Heights of two hills of the radius of curvature 1 m, 0.4 m apart, over a square of 1 m [m]."""
    x = (np.arange(count) + 0.5) / count - 0.5
    return -np.minimum((x[:, None] - 0.2) ** 2, (x[:, None] + 0.2) ** 2) / 2.0 - x**2 / 2.0


def softness(x: np.ndarray, y: np.ndarray, side: float) -> np.ndarray:
    """Displacement of places by even pressure on square pixels (Love), E* = 1."""
    found = np.zeros((x.size, x.size))
    for sx in (1.0, -1.0):
        for sy in (1.0, -1.0):
            dx, dy = x[:, None] - x + sx * side / 2.0, y[:, None] - y + sy * side / 2.0
            found += sx * sy * (dx * np.arcsinh(dy / np.abs(dx)) + dy * np.arcsinh(dx / np.abs(dy)))
    return found / np.pi


@of_case
def two_hills_stiffness() -> Numbers:
    """Depth 0.01: pixels are let go that pull until none does; dF/dd is what lifts their flat stamp by one."""
    heights, side = two_hills(), 1.0 / 40
    sunk = 0.01 - (heights.max() - heights)
    place = (np.arange(40) + 0.5) * side
    x, y = np.meshgrid(place, place, indexing="ij")
    near = sunk > 0.0
    soft, sunk = softness(x[near], y[near], side), sunk[near]
    held = np.ones(sunk.size, dtype=bool)
    while True:
        pressure = np.linalg.solve(soft[np.ix_(held, held)], sunk[held])
        if np.all(pressure > 0.0):
            break
        held[np.flatnonzero(held)[pressure <= 0.0]] = False
    assert np.all(soft[:, held] @ pressure >= sunk - 1e-14)
    stamp = np.linalg.solve(soft[np.ix_(held, held)], np.ones(held.sum()))
    return [float(pressure.sum()) * side**2, float(stamp.sum()) * side**2]


# ---------------------------------------------------------------------------------------------------------------------
# yield


def _first_yield(young: Any, nu: Any, strength: Any, radius: Any) -> tuple[Any, Any]:
    """The axis below Hertz's pressure: p0 [3/(2 + 2 z^2) - (1 + nu)(1 - z atan(1/z))] is greatest, and is Y."""

    def stress(z: Any) -> Any:
        return frac("1.5") / (1 + z * z) - (1 + nu) * (1 - z * mp.atan(1 / z))

    peak = strength / stress(mp.findroot(lambda z: mp.diff(stress, z), 0.48))
    contact = mp.pi * radius * peak * (1 - nu * nu) / (2 * young)
    return 2 * mp.pi * peak * contact**2 / 3, contact**2 / radius


@of_case
def plastic_elastic_limit() -> Numbers:
    """Force and depth."""
    return list(_first_yield(frac("210e9"), frac("0.3"), frac("700e6"), frac("1e-2")))


@of_case
def dent_of_first_yield() -> Numbers:
    """The force."""
    return [_first_yield(frac("210e9"), frac("0.3"), frac("700e6"), frac("1e-2"))[0]]


@of_case
def strength_of_first_yield() -> Numbers:
    """The force goes with the third power of the strength."""
    unit = _first_yield(frac("210e9"), frac("0.3"), frac("1"), frac("1e-2"))[0]
    return [mp.cbrt(frac("13.962894307677277") / unit)]


@of_case
def plastic_impact_first_yield() -> Numbers:
    """The energy of Hertz's contact at that pressure, 8/15 E* R^(1/2) d^(5/2), and the time of his impact."""
    young, nu, radius, mass, speed = (frac(text) for text in ("210e9", "0.3", "1e-2", "33e-3", "1e-2"))
    depth = _first_yield(young, nu, frac("700e6"), radius)[1]
    stiffness = young / (1 - nu * nu)
    first = mp.sqrt(frac(16) / 15 * stiffness * mp.sqrt(radius) * depth ** frac("2.5") / mass)
    deepest = (15 * mass * speed**2 / (16 * stiffness * mp.sqrt(radius))) ** frac("0.4")
    lasting = mp.sqrt(mp.pi) * mp.gamma(frac("0.4")) / (frac("1.25") * mp.gamma(frac("0.9")))
    return [first, 1, deepest, lasting * deepest / speed]
