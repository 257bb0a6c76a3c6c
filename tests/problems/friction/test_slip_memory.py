"""What springs remember along the surface: against many springs in many small steps, and against the laws of energy."""

import pickle
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import quad

from winkler.problems.friction.slip_memory import SlipMemory
from winkler.problems.friction.slip_sums import SlipSums

NODES = np.polynomial.legendre.leggauss(12)


class Power:
    """K = first + slope gap^power: a flat end of that stiffness, and flanks."""

    def __init__(self, first, slope, power):
        self.first, self.slope, self.power = first, slope, power

    def at(self, gap):
        n = self.power
        stiffness = self.first + self.slope * gap**n
        force = self.first * gap + self.slope * gap ** (n + 1.0) / (n + 1.0)
        return stiffness, force, self.first * gap**2 / 2.0 + self.slope * gap ** (n + 2.0) / ((n + 1.0) * (n + 2.0))

    def between(self, gap, stiffness, depth):
        """Gauss-Legendre on a narrow ring: exact to rounding."""
        x, w = NODES
        place, half = 0.5 * (gap + depth) + 0.5 * (depth - gap) * x, 0.5 * (depth - gap)
        excess = half * w * self.slope * (place**self.power - gap**self.power)
        return float(np.sum(excess)), 2.0 * float(excess @ (depth - place))


sphere_like, cone_like, flat_with_flanks = Power(0.0, 1.0, 0.5), Power(0.0, 1.0, 1.0), Power(1.0, 1.0, 1.0)
CURVES = (sphere_like, cone_like, flat_with_flanks)


class EachSpring:
    """Springs of given gaps, each of a stiffness of one: what is summed is that of every spring."""

    def __init__(self, gap):
        self.gap = gap

    def ring(self, start, stop):
        inside = (self.gap > start) & (self.gap <= stop)
        left = np.where(inside, stop - self.gap, 0.0)
        return inside.astype(float), left, left**2


def follow(points, bound, sums=None):
    """Return the memories and the losses along a path of (depth, shift), pressed to the first point."""
    memory, lost, here = SlipMemory.fresh(), [], (0.0, 0.0)
    memories = []
    for depth, shift in points:
        memory, loss, _ = memory.moved(depth, shift - here[1], bound, sums)
        here = depth, shift
        memories.append(memory)
        lost.append(loss)
    return memories, lost


def shear_of(memory, states):
    return SlipSums(states).shear(memory)


def stored_of(memory, states):
    return SlipSums(states).stored(memory)


def displaced(memory, gap):
    """Return u_t of springs of given gaps, piece by piece; zero outside of the contact."""
    u = np.zeros(gap.shape)
    for start, stop, left, right, _ in memory.outwards():
        inside = (gap >= start) & (gap <= stop)
        u[inside] = memory.dragged + left + (right - left) * (gap[inside] - start) / (stop - start)
    return u


def brute(points, bound, gap, count):
    """March single springs in small steps: stick, clip at the bound, let go; return displacement and loss of each."""
    u, lost = np.zeros(gap.shape), np.zeros(gap.shape)
    depth, shift = 0.0, 0.0
    history = []
    for end, target in points:
        depths, shifts = np.linspace(depth, end, count + 1), np.linspace(shift, target, count + 1)
        for new, next_shift in zip(depths[1:], shifts[1:], strict=True):
            moved = next_shift - shift
            # a spring that comes or goes within the step is dragged only while it touches
            change = new - depth
            first = np.clip(np.where(gap < depth, 0.0, (gap - depth) / change if change else 2.0), 0.0, None)
            last = np.where(gap < new, 1.0, (gap - depth) / change if change else -1.0)
            touching = (last > first) & (first < 1.0) & ((gap < depth) | (gap < new))
            part = np.where(touching, np.clip(last, 0.0, 1.0) - np.clip(first, 0.0, 1.0), 0.0)
            limits = [bound * np.maximum(d - gap, 0.0) for d in (depth, new)]
            trial = np.where(touching, u + moved * part, 0.0)
            after = np.clip(trial, -limits[1], limits[1])
            slid = np.abs(trial - after)
            lost += slid * 0.5 * (np.minimum(limits[0], np.abs(u) + slid) + limits[1])
            u = np.where(gap < new, after, 0.0)
            depth, shift = new, next_shift
        history.append((u.copy(), lost.copy()))
    return history


