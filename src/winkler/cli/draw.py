"""``winkler draw``: a study as a picture."""

from __future__ import annotations

import dataclasses
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

from winkler.cli.options import Settings, StudyFile, completion, refuse_existing
from winkler.cli.streams import write_line

if TYPE_CHECKING:
    from winkler.study.batch.points import Solved

PARTS = {
    "contact": "the body in its indentation, the springs, their load and the pressure",
    "profile": "the shape alone: f(r) and g(x), or the height map",
    "bed": "the shape over its springs",
    "surface": "pressure and displacement of the surface; needs [fields] with r",
    "medium": "a coated or graded solid from its surface down, and the stiffness of its springs",
    "stress": "the stress below the surface; needs [fields] with r and z",
    "curve": "force, radius and stiffness over the depth, of a load that is a list",
    "film": "what moves, as an animated .gif or an .mp4: the body, its springs, stick and slip zones, the pressure",
}


def draw(
    study: StudyFile,
    output: Annotated[
        Path | None,
        typer.Option(
            "--output",
            "-o",
            help="The picture: .png, .svg or .pdf, of a film .gif or .mp4; NAME-PART.png if not given.",
        ),
    ] = None,
    part: Annotated[
        str, typer.Option(help=f"What to draw: {', '.join(PARTS)}.", autocompletion=completion(lambda: PARTS))
    ] = "contact",
    point: Annotated[int, typer.Option(help="Which point of the sweep, from 0; -1 is the last.")] = -1,
    load: Annotated[int, typer.Option(help="Which load, where the study has many at once; -1 is the last.")] = -1,
    settings: Settings = None,
    overwrite: Annotated[bool, typer.Option("--overwrite", "--yes", "-y", help="Replace an existing picture.")] = False,
) -> None:
    """Draw a study into a picture file.

    Example: winkler draw examples/studies/normal/hertz.toml --part stress --output stress.svg
    """
    from winkler.fields.restoration import SubsurfaceFields
    from winkler.io.whole_file import write_whole
    from winkler.plot.animation import FILMS, animated
    from winkler.plot.normal.stresses import interface_rules
    from winkler.plot.picture_file import picture_file
    from winkler.plot.registered import sheet_of_kind
    from winkler.study.language.reading import read_study
    from winkler.study.language.study import PICTURES
    from winkler.values.errors import InvalidInput, suggest

    if part not in PARTS:
        raise InvalidInput(
            f"draw: the part '{part}' is not known{suggest(part, PARTS)}; give one of {', '.join(PARTS)}."
        )
    path = output or Path(f"{study.stem}-{part}.{'gif' if part == 'film' else 'png'}")
    film, form = part == "film", path.suffix.lstrip(".").lower()
    allowed, between = (FILMS, " or .") if film else (PICTURES, ", .")
    if form not in allowed:
        kind = "film" if film else "picture"
        raise InvalidInput(f"draw: '{path}' does not end like a {kind}; give .{between.join(allowed)}.")
    refuse_existing(path, overwrite, "draw: ")
    answer = _solved(read_study(study, settings=settings or ()), point)
    if film:
        from winkler.web.pictures.frames import frames_of

        write_whole({path: animated(frames_of(answer), form=form)})
        write_line(f"Written {path}")
        return
    item = _drawn_value(answer, part, load)
    sheet = sheet_of_kind(item)
    if isinstance(item, SubsurfaceFields) and min(item.r.shape) > 1:
        rules = interface_rules(item, answer.problem.bed.medium)
        sheet = dataclasses.replace(sheet, panels=(sheet.panels[0].plus(*rules),))
    write_whole({path: picture_file(sheet, form)})
    write_line(f"Written {path}")


def _solved(study: Any, point: int) -> Solved:
    """Solve one point of a study."""
    from winkler.study.batch.points import Failed
    from winkler.study.batch.run import ERRORS
    from winkler.study.batch.sweep import solved
    from winkler.study.batch.tasks import tasks
    from winkler.values.errors import InvalidInput

    points = tasks(study)
    if not -len(points) <= point < len(points):
        raise InvalidInput(f"draw: there is no point {point}; the study has {len(points)}, counted from 0.")
    answer = solved(points[point])
    if isinstance(answer, Failed):
        raise ERRORS[answer.code](answer.reason)
    return answer


def _drawn_value(answer: Solved, part: str, load: int) -> Any:
    """Return what is drawn: a part of the solved point."""
    from winkler.foundation.footprint import RoundOutline
    from winkler.foundation.measured import MeasuredBed
    from winkler.plot.registered import is_drawn
    from winkler.study.report.extra_pictures import extra_pictures
    from winkler.values.errors import InvalidInput

    bed = getattr(answer.problem, "bed", None)
    outline = getattr(bed, "footprint", None)  # a line contact and an ellipse have none
    outlined = outline is not None and not isinstance(outline, RoundOutline)  # its springs represent another body
    shape = None if outlined else getattr(bed, "profile", None) or getattr(bed, "plane_profile", None)
    if not -len(answer.each) <= load < len(answer.each):
        raise InvalidInput(f"draw: there is no load {load}; the study has {len(answer.each)}, counted from 0.")
    match part:
        case "profile":
            maps = extra_pictures(answer.solution)
            if maps:
                return maps[0].item
            if shape is None:
                raise InvalidInput("draw: this study has no profile; `--part bed` shows what it has.")
            return shape
        case "bed" if bed is not None:
            return bed
        case "medium" if bed is not None:
            return bed if isinstance(bed, MeasuredBed) else bed.medium
        case "curve":
            return answer.solution
        case "surface" | "stress":
            fields = answer.surface if part == "surface" else answer.subsurface
            if not fields:
                need = "r" if part == "surface" else "r and z"
                raise InvalidInput(f"draw: the study restores no such fields; add [fields] with {need}.")
            return fields[load]
        case _:
            state = answer.each[load]
            return state if is_drawn(state) else answer.solution  # states of rolling have no picture of their own
