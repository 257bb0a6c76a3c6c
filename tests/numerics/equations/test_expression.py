"""Formulas: what is read, what is refused and how, and derivatives against 30-digit arithmetic."""

from __future__ import annotations

import dataclasses
import math
import pickle

import mpmath as mp
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from winkler.numerics.equations.expression import Expression
from winkler.numerics.equations.taylor import FUNCTIONS, power_sum
from winkler.values.errors import InvalidInput

INF, NAN = math.inf, math.nan

# text, the same function in mpmath, places
SMOOTH = [
    ("r**2/(2*0.5)", lambda r: r**2, (0.3, 2.0)),
    ("0.5 - sqrt(0.5**2 - r**2)", lambda r: mp.mpf("0.5") - mp.sqrt(mp.mpf("0.25") - r**2), (1e-3, 0.2, 0.49)),
    ("2*(1 - cos(2*pi*r/3))", lambda r: 2 * (1 - mp.cos(2 * mp.pi * r / 3)), (0.1, 1.0, 7.0)),
    ("exp(-r)*sin(3*r) + r**3.5", lambda r: mp.exp(-r) * mp.sin(3 * r) + r ** mp.mpf("3.5"), (0.2, 1.5)),
    ("log(1 + r)/(1 + r**2)", lambda r: mp.log(1 + r) / (1 + r**2), (0.2, 3.0)),
    ("tan(r)**2", lambda r: mp.tan(r) ** 2, (0.4, 1.1)),
    ("arcsin(r)*arccos(r)", lambda r: mp.asin(r) * mp.acos(r), (0.2, 0.8)),
    ("arctan(r/0.3)", lambda r: mp.atan(r / mp.mpf("0.3")), (0.1, 2.0)),
    ("sinh(r) - cosh(2*r) + tanh(r)", lambda r: mp.sinh(r) - mp.cosh(2 * r) + mp.tanh(r), (0.3, 1.7)),
    ("e**(2*r) - 1", lambda r: mp.exp(2 * r) - 1, (0.3,)),
    ("r**r", lambda r: r**r, (0.3, 1.4)),
    ("2**-r", lambda r: mp.mpf(2) ** -r, (0.7,)),
    ("(1 + r)**-2.5", lambda r: (1 + r) ** mp.mpf("-2.5"), (0.7,)),
    ("1/(1 + sqrt(1 + r**2))", lambda r: 1 / (1 + mp.sqrt(1 + r**2)), (0.5, 4.0)),
    ("-(r - 2)**3 - -r", lambda r: -((r - 2) ** 3) + r, (0.5, 3.0)),
    ("((r-1)**2)**0.5", lambda r: mp.fabs(r - 1), (0.5, 3.0)),
    ("3e-2*r + .5*r**2.", lambda r: mp.mpf("0.03") * r + r**2 / 2, (0.5,)),
    ("r*sqrt(r)*log(r)", lambda r: r ** mp.mpf("1.5") * mp.log(r), (0.2, 2.5)),
]


@pytest.mark.parametrize(("text", "exact", "places"), SMOOTH, ids=[text for text, _, _ in SMOOTH])
def test_value_and_derivatives_are_exact(text, exact, places):
    got = Expression(text).taylor(places)
    with mp.workdps(30):
        for order, array in enumerate(got):
            for place, number in zip(places, array, strict=True):
                wanted = exact(mp.mpf(place)) if order == 0 else mp.diff(exact, mp.mpf(place), order)
                size = max(abs(wanted), mp.mpf(1) if order == 0 else mp.mpf("1e-3"))
                assert abs(number - wanted) < 2e-13 * size, (order, place)


@pytest.mark.parametrize("name", FUNCTIONS)
def test_every_function_against_mpmath(name):
    ours = {"arcsin": mp.asin, "arccos": mp.acos, "arctan": mp.atan, "log": mp.log}
    exact = ours.get(name) or getattr(mp, name)
    places = np.array([0.1, 0.35, 0.9])
    value, first, second = Expression(f"{name}(r)").taylor(places)
    with mp.workdps(30):
        for n, place in enumerate(map(mp.mpf, places.tolist())):
            assert value[n] == pytest.approx(float(exact(place)), rel=1e-15)
            assert first[n] == pytest.approx(float(mp.diff(exact, place)), rel=1e-14)
            assert second[n] == pytest.approx(float(mp.diff(exact, place, 2)), rel=1e-13, abs=1e-15)


