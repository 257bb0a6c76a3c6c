"""What files are taken for, what is doubtful of them, and the studies to start from."""

from __future__ import annotations

import re

import numpy as np
import pytest
from made_files import DATA, made_files, table

from winkler.cli import main
from winkler.io.tables.relaxation_table import read_dynamic
from winkler.study.inspection import inspect
from winkler.study.inspection.inspect import inspect_file, inspect_files
from winkler.study.inspection.surfaces import SurfaceOptions
from winkler.values.errors import InvalidInput


def test_each_kind_is_recognised(tmp_path):
    files = made_files(tmp_path)
    assert {path.name: inspect_file(path, brief=True).taken_for for path in files} == {
        path.name: kind for path, kind in files.items()
    }


def test_each_recognised_kind_has_columns_with_units(tmp_path):
    for path in made_files(tmp_path):
        found = inspect_file(path, brief=True)
        assert found.columns, path
        for column in found.columns:
            assert column.meaning, (path, column.name)
            assert column.low <= column.high, (path, column.name)
            assert 3 <= len(column.sparkline) <= 32, (path, column.name)
    pressed = inspect_file(tmp_path / "path.csv")
    assert [column.name for column in pressed.columns] == ["time", "force", "shift"]
    shift = pressed.column("shift")
    assert (shift.unit, shift.low, shift.high) == ("m", pytest.approx(-1e-6, rel=1e-2), pytest.approx(1e-6, rel=1e-2))


KINDS = (
    "moduli.csv", "sweeps.csv", "relaxing.csv", "creeping.csv", "relaxing_sweeps.csv", "density.csv", "path.csv",
    "twist.csv", "pressures.csv", "graded.csv", "bed.csv", "body.csv", "scan.csv", "map.npz", "rail_head.prr",
    "wheel_tread.csv", "gel_bead.csv", "steel_1.csv",
)  # fmt: skip


@pytest.mark.slow
@pytest.mark.parametrize("name", KINDS)
def test_each_study_to_start_from_runs_as_it_is(name, tmp_path, capsys):
    path = next(one for one in made_files(tmp_path) if one.name == name)
    study = tmp_path / "studies" / "study.toml"
    study.parent.mkdir()
    assert main(["show", str(path), "--write", str(study)]) == 0
    command = capsys.readouterr().out.rpartition("run it with: winkler ")[2].split()
    assert main([*command, "--output", str(tmp_path / "results"), "--quiet"]) == 0
    assert (tmp_path / "results").is_dir()
    assert main(["show", str(path), "--write", str(study)]) == 2
    assert f"show: '{study}' exists; add --overwrite to replace it" in capsys.readouterr().err


def test_only_area_functions_and_single_holds_have_no_study(tmp_path):
    without = [path.name for path in made_files(tmp_path) if not inspect_file(path, brief=True).study]
    assert without == ["tip_area.csv", "narrow.csv"]


def _curve(tmp_path, force):
    x = np.linspace(-500.0, 500.0, 400)
    time = np.linspace(0.0, 1.0, 400)
    return table(tmp_path / "curve.csv", "time [s], depth [nm], force [nN]", time, x, force(x))


def _hertz(x):
    return 1e-3 * np.maximum(x, 0.0) ** 1.5 + 0.02 * np.random.default_rng(2).normal(size=x.size)


def test_a_good_curve_has_no_doubts_and_its_events(tmp_path):
    found = inspect_file(_curve(tmp_path, _hertz))
    assert found.taken_for == "force curve"
    assert "depth from 'depth [nm]'" in found.reason
    assert found.doubts == ()
    assert any("baseline before contact" in line for line in found.done)


@pytest.mark.parametrize(
    ("spoil", "sentence"),
    [
        (lambda x: np.where(np.arange(x.size) == 123, 300.0, _hertz(x)), "force: 1 single number far from both"),
        (lambda x: np.where(np.arange(x.size) % 90 == 3, -9999.0, _hertz(x)), "force: 5 of 400 numbers are"),
        (lambda x: _hertz(x - 600.0), "no contact"),
    ],
    ids=["spike", "mark", "nothing"],
)
def test_what_is_doubtful_of_a_curve(spoil, sentence, tmp_path):
    assert sentence in " ".join(inspect_file(_curve(tmp_path, spoil), brief=True).doubts)


