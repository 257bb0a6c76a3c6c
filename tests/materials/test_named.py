"""The table of materials: complete, sourced, and within physics."""

from __future__ import annotations

import math
import pickle

import numpy as np
import pytest

import winkler as wk
from winkler.materials.named import NamedElastic
from winkler.values.vocabulary import GLOSSARY

NAMES = wk.material_names()
RANGES = {
    "young": (5e2, 1.3e12), "poisson": (0.0, 0.5), "hardness": (1e6, 1.5e11), "strength": (1e6, 1e10),
    "density": (800.0, 23000.0), "heat_capacity": (100.0, 4200.0), "conductivity": (0.1, 2500.0),
    "resistivity": (1e-8, 1e-5), "temperature_coefficient": (0.0, 0.01),
}  # fmt: skip
"""Soft gels, diamond and osmium are the ends."""


@pytest.mark.parametrize("name", NAMES)
def test_every_number_has_a_word_a_source_and_a_sane_size(name):
    found = wk.material(name)
    quantities = [figure.quantity for figure in found.figures]
    assert "young" in quantities
    assert len(set(quantities)) == len(quantities)
    for figure in found.figures:
        least, greatest = RANGES[figure.quantity]
        assert least <= figure.number <= greatest
        assert GLOSSARY[figure.quantity].unit is not None
        assert len(figure.source) > 8
        if figure.spread:
            assert figure.spread[0] <= figure.number <= figure.spread[1]
            assert figure.spread[0] < figure.spread[1]
    if "poisson" in quantities:
        assert found.elastic.young == found.number("young")
    else:
        assert "that a table states" in found.sort
        with pytest.raises(wk.InvalidInput, match="no poisson is in the table"):
            found.elastic  # noqa: B018


@pytest.mark.parametrize(
    "name", ["aluminium alloy", "titanium alloy", "brass", "bronze", "alloy steel", "stainless steel"]
)
def test_heat_and_current_of_alloys_come_from_the_same_electrons(name):
    """These conduct L T / rho, L = pi^2/3 (k/e)^2 = 2.443e-8 V^2/K^2; the lattice adds up to a dozen W/(m K)."""
    alloy = wk.material(name)
    electrons = 2.443e-8 * 293.0 / alloy.number("resistivity")
    lattice = alloy.number("conductivity") - electrons
    assert -0.08 * electrons < lattice < 12.0


HELD = [("A 50", 2.2), ("A 65", 830.0 * 6.894757e-3), ("A 75", 1340.0 * 6.894757e-3)]
"""Natural rubber by its hardness [MPa]; the last two [lbf/in^2] after a table of *Designing with rubber*."""


@pytest.mark.parametrize(("hardness", "young"), HELD)
def test_measured_moduli_of_natural_rubber_lie_in_the_range_of_their_hardness(hardness, young):
    least, greatest = wk.material(f"Shore {hardness}").figures[0].spread
    assert 1e-6 * least < young < 1e-6 * greatest


def test_rubbers_by_their_shore_hardness():
    """ASTM D2240's chart has 80 of scale A beside 29 or 30 of scale D."""
    soft, hard = wk.material("Shore A 80"), wk.material("rubber shore d 30")
    assert soft.number("young") == pytest.approx(hard.number("young"), rel=1e-12)
    (young, poisson) = wk.material("Shore A50").figures
    assert young.number == pytest.approx(10.0**0.5347 * 1e6)
    assert young.spread[1] == pytest.approx(10.0 ** (0.5347 + 5.0 * 0.0235) * 1e6)
    assert poisson.number == poisson.spread[1] == 0.5
    assert wk.NamedElastic("Shore A 60").young == wk.material("Shore A 60").number("young")
    moduli = [wk.material(f"Shore A {hardness}").number("young") for hardness in range(20, 81)]
    assert all(one < other for one, other in zip(moduli, moduli[1:], strict=False))


@pytest.mark.parametrize("hardness", [45.0, 60.0, 80.0])
def test_the_least_modulus_of_scale_a_is_what_a_punch_as_wide_as_its_cone_would_measure(hardness):
    """ASTM D2240: a cone from 0.79 to 1.27 mm, 2.54 mm deep at 0, whose spring bears 56 g and 7.62 g a point."""
    young, measured = wk.material(f"Shore A {hardness}").figures[0].spread[0], hardness - 5.0
    bed = wk.Foundation(wk.FlatPunch(0.25e-3 * (0.79 + 1.27)), wk.HalfSpace(wk.Elastic(young, 0.5)))
    pressed = wk.Indentation(bed, wk.Depth(2.54e-3 * (1.0 - measured / 100.0))).solve()
    assert pressed.force == pytest.approx(9.81e-3 * (56.0 + 7.62 * measured), rel=3e-3)


