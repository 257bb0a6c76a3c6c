"""Fields as VTK files: read back by a reader that was written after the description of the format alone."""

from __future__ import annotations

from xml.etree import ElementTree

import numpy as np
import pytest

import winkler as wk

STEEL = wk.Elastic(210e9, 0.3)
SOFT = wk.Elastic(70e9, 0.33)
BED = wk.Foundation(wk.Paraboloid(10e-3), wk.HalfSpace.between(STEEL, SOFT))
CONTACT = wk.Indentation(BED, wk.Force(100.0)).solve()
A = CONTACT.radius
R, Z = np.linspace(0.0, 2.0 * A, 5), np.linspace(0.1 * A, 2.0 * A, 4)


def read(path):
    """Return the dimensions, the points, and name -> numbers of every point, first axis fastest."""
    content = path.read_bytes()
    place = 0

    def line():
        nonlocal place
        end = content.index(b"\n", place)
        text, place = content[place:end].decode("ascii"), end + 1
        return text

    def numbers(count, parts):
        nonlocal place
        size = 8 * count * parts
        found = np.frombuffer(content, dtype=">f8", count=count * parts, offset=place).reshape(count, parts)
        place += size
        assert content[place : place + 1] == b"\n"
        place += 1
        return found.astype(float)

    assert line() == "# vtk DataFile Version 3.0"
    assert len(line()) <= 256
    assert line() == "BINARY"
    assert line() == "DATASET STRUCTURED_GRID"
    dimensions = tuple(int(word) for word in line().split()[1:])
    word, count, kind = line().split()
    assert (word, int(count), kind) == ("POINTS", np.prod(dimensions), "double")
    points = numbers(int(count), 3)
    assert line() == f"POINT_DATA {count}"
    found = {}
    while place < len(content):
        sort, name, kind, *rest = line().split()
        assert kind == "double"
        if sort == "SCALARS":
            assert rest == ["1"]
            assert line() == "LOOKUP_TABLE default"
        found[name] = numbers(int(count), {"SCALARS": 1, "VECTORS": 3, "TENSORS": 9}[sort])
    return dimensions, points, found


def read_xml(path):
    """Return the same of a file in XML; arrays lie behind the underscore, each after its length in bytes."""
    content = path.read_bytes()
    head, _, rest = content.partition(b'<AppendedData encoding="raw">')
    raw = rest[rest.index(b"_") + 1 :]
    root = ElementTree.fromstring(head + b"</VTKFile>")
    assert root.attrib == {
        "type": "StructuredGrid", "version": "1.0", "byte_order": "LittleEndian", "header_type": "UInt64"
    }  # fmt: skip
    extent = [int(word) for word in root.find("StructuredGrid/Piece").get("Extent").split()]
    dimensions = tuple(high - low + 1 for low, high in zip(extent[::2], extent[1::2], strict=True))
    count, found, end = int(np.prod(dimensions)), {}, 0
    for array in root.iter("DataArray"):
        assert (array.get("type"), array.get("format")) == ("Float64", "appended")
        place, parts = int(array.get("offset")), int(array.get("NumberOfComponents"))
        size = int.from_bytes(raw[place : place + 8], "little")
        assert size == 8 * count * parts
        numbers = np.frombuffer(raw, "<f8", count * parts, place + 8).reshape(count, parts)
        found[array.get("Name")] = numbers
        end = max(end, place + 8 + size)
    assert raw[end:].split() == [b"</AppendedData>", b"</VTKFile>"]
    return dimensions, found.pop("points"), found


def of_program(path):
    """Return the same by the library of VTK itself."""
    core = pytest.importorskip("vtkmodules.vtkIOXML", reason="vtk is not installed")
    convert = pytest.importorskip("vtkmodules.util.numpy_support").vtk_to_numpy
    reader = core.vtkXMLStructuredGridReader()
    reader.SetFileName(str(path))
    reader.Update()
    grid = reader.GetOutput()
    data = grid.GetPointData()
    arrays = {data.GetArrayName(k): convert(data.GetArray(k)) for k in range(data.GetNumberOfArrays())}
    found = {name: numbers.reshape(len(numbers), -1) for name, numbers in arrays.items()}
    return grid.GetDimensions(), convert(grid.GetPoints().GetData()), found


