"""Kernels in C do what their Python source does, to the last bit."""

from __future__ import annotations

import importlib
import pkgutil

import numpy as np
import pytest
from compiled_c import interpreted, library, type_of
from kernel_histories import HISTORIES, history, outcome

import winkler.numerics
from winkler.exporting.translation.translate import Translation
from winkler.numerics.jit import Kernel
from winkler.values.errors import InvalidInput

FAST = ("-O2",)
SEEDS = range(10)
REFUSED = {"rolled", "mapped", "passages", "spread_loads", "surface_points", "_lagged", "_spread", "_summed",
           "_angle"}  # fmt: skip
"""Kernels of fields that leave the subset: they sort, or return arrays that they make."""
UNUSED = {"panel_value", "line_load", "echoed_points", "_folded", "fill_columns", "march", "smallest_balls",
          "advance_under_forces", "_put", "_curved", "follow_line", "follow_plane", "_stick_radius", "work_on_line",
          "_work_on_row", "work_in_plane", "_slipped", "_worked", "_held_row"}  # fmt: skip
"""Kernels of fields, of maps, of fits, of shakedown, of paths under forces and of whole histories, which no law calls:
not compared."""


@pytest.fixture(scope="module")
def translated(tmp_path_factory):
    kernels = {name: (kernel, history(name, 0)) for name, (kernel, _) in HISTORIES.items()}
    return library(tmp_path_factory.mktemp("strict"), kernels)


@pytest.fixture(scope="module")
def fast(tmp_path_factory):
    kernels = {name: (kernel, history(name, 0)) for name, (kernel, _) in HISTORIES.items()}
    return library(tmp_path_factory.mktemp("fast"), kernels, FAST)


def same(one, other):
    return all(np.array_equal(*pair, equal_nan=True) for pair in zip(one, other, strict=True))


@pytest.mark.parametrize(
    "name", [pytest.param(name, marks=pytest.mark.slow) if name == "corners_at" else name for name in HISTORIES]
)
def test_the_source_and_its_translation_agree_bit_by_bit(translated, name):
    plain = interpreted(HISTORIES[name][0])
    for seed in SEEDS:
        arguments = history(name, seed)
        assert same(outcome(translated[name], arguments), outcome(plain, arguments)), seed


@pytest.mark.few(0, slow=3)
@pytest.mark.parametrize("name", HISTORIES)
def test_a_thousand_histories_agree_bit_by_bit(translated, name):
    plain = interpreted(HISTORIES[name][0])
    for seed in range(100, 160):
        arguments = history(name, seed)
        assert same(outcome(translated[name], arguments), outcome(plain, arguments)), seed


@pytest.mark.parametrize("name", ["move_balls", "turn_balls", "march_line"])
def test_compiled_python_and_compiled_c_agree(fast, name):
    kernel = HISTORIES[name][0]
    for seed in SEEDS:
        arguments = history(name, seed)
        agree(outcome(fast[name], arguments), outcome(kernel, arguments))


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize("name", [name for name in HISTORIES if name not in ("move_balls", "turn_balls", "march_line")])
def test_compiled_python_and_compiled_c_agree_everywhere(fast, name):
    kernel = HISTORIES[name][0]
    for seed in range(20):
        arguments = history(name, seed)
        agree(outcome(fast[name], arguments), outcome(kernel, arguments))


def agree(one, other):
    for mine, theirs in zip(one, other, strict=True):
        np.testing.assert_allclose(mine, theirs, rtol=0.0, atol=1e-13 * np.max(np.abs(theirs), initial=0.0))


def all_kernels():
    """Return every kernel of the mathematics of the package."""
    found = {}
    for module in pkgutil.walk_packages(winkler.numerics.__path__, "winkler.numerics."):
        spec = module.module_finder.find_spec(module.name, None)
        if "@compiled\n" not in spec.loader.get_source(module.name):
            continue
        page = importlib.import_module(module.name)
        found |= {
            part: part for part in vars(page).values() if isinstance(part, Kernel) and page.__name__ == part.__module__
        }
    return list(found)


@pytest.mark.slow
def test_every_kernel_is_translated_or_known_to_be_left_out():
    translation = Translation()
    for name, (kernel, _) in HISTORIES.items():
        translation.routine(kernel, tuple(map(type_of, history(name, 0))))
    done = {kernel.function for kernel, _ in translation.routines}
    left = {kernel.__name__ for kernel in all_kernels() if kernel.function not in done}
    assert left == REFUSED | UNUSED


@pytest.mark.parametrize("name", ["rolled", "passages"])
def test_what_is_refused_names_its_place(name):
    from winkler.numerics.springs import fastsim

    kernel = getattr(fastsim, name)
    arguments = {"rolled": (np.zeros((1, 4)), np.ones((1, 5)), 5, np.zeros((1, 4))), "passages": (5,)}[name]
    with pytest.raises(InvalidInput, match=r"winkler/numerics/springs/fastsim\.py:\d+: an array is returned; "):
        Translation().routine(kernel, tuple(map(type_of, arguments)))
