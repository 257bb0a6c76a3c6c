r"""Kalker's linear theory of rolling solved: creep coefficients of an ellipse without a table.

At vanishing creepage nothing slips, and material that came in without traction keeps the rigid displacement

.. math:: u_x = \xi x - \varphi x y + k(y), \qquad u_y = \eta x + \tfrac12\varphi x^2 + l(y),

with two unknown functions of y that make the tractions vanish at the leading edge.  On the ellipse X = x/a, Y = y/b
tractions :math:`P(X, Y)/\sqrt{1-X^2-Y^2}` with a polynomial P of degree n displace by polynomials of that degree
(Galin).  Spherical harmonics projected on the disc part the degrees: their waves are spherical Bessel functions of
order n, which are orthogonal.  With the values of P on the edge, :math:`\sum_m e_m\mathrm e^{im\theta}`, as
unknowns, and :math:`F_d=\int M(\phi)\,\mathrm e^{-id\phi}/|q|\,\mathrm d\phi` of the compliance M of waves, one
degree is

.. math:: \sum_{m'} F_{m-m'} e_{m'} = 2\,\mathrm e^{-im\psi} \qquad (m, m' = -n, -n+2, \dots, n)

for the displacement :math:`P_n(X\cos\psi+Y\sin\psi)` of Legendre, E* = 1 and ab = 1.  k and l are sums of Legendre's
polynomials in Y; least squares over the leading edge find them, and doubling their number bounds the error.
"""

from __future__ import annotations

import functools
import math

import numpy as np

from winkler.numerics.types import Array
from winkler.values.errors import NotConverged, OutsideValidity
from winkler.values.value import value, words

MOST_SLENDER = 50.0
"""Largest ratio of the semi-axes, either way."""
FIRST_DEGREE, LAST_DEGREE = 16, 256
"""Degree of the polynomials in Y, doubled until the coefficients stand still."""
CHANGE = 1e-5
"""Largest change under the last doubling, and difference of c23 by force and by moment, over the coefficients."""
ANGLES_MORE = 48
"""Angles of the integrals over all waves beyond twice the degree, times the ratio of the semi-axes."""
POINTS_MORE = 4
"""Places on the leading edge over unknowns of one direction."""


@value
class LinearCreepCoefficients:
    r"""Forces and moment of little creepage on an ellipse, with which the second body drags the first.

    .. math:: F_x = Gab\,c_{11}\xi,\quad F_y = Gab\,c_{22}\eta + G(ab)^{3/2}c_{23}\varphi,\quad
        M_z = -G(ab)^{3/2}c_{23}\eta + G(ab)^2c_{33}\varphi

    Parameters
    ----------
    longitudinal, lateral, spin, turning : float
        c11, c22, c23 and c33 [-].
    error : float
        Estimate of the relative error [-]: the change when the degree of the polynomials was doubled last, or the
        difference of c23 by force and by moment.
    """

    __words__ = words(
        longitudinal=("c_{11}", "", "Kalker's coefficient of longitudinal creepage"),
        lateral=("c_{22}", "", "Kalker's coefficient of lateral creepage"),
        spin=("c_{23}", "", "Kalker's coefficient of spin"),
        turning=("c_{33}", "", "Kalker's coefficient of the moment of spin"),
        error=("", "", "estimate of the relative error"),
    )

    longitudinal: float
    lateral: float
    spin: float
    turning: float
    error: float


def linear_creep_coefficients(ratio: float, poisson: float) -> LinearCreepCoefficients:
    """Return Kalker's coefficients of an elliptic contact, from the linear theory itself.

    Parameters
    ----------
    ratio : float
        a/b [-], the semi-axis along the direction of rolling over that across it, from 1/50 to 50.
    poisson : float
        nu [-] of the pair, above -1 and up to 0.5.

    Returns
    -------
    LinearCreepCoefficients
        Coefficients with at least five correct digits; `error` states the accuracy.

    Raises
    ------
    OutsideValidity
        If the ratio or Poisson's ratio lies outside.
    NotConverged
        If polynomials of the highest degree do not suffice.

    References
    ----------
    J. J. Kalker, On the Rolling Contact of Two Elastic Bodies in the Presence of Dry Friction, Delft 1967

    Examples
    --------
    >>> circle = linear_creep_coefficients(1.0, 0.0)
    >>> round(circle.longitudinal, 6) == round(32 / (3 * math.pi), 6)
    True
    >>> round(linear_creep_coefficients(0.5, 0.25).turning, 4)
    1.9381
    """
    if not 1.0 / MOST_SLENDER <= ratio <= MOST_SLENDER:
        raise OutsideValidity(
            "Linear theory of rolling: the ratio of the semi-axes, along over across the direction of rolling, is "
            f"{ratio:.6g}; give one from {1.0 / MOST_SLENDER:g} to {MOST_SLENDER:g}."
        )
    if not -1.0 < poisson <= 0.5:
        raise OutsideValidity(
            f"Linear theory of rolling: Poisson's ratio is {poisson:.6g}; give one above -1 and up to 0.5."
        )
    return _solved(float(ratio), float(poisson))


