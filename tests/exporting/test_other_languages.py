"""The same laws in Fortran, in WebAssembly and as units for co-simulation, where there is what runs them."""

from __future__ import annotations

import ctypes
import io
import re
import shutil
import subprocess
import xml.etree.ElementTree as ET
import zipfile
from importlib.util import find_spec

import numpy as np
import pytest
from compiled_c import compiler
from exported_laws import PROBLEMS, ran

from winkler.exporting.choose import law_of
from winkler.exporting.export import RESERVED, TARGETS, export, write_export
from winkler.exporting.targets import compilers
from winkler.exporting.targets.fmu_description import fmu_inputs
from winkler.exporting.targets.fortran_law import fortran_law
from winkler.values.errors import InvalidInput

NAMES = ["beads", "gel"]


@pytest.mark.few(1)
@pytest.mark.parametrize("name", NAMES)
def test_the_module_in_fortran_agrees_with_the_trace(tmp_path, name):
    gfortran = shutil.which("gfortran")
    if gfortran is None:
        pytest.skip("no gfortran here: install it to compile the module")
    files = write_export(export(PROBLEMS[name], "fortran", name=name, count=8), tmp_path)
    assert [file.name for file in files] == [f"{name}.f90", f"{name}.h", f"{name}_c.c", f"{name}_test.f90"]
    subprocess.run([*compiler(), "-std=c99", "-O0", "-c", f"{name}_c.c", "-o", f"{name}_c.o"], cwd=tmp_path, check=True)
    parts = [f"{name}.f90", f"{name}_test.f90", f"{name}_c.o"]
    command = [gfortran, "-std=f2008", "-Wall", "-Werror=line-truncation", *parts, "-o", name, "-lm"]
    subprocess.run(command, cwd=tmp_path, check=True)
    code, text = ran(tmp_path / name)
    assert code == 0
    assert text.startswith(f"{name}: the steps agree with winkler to")


def test_no_line_of_the_fortran_is_too_long():
    for name in NAMES:
        for file, text in export(PROBLEMS[name], "fortran", name=name, count=8).files:
            if file.endswith(".f90"):
                assert max(len(line) for line in text.splitlines() if not line.startswith("!")) <= 132


@pytest.mark.slow
@pytest.mark.parametrize("name", NAMES)
def test_the_module_of_webassembly_agrees_with_the_trace(tmp_path, name):
    if find_spec("ziglang") is None or shutil.which("node") is None:
        pytest.skip("no ziglang or no node here: pip install winkler[export], and install node")
    write_export(export(PROBLEMS[name], "wasm", name=name, count=8), tmp_path)
    code, text = ran("node", tmp_path / f"{name}.mjs")
    assert code == 0, text
    assert (tmp_path / f"{name}.wasm").stat().st_size < 40_000


def test_without_its_compiler_webassembly_is_refused(monkeypatch):
    monkeypatch.setattr(compilers, "_zig", list)
    with pytest.raises(InvalidInput, match=r"pip install winkler\[export\]"):
        export(PROBLEMS["ball"], "wasm")


@pytest.mark.parametrize(
    "name",
    ["abs", "answer", "c_double", "con", "expected", "iso_c_binding", "lambda", "math", "max", "maxval", "motion",
     "new", "numpy", "procedure", "scale", "state", "step", "string", "trial", "types", "worst", "yield"],
)  # fmt: skip
def test_words_of_the_targets_are_no_names(name):
    """Issue 38, item 5: 12 of 95 names were accepted and did not compile in Fortran."""
    for to in ("c", "fortran", "python"):
        with pytest.raises(InvalidInput, match=rf"^export: '{name}' is a word of .*; give another, such as contact\.$"):
            export(PROBLEMS["ball"], to, name=name)


@pytest.mark.few(4)
@pytest.mark.parametrize("name", PROBLEMS)
def test_each_word_that_the_files_in_fortran_use_is_refused(name):
    """A module cannot have the name of anything that is used or declared where it stands."""
    files = fortran_law(law_of(PROBLEMS[name], tolerance=1e-3, count=3), "placeholder")
    used = set()
    for file in ("placeholder.f90", "placeholder_test.f90"):
        for line in files[file].splitlines():
            code = re.sub(r"%\s*\w+|\"[^\"]*\"|\b[0-9.]+e[-+]?\d+", " ", line).partition("!")[0]
            member = "::" in code and ("c_double" in code or "c_int" in code or "c_bool" in code) and "!" in line
            used |= {word.lower() for word in re.findall(r"[A-Za-z]\w*", code.partition("::")[0] if member else code)}
    used = {word for word in used if "placeholder" not in word and not word.endswith("_")}  # numbers of the state
    assert {"abs", "c_double", "max", "motion", "state", "step"} <= used
    assert used - set(RESERVED) <= {"c", "e"}  # of bind(c)


@pytest.mark.usefixtures("nothing_compiles")
def test_files_of_two_targets_share_a_name_only_if_they_are_the_same():
    """`--to fmu` and `--to fmu3` wrote one file."""
    found = {}
    for to in (target for target in TARGETS if target != "wasm"):
        for file, content in export(PROBLEMS["ball"], to, count=3, tolerance=1e-3).files:
            if isinstance(content, str):  # all but the mark of the set of files to which it belongs
                content = "\n".join(line for line in content.splitlines() if "EXPORT" not in line)
            assert found.setdefault(file, content) == content, (to, file)
    assert {"contact.fmu", "contact_fmi3.fmu"} <= set(found)