@pytest.mark.parametrize("reader", [read_xml, of_program])
def test_xml_holds_what_the_legacy_format_holds(reader, tmp_path):
    field = wk.restore(CONTACT, R[:, None], Z[None, :])
    wk.write_vtk(field, tmp_path / "a.vtk", around=5)
    wk.write_vtk(field, tmp_path / "a.vts", around=5)
    dimensions, points, found = read(tmp_path / "a.vtk")
    again = reader(tmp_path / "a.vts")
    assert again[0] == dimensions
    assert np.array_equal(again[1], points)
    assert again[2].keys() == found.keys()
    assert all(np.array_equal(again[2][name], found[name]) for name in found)


def test_a_time_series_is_a_collection_of_states(tmp_path):
    loads = {0.0: 1.0, 0.5: 30.0, 2.0: 100.0}
    states = {
        time: wk.restore(wk.Indentation(BED, wk.Force(load)).solve(), R[:, None], Z[None, :])
        for time, load in loads.items()
    }
    target = tmp_path / "press & hold.pvd"
    assert wk.write_vtk(states, target) == target
    root = ElementTree.fromstring(target.read_bytes())
    assert root.get("type") == "Collection"
    listed = {float(one.get("timestep")): one.get("file") for one in root.iter("DataSet")}
    assert list(listed) == list(loads)
    assert {target.name, *listed.values()} == {path.name for path in tmp_path.iterdir()}
    for time, name in listed.items():
        _, _, found = read_xml(tmp_path / name)
        assert np.max(found["von_mises"]) == np.max(states[time].von_mises)


def test_a_half_plane_has_the_numbers_of_the_field(tmp_path):
    field = wk.restore(CONTACT, R[:, None], Z[None, :])
    assert wk.write_vtk(field, tmp_path / "below.vtk") == tmp_path / "below.vtk"
    dimensions, points, found = read(tmp_path / "below.vtk")
    assert dimensions == (5, 1, 4)
    fastest = [(i, k) for k in range(4) for i in range(5)]
    for row, (i, k) in enumerate(fastest):
        assert points[row].tolist() == [R[i], 0.0, Z[k]]
        assert found["von_mises"][row, 0] == field.von_mises[i, k]
        assert found["displacement"][row].tolist() == [
            field.radial_displacement[i, k], 0.0, field.axial_displacement[i, k]
        ]  # fmt: skip
        tensor = found["stress"][row].reshape(3, 3)
        assert tensor.tolist() == [
            [field.radial_stress[i, k], 0.0, field.shear_stress[i, k]],
            [0.0, field.hoop_stress[i, k], 0.0],
            [field.shear_stress[i, k], 0.0, field.axial_stress[i, k]],
        ]


def test_turned_about_the_axis_it_is_the_field_of_the_body(tmp_path):
    """`restore_body` has the same stresses in the axes x, y, z by another path of code."""
    field = wk.restore(CONTACT, R[1:, None], Z[None, :])
    wk.write_vtk(field, tmp_path / "body.vtk", around=7)
    dimensions, points, found = read(tmp_path / "body.vtk")
    assert dimensions == (4, 8, 4)
    body = wk.restore_body(CONTACT, *points.T)
    names = ("xx", "xy", "xz", "xy", "yy", "yz", "xz", "yz", "zz")
    scale = np.max(np.abs(field.axial_stress))
    for place, name in enumerate(names):
        np.testing.assert_allclose(found["stress"][:, place], getattr(body, f"{name}_stress"), atol=1e-9 * scale)
    for place, name in enumerate("xyz"):
        expected = getattr(body, f"{name}_displacement")
        np.testing.assert_allclose(found["displacement"][:, place], expected, atol=1e-9 * CONTACT.depth)
    closed = points.reshape(4, 8, 4, 3)
    np.testing.assert_allclose(closed[:, 0], closed[:, -1], atol=1e-18)


def test_both_bodies_share_one_direction_of_z(tmp_path):
    """Surfaces stay together: on the axis the displacements differ by the depth of the contact."""
    step = 1e-9 * A
    field = wk.restore(CONTACT, np.zeros(2), np.array([step, -step]))
    wk.write_vtk(field, tmp_path / "two.vtk")
    _, _, found = read(tmp_path / "two.vtk")
    first, second = found["displacement"][:, 2]
    assert first > 0.0 > second
    assert first - second == pytest.approx(CONTACT.depth, rel=1e-6)


