r"""Relaxation of the force on a poroelastic half-space held at a constant depth, as tables of its solution.

Frictionless, impermeable indenters on a half-space that drains freely outside of the contact, whose radius stays as it
is,

.. math:: F(t) = F_\infty + (F_0-F_\infty)\,g(\tau,\nu),\quad \tau=Dt/a^2,\quad F_\infty=\frac{F_0}{2(1-\nu)} .

The tables are the solution of the dual integral equations of Biot's theory in Hankel and Laplace space (McNamee and
Gibson), inverted by the algorithm of Stehfest; tests/problems/biot_solution.py computes them anew.  Finite elements in
space and time agree with all to 0.015, the formula of Lai and Hu with that of the flat punch at nu = 0 to 0.005.

J. McNamee, R. E. Gibson, Q. J. Mech. Appl. Math. 13 (1960) 98-111, doi:10.1093/qjmam/13.1.98; Y. Lai, Y. Hu, Soft
Matter 13 (2017) 852-861
"""

from __future__ import annotations

import functools
from collections.abc import Callable

import numpy as np

from winkler.numerics.types import Array

TIMES = np.geomspace(1e-3, 1e3, 25)
"""tau of the tables."""
POISSON = np.array([0.0, 0.1, 0.2, 0.3, 0.4, 0.49])
"""Poisson's ratios of the rows."""
GREATEST_POISSON = 0.49
NUMBERS = {
    "flat": """
    0.96757 0.94835 0.93251 0.90895 0.88323 0.84758 0.79640 0.73675 0.65000 0.54836 0.43094 0.31351 0.21664
    0.15011 0.10711 0.07820 0.05780 0.04301 0.03211 0.02402 0.01799 0.01348 0.01011 0.00758 0.00569
    0.96797 0.94928 0.93321 0.91007 0.88413 0.84830 0.79802 0.73790 0.65311 0.55257 0.43640 0.31993 0.22317
    0.15581 0.11162 0.08164 0.06040 0.04496 0.03358 0.02512 0.01882 0.01410 0.01057 0.00792 0.00593
    0.96794 0.95012 0.93398 0.91130 0.88519 0.84930 0.79990 0.73956 0.65667 0.55737 0.44261 0.32724 0.23062
    0.16234 0.11682 0.08562 0.06341 0.04723 0.03528 0.02640 0.01977 0.01482 0.01111 0.00832 0.00623
    0.96777 0.95083 0.93475 0.91262 0.88639 0.85061 0.80208 0.74182 0.66079 0.56292 0.44980 0.33567 0.23923
    0.16993 0.12289 0.09029 0.06695 0.04990 0.03729 0.02791 0.02091 0.01567 0.01174 0.00880 0.00659
    0.96749 0.95160 0.93572 0.91402 0.88787 0.85229 0.80467 0.74480 0.66567 0.56949 0.45825 0.34559 0.24939
    0.17893 0.13015 0.09590 0.07121 0.05311 0.03971 0.02973 0.02227 0.01669 0.01252 0.00940 0.00708
    0.96669 0.95198 0.93684 0.91558 0.88932 0.85414 0.80748 0.74824 0.67094 0.57656 0.46734 0.35624 0.26031
    0.18867 0.13806 0.10205 0.07590 0.05666 0.04238 0.03174 0.02379 0.01785 0.01341 0.01018 0.00790
    """,
    "ball": """
    1.00010 0.98949 0.98399 0.97195 0.95868 0.93438 0.89096 0.83271 0.73679 0.61617 0.47459 0.33574 0.22578
    0.15339 0.10830 0.07866 0.05798 0.04308 0.03214 0.02403 0.01800 0.01348 0.01011 0.00758 0.00569
    1.00019 0.99009 0.98427 0.97257 0.95891 0.93427 0.89166 0.83275 0.73893 0.61958 0.47954 0.34198 0.23233
    0.15915 0.11285 0.08212 0.06059 0.04504 0.03361 0.02514 0.01882 0.01410 0.01057 0.00792 0.00593
    0.99982 0.99055 0.98456 0.97322 0.95921 0.93433 0.89246 0.83319 0.74139 0.62347 0.48518 0.34907 0.23979
    0.16574 0.11809 0.08612 0.06361 0.04731 0.03531 0.02641 0.01978 0.01482 0.01111 0.00832 0.00623
    0.99926 0.99082 0.98477 0.97386 0.95953 0.93457 0.89342 0.83408 0.74424 0.62799 0.49170 0.35727 0.24842
    0.17339 0.12421 0.09081 0.06716 0.04998 0.03732 0.02792 0.02091 0.01567 0.01174 0.00880 0.00659
    0.99850 0.99107 0.98509 0.97445 0.95997 0.93498 0.89456 0.83546 0.74764 0.63333 0.49939 0.36691 0.25858
    0.18247 0.13151 0.09644 0.07143 0.05320 0.03975 0.02974 0.02228 0.01670 0.01252 0.00940 0.00709
    0.99725 0.99089 0.98550 0.97513 0.96026 0.93547 0.89582 0.83722 0.75132 0.63910 0.50766 0.37726 0.26952
    0.19230 0.13948 0.10262 0.07614 0.05676 0.04242 0.03176 0.02380 0.01785 0.01341 0.01018 0.00791
    """,
    "cone": """
    1.00148 0.99178 0.98769 0.97779 0.96763 0.94742 0.90864 0.85412 0.75860 0.63407 0.48619 0.34161 0.22815
    0.15422 0.10860 0.07877 0.05803 0.04310 0.03215 0.02404 0.01800 0.01348 0.01011 0.00758 0.00569
    1.00157 0.99236 0.98794 0.97836 0.96779 0.94720 0.90917 0.85393 0.76050 0.63727 0.49100 0.34780 0.23470
    0.16000 0.11316 0.08224 0.06064 0.04506 0.03362 0.02514 0.01882 0.01410 0.01057 0.00792 0.00593
    1.00119 0.99281 0.98821 0.97897 0.96801 0.94713 0.90979 0.85412 0.76268 0.64092 0.49648 0.35484 0.24216
    0.16660 0.11841 0.08624 0.06366 0.04733 0.03532 0.02642 0.01978 0.01482 0.01111 0.00832 0.00623
    1.00061 0.99306 0.98839 0.97956 0.96824 0.94722 0.91052 0.85471 0.76523 0.64516 0.50283 0.36296 0.25079
    0.17428 0.12454 0.09094 0.06721 0.05000 0.03733 0.02793 0.02091 0.01567 0.01174 0.00880 0.00659
    0.99983 0.99329 0.98867 0.98008 0.96857 0.94747 0.91141 0.85575 0.76825 0.65019 0.51031 0.37252 0.26096
    0.18338 0.13186 0.09658 0.07149 0.05323 0.03976 0.02975 0.02228 0.01670 0.01252 0.00940 0.00709
    0.99858 0.99308 0.98904 0.98070 0.96875 0.94776 0.91240 0.85715 0.77154 0.65562 0.51836 0.38279 0.27189
    0.19322 0.13984 0.10276 0.07620 0.05678 0.04243 0.03176 0.02380 0.01785 0.01341 0.01018 0.00791
    """,
}
"""Shape of the indenter -> g, one pair of lines for each Poisson's ratio."""
TABLES = {shape: np.array(text.split(), dtype=float).reshape(POISSON.size, -1) for shape, text in NUMBERS.items()}
"""Shape of the indenter -> g, one row for each Poisson's ratio."""


