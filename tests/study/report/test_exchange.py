"""Answers in xarray and pandas: the numbers of the answer, with their units, through a file and back."""

from __future__ import annotations

import functools

import numpy as np
import pandas
import pytest
import xarray

import winkler as wk
from winkler.study.batch.run import run
from winkler.study.language.reading import parse_study
from winkler.values.vocabulary import GLOSSARY

BED = wk.Foundation(wk.Paraboloid(10e-3), wk.HalfSpace(wk.Elastic(210e9, 0.3)))
FORCES = np.array([1.0, 10.0, 100.0])
PRESSED = wk.Indentation(BED, wk.Force(FORCES)).solve()
ONE = PRESSED.at(2)
A = ONE.radius
TURNING = wk.Path([0.0, 1.0, 2.0], wk.Force(100.0), wk.Shift(np.array([[0.0, 0.0], [5e-7, 1e-7], [-5e-7, 0.0]])))


@functools.cache
def rubbed():
    """Return a march; it is solved when a test needs it, not while tests are collected."""
    return wk.Tangential(BED, wk.Coulomb(0.3), TURNING).solve()


def test_a_solution_is_a_dataset_with_units():
    data = wk.to_xarray(PRESSED)
    assert dict(data.sizes) == {"load": 3}
    np.testing.assert_array_equal(data.force, FORCES)
    np.testing.assert_array_equal(data.depth, PRESSED.depth)
    for name, content in data.data_vars.items():
        assert content.attrs["units"] == (GLOSSARY[name].unit or "1")
        assert content.attrs["long_name"] == GLOSSARY[name].meaning
    assert "exact: Homogeneous, isotropic, linear elastic half-spaces" in data.attrs["validity"]


def test_the_dataset_says_how_it_is_made_again():
    data = wk.to_xarray(PRESSED)
    again = parse_study(data.attrs["study"]).problem
    assert again == PRESSED.problem
    np.testing.assert_array_equal(again.solve().depth, data.depth)


def test_through_netcdf_and_back(tmp_path):
    for number, answer in enumerate((PRESSED, ONE, rubbed(), wk.restore(ONE, np.linspace(0.0, A, 4)))):
        data = wk.to_xarray(answer)
        data.to_netcdf(tmp_path / f"{number}.nc", engine="h5netcdf")
        with xarray.open_dataset(tmp_path / f"{number}.nc", engine="h5netcdf") as back:
            assert back.load().identical(data)


def test_a_path_in_the_plane_has_two_columns():
    data, table = wk.to_xarray(rubbed()), wk.to_pandas(rubbed())
    for place, axis in enumerate("xy"):
        np.testing.assert_array_equal(data[f"shear_force_{axis}"], rubbed().shear_force[:, place])
        np.testing.assert_array_equal(table[f"shear_force_{axis}"], rubbed().shear_force[:, place])
    assert table.attrs["units"]["shear_force_x"] == "N"
    assert data.shear_force_y.attrs["units"] == "N"


def test_fields_lie_on_their_places():
    r, z = np.linspace(0.0, 2.0 * A, 5), np.array([0.2 * A, 0.5 * A, A])
    field = wk.restore(ONE, r[:, None], z[None, :])
    data = wk.to_xarray(field)
    assert data.von_mises.dims == ("r", "z")
    assert float(data.von_mises.sel(r=0.0, z=0.5 * A)) == field.von_mises[0, 1]
    assert data.principal.dims == ("r", "z", "principal_axis")
    assert float(data.principal.sel(r=0.0, z=A, principal_axis="least")) == field.principal[0, 2, 2]
    turned = wk.to_xarray(wk.restore(ONE, r[None, :], z[:, None]))
    assert turned.von_mises.dims == ("z", "r")
    np.testing.assert_array_equal(turned.von_mises.transpose("r", "z"), data.von_mises)


def test_places_that_follow_each_other_are_coordinates():
    along = np.linspace(0.1, 1.0, 7) * A
    data = wk.to_xarray(wk.restore(ONE, along, along))
    assert data.von_mises.dims == ("place_0",)
    np.testing.assert_array_equal(data.r, along)
    np.testing.assert_array_equal(data.z, along)
    level = wk.to_xarray(wk.restore(ONE, along, 0.5 * A))
    assert level.von_mises.dims == ("r",)
    assert float(level.z) == 0.5 * A


@pytest.mark.slow
def test_fields_of_sheared_and_heated_bodies():
    state = rubbed().states[1]
    surface = wk.restore(state, np.linspace(0.0, A, 4))
    assert wk.to_xarray(surface).traction.dims == ("r", "direction")
    table = wk.to_pandas(surface)
    np.testing.assert_array_equal(table["traction_y"], surface.traction[:, 1])
    body = wk.restore_body(state, np.linspace(-A, A, 3)[:, None], 0.0, np.array([0.5, 1.0])[None, :] * A)
    data = wk.to_xarray(body)
    assert data.xx_stress.dims == ("x", "z")
    assert float(data.y) == 0.0
    rows = wk.to_pandas(body)
    assert len(rows) == 6
    np.testing.assert_array_equal(rows["principal_greatest"], body.principal[..., 0].ravel())


def test_a_table_is_plain_columns():
    table = wk.to_pandas(PRESSED)
    assert isinstance(table, pandas.DataFrame)
    assert list(table.columns) == list(wk.to_xarray(PRESSED).data_vars)
    np.testing.assert_array_equal(table["depth"], PRESSED.depth)
    assert table.attrs["units"] == {name: GLOSSARY[name].unit for name in table.columns}
    assert len(wk.to_pandas(ONE)) == 1


def test_an_outcome_is_its_archive():
    study = parse_study(
        """
        [problem]
        kind = "indentation"
        bed.kind = "foundation"
        bed.profile = { kind = "sphere", curvature_radius = "10 mm" }
        bed.medium = { kind = "half_space", first = { kind = "named_elastic", name = "sapphire" } }
        load = { kind = "force", force = "1 N" }
        [sweep]
        "problem.load.force" = ["1 N", "2 N", "5 N"]
        "problem.bed.medium.first.name" = ["sapphire", "tungsten"]
        """
    )
    outcome = run(study)
    data, table = wk.to_xarray(outcome), wk.to_pandas(outcome)
    assert data.depth.shape == (3, 2)
    stiff = wk.Foundation(wk.Sphere(10e-3), wk.HalfSpace(wk.material("tungsten").elastic))
    assert float(data.depth[2, 1]) == wk.Indentation(stiff, wk.Force(5.0)).solve().depth
    assert len(table) == 6
    np.testing.assert_array_equal(table["depth"], np.ravel(data.depth))
    assert table.attrs["units"]["problem.load.force"] == "N"


@pytest.mark.parametrize(
    "given", [3.0, None, "sphere", wk.Sphere, wk.Sphere(1.0), BED, wk.Indentation(BED, wk.Force(1.0))]
)
def test_what_is_no_answer_is_stated(given):
    for verb in (wk.to_xarray, wk.to_pandas):
        with pytest.raises(wk.InvalidInput, match="give what solve"):
            verb(given)
