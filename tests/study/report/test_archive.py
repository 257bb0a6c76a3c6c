"""What is archived comes back: every number to the last digit, with its unit, its meaning, and where it is from."""

from __future__ import annotations

import csv
import functools
import math

import h5netcdf
import numpy as np
import pytest
from study_samples import SAMPLES, pressed

import winkler as wk
from winkler.io.software import software
from winkler.study.batch.run import run
from winkler.study.language.reading import parse_study
from winkler.study.language.study import Study
from winkler.study.language.varied import Axis
from winkler.study.report import archive, archive_maps
from winkler.study.report.writing import write_files
from winkler.values.vocabulary import GLOSSARY, Word

xarray = pytest.importorskip("xarray")


@pytest.fixture(scope="module")
def outcomes():
    return {name: run(study) for name, study in SAMPLES.items()}


@pytest.fixture(scope="module")
def folder(outcomes, tmp_path_factory):
    """Return the folder of the archive of a sample, which is written once."""

    @functools.cache
    def written(name):
        path = tmp_path_factory.mktemp("archive")
        write_files(archive.archive_files(outcomes[name]), path)
        return path

    return written


@pytest.fixture(scope="module")
def reopened(folder):
    @functools.cache
    def reopen(name):
        with xarray.open_dataset(folder(name) / archive.NETCDF, engine="h5netcdf") as data:
            return data.load()

    return reopen


def test_solutions_with_maps_are_named_as_their_classes():
    for name in archive_maps.SOLUTIONS_WITH_MAPS:
        assert getattr(wk, name).__name__ == name


def rows(path):
    with path.open(encoding="utf-8", newline="") as file:
        return list(csv.reader(file))


@pytest.mark.few(8)
@pytest.mark.parametrize("name", SAMPLES)
def test_every_answer_comes_back(name, outcomes, reopened):
    outcome, data = outcomes[name], reopened(name)
    assert outcome.answers
    for answer in outcome.answers:
        expected = outcome.answer(answer)
        np.testing.assert_array_equal(data[answer].values, expected if expected.shape[-1] > 1 else expected[..., 0])


@pytest.mark.few(3, slow=2)
@pytest.mark.parametrize("name", SAMPLES)
def test_the_file_is_the_one_that_xarray_writes(name, outcomes, reopened, folder, tmp_path):
    """An independent writer of the same dataset: values, types, dimensions, coordinates and attributes."""
    other = tmp_path / "other.nc"
    made = archive.dataset(outcomes[name])
    bare = {axis: {"_FillValue": None} for axis in made.coords if made[axis].dims == (axis,)}
    made.to_netcdf(other, engine="h5netcdf", encoding=bare)
    with xarray.open_dataset(other, engine="h5netcdf") as data:
        assert reopened(name).identical(data.load())
    with h5netcdf.File(folder(name) / archive.NETCDF) as one, h5netcdf.File(other) as two:
        text, wanted = (
            {key: str(sorted(item.attrs.items())) for key, item in file.variables.items()} for file in (one, two)
        )
        assert text == wanted


@pytest.mark.parametrize("name", SAMPLES)
def test_every_variable_has_a_unit_and_a_meaning(name, reopened):
    data = reopened(name)
    for key, variable in data.variables.items():
        if key not in ("load", "point"):
            assert variable.attrs["long_name"], key
            assert "units" in variable.attrs or variable.dtype.kind in "OU", key
    assert data["depth"].attrs == {
        "units": "m",
        "long_name": GLOSSARY["depth"].meaning,
        "symbol": "d",
    }


@pytest.mark.parametrize("name", SAMPLES)
def test_provenance_and_the_study_itself_come_back(name, outcomes, reopened):
    outcome, attributes = outcomes[name], reopened(name).attrs
    assert attributes["title"] == outcome.study.title
    assert attributes["study_hash"] == outcome.provenance.hash
    assert len(attributes["study_hash"]) == 64
    assert attributes["winkler_version"] == wk.__version__
    assert attributes["winkler_sources"] == software()["sources"]
    assert attributes["created"] == outcome.provenance.created
    assert attributes["numpy_version"] == np.__version__
    assert attributes["python_version"].startswith("3.")
    assert parse_study(attributes["study"]) == outcome.study


def test_axes_of_the_sweep_are_coordinates(reopened):
    data = reopened("two keys")
    assert dict(data.sizes) == {"problem.load.force": 4, "problem.bed.profile.curvature_radius": 2}
    force = data["problem.load.force"]
    assert force.attrs["units"] == "N"
    one = data["depth"].sel({"problem.load.force": 100.0, "problem.bed.profile.curvature_radius": 10e-3})
    modulus = 210e9 / (2 * (1 - 0.3**2))
    assert float(one) == pytest.approx((9 * 100.0**2 / (16 * modulus**2 * 10e-3)) ** (1 / 3), rel=1e-12)


def test_keys_that_vary_together_share_one_axis(reopened):
    data = reopened("together")
    assert dict(data.sizes) == {"point": 4}
    np.testing.assert_array_equal(data["problem.bed.medium.first.young"].values, [1e9, 2e9, 4e9, 8e9])
    assert data["problem.load.force"].dims == ("point",)