def relaxed_share(shape: str, tau: Array, poisson: float) -> Array:
    """Return g, the part of the force that still has to relax: 1 at first, 0 at last.

    Parameters
    ----------
    shape : str
        "flat", "ball" or "cone".
    tau : ndarray
        D t / a^2 [-], positive; outside of the tables the laws of short and long times, 1 - g ~ tau^(1/2) and
        g ~ tau^(-1/2), continue them.
    poisson : float
        nu of the drained body [-], 0 to 0.49.
    """
    rows = np.array([curve(np.log(np.clip(tau, TIMES[0], TIMES[-1]))) for curve in _curves(shape)])
    share = np.clip(_weights(poisson) @ rows, 0.0, 1.0)
    early, late = np.sqrt(tau / TIMES[0]), np.sqrt(TIMES[-1] / np.maximum(tau, TIMES[-1]))
    return np.asarray(np.where(tau < TIMES[0], 1.0 - (1.0 - share) * early, share * late))


def _weights(poisson: float) -> Array:
    """Return the weights of the rows, those of Lagrange's polynomial."""
    apart = POISSON[:, None] - POISSON
    shares = np.divide(poisson - POISSON, apart, out=np.ones_like(apart), where=apart != 0.0)
    return np.asarray(np.prod(shares, axis=1))


@functools.cache
def _curves(shape: str) -> tuple[Callable[[Array], Array], ...]:
    from scipy.interpolate import PchipInterpolator

    return tuple(PchipInterpolator(np.log(TIMES), np.minimum(row, 1.0)) for row in TABLES[shape])
