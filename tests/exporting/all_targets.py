"""Histories through every target: one library, module or program holds all laws, so that each is compiled once."""

from __future__ import annotations

import ctypes
import io
import platform
import shutil
import subprocess
import xml.etree.ElementTree as ET
import zipfile
from importlib.util import find_spec

import numpy as np
import pytest
from compiled_c import compiler, interpreted

from winkler.exporting.targets import compilers
from winkler.exporting.targets.c_law import c_law
from winkler.exporting.targets.fmu_description import fmu_inputs
from winkler.exporting.targets.fmu_law import fmu_law
from winkler.exporting.targets.fortran_law import fortran_law
from winkler.exporting.targets.python_law import python_law
from winkler.numerics.jit import Kernel

STRICT = ("-std=c99", "-O0", "-ffp-contract=off")
FOLLOW = """#include "{name}.h"
{exported}void {name}_follow(const double *motions, double *answers, int histories, int steps) {{
    {name}_state state;
    {name}_motion motion;
    {name}_answer answer;
    for (int k = 0; k < histories * steps; ++k) {{
        if (k % steps == 0) {name}_begin(&state);
        memcpy(&motion, motions + (size_t)k * {takes}, sizeof(motion));
        {name}_step(&state, &motion, &answer);
        memcpy(answers + (size_t)k * {gives}, &answer, sizeof(answer));
    }}
}}
"""
FILED = """    {{
        double *motions = malloc(8 * {takes}), *answers = malloc(8 * {gives});
        FILE *file = fopen("{name}.motions", "rb");
        if (fread(motions, 8, {takes}, file) != {takes}) return 1;
        fclose(file);
        {name}_follow(motions, answers, {histories}, {steps});
        file = fopen("{name}.filed", "wb");
        fwrite(answers, 8, {gives}, file);
        fclose(file);
    }}
"""
FOLLOW_FORTRAN = """
subroutine {name}_follow(motions, answers, histories, steps) bind(c)
  use, intrinsic :: iso_c_binding
  use {name}
  implicit none
  integer(c_int), value :: histories, steps
  real(c_double), intent(in) :: motions({takes}, histories * steps)
  real(c_double), intent(out) :: answers({gives}, histories * steps)
  type({name}_state) :: state
  type({name}_motion) :: motion
  type({name}_answer) :: answer
  integer :: k
  do k = 1, histories * steps
    if (mod(k - 1, steps) == 0) call {name}_begin(state)
{put}
    call {name}_step(state, motion, answer)
{got}
  end do
end subroutine
"""
PAGE = """
import {{ readFileSync, writeFileSync }} from "node:fs";
const wasi = new Proxy({{}}, {{ get: () => () => 8 }}); // no files
const {{ instance }} = await WebAssembly.instantiate(readFileSync("laws.wasm"), {{ wasi_snapshot_preview1: wasi }});
const own = instance.exports;
own._initialize?.();
for (const [name, takes, gives, histories, steps] of {laws}) {{
  const motions = new Float64Array(new Uint8Array(readFileSync(`${{name}}.motions`)).buffer);
  const from = own.room(8 * histories * steps * (takes + gives)), to = from + 8 * histories * steps * takes;
  new Float64Array(own.memory.buffer, from, motions.length).set(motions);
  own[`${{name}}_follow`](from, to, histories, steps);
  writeFileSync(`${{name}}.answers`, new Uint8Array(own.memory.buffer, to, 8 * histories * steps * gives));
}}
"""


def by_reference(law, motions):
    """Return what the source of winkler answers, (histories, steps, outputs), with the functions of C's library."""
    kernel = interpreted(law.kernel) if isinstance(law.kernel, Kernel) else law.kernel
    answers = np.empty((*motions.shape[:2], len(law.answer)))
    for history, rows in zip(motions, answers, strict=True):
        state = [np.array(part.begin) for part in law.state]
        with np.errstate(all="ignore"):  # C is silent, too
            for motion, row in zip(history, rows, strict=True):
                law.step(state, motion, row, kernel)
    return answers


