"""The theory of section 1 in mpmath: every result by quadrature of its definition, none by a closed form.

A body of revolution is a list of smooth pieces of f'; depth, force, pressure and displacement follow by the
transforms T1, T3, T4 and T6, and the field below the surface by Hankel's integrals, which share nothing with the
complex potentials of the package.
"""

from __future__ import annotations

import functools
import itertools
from collections.abc import Callable
from dataclasses import dataclass, field

import mpmath as mp

Real = Callable[[mp.mpf], mp.mpf]


def _integral(piece: Piece, function: Real, low: mp.mpf, high: mp.mpf) -> mp.mpf:
    """The integral of a function that is as smooth at its ends as the piece is."""
    return mp.quadgl(function, [low, high]) if piece.analytic else mp.quad(function, [low, high])


def _both_legs(high: mp.mpf, rest: mp.mpf, end: mp.mpf) -> mp.mpf:
    return mp.quad(lambda w: 1 / (mp.hypot(high, w) * mp.hypot(rest, w)), [0, end])


@dataclass
class Piece:
    """A smooth piece of a profile from `start` on: its slope f' and curvature f''; analytic at both ends too?"""

    start: mp.mpf
    slope: Real
    curvature: Real
    analytic: bool = True


@dataclass
class Body:
    """A body of revolution; `rim` is the radius where the contact is pinned."""

    pieces: list[Piece]
    rim: mp.mpf = field(default_factory=lambda: mp.inf)

    def _between(self, low: mp.mpf, high: mp.mpf) -> list[tuple[mp.mpf, mp.mpf, Piece]]:
        ends = [piece.start for piece in self.pieces[1:]] + [mp.inf]
        found = []
        for piece, end in zip(self.pieces, ends, strict=True):
            a, b = max(piece.start, low), min(end, high)
            if a < b:
                found.append((a, b, piece))
        return found

    def height(self, r: mp.mpf) -> mp.mpf:
        return mp.fsum(mp.quad(piece.slope, [a, b]) for a, b, piece in self._between(mp.mpf(0), r))

    def gap(self, x: mp.mpf) -> mp.mpf:
        """T1 with r = x sin(phi)."""
        total = mp.mpf(0)
        for a, b, piece in self._between(mp.mpf(0), x):
            total += _integral(
                piece, lambda phi, piece=piece: piece.slope(x * mp.sin(phi)), mp.asin(a / x), mp.asin(b / x)
            )
        return x * total

    def _smooth_gap_slope(self, x: mp.mpf) -> mp.mpf:
        """Int (r f')' / sqrt(x^2 - r^2) dr, without the jumps of f'."""
        total = mp.mpf(0)
        for a, b, piece in self._between(mp.mpf(0), x):

            def density(phi: mp.mpf, piece: Piece = piece) -> mp.mpf:
                r = x * mp.sin(phi)
                return piece.slope(r) + r * piece.curvature(r)

            total += _integral(piece, density, mp.asin(a / x), mp.asin(b / x))
        return total

    def force(self, a: mp.mpf, modulus: mp.mpf) -> mp.mpf:
        """T6: F = 2 E* Int_0^a r^2 f' / sqrt(a^2 - r^2) dr."""
        total = mp.mpf(0)
        for low, high, piece in self._between(mp.mpf(0), a):
            total += mp.quad(
                lambda phi, piece=piece: mp.sin(phi) ** 2 * piece.slope(a * mp.sin(phi)),
                [mp.asin(low / a), mp.asin(high / a)],
            )
        return 2 * modulus * a**2 * total

    def energy(self, a: mp.mpf, modulus: mp.mpf, depth: mp.mpf) -> mp.mpf:
        """T8: U = E* Int_0^a (d - g)^2 dx."""
        cuts = [mp.mpf(0), *(piece.start for piece in self.pieces[1:] if piece.start < a), a]
        return modulus * mp.quad(lambda x: (depth - self.gap(x)) ** 2 if x > 0 else depth**2, cuts)

    def pressure(self, r: mp.mpf, a: mp.mpf, modulus: mp.mpf, depth: mp.mpf) -> mp.mpf:
        """T4; a jump of f' at b adds jump b / sqrt(x^2 - b^2) to g', whose root is taken out by substitution."""

        def leg(x: mp.mpf, y: mp.mpf) -> mp.mpf:
            return mp.sqrt((x - y) * (x + y))

        starts = [piece.start for piece in self.pieces[1:] if piece.start < a]
        cuts = [mp.mpf(0), *(leg(b, r) for b in starts if b > r), leg(a, r)]
        total = mp.quad(lambda w: self._smooth_gap_slope(mp.hypot(r, w)) / mp.hypot(r, w), cuts)
        for before, piece in itertools.pairwise(self.pieces):
            b = piece.start
            jump = piece.slope(b) - before.slope(b)
            if b < a and jump != 0:
                high, low = max(b, r), min(b, r)
                total += b * jump * _both_legs(high, leg(high, low), leg(a, high))
        edge = depth - self.gap(a)
        if abs(edge) > mp.mpf(10) ** (10 - mp.mp.dps) * abs(depth):
            total += edge / leg(a, r)
        return modulus / mp.pi * total

    def displacement(self, r: mp.mpf, a: mp.mpf, depth: mp.mpf) -> mp.mpf:
        """T3 outside, after the order of integration was changed: one integral over f'."""
        if r <= a:
            return depth - self.height(r)
        total = mp.mpf(0)
        for low, high, piece in self._between(mp.mpf(0), a):

            def density(s: mp.mpf, piece: Piece = piece) -> mp.mpf:
                return piece.slope(s) * mp.asin(mp.sqrt((a - s) * (a + s) / ((r - s) * (r + s))))

            total += mp.quad(density, [low, high])
        return 2 / mp.pi * (depth * mp.asin(a / r) - total)

    def radius_at_depth(self, depth: mp.mpf, guess: mp.mpf) -> mp.mpf:
        if self.rim < mp.inf and depth >= self.gap(self.rim):
            return self.rim
        return mp.findroot(lambda a: self.gap(a) / depth - 1, (guess, guess * mp.mpf("1.01")))

    def radius_at_force(self, force: mp.mpf, modulus: mp.mpf, guess: mp.mpf) -> mp.mpf:
        if self.rim < mp.inf and force >= self.force(self.rim, modulus):
            return self.rim
        return mp.findroot(lambda a: self.force(a, modulus) / force - 1, (guess, guess * mp.mpf("1.01")))


