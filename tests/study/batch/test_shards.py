"""Shards of a sweep: solved apart, also after a kill, they become what one run writes."""

from __future__ import annotations

import json

import numpy as np
import pytest
import xarray as xr

from winkler.cli import main
from winkler.study.batch.shards import Shard
from winkler.values.errors import InvalidInput

STUDY = """title = "Balls"

[problem]
kind = "indentation"
load = { kind = "force", force = "100 N" }

[problem.bed]
kind = "foundation"
profile = { kind = "paraboloid", curvature_radius = "10 mm" }
medium = { kind = "half_space", first = { kind = "elastic", young = "210 GPa", poisson = 0.3 } }

[sweep]
"problem.load.force" = ["1 N", "-1 N", "2 N", "5 N", "7 N"]
"problem.bed.profile.curvature_radius" = ["1 mm", "2 mm"]

[output]
figures = []
report = false
"""


@pytest.fixture
def here(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "balls.toml").write_text(STUDY, encoding="utf-8")
    return tmp_path


def hidden(folder):
    return sorted(path.name for path in folder.iterdir() if path.name.startswith("."))


def test_shards_share_all_points_once():
    for size, count in ((10, 3), (4, 7), (12, 12)):
        shares = [~Shard(number, count).others(size) for number in range(1, count + 1)]
        assert np.sum(shares, axis=0).tolist() == [1] * size


@pytest.mark.parametrize("text", ["", "2", "0/3", "4/3", "1/0", "a/b", "1/3/5", "-1/3", "1/1000000"])
def test_what_is_no_shard_is_refused(text):
    with pytest.raises(InvalidInput, match="shard: .* such as 2/8"):
        Shard.read(text)


def test_shards_that_are_put_together_are_what_one_run_writes(here, capsys):
    whole_code = main(["run", "balls.toml", "--output", "whole/balls"])
    assert whole_code == 4  # the point that pulls has no answer
    assert main(["run", "balls.toml", "--shard", "3/3", "--output", "parts/balls"]) in (0, 4)
    assert main(["merge", "balls.toml", "--output", "parts/balls"]) == 2
    message = capsys.readouterr().err
    assert "merge: 7 of 10 points are in none of the 1 shards" in message
    assert "that of --shard 1/3." in message
    assert not (here / "parts" / "balls").exists()
    for number in (1, 2):
        assert main(["run", "balls.toml", "--shard", f"{number}/3", "--output", "parts/balls"]) in (0, 4)
    # a shard that was killed while it wrote its last line goes on from the line before
    journal = here / "parts" / ".balls.shard-2-of-3.journal"
    complete = journal.read_bytes()
    journal.write_bytes(complete[:-5])
    assert main(["merge", "balls.toml", "--output", "parts/balls"]) == 2
    assert "1 of 10 points are in none of the 3 shards" in capsys.readouterr().err
    assert main(["run", "balls.toml", "--shard", "2/3", "--output", "parts/balls"]) in (0, 4)
    assert journal.read_bytes() == complete
    assert main(["merge", "balls.toml", "--output", "parts/balls"]) == whole_code
    whole, parts = here / "whole" / "balls", here / "parts" / "balls"
    for name in ("results.csv", "study.toml"):
        assert (parts / name).read_bytes() == (whole / name).read_bytes()
    with xr.open_dataset(parts / "results.nc") as mine, xr.open_dataset(whole / "results.nc") as theirs:
        assert mine.equals(theirs)
    made = [json.loads((one / "provenance.json").read_text(encoding="utf-8")) for one in (whole, parts)]
    assert made[0]["hash"] == made[1]["hash"]
    assert not [name for name in hidden(here / "parts") if "shard" in name or name.endswith(".journal")]


def test_a_shard_of_another_study_is_refused(here, capsys):
    assert main(["run", "balls.toml", "--shard", "1/2"]) in (0, 4)
    assert main(["run", "balls.toml", "--shard", "2/2", "--set", "problem.bed.medium.first.poisson=0.2"]) in (0, 4)
    assert main(["merge", "balls.toml"]) == 2
    assert "shard-2-of-2.journal' holds points of another study" in capsys.readouterr().err


def test_a_study_without_a_sweep_has_no_shards(here, capsys):
    (here / "one.toml").write_text(STUDY.partition("[sweep]")[0], encoding="utf-8")
    assert main(["run", "one.toml", "--shard", "1/2"]) == 2
    assert "the study has no sweep; leave --shard out." in capsys.readouterr().err
