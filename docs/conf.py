"""How the manual is built: ``sphinx-build -W -b html docs OUT``.

Two pages are written while building: the interface from ``winkler.__all__``, which so forgets no name, and the
validation from the cases of the package, which so shows no number of yesterday.
"""

from __future__ import annotations

import dataclasses
import inspect
import re
import sys
import tomllib
import warnings
import weakref
from pathlib import Path
from typing import Any

from docutils import nodes
from latex2mathml.converter import convert
from matplotlib import pyplot
from matplotlib.figure import Figure
from sphinx.util import logging
from sphinx_gallery.scrapers import figure_rst
from sphinx_gallery.sorting import FileNameSortKey

import winkler
from winkler.calculators.single_page import calculator_page
from winkler.cli import main as winkler_command
from winkler.study.finding.finding import known, neighbours, words
from winkler.study.ledger.ledger import case_files, ledger, remarks
from winkler.study.ledger.ledger_page import markdown

sys.path.insert(0, str(Path(__file__).parent / "figures"))
from legibility import faults

pyplot.switch_backend("Agg")

project = "winkler"
author = "The winkler developers"
copyright = "2026, The winkler developers"
release = version = winkler.__version__

extensions = [
    "myst_parser",
    "sphinx.ext.autodoc",
    "sphinx.ext.napoleon",
    "sphinx_gallery.gen_gallery",
]

html_theme = "furo"
html_math_renderer = "mathml"
html_static_path = ["static"]
html_css_files = ["formulas.css"]
html_title = "winkler"
URLS = tomllib.loads((Path(__file__).parents[1] / "pyproject.toml").read_text(encoding="utf-8"))["project"]["urls"]
if "Source" in URLS:  # each page then links to its text
    html_theme_options = {"source_repository": URLS["Source"], "source_branch": "main", "source_directory": "docs/"}
exclude_patterns = ["_build", "sg_execution_times.rst", "**/sg_execution_times.rst"]

myst_enable_extensions = ["dollarmath", "deflist"]
myst_heading_anchors = 3

autodoc_member_order = "bysource"
toc_object_entries = False  # thousands of members in the contents of each page took a third of the build
autodoc_typehints = "none"
autoclass_content = "class"
napoleon_google_docstring = False
napoleon_use_ivar = True
napoleon_use_rtype = False


_shown: weakref.WeakKeyDictionary[Figure, tuple[str, list[str]]] = weakref.WeakKeyDictionary()
"""Where a figure is saved, and what was in it then."""
_faults: dict[str, tuple[str, list[str]]] = {}
"""The script of each figure and what cannot be read in it, by where it was saved last."""


def figures(block: Any, block_vars: dict[str, Any], gallery_conf: Any) -> str:
    """Give the figures of an example to the gallery; `draw` makes them without pyplot, where it would not find them.

    One that a later block goes on with is saved once more, so that the page shows it as it is in the end.
    """
    script = Path(block_vars["src_file"]).name
    paths = []
    for item in list(block_vars["example_globals"].values()):
        if not isinstance(item, Figure):
            continue
        content = [str(artist) for artist in item.findobj()]
        if item not in _shown:
            paths.append(next(block_vars["image_path_iterator"]))
        elif _shown[item][1] == content:
            continue
        path = _shown[item][0] if item in _shown else paths[-1]
        item.savefig(path, dpi=110, bbox_inches="tight")
        _faults[path] = script, faults(item)
        _shown[item] = path, [str(artist) for artist in item.findobj()]
        pyplot.close(item)
    for number in pyplot.get_fignums():  # those without a name
        _faults[f"{script}, {block[2]}, {number}"] = script, faults(pyplot.figure(number))
    return str(figure_rst(paths, gallery_conf["src_dir"]))


def _report(app: Any) -> None:
    """Warn of what a reader cannot read in the figures of scripts, as they are in the end."""
    for script, found in _faults.values():
        for fault in found:
            logging.getLogger(__name__).warning("%s: a figure is to be mended, %s", script, fault)


