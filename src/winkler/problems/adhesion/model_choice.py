r"""Which model of adhesion fits a contact: the range of attraction against how far it stretches the surfaces.

Tabor's parameter compares both, Maugis' parameter is the same but for a factor,

.. math:: \mu = \Bigl(\frac{R\,w^2}{E^{*2} z_0^3}\Bigr)^{1/3}, \qquad
          \lambda = 2\sigma_0\Bigl(\frac{R}{\pi w K^2}\Bigr)^{1/3}, \quad K = \tfrac43E^* ,

with :math:`\lambda = 1.1272\,\mu` if :math:`z_0 = w/\sigma_0`.  Large values mean JKR, small ones DMT.  What a model is
wrong by is not read off a map here but computed, against Maugis' equations for the same profile.
"""

from __future__ import annotations

import numpy as np

from winkler.foundation.bed import Bed
from winkler.laws.adhesion import DerjaguinMullerToporov, Dugdale, ShortRange
from winkler.loading.loads import Force
from winkler.problems.adhesion import griffith
from winkler.problems.adhesion.indentation import AdhesiveIndentation, AdhesiveSolution
from winkler.problems.adhesion.pull_off import PullOff
from winkler.problems.adhesion.tabor import MAUGIS_OVER_TABOR
from winkler.problems.assumptions.adhesion_range import GREENWOOD, PULL_OFF_STRETCH
from winkler.problems.normal.indentation import Indentation
from winkler.values.errors import InvalidInput, OutsideValidity
from winkler.values.validity import Assumption, Note, Standing
from winkler.values.value import value, words

UNLOADED = Force(0.0)
TABOR = "D. Tabor, J. Colloid Interface Sci. 58 (1977) 2-13, doi:10.1016/0021-9797(77)90366-6"
EQUATIONS = "D. Maugis, J. Colloid Interface Sci. 150 (1992) 243-269, doi:10.1016/0021-9797(92)90285-T"


@value
class ModelError:
    """The result of one model, and how far it is from Maugis' equations for the same profile.

    Parameters
    ----------
    model : str
        Hertz (no adhesion), DMT, Maugis or JKR.
    pull_off : float
        Force at which a dead load tears the contact off [N], negative; zero without adhesion.
    radius : float
        Contact radius [m] under the given load.
    pull_off_error, radius_error : float
        Relative [-], against Maugis.
    """

    __words__ = words(pull_off=("F_A", "N", "force at which a dead load tears the contact off"))

    model: str
    pull_off: float
    radius: float
    pull_off_error: float
    radius_error: float


@value
class Recommendation:
    """Which model to take, and why.

    Parameters
    ----------
    problem : Indentation or AdhesiveIndentation
        The contact under the given load, in the recommended model; ready to be solved.
    model : str
        Its name: Hertz, DMT, Maugis or JKR.
    tabor : float
        Tabor's parameter with the distance work / strength [-]; for a profile that is no paraboloid, that of the
        paraboloid whose edge is stretched as far at the pull-off.
    models : tuple of ModelError
        What each model that exists for this profile would be wrong by.
    notes : tuple of Note
        The reasons, in sentences, with sources.
    """

    problem: Indentation | AdhesiveIndentation
    model: str
    tabor: float
    models: tuple[ModelError, ...]
    notes: tuple[Note, ...]

    @property
    def maugis(self) -> float:
        """Maugis' parameter lambda [-]."""
        return MAUGIS_OVER_TABOR * self.tabor


