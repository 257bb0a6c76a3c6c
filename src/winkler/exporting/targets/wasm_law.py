"""A contact law as a WebAssembly module, compiled by the wheel `ziglang`, with an example in JavaScript."""

from __future__ import annotations

import json

from winkler.exporting.step_law import StepLaw
from winkler.exporting.targets.c_law import c_law
from winkler.exporting.targets.compilers import compiled_by_zig
from winkler.exporting.targets.one_export import MARK, marked

OPTIONS = ("-mexec-model=reactor", "-Wl,--strip-all")


def wasm_law(law: StepLaw, name: str) -> dict[str, str | bytes]:
    """Return the module, its source, and an example in JavaScript.

    Raises
    ------
    InvalidInput
        If there is no compiler, or it fails.
    """
    example = f"{name}.mjs"
    files = marked({example: _example(law, name), f"{name}.h": c_law(law, name), f"{name}_wasm.c": _glue(law, name)})
    sources = {file: text for file, text in files.items() if file != example}
    return {f"{name}.wasm": compiled_by_zig(sources, "wasm32-wasi", OPTIONS, f"{name}.wasm"), **files}


def _glue(law: StepLaw, name: str) -> str:
    """Return what the module exports: one place for motion and answer, and contacts side by side."""
    return f"""/* What {name}.wasm exports. Contacts stand side by side; motion and answer are arrays of numbers. */
#include "{name}.h"

#define EXPORTED(name) __attribute__((export_name(name)))
#define MOST 4096

static {name}_state contacts[MOST];
static {name}_motion motion;
static {name}_answer answer;

EXPORTED("export_{MARK}") int export_mark(void) {{ return 1; }}
EXPORTED("most") int most(void) {{ return MOST; }}
EXPORTED("motion") double *motion_at(void) {{ return (double *)&motion; }}
EXPORTED("answer") double *answer_at(void) {{ return (double *)&answer; }}
EXPORTED("begin") void begin(int which) {{ {name}_begin(&contacts[which]); }}
EXPORTED("step") void step(int which) {{ {name}_step(&contacts[which], &motion, &answer); }}
"""


def _example(law: StepLaw, name: str) -> str:
    """Return the example: a trace of winkler, step by step, in a browser or in Node."""
    takes = json.dumps([one.name for one in law.motion])
    gives = json.dumps([one.name for one in law.answer])
    return f"""// {law.title}: {name}.wasm from JavaScript. Test: node {name}.mjs
export const MOTION = {takes};
export const ANSWER = {gives};

// Give the bytes of {name}.wasm; contacts are numbered from 0.
export async function load(bytes) {{
  const wasi = new Proxy({{}}, {{ get: () => () => 0 }}); // the module asks its host for nothing
  const {{ instance }} = await WebAssembly.instantiate(bytes, {{ wasi_snapshot_preview1: wasi }});
  const own = instance.exports;
  if (!own.export_{MARK}) throw new Error("{name}.wasm is of another export than {name}.mjs; export all files again");
  own._initialize?.();
  const view = (at, count) => new Float64Array(own.memory.buffer, at, count);
  return {{
    most: own.most(),
    begin: (contact) => own.begin(contact),
    step: (contact, motion) => {{
      view(own.motion(), MOTION.length).set(motion);
      own.step(contact);
      return Array.from(view(own.answer(), ANSWER.length));
    }},
  }};
}}

const trial = {json.dumps(law.trial.tolist())};
const expected = {json.dumps(law.trace().tolist())};
if (typeof process !== "undefined" && process.argv[1]?.endsWith("{name}.mjs")) {{
  const {{ readFileSync }} = await import("node:fs");
  const law = await load(readFileSync(new URL("{name}.wasm", import.meta.url)));
  law.begin(0);
  const found = trial.map((motion) => law.step(0, motion));
  const worst = Math.max(...ANSWER.map((_, k) => Math.max(...found.map((row, n) => Math.abs(row[k] - expected[n][k])))
    / Math.max(1e-300, ...expected.map((row) => Math.abs(row[k])))));
  console.log(`{name}: ${{trial.length}} steps agree with winkler to ${{worst.toPrecision(2)}}`);
  process.exitCode = worst <= 1e-11 ? 0 : 1;
}}
"""