ZERO = mp.mpf(0)


def power_law(coefficient: mp.mpf, exponent: mp.mpf) -> Body:
    c, n = coefficient, exponent
    curve = (lambda r: c * n * (n - 1) * r ** (n - 2)) if n != 1 else (lambda r: ZERO)
    return Body([Piece(ZERO, lambda r: c * n * r ** (n - 1), curve, analytic=mp.isint(n))])


def paraboloid(curvature_radius: mp.mpf) -> Body:
    return power_law(1 / (2 * curvature_radius), mp.mpf(2))


def cone(half_angle: mp.mpf) -> Body:
    return power_law(mp.cot(half_angle), mp.mpf(1))


def ellipsoid(radial_semi_axis: mp.mpf, axial_semi_axis: mp.mpf) -> Body:
    a, ratio = radial_semi_axis, axial_semi_axis / radial_semi_axis
    return Body(
        [Piece(ZERO, lambda r: ratio * r / mp.sqrt(a**2 - r**2), lambda r: ratio * a**2 / mp.sqrt(a**2 - r**2) ** 3)]
    )


def sphere(curvature_radius: mp.mpf) -> Body:
    return ellipsoid(curvature_radius, curvature_radius)


def hyperboloid(curvature_radius: mp.mpf, half_angle: mp.mpf) -> Body:
    rise = mp.cot(half_angle)
    a = curvature_radius * rise
    return Body([Piece(ZERO, lambda r: rise * r / mp.hypot(a, r), lambda r: rise * a**2 / mp.hypot(a, r) ** 3)])


def flat_until(b: mp.mpf, slope: Real, curvature: Real) -> Body:
    return Body([Piece(ZERO, lambda r: ZERO, lambda r: ZERO), Piece(b, slope, curvature)])


def truncated_cone(half_angle: mp.mpf, flat_radius: mp.mpf) -> Body:
    return flat_until(flat_radius, lambda r: mp.cot(half_angle), lambda r: ZERO)


def truncated_paraboloid(curvature_radius: mp.mpf, flat_radius: mp.mpf) -> Body:
    return flat_until(flat_radius, lambda r: r / curvature_radius, lambda r: 1 / curvature_radius)


def rounded_punch(flat_radius: mp.mpf, edge_radius: mp.mpf) -> Body:
    return flat_until(flat_radius, lambda r: (r - flat_radius) / edge_radius, lambda r: 1 / edge_radius)


def capped_paraboloid(curvature_radius: mp.mpf, cap_curvature_radius: mp.mpf, cap_radius: mp.mpf) -> Body:
    big, cap = curvature_radius, cap_curvature_radius
    return Body(
        [Piece(ZERO, lambda r: r / cap, lambda r: 1 / cap), Piece(cap_radius, lambda r: r / big, lambda r: 1 / big)]
    )


def rounded_cone(curvature_radius: mp.mpf, half_angle: mp.mpf) -> Body:
    big, rise = curvature_radius, mp.cot(half_angle)
    return Body([Piece(ZERO, lambda r: r / big, lambda r: 1 / big), Piece(big * rise, lambda r: rise, lambda r: ZERO)])


