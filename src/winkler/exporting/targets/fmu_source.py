"""The functions of a functional mock-up unit (FMI 2.0, co-simulation) around a contact law in C."""

from __future__ import annotations

from winkler.exporting.step_law import StepLaw
from winkler.exporting.targets.fmu_core import fmu_core

__all__ = ["fmu_source"]


def fmu_source(law: StepLaw, name: str, guid: str) -> str:
    """Return the C file."""
    return f"""{fmu_core(law, name, 2)}
Text FMI(fmi2GetTypesPlatform)(void) {{ return "default"; }}
Text FMI(fmi2GetVersion)(void) {{ return "2.0"; }}
Status FMI(fmi2SetDebugLogging)(Unit u, Truth on, size_t n, const Text c[]) {{
    (void)u; (void)on; (void)n; (void)c; return OK;
}}

Unit FMI(fmi2Instantiate)(
    Text name, int kind, Text guid, Text resources, const void *calls, Truth visible, Truth log) {{
    (void)name; (void)resources; (void)calls; (void)visible; (void)log;
    return kind == 1 ? made_unit(guid, "{guid}") : NULL;
}}
void FMI(fmi2FreeInstance)(Unit u) {{ free(u); }}
Status FMI(fmi2SetupExperiment)(Unit u, Truth given, double tolerance, double start, Truth stated, double stop) {{
    (void)u; (void)given; (void)tolerance; (void)start; (void)stated; (void)stop; return OK;
}}
Status FMI(fmi2EnterInitializationMode)(Unit u) {{ (void)u; return OK; }}
Status FMI(fmi2ExitInitializationMode)(Unit u) {{ return start((Contact *)u); }}
Status FMI(fmi2Terminate)(Unit u) {{ (void)u; return OK; }}
Status FMI(fmi2Reset)(Unit u) {{ return begin((Contact *)u); }}

Status FMI(fmi2GetReal)(Unit u, const Reference r[], size_t n, double value[]) {{
    return read((const Contact *)u, r, n, value);
}}
Status FMI(fmi2SetReal)(Unit u, const Reference r[], size_t n, const double value[]) {{
    return write((Contact *)u, r, n, value);
}}
#define NONE(get, set, type) \\
    Status FMI(get)(Unit u, const Reference r[], size_t n, type v[]) {{ \\
        (void)u; (void)r; (void)v; return n ? ERROR : OK; \\
    }} \\
    Status FMI(set)(Unit u, const Reference r[], size_t n, const type v[]) {{ \\
        (void)u; (void)r; (void)v; return n ? ERROR : OK; \\
    }}
NONE(fmi2GetInteger, fmi2SetInteger, Whole)
NONE(fmi2GetBoolean, fmi2SetBoolean, Truth)
NONE(fmi2GetString, fmi2SetString, Text)

Status FMI(fmi2GetFMUstate)(Unit u, void **kept) {{ return keep(u, kept); }}
Status FMI(fmi2SetFMUstate)(Unit u, void *kept) {{ memcpy(u, kept, sizeof(Contact)); return OK; }}
Status FMI(fmi2FreeFMUstate)(Unit u, void **kept) {{ (void)u; free(*kept); *kept = NULL; return OK; }}
Status FMI(fmi2SerializedFMUstateSize)(Unit u, void *kept, size_t *n) {{
    (void)u; (void)kept; *n = sizeof(Contact); return OK;
}}
Status FMI(fmi2SerializeFMUstate)(Unit u, void *kept, char bytes[], size_t n) {{
    (void)u;
    if (n < sizeof(Contact)) return ERROR;
    memcpy(bytes, kept, sizeof(Contact));
    return OK;
}}
Status FMI(fmi2DeSerializeFMUstate)(Unit u, const char bytes[], size_t n, void **kept) {{
    (void)u;
    if (n < sizeof(Contact)) return ERROR;
    return keep(bytes, kept);
}}
Status FMI(fmi2GetDirectionalDerivative)(
    Unit u, const Reference a[], size_t n, const Reference b[], size_t m, const double s[], double t[]) {{
    (void)u; (void)a; (void)n; (void)b; (void)m; (void)s; (void)t; return ERROR;
}}
Status FMI(fmi2SetRealInputDerivatives)(Unit u, const Reference r[], size_t n, const Whole o[], const double v[]) {{
    (void)u; (void)r; (void)n; (void)o; (void)v; return ERROR;
}}
Status FMI(fmi2GetRealOutputDerivatives)(Unit u, const Reference r[], size_t n, const Whole o[], double v[]) {{
    (void)u; (void)r; (void)n; (void)o; (void)v; return ERROR;
}}
Status FMI(fmi2DoStep)(Unit u, double time, double step, Truth keep) {{
    (void)time; (void)keep; return move((Contact *)u, step);
}}
Status FMI(fmi2CancelStep)(Unit u) {{ (void)u; return ERROR; }}
#define NO_STATUS(get, type) \\
    Status FMI(get)(Unit u, int kind, type *value) {{ (void)u; (void)kind; (void)value; return ERROR; }}
NO_STATUS(fmi2GetStatus, Status)
NO_STATUS(fmi2GetRealStatus, double)
NO_STATUS(fmi2GetIntegerStatus, Whole)
NO_STATUS(fmi2GetBooleanStatus, Truth)
NO_STATUS(fmi2GetStringStatus, Text)
"""
