"""A contact law as one Python file that needs numpy alone."""

from __future__ import annotations

import textwrap
from typing import Any

import numpy as np

from winkler.exporting.step_law import StepLaw, StepNumber
from winkler.exporting.targets.c_law import factors_of_size, translated_step
from winkler.exporting.targets.heading import heading_lines
from winkler.exporting.translation.python_writer import python_source

TOLERANCE = 1e-11
"""To which the file agrees with the trace, over the greatest number of a column."""


def python_law(law: StepLaw, name: str) -> str:
    """Return the file."""
    unit, routine = translated_step(law)
    heading = "\n".join(heading_lines(law)).replace("\\", "\\\\").replace('"""', "'''")
    tables = "\n".join(
        f"{table.name.upper()}_TABLE = {_array(table.numbers)}  # {table.meaning}" for table in law.tables
    )
    begin = "\n".join(f"        {_array(part.begin)},  # {part.meaning}" for part in law.state)
    answers = law.trace()
    return f'''"""{heading}

Use: state = begin() before the first touch, then answer = step(state, motion) in every step.
Test: `python {name}.py` compares a trace of winkler with what this file computes, and returns 0 if they agree.
"""

import math
import sys

import numpy as np

MOTION = {_names(law.motion)}
ANSWER = {_names(law.answer)}

{tables}


{python_source(unit)}


def begin():
    """Return the state of a contact before the first touch."""
    return [
{begin}
    ]


def step(state, motion):
    """Move a contact by one step, whose motion is in the order of MOTION; return what is in the order of ANSWER."""
    answer = np.zeros(len(ANSWER))
{_call(law, routine.name)}
    return answer


TRIAL_MOTION = {_array(law.trial)}
TRIAL_ANSWER = {_array(answers)}


def main():
    """Compare the trace."""
    state = begin()
    found = np.array([step(state, motion) for motion in TRIAL_MOTION])
    scale = np.maximum(np.max(np.abs(TRIAL_ANSWER), axis=0), 1e-300)
    worst = np.max(np.abs(found - TRIAL_ANSWER) / scale)
    print(f"{name}: {{len(found)}} steps agree with winkler to {{worst:.2g}}")
    return 0 if worst <= {TOLERANCE!r} else 1


if __name__ == "__main__":
    sys.exit(main())
'''


def _call(law: StepLaw, kernel: str) -> str:
    """Return the lines that call the kernel; of a law of all radii to a pair that is alike, and back."""
    tables, lines, motion = [f"{table.name.upper()}_TABLE" for table in law.tables], [], "np.array(motion, dtype=float)"
    if law.every_radius:
        lines = [f"    size = motion[-1] / {law.curvature_radius!r}"]
        alike = [f"motion[{k}]{' / size' if one.unit == 'm' else ''}" for k, one in enumerate(law.motion[:-1])]
        for k, table in enumerate(law.tables):
            if table.falling:
                tables[k] = f"own_{table.name}"
                lines += [f"    {tables[k]} = {table.name.upper()}_TABLE.copy()"]
                lines += [f"    {tables[k]}[{place}] /= size" for place in table.falling]
        motion = f"np.array([{', '.join(alike)}], dtype=float)"
    lines += [
        '    with np.errstate(all="ignore"):',
        f"        {kernel}({', '.join([*tables, '*state', motion, 'answer'])})",
    ]
    if law.every_radius:
        grown = (f"answer[{k}]{factor}" for k, factor in enumerate(factors_of_size(law)))
        lines += [f"    answer = np.array([{', '.join(grown)}])"]
    return "\n".join(lines)


def _names(quantities: tuple[StepNumber, ...]) -> str:
    return repr(tuple(one.name for one in quantities))


def _array(numbers: np.ndarray[Any, Any]) -> str:
    kind = {"f": "float", "i": "np.int64", "b": "bool"}[numbers.dtype.kind]
    if numbers.size and not np.any(numbers):
        return f"np.zeros({numbers.shape}, dtype={kind})"
    text = repr(numbers.tolist()).replace("inf", "math.inf").replace("nan", "math.nan")
    wrapped = "\n".join(textwrap.wrap(text, 112, initial_indent="    ", subsequent_indent="    "))
    return f"np.array(\n{wrapped},\n    dtype={kind},\n)"
