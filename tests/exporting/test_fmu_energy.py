"""Units of FMI 2 and FMI 3 as a master uses them: an oscillator on a contact, whose energy is kept."""

from __future__ import annotations

import ctypes
import io
import re
import subprocess
import xml.etree.ElementTree as ET
import zipfile

import numpy as np
import pytest
from compiled_c import compiler
from exported_laws import PROBLEMS
from scipy.integrate import solve_ivp

from winkler.exporting.choose import law_of
from winkler.exporting.export import export, write_export
from winkler.exporting.targets import compilers
from winkler.exporting.targets.fmu_description import fmu_inputs

TARGETS = {2: "fmu", 3: "fmu3"}


class Master:
    """Calls a unit as a program for co-simulation does."""

    def __init__(self, folder, name, version):
        ((_, content),) = export(PROBLEMS[name], TARGETS[version], name=name, count=8).files
        archive = zipfile.ZipFile(io.BytesIO(content))
        archive.extractall(folder)
        source, made = folder / "sources" / f"{name}_fmu.c", folder / "unit.so"
        command = [*compiler(), "-std=c99", "-Wall", "-Wextra", "-O0", "-shared", "-fPIC", str(source), "-o", str(made)]
        done = subprocess.run([*command, "-lm"], capture_output=True, text=True, check=True)
        assert done.stderr == ""
        self.version, self.library = version, ctypes.CDLL(str(made))
        self.law = law_of(PROBLEMS[name], tolerance=1e-6, count=8)
        self.inputs, self.outputs = len(fmu_inputs(self.law)), len(self.law.answer)
        root = ET.fromstring(archive.read("modelDescription.xml"))
        assert root.attrib["fmiVersion"] == f"{version}.0"
        token = root.attrib["guid" if version == 2 else "instantiationToken"].encode()
        assert not self.made(b"another")
        self.unit = ctypes.c_void_p(self.made(token))
        initialise = [ctypes.c_bool(False), ctypes.c_double(0.0), ctypes.c_double(0.5)] if version == 3 else []
        initialise += [ctypes.c_bool(False), ctypes.c_double(0.0)] if version == 3 else []
        assert self.call("EnterInitializationMode", *initialise) == 0
        assert self.call("ExitInitializationMode") == 0

    def made(self, token):
        """Return an instance, or nothing for the token of another unit."""
        make = getattr(self.library, "fmi2Instantiate" if self.version == 2 else "fmi3InstantiateCoSimulation")
        make.restype = ctypes.c_void_p
        null = ctypes.c_void_p()
        if self.version == 2:
            return make(b"x", 1, token, null, null, 0, 0)
        return make(b"x", token, null, *[ctypes.c_bool(False)] * 4, null, ctypes.c_size_t(0), null, null, null)

    def call(self, function, *arguments):
        """Call a function of the unit."""
        return getattr(self.library, f"fmi{self.version}{function}")(self.unit, *arguments)

    def get(self, references):
        """Return numbers by their references."""
        n = len(references)
        row = (ctypes.c_double * n)()
        size = [ctypes.c_size_t(n)] if self.version == 3 else []
        kind = "Real" if self.version == 2 else "Float64"
        assert self.call(f"Get{kind}", (ctypes.c_uint * n)(*references), ctypes.c_size_t(n), row, *size) == 0
        return np.array(row)

    def step(self, numbers, duration=0.1):
        """Put the inputs, do a step, and return the outputs and the status."""
        n = self.inputs
        size = [ctypes.c_size_t(n)] if self.version == 3 else []
        kind = "Real" if self.version == 2 else "Float64"
        row = (ctypes.c_double * n)(*numbers)
        assert self.call(f"Set{kind}", (ctypes.c_uint * n)(*range(n)), ctypes.c_size_t(n), row, *size) == 0
        told = [ctypes.byref(ctypes.c_bool()) for _ in range(3)] + [ctypes.byref(ctypes.c_double())]
        status = self.call(
            "DoStep", ctypes.c_double(0.5), ctypes.c_double(duration), ctypes.c_bool(True),
            *(told if self.version == 3 else []),
        )  # fmt: skip
        return self.get(range(n, n + self.outputs)), status


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize("version", [2, 3])
def test_an_oscillator_on_a_unit_keeps_its_energy(tmp_path, version):
    """A mass that hangs between a spring and a contact; the force of the unit against the energy that it states."""
    master = Master(tmp_path, "ball", version)
    mass, spring, pull = 0.01, 2e5, 0.15

    def fall(_, state):
        answer, status = master.step([state[0]])
        assert status == 0
        return [state[1], (pull - answer[0] - spring * state[0]) / mass]

    path = solve_ivp(fall, (0.0, 2e-3), [5e-8, 0.0], method="DOP853", rtol=1e-13, atol=[1e-20, 1e-16])
    depth, velocity = path.y
    stored = np.array([master.step([d])[0][2] for d in depth])
    kinetic = 0.5 * mass * velocity**2
    total = kinetic + stored + 0.5 * spring * depth**2 - pull * depth
    assert np.max(kinetic) > 1e-10  # it moves
    assert np.max(np.abs(total - total[0])) < 1e-10 * (np.max(kinetic) + np.max(stored))


