"""The model files for nanite: against closed forms, and loaded and fitted by nanite where it is installed."""

import importlib
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

FOLDER = Path(__file__).parents[2] / "examples" / "exchange"
NAMES = ("film", "measured_tip", "jkr")
RADIUS = 5e-6


@pytest.fixture
def model(monkeypatch):
    monkeypatch.syspath_prepend(FOLDER)
    return lambda name: importlib.import_module(f"nanite_model_{name}")


@pytest.mark.parametrize("name", NAMES)
def test_what_nanite_asks_of_a_model(model, name):
    """Keys, names and units of one length, in the order of the arguments of the function."""
    module = model(name)
    arguments = module.model_func.__code__.co_varnames[: module.model_func.__code__.co_argcount]
    assert list(arguments[1:]) == module.parameter_keys
    assert len(module.parameter_keys) == len(module.parameter_names) == len(module.parameter_units)
    assert len(set(module.parameter_names)) == len(module.parameter_names)
    assert module.valid_axes_x == ["tip position"]


def test_a_thin_penetration_of_a_film(model):
    """Dimitriadis et al., Biophys. J. 82 (2002) 2798, doi:10.1016/S0006-3495(02)75620-8, Eq. 14: bonded, nu = 0.5."""
    depth, thickness = np.array([10e-9, 40e-9, 160e-9]), 10e-6
    force = model("film").bonded_film(3e-7 - depth, 1e3, RADIUS, 0.5, thickness, contact_point=3e-7, baseline=1e-12)
    chi = np.sqrt(RADIUS * depth) / thickness
    series = 1 + 1.133 * chi + 1.283 * chi**2 + 0.769 * chi**3 + 0.0975 * chi**4
    hertz = 16 / 9 * 1e3 * np.sqrt(RADIUS) * depth**1.5
    np.testing.assert_allclose(force - 1e-12, hertz * series, rtol=2e-3)


def test_jkr_by_its_closed_form(model):
    """d = a^2/R - sqrt(2 pi w a/E*), F = 4 E* a^3/(3 R) - sqrt(8 pi w E* a^3); nothing once contact is lost."""
    young, work = 2e3, 3e-5
    modulus = young / 0.75
    radius = np.linspace(0.2e-6, 6e-6, 4000)
    depth = radius**2 / RADIUS - np.sqrt(2 * np.pi * work * radius / modulus)
    force = 4 * modulus * radius**3 / (3 * RADIUS) - np.sqrt(8 * np.pi * work * modulus * radius**3)
    stable = slice(int(np.argmin(depth)) + 10, None)
    found = model("jkr").jkr_retraction(
        1e-7 - depth[stable], young, RADIUS, 0.5, work, contact_point=1e-7, baseline=2e-9
    )
    np.testing.assert_allclose(found - 2e-9, force[stable], atol=1e-5 * np.ptp(force))
    lost = model("jkr").jkr_retraction(
        np.array([1e-7 - 1.01 * depth.min()]), young, RADIUS, 0.5, work, contact_point=1e-7
    )
    assert lost == 0.0


def test_the_measured_tip_is_a_ball_and_a_cone(model):
    """The table was made from a ball of 120 nm with a tangent cone; its scatter is 0.2 nm."""
    depth = np.array([20e-9, 30e-9])
    force = model("measured_tip").measured_tip(-depth, 1e5, 0.5)
    np.testing.assert_allclose(force, 16 / 9 * 1e5 * np.sqrt(120e-9) * depth**1.5, rtol=0.05)
    with pytest.warns(UserWarning, match="the tip is known to a depth of 2.. nm; fit a shallower range"):
        model("measured_tip").measured_tip(np.array([-4e-7]), 1e5, 0.5)


@pytest.mark.parametrize("name", NAMES)
def test_in_nanite(name, monkeypatch):
    """nanite loads the file, and finds the numbers with which a curve was made."""
    nanite_model = pytest.importorskip("nanite.model")
    lmfit = pytest.importorskip("lmfit")
    monkeypatch.syspath_prepend(FOLDER)
    sys.modules.pop(f"nanite_model_{name}", None)
    loaded = nanite_model.load_model_from_file(FOLDER / f"nanite_model_{name}.py", register=True)
    truth = {"film": {"E": 2e3}, "measured_tip": {"E": 9e4}, "jkr": {"E": 2e3, "work": 3e-5}}[name]
    reach = 1.5e-7 if name == "measured_tip" else 1e-6
    tip = np.linspace(reach, -reach, 400)
    parameters = loaded.get_parameter_defaults()
    for key, number in truth.items():
        parameters[key].value = number
    force = loaded.model(parameters, tip)
    for key, number in truth.items():
        parameters[key].value = 0.6 * number
    found = lmfit.minimize(loaded.residual, parameters, args=(tip, force, 0)).params
    for key, number in truth.items():
        assert found[key].value == pytest.approx(number, rel=2e-3)
    assert found["contact_point"].value == pytest.approx(0.0, abs=2e-3 * reach)


@pytest.mark.slow
def test_the_models_are_installed_as_one_package(tmp_path):
    """Built and installed by pip into a folder of its own, far from the examples; nanite then knows the models."""
    pytest.importorskip("nanite.model")
    pytest.importorskip("hatchling", reason="no hatchling here: pip install winkler[checks]")
    source, place = tmp_path / "source", tmp_path / "installed"
    shutil.copytree(FOLDER, source)
    pip = [sys.executable, "-m", "pip", "install", "--quiet", "--no-index", "--no-deps", "--no-build-isolation"]
    subprocess.run([*pip, "--target", str(place), str(source)], check=True)
    assert sorted(path.name for path in place.glob("*.py")) == [
        f"nanite_model_{one}.py" for one in ("film", "jkr", "measured_tip", "winkler")
    ]
    table = FOLDER.parent / "data" / "measured_tip.csv"
    code = f"""
import sys
sys.path.insert(0, {str(place)!r})
import nanite_model_winkler as plugin, nanite.model, numpy, winkler
assert plugin.__file__.startswith({str(place)!r})
try:
    plugin.register("none.csv")
except (winkler.WinklerError, OSError) as error:
    print(error)
assert not [key for key in nanite.model.models_available if "winkler" in key]
assert sorted(plugin.register()) == ["winkler_film", "winkler_jkr"]
assert "winkler_measured_tip" not in nanite.model.models_available
made = plugin.register({str(table)!r})
for key, model in made.items():
    assert nanite.model.models_available[key] is model
    parameters = nanite.model.get_init_parms(key)
    assert numpy.ptp(model.model(parameters, numpy.linspace(1e-7, -1e-7, 50))) > 0.0
print(sorted(made))
"""
    done = subprocess.run([sys.executable, "-c", code], cwd=tmp_path, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    refused, names = done.stdout.splitlines()
    assert "none.csv" in refused
    assert names == "['winkler_film', 'winkler_jkr', 'winkler_measured_tip']"