PATH = [(1.0, 0.0), (1.0, 0.4), (1.4, 0.1), (0.7, -0.2), (0.3, 0.3), (1.1, 0.9), (1.2, -0.5), (-0.2, 0.1), (0.6, 0.25)]


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize("bound", [0.25, 0.8, 2.0])
def test_every_spring_is_where_small_steps_bring_it(bound):
    gap = np.linspace(0.0, 1.5, 601)[1:] - 1e-4
    memories, losses = follow(PATH, bound, EachSpring(gap))
    spent = np.zeros(gap.shape)
    for memory, lost, (u, waste) in zip(memories, losses, brute(PATH, bound, gap, 2000), strict=True):
        np.testing.assert_allclose(displaced(memory, gap), u, atol=1e-12)
        spent += lost
        np.testing.assert_allclose(spent, waste, atol=2e-6)


def test_the_loss_of_small_steps_converges_to_ours():
    gap = np.linspace(0.0, 1.5, 301)[1:] - 1e-4
    ours = sum(follow(PATH, 0.8, EachSpring(gap))[1])
    errors = [np.max(np.abs(brute(PATH, 0.8, gap, count)[-1][1] - ours)) for count in (100, 400)]
    assert errors[1] < errors[0] / 10.0  # second order: sixteen


def corners(reached):
    """Return the shares of a step at which its pieces become others, by halving, one after the other."""

    def pattern(share):
        return tuple(piece.slides for piece in reached(share).outwards())

    result = []
    for low, high in pairwise([1e-12, *np.linspace(0.0, 1.0, 121)[1:].tolist()]):
        while (before := pattern(low)) != pattern(high):
            end = high
            for _ in range(50):
                middle = 0.5 * (low + end)
                low, end = (middle, end) if pattern(middle) == before else (low, middle)
            result.append(end)
            low = end
    return result


turning_points = st.lists(
    st.tuples(st.floats(-0.3, 2.0), st.floats(-1.5, 1.5)),
    min_size=1,
    max_size=12,
)


@given(turning_points, st.floats(0.02, 5.0), st.sampled_from(CURVES))
@settings(max_examples=60, deadline=None)
def test_no_history_creates_energy(points, bound, states):
    gap = np.linspace(0.0, 2.0, 101)
    memories, losses = follow(points, bound, SlipSums(states))
    _, each = follow(points, bound, EachSpring(gap))
    for memory, lost, density in zip(memories, losses, each, strict=True):
        if memory.depth <= 0.0:
            assert memory.left.size == 0
            continue
        limit = bound * (memory.depth - memory.edges)
        assert np.all(np.diff(memory.edges) > 0.0)
        assert memory.edges[0] == 0.0
        assert memory.edges[-1] == memory.depth
        assert np.all(np.abs(memory.left) <= limit[:-1] + 1e-14 * bound)
        assert np.all(np.abs(memory.right) <= limit[1:] + 1e-14 * bound)
        np.testing.assert_allclose(memory.left[1:], memory.right[:-1], atol=1e-13 * bound)  # no jumps
        assert lost >= -1e-13 * bound**2
        assert np.all(density >= -1e-13 * bound**2)


@pytest.mark.slow
@given(turning_points.map(lambda points: points[:5]), st.floats(0.05, 5.0), st.sampled_from(CURVES))
@settings(max_examples=15, deadline=None)
def test_work_is_stored_or_lost(points, bound, states):
    points = [(abs(points[0][0]), 0.0), *points]
    memory, sums = SlipMemory.fresh().moved(points[0][0], 0.0, bound).memory, SlipSums(states)
    total, scale, doubt = 0.0, 1e-300, 0.0
    for (depth, shift), (end, target) in zip(points, points[1:], strict=False):
        change = target - shift

        def shear(share, memory=memory, depth=depth, end=end, change=change):
            return shear_of(memory.moved(depth + (end - depth) * share, change * share, bound)[0], states)

        after, lost, spent = memory.moved(end, change, bound, sums)
        # the shear force has corners where zones of slip meet old turning points: between them it is smooth
        cuts = [0.0, *corners(lambda share: memory.moved(depth + (end - depth) * share, change * share, bound)[0]), 1.0]  # noqa: B023
        parts = np.array([quad(shear, low, high, epsabs=1e-12, limit=200) for low, high in pairwise(cuts)])
        work, error = (float(part) for part in parts.sum(axis=0) * (change, abs(change)))
        gain = stored_of(after, states) - stored_of(memory, states) + lost
        scale = max(scale, bound**2 * states.at(max(depth, end, 0.1))[2], abs(change) * 1e-2)
        assert abs(work - gain) <= 1e-9 * scale + error
        assert abs(work - spent) <= 1e-9 * scale + error
        total, doubt = total + work - gain, doubt + error
        memory = after
    assert abs(total) <= 1e-9 * scale + doubt