def test_loads_have_an_axis_where_there_are_many(reopened):
    assert reopened("many loads")["force"].dims == ("load",)
    assert reopened("many loads, varied")["force"].dims == ("problem.bed.profile.curvature_radius", "load")


def test_what_is_no_number_is_stated_by_name(reopened):
    data = reopened("shapes")
    shapes = data["problem.bed.profile"]
    assert "units" not in shapes.attrs
    assert list(shapes.values) == [
        "Paraboloid(curvature_radius=0.01)",
        "Cone(half_angle=1.5)",
        "FlatPunch(radius=0.001)",
    ]


def test_a_point_without_an_answer_is_missing_and_says_why(reopened, folder):
    data = reopened("some fail")
    assert np.isnan(data["depth"].values).tolist() == [False, False, True]
    assert list(data["failure"].values[:2]) == ["", ""]
    assert "0.002 m is beyond the rim" in data["failure"].values[2]
    table = rows(folder("some fail") / archive.CSV)
    assert table[0][-1] == "failure"
    assert table[3][0] == "0.002"
    assert math.isnan(float(table[3][1]))
    assert "beyond the rim" in table[3][-1]


def test_fields_at_multiples_of_the_contact_radius(outcomes, reopened):
    data = reopened("fields")
    assert dict(data.sizes) == {"problem.load.force": 4, "r_over_a": 4, "z_over_a": 2}
    assert data["pressure"].dims == ("problem.load.force", "r_over_a")
    assert data["von_mises"].dims == ("problem.load.force", "r_over_a", "z_over_a")
    assert data["r_over_a"].attrs["units"] == "1"
    np.testing.assert_allclose(data["r"].values, data["radius"].values[:, None] * [0.0, 0.5, 1.0, 2.0], rtol=1e-15)
    for place, point in enumerate(outcomes["fields"].solved):
        np.testing.assert_array_equal(data["pressure"].values[place], point.surface[0].pressure)
        np.testing.assert_array_equal(data["hoop_stress"].values[place], point.subsurface[0].hoop_stress)
        np.testing.assert_array_equal(data["von_mises"].values[place], point.subsurface[0].von_mises)
    assert data["separation" if "separation" in data else "gap"].attrs["units"] == "m"


def test_fields_at_lengths(outcomes, reopened, folder):
    data = reopened("fields at lengths")
    assert data["pressure"].dims == ("load", "r")
    np.testing.assert_array_equal(data["r"].values, [0.0, 1e-4])
    assert data["r"].attrs["units"] == "m"
    table = rows(folder("fields at lengths") / archive.SURFACE)
    assert table[0] == ["load", "r [m]", "pressure [Pa]", "displacement [m]", "gap [m]"]
    assert len(table) == 1 + 2 * 2
    solved = outcomes["fields at lengths"].solved[0]
    assert [float(cell) for cell in table[4][1:]] == [
        getattr(solved.surface[1], name)[1] for name in ("r", "pressure", "displacement", "gap")
    ]


def test_a_table_of_surface_fields_names_what_was_varied(outcomes, folder):
    table = rows(folder("fields") / archive.SURFACE)
    assert table[0][:2] == ["problem.load.force [N]", "r [m]"]
    assert [row[0] for row in table[1::4]] == ["1.0", "10.0", "100.0", "1000.0"]


def test_no_fields_no_table_of_fields(outcomes, tmp_path):
    write_files(archive.archive_files(outcomes["one load"]), tmp_path)
    assert sorted(path.name for path in tmp_path.iterdir()) == [archive.CSV, archive.NETCDF]


@pytest.mark.parametrize("name", SAMPLES)
def test_the_csv_has_units_and_all_digits(name, outcomes, folder):
    outcome = outcomes[name]
    table = rows(folder(name) / archive.CSV)
    columns = outcome.table()
    assert table[0] == [archive.heading(column.name, column.word) for column in columns]
    assert "depth [m]" in table[0]
    assert len(table) == 1 + len(columns[0].content)
    for place, column in enumerate(columns):
        written = [row[place] for row in table[1:]]
        if column.content.dtype.kind == "f":
            np.testing.assert_array_equal([float(cell) for cell in written], column.content)
        else:
            assert written == [str(item) for item in column.content]


def test_headings():
    assert archive.heading("poisson", Word("", "", "")) == "poisson [-]"
    assert archive.heading("coefficient", Word("c", "m^(1-n)", "")) == "coefficient [m^(1-n)]"


def test_archives_of_equal_studies_agree(tmp_path):
    study = Study("Twice", pressed(), sweep=(Axis("problem.load.force", (1.0, 2.0)),))
    for name in ("one", "two"):
        (tmp_path / name).mkdir()
        write_files(archive.archive_files(run(study)), tmp_path / name)
    one, two = ((tmp_path / name / archive.CSV).read_bytes() for name in ("one", "two"))
    assert one == two
    assert b"\r" not in one


def test_writing_again_replaces(outcomes, tmp_path):
    write_files(archive.archive_files(outcomes["two keys"]), tmp_path)
    write_files(archive.archive_files(outcomes["one load"]), tmp_path)
    with xarray.open_dataset(tmp_path / archive.NETCDF, engine="h5netcdf") as data:
        assert data.attrs["title"] == "A ball"
        assert dict(data.sizes) == {}
