"""How far resistance and temperature of the spots of a height map can be trusted."""

from __future__ import annotations

import numpy as np

from winkler.materials.conducting_body import Plated
from winkler.media.conduction.conductors import ElectricalConductors
from winkler.numerics.types import Quantity
from winkler.problems.conduction.disc import mean_free_path_note
from winkler.problems.conduction.joule_heating import KOHLRAUSCH
from winkler.problems.surface_current.softening import coefficients_of
from winkler.values.validity import Assumption, Note, Standing

HOLM = "R. Holm, Electric Contacts, 4th edition, Springer 1967, doi:10.1007/978-3-662-06688-1"
PIXELS = "pixels of constant flux against discs, whose error falls like the size of the pixels"
GROWTH_SHARE = 2.0 / 3.0
"""Of a contact's resistance, by which it grows for each alpha times the greatest rise of temperature (Holm)."""


def current_notes(
    conductors: ElectricalConductors,
    *,
    rise: float,
    narrowest: float,
    mean_free_path: float,
    spots: tuple[Quantity, Quantity, Quantity],
) -> tuple[Note, ...]:
    """Return what was assumed of the bodies, the film and the temperature.

    Parameters
    ----------
    conductors
        The bodies and the film.
    rise
        Greatest temperature above that of the bodies [K].
    narrowest
        Least radius of spots of mean area [m].
    mean_free_path
        Of the electrons [m].
    spots
        Temperatures of the coldest and the hottest pixel in contact, and that at the mean voltage [K].
    """
    bodies = (conductors.first, conductors.second)
    plated = any(isinstance(body, Plated) for body in bodies)
    film = conductors.film.area_resistance > 0.0
    spread = [max(coefficients_of(body)) - min(coefficients_of(body)) for body in bodies]
    notes = [
        Note(
            Assumption.CONDUCTION,
            Standing.EXACT,
            "Steady conduction between thick bodies through all pixels in contact, which have one voltage"
            + (", their platings bonded without resistance" if plated else "")
            + (", through a film that also spreads the current" if film else "")
            + ".",
            HOLM,
        ),
        Note(
            Assumption.RESOLUTION,
            Standing.APPROXIMATE,
            "The resistance is computed for the pixels in contact. For a round spot n pixels wide it is too high "
            "by a fraction of about 0.5 / n of that of the equal disc.",
            PIXELS,
        ),
        Note(
            Assumption.CONDUCTION,
            Standing.APPROXIMATE if film else Standing.EXACT,
            "Steady state. Temperature follows from voltage for spots of any shape, if all metals obey the "
            "Wiedemann-Franz law with one Lorenz number. The ends have the temperature of the bodies, and no "
            "heat leaves through other surfaces. Thermoelectric effects are neglected."
            + (
                " The contact is assumed to have one temperature, and the heat of the film to be distributed as "
                "the current. This is exact for equal, clean bodies."
                if film
                else ""
            ),
            KOHLRAUSCH,
        ),
    ]
    coldest, hottest, mean = (np.ravel(part) for part in spots)
    if np.any(hottest > coldest):
        worst = int(np.argmax(hottest - coldest))
        notes.append(
            Note(
                Assumption.CONDUCTION,
                Standing.APPROXIMATE,
                f"Between different platings the contact has no single temperature: {coldest[worst]:.5g} to "
                f"{hottest[worst]:.5g} K over its pixels, {mean[worst]:.5g} K at the mean voltage of the current.",
                "own solution: with heat flowing as the current, L (T^2 - T_0^2) is the product of both voltages",
            )
        )
    if max(spread) > 0.0:
        off = 0.5 * GROWTH_SHARE * max(spread) * rise
        notes.append(
            Note(
                Assumption.CONDUCTION,
                Standing.APPROXIMATE,
                "The resistivities of a plating and of its substrate rise differently with temperature; the mean "
                f"of both temperature coefficients is used. The hot resistance may differ by {100.0 * off:.2g} "
                "per cent.",
                HOLM,
                off,
            )
        )
    return (*notes, *mean_free_path_note(np.array([narrowest]), mean_free_path))
