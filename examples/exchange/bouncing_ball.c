/* A ball that falls onto a plate and bounces: a law exported by winkler in a program of one's own.
 *
 *     winkler export examples/studies/normal/hertz.toml --to c --name contact
 *     cc -std=c99 -O2 -I. examples/exchange/bouncing_ball.c -o bouncing_ball -lm && ./bouncing_ball
 */
#include <stdio.h>

#include "contact.h"

int main(void) {
    const double mass = 0.0327, step = 2e-8; /* kg (steel, radius 10 mm); s */
    double velocity = 0.005, depth = 0.0;    /* m/s, downwards; m */
    const double energy = 0.5 * mass * velocity * velocity;
    double time = 0.0, deepest = 0.0, greatest = 0.0, error = 0.0;
    contact_state state;
    contact_motion motion;
    contact_answer answer = {0};

    contact_begin(&state);
    do {
        velocity -= 0.5 * step * answer.force / mass;
        depth += step * velocity;
        motion.depth = depth;
        contact_step(&state, &motion, &answer);
        velocity -= 0.5 * step * answer.force / mass;
        time += step;
        if (!(answer.force >= 0.0)) {
            fprintf(stderr, "deeper than the law reaches: export a study with a greater load\n");
            return 1;
        }
        if (depth > deepest) deepest = depth;
        if (answer.force > greatest) greatest = answer.force;
        const double off = fabs(0.5 * mass * velocity * velocity + answer.energy - energy) / energy;
        if (off > error) error = off;
    } while (depth > 0.0);
    printf("contact %.4f us, depth %.4f um, force %.4f N\n", 1e6 * time, 1e6 * deepest, greatest);
    printf("restitution %.6f, energy off by %.1e at most\n", -velocity / 0.005, error);
    return 0;
}