def which_model(bed: Bed, law: Dugdale, load: Force = UNLOADED, *, tolerance: float = 0.02) -> Recommendation:
    """Return the simplest model of adhesion that is good enough for a contact.

    Parameters
    ----------
    bed : Bed
        On a homogeneous half-space or one graded by a power of the depth, where Maugis' equations hold.
    law : Dugdale
        Work of adhesion and strength of the attraction; for molecular forces strength is about work / 0.3 nm.
    load : Force, optional
        The load of interest [N], zero or positive. At large loads adhesion may be negligible.
    tolerance : float, optional
        Permitted relative error of the pull-off force and, under the load, of the contact radius.

    Raises
    ------
    InvalidInput
        If law, load or tolerance are of other kinds.
    OutsideValidity
        If Maugis' equations do not hold on this medium.

    References
    ----------
    K. L. Johnson, J. A. Greenwood, J. Colloid Interface Sci. 192 (1997) 326-333, doi:10.1006/jcis.1997.4984

    Examples
    --------
    >>> from winkler.foundation.foundation import Foundation
    >>> from winkler.materials.elastic import Elastic
    >>> from winkler.media.halfspace import HalfSpace
    >>> from winkler.profiles.power import Paraboloid
    >>> rubber = Foundation(Paraboloid(1e-3), HalfSpace(Elastic(1e6, 0.5)))
    >>> which_model(rubber, Dugdale(work=0.05, strength=1e8)).model
    'JKR'
    """
    if not isinstance(law, Dugdale):
        raise InvalidInput(
            f"which_model: the law is a {type(law).__name__}; give Dugdale(work, strength): without a range of "
            "attraction there is nothing to choose by."
        )
    if not isinstance(load, Force) or np.ndim(load.force) != 0 or float(load.force) < 0.0:
        raise InvalidInput(f"which_model: the load is {load!r}; give one Force(force), zero or positive.")
    if not 0.0 < tolerance < 1.0:
        raise InvalidInput(f"which_model: tolerance is {tolerance!r}; give a number between 0 and 1, such as 0.02.")
    problems: dict[str, Indentation | AdhesiveIndentation] = {
        "Maugis": AdhesiveIndentation(bed, law, load),
        "JKR": AdhesiveIndentation(bed, ShortRange(law.work), load),
        "DMT": AdhesiveIndentation(bed, DerjaguinMullerToporov(law.work), load),
        "Hertz": Indentation(bed, load),
    }
    models, refused = _models(problems)
    short = PullOff(bed, ShortRange(law.work)).solve()
    stretch = float(griffith.stretch(bed, law.work, np.array([short.radius]))[0])
    tabor = stretch / (PULL_OFF_STRETCH * law.range)
    good = [each.model for each in models if max(abs(each.pull_off_error), abs(each.radius_error)) <= tolerance]
    # the simplest first; Hertz if the load makes adhesion vanish, though it has no pull-off
    plain = next(each for each in models if each.model == "Hertz")
    if float(load.force) > 0.0 and abs(plain.radius_error) <= tolerance:
        name = "Hertz"
    else:
        name = next(each for each in ("JKR", "DMT", "Maugis") if each in good)
    notes = _reasons(name, tabor, stretch, law, load, models, tolerance, refused)
    return Recommendation(problems[name], name, tabor, models, notes)


def _models(problems: dict[str, Indentation | AdhesiveIndentation]) -> tuple[tuple[ModelError, ...], str]:
    """Return the results of the models, Maugis' first, and why there is no DMT, if there is none."""
    models: list[ModelError] = []
    refused = ""
    for name, problem in problems.items():
        try:
            contact = problem.solve()
            pull_off = contact.pull_off.force if isinstance(contact, AdhesiveSolution) else 0.0
        except OutsideValidity as error:
            if name != "DMT":
                raise
            refused = str(error)
            continue
        radius = float(contact.radius)
        best = models[0] if models else ModelError(name, pull_off, radius, 0.0, 0.0)
        models.append(ModelError(name, pull_off, radius, pull_off / best.pull_off - 1.0, radius / best.radius - 1.0))
    return tuple(models), refused


def _reasons(
    name: str,
    tabor: float,
    stretch: float,
    law: Dugdale,
    load: Force,
    models: tuple[ModelError, ...],
    tolerance: float,
    refused: str,
) -> tuple[Note, ...]:
    compared = "; ".join(
        f"{each.model} {each.pull_off:.4g} N ({each.pull_off_error:+.2%})" for each in models if each.model != "Hertz"
    )
    wide = "; ".join(f"{each.model} {each.radius:.4g} m ({each.radius_error:+.2%})" for each in models)
    verdicts = {
        "Hertz": f"Under {float(load.force):.4g} N adhesion changes the contact radius by less than "
        f"{tolerance:.2g} of it. Use Indentation, which has no pull-off.",
        "JKR": f"JKR differs from Maugis by less than {tolerance:.2g}: use ShortRange.",
        "DMT": f"DMT differs from Maugis by less than {tolerance:.2g}: use DerjaguinMullerToporov.",
        "Maugis": f"Both JKR and DMT differ from Maugis by more than {tolerance:.2g}: use Dugdale.",
    }
    region = "JKR (above 5)" if tabor > 5.0 else "DMT (below 0.1)" if tabor < 0.1 else "the transition (0.1 to 5)"
    notes = [
        Note(
            Assumption.ADHESION,
            Standing.EXACT,
            verdicts[name],
            "pull-off and contact radius of all models, computed for this profile",
        ),
        Note(
            Assumption.ADHESION,
            Standing.ASYMPTOTIC,
            f"At pull-off attraction stretches the edge by {stretch:.3g} m; the range of attraction is "
            f"{law.range:.3g} m. Tabor's parameter is {tabor:.3g}, Maugis' parameter "
            f"{MAUGIS_OVER_TABOR * tabor:.3g}: the region of {region}.",
            f"{TABOR}; {GREENWOOD}",
        ),
        Note(Assumption.ADHESION, Standing.EXACT, f"Pull-off under a dead load: {compared}.", EQUATIONS),
        Note(
            Assumption.ADHESION, Standing.EXACT, f"Contact radius under {float(load.force):.4g} N: {wide}.", EQUATIONS
        ),
        Note(
            Assumption.ADHESION,
            Standing.APPROXIMATE,
            "The true law of attraction is not a constant stress. Between the limits other laws of equal work "
            "and strength differ from Maugis by a few per cent.",
            GREENWOOD,
        ),
    ]
    if refused:
        notes.append(Note(Assumption.ADHESION, Standing.EXACT, f"DMT was left out. {refused}", "apex of the profile"))
    return tuple(notes)
