"""The table of bad input: every constructor, every field, every kind of nonsense, one sentence each."""

from __future__ import annotations

import math

import pytest

import winkler as wk

SOUND = {
    wk.Paraboloid: {"curvature_radius": 1.0},
    wk.PowerLaw: {"coefficient": 1.0, "exponent": 2.0},
    wk.Sphere: {"curvature_radius": 1.0},
    wk.Ellipsoid: {"radial_semi_axis": 1.0, "axial_semi_axis": 2.0},
    wk.Hyperboloid: {"curvature_radius": 1.0, "half_angle": 1.0},
    wk.Cone: {"half_angle": 1.0},
    wk.TruncatedCone: {"half_angle": 1.0, "flat_radius": 1.0},
    wk.RoundedCone: {"curvature_radius": 1.0, "half_angle": 1.0},
    wk.SpheroConical: {"curvature_radius": 1.0, "half_angle": 1.0},
    wk.FlatPunch: {"radius": 1.0},
    wk.RoundedPunch: {"flat_radius": 1.0, "edge_radius": 2.0},
    wk.TruncatedParaboloid: {"curvature_radius": 1.0, "flat_radius": 1.0},
    wk.CappedParaboloid: {"curvature_radius": 1.0, "cap_curvature_radius": 2.0, "cap_radius": 0.1},
    wk.Wavy: {"amplitude": 1.0, "wavelength": 1.0},
}
NONSENSE = [0.0, -1.0, math.nan, math.inf, -math.inf, "1", "1 mm", None, True, False, [1.0], 1.0 + 0.0j]


@pytest.mark.parametrize("cls", SOUND)
def test_every_field_of_every_shape(cls):
    cls(**SOUND[cls])
    for word in SOUND[cls]:
        for bad in NONSENSE:
            with pytest.raises(wk.InvalidInput) as caught:
                cls(**SOUND[cls] | {word: bad})
            text = str(caught.value)
            assert text.startswith(f"{cls.__name__}: {word} is ")
            assert text.endswith(".")
            assert text.count("\n") == 0
            assert "must" in text


@pytest.mark.parametrize("cls", SOUND)
def test_integers_are_numbers(cls):
    numbers = dict.fromkeys(SOUND[cls], 1)
    assert cls(**numbers) == cls(**{word: float(v) for word, v in numbers.items()})


@pytest.mark.parametrize("cls", SOUND)
def test_misspelt_fields(cls):
    with pytest.raises(TypeError):
        cls(**SOUND[cls] | {"colour": 1.0})
    with pytest.raises(TypeError):
        cls()
