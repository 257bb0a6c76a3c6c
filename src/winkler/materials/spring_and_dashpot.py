"""Viscoelastic solids of one dashpot: beside a spring, behind one, or behind one and both beside another."""

from __future__ import annotations

import numpy as np

from winkler.materials.viscoelastic import ViscoelasticSolid
from winkler.numerics.springs.exponential_sums import RelaxationSeries
from winkler.values.checks.number_checks import PoissonRatio, Positive
from winkler.values.value import value


@value
class KelvinVoigt(ViscoelasticSolid):
    """A spring and a dashpot in parallel: the stress is G gamma + eta dgamma/dt.

    It has no instantaneous elasticity: a sudden step of strain needs an infinite force.

    Parameters
    ----------
    shear : float
        G [Pa], positive.
    viscosity : float
        eta [Pa s], positive.
    poisson : float, optional
        nu [-].

    Raises
    ------
    InvalidInput
        If a number is outside its range.

    Examples
    --------
    >>> round(float(KelvinVoigt(shear=2.0, viscosity=4.0).creep(2.0)), 9)
    0.316060279
    """

    shear: Positive
    viscosity: Positive
    poisson: PoissonRatio = 0.5

    @property
    def series(self) -> RelaxationSeries:
        """G(t) [Pa]."""
        return RelaxationSeries(self.shear, self.viscosity, np.empty(0), np.empty(0))


@value
class Maxwell(ViscoelasticSolid):
    """A spring and a dashpot in series, G(t) = G exp(-t / tau): a liquid at long times.

    Parameters
    ----------
    shear : float
        G [Pa], positive.
    relaxation_time : float
        tau [s], positive: viscosity over G.
    poisson : float, optional
        nu [-].

    Raises
    ------
    InvalidInput
        If a number is outside its range.

    Examples
    --------
    >>> float(Maxwell(shear=2.0, relaxation_time=3.0).creep(6.0))
    1.5
    """

    shear: Positive
    relaxation_time: Positive
    poisson: PoissonRatio = 0.5

    @property
    def series(self) -> RelaxationSeries:
        """G(t) [Pa]."""
        return RelaxationSeries(0.0, 0.0, np.array([self.shear]), np.array([self.relaxation_time]))


@value
class StandardSolid(ViscoelasticSolid):
    """The standard linear solid (Zener), G(t) = G_inf + G_1 exp(-t / tau).

    Parameters
    ----------
    relaxed_shear : float
        G_inf [Pa], positive.
    shear : float
        G_1 [Pa], positive: the part of the modulus that relaxes.
    relaxation_time : float
        tau [s], positive.
    poisson : float, optional
        nu [-].

    Raises
    ------
    InvalidInput
        If a number is outside its range.

    Examples
    --------
    >>> float(StandardSolid(relaxed_shear=1.0, shear=3.0, relaxation_time=0.5).storage(2.0))
    2.5
    """

    relaxed_shear: Positive
    shear: Positive
    relaxation_time: Positive
    poisson: PoissonRatio = 0.5

    @property
    def series(self) -> RelaxationSeries:
        """G(t) [Pa]."""
        return RelaxationSeries(self.relaxed_shear, 0.0, np.array([self.shear]), np.array([self.relaxation_time]))