def test_a_sheared_body_keeps_its_grid(tmp_path):
    path = wk.Path([0.0, 1.0], wk.Force(100.0), wk.Shift(np.array([0.0, 3e-7])))
    state = wk.Tangential(BED, wk.Coulomb(0.3), path).solve().states[-1]
    x, y, z = np.linspace(-A, A, 3), np.linspace(-A, 0.5 * A, 4), np.linspace(0.1 * A, A, 2)
    field = wk.restore_body(state, x[:, None, None], y[None, :, None], z[None, None, :])
    wk.write_vtk(field, tmp_path / "sheared.vtk")
    dimensions, points, found = read(tmp_path / "sheared.vtk")
    assert dimensions == (3, 4, 2)
    row = 2 + 3 * (1 + 4 * 1)  # i = 2, j = 1, k = 1
    assert points[row].tolist() == [x[2], y[1], z[1]]
    assert found["stress"][row].reshape(3, 3)[0, 1] == field.xy_stress[2, 1, 1]
    assert found["max_shear"][row, 0] == field.max_shear[2, 1, 1]


def test_currents_and_heat_are_written(tmp_path):
    silver = wk.NamedElectricalConductor("silver")
    hot = wk.JouleHeating(
        wk.Indentation(BED, wk.Force(1.0)), wk.ElectricalConductors(silver, silver), wk.Current(5.0)
    ).solve()
    field = wk.restore_conduction(hot, np.linspace(0.0, 0.9e-5, 4)[:, None], np.array([1e-6, 2e-5])[None, :])
    wk.write_vtk(field, tmp_path / "current.vtk", around=4)
    dimensions, _, found = read(tmp_path / "current.vtk")
    assert dimensions == (4, 5, 2)
    assert set(found) == {"potential", "temperature", "current_density"}
    density = np.hypot(*found["current_density"].reshape(2, 5, 4, 3)[0, 1, :, :2].T)
    np.testing.assert_allclose(density, np.abs(field.radial_current_density[:, 0]), rtol=1e-12, atol=1e-6)


@pytest.mark.parametrize(
    ("make", "sentence"),
    [
        (lambda: wk.write_vtk(CONTACT, "a.vtk"), "is no field inside the bodies"),
        (lambda: wk.write_vtk(wk.restore(CONTACT, R), "a.vtk"), "is no field inside the bodies"),
        (lambda: wk.write_vtk(wk.restore(CONTACT, R, Z[:1]), "a.vtu"), "the ending is '.vtu'; give .vtk or .vts"),
        (lambda: wk.write_vtk({0.0: wk.restore(CONTACT, R, Z[:1])}, "a.vts"), "the ending is '.vts'; give .pvd"),
        (lambda: wk.write_vtk({}, "a.pvd"), "the times must be finite and rise, at least one"),
        (lambda: wk.write_vtk({"now": wk.restore(CONTACT, R, Z[:1])}, "a.pvd"), "a time is no number"),
        (lambda: wk.write_vtk({1.0: wk.restore(CONTACT, R, Z[:1]), 0.0: 3}, "a.pvd"), "must be finite and rise"),
        (lambda: wk.write_vtk({0.0: wk.restore(CONTACT, R, Z[:1]), 1.0: 3}, "a.pvd"), "a int is no field"),
        (lambda: wk.write_vtk(wk.restore(CONTACT, R, Z[:1]), "no/such/a.vtk"), "cannot be written"),
        (lambda: wk.write_vtk(wk.restore(CONTACT, R, Z[:1]), "a.vtk", around=2), "around is 2; give 1"),
        (lambda: wk.write_vtk(wk.restore(CONTACT, np.ones((2, 2, 2)) * A, A), "a.vtk"), "the places have the shape"),
        (lambda: wk.write_vtk(wk.restore_body(CONTACT, 0.0, 0.0, A), "a.vtk", around=5), "leave around out"),
    ],
)
def test_what_cannot_be_written_is_stated(make, sentence, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    with pytest.raises(wk.InvalidInput, match=sentence):
        make()
    assert list(tmp_path.iterdir()) == []