@pytest.mark.parametrize("hardness", [30.0, 50.0, 85.0])
def test_the_greatest_modulus_of_scale_d_is_what_its_cone_and_spring_would_measure(hardness):
    """ASTM D2240: a cone of 30 degrees goes 2.5 mm deep at 0, and its spring bears 44.45 N at 100."""
    young, measured = wk.material(f"Shore D {hardness}").figures[0].spread[1], hardness + 5.0
    bed = wk.Foundation(wk.Cone(math.radians(15.0)), wk.HalfSpace(wk.Elastic(young, 0.5)))
    pressed = wk.Indentation(bed, wk.Depth(2.5e-3 * (1.0 - measured / 100.0))).solve()
    assert pressed.force == pytest.approx(44.45 * measured / 100.0, rel=1e-9)


@pytest.mark.parametrize("name", ["Shore A 19", "Shore A 81", "Shore D 29.9", "shore d 90"])
def test_a_hardness_out_of_range(name):
    with pytest.raises(wk.InvalidInput, match="out of the range of"):
        wk.material(name)


def test_a_word_lists_its_materials(capsys):
    from winkler.cli import main
    from winkler.materials.named import materials_called

    assert {"bearing steel", "stainless steel", "carbon steel", "alloy steel", "tool steel"} == set(
        materials_called("Steel")
    )
    assert materials_called("") == materials_called("steels") == ()
    assert main(["show", "steel"]) == 0
    shown = capsys.readouterr().out
    assert all(name in shown for name in materials_called("steel"))
    for word, name in (("Stahl", "tool steel"), ("acier", "tool steel"), ("Messing", "brass"), ("glass", "soda-lime")):
        assert main(["show", word]) == 0
        assert name in capsys.readouterr().out
    assert main(["show", "Shore", "A", "70"]) == 0
    assert "Gent" in capsys.readouterr().out
    assert main(["show", "Shore", "A", "95"]) == 2
    assert "20 to 80" in capsys.readouterr().err
    assert main(["show", "PEEK"]) == 0
    assert "Poisson ratio of your own" in capsys.readouterr().out


LORENZ = {
    "silver": 2.31e-8, "gold": 2.35e-8, "copper": 2.23e-8, "platinum": 2.51e-8, "tungsten": 3.04e-8,
    "tin": 2.52e-8, "iron": 2.61e-8, "aluminium": 2.14e-8,
}  # fmt: skip
"""Measured at 0 degrees Celsius [V^2/K^2]: the first six after C. Kittel, Introduction to Solid State Physics, 8th
ed., Wiley 2005, chapter 6, the others after N. W. Ashcroft, N. D. Mermin, Solid State Physics, Saunders 1976."""


@pytest.mark.parametrize(("name", "lorenz"), LORENZ.items())
def test_heat_and_current_of_pure_metals_are_in_the_measured_proportion(name, lorenz):
    """Conductivity and resistivity come from tables of different origin; the proportion changes little up to 20 C."""
    metal = wk.material(name)
    assert metal.number("conductivity") * metal.number("resistivity") / 293.0 == pytest.approx(lorenz, rel=0.06)


def test_silicon_is_hills_mean_of_its_crystal():
    c11, c12, c44 = 165.7e9, 63.9e9, 79.6e9
    voigt = (c11 - c12 + 3.0 * c44) / 5.0
    reuss = 5.0 * (c11 - c12) * c44 / (4.0 * c44 + 3.0 * (c11 - c12))
    is_of_moduli("silicon", (c11 + 2.0 * c12) / 3.0, 0.5 * (voigt + reuss))


def test_diamond_is_the_self_consistent_mean_of_its_crystal():
    """Of Hershey and Kroener, with the constants of M. H. Grimsditch, A. K. Ramdas, Phys. Rev. B 11 (1975) 3139."""
    c11, c12, c44 = 1076.4e9, 125.2e9, 577.4e9
    bulk, other = (c11 + 2.0 * c12) / 3.0, 0.5 * (c11 - c12)
    roots = np.roots([8.0, 9.0 * bulk + 4.0 * other, -3.0 * c44 * (bulk + 4.0 * other), -6.0 * bulk * c44 * other])
    (shear,) = roots[roots > 0.0]
    is_of_moduli("diamond", bulk, shear)


