"""Whether the bodies can be as hot as they come out, and whether their properties stay as they are."""

from __future__ import annotations

from winkler.values.validity import Assumption, Note, Standing, standing_of

MODERATE_RISE = 200.0
"""Rise of temperature [K] up to which conductivity, strength and friction of metals change by some ten per cent."""
HIGHEST_MELTING_POINT = 4400.0
"""Temperature [K] above which no solid is known; the highest melting point predicted is that of Hf-C-N."""
VERDICTS = {
    Standing.ASYMPTOTIC: "moderate",
    Standing.APPROXIMATE: "give the properties at that temperature, and see that neither body softens or melts",
    Standing.OUTSIDE: "no solid is known that hot: the bodies soften and melt long before",
}
IN_CONTACT = "Thermal expansion does not act back on the pressure; friction and properties"
PROPERTIES = (
    "J. F. Archard, Wear 2 (1959) 438-455, doi:10.1016/0043-1648(59)90159-0; Q.-J. Hong, A. van de Walle, Phys. Rev. B "
    "92 (2015) 020104, doi:10.1103/PhysRevB.92.020104"
)


def temperature_note(rise: float, constant: str = IN_CONTACT) -> Note:
    """Return what the greatest rise of temperature [K] means for what is taken as `constant`, in words."""
    fact = f"The greatest rise of temperature is {rise:.4g} K"
    standing = standing_of(rise, MODERATE_RISE, HIGHEST_MELTING_POINT)
    return Note(
        Assumption.TEMPERATURE,
        standing,
        f"{fact}: {VERDICTS[standing]}. {constant} do not change with temperature.",
        PROPERTIES,
    )
