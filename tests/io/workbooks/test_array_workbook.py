"""Named columns in files of HDF5, PyTables, pandas and MATLAB, each written here as its program writes it."""

from __future__ import annotations

import pickle

import h5py
import numpy as np
import pytest
from scipy.io import savemat

import winkler as wk
from winkler.io.curves import read_curves
from winkler.study.inspection.inspect import inspect_file

DEPTH = np.linspace(0.0, 800.0, 60)
FORCE = 1e-3 * DEPTH**1.5
UNITS = {"position": "nm", "force": "uN"}
FREQUENCY = np.geomspace(0.1, 100.0, 12)
STORAGE, LOSS = 1e3 * FREQUENCY**0.2, 4e2 * FREQUENCY**0.2
RAN = []


def curve_of(path):
    (placed,) = read_curves(path, units=UNITS)
    return placed.curve


def is_the_curve(curve):
    return np.allclose(curve.position, 1e-9 * DEPTH) and np.allclose(curve.force, 1e-6 * FORCE)


@pytest.mark.parametrize(
    "content",
    [
        {"depth": DEPTH, "force": FORCE},
        {"depth": DEPTH[:, None], "force": FORCE[None, :], "radius": 5.0, "operator": "A. Hertz"},
        {"test": {"depth": DEPTH, "force": FORCE, "date": "today"}},
        {"run": {"raw": {"depth": DEPTH, "force": FORCE}}, "image": np.eye(4)},
    ],
)
def test_vectors_of_a_workspace_are_a_curve(tmp_path, content):
    savemat(tmp_path / "curve.mat", content)
    assert is_the_curve(curve_of(tmp_path / "curve.mat"))


def test_structures_that_stand_again_are_tests(tmp_path):
    tests = [{"depth": DEPTH, "force": scale * FORCE} for scale in (1.0, 2.0)]
    savemat(tmp_path / "tests.mat", {"test": tests})
    first, second = read_curves(tmp_path / "tests.mat", units=UNITS)
    np.testing.assert_allclose(second.curve.force, 2.0 * first.curve.force)


def cells(*contents):
    array = np.empty(len(contents), object)
    array[:] = contents
    return array


@pytest.mark.parametrize("name", ["", "tests"])
def test_the_cells_of_each_place_are_a_test(tmp_path, name):
    """depth{2} and force{2} are the second curve, and shorter than the first."""
    content = {"depth": cells(DEPTH, DEPTH[:40]), "force": cells(FORCE, 2.0 * FORCE[:40]), "sample": cells("a", "b")}
    savemat(tmp_path / "cells.mat", {name: content} if name else content)
    first, second = (placed.curve for placed in read_curves(tmp_path / "cells.mat", units=UNITS))
    assert is_the_curve(first)
    np.testing.assert_allclose(second.force, 2.0 * first.force[:40])


def test_cells_of_a_workspace_in_hdf5(tmp_path):
    path = tmp_path / "cells.mat"
    with h5py.File(path, "w", userblock_size=512) as file:
        for name, vector in (("depth", DEPTH), ("force", FORCE)):
            parts = [file.create_dataset(f"#refs#/{name}{number}", data=vector[None, :]) for number in range(2)]
            file[name] = np.array([[one.ref] for one in parts], dtype=h5py.ref_dtype)
    with path.open("r+b") as file:
        file.write(b"MATLAB 7.3 MAT-file".ljust(512))
    first, second = (placed.curve for placed in read_curves(path, units=UNITS))
    assert is_the_curve(first)
    assert is_the_curve(second)


def test_matrices_in_cells_are_read_by_the_numbers_of_their_columns(tmp_path):
    both = np.column_stack([DEPTH, FORCE])
    savemat(tmp_path / "cells.mat", {"curve": cells(both, both[:40])})
    with pytest.raises(wk.InvalidInput, match="no sheet of the workbook has a row that names a depth and a force"):
        wk.read_curve(tmp_path / "cells.mat")
    found = [one.curve for one in read_curves(tmp_path / "cells.mat", units=UNITS, columns={"depth": 1, "force": 2})]
    assert [one.position.size for one in found] == [60, 40]
    assert [one.name for one in found] == ["cells.mat, sheet 'curve 1'", "cells.mat, sheet 'curve 2'"]