CRYSTALS = {
    "aluminium": (106.75e9, 60.41e9, 28.34e9), "nickel": (248.1e9, 154.9e9, 124.2e9),
    "silver": (124.0e9, 93.4e9, 46.1e9), "tungsten": (522.39e9, 204.37e9, 160.83e9),
}  # fmt: skip
"""c11, c12 and c44 after G. Simmons, H. Wang, Single Crystal Elastic Constants, MIT Press 1971."""


@pytest.mark.parametrize(("name", "constants"), CRYSTALS.items())
def test_moduli_of_metals_lie_between_the_bounds_of_their_crystals(name, constants):
    """Of Reuss and Voigt, without texture; one per cent beside them is the scatter of the constants."""
    c11, c12, c44 = constants
    bulk, voigt = (c11 + 2.0 * c12) / 3.0, (c11 - c12 + 3.0 * c44) / 5.0
    reuss = 5.0 * (c11 - c12) * c44 / (4.0 * c44 + 3.0 * (c11 - c12))
    least, greatest = (9.0 * bulk * shear / (3.0 * bulk + shear) for shear in (reuss, voigt))
    metal = wk.material(name)
    assert 0.99 * least < metal.number("young") < 1.01 * greatest
    lateral = [0.5 - young / (6.0 * bulk) for young in (greatest, least)]
    assert lateral[0] - 0.005 < metal.number("poisson") < lateral[1] + 0.005


@pytest.mark.parametrize(
    ("name", "c11", "c12", "c44"), [("silicon", 165.7, 63.9, 79.6), ("diamond", 1076.4, 125.2, 577.4)]
)
def test_the_range_of_poissons_ratios_of_a_crystal_is_that_over_pairs_of_directions(name, c11, c12, c44):
    """Sought by brute force: s' = s12 + s (sum a^2 b^2), s11 - s (1 - sum a^4) for a pulled, b across."""
    spare = (c11 - c12) * (c11 + 2.0 * c12)
    s11, s12 = (c11 + c12) / spare, -c12 / spare
    s = s11 - s12 - 0.5 / c44
    draws = np.random.default_rng(5).normal(size=(2, 100_000, 3))
    pulled = draws[0] / np.linalg.norm(draws[0], axis=1)[:, None]
    across = np.cross(pulled, draws[1])
    across /= np.linalg.norm(across, axis=1)[:, None]
    ratios = -(s12 + s * np.sum(pulled**2 * across**2, axis=1)) / (s11 - s * (1.0 - np.sum(pulled**4, axis=1)))
    (spread,) = [figure.spread for figure in wk.material(name).figures if figure.quantity == "poisson"]
    assert (ratios.min(), ratios.max()) == pytest.approx(spread, abs=2e-3)


TABLED = {
    "aluminium": 97.1, "copper": 117.0, "gold": 127.0, "iron": 23.1, "nickel": 23.0, "platinum": 25.1,
    "silicon": 89.2, "silver": 174.0, "tin": 40.1, "titanium": 9.32, "tungsten": 68.3,
}  # fmt: skip
"""Diffusivities at 300 K [mm^2/s] after F. P. Incropera and D. P. DeWitt, Introduction to Heat Transfer, table A.1."""


@pytest.mark.parametrize(("name", "diffusivity"), TABLED.items())
def test_conductivity_density_and_heat_capacity_make_the_tabulated_diffusivity(name, diffusivity):
    assert wk.material(name).thermal_conductor.diffusivity == pytest.approx(1e-6 * diffusivity, rel=0.015)


STRONG = [name for name in NAMES if {"strength", "hardness"} <= {each.quantity for each in wk.material(name).figures}]


@pytest.mark.parametrize("name", STRONG)
def test_metals_are_about_three_times_as_hard_as_strong(name):
    """Tabor: three times the stress after 8 per cent of plastic strain; soft metals have hardened by then."""
    metal = wk.material(name)
    most = 4.0 if name in ("bearing steel", "tool steel") else 6.0
    assert 2.8 < metal.number("hardness") / metal.number("strength") < most


FOREIGN = {
    "Stahl": "tool steel", "acier": "bearing steel", "Wälzlagerstahl": "bearing steel", "acier inoxydable": "stainless",
    "Messing": "brass", "laiton": "brass", "Gummi": "natural rubber", "caoutchouc": "natural rubber",
    "verre": "soda-lime glass", "Glas": "soda-lime glass", "Kupfer": "copper", "étain": "white tin",
    "Grauguss": "grey cast", "fonte": "ductile", "Hartmetall": "tungsten carbide",
    "nitrure de silicium": "silicon nitride",
    "Quarzglas": "silica", "Silizium": "silicon", "Saphir": "sapphire", "Keramik": "zirconia",
    "Polystyrol": "polystyrene", "Rubin": "sapphire", "Titanlegierung": "titanium alloy", "Kunststoff": "POM",
}  # fmt: skip


