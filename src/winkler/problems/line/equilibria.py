r"""The equilibria of a line contact that sticks, as those of a round one.

The strip is in equilibrium where the edge releases the work of adhesion :math:`\gamma`.  A pull -Q of the edge has the
stress intensity :math:`K_I = Q/\sqrt{\pi a}` of a flat punch, and :math:`K_I^2 = 2E^*\gamma` gives

.. math:: P(a) = E^* w(a) - \sqrt{2\pi a E^*\gamma} .

That is the depth :math:`d(a) = g(a) - \sqrt{2\pi a\gamma/c_N}` of springs with :math:`g = E^* w` and :math:`c_N =
1/E^*`.  On layers the edges of a flat punch are s times as steep as on half-planes, :math:`K_I = sQ/\sqrt{\pi a}` with
E* of the uppermost layer, so that :math:`c_N = s^2/E^*`.  A line contact under a dead load is as stable as such a round
one in fixed grips, and what finds the branches of the latter (`winkler.problems.adhesion.stability`) finds those of the
former.
"""

from __future__ import annotations

from winkler.foundation.line_bed import LineBed
from winkler.laws.adhesion import Dugdale, ShortRange
from winkler.problems.adhesion.edge_states import EdgeStates, ShortStates
from winkler.problems.line.cohesive import CohesiveLineStates
from winkler.problems.line.load_springs import LoadSprings

LineLaw = ShortRange | Dugdale
"""How the surfaces of a line contact may attract each other."""
FIXED_GRIPS = float("inf")
"""Of the round contact: a dead load of the line contact."""


def line_states(bed: LineBed, law: LineLaw) -> EdgeStates:
    """Return the equilibria of a line contact: their `depth` is the force per length [N/m].

    Parameters
    ----------
    bed : LineFoundation or LayeredLineFoundation
    law : ShortRange or Dugdale

    Raises
    ------
    OutsideValidity
        If the law does not hold for the profile.
    """
    return CohesiveLineStates(bed, law) if isinstance(law, Dugdale) else ShortStates(LoadSprings(bed), law.work)