sphinx_gallery_conf = {
    "image_scrapers": (figures, "matplotlib"),
    "capture_repr": (),
    "examples_dirs": "../examples",
    "gallery_dirs": "gallery",
    "within_subsection_order": FileNameSortKey,
    "filename_pattern": r"\.py$",
    "ignore_pattern": r"__init__\.py$",
    "download_all_examples": False,
    "remove_config_comments": True,
    "show_memory": False,
    "show_signature": False,
    "plot_gallery": True,
    "abort_on_example_error": True,
    "only_warn_on_example_error": False,
}
suppress_warnings = ["config.cache"]

CHAPTERS = (
    ("Solids", "materials"),
    ("Shapes", "profiles"),
    ("Media", "media"),
    ("Beds of springs", "foundation"),
    ("Laws of adhesion", "laws"),
    ("Loads", "loading"),
    ("Problems and their answers", "problems"),
    ("Fits to force curves", "fitting"),
    ("Fields and greatest stresses", "fields"),
    ("Reading measured tables", "io"),
    ("Validity, errors and units", "values"),
)


def _entry(name: str) -> str:
    """Return the directive that documents one public name."""
    item = getattr(winkler, name)
    if inspect.isclass(item):
        shared = "   :inherited-members:\n" if name.endswith("Solution") else ""  # what answers have in common
        return f".. autoclass:: winkler.{name}\n   :members:\n{shared}"
    if callable(item):
        return f".. autofunction:: winkler.{name}\n"
    return f".. py:data:: winkler.{name}\n\n   ``{str(item).replace('winkler.', '')}``\n"


def _layer_of(name: str) -> str:
    """Return the layer that defines a name; a union comes from the layer of its members."""
    item = getattr(winkler, name)
    module = getattr(item, "__module__", "")
    if not module.startswith("winkler."):
        members = getattr(item, "__args__", ())
        module = members[0].__module__ if members else ""
    return module.split(".")[1] if module.startswith("winkler.") else ""


def _links(names: list[str]) -> str:
    """Return the names of a chapter as one line of links to what is below."""
    return " · ".join(f":py:obj:`~winkler.{name}`" for name in names)


def public_names_page() -> str:
    """Return the page of the interface in reStructuredText, chapter by chapter."""
    names = [name for name in winkler.__all__ if not name.startswith("__")]
    written, text = set(), []
    for title, layer in CHAPTERS:
        here = [name for name in names if _layer_of(name) == layer]
        if here:
            text += [title, "-" * len(title), "", _links(here), "", *map(_entry, here)]
            written.update(here)
    rest = [name for name in names if name not in written]
    if rest:
        text += ["More", "----", "", _links(rest), "", *map(_entry, rest)]
    title = "Numbers that answers share with their states"
    text += [title, "-" * len(title), "", *(f".. autoclass:: {place}\n" for place in shared_records())]
    return "\n".join(text)


def shared_records() -> list[str]:
    """Return the paths of the classes that hold numbers of public answers, and are no public names."""
    public = [item for name in winkler.__all__ if inspect.isclass(item := getattr(winkler, name))]
    bases = {
        base for item in public for base in item.__mro__ if dataclasses.is_dataclass(base) and base.__name__[0] != "_"
    }
    return sorted(f"{base.__module__}.{base.__qualname__}" for base in bases - set(public))


def words_page() -> str:
    """Return what people call each problem, medium and shape, and what is not covered."""
    text = []
    for title, slots in (("Problems", ("problem",)), ("Media and shapes", ("medium", "profile")), ("Other tasks", ())):
        text += [f"## {title}", ""]
        for hit in known():
            if hit.group in slots or (not slots and hit.group == "task"):
                text += [f"**{hit.name}** (`{hit.command}`): {hit.meaning}", "", f"> {words(hit.name)}", ""]
    text += ["## What is not covered", ""]
    for one in neighbours():
        text += [f"- {one.what}; the nearest: {', '.join(f'`{name}`' for name in one.nearest)}"]
    return "\n".join(text)


