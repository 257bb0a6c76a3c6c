"""Pictures of worn height maps and of their electric contacts hold what they say."""

from __future__ import annotations

import numpy as np

import winkler as wk
from winkler.plot import draw, sheet_of

X = np.arange(16) / 16
WAVE = wk.Topography(1e-6 * np.cos(2.0 * np.pi * X[:, None]) * np.cos(2.0 * np.pi * X), [1e-4, 1e-4], periodic=True)
STEEL = wk.HalfSpace(wk.Elastic(210e9, 0.3))


def test_the_sheet_of_a_worn_map():
    contact = wk.SurfaceContact(WAVE, STEEL, wk.Force(0.5))
    found = wk.SurfaceWear(contact, wk.Archard(1e-14), [0.0, 0.01, 0.1], tolerance=1e-2).solve()
    sheet = sheet_of(found)
    assert [panel.title for panel in sheet.panels] == [
        "cut through the most worn pixel", "worn off after 100 mm", "pressure after 0 m", "pressure after 100 mm",
        "pressures", "root mean square height", "skewness", "contact", "worn volume",
    ]  # fmt: skip
    peak = sheet.panels[4].marks[0]
    assert np.array_equal(peak.y, found.peak_pressure)
    assert len(draw(found).axes) >= 9
    single = wk.SurfaceWear(contact, wk.Archard(1e-14), [0.01], tolerance=1e-2).solve()
    assert len(sheet_of(single).panels) == 3


def test_the_sheet_of_an_electric_contact():
    gold = wk.ElectricalConductor(22e-9)
    pair = wk.ElectricalConductors(gold, gold, wk.SurfaceFilm(1e-13))
    contact = wk.SurfaceContact(WAVE, STEEL, wk.Force([0.1, 0.5]), hardness=2e9)
    found = wk.SurfaceConstriction(contact, pair, wk.Current(5.0), softening_temperature=373.0).solve()
    sheet = sheet_of(found)
    assert [panel.title for panel in sheet.panels] == [
        "pressure in the spots", "resistance and its parts", "spots of contact", "greatest rise of temperature",
        "current at which the metal",
    ]  # fmt: skip
    drawn = [line.name for line in sheet.panels[1].marks]
    assert drawn == ["all", "constrictions", "film", "constrictions without platings"]
    assert len(draw(found).axes) >= 5
    contact = wk.SurfaceContact(WAVE, STEEL, wk.Force(0.5))
    still = wk.SurfaceConstriction(contact, pair, wk.Voltage(0.0)).solve()
    assert [panel.title for panel in sheet_of(still).panels] == ["pressure in the spots", "parts of the resistance"]
