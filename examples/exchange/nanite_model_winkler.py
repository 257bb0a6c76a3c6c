"""
All models for nanite, as one package
=====================================

``pip install examples/exchange`` installs the three model files of this folder beside nanite, and this module, which
registers them. nanite looks for no plug-ins by itself, so a script says it once::

    import nanite_model_winkler

    nanite_model_winkler.register("my_tip.csv")

Without a table the model of a measured tip is left out. PyJibe takes the files one by one.
"""

from pathlib import Path

import nanite_model_film
import nanite_model_jkr
import nanite_model_measured_tip


def register(tip=None):
    """Register the models with nanite, and return them by their keys

    Parameters
    ----------
    tip: str or path, optional
        Table of the profile of a tip, for the model ``winkler_measured_tip``

    Returns
    -------
    models: dict
        The models of nanite, by their keys

    Raises
    ------
    winkler.InvalidInput
        If the table cannot be read; then nothing is registered
    """
    from nanite.model import register_model

    modules = [nanite_model_film, nanite_model_jkr]
    if tip is not None:
        table = Path(tip).resolve()
        nanite_model_measured_tip.force_of_unit_modulus(table)  # a table that cannot be read is refused here
        nanite_model_measured_tip.TIP = table
        modules.append(nanite_model_measured_tip)
    return {module.model_key: register_model(module) for module in modules}