@pytest.mark.parametrize(("depth", "change"), [(1.6, 0.9), (1.6, -1.4), (0.2, 0.1), (-0.1, 0.3), (0.31, 0.5)])
def test_parts_of_a_straight_step_are_the_whole_step(depth, change):
    start = follow(PATH[:4], 0.7)[0][-1]
    whole = start.moved(depth, change, 0.7).memory
    half = start.moved(start.depth + 0.3 * (depth - start.depth), 0.3 * change, 0.7).memory
    again = half.moved(depth, 0.7 * change, 0.7).memory
    gap = np.linspace(0.0, 1.6, 77)
    np.testing.assert_allclose(displaced(again, gap), displaced(whole, gap), atol=1e-14)
    for sums in map(SlipSums, CURVES):
        at_once = start.moved(depth, change, 0.7, sums)
        first = start.moved(half.depth, 0.3 * change, 0.7, sums)
        then = half.moved(depth, 0.7 * change, 0.7, sums)
        assert first.lost + then.lost == pytest.approx(at_once.lost, rel=1e-12, abs=1e-15)
        assert first.work + then.work == pytest.approx(at_once.work, rel=1e-12, abs=1e-15)


def test_a_memory_forgets_what_is_wiped_out():
    bound = 1.0
    memory = SlipMemory.fresh().moved(1.0, 0.0, bound).memory
    for change in (0.3, -0.1, 0.05, -0.02):
        memory = memory.moved(1.0, change, bound).memory
    assert memory.left.size == 5  # one straight piece per turning point, and the springs that never slid
    memory = memory.moved(1.0, 0.5, bound).memory  # beyond all of them
    assert memory.left.size == 2


def test_many_equal_cycles_cost_no_memory():
    memory = SlipMemory.fresh().moved(1.0, 0.0, 0.7).memory
    sizes = []
    for _ in range(200):
        for depth, change in ((1.3, 0.21), (0.9, -0.37), (1.0, 0.16)):
            memory = memory.moved(depth, change, 0.7).memory
        sizes.append(memory.left.size)
    assert max(sizes[10:]) == min(sizes[10:]) <= 6


def test_stick_gap_is_where_sliding_begins():
    memory = SlipMemory.fresh().moved(1.0, 0.0, 0.5).memory
    assert memory.stick_gap == 1.0
    memory = memory.moved(1.0, 0.2, 0.5).memory
    assert memory.stick_gap == pytest.approx(0.6, rel=1e-14)  # beta (d - gamma) = U
    still = memory.moved(1.0, 0.0, 0.5).memory
    assert still.stick_gap == pytest.approx(0.6, rel=1e-14)
    back = memory.moved(1.0, -0.1, 0.5).memory
    assert back.stick_gap == pytest.approx(0.9, rel=1e-14)  # 2 beta (d - gamma) = change
    gone = memory.moved(1.0, 1.0, 0.5).memory
    assert gone.stick_gap == 0.0


def test_without_slip_springs_let_go_what_they_hold():
    sums = SlipSums(cone_like)
    memory = SlipMemory.fresh().moved(1.0, 0.0, np.inf).memory
    memory, lost, work = memory.moved(1.0, 0.3, np.inf, sums)
    assert lost == 0.0
    assert work == pytest.approx(0.5 * 0.3**2, rel=1e-13)
    assert shear_of(memory, cone_like) == pytest.approx(0.3, rel=1e-15)
    after, lost, work = memory.moved(0.5, 0.0, np.inf, sums)
    assert work == 0.0
    # springs between 0.5 and 1 lose u^2/2 each
    assert lost == pytest.approx(0.5 * 0.3**2 * 0.5, rel=1e-13)
    again = after.moved(1.0, 0.0, np.inf).memory
    np.testing.assert_allclose(displaced(again, np.array([0.2, 0.7])), [0.3, 0.0], atol=1e-16)  # a jump, for ever
    assert 2.0 * stored_of(again, cone_like) == pytest.approx(0.3**2 * 0.5, rel=1e-13)