def sphero_conical(curvature_radius: mp.mpf, half_angle: mp.mpf) -> Body:
    rise = mp.cot(half_angle)
    tip = sphere(curvature_radius).pieces[0]
    return Body([tip, Piece(curvature_radius * mp.cos(half_angle), lambda r: rise, lambda r: ZERO)])


def wavy(amplitude: mp.mpf, wavelength: mp.mpf) -> Body:
    k = 2 * mp.pi / wavelength
    return Body([Piece(ZERO, lambda r: amplitude * k * mp.sin(k * r), lambda r: amplitude * k**2 * mp.cos(k * r))])


def flat_punch(radius: mp.mpf) -> Body:
    return Body([Piece(ZERO, lambda r: ZERO, lambda r: ZERO)], rim=radius)


def capped_cylinder(radius: mp.mpf, cap: Body) -> Body:
    return Body(cap.pieces, rim=radius)


def added(parts: list[Body]) -> Body:
    """The sum of smooth profiles."""
    pieces = [part.pieces[0] for part in parts]
    assert all(len(part.pieces) == 1 for part in parts)
    return Body(
        [Piece(ZERO, lambda r: mp.fsum(p.slope(r) for p in pieces), lambda r: mp.fsum(p.curvature(r) for p in pieces))]
    )


def hankel_field(
    transform: Real, r: mp.mpf, z: mp.mpf, poisson: mp.mpf, shear: mp.mpf, radius: mp.mpf
) -> dict[str, mp.mpf]:
    """Stresses and displacements at z > 0 from the Hankel transform of the pressure (Sneddon, Fourier Transforms)."""
    soft = 1 - 2 * poisson

    @functools.cache
    def factors(xi: mp.mpf) -> tuple[mp.mpf, ...]:
        j0, j1 = mp.besselj(0, xi * r), mp.besselj(1, xi * r)
        return j0, j1, j1 / (xi * r) if r > 0 else mp.mpf(1) / 2, transform(xi) * mp.exp(-xi * z)

    def integral(kernel: Callable[[mp.mpf, mp.mpf, mp.mpf, mp.mpf], mp.mpf]) -> mp.mpf:
        def density(xi: mp.mpf) -> mp.mpf:
            if xi == 0:
                xi = mp.mpf(10) ** (-mp.mp.dps)
            j0, j1, over, weight = factors(xi)
            return kernel(xi, j0, j1, over) * weight

        last = (mp.mp.dps + 5) * mp.log(10) / z
        step = 2 * mp.pi / (radius + r)
        cuts = [step * k for k in range(int(last / step) + 2)]
        return mp.quad(density, cuts, maxdegree=5)

    return {
        "axial_stress": -integral(lambda xi, j0, j1, over: xi * (1 + xi * z) * j0),
        "shear_stress": -integral(lambda xi, j0, j1, over: xi**2 * z * j1),
        "radial_stress": -integral(lambda xi, j0, j1, over: xi * ((1 - xi * z) * j0 - (soft - xi * z) * over)),
        "hoop_stress": -integral(lambda xi, j0, j1, over: xi * (2 * poisson * j0 + (soft - xi * z) * over)),
        "axial_displacement": integral(lambda xi, j0, j1, over: (1 + soft + xi * z) * j0) / (2 * shear),
        "radial_displacement": -integral(lambda xi, j0, j1, over: (soft - xi * z) * j1) / (2 * shear),
    }


def hertz_transform(radius: mp.mpf, peak_pressure: mp.mpf) -> Real:
    """Int_0^a p0 sqrt(1 - r^2/a^2) J0(xi r) r dr."""

    def transform(xi: mp.mpf) -> mp.mpf:
        t = xi * radius
        if t < mp.mpf("1e-10"):
            return peak_pressure * radius**2 / 3
        return peak_pressure * radius**2 * (mp.sin(t) - t * mp.cos(t)) / t**3

    return transform


def punch_transform(radius: mp.mpf, force: mp.mpf) -> Real:
    """Int_0^a F/(2 pi a sqrt(a^2 - r^2)) J0(xi r) r dr."""
    return lambda xi: force * mp.sinc(xi * radius) / (2 * mp.pi)


def equivalents(field: dict[str, mp.mpf]) -> dict[str, mp.mpf]:
    """The largest shear stress and von Mises' stress of a field."""
    rr, tt, zz, rz = (field[name] for name in ("radial_stress", "hoop_stress", "axial_stress", "shear_stress"))
    mean, half = (rr + zz) / 2, mp.hypot((rr - zz) / 2, rz)
    principal = [mean + half, mean - half, tt]
    square = (rr - tt) ** 2 + (tt - zz) ** 2 + (zz - rr) ** 2 + 6 * rz**2
    return {"max_shear": (max(principal) - min(principal)) / 2, "von_mises": mp.sqrt(square / 2)}