def test_a_workspace_of_matlab_in_hdf5(tmp_path):
    path = tmp_path / "curve.mat"
    with h5py.File(path, "w", userblock_size=512) as file:
        file["depth"], file["force"] = DEPTH[None, :], FORCE[None, :]
        file["name"] = np.frombuffer(b"x" * 60, "u1").astype("u2")[None, :]
        file["name"].attrs["MATLAB_class"] = np.bytes_("char")
        file["#refs#/a"] = DEPTH
    content = path.read_bytes()
    path.write_bytes(b"MATLAB 7.3 MAT-file".ljust(512, b" ") + content[512:])
    assert is_the_curve(curve_of(path))


def test_units_of_hdf5_stand_beside_its_columns(tmp_path):
    path = tmp_path / "sweep.h5"
    with h5py.File(path, "w") as file:
        for name, unit, column in (
            ("frequency", "Hz", FREQUENCY),
            ("storage modulus", "Pa", STORAGE),
            ("loss modulus", b"kPa", 1e-3 * LOSS),
        ):
            file[f"gel/{name}"] = column
            file[f"gel/{name}"].attrs["units"] = unit
    data = wk.read_dynamic(path)
    np.testing.assert_allclose(data.storage_shear, STORAGE, rtol=1e-12)
    np.testing.assert_allclose(data.loss_shear, LOSS, rtol=1e-12)
    assert inspect_file(path).taken_for == "storage and loss"


def test_a_table_of_records(tmp_path):
    path = tmp_path / "curve.hdf5"
    with h5py.File(path, "w") as file:
        kinds = [("depth", "f8"), ("force", "f4"), ("remark", "S8")]
        file["log"] = np.array([(d, f, b"x") for d, f in zip(DEPTH, FORCE, strict=True)], dtype=kinds)
    np.testing.assert_allclose(curve_of(path).force, 1e-6 * FORCE, rtol=1e-6)


def test_a_frame_of_pandas(tmp_path):
    path = tmp_path / "curve.h5"
    with h5py.File(path, "w") as file:
        frame = file.create_group("test 1")
        frame["axis0"] = np.array([b"depth", b"force"])
        frame["axis1"] = np.arange(DEPTH.size)
        frame["block0_items"] = np.array([b"depth", b"force"])
        frame["block0_values"] = np.column_stack([DEPTH, FORCE])
    assert is_the_curve(curve_of(path))


class Runs:
    """Something that a pickle would run."""

    def __reduce__(self):
        return RAN.append, ("it ran",)


@pytest.mark.parametrize("protocol", [0, 2, 4])
def test_names_in_a_pickle_are_read_and_nothing_is_run(tmp_path, protocol):
    path = tmp_path / "curve.h5"
    kinds = [("index", "i8"), ("values_block_0", "f8", (2,))]
    records = np.array([(n, (d, f)) for n, (d, f) in enumerate(zip(DEPTH, FORCE, strict=True))], dtype=kinds)
    with h5py.File(path, "w") as file:
        file["test 1/table"] = records
        file["test 1/table"].attrs["values_block_0_kind"] = np.void(pickle.dumps(["depth", "force"], protocol))
        file["test 2/table"] = records
        file["test 2/table"].attrs["values_block_0_kind"] = np.void(pickle.dumps([Runs(), "depth"], protocol))
    assert is_the_curve(curve_of(path))
    assert RAN == []


def test_what_is_no_table_is_refused_by_name(tmp_path):
    savemat(tmp_path / "one.mat", {"trace": DEPTH, "step": 1e-3})
    with pytest.raises(wk.InvalidInput, match="no two vectors of one length, 3 or more, with names; save the columns"):
        wk.read_curve(tmp_path / "one.mat")
    savemat(tmp_path / "bare.mat", {"depth": DEPTH, "force": FORCE})
    with pytest.raises(wk.InvalidInput, match='give it as units = { position = "nm", force = "uN" }'):
        wk.read_curve(tmp_path / "bare.mat")
    (tmp_path / "cut.mat").write_bytes((tmp_path / "bare.mat").read_bytes()[:300])
    with pytest.raises(wk.InvalidInput, match=r"cut\.mat"):
        wk.read_curve(tmp_path / "cut.mat")


def test_stated_sizes_are_refused_before_anything_is_read(tmp_path):
    path = tmp_path / "huge.h5"
    with h5py.File(path, "w") as file:
        for name in ("depth", "force"):
            file.create_dataset(name, shape=(10**11,), dtype="f8", chunks=(1024,))
    with pytest.raises(wk.InvalidInput, match="more than 200000 rows"):
        wk.read_curve(path)