def by_c(folder, laws, motions):
    """Return what the C files answer, without optimisation."""
    for name, law in laws.items():
        (folder / f"{name}.h").write_text(c_law(law, name))
        (folder / f"{name}_follow.c").write_text(_follow(name, law))
    parts = [f"{name}_follow.c" for name in laws]
    _run(folder, *compiler(), *STRICT, "-shared", "-fPIC", *parts, "-o", "laws.so", "-lm")
    return _followed(ctypes.CDLL(str(folder / "laws.so")), laws, motions)


def by_fortran(folder, laws, motions):
    """Return what the modules answer."""
    if shutil.which("gfortran") is None:
        pytest.skip("no gfortran here: install it to compile the modules")
    modules = []
    for name, law in laws.items():
        for file, text in fortran_law(law, name).items():
            (folder / file).write_text(text)
        put = "\n".join(f"    motion%{one.name} = motions({k + 1}, k)" for k, one in enumerate(law.motion))
        got = "\n".join(f"    answers({k + 1}, k) = answer%{one.name}" for k, one in enumerate(law.answer))
        words = {"takes": len(law.motion), "gives": len(law.answer), "put": put, "got": got}
        (folder / f"{name}_follow.f90").write_text(FOLLOW_FORTRAN.format(name=name, **words))
        modules += [f"{name}.f90", f"{name}_follow.f90"]
    _run(folder, *compiler(), *STRICT, "-c", "-fPIC", *(f"{name}_c.c" for name in laws))
    objects = [f"{name}_c.o" for name in laws]
    _run(folder, "gfortran", "-std=f2008", "-O0", "-shared", "-fPIC", *modules, *objects, "-o", "laws.so", "-lm")
    return _followed(ctypes.CDLL(str(folder / "laws.so")), laws, motions)


def by_python(laws, motions):
    """Return what the Python files answer, by themselves."""
    found = {}
    for name, law in laws.items():
        own = {"__name__": name}
        exec(compile(python_law(law, name), f"{name}.py", "exec"), own)
        found[name] = np.empty((*motions[name].shape[:2], len(law.answer)))
        for history, into in zip(motions[name], found[name], strict=True):
            state = own["begin"]()
            into[:] = [own["step"](state, motion) for motion in history]
    return found


def by_webassembly(folder, laws, motions):
    """Return what one module of all laws answers in Node, with the options of an export."""
    if find_spec("ziglang") is None or shutil.which("node") is None:
        pytest.skip("no ziglang or no node here: pip install winkler[export], and install node")
    sources = {f"{name}.h": c_law(law, name) for name, law in laws.items()}
    parts = [_follow(name, law, f'__attribute__((export_name("{name}_follow"))) ') for name, law in laws.items()]
    room = '#include <stdlib.h>\n__attribute__((export_name("room"))) void *room(int bytes) { return malloc(bytes); }\n'
    sources["laws.c"] = "".join(parts) + room
    options = ("-mexec-model=reactor",)
    (folder / "laws.wasm").write_bytes(compilers.compiled_by_zig(sources, "wasm32-wasi", options, "laws.wasm"))
    sizes = []
    for name, law in laws.items():
        (folder / f"{name}.motions").write_bytes(np.ascontiguousarray(motions[name]).tobytes())
        sizes.append([name, len(law.motion), len(law.answer), *motions[name].shape[:2]])
    (folder / "page.mjs").write_text(PAGE.format(laws=str(sizes).replace("'", '"')))
    _run(folder, "node", "page.mjs")
    read = {name: np.frombuffer((folder / f"{name}.answers").read_bytes()) for name in laws}
    return {name: read[name].reshape(*motions[name].shape[:2], -1) for name in laws}


def by_c_with_the_library_of_webassembly(folder, laws, motions):
    """Return what a program answers whose library of C is musl, which WebAssembly has, too; after `by_webassembly`."""
    sources = {f"{name}.h": c_law(law, name) for name, law in laws.items()}
    steps = []
    for name, law in laws.items():
        histories, length = motions[name].shape[:2]
        takes, gives = (histories * length * len(numbers) for numbers in (law.motion, law.answer))
        steps.append(FILED.format(name=name, takes=takes, gives=gives, histories=histories, steps=length))
    parts = [_follow(name, law) for name, law in laws.items()]
    main = ["#include <stdio.h>\n#include <stdlib.h>\n", *parts, "int main(void) {\n", *steps, "    return 0;\n}\n"]
    sources["laws.c"] = "".join(main)
    target = f"{platform.machine()}-linux-musl"
    (folder / "laws").write_bytes(compilers.compiled_by_zig(sources, target, ("-static",), "laws"))
    (folder / "laws").chmod(0o755)
    _run(folder, "./laws")
    read = {name: np.frombuffer((folder / f"{name}.filed").read_bytes()) for name in laws}
    return {name: read[name].reshape(*motions[name].shape[:2], -1) for name in laws}


