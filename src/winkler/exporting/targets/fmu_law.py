"""A contact law as a functional mock-up unit (FMI 2.0 or 3.0, co-simulation): its source, and a binary."""

from __future__ import annotations

import io
import platform
import sys
import zipfile
from collections.abc import Mapping
from xml.sax.saxutils import quoteattr

from winkler.exporting.step_law import StepLaw, StepNumber
from winkler.exporting.targets.c_law import c_law
from winkler.exporting.targets.compilers import compiled_here, has_compiler
from winkler.exporting.targets.fmu_core import fmu_core
from winkler.exporting.targets.fmu_description import description, fmu_inputs, unit_and_start, unit_guid, unit_lines
from winkler.values.errors import InvalidInput

SYSTEMS = {
    ("linux", "x86_64"): ("linux64", ".so"),
    ("win32", "amd64"): ("win64", ".dll"),
    ("darwin", "x86_64"): ("darwin64", ".dylib"),
}
"""Systems for which FMI 2.0 has a folder of binaries, and the ending of their libraries."""
SYSTEMS3 = {
    ("linux", "x86_64"): ("x86_64-linux", ".so"),
    ("linux", "aarch64"): ("aarch64-linux", ".so"),
    ("win32", "amd64"): ("x86_64-windows", ".dll"),
    ("darwin", "x86_64"): ("x86_64-darwin", ".dylib"),
    ("darwin", "arm64"): ("aarch64-darwin", ".dylib"),
}
"""The same for FMI 3.0."""
DATE = (2026, 1, 1, 0, 0, 0)
"""Of every file in the unit, so that the same law gives the same unit."""


def refuse_every_radius(law: StepLaw) -> None:
    """Refuse a law of all radii: a unit is one contact."""
    if law.every_radius:
        raise InvalidInput("export: a unit is one contact, of the R of the study; leave every-radius out.")


def fmu_law(law: StepLaw, name: str) -> dict[str, str | bytes]:
    """Return the unit of FMI 2; with a binary for the system here where a C compiler is at hand, else as source."""
    refuse_every_radius(law)
    header = c_law(law, name)
    guid = unit_guid(header)
    sources = {f"{name}.h": header, f"{name}_fmu.c": fmu_source(law, name, guid)}
    return {f"{name}.fmu": _unit(name, description(law, name, guid), sources, {}, SYSTEMS)}


def fmu3_law(law: StepLaw, name: str) -> dict[str, str | bytes]:
    """Return the unit of FMI 3, in the same way."""
    refuse_every_radius(law)
    header = c_law(law, name)
    token = unit_guid(header)
    sources = {f"{name}.h": header, f"{name}_fmu.c": fmu3_source(law, name, token)}
    extra = {"sources/buildDescription.xml": build_description3(name)}
    return {f"{name}_fmi3.fmu": _unit(name, description3(law, name, token), sources, extra, SYSTEMS3)}


def _unit(
    name: str,
    described: str,
    sources: Mapping[str, str],
    extra: Mapping[str, str],
    systems: Mapping[tuple[str, str], tuple[str, str]],
) -> bytes:
    """Return the archive."""
    contents: dict[str, str | bytes] = {"modelDescription.xml": described}
    contents |= {f"sources/{file}": text for file, text in sources.items()}
    contents |= extra
    folder, ending = systems.get((sys.platform, platform.machine().lower()), ("", ""))
    if folder and has_compiler():
        contents[f"binaries/{folder}/{name}{ending}"] = compiled_here(sources, name + ending)
    archive = io.BytesIO()
    with zipfile.ZipFile(archive, "w", zipfile.ZIP_DEFLATED) as unit:
        for file, content in contents.items():
            unit.writestr(zipfile.ZipInfo(file, DATE), content, zipfile.ZIP_DEFLATED)
    return archive.getvalue()


def description3(law: StepLaw, name: str, token: str) -> str:
    """Return modelDescription.xml."""
    inputs = fmu_inputs(law)
    count = len(inputs)
    variables = [_variable(k, one, "input") for k, one in enumerate(inputs)]
    variables += [_variable(count + k, one, "output") for k, one in enumerate(law.answer)]
    variables.append(
        f'    <Float64 name="time" valueReference="{count + len(law.answer)}" causality="independent" '
        'variability="continuous"/>'
    )
    known = " ".join(map(str, range(count)))
    outputs = [f'valueReference="{count + k}" dependencies="{known}"' for k in range(len(law.answer))]
    structure = [f"    <Output {text}/>" for text in outputs] + [f"    <InitialUnknown {text}/>" for text in outputs]
    lines, unknown = "\n".join(variables), "\n".join(structure)
    return f"""<?xml version="1.0" encoding="UTF-8"?>
<fmiModelDescription fmiVersion="3.0" modelName="{name}" instantiationToken="{token}"
  description={quoteattr(law.title)} generationTool="winkler" variableNamingConvention="flat">
  <CoSimulation modelIdentifier="{name}" canHandleVariableCommunicationStepSize="true"
    canGetAndSetFMUState="true" canSerializeFMUState="true"/>
  <UnitDefinitions>
{unit_lines(law)}
  </UnitDefinitions>
  <ModelVariables>
{lines}
  </ModelVariables>
  <ModelStructure>
{unknown}
  </ModelStructure>
</fmiModelDescription>
"""


def build_description3(name: str) -> str:
    """Return sources/buildDescription.xml."""
    return f"""<?xml version="1.0" encoding="UTF-8"?>
<fmiBuildDescription fmiVersion="3.0">
  <BuildConfiguration modelIdentifier="{name}">
    <SourceFileSet language="C99">
      <SourceFile name="{name}_fmu.c"/>
    </SourceFileSet>
  </BuildConfiguration>
</fmiBuildDescription>
"""


def _variable(reference: int, one: StepNumber, causality: str) -> str:
    return (
        f'    <Float64 name="{one.name}" valueReference="{reference}" causality="{causality}" '
        f'variability="continuous" description={quoteattr(one.meaning)}{unit_and_start(one, causality)}/>'
    )


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