@pytest.fixture
def nothing_compiles(monkeypatch):
    monkeypatch.setattr(compilers, "_zig", list)
    monkeypatch.setattr(compilers.shutil, "which", lambda name: None)


def unit_of(name):
    """Return the unit of a problem as an archive."""
    exported = export(PROBLEMS[name], "fmu", name=name, count=8)
    ((file, content),) = exported.files
    assert file == f"{name}.fmu"
    return zipfile.ZipFile(io.BytesIO(content))


@pytest.mark.usefixtures("nothing_compiles")
def test_without_a_compiler_a_unit_is_its_source():
    assert unit_of("ball").namelist() == ["modelDescription.xml", "sources/ball.h", "sources/ball_fmu.c"]


@pytest.mark.usefixtures("nothing_compiles")
def test_a_unit_describes_its_numbers():
    archive = unit_of("beads")
    root = ET.fromstring(archive.read("modelDescription.xml"))
    assert root.attrib["fmiVersion"] == "2.0"
    names = [(node.attrib["name"], node.attrib["causality"]) for node in root.iter("ScalarVariable")]
    assert names[:3] == [("depth", "input"), ("position_x", "input"), ("position_y", "input")]
    assert ("force", "output") in names
    units = {node.attrib["name"] for node in root.iter("Unit")}
    assert {node.attrib.get("unit") for node in root.iter("Real")} - {None} <= units
    outputs = [int(node.attrib["index"]) for node in root.find("ModelStructure/Outputs")]
    assert outputs == [k + 1 for k, (_, causality) in enumerate(names) if causality == "output"]
    assert root.attrib["guid"].encode() in archive.read("sources/beads_fmu.c")


@pytest.mark.few(1)
@pytest.mark.parametrize("name", ["beads", "gel"])
def test_a_unit_does_what_the_law_does(tmp_path, monkeypatch, name):
    """By its own functions, which a master of FMI calls; with saving and restoring in between."""
    command = compiler()
    monkeypatch.setattr(compilers, "_own", list)
    archive = unit_of(name)
    archive.extractall(tmp_path)
    made = tmp_path / "unit.so"
    source = tmp_path / "sources" / f"{name}_fmu.c"
    command += ["-std=c99", "-Wall", "-O0", "-shared", "-fPIC", str(source), "-o", str(made), "-lm"]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    assert done.stderr == ""
    unit = ctypes.CDLL(str(made))
    unit.fmi2Instantiate.restype = ctypes.c_void_p
    guid = ET.fromstring(archive.read("modelDescription.xml")).attrib["guid"].encode()
    assert unit.fmi2Instantiate(b"x", 1, b"other", None, None, 0, 0) is None
    one = ctypes.c_void_p(unit.fmi2Instantiate(b"x", 1, guid, None, None, 0, 0))
    law = law_of(PROBLEMS[name], tolerance=1e-6, count=8)
    inputs = fmu_inputs(law)
    changing = [k for k, part in enumerate(law.motion) if part.changes]
    stays = [k for k, part in enumerate(law.motion) if part.name != "duration"]
    places = law.trial.copy()
    places[:, changing] = np.cumsum(places[:, changing], axis=0)
    durations = law.trial[:, 1] if len(stays) < len(law.motion) else np.full(len(places), 0.1)

    def put(numbers):
        row, which = (ctypes.c_double * len(inputs))(*numbers), (ctypes.c_uint * len(inputs))(*range(len(inputs)))
        assert unit.fmi2SetReal(one, which, ctypes.c_size_t(len(inputs)), row) == 0

    def got():
        count = len(law.answer)
        row = (ctypes.c_double * count)()
        which = (ctypes.c_uint * count)(*range(len(inputs), len(inputs) + count))
        assert unit.fmi2GetReal(one, which, ctypes.c_size_t(count), row) == 0
        return list(row)

    def step(k):
        put(places[k, stays])
        duration = ctypes.c_double(float(durations[k]))
        assert unit.fmi2DoStep(one, ctypes.c_double(0.0), duration, 1) == 0
        return got()

    assert unit.fmi2EnterInitializationMode(one) == 0
    assert unit.fmi2ExitInitializationMode(one) == 0
    found = [step(k) for k in range(30)]
    kept = ctypes.c_void_p()
    assert unit.fmi2GetFMUstate(one, ctypes.byref(kept)) == 0
    first = [step(k) for k in range(30, 60)]
    assert unit.fmi2SetFMUstate(one, kept) == 0
    again = [step(k) for k in range(30, 60)]
    assert first == again
    unit.fmi2FreeFMUstate(one, ctypes.byref(kept))
    expected = law.trace()
    scale = np.maximum(np.max(np.abs(expected), axis=0), 1e-300)
    assert np.max(np.abs(np.array(found + first) - expected) / scale) < 1e-11
    put([1.0] * len(inputs))
    assert unit.fmi2DoStep(one, ctypes.c_double(0.0), ctypes.c_double(0.1), 1) == 3  # beyond the greatest depth
    unit.fmi2FreeInstance(one)


def test_fmpy_finds_nothing_wrong(tmp_path):
    validation = pytest.importorskip("fmpy.validation", reason="no FMPy here: pip install fmpy")
    (path,) = write_export(export(PROBLEMS["beads"], "fmu", name="beads", count=8), tmp_path)
    assert validation.validate_fmu(str(path)) == []