def by_units(folder, laws, motions):
    """Return what units of FMI 2 answer through their own functions; and the motions that they make of positions.

    A unit is initialised where the bodies are apart, which is a step of its own.
    """
    shapes, tokens = {}, {}
    for name, law in laws.items():
        ((_, content),) = fmu_law(law, name).items()
        archive = zipfile.ZipFile(io.BytesIO(content))
        tokens[name] = ET.fromstring(archive.read("modelDescription.xml")).attrib["guid"].encode()
        for file in (f"{name}.h", f"{name}_fmu.c"):
            (folder / file).write_bytes(archive.read(f"sources/{file}"))
        prefixed = f'#define FMI2_FUNCTION_PREFIX {name}_\n#include "{name}_fmu.c"\n'
        (folder / f"{name}_unit.c").write_text(prefixed)
        shapes[name] = (len(fmu_inputs(law)), len(law.answer))
    parts = [f"{name}_unit.c" for name in laws]
    _run(folder, *compiler(), *STRICT, "-shared", "-fPIC", *parts, "-o", "units.so", "-lm")
    library = ctypes.CDLL(str(folder / "units.so"))
    answers, moved = {}, {}
    for name, law in laws.items():
        places = motions[name].copy()
        changing = [k for k, one in enumerate(law.motion) if one.changes]
        places[:, :, changing] = np.cumsum(places[:, :, changing], axis=1)
        moved[name] = np.insert(places, 0, 0.0, axis=1)
        moved[name][:, 1:, changing] = np.diff(moved[name][:, :, changing], axis=1)
        unit = {word: getattr(library, f"{name}_fmi2{word}") for word in ("Instantiate", "SetReal", "GetReal")}
        unit |= {word: getattr(library, f"{name}_fmi2{word}") for word in ("DoStep", "ExitInitializationMode")}
        answers[name] = _stepped(unit, tokens[name], law, places, shapes[name])
    return answers, moved


def _stepped(unit, token, law, places, shape):
    """Return the answers of one unit, (histories, steps, outputs)."""
    takes, gives = shape
    stays = [k for k, one in enumerate(law.motion) if one.name != "duration"]
    timed = [k for k, one in enumerate(law.motion) if one.name == "duration"]
    unit["Instantiate"].restype = ctypes.c_void_p
    inputs, outputs = (ctypes.c_uint * takes)(*range(takes)), (ctypes.c_uint * gives)(*range(takes, takes + gives))
    answers, row = np.empty((*places.shape[:2], gives)), (ctypes.c_double * gives)()
    for history, into in zip(places, answers, strict=True):
        one = ctypes.c_void_p(unit["Instantiate"](b"one", 1, token, None, None, 0, 0))
        assert unit["ExitInitializationMode"](one) == 0
        for k, motion in enumerate(history):
            unit["SetReal"](one, inputs, ctypes.c_size_t(takes), (ctypes.c_double * takes)(*motion[stays]))
            step = ctypes.c_double(motion[timed[0]] if timed else 0.1)
            assert unit["DoStep"](one, ctypes.c_double(0.0), step, 1) == 0
            assert unit["GetReal"](one, outputs, ctypes.c_size_t(gives), row) == 0
            into[k] = row
    return answers


def _follow(name, law, exported=""):
    return FOLLOW.format(name=name, takes=len(law.motion), gives=len(law.answer), exported=exported)


def _run(folder, *command):
    done = subprocess.run([str(part) for part in command], cwd=folder, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr


def _followed(library, laws, motions):
    found = {}
    for name, law in laws.items():
        rows = np.ascontiguousarray(motions[name])
        found[name] = np.empty((*rows.shape[:2], len(law.answer)))
        places = (ctypes.c_void_p(part.ctypes.data) for part in (rows, found[name]))
        getattr(library, f"{name}_follow")(*places, *map(ctypes.c_int, rows.shape[:2]))
    return found
