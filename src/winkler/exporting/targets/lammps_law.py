"""A contact law for LAMMPS: a pair style that the command `plugin load` adds, over the C file."""

from __future__ import annotations

import math

import numpy as np

from winkler.exporting.step_law import StepLaw
from winkler.exporting.targets.c_law import c_law
from winkler.exporting.targets.lammps_contact import CONTACT, MADE
from winkler.exporting.targets.lammps_granular import granular_law
from winkler.exporting.targets.one_export import marked
from winkler.exporting.translation.plain import plain
from winkler.values.errors import InvalidInput

MOTIONS = {
    "depth": "depth",
    "duration": "step",
    "motion_x": "dot(slide, one)",
    "motion_y": "dot(slide, two)",
    "twist": "dot(turn, n)",
    "roll_x": "dot(turn, one)",
    "roll_y": "dot(turn, two)",
    "curvature_radius": "R",
}
"""What a law takes -> what it is in the pair style."""
MOMENTS = (("torque", "n"), ("rolling_x", "one"), ("rolling_y", "two"))
LOADS, HALVINGS, MARGIN = 10, 40, 1.2


def lammps_law(law: StepLaw, name: str) -> dict[str, str]:
    """Return the files: the pair style, the law in C, and, without friction, the sub-model for pair style granular.

    Raises
    ------
    InvalidInput
        If the law takes another motion than those of two balls.
    """
    unknown = [one.name for one in law.motion if one.name not in MOTIONS]
    if unknown:
        raise InvalidInput(f"export: LAMMPS knows no {unknown[0]} of two balls; export this law to c.")
    hold = farthest_hold(law)
    files = {f"pair_{name}.cpp": _filled(law, name, hold), f"{name}.h": c_law(law, name)}
    return marked(files | granular_law(law, name, hold, radii_of(law)) if is_normal(law) else files)


def radii_of(law: StepLaw) -> dict[str, str]:
    """Return R that every pair must have, and R of a law of all radii [m]; zero where there is none."""
    given = "0.0" if math.isnan(law.curvature_radius) else repr(law.curvature_radius)
    return {"radius": "0.0" if law.every_radius else given, "given": given if law.every_radius else "0.0"}


def is_normal(law: StepLaw) -> bool:
    """Return whether the law needs nothing but depth and time."""
    return {one.name for one in law.motion} <= {"depth", "duration", "curvature_radius"}


def farthest_hold(law: StepLaw) -> float:
    """Return how far apart the bodies still attract each other [m], after any load, with a margin; 0 if they do not."""
    names = [one.name for one in law.answer]
    if "radius" not in names or {one.name for one in law.motion} - {"curvature_radius"} != {"depth"}:
        return 0.0
    deepest = float(np.max(law.trial[:, 0]))
    if law.every_radius:
        deepest *= law.curvature_radius / float(law.trial[0, -1])
    farthest = 0.0
    for load in deepest * np.geomspace(1e-4, 1.0, LOADS):
        near, far = 0.0, 10.0 * deepest
        for _ in range(HALVINGS):
            middle = 0.5 * (near + far)
            if _holds(law, load, middle, names.index("radius")):
                near = middle
            else:
                far = middle
        farthest = max(farthest, near)
    return float(MARGIN * farthest)


def _holds(law: StepLaw, load: float, apart: float, column: int) -> bool:
    """Return whether the bodies still hold each other a distance apart, after a load."""
    tables = [np.array(table.numbers, dtype=float) for table in law.tables]
    state = [np.array(part.begin) for part in law.state]
    answer, step = np.zeros(len(law.answer)), plain(law.kernel)
    for depth in (load, -apart):
        step(*tables, *state, np.array([depth]), answer)
    return bool(answer[column] > 0.0)


