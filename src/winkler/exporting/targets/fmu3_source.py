"""The functions of a functional mock-up unit (FMI 3.0, co-simulation) around a contact law in C."""

from __future__ import annotations

from winkler.exporting.step_law import StepLaw
from winkler.exporting.targets.fmu_core import fmu_core

__all__ = ["fmu3_source"]

TYPES = "Float32 Int8 UInt8 Int16 UInt16 Int32 UInt32 Int64 UInt64 Boolean String Binary Clock"
"""Of variables that no unit has."""
NOT_HERE = (
    "GetNumberOfVariableDependencies GetVariableDependencies GetDirectionalDerivative GetAdjointDerivative "
    "EnterConfigurationMode ExitConfigurationMode GetIntervalDecimal GetIntervalFraction GetShiftDecimal "
    "GetShiftFraction SetIntervalDecimal SetIntervalFraction SetShiftDecimal SetShiftFraction EvaluateDiscreteStates "
    "UpdateDiscreteStates EnterEventMode EnterStepMode GetOutputDerivatives EnterContinuousTimeMode "
    "CompletedIntegratorStep SetTime SetContinuousStates GetContinuousStateDerivatives GetEventIndicators "
    "GetContinuousStates GetNominalsOfContinuousStates GetNumberOfEventIndicators GetNumberOfContinuousStates "
    "ActivateModelPartition"
)
"""Functions for what the unit is not; they return the status of an error, and importers look for their names."""


def fmu3_source(law: StepLaw, name: str, token: str) -> str:
    """Return the C file."""
    none = "\n".join(f"NONE(fmi3Get{kind}, fmi3Set{kind})" for kind in TYPES.split())
    missing = "\n".join(f"NOT_HERE(fmi3{function})" for function in NOT_HERE.split())
    return f"""{fmu_core(law, name, 3)}
Text FMI(fmi3GetVersion)(void) {{ return "3.0"; }}
Status FMI(fmi3SetDebugLogging)(Unit u, bool on, size_t n, const Text c[]) {{
    (void)u; (void)on; (void)n; (void)c; return OK;
}}

Unit FMI(fmi3InstantiateCoSimulation)(
    Text name, Text token, Text resources, bool visible, bool log, bool events, bool early,
    const Reference required[], size_t count, void *environment, void *message, void *update) {{
    (void)name; (void)resources; (void)visible; (void)log; (void)events; (void)early; (void)required; (void)count;
    (void)environment; (void)message; (void)update;
    return made_unit(token, "{token}");
}}
Unit FMI(fmi3InstantiateModelExchange)(void) {{ return NULL; }}
Unit FMI(fmi3InstantiateScheduledExecution)(void) {{ return NULL; }}
void FMI(fmi3FreeInstance)(Unit u) {{ free(u); }}
Status FMI(fmi3EnterInitializationMode)(
    Unit u, bool given, double tolerance, double time, bool stated, double stop) {{
    (void)given; (void)tolerance; (void)stated; (void)stop;
    ((Contact *)u)->time = time;
    return OK;
}}
Status FMI(fmi3ExitInitializationMode)(Unit u) {{ return start((Contact *)u); }}
Status FMI(fmi3Terminate)(Unit u) {{ (void)u; return OK; }}
Status FMI(fmi3Reset)(Unit u) {{ return begin((Contact *)u); }}

Status FMI(fmi3GetFloat64)(Unit u, const Reference r[], size_t n, double value[], size_t m) {{
    return n == m ? read((const Contact *)u, r, n, value) : ERROR;
}}
Status FMI(fmi3SetFloat64)(Unit u, const Reference r[], size_t n, const double value[], size_t m) {{
    return n == m ? write((Contact *)u, r, n, value) : ERROR;
}}
#define NONE(get, set) \\
    Status FMI(get)(Unit u, const Reference r[], size_t n) {{ (void)u; (void)r; return n ? ERROR : OK; }} \\
    Status FMI(set)(Unit u, const Reference r[], size_t n) {{ (void)u; (void)r; return n ? ERROR : OK; }}
{none}
#define NOT_HERE(name) Status FMI(name)(Unit u) {{ (void)u; return ERROR; }}
{missing}

Status FMI(fmi3GetFMUState)(Unit u, void **kept) {{ return keep(u, kept); }}
Status FMI(fmi3SetFMUState)(Unit u, void *kept) {{ memcpy(u, kept, sizeof(Contact)); return OK; }}
Status FMI(fmi3FreeFMUState)(Unit u, void **kept) {{ (void)u; free(*kept); *kept = NULL; return OK; }}
Status FMI(fmi3SerializedFMUStateSize)(Unit u, void *kept, size_t *n) {{
    (void)u; (void)kept; *n = sizeof(Contact); return OK;
}}
Status FMI(fmi3SerializeFMUState)(Unit u, void *kept, unsigned char bytes[], size_t n) {{
    (void)u;
    if (n < sizeof(Contact)) return ERROR;
    memcpy(bytes, kept, sizeof(Contact));
    return OK;
}}
Status FMI(fmi3DeserializeFMUState)(Unit u, const unsigned char bytes[], size_t n, void **kept) {{
    (void)u;
    return n < sizeof(Contact) ? ERROR : keep(bytes, kept);
}}

Status FMI(fmi3DoStep)(
    Unit u, double time, double step, bool final, bool *event, bool *terminate, bool *early, double *reached) {{
    Contact *unit = (Contact *)u;
    (void)final;
    *event = *terminate = *early = false;
    const Status status = move(unit, step);
    unit->time = *reached = status == OK ? time + step : time;
    return status;
}}
"""