@pytest.mark.parametrize(
    ("text", "value", "first", "second"),
    [
        ("r**2", 0.0, 0.0, 2.0),
        ("sqrt(r**2)", 0.0, 1.0, 0.0),
        ("sqrt(r**2/4)*3", 0.0, 1.5, 0.0),
        ("(r**2)**0.75", 0.0, 0.0, INF),
        ("r**1.5", 0.0, 0.0, INF),
        ("-r**1.5", 0.0, 0.0, -INF),
        ("r**2.5", 0.0, 0.0, 0.0),
        ("r**0.5", 0.0, INF, -INF),
        ("r**3/r", 0.0, 0.0, 2.0),
        ("r**2*log(r)", 0.0, 0.0, -INF),
        ("r**3*log(r)", 0.0, 0.0, 0.0),
        ("log(r)*r**3", 0.0, 0.0, 0.0),
        ("0*log(r)", 0.0, 0.0, 0.0),
        ("r*log(r)", 0.0, -INF, INF),
        ("r**1.5*cos(r)", 0.0, 0.0, INF),
        ("r**1.5*sin(r)", 0.0, 0.0, 0.0),
        ("sin(r)**1.5", 0.0, 0.0, INF),
        ("sqrt(sin(r))", 0.0, INF, -INF),
        ("arccos(1 - r)", 0.0, INF, -INF),
        ("log(r)", -INF, INF, -INF),
        ("r*sqrt(1 + r)", 0.0, 1.0, 1.0),
        ("1 - cos(r)", 0.0, 0.0, 1.0),
        # undetermined: nothing is invented
        ("sin(r)/r", NAN, NAN, NAN),
        ("(1 - cos(r))/r", NAN, NAN, NAN),
        ("1/r", NAN, NAN, NAN),
        ("sqrt(1 - cos(r))", 0.0, NAN, NAN),
        ("sqrt(sin(r))*sqrt(sin(r))", 0.0, NAN, NAN),
        ("cos(sqrt(r))", 1.0, NAN, NAN),
    ],
)
def test_at_zero_limits_are_taken_or_nan(text, value, first, second):
    got = [float(part[0]) for part in Expression(text).taylor([0.0])]
    np.testing.assert_array_equal(got, [value, first, second])


def test_limits_at_zero_agree_with_those_from_above():
    """The value at r = 0 is the limit of r -> 0."""
    for text in ("r*sqrt(1 + r)", "r**2*log(r)", "sqrt(r**2 + 4) - 2", "r**3*log(r)", "r**1.5*sin(r)"):
        here, near = (Expression(text).taylor([place]) for place in (0.0, 1e-14))
        for order in range(2):
            assert near[order][0] == pytest.approx(here[order][0], abs=1e-6), text


def test_outside_the_real_numbers_there_is_nan_and_no_warning():
    value, first, second = Expression("sqrt(1 - r) + log(2 - r)").taylor([0.5, 1.5, 3.0])
    assert np.isfinite([value[0], first[0], second[0]]).all()
    assert np.isnan([value[1:], first[1:], second[1:]]).all()
    assert Expression("exp(r)").taylor([1e4])[0][0] == INF


def test_shapes_follow_the_places():
    law = Expression("3 + 0*r")
    assert [part.shape for part in law.taylor(np.zeros((2, 3)))] == [(2, 3)] * 3
    assert law.taylor(0.5)[0].shape == ()
    assert Expression("sin(r)").taylor(np.zeros(0))[2].shape == (0,)


