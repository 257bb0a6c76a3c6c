"""``winkler show fit``: what the section ``[fit]`` takes, which models can be fitted, corrections, flags."""

from __future__ import annotations

from winkler.cli.streams import until_closed

EXAMPLE = """\
[problem]
kind = "indentation"

[problem.bed]
kind = "foundation"
profile = { kind = "sphere", curvature_radius = "5 um" }

[problem.bed.medium]
kind = "half_space"
first = { kind = "elastic", young = "1 kPa", poisson = 0.5 }

[fit]
curve = "gel/*.csv"
part = "approach"

[fit.free]
"problem.bed.medium.first.young" = ["10 Pa", "10 MPa"]
contact_point = true
baseline = true
"""

CORRECTION_MEANINGS = {
    "baseline": "subtracts a line through the points out of contact; better: free baseline and tilt",
    "drag": "subtracts half the difference of approach and retraction out of contact",
    "drift": "subtracts the drift of the position, measured during a hold",
    "saturation": "leaves out points at which the detector is at its end",
    "interference": "subtracts a sinusoid over the position, found out of contact",
    "clock": "moves the forces in time against the positions, by the offset found in the curve",
}


@until_closed()
def show_fit() -> None:
    """Print keys, models, corrections and flags."""
    from winkler.cli import terminal

    out = terminal.console()
    for title, heads, rows in _parts():
        out.print(title)
        table = terminal.table(*heads)
        for row in rows:
            table.add_row(*row)
        out.print(table)
    out.print("Example:\n")
    out.print(EXAMPLE, soft_wrap=True, markup=False)
    out.print("`winkler show KIND` shows the keys of a model; docs/fits.md explains the rest.", markup=False)


def fit_json() -> dict[str, list[dict[str, str]]]:
    """Return the same as JSON."""
    return {
        title.partition(":")[0]: [dict(zip(heads, row, strict=True)) for row in rows] for title, heads, rows in _parts()
    }


def _parts() -> list[tuple[str, tuple[str, ...], list[tuple[str, ...]]]]:
    from winkler.fitting.flag_meanings import FLAG_MEANINGS, REFUSING_FLAGS
    from winkler.study.language.catalogue import kinds
    from winkler.study.language.correcting import CORRECTIONS
    from winkler.study.language.explain import summary
    from winkler.study.language.fit_study import FITTED
    from winkler.study.language.grammar import SECTIONS

    known = {name: CORRECTION_MEANINGS.get(name, "see docs/fits.md") for name in CORRECTIONS}
    return [
        ("[fit]: measured curves and their model", ("key", "meaning"), list(SECTIONS["fit"].items())),
        ("[fit.free]: what is fitted", ("key", "meaning"), list(SECTIONS["fit.free"].items())),
        ("models: kinds of [problem]", ("kind", "what it is"), [(name, summary(kinds()[name].cls)) for name in FITTED]),
        ("corrections: before the fit, in the order of correct", ("name", "what it does"), list(known.items())),
        ("flags: beside the numbers of a fit", ("flag", "meaning"), list(FLAG_MEANINGS.items())),
        ("refused: curves with one of these are not fitted", ("flag", "meaning"), list(REFUSING_FLAGS.items())),
    ]
