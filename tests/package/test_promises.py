"""What SECURITY.md promises is held by tests that exist, and by what the source does not contain."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterable

UNPICKLE = {"pickle", "cPickle", "_pickle", "dill", "cloudpickle", "joblib", "marshal", "shelve"}


def test_each_promise_names_tests_that_exist(root):
    page = (root / "SECURITY.md").read_text(encoding="utf-8")
    table = page.partition("| held by |")[2].partition("\n\n")[0]
    rows = [row.split("|")[1:-1] for row in table.splitlines()[2:]]
    assert len(rows) >= 8
    for promise, held in rows:
        named = re.findall(r"`([\w/.]+)::(\w+)`", held)
        assert named, promise
        for path, test in named:
            assert re.search(rf"^def {test}\(", (root / path).read_text(encoding="utf-8"), re.MULTILINE), (path, test)


def unpickling(nodes: Iterable[ast.AST]) -> list[int]:
    """Return the lines that may unpickle: a module made for it, NumPy's `load` unless switched off, pandas' reader."""
    lines = []
    for node in nodes:
        modules = [alias.name for alias in node.names] if isinstance(node, ast.Import) else []
        modules += [node.module or ""] if isinstance(node, ast.ImportFrom) else []
        if UNPICKLE & {name.partition(".")[0] for name in modules}:
            lines.append(node.lineno)
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute):
            refused = any(
                given.arg == "allow_pickle" and isinstance(given.value, ast.Constant) and given.value.value is False
                for given in node.keywords
            )
            if node.func.attr not in ("load", "read_pickle"):
                continue
            whole = ast.unparse(node.func)
            if whole.endswith("read_pickle") or (whole in ("np.load", "numpy.load") and not refused):
                lines.append(node.lineno)
    return lines


def test_no_module_unpickles(pages):
    assert [f"{page.name}:{line}" for page in pages for line in unpickling(page.nodes)] == []


def test_the_search_for_pickles_finds_them():
    code = "import pickle\nfrom joblib import load\nnp.load(f)\nnp.load(f, allow_pickle=True)\npd.read_pickle(f)\n"
    assert unpickling(ast.walk(ast.parse(code))) == [1, 2, 3, 4, 5]
    assert unpickling(ast.walk(ast.parse("np.load(f, allow_pickle=False)\nimport picklejar\n"))) == []


def test_the_app_listens_on_this_machine_only(pages):
    [serve] = [page for page in pages if page.name == "web/page/serve.py"]
    assert re.findall(r'^HOST = "(.*)"$', serve.text, re.MULTILINE) == ["127.0.0.1"]
    calls = [
        (page.name, ast.unparse(node.func), given.value)
        for page in pages
        for node in page.nodes
        if isinstance(node, ast.Call)
        for given in node.keywords
        if given.arg == "host"
    ]
    assert [(name, who, ast.unparse(host)) for name, who, host in calls] == [("web/page/serve.py", "ui.run", "HOST")]
    stated = [page.name for page in pages if re.search(r"0\.0\.0\.0|INADDR_ANY", page.text)]
    assert stated == []