@pytest.mark.slow
def test_a_unit_of_fmi_3_does_what_the_law_does(tmp_path):
    master = Master(tmp_path, "beads", 3)
    law = master.law
    changing = [k for k, part in enumerate(law.motion) if part.changes]
    places = law.trial.copy()
    places[:, changing] = np.cumsum(places[:, changing], axis=0)
    expected = law.trace()
    scale = np.maximum(np.max(np.abs(expected), axis=0), 1e-300)
    kept = ctypes.c_void_p()
    for k, (place, row) in enumerate(zip(places, expected, strict=True)):
        if k == 30:
            assert master.call("GetFMUState", ctypes.byref(kept)) == 0
            master.step(places[3])
            assert master.call("SetFMUState", kept) == 0
        answer, status = master.step(place)
        assert status == 0
        assert np.max(np.abs(answer - row) / scale) < 1e-11
    assert master.get([master.inputs + master.outputs])[0] == pytest.approx(0.6, rel=1e-12)  # the time
    assert master.step(np.ones(master.inputs))[1] == 3  # beyond the greatest depth
    assert master.call("FreeFMUState", ctypes.byref(kept)) == 0
    master.library.fmi3FreeInstance(master.unit)


@pytest.mark.slow
@pytest.mark.parametrize("version", [2, 3])
def test_fmpy_runs_a_unit_and_finds_nothing_wrong(tmp_path, version):
    fmpy = pytest.importorskip("fmpy", reason="no FMPy here: pip install fmpy")
    validation = pytest.importorskip("fmpy.validation")
    (path,) = write_export(export(PROBLEMS["ball"], TARGETS[version], name="ball"), tmp_path)
    assert validation.validate_fmu(str(path)) == []
    times = np.array([0.0, 1.0])
    given = np.array([(0.0, 0.0), (1.0, 3e-7)], dtype=[("time", float), ("depth", float)])
    found = fmpy.simulate_fmu(str(path), stop_time=1.0, step_size=0.1, output_interval=0.1, input=given)
    assert found["time"][-1] == pytest.approx(times[-1])
    law = law_of(PROBLEMS["ball"], tolerance=1e-6, count=8)
    least, largest = (law.trace(np.array([[3e-7 * t]]))[0, 0] for t in (0.85, 1.0))
    assert least < found["force"][-1] <= largest * (1.0 + 1e-12)


def test_a_unit_of_fmi_3_without_a_compiler_is_its_source(monkeypatch):
    monkeypatch.setattr(compilers, "_zig", list)
    monkeypatch.setattr(compilers.shutil, "which", lambda name: None)
    ((_, content),) = export(PROBLEMS["ball"], "fmu3", name="ball").files
    archive = zipfile.ZipFile(io.BytesIO(content))
    names = ["modelDescription.xml", "sources/ball.h", "sources/ball_fmu.c", "sources/buildDescription.xml"]
    assert archive.namelist() == names
    root = ET.fromstring(archive.read("modelDescription.xml"))
    numbers = {node.attrib["name"]: node.attrib for node in root.iter("Float64")}
    assert numbers["time"]["causality"] == "independent"
    assert re.search(r'valueReference="1" dependencies="0"', archive.read("modelDescription.xml").decode())