def test_a_sign_that_is_changed_is_named_and_leaves_no_doubt(tmp_path):
    found = inspect_file(_curve(tmp_path, lambda x: -_hertz(x)))
    assert "the contact is pressed by negative forces, whose sign is changed" in found.reason
    assert found.doubts == ()
    assert any("baseline before contact" in line for line in found.done)


def test_a_nanoindentation_needs_no_baseline():
    found = inspect_file(DATA / "nanoindentation" / "silica_1.csv", brief=True)
    assert found.taken_for == "nanoindentation"
    assert found.doubts == ()


def test_a_file_that_cannot_be_read_says_what_its_reader_needs(tmp_path):
    path = table(tmp_path / "piezo.csv", "piezo [nm], deflection [nm]", np.arange(20.0), np.arange(20.0))
    found = inspect_file(path)
    assert not found.is_read
    assert "give spring_constant in N/m" in found.reason
    rows = np.column_stack((np.arange(30.0), np.cos(np.arange(30.0))))
    np.savetxt(tmp_path / "bare.txt", rows)
    assert "give its unit" in inspect_file(tmp_path / "bare.txt").reason
    scan = table(tmp_path / "scan.csv", "X_(microns),y1", *rows.T)
    assert "force curve" not in inspect_file(scan).reason
    assert "unit" in inspect_file(scan).reason
    with pytest.raises(InvalidInput, match="there is no such file"):
        inspect_file(tmp_path / "absent.csv")


def test_what_its_header_calls_a_curve_is_given_to_no_reader_of_surfaces(tmp_path, monkeypatch):
    """They took 3 s to load, and 40 ms to refuse each of the curves of a folder."""
    monkeypatch.setattr(inspect, "read_surface_file", lambda *_: pytest.fail("a reader of surfaces was tried"))
    path = table(tmp_path / "piezo.csv", "piezo [nm], force [nN]", np.arange(20.0), np.arange(20.0))
    found = inspect_file(path)
    assert not found.is_read
    assert found.reason.startswith(f"{path}: read as force curve: ")
    assert "give spring_constant in N/m" in found.reason


def test_files_in_toml_are_calibrated_indenters_or_studies(tmp_path):
    tip = tmp_path / "tip.toml"
    tip.write_text(
        'kind = "calibrated_indenter"\narea = [24.5, 1e-7]\nframe_compliance = 1e-7\nyoung = 1.141e12\npoisson = 0.07\n'
    )
    found = inspect_file(tip)
    assert found.taken_for == "calibrated indenter"
    assert found.done == ("area coefficients 24.5, 1e-07 (SI)", "frame compliance 100 nm/N")
    tip.write_text('[problem]\nkind = "indentation"\n')
    assert not inspect_file(tip).is_read
    assert "if it is a study, solve it by `winkler run`" in inspect_file(tip).reason


def test_a_list_reads_what_it_can(tmp_path):
    good = _curve(tmp_path, _hertz)
    bad = tmp_path / "bad.csv"
    bad.write_text("no numbers at all\n")
    found = dict(inspect_files([good, bad, tmp_path / "absent.csv"], 60.0))
    assert [found[place].taken_for for place in range(3)] == ["force curve", "", ""]
    assert found[2].reason.startswith("it cannot be read")
    assert len(dict(inspect_files([good] * 5, -1.0))) == 1


@pytest.mark.slow
def test_many_files_are_read_by_several_processes(tmp_path):
    good = _curve(tmp_path, _hertz)
    found = dict(inspect_files([good] * 120, 600.0))
    assert sorted(found) == list(range(120))
    assert {one.taken_for for one in found.values()} == {"force curve"}


@pytest.mark.parametrize(
    ("header", "doubted"),
    [
        ("Frequency (Hz),Storage Modulus (MPa),Loss Modulus (MPa)", True),
        ("Frequency (Hz),Storage Modulus (MPa),Loss Modulus (MPa),Torque (uN.m)", False),
        ("Frequency (Hz),G' (MPa),G'' (MPa)", False),
    ],
)
def test_moduli_of_a_dma_are_doubted(header, doubted, tmp_path):
    """A storage modulus is that of shear by its name alone, and a DMA measures that of tension."""
    rows = [f"{f:g},{10 + f:g},{1 + f:g}" + ",1" * (header.count(",") - 2) for f in (0.1, 1.0, 10.0, 100.0)]
    path = tmp_path / "dma.csv"
    path.write_text("\n".join([header, *rows]) + "\n", encoding="utf-8")
    found = inspect_file(path)
    assert found.taken_for == "storage and loss"
    assert any("name it tensile_storage" in one for one in found.doubts) == doubted