def _filled(law: StepLaw, name: str, hold: float) -> str:
    """Return the pair style."""
    takes = [f"motion.{one.name} = {MOTIONS[one.name]};" for one in law.motion]
    given = {one.name for one in law.answer}
    adds = []
    if "shear_x" in given:
        adds.append("push[k] -= answer.shear_x * one[k] + answer.shear_y * two[k];")
    moments = [f"answer.{part} * {axis}[k]" for part, axis in MOMENTS if part in given]
    if moments:
        adds.append(f"moment[k] -= {' + '.join(moments)};")
    words = {
        "title": law.title.replace("*/", "* /"),
        "name": name,
        "takes": "\n    ".join(takes),
        "adds": "\n        ".join(adds),
        "slides": "false" if is_normal(law) else "true",
        "remembers": "true" if law.state else "false",
        "stored": "answer.energy" if not law.state else "0.0",
        "hold": repr(hold * (2.0 if law.against_plane else 1.0)),
        **radii_of(law),
        "shared": "0.5" if law.against_plane else "1.0",
    }
    text = CONTACT + PAIR + WALL + MADE
    for word, content in words.items():
        text = text.replace(f"@{word}@", content)
    return text


PAIR = r"""
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
        contacts.begin();
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
                    own = contacts.find(atom->tag[a], atom->tag[b], overlap);
                    if (!own) continue;
                    if (contacts.twice)
                        error->one(FLERR, "pair_style @name@: two images of one sphere are near: use a larger box");
                } else {
                    if (!(overlap > 0.0)) continue;
                    own = &fresh;
                }
                if (overlap > 0.0) check_radii(radius[a], radius[b]);
                const double whole = 1.0 / distance;
                for (int k = 0; k < 3; ++k) n[k] *= whole;
                const double arm_a = radius[a] - 0.5 * overlap, arm_b = radius[b] - 0.5 * overlap;
                double slide[3] = {0.0, 0.0, 0.0}, turn[3] = {0.0, 0.0, 0.0}, spin[3] = {0.0, 0.0, 0.0};
                if (SLIDES) {
                    double swept[3];
                    for (int k = 0; k < 3; ++k) {
                        spin[k] = arm_a * omega[a][k] + arm_b * omega[b][k];
                        turn[k] = step * (omega[a][k] - omega[b][k]);
                    }
                    cross(spin, n, swept);
                    for (int k = 0; k < 3; ++k) {
                        slide[k] = step * (v[a][k] - v[b][k] - swept[k]);
                        spin[k] = 0.5 * step * (omega[a][k] + omega[b][k]);
                    }
                }
                double push[3], moment[3] = {0.0, 0.0, 0.0}, lever[3];
                @name@_answer answer;
                const double R = radius[a] * radius[b] / (radius[a] + radius[b]) / SHARED;
                if (!moved(own, n, SHARED * overlap, R, step, slide, turn, spin, answer, push, moment))
                    error->one(FLERR, "pair_style @name@: an overlap of {} m is deeper than the law goes", overlap);
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
        contacts.end();
    }

private:
    double size = 0.0;
    Memory contacts;

    void check_radii(double a, double b) {
        if (a + b > size * (1.0 + 1e-12))
            error->one(FLERR, "pair_style @name@: {} m was given, but spheres touch at {} m", size, a + b);
        const double radius = a * b / (a + b) / SHARED;
        if (RADIUS > 0.0 && std::fabs(radius - RADIUS) > 1e-6 * RADIUS)
            error->one(FLERR, "pair_style @name@ was made for R = {} m, two spheres have {} m", RADIUS, radius);
        if (SHARED < 1.0 && std::fabs(a - b) > 1e-6 * a)
            error->one(FLERR, "pair_style @name@ is for pairs of equal spheres, two have {} m and {} m", a, b);
    }
};
"""


