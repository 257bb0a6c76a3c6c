"""Line contacts on layers: homogeneous and thin limits, an independent discretisation, stresses, refusals."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import quad

import winkler as wk
from winkler.numerics.transforms.strips.strip_modes import bessel_rows
from winkler.problems.line.stress import LineFields
from winkler.values.errors import InvalidInput, OutsideValidity

CYLINDER = wk.Paraboloid(1.0)
ROUNDED = wk.RoundedPunch(0.4, 1.0)
WEDGE = wk.Cone(np.radians(80.0))
SOLID = wk.Elastic(0.91, 0.3)


def strip(poisson=0.3, thickness=1.0, profile=CYLINDER):
    """A strip of E* = 1 bonded to a rigid base."""
    layer = wk.Layer(wk.Elastic(1.0 - poisson**2, poisson), thickness)
    return wk.LayeredLineFoundation(profile, wk.CoatedHalfSpace([layer], on=wk.Rigid()))


def coated(profile=CYLINDER, layer=SOLID, base=SOLID, second=None, thickness=1.0):
    medium = wk.CoatedHalfSpace([wk.Layer(layer, thickness)], base, second or wk.Rigid())
    return wk.LayeredLineFoundation(profile, medium)


def of_width(bed, half_width):
    return wk.LineIndentation(bed, wk.HalfWidth(half_width)).solve()


def parts(fields: LineFields):
    return np.array([fields.xx_stress, fields.yy_stress, fields.zz_stress, fields.xz_stress])


@pytest.mark.parametrize("count", [1, 2, 30, 120])
def test_even_bessel_functions(count):
    from scipy.special import jv

    places = np.concatenate([[0.0], np.geomspace(1e-9, 400.0, 40), [2.0 * count - 2.0]])
    expected = np.array([jv(2 * n, places) for n in range(count)])
    np.testing.assert_allclose(bessel_rows(places, count), expected, rtol=0.0, atol=2e-14)


@pytest.mark.parametrize("profile", [CYLINDER, ROUNDED, WEDGE, wk.PowerLaw(1.5, 1.0)])
def test_layers_of_one_solid_are_a_half_plane(profile):
    second = wk.Elastic(3.0, 0.2)
    layered = of_width(coated(profile, second=second), 1.0)
    plain = of_width(wk.LineFoundation(profile, wk.HalfSpace(SOLID, second)), 1.0)
    x = np.array([0.05, 0.5, 0.9, 1.0, 1.3, 4.0])
    assert layered.force_per_length == pytest.approx(plain.force_per_length, rel=1e-13)
    np.testing.assert_allclose(layered.pressure(x), plain.pressure(x), rtol=1e-11, atol=1e-15)
    np.testing.assert_allclose(layered.separation(x), plain.separation(x), rtol=1e-10, atol=1e-13)
    places = np.array([0.1, 0.5, 1.2, 0.3]), np.array([0.0, 0.5, 0.9, 2.5])
    np.testing.assert_allclose(parts(layered.stresses(*places)), parts(plain.stresses(*places)), atol=1e-12)
    above = places[0], -places[1]
    np.testing.assert_allclose(parts(layered.stresses(*above)), parts(plain.stresses(*above)), atol=1e-12)
    if profile is CYLINDER:
        assert layered.approach(first=5.0, second=2.0) == pytest.approx(plain.approach(5.0, 2.0), rel=1e-11)


def test_waves_of_many_lengths_under_a_strip_are_a_half_plane_on_layers_of_one_solid():
    """Of 40 waves the profile is no polynomial of degree 128; it was taken for one with kinks."""
    waves = wk.Sum([wk.Paraboloid(1.0), wk.Wavy(1e-6, 0.1)])
    layered = of_width(coated(waves), 2.0)
    plain = of_width(wk.LineFoundation(waves, wk.HalfSpace(SOLID, wk.Rigid())), 2.0)
    assert layered.force_per_length == pytest.approx(plain.force_per_length, rel=1e-12)
    x = np.array([0.0, 0.31, 1.7])
    np.testing.assert_allclose(layered.pressure(x), plain.pressure(x), rtol=1e-9)
    assert layered.problem.bed.carried(2.0, 0.0).own is not None


@pytest.mark.parametrize("half_width", [0.03, 0.3, 1.0, 3.0, 20.0])
@pytest.mark.parametrize("poisson", [0.0, 0.3, 0.5])
def test_a_force_leads_back_to_its_half_width_and_grows_by_flat_punches(poisson, half_width):
    """The derivative of the load comes from the edge of a flat punch, and is that of the load."""
    bed = strip(poisson)
    contact = of_width(bed, half_width)
    back = wk.LineIndentation(bed, wk.LineForce(contact.force_per_length)).solve()
    assert back.half_width == pytest.approx(half_width, rel=1e-11)
    steps = half_width * (1.0 + 1e-3 * np.array([-2.0, -1.0, 1.0, 2.0]))
    slope = bed.load_profile(steps) @ np.array([1.0, -8.0, 8.0, -1.0]) / (12e-3 * half_width)
    assert float(bed.load_profile_slope(np.array([half_width]))[0]) == pytest.approx(slope, rel=1e-8)


def bonded(k, poisson):
    """M of a layer of the thickness 1 bonded to a rigid base (Johnson 1985, section 5.8)."""
    kappa = 3.0 - 4.0 * poisson
    below = 2.0 * kappa * np.cosh(2.0 * k) + 1.0 + kappa**2 + 4.0 * k * k
    return (2.0 * kappa * np.sinh(2.0 * k) - 4.0 * k) / below - 1.0


def slid(k, softer):
    """M of a layer of the thickness 1 that slides on a half-plane, from E* of the layer over that of the base."""
    s, c, e = -0.5 * np.expm1(-2.0 * k), 0.5 * (1.0 + np.exp(-2.0 * k)), np.exp(-2.0 * k)  # over exp(k)
    both = s * c + k * e
    return (s * s + softer * both) / (both + softer * (s * s - k * k * e)) - 1.0


def collocated(excess, half_width, count):
    """Load of a cylinder on a strip of the thickness 1, after Erdogan and Gupta: zeros of U_n and of T_(n+1)."""
    step = 0.25 / (1.0 + half_width)
    k = (np.arange(int(22.0 / step))[:, None] + 0.5 * (np.polynomial.legendre.leggauss(12)[0] + 1.0)).ravel() * step
    weights = np.tile(0.5 * step * np.polynomial.legendre.leggauss(12)[1], k.size // 12)
    excess = excess(k)
    angle = np.pi * np.arange(1, count + 1) / (count + 1)
    s, shares = half_width * np.cos(angle), half_width * np.pi * np.sin(angle) ** 2 / (count + 1)
    x = half_width * np.cos(np.pi * (np.arange(1, count + 2) - 0.5) / (count + 1))
    sines, cosines = np.sin(np.outer(x, k)), np.cos(np.outer(x, k))
    smooth = (sines * excess * weights) @ np.cos(np.outer(k, s)) - (cosines * excess * weights) @ np.sin(np.outer(k, s))
    kernel = (1.0 / (x[:, None] - s) + smooth) * shares
    return float(shares @ np.linalg.lstsq(kernel, 0.5 * np.pi * x, rcond=None)[0])


@pytest.mark.parametrize("poisson", [0.2, 0.45, 0.5])
@pytest.mark.parametrize("half_width", [0.2, 1.5, 6.0])
def test_a_cylinder_by_another_discretisation(poisson, half_width):
    """Collocation on the closed compliance of a bonded layer (Johnson 1985, section 5.8)."""
    expected = collocated(lambda k: bonded(k, poisson), half_width, 60)
    assert of_width(strip(poisson), half_width).force_per_length == pytest.approx(expected, rel=1e-11)


def sliding(softer, profile=CYLINDER, second=None, poisson=0.4):
    """A film of E* = 1 and the thickness 1 that slides on a base of E* = 1 / softer."""
    base = wk.Elastic((1.0 - 0.3**2) / softer, 0.3) if softer else wk.Rigid()
    film = wk.Layer(wk.Elastic(1.0 - poisson**2, poisson), 1.0)
    return wk.LayeredLineFoundation(profile, wk.SlidingFilm([film], base, second or wk.Rigid()))


@pytest.mark.parametrize("softer", [0.0, 0.05, 1.0, 40.0])
@pytest.mark.parametrize("half_width", [0.2, 1.5, 6.0])
def test_a_cylinder_on_a_film_that_slides_by_another_discretisation(softer, half_width):
    """The base decides, and nothing but E* of the film counts."""
    found = of_width(sliding(softer), half_width).force_per_length
    assert found == pytest.approx(collocated(lambda k: slid(k, softer), half_width, 80), rel=1e-9)
    assert of_width(sliding(softer, poisson=0.1), half_width).force_per_length == pytest.approx(found, rel=1e-12)


@pytest.mark.parametrize("ratio", [30.0, 100.0])
def test_a_thin_film_that_slides_is_a_row_of_springs(ratio):
    """p = E* (a^2 - x^2)/(2 R h), incompressible or not: the film gives way sideways."""
    contact = of_width(sliding(0.0, poisson=0.5), ratio)
    assert contact.force_per_length == pytest.approx(2.0 / 3.0 * ratio**3, rel=1.2 / ratio)
    assert contact.depth == pytest.approx(0.5 * ratio**2, rel=1.0 / ratio)
    assert contact.peak_pressure == pytest.approx(0.5 * ratio**2, rel=1.0 / ratio)


@pytest.mark.slow
@pytest.mark.parametrize("softer", [0.0, 2.0])
def test_stresses_in_a_film_that_slides_on_its_base(softer):
    """No shear on the interface, what bears there holds the load up, and both faces of it bear the same."""
    contact = of_width(sliding(softer), 1.5)
    x = np.linspace(-60.0, 60.0, 4001)
    bottom = contact.stresses(x, np.full(x.size, 1.0))
    np.testing.assert_allclose(bottom.xz_stress, 0.0, atol=1e-9 * contact.peak_pressure)
    borne = -np.trapezoid(bottom.zz_stress, x)
    assert borne == pytest.approx(contact.force_per_length, rel=1e-6 if softer == 0.0 else 1e-3)
    inside = contact.stresses(np.array([0.0, 0.7]), np.zeros(2))
    np.testing.assert_allclose(inside.zz_stress, -contact.pressure(np.array([0.0, 0.7])), rtol=1e-9)
    if softer:
        below = contact.stresses(x, np.full(x.size, np.nextafter(1.0, 2.0)))
        np.testing.assert_allclose(below.zz_stress, bottom.zz_stress, atol=1e-9 * contact.peak_pressure)
    assert any("slides on it without friction" in note.statement for note in contact.validity)


@pytest.mark.few(1)
@pytest.mark.parametrize("ratio", [30.0, 100.0])
def test_thin_compressible_strip(ratio):
    """Johnson 1985, section 5.8: p = M_c (a^2 - x^2)/(2 R h), depth a^2/(2 R), as the strip becomes thin."""
    contact = of_width(strip(0.3), ratio)
    confined = 0.7 / (1.3 * 0.4) * 0.91
    assert contact.force_per_length == pytest.approx(2.0 / 3.0 * confined * ratio**3, rel=0.4 / ratio)
    assert contact.depth == pytest.approx(0.5 * ratio**2, rel=0.3 / ratio)
    assert contact.peak_pressure == pytest.approx(0.5 * confined * ratio**2, rel=0.3 / ratio)


@pytest.mark.parametrize("ratio", [30.0, 100.0])
def test_thin_incompressible_strip(ratio):
    """Johnson 1985, section 5.8: p = G (a^2 - x^2)^2/(8 R h^3), depth a^2/(6 R), as the strip becomes thin."""
    contact = of_width(strip(0.5), ratio)
    shear = 0.75 / 3.0
    assert contact.peak_pressure == pytest.approx(shear * ratio**4 / 8.0, rel=7.0 / ratio)
    assert contact.force_per_length == pytest.approx(shear / 8.0 * ratio**5 * 16.0 / 15.0, rel=9.0 / ratio)
    assert contact.depth == pytest.approx(ratio**2 / 6.0, rel=4.0 / ratio)


@pytest.mark.few(1)
@pytest.mark.parametrize("profile", [ROUNDED, WEDGE])
def test_pressure_bears_the_load_and_surfaces_part(profile):
    contact = of_width(strip(0.45, profile=profile), 1.0)

    def share(t):
        return float(contact.pressure(np.array(np.sin(t)))) * np.cos(t)

    borne = 2.0 * quad(share, 0.0, 0.5 * np.pi, points=[np.arcsin(0.4)], limit=200, epsabs=1e-13)[0]
    assert borne == pytest.approx(contact.force_per_length, rel=1e-9)
    assert np.all(np.diff(contact.separation(np.linspace(1.0, 8.0, 40))) > 0.0)


def test_a_flat_punch_is_pinned_and_deeper_by_its_load():
    bed = strip(0.3, profile=wk.FlatPunch(1.0))
    contacts = wk.LineIndentation(bed, wk.LineForce(np.array([1.0, 2.0]))).solve()
    np.testing.assert_allclose(contacts.half_width, 1.0)
    assert contacts.depth[1] == pytest.approx(2.0 * contacts.depth[0], rel=1e-13)
    assert np.isinf(contacts.peak_pressure).all()


def test_depth_grows_by_the_load_over_the_stiffness_of_a_flat_punch():
    """dP = k(a) d delta: the growing contact adds flat punches."""
    step = 1e-3
    near = [of_width(strip(0.3), 1.0 + s * step) for s in (-1, 1)]
    punch = wk.LineIndentation(strip(0.3, profile=wk.FlatPunch(1.0)), wk.LineForce(1.0)).solve()
    risen = near[1].force_per_length - near[0].force_per_length
    assert near[1].depth - near[0].depth == pytest.approx(risen * punch.depth, rel=1e-6)


def test_stresses_are_in_equilibrium_and_continuous():
    contact = of_width(coated(layer=wk.Elastic(3.0, 0.25)), 1.2)
    step = 1e-4
    place = np.array([0.7 + step, 0.7 - step, 0.7, 0.7]), np.array([0.6, 0.6, 0.6 + step, 0.6 - step])
    xx, _, zz, xz = parts(contact.stresses(*place))
    assert xx[0] - xx[1] + xz[2] - xz[3] == pytest.approx(0.0, abs=1e-9)
    assert xz[0] - xz[1] + zz[2] - zz[3] == pytest.approx(0.0, abs=1e-9)
    upper, lower = (parts(contact.stresses(0.4, z)) for z in (1.0, np.nextafter(1.0, 2.0)))
    np.testing.assert_allclose(upper[2:], lower[2:], rtol=1e-12)
    assert upper[0] != pytest.approx(lower[0], rel=0.1)
    on_surface = parts(contact.stresses(np.array([0.5, 2.0]), np.zeros(2)))
    np.testing.assert_allclose(on_surface[2], -contact.pressure(np.array([0.5, 2.0])), atol=1e-12)
    np.testing.assert_allclose(on_surface[3], 0.0, atol=1e-12)


@pytest.mark.slow
def test_the_greatest_stresses_of_layers():
    contact = of_width(coated(layer=wk.Elastic(3.0, 0.25)), 1.0)
    first, base = contact.layer_stresses()
    x, z = np.linspace(0.0, 2.0, 81), np.linspace(0.0, 1.0, 61)
    sampled = contact.stresses(x[:, None], z[None, :]).von_mises
    assert np.max(sampled) <= first.von_mises * (1.0 + 1e-9) <= 1.01 * np.max(sampled)
    shear = np.abs(contact.stresses(x, np.full(x.shape, 1.0)).xz_stress)
    assert np.max(shear) <= first.interface_shear * (1.0 + 1e-9) <= 1.01 * np.max(shear)
    assert base.layer == 2
    assert np.isnan(base.interface_shear)
    assert contact.greatest_stress().value == max(first.von_mises, base.von_mises)


def test_stacks_and_bodies_are_the_same_in_other_units():
    for scale in (1e-6, 1e3):
        own = wk.CoatedHalfSpace([wk.Layer(SOLID, scale), wk.Layer(wk.Elastic(4.0, 0.2), 0.5 * scale)], wk.Rigid())
        contact = of_width(wk.LayeredLineFoundation(wk.Paraboloid(scale), own), scale)
        one = wk.CoatedHalfSpace([wk.Layer(SOLID, 1.0), wk.Layer(wk.Elastic(4.0, 0.2), 0.5)], wk.Rigid())
        unit = of_width(wk.LayeredLineFoundation(CYLINDER, one), 1.0)
        assert contact.depth == pytest.approx(scale * unit.depth, rel=1e-12)
        assert contact.force_per_length == pytest.approx(scale * unit.force_per_length, rel=1e-12)


def test_what_is_refused():
    bed = strip()
    with pytest.raises(wk.InvalidInput, match="layers go into a LayeredLineFoundation"):
        wk.LineFoundation(CYLINDER, bed.medium)
    with pytest.raises(wk.InvalidInput, match="homogeneous bodies go into a LineFoundation"):
        wk.LayeredLineFoundation(CYLINDER, wk.HalfSpace(SOLID))
    contact = of_width(bed, 1.0)
    with pytest.raises(wk.OutsideValidity, match="lies in the rigid base"):
        contact.stresses(0.0, 1.1)
    with pytest.raises(wk.OutsideValidity, match="rigid"):
        contact.stresses(0.0, -1.1)
    on_soft = of_width(coated(), 1.0)
    with pytest.raises(wk.OutsideValidity, match="only where a rigid base carries the layers"):
        _ = on_soft.depth
    with pytest.raises(wk.InvalidInput, match=r"at least the 1 m of the layers"):
        on_soft.approach(first=0.5)
    with pytest.raises(wk.OutsideValidity, match="as wide as the uppermost layer is thick"):
        of_width(strip(thickness=1e-4), 1.0)
    with pytest.raises(wk.OutsideValidity, match="infinite"):
        of_width(strip(profile=WEDGE), 1.0).layer_stresses()


def test_a_plate_on_a_soft_base_parts_or_is_one_strip():
    """A flat punch with hardly rounded edges on a stiff plate: the middle would pull, which is found."""
    plate = coated(wk.RoundedPunch(30.0, 1.0), wk.Elastic(1e4, 0.3), wk.Elastic(1.0, 0.3))
    with pytest.raises(wk.OutsideValidity, match="parted into several"):
        of_width(plate, 30.001)


def test_the_picture_shows_the_depth_where_there_is_one():
    pyplot = pytest.importorskip("matplotlib.pyplot")
    from winkler.plot import draw

    many = [wk.LineIndentation(bed, wk.LineForce(np.array([0.1, 1.0]))).solve() for bed in (strip(), coated())]
    figures = [draw(solution) for solution in (*many, many[0].at(0))]
    assert [len(figure.axes) for figure in figures] == [3, 2, 2]
    for figure in figures:
        pyplot.close(figure)


@pytest.mark.slow
def test_the_search_under_a_falling_profile_ends():
    bed = strip(thickness=0.02, profile=wk.Wavy(0.01, 4.0))
    with pytest.raises(wk.OutsideValidity, match="no wider strip is sought where the load may fall"):
        wk.LineIndentation(bed, wk.LineForce(1e9)).solve()


def yielding_pair(coating, base, thickness, profile=CYLINDER):
    return wk.LayeredLineFoundation(profile, wk.CoatedHalfSpace([wk.Layer(coating, thickness)], base))


def test_equal_layers_yield_as_a_half_plane():
    solid = wk.Elastic(0.91, 0.3, strength=0.1)
    ours = wk.LineYieldOnset(yielding_pair(solid, SOLID, 3.0)).solve()
    theirs = wk.LineYieldOnset(wk.LineFoundation(CYLINDER, wk.HalfSpace(solid))).solve()
    assert ours.force_per_length == pytest.approx(theirs.force_per_length, rel=1e-9)
    assert ours.z == pytest.approx(theirs.z, rel=1e-4)
    assert any("Yielding begins" in note.statement for note in ours.validity)


@pytest.mark.slow
def test_equal_layers_slide_as_a_half_plane_and_all_bodies_have_their_load():
    solid, roller = wk.Elastic(0.91, 0.3, strength=0.1), wk.Elastic(2.0, 0.25, strength=0.12)
    layered = wk.CoatedHalfSpace([wk.Layer(solid, 0.1)], solid, roller)
    ours = wk.LineYieldOnset(wk.LayeredLineFoundation(CYLINDER, layered), wk.Coulomb(0.3)).solve()
    theirs = wk.LineYieldOnset(wk.LineFoundation(CYLINDER, wk.HalfSpace(solid, roller)), wk.Coulomb(0.3)).solve()
    layer, base, second = ours.onsets
    assert [one.name for one in ours.onsets] == ["layer 1", "body under the layers", "second body"]
    assert (ours.force_per_length, ours.z) == (layer.force_per_length, 0.0)
    assert layer.force_per_length == pytest.approx(theirs.force_per_length, rel=1e-9)
    assert second.force_per_length == pytest.approx(theirs.onsets[1].force_per_length, rel=1e-9)
    assert base.force_per_length > layer.force_per_length
    assert layer.x == pytest.approx(theirs.x, rel=1e-4)


def test_stresses_under_a_sliding_strip_are_in_equilibrium_and_continuous():
    """In layer and base; across the interface the tractions and the strain along it; the traction on the surface."""
    solids, mu, step = (wk.Elastic(3.0, 0.25), wk.Elastic(0.91, 0.3)), 0.4, 1e-4
    contact = of_width(coated(layer=solids[0]), 1.2)
    for x, z in ((0.7, 0.6), (-0.5, 1.4)):
        place = np.array([x + step, x - step, x, x]), np.array([z, z, z + step, z - step])
        xx, _, zz, xz = parts(contact.stresses(*place, friction=mu))
        assert xx[0] - xx[1] + xz[2] - xz[3] == pytest.approx(0.0, abs=1e-9)
        assert xz[0] - xz[1] + zz[2] - zz[3] == pytest.approx(0.0, abs=1e-9)
    along = np.array([-0.9, 0.4, 1.5])
    upper, lower = (parts(contact.stresses(along, np.full(3, z), friction=mu)) for z in (1.0, np.nextafter(1.0, 2.0)))
    np.testing.assert_allclose(upper[2:], lower[2:], rtol=1e-11)
    strains = [((1.0 - s.poisson) * f[0] - s.poisson * f[2]) / s.shear
               for s, f in zip(solids, (upper, lower), strict=True)]  # fmt: skip
    np.testing.assert_allclose(strains[0], strains[1], rtol=1e-9)
    on = parts(contact.stresses(along, np.zeros(3), friction=mu))
    np.testing.assert_allclose(on[3], -mu * contact.pressure(along), atol=1e-11)
    np.testing.assert_allclose(on[2], -contact.pressure(along), atol=1e-11)


@pytest.mark.few(0, slow=2)
@pytest.mark.parametrize("base", [wk.Elastic(0.91, 0.3), wk.Elastic(3.0, 0.2)])
def test_thin_layers_under_a_sliding_strip_take_the_strain_of_the_base(base):
    """What is left of the limit halves with the thickness; the strain is that of a half-plane under p and mu p."""
    layer, mu, left = wk.Elastic(2.0, 0.25), 0.3, []
    x = np.array([-0.5, 0.0, 0.4])
    for thickness in (1e-2, 5e-3):
        contact = of_width(coated(layer=layer, base=base, thickness=thickness), 1.0)
        p0 = 0.5 * wk.HalfSpace(base).modulus
        root = np.sqrt(1.0 - x**2)
        across, along = -p0 * root, -p0 * (root + 2.0 * mu * x)  # of the half-plane on its surface
        strain = ((1.0 - base.poisson) * along - base.poisson * across) / base.shear
        limit = (strain * layer.shear + layer.poisson * across) / (1.0 - layer.poisson)
        found = parts(contact.stresses(x, np.full(3, 0.5 * thickness), friction=mu))
        left.append((found[0] - limit) / p0)
    assert np.max(np.abs(left[0])) > 1e-4
    np.testing.assert_allclose(2.0 * left[1], left[0], atol=0.05 * np.max(np.abs(left[0])))


@pytest.mark.slow
@pytest.mark.parametrize("mu", [0.0, 0.3])
@pytest.mark.parametrize(("strengths", "part"), [((0.5, np.inf), 0), ((np.inf, 0.2), 1)])
def test_no_place_of_a_stressed_coating_is_beyond_its_strength_at_onset(strengths, part, mu):
    """The fields at the load found, on a fine grid that knows nothing of the search: just at the strength."""
    coating, base = (
        wk.Elastic(*row, strength=each) for row, each in zip(((3.0, 0.25), (0.91, 0.3)), strengths, strict=True)
    )
    onset = wk.LineYieldOnset(yielding_pair(coating, base, 0.3), wk.Coulomb(mu)).solve()
    contact = wk.LineIndentation(onset.problem.bed, wk.LineForce(onset.force_per_length)).solve()
    x = onset.half_width * np.linspace(-1.5 if mu else 0.0, 1.5, 121)
    z = np.linspace(0.0, 0.3, 121) if part == 0 else 0.3 + np.linspace(1e-12, 2.0 * onset.half_width, 121)
    level = contact.stresses(x[:, None], z[None, :], mu).von_mises
    assert np.max(level) <= strengths[part] * (1.0 + 1e-9)
    assert np.max(level) == pytest.approx(strengths[part], rel=2e-3)
    assert float(contact.stresses(onset.x, onset.z, mu).von_mises) == pytest.approx(strengths[part], rel=1e-8)


@pytest.mark.slow
def test_the_greatest_stress_of_a_deep_layer_lies_far_beside_a_narrow_strip():
    """A soft layer between stiff ones: 3.5 half-widths beside the middle, on a grid apart from the search."""
    solids = (wk.Elastic(3.4, 0.0), wk.Elastic(1.5, 0.5, strength=0.0251), wk.Elastic(97.0, 0.0))
    layers = [wk.Layer(solid, thickness) for solid, thickness in zip(solids, (0.6, 0.38, 0.46), strict=True)]
    contact = of_width(wk.LayeredLineFoundation(CYLINDER, wk.CoatedHalfSpace(layers, wk.Rigid())), 0.14)
    found = contact.layer_stresses()[1]
    x, z = np.linspace(0.0, 1.5, 301), 0.6 + 0.38 * np.linspace(1e-9, 1.0, 41)
    level = contact.stresses(x[:, None], z[None, :]).von_mises
    place = np.unravel_index(np.argmax(level), level.shape)
    assert found.von_mises == pytest.approx(level[place], rel=1e-4)
    assert found.von_mises >= level[place]
    assert found.x == pytest.approx(x[place[0]], abs=0.005)
    assert found.x > 0.4
    note = next(note for note in contact.validity if note.assumption is wk.Assumption.ELASTIC)
    assert note.standing is wk.Standing.OUTSIDE  # less than 1.02 times the strength, that of the middle is 0.9
    assert "times the strength of the layer 2" in note.statement


def test_the_greatest_stress_on_a_flat_ridge():
    """Under an incompressible layer the stress about the middle changes by 3e-4 over a quarter of the half-width."""
    layers = [wk.Layer(wk.Elastic(0.61, 0.5), 0.557), wk.Layer(wk.Elastic(0.0157, 0.49), 0.649)]
    contact = of_width(wk.LayeredLineFoundation(CYLINDER, wk.CoatedHalfSpace(layers, wk.Elastic(1.0, 0.3))), 0.0364)
    x, z = np.linspace(0.0, 0.0364, 81), 0.0364 * np.linspace(0.6, 1.0, 81)
    level = contact.stresses(x[:, None], z[None, :]).von_mises
    assert contact.layer_stresses()[0].von_mises >= np.max(level)


def test_yield_onset_on_layers_refuses_sharp_tips_and_films_that_are_dragged_away():
    solid = wk.Elastic(0.91, 0.3, strength=0.3)
    film = wk.SlidingFilm([wk.Layer(solid, 1.0)], on=solid)
    with pytest.raises(OutsideValidity, match="layer 1 slides on its base and carries no shear there"):
        wk.LineYieldOnset(wk.LayeredLineFoundation(CYLINDER, film), wk.Coulomb(0.1))
    with pytest.raises(InvalidInput, match="no layer or body has a strength"):
        wk.LineYieldOnset(yielding_pair(SOLID, SOLID, 1.0))
    with pytest.raises(OutsideValidity, match="sharp tip"):
        wk.LineYieldOnset(yielding_pair(solid, solid, 1.0, WEDGE)).solve()