def test_an_area_beside_a_curve_is_no_area_function(tmp_path):
    """Instruments write the area of each point beside depth and load; beside results it is doubted, or a list."""
    depth = np.concatenate([np.linspace(1.0, 100.0, 60), np.linspace(99.0, 60.0, 40)])
    load = np.where(np.arange(100) < 60, 1e-3 * depth**2, 10.0 * ((depth - 50.0) / 50.0).clip(0.0) ** 1.5)
    path = tmp_path / "test.csv"
    rows = [f"{h:.6g},{p:.6g},{24.5 * h**2:.6g}" for h, p in zip(depth, load, strict=True)]
    path.write_text("\n".join(["depth [nm],load [uN],area [nm^2]", *rows]) + "\n", encoding="utf-8")
    assert inspect_file(path).taken_for in ("force curve", "nanoindentation")
    rng = np.random.default_rng(1)
    head, depths = "hc [nm],hardness [GPa],A [nm^2]", np.linspace(50.0, 900.0, 40)
    for listed in (depths, rng.permutation(depths)):
        rows = [f"{h:.6g},{rng.uniform(1.0, 9.0):.3g},{24.5 * h**2:.6g}" for h in listed]
        path.write_text("\n".join([head, *rows]) + "\n", encoding="utf-8")
        found = inspect_file(path)
        if listed is depths:
            assert found.taken_for == "area function of a tip"
            assert any("names a hardness too, as a list of results does" in one for one in found.doubts)
        else:
            assert not found.is_read
            assert "its rows are no curve but a list, for 'hc [nm]' and 'A [nm^2]' do not go on" in found.reason


def test_a_jump_of_the_position_is_doubted(tmp_path):
    """A way back that is written from its end, without a word that says so, is a jump over the whole travel."""
    place = np.linspace(0.0, 900.0, 100)
    force = 1e-4 * (place - 600.0).clip(0.0) ** 1.5
    rows = [f"{z:g},{f:.9g}" for z, f in zip([*place, *place], [*force, *force], strict=True)]
    path = tmp_path / "curve.csv"
    path.write_text("\n".join(["depth [nm],force [nN]", *rows]) + "\n", encoding="utf-8")
    found = inspect_file(path)
    assert found.taken_for == "force curve"
    assert any("a jump of 900 nm behind row 100" in one for one in found.doubts)


def test_bounces_begin_a_search_for_a_relaxation_time(tmp_path):
    """The study sweeps what takes the energy; its speed is that of the first flight, and it runs as it stands."""
    from winkler.study.language.reading import read_study

    times = _bounces(np.full(13, 0.85))
    (tmp_path / "log.csv").write_text("\n".join(["bounce [s]", *(f"{one:.9g}" for one in times)]) + "\n")
    study = inspect_file(tmp_path / "log.csv").study
    assert "whose times give e = 0.85 ±" in study
    assert f'velocity = "{0.5 * 9.81 * (times[1] - times[0]):.4g} m/s"' in study
    (tmp_path / "study.toml").write_text(study)
    assert read_study(tmp_path / "study.toml")


def _bounces(restitution):
    """Times of bounces whose coefficients follow each other."""
    return np.concatenate([[0.0], np.cumsum(0.6 * np.cumprod(np.concatenate([[1.0], restitution])))])


@pytest.mark.parametrize("changes", [False, True])
def test_a_restitution_that_changes_is_doubted(changes, tmp_path):
    """A viscous ball loses more at high speed; one number for all of its bounces is none of it."""
    rng = np.random.default_rng(3)
    times = _bounces(np.linspace(0.80, 0.90, 13) if changes else np.full(13, 0.85)) + rng.normal(0.0, 1e-4, 15)
    found = inspect_file(table(tmp_path / "ball.csv", "bounce time [s]", times))
    assert found.taken_for == "bounces by their times"
    said = [one for one in found.doubts if "not the same in all bounces" in one]
    assert len(said) == changes
    if changes:
        early, late = (float(word) for word in re.findall(r"(0\.\d+) ±", said[0]))
        assert 0.79 < early < 0.85 < late < 0.90


