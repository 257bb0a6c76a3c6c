"""Files that are damaged or no curves: one sentence that names the file, whatever they hold."""

import numpy as np
import pytest

import winkler as wk
from winkler.io.curves import read_curve, read_curves

ROWS = "\n".join(f"{i},{i * i},{0.1 * i}" for i in range(30))
TABLE = f"depth [nm],force [uN],time [s]\n{ROWS}\n"
WIDE = ",".join(["depth [nm]", "force [uN]", *(f"c{i}" for i in range(1500))])


def refused(path, **given):
    with pytest.raises(wk.InvalidInput) as error:
        read_curve(path, **given)
    text = str(error.value)
    assert path.name in text
    assert "\n" not in text
    assert "Traceback" not in text
    return text


@pytest.mark.parametrize(
    ("content", "why"),
    [
        (b"", "the file is empty"),
        (b"   \n \n", "the file is empty"),
        (bytes(range(256)) * 20, "cannot read this file"),
        (np.random.default_rng(1).bytes(5000), "cannot read this file"),
        (TABLE.encode("utf-16")[:-3], "the file is damaged UTF-16; save it anew as UTF-8"),
        (TABLE.encode("utf-32"), "the file is written in UTF-32; save it as UTF-8"),
        (TABLE.encode("utf-16-le"), "looks like UTF-16 without a byte order mark; save it as UTF-8"),
        (TABLE.encode("utf-16-be"), "looks like UTF-16 without a byte order mark; save it as UTF-8"),
        (TABLE.replace("[uN]", "[GPa]").encode(), "'GPa' is the unit of a pressure"),
        (TABLE.replace("[uN]", "[blub]").encode(), "'blub' cannot be read"),
        (TABLE.replace("5,25,", "5,nan,").encode(), "line 7: a number is missing or not finite"),
        (TABLE.replace("5,25,0.5", "5,25").encode(), "line 7: the line has 2 and the header 3 cells"),
        (TABLE.replace("5,25,0.5", "5,x,0.5").encode(), "line 7: 'x' in the column"),
        (
            TABLE.replace("5,25,0.5", "depth [nm],force [uN],time [s]").encode(),
            "line 7: the header with the depth stands again",
        ),
        (f"depth [nm],depth [nm],force [uN]\n{ROWS}".encode(), "may each be the depth; rename all but one"),
        (TABLE.replace("29,841,2.9000000000000004", "29,841,0.1").encode(), "time falls|must never fall|never fall"),
        (b"h F t\n", "no unit|no numbers"),
        (b"depth [nm],force [uN]\n", "no numbers below the header"),
        (f"{ROWS}\n".encode(), "without a header|names a depth"),
        (f"{WIDE}\n{','.join(['1'] * 1502)}\n".encode(), "at least 2"),
        ((WIDE * 3).encode() + b"\n1,2\n", "the line has .* characters, and a table at most"),
    ],
)
def test_tables_that_are_refused(tmp_path, content, why):
    path = tmp_path / "curve.csv"
    path.write_bytes(content)
    with pytest.raises(wk.InvalidInput, match=why):
        read_curve(path)
    refused(path)


def hld():
    head = ["File Version: Hysitron X", "Machine Comp: 1 nm/µN", "Segment Number: 0", "Segment Points: 4"]
    head += [
        "Segment Begin Demand: 0 µN",
        "Segment End Demand: 9 µN",
        "Test Data Points: 4",
        "Time_s\tDisp_nm\tForce_µN",
    ]
    return "\r\n".join([*head, *(f"{i}\t{i}\t{i * i}" for i in range(4))])


FISCHER = "x\nBlock : 1   Value : 1\nx= 4,65  y= 6,01\nhmax\t[µm]\t1.5\nF\th\tt\n" + "\n".join(
    f"{i},5\t0,{i}1\t{i},25" for i in range(9)
)
FEMTO = "// Phase [#]\tDisplacement [um]\tTime [s]\tForce A [uN]\n" + "\n".join(f"2\t{i}.5\t{i}\t{i}" for i in range(9))
MICRO = "\r\n".join(f"{i}.0\t{i}.5\t{i}.25" for i in range(9))
DMA = "nanoDMA Text Export Version 1.00\n\n Test Time (s)\t Indent Disp. (nm)\t Indent Load (µN)\n" + "\n".join(
    f"{i}\t{i}.5\t{i}" for i in range(9)
)
FILES = {"a.hld": hld(), "b.txt": FISCHER, "c.txt": FEMTO, "d 1 2 3.txt": MICRO, "e.txt": DMA, "f.csv": TABLE}


@pytest.mark.few(1)
@pytest.mark.parametrize("name", FILES)
def test_files_cut_off_or_garbled_anywhere(tmp_path, name):
    """Read or refused by one sentence, for each of 60 cuts and 120 changed letters."""
    pytest.importorskip("afmformats")
    whole = FILES[name].encode("latin-1")
    path = tmp_path / name
    path.write_bytes(whole)
    assert sum(placed.curve.count for placed in read_curves(path)) >= 4
    rng = np.random.default_rng(7)
    cuts = [whole[: len(whole) * k // 60] for k in range(60)]
    letters = b"\x00\t\n;,.:/eE-[]( #%x9\xff\xb5"
    for _ in range(120):
        changed = bytearray(whole)
        for place in rng.integers(0, len(whole), 3):
            changed[place] = letters[rng.integers(0, len(letters))]
        cuts.append(bytes(changed))
    sentences = []
    for content in cuts:
        path.write_bytes(content)
        try:
            curves = [placed.curve for placed in read_curves(path)]
        except wk.InvalidInput as error:
            sentences.append(str(error))
        else:
            assert all(np.all(np.isfinite(curve.force)) and np.all(np.isfinite(curve.position)) for curve in curves)
    assert all("\n" not in sentence and name in sentence for sentence in sentences)