def test_constants_and_variable_have_names():
    law = Expression("a*x**2 + b_1*x", "x", (("a", 2.0), ("b_1", -1)))
    value, first, second = law.taylor([3.0])
    assert (value[0], first[0], second[0]) == (15.0, 11.0, 4.0)
    assert law == pickle.loads(pickle.dumps(law))
    assert hash(law) == hash(dataclasses.replace(law))
    assert law != dataclasses.replace(law, constants=(("a", 3.0), ("b_1", -1)))


def test_powers_are_separated_from_the_rest():
    law = Expression("r**2/(2*R) - 4*r**4*R", constants=(("R", 0.5),))
    assert law.powers == ((1.0, 2.0), (-2.0, 4.0))
    assert law.remainder([1.0]) is None
    assert Expression("sqrt(4*r**3)*(1 + r) - 3").powers == ((-3.0, 0.0), (2.0, 1.5), (2.0, 2.5))
    mixed = Expression("r + 2*sin(r) - 3*r**2/2")
    assert mixed.powers == ((1.0, 1.0), (-1.5, 2.0))
    np.testing.assert_allclose(
        [part[0] for part in mixed.remainder([0.5])], [2 * math.sin(0.5), 2 * math.cos(0.5), -2 * math.sin(0.5)]
    )
    assert Expression("(1 + r)**2").powers == ()


def test_a_power_sum_at_zero():
    value, first, second = power_sum(((2.0, 0.0), (3.0, 1.0), (1.0, 1.5)), np.array([0.0, 4.0]))
    np.testing.assert_array_equal(value, [2.0, 22.0])
    np.testing.assert_array_equal(first, [3.0, 6.0])
    np.testing.assert_array_equal(second, [INF, 0.375])


def test_the_magnitude_is_what_rounding_is_measured_against():
    law = Expression("2*(R - sqrt(R**2 - r**2)) - (r - 1)/4", constants=(("R", 3.0),))
    assert law.magnitude([0.0])[0] == pytest.approx(12.25)
    assert abs(law.taylor([0.0])[0][0] - 0.25) < 1e-15 * law.magnitude([0.0])[0]


@given(st.lists(st.tuples(st.floats(-5, 5), st.integers(0, 6)), min_size=1, max_size=6), st.floats(0.0, 3.0))
def test_polynomials_equal_numpy_polynomials(terms, place):
    text = " + ".join(f"({c!r})*r**{p}" for c, p in terms)
    coefficients = np.zeros(7)
    for c, p in terms:
        coefficients[p] += c
    poly = np.polynomial.Polynomial(coefficients)
    size = np.polynomial.Polynomial(np.bincount([p for _, p in terms], [abs(c) for c, _ in terms], 7))
    for order, part in enumerate(Expression(text).taylor([place])):
        wanted, scale = (poly, size) if order == 0 else (poly.deriv(order), size.deriv(order))
        assert abs(part[0] - wanted(place)) <= 1e-13 * scale(place) + 1e-300


LONG = "r" + "+r" * 600