def test_a_pin_states_its_wear_by_area_and_force(tmp_path):
    """k = V / (F s): of a pin of 2 mm^2 under 10 N that loses 5 um over 100 m it is 1e-14 /Pa."""
    from winkler.io.logs.log_tables import read_pin

    way = np.linspace(0.0, 200.0, 201)
    path = table(tmp_path / "pin.csv", "distance [m], wear depth [um]", way, 0.05 * way)
    assert "k = V / (F s) = 5e-08 A/F" in " ".join(inspect_file(path).done)
    assert read_pin(path).wear_coefficient(2e-6, 10.0).value == pytest.approx(5e-6 * 2e-6 / (10.0 * 100.0), rel=1e-6)


def test_a_pin_whose_log_has_times_needs_the_speed(tmp_path):
    """The clock of the second step begins again; 20 s at 0.5 m/s are 10 m.  A total time stands below the rows."""
    from winkler.io.logs.log_tables import read_pin

    clock = np.concatenate([np.arange(1.0, 11.0), np.arange(1.0, 11.0)])
    path = table(
        tmp_path / "pin.csv", "Step, Timestamp [s], DAQ.COF ()", np.repeat([1.0, 2.0], 10), clock, 0 * clock + 0.3
    )
    with path.open("a") as file:
        file.write("\nTotalTime\n00:00:20.5\n")
    assert "give speed, that of sliding in m/s" in inspect_file(path).reason
    log = read_pin(path, speed=0.5)
    np.testing.assert_allclose(log.distance, 0.5 * np.arange(1.0, 21.0))
    assert log.steady_friction.value == pytest.approx(0.3)
    with path.open("a") as file:
        file.write("21.0\n")
    with pytest.raises(InvalidInput, match="the line has 1 and the header 3 cells"):
        read_pin(path, speed=0.5)
    way = table(tmp_path / "way.csv", "distance [m], cof", clock, clock)
    with pytest.raises(InvalidInput, match="its header names a distance; leave speed out"):
        read_pin(way, speed=0.5)


def test_heights_without_places_need_the_length(tmp_path):
    heights = np.sin(np.arange(400.0) / 9.0)
    path = table(tmp_path / "scan.txt", "Point, Raw [um], Rough [um]", np.arange(400.0), heights, 2.0 * heights)
    assert "its header names heights and no places; give --lengths '4 mm'" in inspect_file(path).reason
    for channel, scale in (("", 1e-6), ("Rough", 2e-6)):
        found = inspect_file(path, SurfaceOptions(lengths="4 mm", channel=channel))
        assert found.taken_for == "line scan"
        assert not found.study
        np.testing.assert_allclose(found.content.position, np.linspace(0.0, 4e-3, 400), atol=1e-12)
        np.testing.assert_allclose(found.content.heights, scale * heights, atol=1e-15)


def test_a_table_of_bare_numbers_may_be_a_curve_or_moduli(tmp_path):
    path = tmp_path / "bare.csv"
    np.savetxt(path, np.random.default_rng(3).uniform(1.0, 2.0, (12, 7)), delimiter=",")
    assert "of a table without names: give columns = {" in inspect_file(path).reason


def test_moduli_over_strain_are_no_curve(tmp_path):
    row = np.linspace(1.0, 9.0, 8)
    path = table(tmp_path / "strain.csv", "Strain [%], Storage Modulus [Pa], Loss Modulus [Pa]", row, row, row)
    assert "its header names moduli and no frequency" in inspect_file(path).reason


def test_a_sweep_of_strain_is_no_path(tmp_path):
    """Rheometers write normal force and torque beside the moduli."""
    rows = [np.arange(8.0), np.full(8, 3.0), np.linspace(1.0, 9.0, 8), np.linspace(9.0, 1.0, 8), np.ones(8)]
    head = "time [s], normal force [N], torque [mN m], storage modulus [Pa], strain [%]"
    found = inspect_file(table(tmp_path / "sweep.csv", head, *rows))
    assert found.taken_for == "path"
    assert any("no path of a contact" in one for one in found.doubts)


def rheometer(path, rows):
    """A table as a rheometer writes it: moduli, gap and normal force; `rows` are t, G', G'', f, F_n and h."""
    lines = ["t in s;G' in Pa;G'' in Pa;f in Hz;Fn in N;h in mm;T in °C"]
    lines += [";".join("" if one is None else f"{one:.6g}" for one in (*row, 37.0 + 1e-3 * (k % 7))) for k, row in
              enumerate(rows)]  # fmt: skip
    path.write_text("\n".join(lines), encoding="utf-8")
    return path


