r"""Oliver and Pharr's reading of an unloading curve: stiffness, contact depth, area, modulus, hardness.

The upper part of the unloading is fitted by :math:`F = B(h-h_f)^m`; its slope at the greatest depth is the stiffness S.
The contact depth and the modulus are

.. math:: h_c = h_{max} - \epsilon\,\frac{F_{max}}S, \qquad E_r = \frac{\sqrt\pi}{2\beta}\,\frac S{\sqrt{A(h_c)}},
          \qquad H = \frac{F_{max}}{A(h_c)} ,

with the area A of the tip's cross-section at the height :math:`h_c`, and for a body of revolution that unloads with the
exponent m

.. math:: \epsilon = m\left(1 - \frac{2(m-1)\,\Gamma\bigl(\frac m{2(m-1)}\bigr)}
          {\sqrt\pi\,\Gamma\bigl(\frac1{2(m-1)}\bigr)}\right) :

3/4 for a paraboloid, 0.727 for a cone.  For an elastic contact of either shape the reading is exact.
"""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np

from winkler.errors import InvalidInput, NotConverged, OutsideValidity
from winkler.fitting.curve import ForceCurve
from winkler.fitting.noise import memory, spread
from winkler.materials.elastic import Elastic, Rigid, Solid
from winkler.numerics.types import Array
from winkler.profiles.profile import Profile
from winkler.values import value

__all__ = ["OliverPharr", "OliverPharrSolution", "intercept_factor", "sample_young"]

FEWEST = 10
STEP = 1e-6
LONGEST = 200


def intercept_factor(exponent: float) -> float:
    """Return epsilon [-] of a body that unloads with an exponent m > 1; 1 for m = 1.

    Examples
    --------
    >>> intercept_factor(1.5), round(intercept_factor(2.0), 6)
    (0.75, 0.72676)
    """
    if exponent - 1.0 < 1e-6:
        return 1.0
    half = 0.5 / (exponent - 1.0)
    ratio = math.exp(math.lgamma(exponent * half) - math.lgamma(half))
    return exponent * (1.0 - 2.0 * (exponent - 1.0) * ratio / math.sqrt(math.pi))


