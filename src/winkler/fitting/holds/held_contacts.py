"""Measured holds of several contact radii: does a liquid leave the body, or is it viscoelastic, and its numbers.

The depth scaling of the times tells the kind of body (`winkler.fitting.holds.depth_scaling`); shear modulus, Poisson's
ratio and diffusivity are those of the poroelastic body that describes all holds best
(`winkler.fitting.holds.poroelastic`), and mean something only if the body is one.
"""

from __future__ import annotations

import functools
import math
from typing import Annotated, ClassVar

from winkler.fitting.holds.depth_scaling import DepthScaling, HoldVerdict, depth_scaling, distinct_radii
from winkler.fitting.holds.held_force import HeldForce, checked_holds
from winkler.fitting.holds.poroelastic import PoroelasticFit, fit_poroelastic
from winkler.numerics.types import Array
from winkler.problems.assumptions.declared import RELAXING
from winkler.problems.poroelastic.held import shape_of
from winkler.values.checks.number_checks import Advice
from winkler.values.readable import with_unit
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value, words

SCALING = "generalised least squares of the shifts of all holds over the contact radius, at 99 % confidence"
STEADY, GROWING = "0.01, which is 5 % of D", "0.03, which is 12 % of D"
"""What is not known of g, of a constant contact radius and of one that grows: over the greatest slope dg/d ln t."""
MEANINGS = {
    HoldVerdict.POROELASTIC: (
        Standing.ASYMPTOTIC,
        "poroelastic: the times grow as the contact area; a viscoelastic body is excluded",
    ),
    HoldVerdict.VISCOELASTIC: (
        Standing.OUTSIDE,
        "viscoelastic: the times do not grow with the contact, and a poroelastic body is excluded. The "
        "poroelastic parameters are meaningless here, so fit the curves with a viscoelastic body",
    ),
    HoldVerdict.UNDECIDED: (
        Standing.APPROXIMATE,
        "undecided: both kinds are possible, and the parameters apply only if the body is poroelastic; add holds "
        "with other contact radii",
    ),
    HoldVerdict.NEITHER: (
        Standing.OUTSIDE,
        "neither: the times grow with the contact, but not as its area, as for a body that is both. The "
        "poroelastic parameters are meaningless here",
    ),
}


@value
class HeldContacts:
    """Force relaxation of contacts at constant depth, with at least two contact radii.

    Parameters
    ----------
    holds : sequence of HeldForce
        Two or more, of one shape of indenter, with different contact radii.
    vertical : bool, optional
        Whether the forces of each hold period have a free factor when times are compared, so that an error of the
        depth does not bias the verdict.

    Raises
    ------
    InvalidInput
        If there are fewer than two, shapes differ, or the contact radii are nearly the same.

    References
    ----------
    Y. Hu, X. Zhao, J. J. Vlassak, Z. Suo, Appl. Phys. Lett. 96 (2010) 121904, doi:10.1063/1.3370354

    Examples
    --------
    >>> import numpy as np
    >>> from winkler.problems.poroelastic.held import PoroelasticRelaxation
    >>> from winkler.profiles.power import Paraboloid
    >>> rng, time, holds = np.random.default_rng(1), np.geomspace(1.0, 3e3, 40), []
    >>> for depth in (10e-6, 40e-6):
    ...     gel = PoroelasticRelaxation(Paraboloid(1e-3), 5e3, 0.3, 1e-10, depth=depth, time=time)
    ...     force = gel.solve().force * (1.0 + 5e-3 * rng.standard_normal(40))
    ...     holds.append(HeldForce(gel.profile, depth, time, force))
    >>> found = HeldContacts(holds).solve()
    >>> found.verdict, round(found.shear, -2)
    ('poroelastic', 5000.0)
    """

    __words__ = words(
        holds=("", None, "measured forces of contacts held at constant depths"),
        vertical=("", None, "whether each hold has a free factor of its forces"),
    )

    holds: Annotated[tuple[HeldForce, ...], Advice("a list of holds")]
    vertical: bool = True

    references: ClassVar[tuple[str, ...]] = ("hu_zhao_vlassak_suo_2010", "lai_hu_2017", "mcnamee_gibson_1960")
    assumptions: ClassVar[frozenset[Assumption]] = RELAXING | {Assumption.CURVE}

    def __post_init__(self) -> None:
        distinct_radii("HeldContacts", checked_holds("HeldContacts", self.holds, 2))

    def solve(self) -> HeldContactsSolution:
        """Return the growth of the times with the contact radius, and the best poroelastic body.

        Returns
        -------
        HeldContactsSolution

        Raises
        ------
        NotConverged
            If an iteration does not converge.
        """
        scaling, body = depth_scaling(self.holds, vertical=self.vertical), fit_poroelastic(self.holds)
        stiffness, poisson, spread = (math.sqrt(float(body.covariance[place, place])) for place in range(3))
        return HeldContactsSolution(
            problem=self,
            radius=scaling.radius,
            shift_factor=scaling.shift_factor,
            shift_error=scaling.shift_error,
            exponent=scaling.exponent,
            exponent_error=scaling.error,
            shear=body.shear,
            shear_error=body.shear * stiffness,
            poisson=body.poisson,
            poisson_error=poisson,
            diffusivity=body.diffusivity,
            diffusivity_error=body.diffusivity * spread,
            scatter=body.scatter,
            verdict=scaling.verdict,
        )