def test_a_sweep_of_strain_over_a_gap_that_stays_is_no_curve(tmp_path):
    stays = [(16.0 * k, 900.0, 65.0, 1.0, 0.3 - 0.01 * k, 1.5087 + 1e-6 * (k % 3)) for k in range(25)]
    found = inspect_file(rheometer(tmp_path / "strain.csv", stays))
    assert not found.is_read
    assert "all of its 25 rows have one frequency, 6.283 rad/s" in found.reason
    moves = [(*row[:5], 4.0 - 0.1 * k) for k, row in enumerate(stays)]
    assert inspect_file(rheometer(tmp_path / "moves.csv", moves)).taken_for == "force curve"


def test_columns_of_moduli_without_numbers_name_no_moduli(tmp_path):
    gaps = np.linspace(2.0, 1.5, 40)
    pressed = [(0.1 * k, 0.0, 0.0, 0.0, 3.0 * (2.0 - gap) ** 1.5, gap) for k, gap in enumerate(gaps.tolist())]
    found = inspect_file(rheometer(tmp_path / "compression.csv", pressed))
    assert not found.is_read
    assert "give columns = { gap = 6, force = 5 }" in found.reason


def test_the_first_of_several_sweeps_is_read_and_its_study_runs(tmp_path, capsys):
    omegas = np.geomspace(0.1, 100.0, 12).tolist()
    first = [(k, 1000.0 * omega**0.2, 100.0, omega, 0.1, 1.5) for k, omega in enumerate(omegas)]
    rest = [(100 + k, None, None, None, 0.02, 1.5) for k in range(8)]
    again = [(200 + k, 500.0 * omega**0.2, 100.0, omega, 0.1, 1.5) for k, omega in enumerate(omegas)]
    path = rheometer(tmp_path / "recovery.csv", [*first, *rest, *again])
    found = inspect_file(path)
    assert (found.taken_for, found.count) == ("storage and loss", 2)
    assert found.column("storage_shear").high == pytest.approx(1000.0 * 100.0**0.2, rel=1e-3)
    study = tmp_path / "study.toml"
    assert main(["show", str(path), "--write", str(study)]) == 0
    assert "test = 1" in study.read_text(encoding="utf-8")
    assert main(["run", str(study), "--output", str(tmp_path / "results"), "--quiet"]) == 0
    capsys.readouterr()


def test_a_sweep_at_one_scattering_temperature_is_one_sweep(tmp_path):
    omegas = np.geomspace(0.1, 100.0, 12).tolist()
    rows = [(k, 1000.0 * omega**0.2, 100.0, omega, 0.1, 1.5) for k, omega in enumerate(omegas)]
    assert inspect_file(rheometer(tmp_path / "sweep.csv", rows)).taken_for == "storage and loss"


def test_bare_numbers_are_told_how_curves_and_moduli_are_named(tmp_path):
    path = tmp_path / "bare.csv"
    path.write_text("".join(f"{0.1 * 2**k:.6g},{0.8 + 0.1 * k:.6g},{0.1 + 0.02 * k:.6g}\n" for k in range(9)))
    reason = inspect_file(path).reason
    assert "give columns = { position = 1, force = 2 }" in reason
    named = re.search(r'of moduli give header = "(.*)"', reason)
    assert named
    assert read_dynamic(path, header=named[1]).storage_shear[-1] == pytest.approx(1.6e3)


def test_a_force_that_falls_over_the_whole_way_in_is_doubted(tmp_path):
    """A microscope's curve through 13 um of air: -15 nN at its end, and nothing was said."""
    way = np.linspace(0.0, 13e3, 400)
    noise = np.random.default_rng(8).normal(0.0, 0.01, 800)
    drift = np.append(-way / 1e3, -way[::-1] / 1e3) + noise
    segment = np.repeat([0.0, 1.0], 400)
    header = "depth [nm], force [nN], segment"
    path = table(tmp_path / "air.csv", header, np.append(way, way[::-1]), drift, segment)
    assert any("falls during the whole approach, by" in doubt for doubt in inspect_file(path).doubts)
    pressed = drift + np.append(np.maximum(way - 12e3, 0.0), np.maximum(way[::-1] - 12e3, 0.0)) / 10.0
    path = table(tmp_path / "gel.csv", header, np.append(way, way[::-1]), pressed, segment)
    assert not any("whole way in" in doubt for doubt in inspect_file(path).doubts)
