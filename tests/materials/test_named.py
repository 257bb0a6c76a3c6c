"""The table of materials: complete, sourced, and within physics."""

from __future__ import annotations

import pickle

import pytest

import winkler as wk
from winkler.materials.named import NamedElastic
from winkler.vocabulary import GLOSSARY

NAMES = wk.material_names()
RANGES = {
    "young": (1e5, 1.3e12), "poisson": (0.0, 0.5), "hardness": (1e6, 1.5e11), "strength": (1e6, 1e10),
    "density": (800.0, 23000.0), "heat_capacity": (100.0, 4200.0), "conductivity": (0.1, 2500.0),
    "resistivity": (1e-8, 1e-5), "temperature_coefficient": (0.0, 0.01),
}  # fmt: skip
"""Diamond and osmium are the ends."""


@pytest.mark.parametrize("name", NAMES)
def test_every_number_has_a_word_a_source_and_a_sane_size(name):
    found = wk.material(name)
    quantities = [figure.quantity for figure in found.figures]
    assert {"young", "poisson"} <= set(quantities)
    assert len(set(quantities)) == len(quantities)
    for figure in found.figures:
        least, greatest = RANGES[figure.quantity]
        assert least <= figure.number <= greatest
        assert GLOSSARY[figure.quantity].unit is not None
        assert len(figure.source) > 8
    assert found.elastic.young == found.number("young")


LORENZ = {
    "silver": 2.31e-8, "gold": 2.35e-8, "copper": 2.23e-8, "platinum": 2.51e-8, "tungsten": 3.04e-8,
    "iron": 2.61e-8, "aluminium": 2.14e-8,
}  # fmt: skip
"""Measured at 0 degrees Celsius [V^2/K^2]: the first five after C. Kittel, Introduction to Solid State Physics, 8th
ed., Wiley 2005, chapter 6, the others after N. W. Ashcroft, N. D. Mermin, Solid State Physics, Saunders 1976."""


@pytest.mark.parametrize(("name", "lorenz"), LORENZ.items())
def test_heat_and_current_of_pure_metals_are_in_the_measured_proportion(name, lorenz):
    """Conductivity and resistivity come from tables of different origin; the proportion changes little up to 20 C."""
    metal = wk.material(name)
    assert metal.number("conductivity") * metal.number("resistivity") / 293.0 == pytest.approx(lorenz, rel=0.06)


def test_silicon_is_hills_mean_of_its_crystal():
    c11, c12, c44 = 165.7e9, 63.9e9, 79.6e9
    bulk = (c11 + 2.0 * c12) / 3.0
    voigt = (c11 - c12 + 3.0 * c44) / 5.0
    reuss = 5.0 * (c11 - c12) * c44 / (4.0 * c44 + 3.0 * (c11 - c12))
    shear = 0.5 * (voigt + reuss)
    young = 9.0 * bulk * shear / (3.0 * bulk + shear)
    silicon = wk.material("silicon")
    assert silicon.number("young") == pytest.approx(young, rel=1e-3)
    assert silicon.number("poisson") == pytest.approx(young / (2.0 * shear) - 1.0, abs=1e-3)


def test_other_names_and_capitals():
    assert wk.material("Fused Quartz") == wk.material("fused silica")
    assert wk.material("AL").name == "aluminium"
    assert wk.material(" 100CR6 ").name == "bearing steel"


@pytest.mark.parametrize("given", ["stel", "", "unobtainium", 3.0, None, b"steel"])
def test_an_unknown_name_lists_the_known_ones(given):
    with pytest.raises(wk.InvalidInput, match="is not in the table.*it has aluminium, copper"):
        wk.material(given)


def test_a_number_that_no_table_says():
    with pytest.raises(wk.InvalidInput, match="PDMS: no conductivity is in the table, which has young, poisson"):
        wk.NamedThermalConductor("PDMS")
    with pytest.raises(wk.InvalidInput, match="no resistivity"):
        wk.material("sapphire").electrical_conductor  # noqa: B018


def test_a_named_solid_is_a_solid():
    named, plain = NamedElastic("tungsten"), wk.material("tungsten").elastic
    assert isinstance(named, wk.Elastic)
    assert (named.young, named.poisson, named.shear) == (plain.young, plain.poisson, plain.shear)
    assert named == NamedElastic("tungsten") == pickle.loads(pickle.dumps(named))
    assert named != plain
    assert wk.NamedThermalConductor("copper").diffusivity == wk.material("copper").thermal_conductor.diffusivity
    bed = wk.Foundation(wk.Sphere(1e-3), wk.HalfSpace(named))
    same = wk.Foundation(wk.Sphere(1e-3), wk.HalfSpace(plain))
    assert wk.Indentation(bed, wk.Force(1.0)).solve().depth == wk.Indentation(same, wk.Force(1.0)).solve().depth


def test_the_command_line_shows_the_table(capsys):
    from winkler.cli import main

    assert main(["show", "materials"]) == 0
    shown = capsys.readouterr().out
    assert all(name in shown for name in NAMES)
    assert main(["show", "copper"]) == 0
    shown = capsys.readouterr().out
    assert "J. Phys. Chem. Ref. Data" in shown
    assert 'kind = "named_elastic", name = "copper"' in shown
