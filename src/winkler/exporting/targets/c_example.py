"""The example at the end of a law in C: a program that steps through a test trace and compares it with winkler's."""

from __future__ import annotations

import textwrap

import numpy as np

from winkler.exporting.step_law import StepLaw
from winkler.numerics.types import Array

TRACE_TOLERANCE = 1e-11
"""To which a compiled file agrees with the trace, over the greatest number of a column: compilers round differently."""


def c_main(law: StepLaw, name: str, tolerance: float = TRACE_TOLERANCE) -> str:
    """Return the program, which compares to a tolerance."""
    answers = law.trace()
    scale = np.maximum(np.max(np.abs(answers), axis=0), 1e-300)
    count, takes, gives = len(law.trial), len(law.motion), len(law.answer)
    columns = ", ".join(f'"{one.name}"' for one in law.answer)
    return f"""#include <stdio.h>

#define STEPS {count}
/* Motions of the test, one step a row: {", ".join(one.name for one in law.motion)} */
static const double trial_motion[STEPS][{takes}] = {{
{_rows(law.trial)}
}};
/* What winkler answers: {", ".join(one.name for one in law.answer)} */
static const double trial_answer[STEPS][{gives}] = {{
{_rows(answers)}
}};
/* The greatest of every column. */
static const double trial_scale[{gives}] = {{{", ".join(map(repr, scale.tolist()))}}};

int main(void) {{
    static const char *columns[{gives}] = {{{columns}}};
    {name}_state state;
    {name}_motion motion;
    {name}_answer answer;
    double worst = 0.0;
    {name}_begin(&state);
    for (int step = 0; step < STEPS; ++step) {{
        memcpy(&motion, trial_motion[step], sizeof(motion));
        {name}_step(&state, &motion, &answer);
        double got[{gives}];
        memcpy(got, &answer, sizeof(answer));
        for (int k = 0; k < {gives}; ++k) {{
            const double error = fabs(got[k] - trial_answer[step][k]) / trial_scale[k];
            if (!(error <= {tolerance!r})) {{
                printf("step %d: %s is %.17g, winkler has %.17g\\n", step, columns[k], got[k], trial_answer[step][k]);
                return 1;
            }}
            if (error > worst) worst = error;
        }}
    }}
    printf("{name}: %d steps agree with winkler to %.2g\\n", STEPS, worst);
    return 0;
}}"""


def _rows(numbers: Array) -> str:
    lines = ["{" + ", ".join("NAN" if x != x else repr(x) for x in row) + "}," for row in numbers.tolist()]
    return "\n".join("\n".join(textwrap.wrap(x, 112, initial_indent="    ", subsequent_indent="     ")) for x in lines)
