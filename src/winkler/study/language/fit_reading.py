"""Studies with ``[fit]`` read from TOML: the model, the files of curves, and the free numbers."""

from __future__ import annotations

import copy
import dataclasses
import itertools
import re
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from winkler.fitting.parameters import number_at
from winkler.fitting.validity import with_load
from winkler.io.foreign import path_text, reason_of
from winkler.io.text_file import path_of
from winkler.loading.loads import Depth, Force
from winkler.loading.path import Path as MotionPath
from winkler.problems.plastic.indentation import PlasticIndentation
from winkler.problems.viscoelastic.indentation import ViscoelasticIndentation
from winkler.study.language import keys
from winkler.study.language.build import MOST_NEIGHBOURS
from winkler.study.language.compared.alternatives import alternatives
from winkler.study.language.fit_study import FITTED, OF_A_CURVE, OF_A_TIMED_CURVE, FitStudy, Free, word_of
from winkler.study.language.reading import checked, parsed, read_text, stated
from winkler.study.language.study import Output
from winkler.values.errors import InvalidInput, WinklerError, suggest
from winkler.values.limits import MOST_CURVES

PLACEHOLDER = {"kind": "depth", "depth": "0 m"}
PLACEHOLDER_TURNS = {"kind": "depth", "depth": ["0 m"]}
PLACEHOLDER_PATH = {"kind": "path", "time": ["0 s"], "normal": PLACEHOLDER}
GLOB_MARKS = re.compile(r"[*?\[]")
EXCLUDED_SECTIONS = ("sweep", "fields", "expect", "source", "grade")


def read_fit_study(path: str | Path, *, settings: Sequence[str] = ()) -> FitStudy:
    """Read a study file with a section ``[fit]``.

    Parameters
    ----------
    path
        A TOML file; the curves that it names lie relative to it.
    settings : sequence of str
        What replaces its own contents, as ``fit.segments=["hold 12 s"]``.

    Raises
    ------
    InvalidInput
        With one sentence for every mistake: file, key, what it was, what is allowed.
    """
    path = path_of(path)
    return parse_fit_study(read_text(path, settings), file=path.name, folder=path.parent)


def parse_fit_study(text: str, *, file: str = "", folder: Path = Path()) -> FitStudy:
    """Return the study with ``[fit]`` that TOML `text` describes; parameters as for `parse_study`."""
    raw = parsed(text, file)
    at = f"{file}: " if file else ""
    if "fit" not in raw:
        raise InvalidInput(f"{at}the study has no section [fit]; add it, or use `winkler run`.")
    for name in EXCLUDED_SECTIONS:
        if name in raw:
            raise InvalidInput(f"{at}a study with [fit] has no {name}; leave it out.")
    own = copy.deepcopy(raw)
    study = _study_of(raw, text, file, folder)
    listed = alternatives(own, lambda other: _study_of(other, text, file, folder), at)
    names = [study.model, *(one.name for one in listed)]
    if len(set(names)) < len(names):
        raise InvalidInput(f"{at}fit.models holds '{study.model}', the name of the problem itself; rename one of them.")
    return dataclasses.replace(study, models=listed)


def _study_of(raw: dict[str, Any], text: str, file: str, folder: Path) -> FitStudy:
    """Return the study with its own problem alone."""
    at = f"{file}: " if file else ""
    _placeholder(raw, at)
    form, problem = checked(raw, file, folder)
    given = stated(form.fit)
    given.pop("models", None)
    try:
        problem = _unloaded(problem, given)
        if "noise" in given:
            given["noise"] = _noise(given["noise"], "N" if given.get("fitted", "force") == "force" else "m")
        frees = _frees(given.pop("free"), problem)
        _refuse_further(given, frees, problem)
        return FitStudy(
            title=form.title or Path(file).stem,
            problem=problem,
            sources=curve_files(given.pop("curve"), folder, "fit.curve"),
            free=frees,
            output=Output(**stated(form.output)),
            text=text,
            folder=str(folder),
            **given,
        )
    except WinklerError as error:
        raise error.reworded(lambda sentence: f"{at}{sentence}") from None