@pytest.mark.parametrize(("word", "name"), FOREIGN.items())
def test_german_and_french_names(word, name, capsys):
    from winkler.cli import main

    assert main(["show", word]) == 0
    assert name in " ".join(capsys.readouterr().out.split())


def is_of_moduli(name, bulk, shear):
    young = 9.0 * bulk * shear / (3.0 * bulk + shear)
    crystal = wk.material(name)
    assert crystal.number("young") == pytest.approx(young, rel=1e-3)
    assert crystal.number("poisson") == pytest.approx(young / (2.0 * shear) - 1.0, abs=1e-3)


def test_diamond_is_softest_along_the_cube_axes_and_stiffest_along_the_diagonals():
    c11, c12, c44 = 1076.4e9, 125.2e9, 577.4e9
    axis = (c11 - c12) * (c11 + 2.0 * c12) / (c11 + c12)
    s11, s12, s44 = 1.0 / axis, -c12 / ((c11 - c12) * (c11 + 2.0 * c12)), 1.0 / c44
    diagonal = 1.0 / (s11 - 2.0 / 3.0 * (s11 - s12 - 0.5 * s44))
    (least, greatest) = wk.material("diamond").figures[0].spread
    assert (least, greatest) == pytest.approx((axis, diagonal), rel=0.02)


def test_tin_and_titanium_nitride_are_told_apart_by_their_capitals():
    assert wk.material("tin").name == wk.material("Tin").name == wk.material("Sn").name == "tin"
    assert wk.material("TiN").name == wk.material("titanium Nitride").name == "titanium nitride"
    with pytest.raises(wk.InvalidInput, match="'TIN' may be tin or titanium nitride; write one of these"):
        wk.material("TIN")
    assert wk.NamedElastic("TiN").young > 4.0 * wk.NamedElastic("tin").young


def test_gels_are_as_soft_as_their_sources_measured():
    """Shear moduli 260 to 4530 Pa; 277 kPa for 2 parts of water, 4.34 kPa for 20, and a power law between."""
    gel = wk.material("polyacrylamide gel")
    young, poisson = gel.number("young"), gel.number("poisson")
    assert young / (2.0 * (1.0 + poisson)) == pytest.approx(2900.0, rel=0.01)
    assert gel.figures[0].spread == pytest.approx((2.96 * 260.0, 2.96 * 4530.0), rel=0.01)
    power = math.log(277.0 / 4.34) / math.log(20.0 / 2.0)
    assert wk.material("gelatin").number("young") == pytest.approx(277e3 * (10.0 / 2.0) ** -power, rel=0.02)


def test_other_names_and_capitals():
    assert wk.material("Fused Quartz") == wk.material("fused silica")
    assert wk.material("AL").name == "aluminium"
    assert wk.material(" 100CR6 ").name == "bearing steel"


def test_a_word_of_several_names_is_none_of_them():
    with pytest.raises(
        wk.InvalidInput, match=r"'glass' may be fused silica, borosilicate glass or soda-lime glass; write"
    ):
        wk.material("glass")
    with pytest.raises(wk.InvalidInput, match=r"'soda' is not in the table .did you mean 'soda-lime glass'"):
        wk.material("soda")


def test_hardened_bearing_steel_conducts_less_than_half_of_what_annealed_steel_does():
    """Measured at 21 W/(m K) by Reddyhoff, Schmidt and Spikes; tables state the 46 W/(m K) of annealed steel."""
    steel = wk.material("100Cr6")
    (conductivity,) = [figure for figure in steel.figures if figure.quantity == "conductivity"]
    assert conductivity.number < 0.5 * conductivity.spread[1]
    assert steel.thermal_conductor.conductivity == conductivity.number


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


UNKNOWN = {("DLC", "poisson"), ("tin", "temperature_coefficient"), ("gelatin gel", "poisson")}
"""Numbers for whose range no source was found."""


@pytest.mark.parametrize("name", ["silver", "gelatin", "DLC"])
def test_where_no_source_states_a_range_the_table_says_so(name, capsys):
    from winkler.cli import main

    figures = wk.material(name).figures
    assert main(["show", name]) == 0
    assert capsys.readouterr().out.count("not stated") == sum(figure.spread is None for figure in figures)
    everywhere = [(each, figure) for each in NAMES for figure in wk.material(each).figures]
    assert {(each, figure.quantity) for each, figure in everywhere if figure.spread is None} == UNKNOWN