@value
class HeldContactsSolution:
    """The solution of a `HeldContacts`.

    Parameters
    ----------
    problem : HeldContacts
        The problem that was solved.
    radius : ndarray, (m,)
        a [m] of each hold, rising.
    shift_factor, shift_error : ndarray, (m,)
        Times relative to those of the smallest contact [-], and the standard error of their natural logarithm.
    exponent, exponent_error : float
        Power of the contact radius with which the times grow [-]: 2 of a poroelastic body, 0 of a viscoelastic one.
    shear, shear_error : float
        G [Pa] of the poroelastic body that describes all holds best, and its standard error.
    poisson, poisson_error : float
        nu [-] of the drained network.
    diffusivity, diffusivity_error : float
        D [m^2/s].
    scatter : float
        Relative scatter of the forces about those of that body [-].
    verdict : str
        "poroelastic", "viscoelastic", "cannot tell" or "neither", by the exponent.
    """

    __words__ = words(
        radius=("a", "m", "contact radius of each hold"),
        shift_factor=("", "", "times relative to those of the smallest contact"),
        shift_error=("", "", "standard error of the natural logarithm of the shift factor"),
        exponent=("n", "", "power of the contact radius with which the times grow"),
        exponent_error=("", "", "standard error of the exponent"),
        shear=("G", "Pa", "shear modulus of the poroelastic body that describes all holds best"),
        shear_error=("", "Pa", "standard error of the shear modulus"),
        poisson=(r"\nu", "", "Poisson's ratio of the drained network"),
        poisson_error=("", "", "standard error of Poisson's ratio"),
        diffusivity=("D", "m^2/s", "effective diffusivity of the liquid in the network"),
        diffusivity_error=("", "m^2/s", "standard error of the diffusivity"),
        scatter=("", "", "relative scatter of the forces about those of the poroelastic body"),
        verdict=("", None, "poroelastic, viscoelastic, cannot tell or neither"),
    )

    problem: HeldContacts
    radius: Array
    shift_factor: Array
    shift_error: Array
    exponent: float
    exponent_error: float
    shear: float
    shear_error: float
    poisson: float
    poisson_error: float
    diffusivity: float
    diffusivity_error: float
    scatter: float
    verdict: str

    @functools.cached_property
    def scaling(self) -> DepthScaling:
        """The shifts with their misfit and intervals."""
        return depth_scaling(self.problem.holds, vertical=self.problem.vertical)

    @functools.cached_property
    def body(self) -> PoroelasticFit:
        """The poroelastic body with covariances, intervals and residuals."""
        return fit_poroelastic(self.problem.holds)

    @property
    def validity(self) -> tuple[Note, ...]:
        """The kind of body that the holds indicate, and the meaning of the parameters."""
        low, high = self.scaling.interval()
        standing, meaning = MEANINGS[HoldVerdict(self.verdict)]
        kind = Note(
            Assumption.CURVE,
            standing,
            f"The times of {len(self.problem.holds)} holds grow with the power {self.exponent:.2f} of the contact "
            f"radius (95 %: {low:.2f} to {high:.2f}); a poroelastic body has 2, a viscoelastic body 0: {meaning}.",
            SCALING,
        )
        ends = ", ".join(
            f"{symbol} {with_unit(low, unit, 3)} to {with_unit(high, unit, 3)}"
            for symbol, unit, (low, high) in (
                ("G", "Pa", self.body.interval("shear")),
                ("nu", "", self.body.interval("poisson")),
                ("D", "m^2/s", self.body.interval("diffusivity")),
            )
        )
        unsure = GROWING if shape_of(self.problem.holds[0].profile) != "flat" else STEADY
        bound = "; Poisson's ratio is at an end of its range, and its interval is meaningless" * self.body.at_bound
        numbers = Note(
            Assumption.RESPONSE,
            Standing.APPROXIMATE,
            f"If the body is poroelastic, the 95 % intervals are {ends}, from the scatter alone{bound}. In "
            f"addition the relaxing part of the force is known within {unsure}. Theory: Biot's, for an "
            "impermeable indenter pressed in at once on a freely draining body. Leave out times shorter than the "
            "loading time.",
            "dual integral equations at a constant contact radius",
        )
        return kind, numbers
