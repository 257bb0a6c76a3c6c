"""A contact law as a Fortran 2008 module over its C file, by iso_c_binding, with a program that tests it."""

from __future__ import annotations

import textwrap

import numpy as np

from winkler.exporting.step_law import StepLaw, StepNumber
from winkler.exporting.targets.c_example import TRACE_TOLERANCE
from winkler.exporting.targets.c_law import c_law
from winkler.exporting.targets.heading import heading_lines
from winkler.exporting.targets.one_export import MARK, marked
from winkler.numerics.types import Array

KINDS = {"f": "real(c_double)", "i": "integer(c_int64_t)", "b": "logical(c_bool)"}


def fortran_law(law: StepLaw, name: str) -> dict[str, str]:
    """Return the files: the C file, what compiles it, the module, and the program."""
    files = {
        f"{name}.f90": _module(law, name),
        f"{name}.h": c_law(law, name),
        f"{name}_c.c": c_wrapper(name),
        f"{name}_test.f90": _program(law, name),
    }
    return marked(files)


def c_wrapper(name: str) -> str:
    """Return a C file with the functions of a law for other languages to call."""
    return f"""/* The functions of {name}.h for other languages. */
#include "{name}.h"

void {name}_begin_{MARK}({name}_state *state) {{ {name}_begin(state); }}

void {name}_step_{MARK}({name}_state *state, const {name}_motion *motion, {name}_answer *answer) {{
    {name}_step(state, motion, answer);
}}
"""


def _module(law: StepLaw, name: str) -> str:
    use = f"Test: cc -O2 -c {name}_c.c && gfortran {name}.f90 {name}_test.f90 {name}_c.o -o {name} -lm && ./{name}"
    heading = "\n".join(f"! {line}".rstrip() for line in [*heading_lines(law), "", use])
    state = [f"{KINDS[part.begin.dtype.kind]} :: {part.name}_({part.begin.size})" for part in law.state]
    members = "\n".join(f"    {line}" for line in state or ["integer(c_signed_char) :: nothing"])
    return f"""{heading}
module {name}
  use, intrinsic :: iso_c_binding
  implicit none

  ! Of this export; the functions of C have it in their names.
  integer, parameter :: {name}_export_{MARK} = 1

  ! What one contact remembers.
  type, bind(c) :: {name}_state
{members}
  end type

  ! What goes into a step.
  type, bind(c) :: {name}_motion
{_members(law.motion)}
  end type

  ! What comes out of it.
  type, bind(c) :: {name}_answer
{_members(law.answer)}
  end type

  interface
    ! Set a contact apart, as before the first touch.
    subroutine {name}_begin(state) bind(c, name="{name}_begin_{MARK}")
      import :: {name}_state
      type({name}_state), intent(out) :: state
    end subroutine

    ! Move a contact by one step.
    subroutine {name}_step(state, motion, answer) bind(c, name="{name}_step_{MARK}")
      import :: {name}_state, {name}_motion, {name}_answer
      type({name}_state), intent(inout) :: state
      type({name}_motion), intent(in) :: motion
      type({name}_answer), intent(out) :: answer
    end subroutine
  end interface
end module
"""


def _members(quantities: tuple[StepNumber, ...]) -> str:
    return "\n".join(f"    real(c_double) :: {one.name} ! [{one.unit}]" for one in quantities)


def _program(law: StepLaw, name: str) -> str:
    answers = law.trace()
    scale = np.maximum(np.max(np.abs(answers), axis=0), 1e-300)
    takes, gives, steps = len(law.motion), len(law.answer), len(law.trial)
    put = "\n".join(f"    motion%{one.name} = trial({k + 1}, step)" for k, one in enumerate(law.motion))
    got = ", ".join(f"answer%{one.name}" for one in law.answer)
    return f"""! Compares a trace of winkler with what {name}.h computes; stops with an error if they disagree.
program {name}_test
  use, intrinsic :: iso_c_binding
  use {name}
  implicit none
  type({name}_state) :: state
  type({name}_motion) :: motion
  type({name}_answer) :: answer
  real(c_double) :: trial({takes}, {steps}), expected({gives}, {steps}), scale({gives}), got({gives}), worst
  integer :: step

{_rows("trial", law.trial)}
{_rows("expected", answers)}
{_row("scale", scale)}
  if ({name}_export_{MARK} /= 1) error stop 1
  worst = 0
  call {name}_begin(state)
  do step = 1, {steps}
{put}
    call {name}_step(state, motion, answer)
    got = [{_wrapped(got)}]
    worst = max(worst, maxval(abs(got - expected(:, step)) / scale))
  end do
  print "(a, es8.1)", "{name}: the steps agree with winkler to", worst
  if (.not. worst <= {_number(TRACE_TOLERANCE)}) error stop 1
end program
"""


def _number(number: float) -> str:
    text = repr(number)
    return f"{text}_c_double"


def _wrapped(text: str) -> str:
    return " &\n      ".join(textwrap.wrap(text, 100))


def _rows(name: str, numbers: Array) -> str:
    return "\n".join(_row(f"{name}(:, {k + 1})", row) for k, row in enumerate(numbers))


def _row(name: str, numbers: Array) -> str:
    return f"  {name} = [{_wrapped(', '.join(map(_number, numbers.tolist())))}]"