@value
class OliverPharr:
    """An unloading curve and the tip that made it.

    Parameters
    ----------
    curve : ForceCurve
        What was measured; the points that come out are read.
    profile : Profile
        The tip: AreaFunction(coefficients), or any profile.
    contact_point : float, optional
        Position of first touch [m]; zero unless given.
    upper, lower : float, optional
        Parts of the greatest force between which the unloading is fitted [-].
    shape_factor : float, optional
        beta [-], 1 for bodies of revolution; about 1.034 is often taken for a Berkovich pyramid.

    References
    ----------
    W. C. Oliver, G. M. Pharr, J. Mater. Res. 7 (1992) 1564-1583, doi:10.1557/JMR.1992.1564
    G. M. Pharr, A. Bolshakov, J. Mater. Res. 17 (2002) 2660-2671
    """

    curve: ForceCurve
    profile: Profile
    contact_point: float = 0.0
    upper: float = 0.98
    lower: float = 0.4
    shape_factor: float = 1.0

    def __post_init__(self) -> None:
        if not 0.0 <= self.lower < self.upper <= 1.0:
            raise InvalidInput(
                f"OliverPharr: the limits of the fitted part are {self.upper!r} and {self.lower!r}; "
                "give 1 >= upper > lower >= 0, parts of the greatest force."
            )
        if not 0.0 < self.shape_factor < math.inf:
            raise InvalidInput(f"OliverPharr: shape_factor is {self.shape_factor!r}; it must be positive.")

    def solve(self) -> OliverPharrSolution:
        """Return stiffness, depth, area, modulus and hardness, with their standard errors.

        Raises
        ------
        InvalidInput
            If nothing comes out, or too few points lie between the limits.
        OutsideValidity
            If the contact depth is not positive, or beyond the profile.
        NotConverged
            If no power law fits the unloading.
        """
        depth, force = self._unloading()
        highest, deepest = float(force.max()), float(depth.max())
        law = _power_law(depth / deepest, force / highest, self._between(force / highest))
        law = _power_law(depth / deepest, force / highest, self._between(law.fitted / law.fitted.max()))
        numbers = self._read(law.numbers, deepest, highest)
        turned = np.empty((numbers.size, law.numbers.size))
        for i in range(law.numbers.size):
            step = np.zeros(law.numbers.size)
            step[i] = STEP
            ahead, behind = (self._read(law.numbers + sign * step, deepest, highest) for sign in (1.0, -1.0))
            turned[:, i] = (ahead - behind) / (2.0 * STEP)
        errors = np.sqrt(np.maximum(np.einsum("ij,jk,ik->i", turned, law.covariance, turned), 0.0))
        top = math.exp(law.numbers[0]) * highest
        return OliverPharrSolution(
            self,
            top,
            deepest,
            exponent=float(numbers[0]),
            final_depth=float(numbers[1]),
            stiffness=float(numbers[2]),
            contact_depth=float(numbers[3]),
            area=float(numbers[4]),
            modulus=float(numbers[5]),
            hardness=float(numbers[6]),
            standard_errors=errors,
            scatter=law.scatter * highest,
        )

    def _unloading(self) -> tuple[Array, Array]:
        """Return depths and forces from the greatest depth on."""
        curve = self.curve.retract
        depth = curve.depth(self.contact_point)
        summit = int(np.argmax(depth))
        if not curve.force[summit] > 0.0 or not depth[summit] > 0.0:
            raise InvalidInput(
                f"OliverPharr: at the greatest depth, {depth[summit]:.3g} m, the force is {curve.force[summit]:.3g} N; "
                "both must be positive: look at signs and contact_point."
            )
        return depth[summit:], curve.force[summit:]

    def _between(self, share: Array) -> Array:
        """Return the points between the limits."""
        chosen = (share <= self.upper) & (share >= self.lower)
        if np.count_nonzero(chosen) < FEWEST:
            raise InvalidInput(
                f"OliverPharr: {int(np.count_nonzero(chosen))} points lie between {self.lower:g} and {self.upper:g} of "
                f"the greatest force; at least {FEWEST} are needed."
            )
        return np.asarray(chosen)

    def _read(self, law: Array, deepest: float, highest: float) -> Array:
        """Return m, h_f, S, h_c, A, E_r and H from the numbers of the power law."""
        top, final, exponent = math.exp(law[0]), float(law[1]), 1.0 + math.exp(law[2])
        force = top * highest
        slope = exponent * force / ((1.0 - final) * deepest)
        contact = deepest - intercept_factor(exponent) * force / slope
        area = math.pi * self._radius(contact) ** 2
        modulus = 0.5 * math.sqrt(math.pi) * slope / (self.shape_factor * math.sqrt(area))
        return np.array([exponent, final * deepest, slope, contact, area, modulus, force / area])

    def _radius(self, height: float) -> float:
        """Return the radius of the tip's cross-section at a height [m]."""
        end = min(self.profile.reach, self.profile.rim)
        if not height > 0.0:
            raise OutsideValidity(f"OliverPharr: the contact depth is {height:.3g} m; look at contact_point.")

        def high(radius: float) -> float:
            return float(self.profile.height(np.array([radius]))[0]) - height

        from scipy.optimize import brentq

        low = min(1e-9, 0.5 * end)
        while high(low) > 0.0 and low > 1e-30:
            low *= 0.5
        far = low
        while far < end and high(far) < 0.0:
            far = min(2.0 * far, end)
        if high(far) < 0.0:
            raise OutsideValidity(
                f"OliverPharr: the contact depth {height:.3g} m is beyond the tip, which is known up to a radius of "
                f"{end:.3g} m."
            )
        return float(brentq(high, low, far, xtol=1e-300, rtol=1e-14))


