"""Spheres against walls by a contact law, a fix of LAMMPS; what stands between @ is filled in for each law."""

from __future__ import annotations

__all__ = ["WALL"]

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