REFUSED = [
    ("", "it is empty; write it in terms of the variable, as r**2/(2*R)."),
    (" \t", "it is empty; write it in terms of the variable, as r**2/(2*R)."),
    ("r^2", "write powers with **, as r**2."),
    ("r²", "write powers with **, as r**2."),
    (
        "r**2,5",
        "a comma or a bracket is out of place; write decimals with a point, as 2.5, thousands without, as 2500.",
    ),
    ("2r", "an operator is missing between '2' and 'r'."),
    ("2(r)", "an operator is missing between '2' and '('."),
    ("r r", "an operator is missing between 'r' and 'r'."),
    ("(r)(r)", "an operator is missing between ')' and '('."),
    ("1.2.3*r", "an operator is missing between '1.2' and '.3'."),
    ("1_000*r", "an operator is missing between '1' and '_000'."),
    ("0x10*r", "an operator is missing between '0' and 'x10'."),
    ("2j*r", "an operator is missing between '2' and 'j'."),
    ("r(2)", "'r' is not a function; write r*(...)."),
    ("pi(r)", "'pi' is not a function; write pi*(...)."),
    ("(r+1)(2)", "an operator is missing between ')' and '('."),
    ("sqrt", "sqrt takes one argument; write sqrt(...)."),
    ("sqrt*r", "sqrt takes one argument; write sqrt(...)."),
    ("sqrt()", "sqrt takes one argument; write sqrt(...)."),
    ("exp(r, 2)", "exp takes one argument; write exp(...)."),
    ("exp(*r)", "exp takes one argument; write exp(...)."),
    (
        "abs(r)",
        "abs(...) is not allowed: its kink must be stated: write sqrt((...)**2), and give the radius where that "
        "vanishes among the corners.",
    ),
    ("max(r, 1)", "max(...) is not allowed: it has kinks or jumps; give the pieces as profiles of their own."),
    ("where(r, 1, 2)", "where(...) is not allowed: it has kinks or jumps; give the pieces as profiles of their own."),
    ("asin(r)", "asin(...) is not allowed: write arcsin, arccos or arctan."),
    ("ln(r)", "ln(...) is not allowed: write log, the natural logarithm."),
    ("pow(r, 2)", "pow(...) is not allowed: write powers with **."),
    (
        "snh(r)",
        "snh(...) is not allowed: the function is unknown (did you mean 'sinh'?); known are sqrt, exp, log, sin, cos, "
        "tan, arcsin, arccos, arctan, sinh, cosh, tanh.",
    ),
    ("Q*r", "the name 'Q' is unknown; known are r, pi, e."),
    ("rr**2", "the name 'rr' is unknown (did you mean 'r'?); known are r, pi, e."),
    ("r.real", "a point belongs inside a number; attributes are not allowed."),
    ("'a'", "text in quotes"),
    ("r if r else 0", "'if' is a reserved word; conditions are not allowed, and constants need other names."),
    ("lambda r: r", "'lambda' is a reserved word; conditions are not allowed, and constants need other names."),
    ("r and r", "'and' is a reserved word; conditions are not allowed, and constants need other names."),
    ("None", "'None' is a reserved word; conditions are not allowed, and constants need other names."),
    ("r > 1", "comparisons are not allowed; give the pieces as profiles of their own."),
    ("r == 1", "comparisons are not allowed; give the pieces as profiles of their own."),
    ("[r]", "the character '[' is not allowed; operators are + - * / **."),
    ("{r}", "the character '{' is not allowed; operators are + - * / **."),
    ("r @ r", "the character '@' is not allowed; operators are + - * / **."),
    ("r % 2", "the character '%' is not allowed; operators are + - * / **."),
    ("r; r", "the character ';' is not allowed; operators are + - * / **."),
    ("r := 1", "the character ':' is not allowed; operators are + - * / **."),
    ("−r", "the character '−' is not allowed; operators are + - * / **."),
    ("λ*r", "the character 'λ' is not allowed; operators are + - * / **."),
    ("r\x00", "the character '\\x00' is not allowed; operators are + - * / **."),
    ("r // 2", "its operators, brackets and numbers do not fit together."),
    ("r +", "its operators, brackets and numbers do not fit together."),
    ("r **", "its operators, brackets and numbers do not fit together."),
    ("(r", "its operators, brackets and numbers do not fit together."),
    ("r)", "its operators, brackets and numbers do not fit together."),
    ("r * * 2", "its operators, brackets and numbers do not fit together."),
    ("()", "a comma or a bracket is out of place; write decimals with a point, as 2.5, thousands without, as 2500."),
    ("9**9**9", "the exponent 3.8742e+08 is too large; at most 100 is allowed."),
    ("r**1000", "the exponent 1000 is too large; at most 100 is allowed."),
    ("(1 + sin(r))**-101", "the exponent -101 is too large; at most 100 is allowed."),
    ("1e999*r", "1e999 is too large a number."),
    ("1e200*1e200*r", "a constant part is too large to be computed."),
    ("(1e9)**99*r", "a constant part is too large to be computed."),
    ("log(-1)*r", "log(-1) is not a finite, real number."),
    ("exp(1000)*r", "exp(1000) is not a finite, real number."),
    ("arcsin(2)", "arcsin(2) is not a finite, real number."),
    ("(-2)**0.5", "(-2)**0.5 is not a real number."),
    ("sqrt(-r**2)", "(-1)**0.5 is not a real number."),
    ("1/0", "it divides by zero."),
    ("r/(2 - 2)", "it divides by zero."),
    ("0**-1", "it divides by zero."),
    ("-" * 150 + "r", "it is nested more than 100 deep; write it more simply."),
    ("r" + "+r" * 150, "it is nested more than 100 deep; write it more simply."),
    ("r**" * 150 + "2", "it is nested more than 100 deep; write it more simply."),
    ("(" * 400 + "r" + ")" * 400, "its operators, brackets and numbers do not fit together."),
    ("__import__('os')", "text in quotes"),
    ("__import__(os)", "__import__(...) is not allowed: the function is unknown"),
    ("().__class__", "a point belongs inside a number; attributes are not allowed."),
]


