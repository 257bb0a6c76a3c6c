r"""Stresses and displacements in a half-space under a rectangle that is loaded evenly, summed from its corners.

The load p = 1 of a rectangle has the potentials :math:`\Phi=\int\mathrm dA/\rho`, :math:`H=\int\ln(\rho+z)\,\mathrm dA`
and :math:`K=\int(z\ln(\rho+z)-\rho)\,\mathrm dA`; what each derivative of them is, a function F of the distances X, Y
from a corner gives, as :math:`F(X_1,Y_1)-F(X_2,Y_1)-F(X_1,Y_2)+F(X_2,Y_2)` (Love).  With :math:`\rho^2=X^2+Y^2+z^2`,
:math:`R_x^2=X^2+z^2` and :math:`R_y^2=Y^2+z^2` these are

.. math::

    \Phi_x &: \operatorname{arsinh}\frac{Y}{R_x} , &
    \Phi_z &: -\arctan\frac{XY}{z\rho} , &
    \Phi_{xx} &: -\frac{XY}{\rho R_x^2} , &
    \Phi_{xy} &: \frac1\rho , \\
    \Phi_{xz} &: -\frac{zY}{\rho R_x^2} , &
    H_{xx} &: \arctan\frac YX-\arctan\frac{zY}{X\rho} , &
    H_{xy} &: \ln(\rho+z) , &
    H_{xxy} &: \frac{X}{\rho(\rho+z)} , \\
    H_x &: Y H_{xy}+z\Phi_x+X H_{xx} , &
    K_{xy} &: zH_{xy}-\rho , &
    K_{xx} &: zH_{xx}-X\Phi_x , &
    K_{xxy} &: -\frac{X}{\rho+z} ;

the others by exchange of x and y, and since all three satisfy Laplace's equation.  What does not depend on both X and Y
is left out, as it cancels.  The stresses are those of `winkler.media.interior.half_ellipsoid`, the displacements those
of `winkler.media.interior.half_ellipsoid_displacement`.

References
----------
A. E. H. Love, Phil. Trans. R. Soc. A 228 (1929) 377-420, doi:10.1098/rsta.1929.0009;
J. Ahmadi, L. M. Keer, T. Mura, Int. J. Solids Struct. 23 (1987) 283-297 (tractions);
K. L. Johnson, Contact Mechanics, Cambridge 1985, sec. 3.2, 3.4 and 3.6, doi:10.1017/CBO9781139171731
"""

from __future__ import annotations

import math

from winkler.numerics.jit import compiled
from winkler.numerics.types import Array

COMPONENTS, STRESSES = 9, 6
"""xx, yy, zz, xy, xz, yz of the stress; displacements along x, y, z, times 2 G."""
EXCHANGED = (1, 0, 2, 3, 5, 4, 7, 6, 8)
"""Components in the order that the exchange of x and y gives them."""
Corner = tuple[float, float, float, float, float, float, float, float, float]
PER_TURN = 0.5 / math.pi


@compiled
def _integrals(x: float, y: float, z: float, least: float) -> tuple[float, ...]:
    """Return what both corners are made of; `least` is a squared length that keeps edges finite."""
    rx, ry = x * x + z * z + least, y * y + z * z + least
    rho = math.sqrt(rx + y * y)
    deep = rho + z
    ax, ay = math.asinh(y / math.sqrt(rx)), math.asinh(x / math.sqrt(ry))
    flat = (x * x + y * y) / deep
    hxx = math.atan2(x * y * flat, x * x * rho + z * y * y)
    return rx, ry, rho, deep, ax, ay, math.atan2(x * y, z * rho), hxx, math.log(deep)


@compiled
def pressed_corner(x: float, y: float, z: float, nu: float, least: float) -> Corner:
    """Return what a corner gives under unit pressure."""
    rx, ry, rho, _, ax, ay, t, hxx, hxy = _integrals(x, y, z, least)
    hyy, most = t - hxx, 1.0 - 2.0 * nu
    zxx, zyy = -z * x * y / (rho * rx), -z * x * y / (rho * ry)
    xx = -2.0 * nu * t - most * hxx - zxx
    yy = -2.0 * nu * t - most * hyy - zyy
    zz = -t + zxx + zyy
    xy = -most * hxy - z / rho
    xz = z * z * y / (rho * rx)
    yz = z * z * x / (rho * ry)
    ux = -most * (y * hxy + z * ax + x * hxx) - z * ax
    uy = -most * (x * hxy + z * ay + y * hyy) - z * ay
    uz = 2.0 * (1.0 - nu) * (x * ax + y * ay - z * t) + z * t
    c = PER_TURN
    return c * xx, c * yy, c * zz, c * xy, c * xz, c * yz, c * ux, c * uy, c * uz


@compiled
def dragged_corner(x: float, y: float, z: float, nu: float, least: float) -> Corner:
    """Return what a corner gives under a unit traction along x that acts on the body."""
    rx, _, rho, deep, ax, ay, t, hxx, hxy = _integrals(x, y, z, least)
    phi_xz = -z * y / (rho * rx)
    h_xxy, h_xyy = x / (rho * deep), y / (rho * deep)
    xx = 2.0 * (1.0 + nu) * ax + 2.0 * nu * (y / deep - ax) + z * (h_xyy + phi_xz)
    yy = 2.0 * nu * ax - 2.0 * nu * y / deep - z * h_xyy
    zz = -z * phi_xz
    xy = ay - 2.0 * nu * x / deep - z * h_xxy
    xz = -t + z * x * y / (rho * rx)
    yz = -z / rho
    ux = 2.0 * (x * ax + y * ay - z * t) + 2.0 * nu * (z * hxx - x * ax) - z * hxx
    uy = 2.0 * nu * (z * hxy - rho) - z * hxy
    uz = (1.0 - 2.0 * nu) * (y * hxy + z * ax + x * hxx) - z * ax
    c = PER_TURN
    return c * xx, c * yy, c * zz, c * xy, c * xz, c * yz, c * ux, c * uy, c * uz


@compiled
def corners_at(x: Array, y: Array, z: float, nu: float, least: float, dragged: bool, out: Array) -> None:
    """Write what corners at all x and y from a place give into `out` (9, nx, ny)."""
    for i in range(x.size):
        for j in range(y.size):
            found = dragged_corner(x[i], y[j], z, nu, least) if dragged else pressed_corner(x[i], y[j], z, nu, least)
            for k in range(9):
                out[k, i, j] = found[k]


@compiled
def sum_corners(
    places: Array, corners: Array, jumps: Array, dragged: bool, nu: float, least: float, out: Array
) -> None:
    """Add what corners (n, 2), of loads that jump there by (n, 3), give at places (m, 3) to `out` (m, 9).

    The jumps are those of pressure and of the tractions along x and y.
    """
    for m in range(places.shape[0]):
        z = places[m, 2]
        for n in range(corners.shape[0]):
            x, y = places[m, 0] - corners[n, 0], places[m, 1] - corners[n, 1]
            p = pressed_corner(x, y, z, nu, least)
            for k in range(9):
                out[m, k] += jumps[n, 0] * p[k]
            if dragged:
                u = dragged_corner(x, y, z, nu, least)
                v = dragged_corner(y, x, z, nu, least)
                qx, qy = jumps[n, 1], jumps[n, 2]
                for k in range(9):
                    out[m, k] += qx * u[k] + qy * v[EXCHANGED[k]]
