"""How elements slip as a shear force grows under a steady normal force, from which all of its history follows.

Between two forces at which an element begins to slip all is straight.  From a turning point on twice as much slips
under twice the force (Masing), until an earlier turning point is reached.

References
----------
M. Ciavarella, Int. J. Solids Struct. 35 (1998) 2349-2362, doi:10.1016/S0020-7683(97)00154-6
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from winkler.numerics.types import Array
from winkler.problems.line_friction.elements import LineElements

ROUNDING = 1e-12


class FirstSlip(NamedTuple):
    """Elements under growing shear forces, from none to the one under which all slip.

    Parameters
    ----------
    shears, shifts
        Q over E* A and the shift over A at which elements begin to slip ``(k,)``.
    traction, ahead, slips
        Over E*, over A, and which elements slip from there on ``(k, n)``.
    """

    shears: Array
    shifts: Array
    traction: Array
    ahead: Array
    slips: Array

    def at(self, shear: float) -> tuple[Array, Array, Array, float]:
        """Return traction, how far elements are ahead, which of them slip, and the shift under a shear force."""
        place = int(np.searchsorted(self.shears, shear, side="right")) - 1
        low = min(place, self.shears.size - 2)
        part = min((shear - self.shears[low]) / (self.shears[low + 1] - self.shears[low]), 1.0)
        traction, ahead, shift = (
            row[low] + part * (row[low + 1] - row[low]) for row in (self.traction, self.ahead, self.shifts)
        )
        return traction, ahead, self.slips[place], float(shift)


def first_slip(elements: LineElements, bound: Array) -> FirstSlip | None:
    """Return it for friction that bears these tractions over E* at most; None if some elements stick again."""
    n = elements.x.size // 2
    own = elements.compliance[n:, n:] + elements.compliance[n:, n - 1 :: -1]  # both sides alike
    widths = 2.0 * elements.widths[n:]
    raised = float(np.max(-own / widths))  # counted from where no traction moves less, shifts are positive
    own, right = own + raised * widths, bound[n:]
    traction, shift, slips = np.zeros(n), 0.0, right == 0.0
    rows = [(0.0, traction, traction, slips)]
    while not slips.all():
        sticks, rate, margin = np.flatnonzero(~slips), np.zeros(n), np.full(n, np.inf)
        rate[sticks] = np.linalg.solve(own[np.ix_(sticks, sticks)], np.ones(sticks.size))
        grows = rate > 0.0
        margin[grows] = (right - traction)[grows] / rate[grows]
        step = float(np.min(margin))
        if not 0.0 < step < np.inf:
            return None
        slips, shift = slips | (margin <= step * (1.0 + ROUNDING)), shift + step
        traction = np.where(slips, right, traction + step * rate)
        rows.append((shift, traction, np.where(slips, shift - own @ traction, 0.0), slips))
    shifts, *whole = (np.array(each) for each in zip(*rows, strict=True))
    shears = whole[0] @ widths
    if np.min(np.diff(whole[1], axis=0)) < -ROUNDING * shift:
        return None
    return FirstSlip(shears, shifts - raised * shears, *(np.hstack([half[:, ::-1], half]) for half in whole))
