"""The description of a contact law as a functional mock-up unit (FMI 2.0, co-simulation), in XML."""

from __future__ import annotations

import re
import uuid
from xml.sax.saxutils import quoteattr

from winkler.exporting.step_law import StepLaw, StepNumber

DURATION = "duration"
"""The input that the step of the master states."""
BASE_UNITS = {
    "m": 'm="1"', "s": 's="1"', "rad": 'rad="1"', "N": 'kg="1" m="1" s="-2"', "J": 'kg="1" m="2" s="-2"',
    "N m": 'kg="1" m="2" s="-2"', "N/m": 'kg="1" s="-2"',
}  # fmt: skip


def fmu_inputs(law: StepLaw) -> list[StepNumber]:
    """Return the inputs: where the bodies are, instead of by how much they move in a step."""
    inputs = []
    for one in law.motion:
        if one.name == DURATION:
            continue
        name = re.sub(r"^motion_", "position_", one.name)
        inputs.append(StepNumber(name, one.unit, _whole(one), one.changes))
    return inputs


def _whole(one: StepNumber) -> str:
    """Return what an input means that is no change."""
    if not one.changes:
        return one.meaning
    return f"since the beginning; the law needs its change in a step ({one.name})"


def unit_guid(content: str) -> str:
    """Return an identifier that changes with the content."""
    return str(uuid.uuid5(uuid.NAMESPACE_URL, content))


def unit_lines(law: StepLaw) -> str:
    """Return the definitions of the units that a law needs."""
    used = {one.unit for one in (*fmu_inputs(law), *law.answer)} & set(BASE_UNITS)
    return "\n".join(f'    <Unit name="{unit}"><BaseUnit {BASE_UNITS[unit]}/></Unit>' for unit in sorted(used))


def unit_and_start(one: StepNumber, causality: str) -> str:
    """Return the attributes of a number that both standards have."""
    start = ' start="0"' if causality == "input" else ""
    return f' unit="{one.unit}"{start}' if one.unit in BASE_UNITS else start


def description(law: StepLaw, name: str, guid: str) -> str:
    """Return modelDescription.xml."""
    inputs = fmu_inputs(law)
    variables = [_variable(k, one, "input") for k, one in enumerate(inputs)]
    variables += [_variable(len(inputs) + k, one, "output") for k, one in enumerate(law.answer)]
    known = " ".join(str(k + 1) for k in range(len(inputs)))
    outputs = range(len(inputs) + 1, len(inputs) + len(law.answer) + 1)
    unknown = "\n".join(f'      <Unknown index="{k}" dependencies="{known}"/>' for k in outputs)
    lines = "\n".join(variables)
    return f"""<?xml version="1.0" encoding="UTF-8"?>
<fmiModelDescription fmiVersion="2.0" modelName="{name}" guid="{guid}" description={quoteattr(law.title)}
  generationTool="winkler" variableNamingConvention="flat" numberOfEventIndicators="0">
  <CoSimulation modelIdentifier="{name}" canHandleVariableCommunicationStepSize="true"
    canGetAndSetFMUstate="true" canSerializeFMUstate="true">
    <SourceFiles><File name="{name}_fmu.c"/></SourceFiles>
  </CoSimulation>
  <UnitDefinitions>
{unit_lines(law)}
  </UnitDefinitions>
  <ModelVariables>
{lines}
  </ModelVariables>
  <ModelStructure>
    <Outputs>
{unknown}
    </Outputs>
    <InitialUnknowns>
{unknown}
    </InitialUnknowns>
  </ModelStructure>
</fmiModelDescription>
"""


def _variable(reference: int, one: StepNumber, causality: str) -> str:
    return (
        f'    <ScalarVariable name="{one.name}" valueReference="{reference}" causality="{causality}" '
        f'variability="continuous" description={quoteattr(one.meaning)}>'
        f"<Real{unit_and_start(one, causality)}/></ScalarVariable>"
    )