def _refuse_further(given: dict[str, Any], frees: tuple[Free, ...], problem: Any) -> None:
    """Raise InvalidInput for keys that do not go together."""
    keys_ = [free.key for free in frees]
    for key in given.get("shared", ()):
        if re.sub(r"\[(\d+)\]", r".\1", key) not in keys_:
            raise InvalidInput(
                f"fit.shared names '{key}', which is not free{suggest(key, keys_)}; {', '.join(keys_)} are free."
            )
    if "shared" in given:
        given["shared"] = tuple(re.sub(r"\[(\d+)\]", r".\1", key) for key in given["shared"])
        if given.get("fitted", "force") != "force":
            raise InvalidInput("fit.shared is given, but positions are fitted; curves share numbers by their forces.")
    if "over_depth" in given:
        if isinstance(problem, ViscoelasticIndentation):
            raise InvalidInput(
                "fit.over_depth is given, but the body relaxes and has a history, which is not cut; leave it out."
            )
        if not any(key.startswith("problem.") for key in keys_):
            raise InvalidInput("fit.over_depth needs a free number of the problem, such as a modulus; free one.")
    if given.get("spring_constant_by") == "thermal" and "sensitivity_error" not in given:
        raise InvalidInput("fit.spring_constant_by is 'thermal', which only matters with sensitivity_error; give it.")


def _placeholder(raw: dict[str, Any], at: str) -> None:
    """Put a load into a problem without one, and refuse problems that are no model of a curve."""
    problem = raw.get("problem")
    if not isinstance(problem, dict):
        return
    kind = problem.get("kind")
    if isinstance(kind, str) and kind not in FITTED:
        from winkler.study.language.catalogue import CATALOGUE

        if kind in CATALOGUE["problem"]:
            raise InvalidInput(f"{at}problem.kind is '{kind}', which no curve can be fitted to; give "
                               f"{', '.join(FITTED[:-1])} or {FITTED[-1]}.")  # fmt: skip
    if kind == FITTED[-1]:
        problem.setdefault("path", dict(PLACEHOLDER_PATH))
    elif kind == "plastic_indentation":
        problem.setdefault("path", dict(PLACEHOLDER_TURNS))
    else:
        problem.setdefault("load", dict(PLACEHOLDER))


def _unloaded(problem: Any, given: dict[str, Any]) -> Any:
    """Return the model with a placeholder for its load, or for its path, whose type states what is prescribed."""
    part, fitted = given["part"], given.get("fitted", "force")
    if not isinstance(problem, ViscoelasticIndentation):
        for key, content in (("part", part if part == "hold" else ""), ("fitted", fitted if fitted != "force" else "")):
            if content:
                raise InvalidInput(
                    f"fit.{key} is '{content}', which needs a body that relaxes; give {FITTED[-1]}, or leave it."
                )
        turns = isinstance(problem, PlasticIndentation)
        return with_load(problem, Depth(np.zeros(1) if turns else 0.0))
    if part == "retract":
        raise InvalidInput(
            "fit.part is 'retract', but what a body that relaxes does depends on how it was pressed; give both."
        )
    if fitted == "position" and part == "both":
        raise InvalidInput(
            "fit.part is 'both', but forces drive a contact only while it grows; give hold, or fit forces."
        )
    return dataclasses.replace(problem, path=MotionPath(np.zeros(1), Depth(0.0) if fitted == "force" else Force(0.0)))


def _noise(raw: Any, unit: str) -> float:
    noise = _number(raw, unit, "fit.noise")
    if not noise > 0.0:
        raise InvalidInput(f"fit.noise is {raw!r}; it must be positive.")
    return noise


def curve_files(given: str, folder: Path, where: str) -> tuple[str, ...]:
    """Return the files that a key `where` names: a file, a folder, or a pattern, in the order of their numbers."""
    try:
        paths, what = _named(given, folder, where)
        files = sorted(itertools.islice(paths, MOST_CURVES + 1), key=_in_numbers)
    except InvalidInput:
        raise
    except (OSError, ValueError, NotImplementedError, RecursionError) as error:
        raise InvalidInput(
            f"{where} is '{path_text(given)}', which cannot be accessed ({reason_of(error)}); give a file, a folder or "
            "a pattern from the study."
        ) from None
    if not files:
        raise InvalidInput(f"{where}: {what}; give a file, a folder or a pattern that has some.")
    if len(files) > MOST_CURVES:
        raise InvalidInput(
            f"{where} is '{path_text(given)}', which are more than {MOST_CURVES} files; fit them in parts."
        )
    return tuple(str(item) for item in files)


