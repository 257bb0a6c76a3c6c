"""States of wear in a file: the same to the last digit, and never half written."""

import numpy as np
import pytest

import winkler as wk
from winkler.io.wear_states import read_wear, write_wear

MEDIUM = wk.HalfSpace(wk.Elastic(young=1.0, poisson=0.3))
BED = wk.Foundation(wk.Paraboloid(1.0), MEDIUM)
FRETTING = wk.FrettingWear(
    BED, wk.Archard(0.1), wk.Coulomb(0.5), wk.Depth(0.01), wk.Shift(0.004), np.array([0.0, 1.0, 10.0, 50.0]), count=30
)
SLIDING = wk.SlidingWear(BED, wk.Archard(0.1), wk.Force(1e-3), np.array([0.0, 1.0, 10.0, 50.0]), count=30)


@pytest.mark.few(1)
@pytest.mark.parametrize("problem", [FRETTING, SLIDING], ids=["fretting", "sliding"])
def test_a_march_goes_on_from_a_file_with_the_same_numbers(problem, tmp_path):
    whole = list(problem.steps())
    path = write_wear(whole[:3], tmp_path / "worn.npz")
    states = read_wear(path, BED)
    assert list(states) == whole[:3]
    assert list(problem.steps(start=states[-1])) == whole[3:]
    assert [each.name for each in tmp_path.iterdir()] == ["worn.npz"]


def test_what_is_no_such_file_is_refused(tmp_path):
    with pytest.raises(wk.InvalidInput, match=r"none\.npz: there is no such file"):
        read_wear(tmp_path / "none.npz", BED)
    spoilt = tmp_path / "spoilt.npz"
    spoilt.write_bytes(b"PK half a file")
    with pytest.raises(wk.InvalidInput, match="no wear can be read"):
        read_wear(spoilt, BED)
    other = tmp_path / "other.npz"
    np.savez(other, format=np.array("winkler wear 0"), kind=np.array("sliding"))
    with pytest.raises(wk.InvalidInput, match="it does not hold 'winkler wear 2'"):
        read_wear(other, BED)
    with pytest.raises(wk.InvalidInput, match=r"give bed=problem\.bed"):
        read_wear(write_wear([next(SLIDING.steps())], tmp_path / "worn.npz"))


def test_what_cannot_be_written_is_refused(tmp_path):
    with pytest.raises(wk.InvalidInput, match="at least one"):
        write_wear([], tmp_path / "worn.npz")
    state = next(SLIDING.steps())
    with pytest.raises(wk.InvalidInput, match="cannot be written"):
        write_wear([state], tmp_path / "nowhere" / "worn.npz")
