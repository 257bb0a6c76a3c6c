"""What units for co-simulation of FMI 2 and FMI 3 share: a contact, its inputs and outputs, and a step."""

from __future__ import annotations

from winkler.exporting.step_law import StepLaw
from winkler.exporting.targets.fmu_description import DURATION


def fmu_core(law: StepLaw, name: str, version: int) -> str:
    """Return the beginning of the C file."""
    lines, place = [], 0
    for one in law.motion:
        if one.name == DURATION:
            lines.append(f"    motion.{one.name} = step;")
            continue
        change = f" - unit->last[{place}]" if one.changes else ""
        lines.append(f"    motion.{one.name} = unit->input[{place}]{change};")
        place += 1
    setting = "\n".join(lines)
    return f"""/* {law.title}, as a unit for co-simulation by FMI {version}.0. */
#include "{name}.h"

#if defined _WIN32
#define EXPORTED __declspec(dllexport)
#else
#define EXPORTED __attribute__((visibility("default")))
#endif
#ifdef FMI{version}_FUNCTION_PREFIX
#define JOINED(a, b) a##b
#define NAMED(a, b) JOINED(a, b)
#define FMI(name) EXPORTED NAMED(FMI{version}_FUNCTION_PREFIX, name)
#else
#define FMI(name) EXPORTED name
#endif

enum {{ INPUTS = {place}, OUTPUTS = {len(law.answer)}, TIMES = {int(version == 3)} }};
enum {{ OK = 0, ERROR = 3 }};
typedef void *Unit;
typedef unsigned int Reference;
typedef int Whole;
typedef int Truth;
typedef const char *Text;
typedef int Status;

typedef struct {{
    {name}_state state;
    double input[INPUTS], last[INPUTS], output[OUTPUTS], time;
}} Contact;

/* Move to where the inputs are; an answer that is no number is an error. */
static Status move(Contact *unit, double step) {{
    {name}_motion motion;
    {name}_answer answer;
    (void)step;
{setting}
    {name}_step(&unit->state, &motion, &answer);
    memcpy(unit->output, &answer, sizeof(unit->output));
    memcpy(unit->last, unit->input, sizeof(unit->last));
    for (int k = 0; k < OUTPUTS; ++k) if (unit->output[k] != unit->output[k]) return ERROR;
    return OK;
}}

static Status begin(Contact *unit) {{
    memset(unit, 0, sizeof(*unit));
    {name}_begin(&unit->state);
    return OK;
}}

/* Read or write numbers by their references. */
static Status read(const Contact *unit, const Reference r[], size_t n, double value[]) {{
    for (size_t k = 0; k < n; ++k) {{
        if (r[k] >= INPUTS + OUTPUTS + TIMES) return ERROR;
        if (r[k] < INPUTS) value[k] = unit->input[r[k]];
        else value[k] = r[k] < INPUTS + OUTPUTS ? unit->output[r[k] - INPUTS] : unit->time;
    }}
    return OK;
}}

static Status write(Contact *unit, const Reference r[], size_t n, const double value[]) {{
    for (size_t k = 0; k < n; ++k) {{
        if (r[k] >= INPUTS) return ERROR;
        unit->input[r[k]] = value[k];
    }}
    return OK;
}}

static Contact *made_unit(const char *given, const char *own) {{
    if (!given || strcmp(given, own) != 0) return NULL;
    Contact *unit = (Contact *)malloc(sizeof(Contact));
    if (unit) begin(unit);
    return unit;
}}

/* The bodies are where they are without having slipped. */
static Status start(Contact *unit) {{
    memcpy(unit->last, unit->input, sizeof(unit->last));
    return move(unit, 0.0);
}}

static Status keep(const void *unit, void **kept) {{
    if (!*kept) *kept = malloc(sizeof(Contact));
    if (!*kept) return ERROR;
    memcpy(*kept, unit, sizeof(Contact));
    return OK;
}}
"""