def _fill(app: Any, docname: str, source: list[str]) -> None:
    """Write the pages that are made while building."""
    if docname == "api":
        source[0] = source[0].replace("PUBLIC_NAMES", public_names_page())
    if docname == "words":
        source[0] = source[0].replace("KNOWN_WORDS", words_page())
    if docname == "validation":
        entries = list(ledger(case_files(())))
        missed = [entry.name for entry in entries if not entry.passed]
        if missed:
            logging.getLogger(__name__).warning("validation: these cases miss their numbers: %s", ", ".join(missed))
        source[0] = markdown(entries, remarks())


def _keep_initials(app: Any, what: str, name: str, item: Any, options: Any, lines: list[str]) -> None:
    """Escape the initials that open a reference: "W. C. Oliver" is no list."""
    lines[:] = [re.sub(r"^(\s*)([A-Z]\. )", r"\1\\\2", line) for line in lines]


def _keep_sentences(app: Any, what: str, name: str, item: Any, options: Any, lines: list[str]) -> None:
    """Open a property with a blank line: napoleon takes what stands before a colon in its first line for a type."""
    if what in ("property", "attribute"):
        lines.insert(0, "")


def in_mathml(formula: str, display: str) -> str:
    """Return a formula in MathML, with a thin space between the name of a function and what it is taken of."""
    return re.sub(
        r"(?<!<msup>)(?<!<msub>)(<mi>[a-z]{2,}</mi>)(?=<m[infs])",
        r'\1<mspace width="0.17em" />',
        convert(formula, display=display),
    )


def inline_formula(writer: Any, node: Any) -> None:
    """Write a formula of a line in MathML: browsers draw it themselves, from any disk, without a script of a server."""
    writer.body.append(in_mathml(node.astext(), "inline"))
    raise nodes.SkipNode


def displayed_formula(writer: Any, node: Any) -> None:
    """Write a displayed formula in MathML, in a box that scrolls by itself where the page is narrow."""
    writer.body.append(f'<div class="math">{in_mathml(node.astext(), "block")}</div>\n')
    raise nodes.SkipNode


FILMS = {
    "pressed": ("normal/formula.toml", "problem.load.radius={from='0.02 mm',to='0.3 mm',count=24}"),
    "pushed": ("friction/fretting_loop.toml", ""),
    "sticky": ("adhesion/sticky_ball.toml", ""),
    "relaxing": ("viscoelastic/cell_indentation.toml", ""),
    "worn": ("wear/fretting_wear.toml", ""),
}
"""The films of the page on the method -> the study that moves there, and what is set in it."""


def _films(app: Any) -> None:
    """Draw the films of the page on the method; delete the folder to have them drawn anew."""
    folder = Path(app.srcdir) / "films"
    folder.mkdir(exist_ok=True)
    for name, (study, setting) in FILMS.items():
        path = folder / f"{name}.gif"
        wanted = [str(Path(app.srcdir).parent / "examples" / "studies" / study), "--part", "film", "-o", str(path)]
        if not path.exists() and winkler_command(["draw", *wanted, *(["--set", setting] if setting else [])]) != 0:
            logging.getLogger(__name__).warning("the film %s is not drawn", path.name)


def _calculators(app: Any, exception: Exception | None) -> None:
    """Put the page of calculators beside the pages of the manual."""
    if exception is None and app.builder.format == "html":
        (Path(app.outdir) / "calculators.html").write_text(calculator_page(), encoding="utf-8")


def setup(app: Any) -> None:
    """Hook the pages that are made while building into the build; a warning of a script is a mistake, as in tests."""
    warnings.filterwarnings("error", category=RuntimeWarning)
    warnings.filterwarnings("error", category=DeprecationWarning, module="winkler")
    app.add_html_math_renderer("mathml", (inline_formula, None), (displayed_formula, None))
    app.connect("builder-inited", _films)
    app.connect("builder-inited", _report, priority=900)  # after the gallery
    app.connect("source-read", _fill)
    app.connect("build-finished", _calculators)
    app.connect("autodoc-process-docstring", _keep_sentences, priority=100)
    app.connect("autodoc-process-docstring", _keep_initials, priority=900)