WALL = r"""
/* Spheres against the surface of a region, which may move. */
class ContactWall : public Fix {
public:
    ContactWall(LAMMPS *lmp, int count, char **words) : Fix(lmp, count, words) {
        if (count != 4) error->all(FLERR, "fix @name@/wall: give the region whose surface is the wall");
        place = words[3];
        vector_flag = 1;
        size_vector = 3;
        global_freq = 1;
        extvector = 1;
    }

    int setmask() override { return FixConst::POST_FORCE; }

    void init() override {
        region = domain->get_region_by_id(place);
        if (!region) error->all(FLERR, "fix @name@/wall: there is no region {}", place);
        if (std::strcmp(update->unit_style, "si") != 0) error->all(FLERR, "fix @name@/wall needs units si");
        if (!atom->radius_flag || !atom->omega_flag || !atom->torque_flag || !atom->tag_enable)
            error->all(FLERR, "fix @name@/wall needs atom_style sphere, and atoms with IDs");
        if (REMEMBERS && comm->nprocs > 1)
            error->all(FLERR, "fix @name@/wall remembers its contacts on one process");
    }

    void setup(int) override { post_force(0); }

    void post_force(int) override {
        const double step = update->setupflag ? 0.0 : update->dt;
        const bool moves = region->dynamic_check();
        region->prematch();
        if (moves) region->set_velocity();
        contacts.begin();
        for (int k = 0; k < 3; ++k) pressed[k] = 0.0;
        for (int i = 0; i < atom->nlocal; ++i) {
            double *x = atom->x[i];
            const double R = atom->radius[i];
            if (!(atom->mask[i] & groupbit) || !region->match(x[0], x[1], x[2])) continue;
            const double hold = SHARED * HOLD * (GIVEN > 0.0 ? std::fmax(1.0, R / GIVEN) : 1.0);
            const int count = region->surface(x[0], x[1], x[2], R + hold + (REMEMBERS ? neighbor->skin : 0.0));
            for (int k = 0; k < count; ++k) touch(i, k, step, moves);
        }
        contacts.end();
    }

    double compute_vector(int k) override {
        if (comm->nprocs > 1) error->all(FLERR, "fix @name@/wall adds up its force on one process");
        return pressed[k];
    }

private:
    std::string place;
    Region *region = nullptr;
    double pressed[3] = {0.0, 0.0, 0.0};
    Memory contacts;

    void touch(int i, int which, double step, bool moves) {
        const Region::Contact &met = region->contact[which];
        const double R = atom->radius[i], arm = met.r, overlap = R - arm;
        Remembered *own = nullptr, fresh;
        if (REMEMBERS) {
            own = contacts.find(atom->tag[i], met.iwall, overlap);
            if (!own) return;
            if (contacts.twice) error->one(FLERR, "fix @name@/wall: a sphere meets one face of region {} twice", place);
        } else {
            if (!(overlap > 0.0)) return;
            own = &fresh;
        }
        if (overlap > 0.0 && RADIUS > 0.0 && std::fabs(R - RADIUS) > 1e-6 * RADIUS)
            error->one(FLERR, "fix @name@/wall was made for R = {} m, a sphere on the wall has {} m", RADIUS, R);
        const double n[3] = {met.delx / arm, met.dely / arm, met.delz / arm};
        double slide[3] = {0.0, 0.0, 0.0}, turn[3] = {0.0, 0.0, 0.0}, spin[3] = {0.0, 0.0, 0.0};
        if (SLIDES) {
            const double none[3] = {0.0, 0.0, 0.0}, *omega = atom->omega[i];
            const double *whirl = moves && region->rotateflag ? region->omega : none;
            double swept[3], wall[3] = {0.0, 0.0, 0.0};
            if (moves) region->velocity_contact(wall, atom->x[i], which);
            cross(omega, n, swept);
            for (int k = 0; k < 3; ++k) {
                slide[k] = step * (atom->v[i][k] - wall[k] - arm * swept[k]);
                turn[k] = step * (omega[k] - whirl[k]);
                spin[k] = 0.5 * step * (omega[k] + whirl[k]);
            }
        }
        double push[3], moment[3] = {0.0, 0.0, 0.0}, lever[3];
        @name@_answer answer;
        if (!moved(own, n, overlap, R, step, slide, turn, spin, answer, push, moment))
            error->one(FLERR, "fix @name@/wall: an overlap of {} m is deeper than the law goes", overlap);
        cross(n, push, lever);
        for (int k = 0; k < 3; ++k) {
            atom->f[i][k] += push[k];
            atom->torque[i][k] += moment[k] - arm * lever[k];
            pressed[k] -= push[k];
        }
    }
};
"""