def _named(given: str, folder: Path, where: str) -> tuple[Iterator[Path], str]:
    """Return the files that `curve` names, and the error text if there are none."""
    path = folder / given
    if path.is_file():
        return iter((path,)), ""
    if path.is_dir():
        inside = (item for item in path.iterdir() if item.is_file() and not item.name.startswith("."))
        return inside, f"the folder '{given}' holds no files"
    if GLOB_MARKS.search(given):
        if given.count("**") > 1:
            raise InvalidInput(f"{where} is '{path_text(given)}'; give a pattern with ** once, or without.")
        absolute = Path(given).is_absolute()
        root = Path(Path(given).anchor) if absolute else folder
        pattern = str(Path(given).relative_to(root)) if absolute else given
        return (item for item in root.glob(pattern) if item.is_file()), f"no file fits the pattern '{path_text(given)}'"
    beside = path.parent.iterdir() if path.parent.is_dir() else ()
    near = sorted(item.name for item in itertools.islice(beside, MOST_NEIGHBOURS))
    hint = suggest(path.name, near) or (f"; there are {', '.join(near[:5])}" if near else "")
    raise InvalidInput(
        f"{where} is '{path_text(given)}', which does not exist beside the study{hint}; give a file, a folder or a "
        "pattern from there."
    )


def _in_numbers(path: Path) -> tuple[Any, ...]:
    """Return a sort key that puts curve2 before curve10."""
    parts = re.split(r"(\d+)", path.as_posix())
    return tuple((int(part), "") if part.isdecimal() else (-1, part) for part in parts)


def _frees(raw: dict[str, Any], problem: Any) -> tuple[Free, ...]:
    if not raw:
        raise InvalidInput('fit.free is empty; name what is fitted, such as "problem.bed.medium.first.young" = true.')
    return tuple(free for key, content in raw.items() for free in _free_row(key, content, problem))


def _free_row(key: str, raw: Any, problem: Any) -> tuple[Free, ...]:
    """Return one line of ``[fit.free]``; of the name of a row, one for each of its numbers."""
    plain = re.sub(r"\[(\d+)\]", r".\1", key).removeprefix("problem.")
    try:
        content = keys.content_at(problem, plain) if key.startswith("problem.") else ()
    except InvalidInput:  # the error is raised below
        content = ()
    if not isinstance(content, np.ndarray):
        return (_free(key, raw, problem),)
    return tuple(_free(f"{key}.{index}", raw, problem) for index in range(content.size))


def _free(key: str, raw: Any, problem: Any) -> Free:
    where = f'fit.free."{key}"' if "." in key else f"fit.free.{key}"
    plain = re.sub(r"\[(\d+)\]", r".\1", key)
    free = Free(plain)
    curves = OF_A_TIMED_CURVE if isinstance(problem, ViscoelasticIndentation) else OF_A_CURVE
    if key in curves:
        unit = word_of(problem, key).unit or ""
    elif not plain.startswith("problem."):
        hint = suggest(key, curves)
        raise InvalidInput(
            f"{where} is neither a key of the problem, which begins with 'problem.' and stands in quotes, nor one of "
            f"{', '.join(curves)}{hint}."
        )
    else:
        try:
            keys.content_at(problem, plain.removeprefix("problem."))
            number_at(problem, free.path)
        except InvalidInput as error:
            sentence = str(error).removeprefix("free: ").replace(plain.removeprefix("problem."), key, 1)
            raise InvalidInput(f"{where}: {sentence.removeprefix(f'the key {key!r}: ')}") from None
        unit = word_of(problem, plain).unit or ""
    if raw is True or raw == {}:
        return free
    texts = raw if isinstance(raw, list) else [raw]
    if isinstance(raw, bool | dict) or len(texts) not in (1, 2) or (isinstance(raw, list) and len(raw) != 2):
        raise InvalidInput(
            f"{where} is {str(raw).lower() if isinstance(raw, bool) else raw!r}; give two bounds as a list, a start, "
            "or true for neither; leave out what is not fitted."
        )
    numbers = tuple(
        _number(text, unit, f"{where}[{place}]" if len(texts) == 2 else where) for place, text in enumerate(texts)
    )
    if len(numbers) == 2 and not numbers[0] < numbers[1]:
        raise InvalidInput(f"{where}: the lower bound {texts[0]!r} is not below the upper one {texts[1]!r}.")
    return Free(plain, numbers)


def _number(raw: Any, unit: str, where: str) -> float:
    from winkler.study.language import quantities

    return float(quantities.read_at(where, raw, unit, quantities.number))
