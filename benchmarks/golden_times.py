"""Times of the golden entries in two source trees, paired: the ratio for each engine.

    python benchmarks/golden_times.py BEFORE AFTER [name ...]

BEFORE and AFTER are folders of the project at two states.  One process for each imports its own `src` and its own
`tests/golden`, and both answer the same questions in turn.  A name chooses the questions that begin with it, all
histories unless given.  Each answer is computed in a fork, so that tables kept by an earlier one do not count, after
the first seed of its group was computed once, so that compilation does not count either.  Of `ROUNDS` times of
processor time, the shortest counts.  POSIX only.
"""

from __future__ import annotations

import os
import subprocess
import sys
import time
from collections import defaultdict
from pathlib import Path
from typing import Any

from pages import in_words, table

ROUNDS, SEEDS = 3, 3
FEWEST = 1e-3
"""Seconds below which an answer does not count: a fork's first touch of memory takes as long."""


def answer_in_turn() -> None:
    """Print the processor time of each question that a line of the input names, in the tree of this process."""
    from golden import answered, questions

    asked, ready = questions(), set()
    for line in sys.stdin:
        key, row = line.split()
        if key not in ready:
            answered(asked[key][0])
            ready.add(key)
        reading, writing = os.pipe()
        if not (child := os.fork()):
            began = time.process_time()
            answered(asked[key][int(row)])
            os.write(writing, repr(time.process_time() - began).encode())
            os._exit(0)
        os.close(writing)
        os.waitpid(child, 0)
        print(os.read(reading, 64).decode(), flush=True)
        os.close(reading)


class Tree:
    """A process that answers in one source tree."""

    def __init__(self, folder: Path) -> None:
        paths = os.pathsep.join(str(folder / part) for part in ("src", "tests/golden", "benchmarks"))
        threads = {"OPENBLAS_NUM_THREADS": "1", "PYTHONPATH": paths}
        command = [sys.executable, __file__, "--answer"]
        self.process: Any = subprocess.Popen(
            command, env=os.environ | threads, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
        )

    def seconds(self, key: str, row: int) -> float:
        """Return the processor time of one answer [s]."""
        self.process.stdin.write(f"{key} {row}\n")
        self.process.stdin.flush()
        return float(self.process.stdout.readline())


def main(before: str, after: str, *names: str) -> None:
    """Print the table."""
    sys.path[:0] = [f"{after}/src", f"{after}/tests/golden"]
    from golden import questions

    trees = [Tree(Path(folder).resolve()) for folder in (before, after)]
    times: defaultdict[str, list[tuple[float, float]]] = defaultdict(list)
    for key, rows in questions().items():
        if key.startswith(names or ("history/",)):
            for row in range(min(SEEDS, len(rows))):
                pairs = [[tree.seconds(key, row) for tree in trees] for _ in range(ROUNDS)]
                first, second = (min(column) for column in zip(*pairs, strict=True))
                if min(first, second) > FEWEST:
                    times["/".join(key.split("/")[: 3 if key.startswith("history") else 1])].append((first, second))
    lines = []
    for engine, pairs in times.items():
        sums = [sum(column) for column in zip(*pairs, strict=True)]
        most = max(second / first for first, second in pairs)
        lines.append([engine, str(len(pairs)), *map(in_words, sums), f"{sums[1] / sums[0]:.3f}", f"{most:.3f}"])
    print(table(["engine", "answers", "before", "after", "ratio", "greatest ratio of one"], lines))


if __name__ == "__main__":
    answer_in_turn() if sys.argv[1:] == ["--answer"] else main(*sys.argv[1:])
