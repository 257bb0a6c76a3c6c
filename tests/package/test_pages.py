"""The rules of a module: one idea, absolute imports, no tricks, a name of its idea, and documented."""

from __future__ import annotations

import ast
import statistics
from collections.abc import Iterable

from winkler.study.language.catalogue import kinds

LONGEST = 800
"""Lines of one idea with all that only it needs; half of the modules stay below the median."""
MEDIAN = 150
FORBIDDEN_NAMES = {"utils", "util", "helpers", "helper", "common", "misc"}
ALLOWED_OF_IMPORTLIB = {"importlib.resources", "importlib.metadata"}
LOADING_BY_NAME = ("__init__.py", "plot/registered.py", "study/chapters/kind.py", "io/foreign.py")
"""They load one class when it is first named, a public name or the kind of a table, or all pictures; the last one loads
a module of igor2 anew.  `test_cold_start` and `test_kinds_lie_below_studies` look at what the others load."""


def test_no_page_is_too_long(pages):
    long = {page.name: page.text.count("\n") for page in pages}
    assert {name: lines for name, lines in long.items() if lines > LONGEST} == {}


def test_half_of_the_pages_are_short(pages):
    assert statistics.median(page.text.count("\n") for page in pages) < MEDIAN


def test_no_page_has_a_name_without_an_idea(pages):
    bad = []
    for page in pages:
        words = page.name.removesuffix(".py").split("/")
        bad += [page.name for word in words if word in FORBIDDEN_NAMES or word.startswith("base_") or word == "base"]
    assert bad == []


def test_imports_are_absolute(pages):
    bad = [
        f"{page.name}:{node.lineno}"
        for page in pages
        for node in page.nodes
        if isinstance(node, ast.ImportFrom) and node.level > 0
    ]
    assert bad == []


def imported(node: ast.AST) -> list[str]:
    """Return the modules that an import statement names."""
    if isinstance(node, ast.Import):
        return [alias.name for alias in node.names]
    if isinstance(node, ast.ImportFrom) and node.level == 0:
        return [node.module or ""]
    return []


def tricks(nodes: Iterable[ast.AST]) -> list[tuple[int, str]]:
    """Return every import that the import linter would not see."""
    found = []
    for node in nodes:
        for module in imported(node):
            if module == "winkler":
                found.append((node.lineno, "imports the public names"))
            if module.split(".")[0] == "importlib" and module not in ALLOWED_OF_IMPORTLIB:
                names = {f"{module}.{alias.name}" for alias in node.names}
                if not (isinstance(node, ast.ImportFrom) and names <= ALLOWED_OF_IMPORTLIB):
                    found.append((node.lineno, f"uses {module}"))
            if module in ("pkgutil", "runpy", "imp"):
                found.append((node.lineno, f"uses {module}"))
        if isinstance(node, ast.Name) and node.id in ("__import__", "eval", "exec"):
            found.append((node.lineno, f"uses {node.id}"))
        if isinstance(node, ast.Attribute) and node.attr == "modules" and ast.unparse(node.value) == "sys":
            found.append((node.lineno, "uses sys.modules"))
    return found


def test_no_import_hides_from_the_linter(pages):
    looked_at = [page for page in pages if page.name not in LOADING_BY_NAME]
    bad = [f"{page.name}:{line} {what}" for page in looked_at for line, what in tricks(page.nodes)]
    assert bad == []


def test_kinds_lie_below_studies():
    """What the catalogue names by path is invisible to the import linter: no kind stands above the studies."""
    above = ("winkler.web", "winkler.cli", "winkler.reference", "winkler.plot")
    paths = {path for line in kinds().values() for path in (line.path, line.reader_path)}
    assert len(paths) > 100
    assert [path for path in paths if path.startswith(above)] == []


def test_the_search_for_tricks_finds_them():
    code = (
        "import winkler\nfrom winkler import Sphere\nimport importlib\nfrom importlib import import_module\n"
        "import importlib.util\n__import__('winkler.plot')\nimport sys\nsys.modules['winkler']\neval('1')\n"
    )
    assert sorted(line for line, _ in tricks(ast.walk(ast.parse(code)))) == [1, 2, 3, 4, 5, 6, 8, 9]
    fine = "from importlib import metadata\nimport importlib.resources\nfrom winkler.values.value import value\n"
    assert tricks(ast.walk(ast.parse(fine))) == []


