"""The description of a contact law as a functional mock-up unit (FMI 3.0, co-simulation), in XML."""

from __future__ import annotations

from xml.sax.saxutils import quoteattr

from winkler.exporting.step_law import StepLaw, StepNumber
from winkler.exporting.targets.fmu_description import fmu_inputs, unit_and_start, unit_lines

__all__ = ["build_description3", "description3"]


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