def test_a_flat_end_loses_in_a_contact_of_no_depth_too():
    memory, sums = SlipMemory.fresh().moved(1.0, 0.0, 1.0).memory, SlipSums(flat_with_flanks)
    losses = [memory.moved(depth, 1.0, 1.0, sums).lost for depth in (1e-6, 3e-185, 1e-309, 0.0)]
    np.testing.assert_allclose(losses, losses[-1], rtol=1e-5)
    assert losses[-1] > 0.3


def test_without_friction_nothing_is_dragged():
    sums = SlipSums(sphere_like)
    memory, lost, work = SlipMemory.fresh().moved(1.0, 0.4, 0.0, sums)
    memory, more, further = memory.moved(1.2, -0.3, 0.0, sums)
    assert shear_of(memory, sphere_like) == 0.0
    assert (lost, more, work, further) == (0.0, 0.0, 0.0, 0.0)


def test_energies_are_no_numbers_where_they_are_not_summed():
    assert np.isnan(SlipMemory.fresh().moved(1.0, 0.4, 0.5)[1:]).all()


@pytest.mark.parametrize("states", CURVES)
def test_monotonic_shear_is_the_difference_of_two_contacts(states):
    # Ciavarella, Jaeger: F_x = mu (F(d) - F(d - U / beta))
    memory = SlipMemory.fresh().moved(1.0, 0.0, 0.5).memory
    for change in (0.1, 0.25, 0.45):
        sheared = memory.moved(1.0, change, 0.5).memory
        inner = states.at(1.0 - change / 0.5)[1]
        expected = 0.5 * (states.at(1.0)[1] - inner)
        assert shear_of(sheared, states) == pytest.approx(expected, rel=1e-14)
    gaps, factors = memory.moved(1.0, 0.2, 0.5)[0].corners
    np.testing.assert_allclose(gaps, [0.6, 1.0], rtol=1e-14)
    np.testing.assert_allclose(factors, [-0.5, 0.5], rtol=1e-14)


def shrinking(turns, bound=0.5, sums=None):
    """Return the memories at the turning points of a loop that dies away at constant depth, and what springs lose."""
    shifts = [0.0, *(0.45 * (-1.0) ** np.arange(turns) * (1.0 - np.arange(turns) / turns))]
    return shifts, follow([(1.0, shift) for shift in shifts], bound, sums)


def test_a_long_memory_is_that_of_springs_one_by_one():
    # at constant depth a spring is the clip of where it is dragged to, and loses its bound times what is cut off
    gap, bound = np.linspace(0.0, 1.0, 2001)[:-1] + 1.1e-4, 0.5
    shifts, (memories, losses) = shrinking(600, bound, EachSpring(gap))
    u, limit, lost, before = np.zeros(gap.size), bound * (1.0 - gap), np.zeros(gap.size), 0.0
    for shift, loss in zip(shifts, losses, strict=True):
        trial = u + shift - before
        u, before = np.clip(trial, -limit, limit), shift
        lost += limit * np.abs(trial - u) - loss
    assert memories[-1].size > 500
    np.testing.assert_allclose(displaced(memories[-1], gap), u, rtol=0.0, atol=2e-14)
    np.testing.assert_allclose(lost, 0.0, atol=2e-14)


def test_states_share_what_they_remember():
    _, (memories, _) = shrinking(400)
    assert {id(memory.pieces) for memory in memories} == {id(memories[0].pieces)}
    assert sum(memory.size for memory in memories) > 50_000
    assert memories[0].pieces.columns.used[0] <= 4 * len(memories)


def test_a_long_memory_is_pickled_compared_and_summed():
    _, (memories, _) = shrinking(1500)
    again = pickle.loads(pickle.dumps(memories[-1]))
    assert again == memories[-1]
    assert hash(again) == hash(memories[-1])
    assert again != memories[-2]
    assert shear_of(again, sphere_like) == shear_of(memories[-1], sphere_like)
    start, stop, left, right = again.edges[:-1], again.edges[1:], again.left, again.right
    slope = (right - left) / (stop - start)
    # of K = gap^(1/2), in closed form: the sum of (left + slope (gap - start)) dK
    each = (left - slope * start) * (stop**0.5 - start**0.5) + slope * (stop**1.5 - start**1.5) / 3.0
    assert shear_of(again, sphere_like) == pytest.approx(float(np.sum(each)), rel=1e-10, abs=1e-14)