def names_listed(text: str) -> tuple[set[str], set[str]]:
    """Return what `__all__` of a module names, and what the module defines."""
    listed: set[str] = set()
    defined: set[str] = set()
    for node in ast.parse(text).body:
        if isinstance(node, ast.FunctionDef | ast.ClassDef):
            defined.add(node.name)
        elif isinstance(node, ast.Assign | ast.AnnAssign):
            targets = node.targets if isinstance(node, ast.Assign) else [node.target]
            names = {one.id for target in targets for one in ast.walk(target) if isinstance(one, ast.Name)}
            defined |= names
            if names == {"__all__"} and node.value is not None:
                listed = {one.value for one in ast.walk(node.value) if isinstance(one, ast.Constant)}
    return listed, defined


def test_no_list_repeats_the_names_of_a_module(pages):
    """Of 1,453 names in such lists 207 were read by no other module, and 48 others that were read stood in none.

    `__all__` stands where a module passes on names of others, and in what the compiled calculators are a digest of.
    """
    bad = []
    for page in pages:
        listed, defined = names_listed(page.text)
        bad += [page.name] if listed and listed <= defined and not page.name.startswith("calculators/") else []
    assert bad == []


def test_a_list_that_repeats_is_told_from_one_that_passes_on():
    assert names_listed("__all__ = ['f', 'g']\ndef f(): pass\ng: int = 1\n") == ({"f", "g"}, {"__all__", "f", "g"})
    listed, defined = names_listed("from a import g\n__all__ = ['f', 'g']\ndef f(): pass\n")
    assert not listed <= defined


def test_no_global_state(pages):
    bad = [f"{page.name}:{node.lineno}" for page in pages for node in page.nodes if isinstance(node, ast.Global)]
    assert bad == []


def test_no_bare_handler_swallows_an_error(pages):
    """`except: pass` and `except Exception: pass` hide failures."""
    bad = []
    for page in pages:
        for node in page.nodes:
            if isinstance(node, ast.ExceptHandler):
                broad = node.type is None or ast.unparse(node.type) in ("Exception", "BaseException")
                silent = all(isinstance(line, ast.Pass | ast.Continue) for line in node.body)
                if node.type is None or (broad and silent):
                    bad.append(f"{page.name}:{node.lineno}")
    assert bad == []


def test_every_module_states_its_idea(pages):
    assert [page.name for page in pages if not ast.get_docstring(page.tree)] == []


def in_words(node: ast.AST) -> bool:
    """Return whether a definition is public; the signatures of an overload follow their implementation."""
    if not isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.ClassDef) or node.name.startswith("_"):
        return False
    return not any(ast.unparse(mark).split(".")[-1] == "overload" for mark in node.decorator_list)


def undocumented(tree: ast.Module) -> list[str]:
    """Return the public functions, classes and methods (of public classes) without a docstring."""
    bad = []
    for node in tree.body:
        if not in_words(node):
            continue
        if not ast.get_docstring(node):
            bad.append(node.name)
        if isinstance(node, ast.ClassDef):
            bad += [
                f"{node.name}.{inner.name}" for inner in node.body if in_words(inner) and not ast.get_docstring(inner)
            ]
    return bad


def test_everything_public_is_documented(pages):
    assert [f"{page.name}: {name}" for page in pages for name in undocumented(page.tree)] == []


def test_the_search_for_docstrings_finds_what_lacks_one():
    code = 'class A:\n    """A."""\n    def b(self): ...\ndef c(): ...\ndef _d(): ...\nclass E: ...\n'
    code += "@overload\ndef f(): ...\n"
    assert undocumented(ast.parse(code)) == ["A.b", "c", "E"]


def test_no_path_of_a_machine(pages):
    bad = [
        f"{page.name}: {word}" for page in pages for word in ("/home/", "/Users/", "/tmp/", "C:\\") if word in page.text
    ]
    assert bad == []