@value
class OliverPharrSolution:
    """What an unloading curve says.

    Parameters
    ----------
    problem : OliverPharr
        What was asked.
    force : float
        Force of the fitted unloading at the greatest depth [N].
    depth : float
        Greatest depth [m].
    exponent : float
        m of the unloading [-].
    final_depth : float
        h_f [m], where the fitted unloading ends.
    stiffness : float
        S [N/m] at the greatest depth.
    contact_depth : float
        h_c [m].
    area : float
        Projected area of contact [m^2].
    modulus : float
        Reduced modulus E_r [Pa], that of the pair.
    hardness : float
        [Pa].
    standard_errors : ndarray, (7,)
        Of exponent, final_depth, stiffness, contact_depth, area, modulus, hardness, in their units: from the scatter of
        the unloading alone.
    scatter : float
        Standard deviation of the forces about the power law [N].
    """

    problem: OliverPharr
    force: float
    depth: float
    exponent: float
    final_depth: float
    stiffness: float
    contact_depth: float
    area: float
    modulus: float
    hardness: float
    standard_errors: Array
    scatter: float


class _PowerLaw(NamedTuple):
    """Numbers (ln of the force at the top, h_f, ln(m - 1)), their covariance, scatter, and the force at all depths."""

    numbers: Array
    covariance: Array
    scatter: float
    fitted: Array


def _power_law(all_depths: Array, forces: Array, chosen: Array) -> _PowerLaw:
    """Return the fitted law F = T ((h - h_f)/(1 - h_f))^m, everything in parts of the greatest."""
    from scipy.optimize import least_squares

    depth, force = all_depths[chosen], forces[chosen]
    least = float(depth.min())

    def law(numbers: Array, depth: Array = depth) -> tuple[Array, Array]:
        share = (depth - numbers[1]) / (1.0 - numbers[1])
        power = 1.0 + np.exp(numbers[2])
        value_ = np.exp(numbers[0]) * np.maximum(share, 1e-12) ** power
        log = np.log(np.maximum(share, 1e-12))
        final = value_ * power * (1.0 / (1.0 - numbers[1]) - 1.0 / np.maximum(depth - numbers[1], 1e-12))
        return value_, np.stack([value_, final, value_ * log * (power - 1.0)], axis=1)

    best = None
    for share in (0.0, 0.5, 0.9):
        start = np.array([0.0, min(share * least, least - 1e-6), math.log(0.5)])
        found = least_squares(
            lambda at: law(at)[0] - force,
            start,
            jac=lambda at: law(at)[1],
            bounds=([-5.0, -10.0, -12.0], [5.0, least - 1e-9, 3.0]),
            x_scale="jac",
            max_nfev=LONGEST,
            ftol=1e-14,
            xtol=1e-14,
            gtol=1e-15,
        )
        if best is None or found.cost < best.cost:
            best = found
    if best is None or not best.success:
        raise NotConverged("OliverPharr: no power law fits the unloading; fit another part of it (upper, lower).")
    kept = memory(best.fun)
    covariance, used = spread(law(best.x)[1], kept.correlations)
    scatter = math.sqrt(2.0 * best.cost / max(depth.size - used, 1.0))
    return _PowerLaw(best.x, scatter**2 * covariance, scatter, law(best.x, all_depths)[0])


def sample_young(modulus: float, poisson: float, indenter: Solid) -> float:
    """Return the sample's Young's modulus from the reduced modulus of the pair.

    Parameters
    ----------
    modulus : float
        E_r [Pa].
    poisson : float
        Of the sample [-].
    indenter : Elastic or Rigid
        Of diamond: Elastic(young=1141e9, poisson=0.07).

    Returns
    -------
    float
        E [Pa], 1/E_r = (1 - nu^2)/E + (1 - nu_i^2)/E_i.

    Raises
    ------
    OutsideValidity
        If the pair is as stiff as the indenter alone, or stiffer.
    """
    own = 0.0 if isinstance(indenter, Rigid) else (1.0 - indenter.poisson**2) / indenter.young
    left = 1.0 / modulus - own
    if not isinstance(indenter, Elastic | Rigid) or not left > 0.0:
        raise OutsideValidity(
            f"sample_young: the pair's modulus {modulus:.4g} Pa leaves nothing for the sample; the indenter is softer."
        )
    return (1.0 - poisson**2) / left