@pytest.mark.parametrize(("text", "sentence"), REFUSED, ids=[text[:20] for text, _ in REFUSED])
def test_what_is_refused_and_how(text, sentence):
    with pytest.raises(InvalidInput) as caught:
        Expression(text)
    message = str(caught.value)
    assert message.startswith(f"the formula {text[:60]!r}: ")
    if sentence == "text in quotes":
        sentence = 'the character "\'" is not allowed; operators are + - * / **.'
    stated = message.removeprefix(f"the formula {text[:60]!r}: ")
    assert stated == sentence or (not sentence.endswith(".") and stated.startswith(sentence))


def test_too_long_and_no_text():
    with pytest.raises(InvalidInput, match="a formula of 1201 characters is too long; at most 1000 are allowed"):
        Expression(LONG)
    with pytest.raises(InvalidInput, match=r"text is 3; give a text: a formula such as 'r\*\*2/\(2\*R\)\'"):
        Expression(3)


@pytest.mark.parametrize(
    ("constants", "sentence"),
    [
        ((("r", 1.0),), "a constant of a formula cannot be called 'r'"),
        ((("pi", 3.0),), "a constant of a formula cannot be called 'pi'"),
        ((("sin", 3.0),), "a constant of a formula cannot be called 'sin'"),
        ((("lambda", 3.0),), "a constant of a formula cannot be called 'lambda'"),
        ((("2a", 3.0),), "a constant of a formula cannot be called '2a'"),
        ((("ä", 3.0),), "a constant of a formula cannot be called 'ä'"),
        ((("a", NAN),), "the constant 'a' of a formula is nan; give a finite number."),
        ((("a", INF),), "the constant 'a' of a formula is inf; give a finite number."),
        ((("a", True),), "Expression: constants['a'] is True; give a number."),
        ((("a", "1"),), "Expression: constants['a'] is '1'; give a number."),
        ((("a", 1.0), ("b", 2.0)), "the formula 'a*r': the constant 'b' does not occur in it."),
        ((("a", 1.0), ("aa", 2.0)), "the formula 'a*r': the constant 'aa' does not occur in it (did you mean 'a'?)."),
    ],
)
def test_constants_are_checked(constants, sentence):
    with pytest.raises(InvalidInput) as caught:
        Expression("a*r", constants=constants)
    assert str(caught.value).startswith(sentence)


def test_negative_places_are_refused():
    with pytest.raises(InvalidInput, match="the formula 'r' is evaluated at r = -1, below zero"):
        Expression("r").taylor([1.0, -1.0])


def test_hostile_texts_neither_hang_nor_crash():
    for text in (
        "9" * 1000,
        "(" * 1000,
        ")" * 1000,
        "**" * 500,
        "r" + "**r" * 300,
        "sin(" * 200 + "r" + ")" * 200,
        "~" * 9,
    ):
        with pytest.raises(InvalidInput):
            Expression(text)


@given(st.text(alphabet="r0123456789.eE+-*/() ,_sincoqtlgxpab<>'\"[]:\n\\", max_size=40))
def test_any_text_is_read_or_refused(text):
    try:
        law = Expression(text)
    except InvalidInput:
        return
    assert all(part.shape == (2,) for part in law.taylor([0.0, 1.0]))