@functools.lru_cache(maxsize=256)
def _solved(ratio: float, poisson: float) -> LinearCreepCoefficients:
    """Return the coefficients, the degree doubled until they stand still."""
    degree, error = FIRST_DEGREE, math.inf
    known = _forces(ratio, poisson, degree)
    while degree < LAST_DEGREE:
        degree *= 2
        found = _forces(ratio, poisson, degree)
        error = float(np.max(np.abs(found / known - 1.0)))
        error = max(error, abs(found[3] / found[2] - 1.0))
        if error <= CHANGE:
            c11, c22, c23, _, c33 = found.tolist()
            return LinearCreepCoefficients(c11, c22, c23, c33, error)
        known = found
    raise NotConverged(
        f"Linear theory of rolling: at a ratio of the semi-axes of {ratio:.6g} and Poisson's ratio {poisson:.6g} the "
        f"coefficients still change by {error:.2g} with polynomials of degree {degree}; allowed are {CHANGE:.0e}. "
        "Give a ratio nearer to one."
    )


def _forces(ratio: float, poisson: float, degree: int) -> Array:
    """Return c11, c22, c23 by the force, c23 by the moment, and c33, with k and l of this degree."""
    a, b = math.sqrt(ratio), 1.0 / math.sqrt(ratio)
    waves = _waves(a, b, poisson, degree)
    count = POINTS_MORE * (degree + 1)
    theta = math.pi * (np.arange(1, count + 1) / (count + 1) - 0.5)
    weight = np.cos(theta)[:, None]
    edges, sums = [], np.zeros((3, 0))
    rigid, given = np.zeros((2 * count, 3)), np.zeros((3, 3))
    for n in range(degree + 1):
        e = _edge_values(waves, _displacements(n, a))
        by_place = np.exp(1j * np.outer(theta, np.arange(-n, n + 1, 2)))
        values = np.concatenate([weight * (by_place @ part).real for part in e])
        total = _resultants(e, a, b)
        rigid += values[:, :3]
        given += total[:, :3]
        edges.append(values[:, 3:])
        sums = np.concatenate((sums, total[:, 3:]), axis=1)
    amounts = np.linalg.lstsq(np.concatenate(edges, axis=1), rigid, rcond=None)[0]
    force = (sums @ amounts - given) / (1.0 - poisson)
    return np.array([force[0, 0], force[1, 1], force[1, 2], -force[2, 1], force[2, 2]])


def _waves(a: float, b: float, poisson: float, degree: int) -> Array:
    """Return F_d of xx, xy and yy for d from 0 to twice the degree, then those of negative d."""
    count = 2 ** math.ceil(math.log2((2 * degree + ANGLES_MORE) * max(a / b, b / a)))
    phi = 2.0 * math.pi * np.arange(count) / count
    x, y = np.cos(phi) / a, np.sin(phi) / b
    q = np.hypot(x, y)
    more = poisson / (1.0 - poisson)
    compliance = np.stack((1.0 + more * (y / q) ** 2, -more * x * y / q**2, 1.0 + more * (x / q) ** 2))
    return np.asarray(np.fft.fft(compliance / q) * (2.0 * math.pi / count))


def _displacements(n: int, a: float) -> Array:
    """Return the right sides of degree n, (2, n + 1, 5): of xi, eta and phi, and of P_n(Y) in k and in l."""
    m = np.arange(-n, n + 1, 2)
    ahead, aside = np.full(n + 1, 2.0), 2.0 * np.exp(-0.5j * math.pi * m)
    right = np.zeros((2, n + 1, 5), dtype=complex)
    right[0, :, 3] = right[1, :, 4] = aside
    if n == 0:
        right[1, :, 2] = a**2 / 6.0 * ahead
    elif n == 1:
        right[0, :, 0] = right[1, :, 1] = a * ahead
    elif n == 2:
        right[1, :, 2] = a**2 / 3.0 * ahead
        right[0, :, 2] = 4.0j / 3.0 * np.sin(math.pi / 4.0 * m)  # -XY by two diagonal directions
    return right


def _edge_values(waves: Array, right: Array) -> Array:
    """Return e_m, (2, n + 1, 5)."""
    n = right.shape[1] - 1
    lag = np.subtract.outer(np.arange(-n, n + 1, 2), np.arange(-n, n + 1, 2))
    xx, xy, yy = waves[:, lag]
    solved = np.linalg.solve(np.block([[xx, xy], [xy, yy]]), right.reshape(2 * (n + 1), -1))
    return solved.reshape(right.shape)


def _resultants(e: Array, a: float, b: float) -> Array:
    """Return forces along and across, and moments, (3, 5): only the lowest degrees have them."""
    found = np.zeros((3, e.shape[2]))
    match e.shape[1] - 1:
        case 0:
            found[:2] = 2.0 * math.pi * e[:, 0].real
        case 1:
            cosine, sine = (e[1, 0] + e[1, 1]).real, (1j * (e[0, 1] - e[0, 0])).real
            found[2] = 2.0 * math.pi / 3.0 * (a * cosine - b * sine)
    return found
