"""What the predictions of a fit may share, by its model and by what is free."""

from __future__ import annotations

from winkler.fitting.elastic.film_tables import FilmTables
from winkler.fitting.elastic.model_tables import EACH_ANEW, HomogeneousTables, ModelTables
from winkler.fitting.validity import Model
from winkler.fitting.varied import CURVE_PARAMETERS, Parameter
from winkler.foundation.foundation import Foundation
from winkler.media.halfspace import HomogeneousMedium
from winkler.media.offers import LayerStack, offers
from winkler.problems.normal.indentation import Indentation

__all__ = ["tables_for"]


def tables_for(model: Model, parameters: tuple[Parameter, ...]) -> ModelTables:
    """Return the tables that the predictions of a fit share.

    Parameters
    ----------
    model : Indentation or AdhesiveIndentation
    parameters : tuple of Parameter
    """
    own = [p for p in parameters if p.name not in CURVE_PARAMETERS]
    of_medium = all(p.name.startswith("bed.medium.") for p in own)
    if not isinstance(model, Indentation) or type(model.bed) is not Foundation or not of_medium:
        return EACH_ANEW
    medium, profile = model.bed.medium, model.bed.profile
    if isinstance(medium, HomogeneousMedium):
        return HomogeneousTables(model.bed)
    film = offers(medium, LayerStack)
    if film and len(own) == 1 and own[0].name.endswith(".young") and not profile.kinks:
        return FilmTables(model, own[0].name)
    return EACH_ANEW
