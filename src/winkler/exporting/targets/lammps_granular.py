"""A contact law without friction as a normal sub-model of LAMMPS' pair style granular, which is built into LAMMPS."""

from __future__ import annotations

from collections.abc import Mapping

from winkler.exporting.step_law import StepLaw
from winkler.exporting.targets.c_law import ITEMS

MOTIONS = {
    "depth": "share * gm->delta",
    "duration": "gm->history_update ? gm->dt : 0.0",
    "curvature_radius": "gm->Reff / share",
}


def granular_law(law: StepLaw, name: str, hold: float, radii: Mapping[str, str]) -> dict[str, str]:
    """Return header and source of the sub-model.

    Parameters
    ----------
    law : StepLaw
        Of depth and time alone.
    name : str
    hold : float
        Farthest distance over which the bodies attract each other [m].
    radii : mapping
        R that all bodies must have, and R of a law of all radii.
    """
    words = {
        "title": law.title.replace("*/", "* /"),
        "name": name,
        "guard": name.upper(),
        "Name": "".join(part.capitalize() for part in name.split("_")),
        "size": str(1 + sum(part.begin.size for part in law.state) if law.state else 0),
        "cohesive": "1" if hold else "0",
        "hold": repr(hold * (2.0 if law.against_plane else 1.0)),
        "shared": "gm->contact_type == PAIR ? 0.5 : 1.0" if law.against_plane else "1.0",
        **radii,
        "takes": "\n    ".join(f"motion.{one.name} = {MOTIONS[one.name]};" for one in law.motion),
        "recall": _each(law, "{to} = {kind}memory[{at} + k];"),
        "keep": _each(law, "memory[{at} + k] = (double){to};"),
    }
    files = {f"gran_sub_mod_{name}.h": HEADER, f"gran_sub_mod_{name}.cpp": SOURCE}
    for word, content in words.items():
        files = {file: text.replace(f"@{word}@", content) for file, text in files.items()}
    return files


def _each(law: StepLaw, line: str) -> str:
    """Return loops over the state; whole numbers and truth values stand in the history as real numbers."""
    lines, at = [], 1
    for part in law.state:
        kind = ITEMS[part.begin.dtype.kind][1]
        text = line.format(to=f"state.{part.name}[k]", at=at, kind="0.0 != " if kind == "bool" else f"({kind})")
        lines.append(f"for (int k = 0; k < {part.begin.size}; ++k) {text}")
        at += part.begin.size
    return "\n        ".join(lines)


HEADER = r"""/* @title@, as a normal sub-model of LAMMPS.

Copy gran_sub_mod_@name@.h, gran_sub_mod_@name@.cpp and @name@.h into src/GRANULAR and build LAMMPS; releases that keep
a table of sub-models (gran_sub_mod_register.cpp) need a line there.  Use, in units si:
  pair_coeff * * @name@ ETA tangential ... damping ...
ETA is the coefficient of LAMMPS' damping model. */
#ifdef GRAN_SUB_MOD_CLASS
GranSubModStyle(@name@,GranSubModNormal@Name@,NORMAL);
#else

#ifndef GRAN_SUB_MOD_@guard@_H
#define GRAN_SUB_MOD_@guard@_H

#include "gran_sub_mod.h"
#include "gran_sub_mod_normal.h"

namespace LAMMPS_NS {
namespace Granular_NS {

class GranSubModNormal@Name@ : public GranSubModNormal {
 public:
    GranSubModNormal@Name@(class GranularModel *, class LAMMPS *);
    void coeffs_to_local() override;
    bool touch() override;
    double pulloff_distance(double, double) override;
    double calculate_forces() override;
    void set_fncrit() override;
};

}    // namespace Granular_NS
}    // namespace LAMMPS_NS

#endif
#endif
"""

SOURCE = r"""/* @title@, as a normal sub-model of LAMMPS: see the header. */
#include "gran_sub_mod_@name@.h"
#include "@name@.h"

#include "error.h"
#include "granular_model.h"
#include "update.h"

#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;
using namespace Granular_NS;

static const int SIZE = @size@;         /* numbers that a contact remembers */
static const double HOLD = @hold@;     /* farthest distance over which the bodies attract [m] */
static const double RADIUS = @radius@; /* R that the contacts must have [m]; 0 if it may be any */
static const double GIVEN = @given@;   /* R to which HOLD belongs [m]; 0 if it is that of all contacts */

/* Greater bodies attract farther, at most in proportion. */
static double holds(double radius) { return GIVEN > 0.0 ? HOLD * std::fmax(1.0, 2.0 * radius / GIVEN) : HOLD; }

GranSubModNormal@Name@::GranSubModNormal@Name@(GranularModel *gm, LAMMPS *lmp) : GranSubModNormal(gm, lmp) {
    num_coeffs = 1;
    contact_radius_flag = 1;
    size_history = SIZE;
    cohesive_flag = @cohesive@;
    beyond_contact = HOLD > 0.0;
    if (SIZE > 0) { /* the history is the same from either side */
        nondefault_history_transfer = 1;
        transfer_history_factor = new double[SIZE > 0 ? SIZE : 1];
        for (int k = 0; k < SIZE; ++k) transfer_history_factor[k] = 1.0;
    }
}

void GranSubModNormal@Name@::coeffs_to_local() {
    damp = coeffs[0];
    if (damp < 0.0) error->all(FLERR, "Normal model @name@: the coefficient of damping is not negative");
    if (std::strcmp(update->unit_style, "si") != 0) error->all(FLERR, "Normal model @name@ needs units si");
}

/* Bodies that touched stay together as far as they may attract each other; the law knows when they part. */
bool GranSubModNormal@Name@::touch() {
    const double reach = gm->radsum + (gm->touch ? holds(gm->Reff) : 0.0);
    return gm->rsq < reach * reach;
}

double GranSubModNormal@Name@::pulloff_distance(double a, double b) { return holds(std::fmax(a, b)); }

double GranSubModNormal@Name@::calculate_forces() {
    const double share = @shared@;
    if (RADIUS > 0.0 && gm->delta > 0.0 && std::fabs(gm->Reff - share * RADIUS) > 1e-6 * RADIUS)
        error->one(FLERR, "Normal model @name@ was made for R = {} m, two bodies have {} m", share * RADIUS, gm->Reff);
    @name@_state state;
    @name@_motion motion;
    @name@_answer answer;
    @name@_begin(&state);
    double *memory = SIZE > 0 ? &gm->history[history_index] : nullptr;
    if (SIZE > 0 && memory[0] != 0.0) {
        @recall@
    }
    @takes@
    @name@_step(&state, &motion, &answer);
    if (!(answer.force == answer.force))
        error->one(FLERR, "Normal model @name@: an overlap of {} m is deeper than the law goes", gm->delta);
    if (SIZE > 0 && gm->history_update) {
        memory[0] = 1.0;
        @keep@
    }
    (void)memory;
    (void)share;
    return answer.force;
}

/* Friction is bounded by the force of pressing alone: nothing where the bodies pull. */
void GranSubModNormal@Name@::set_fncrit() { Fncrit = std::fmax(gm->Fntot, 0.0); }
"""
