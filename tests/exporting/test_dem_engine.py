"""The force model for DEM-Engine, compiled as C++ with what its kernel of forces defines, and stepped."""

from __future__ import annotations

import ctypes
import re
import shutil
import subprocess

import numpy as np
import pytest
from exported_laws import PROBLEMS

from winkler.exporting.choose import law_of
from winkler.exporting.export import export
from winkler.values.errors import InvalidInput

# What the kernel has where the model stands: see the source of DEM-Engine, calculateContactForces.
KERNEL = """
#include <cmath>
#include <cstdint>
#include <cstring>
#define __device__
struct float3 {{ float x, y, z; }};
static float3 operator*(float a, const float3 &b) {{ return {{a * b.x, a * b.y, a * b.z}}; }}
static void operator+=(float3 &a, const float3 &b) {{ a.x += b.x; a.y += b.y; a.z += b.z; }}
{prerequisites}
extern "C" float contact(double overlapDepth, float ARadius, float BRadius, float ts, float *wildcards) {{
    float3 B2A = {{0.0f, 1.0f, 0.0f}};
    float3 force = {{0.0f, 0.0f, 0.0f}};
    (void)ts; (void)wildcards;
    {acquire}
    {{ {model} }}
    {write}
    return force.y;
}}
"""


def stepped(folder, name, depths, radii):
    """Return the forces of a contact along depths."""
    if shutil.which("g++") is None:
        pytest.skip("no g++ here: install it to compile the force model")
    files = dict(export(PROBLEMS[name], "dem-engine", name=name).files)
    prerequisites, model = files[f"{name}_prerequisites.cu"], files[f"{name}_model.cu"]
    listed = re.search(r"SetPerContactWildcards\(\{(.*)\}\)", prerequisites)
    words = sorted(re.findall(r'"(\w+)"', listed[1])) if listed else []
    text = KERNEL.format(
        prerequisites=prerequisites,
        model=model.replace("\n", ""),  # as DEM-Engine joins the lines
        acquire=" ".join(f"float {word} = wildcards[{k}];" for k, word in enumerate(words)),
        write=" ".join(f"wildcards[{k}] = {word};" for k, word in enumerate(words)),
    )
    (folder / "model.cpp").write_text(text)
    command = ["g++", "-std=c++17", "-O0", "-Wall", "-Wno-unused-function", "-shared", "-fPIC", "model.cpp"]
    made = subprocess.run([*command, "-o", "model.so"], cwd=folder, capture_output=True, text=True, check=False)
    assert made.returncode == 0, made.stderr
    assert "warning" not in made.stderr, made.stderr
    library = ctypes.CDLL(str(folder / "model.so"))
    library.contact.restype = ctypes.c_float
    kept = (ctypes.c_float * 16)()
    radii = [ctypes.c_float(radius) for radius in radii]
    return np.array([library.contact(ctypes.c_double(d), *radii, ctypes.c_float(1e-6), kept) for d in depths])


@pytest.mark.slow
@pytest.mark.parametrize(
    ("name", "radii"),
    [("ball", (2e-3, 2e-3)), ("sticky", (2e-3, 2e-3)), pytest.param("powder", (1e-3, 1e15), marks=pytest.mark.slow)],
)
def test_the_force_model_does_what_the_law_does(tmp_path, name, radii):
    law = law_of(PROBLEMS[name], tolerance=1e-6, count=8)
    depths = np.concatenate([[np.max(law.trial) * 1e-2], law.trial[:, 0]])
    expected = law.trace(depths[:, np.newaxis])[:, 0]
    found = stepped(tmp_path, name, depths, radii)
    np.testing.assert_allclose(found, expected, rtol=1e-6, atol=1e-7 * np.max(np.abs(expected)))


@pytest.mark.slow
def test_two_particles_share_the_overlap_and_other_radii_have_no_force(tmp_path):
    law = law_of(PROBLEMS["powder"], tolerance=1e-6, count=8)
    found = stepped(tmp_path, "powder", [2e-6, 40e-6], (1e-3, 1e-3))
    np.testing.assert_allclose(found, law.trace(np.array([[1e-6], [20e-6]]))[:, 0], rtol=1e-6)
    assert np.all(np.isnan(stepped(tmp_path, "powder", [2e-6], (1e-3, 1.1e-3))))


def test_laws_with_much_memory_are_refused():
    with pytest.raises(InvalidInput, match=r"have no friction, but this one needs motion_x"):
        export(PROBLEMS["sheared"], "dem-engine")
    with pytest.raises(InvalidInput, match=r"stores \d+ single-precision values per contact, DEM-Engine at most 16"):
        export(PROBLEMS["gel"], "dem-engine", count=8)
