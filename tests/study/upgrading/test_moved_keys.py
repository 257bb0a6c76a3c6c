"""Keys of version 0.2 that stand in a table of their own today: in sweeps and settings, too."""

from pathlib import Path

from winkler.study.language.catalogue import in_present_kinds
from winkler.study.language.reading import parse_study, read_study

KEPT = Path(__file__).with_name("version_0_2")
ELLIPTIC = KEPT / "elliptic_flash.toml"


def test_a_sweep_over_a_key_that_moved_is_that_of_today():
    study = parse_study(ELLIPTIC.read_text(encoding="utf-8"))
    assert [axis.key for axis in study.sweep] == ["problem.contact.load.force"]


def test_a_setting_of_a_key_that_moved_counts():
    study = read_study(ELLIPTIC, settings=["problem.load.force=30 kN", "problem.medium.first.young=100 GPa"])
    assert study.problem.contact.load.force == 30e3
    assert study.problem.contact.medium.first.young == 100e9
    assert study.problem.contact.medium.first.poisson == 0.28


def test_a_key_with_another_name_counts_in_sweeps_and_settings():
    study = read_study(KEPT / "slipping_wheel.toml", settings=["problem.rolling.load.force=60 kN"])
    assert [axis.key for axis in study.sweep] == ["problem.contact.speed"]
    assert study.problem.contact.load.force == 60e3


def test_words_of_other_problems_stay():
    table = {"problem": {"kind": "indentation", "bed": {"kind": "foundation"}}, "sweep": {"problem.bed.x": [1.0]}}
    assert in_present_kinds(table) == table
    beside = {"problem": {"kind": "transient_heating"}, "sweep": {"problem.bedding": 1.0, "problem.speed": 2.0}}
    assert in_present_kinds(beside) == beside
