"""What was replaced is gone: no name of two mechanisms, and no question of solvers after the class of a medium."""

from __future__ import annotations

import ast
from collections.abc import Iterable
from pathlib import Path

import winkler

SOURCE = Path(winkler.__file__).parent
GONE = {
    "TwistedMedium": "TwistModuli",
    "PowerLawMedium": "PowerOfDepth",
    "DepthVaryingMedium": "PressedWaves",
    "LayeredBody": "LayerStack",
    "TwistedLayers": "TwistedWaves",
    "PushedLayers": "PushedWaves",
    "CoatedBody": "LayerStack",
    "StackedBody": "LayerStack",
    "SlidingStack": "StackMedium",
    "is_bonded": "Layer.bonded, StackLayer.bonded",
    "SlipPath": "SlipRow, under follow",
    "SlipPoint": "SlipState",
    "SpringRun": "SingleSprings, under follow",
    "SpringMarch": "Tangential by springs",
    "SpringTrace": "TangentialSolution",
    "LineMarch": "ElementRow, under follow",
    "MarchedRow": "LineCells",
    "CoatedTangential": "Tangential",
    "CoatedTangentialSolution": "TangentialSolution",
    "CoatedTangentialState": "PushedState",
    "coated_notes": "pushed_notes",
    "ViscoelasticTangential": "Tangential",
    "ViscoelasticTangentialSolution": "TangentialSolution",
    "ViscoelasticTangentialState": "DraggedState",
    "ForceDriven": "SpringRow, in one kernel",
    "ShearedMarch": "DraggedRow, under follow",
    "ShearedRowState": "DraggedRow, under follow",
    "StepTarget": "DragGoal",
    "sudden_step": "DraggedRow, under follow",
    "RowProblem": "SingleSprings, under follow",
    "step_by_angle": "RingRow, under follow",
    "step_to_torque": "RingRow, under follow",
}
"""Classes and functions that are no more, and what stands for them."""
OFFERING = {
    "CoatedHalfSpace",
    "StackedHalfSpace",
    "SlidingFilm",
    "StackMedium",
    "LayeredMedium",
    "DepthGradedHalfSpace",
}
OFFERING |= {"GradedHalfSpace"}
"""Media that are asked by `winkler.media.offers` for what they offer, never for their class."""
SOLVERS = ("problems", "foundation", "fitting", "fields", "media")


def trees(*parts: str, words: Iterable[str]) -> list[tuple[str, ast.Module]]:
    """Return the trees of the files that have one of the words, by their places."""
    files = [
        file for part in parts for file in ([SOURCE / part] if part.endswith(".py") else (SOURCE / part).rglob("*.py"))
    ]
    texts = {str(file.relative_to(SOURCE)): file.read_text(encoding="utf-8") for file in files}
    return [(file, ast.parse(text)) for file, text in texts.items() if any(word in text for word in words)]


def names_in(node: ast.AST) -> set[str]:
    """Return the names that a definition, a reading or an import brings in."""
    if isinstance(node, ast.ClassDef | ast.FunctionDef):
        return {node.name}
    if isinstance(node, ast.ImportFrom):
        return {one.name for one in node.names}
    return {node.id} if isinstance(node, ast.Name) else set()


def test_replaced_names_are_gone():
    found = [
        f"{file}: {name}, now {GONE[name]}"
        for file, tree in trees(".", words=GONE)
        for node in ast.walk(tree)
        for name in names_in(node) & GONE.keys()
    ]
    assert not found
    places = "media/families.py", "media/stacked", "problems/coated_friction", "problems/viscoelastic/force_driven.py"
    assert not [part for part in places if (SOURCE / part).exists()]


def test_solvers_ask_for_offers_and_not_for_classes():
    asked = []
    for file, tree in trees(*SOLVERS, words=OFFERING):
        for node in ast.walk(tree):
            if isinstance(node, ast.Call) and getattr(node.func, "id", "") in ("isinstance", "is_a"):
                kinds = {part.id for part in ast.walk(node.args[1]) if isinstance(part, ast.Name)} & OFFERING
                asked += [f"{file}:{node.lineno} {kind}" for kind in sorted(kinds)]
    assert not asked
