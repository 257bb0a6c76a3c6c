"""The pair style of LAMMPS around a contact law in C; what stands between @ is filled in for each law."""

from __future__ import annotations

__all__ = ["PAIR"]

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
                for (int k = 0; k < 3; ++k) n[k] /= distance;
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
