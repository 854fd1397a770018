"""Every stored reference of the Fortran tests (test/reference), through Python, to the bounds that are promised."""
from decimal import Decimal
from fractions import Fraction
from pathlib import Path

import numpy as np
import pytest

import kyvadlo
from kyvadlo.functions import bounds

FOLDER = Path(__file__).resolve().parents[2]/"test"/"reference"
if not FOLDER.is_dir():
    pytest.skip("only a clone of the repository has the references", allow_module_level=True)
EPS = np.finfo(float).eps

FUNCTIONS = {   # the functions of a file's results, in order
    "carlson_rc": ["elliprc"], "carlson_rd": ["elliprd"], "carlson_rf": ["elliprf"], "carlson_rg": ["elliprg"],
    "carlson_rj": ["elliprj"], "complete": ["ellipk", "ellipe", "ellipd", "ellipb"],
    "complete_c": ["ellipkc", "ellipec", "ellipdc", "ellipbc"], "complete_pi": ["ellippi"], "complete_pi_c": ["ellippic"],
    "incomplete": ["ellipkinc", "ellipeinc", "ellipdinc", "ellipbinc"],
    "incomplete_c": ["ellipkincc", "ellipeincc", "ellipdincc", "ellipbincc"], "incomplete_pi": ["ellippiinc"],
    "incomplete_pi_c": ["ellippiincc"], "nome": ["nome"], "nome_c": ["nomec"], "zeta": ["jacobi_zeta"],
    "zeta_c": ["jacobi_zetac"], "lambda": ["heuman_lambda"], "lambda_c": ["heuman_lambdac"], "bulirsch_cel": ["cel"],
    "bulirsch_el1": ["el1"], "bulirsch_el2": ["el2"], "bulirsch_el3": ["el3"], "jacobi": ["ellipj"], "jacobic": ["ellipjc"],
    "theta": ["theta", "theta_derivative"],
}
MAKERS = {"heights": kyvadlo.Orbit.from_heights, "gaps": kyvadlo.Orbit.from_gaps, "rises": kyvadlo.Orbit.from_rises,
          "energy": kyvadlo.Orbit.from_energy, "release": kyvadlo.Orbit.from_release,
          "top": lambda *x: kyvadlo.Orbit.from_energy(*x, above="top"),
          "bottom": lambda *x: kyvadlo.Orbit.from_energy(*x, above="bottom")}
MOTION = [f"{what}_{start}" for what in ("orbit", "azimuth", "position", "derivatives", "periods")
          for start in ("heights", "gaps", "rises")]
MOTION += ["turning_energy", "turning_top", "turning_bottom", "state", "passage_height", "passage_azimuth",
           "derivatives_energy", "derivatives_release", "periods_energy"]
STATES = sorted(path.stem for path in FOLDER.glob("derivatives_state_*.dat"))


def rows(name):
    """Set, bits, arguments as the doubles they are, results and conditions of every row that doubles can hold."""
    found = 0
    for line in (FOLDER/f"{name}.dat").read_text().splitlines():
        if line.startswith("columns"):
            arguments, results = map(int, line.split()[1:])
        elif line and not line.startswith("#"):
            words = line.split()
            bits = int(words[1])
            if bits == 128:
                continue
            numbers = [float(np.float32(word)) if bits == 32 else float(word) for word in words[2:2 + arguments]]
            expected = words[2 + arguments:2 + arguments + results]
            found += 1
            yield words[0], bits, numbers, expected, [float(word) for word in words[2 + arguments + results:]]
    assert found > 5


def exact(word):
    return Fraction(Decimal(word))


def is_finite(word):
    return not np.isnan(float(word)) and "inf" not in word.lower()


def ulps(actual, expected):
    """The distance in units in the last place; NaN passes no comparison."""
    actual = float(actual)
    if not is_finite(expected) or not np.isfinite(actual):
        return 0.0 if actual == float(expected) else np.inf
    return float(abs(Fraction(actual) - exact(expected))/Fraction(float(np.spacing(abs(float(expected))))))


def test_every_file_is_read_here():
    apart = {"cubic", "theta_complex", "legendre_extremes", "legendre_peers",   # below
             "grid_points", "events"}   # decimals of a grid of the command line: no function of the package
    assert {path.stem for path in FOLDER.glob("*.dat")} == {*FUNCTIONS, *MOTION, *STATES, *apart}


@pytest.mark.parametrize("name", FUNCTIONS)
def test_function(name):
    functions = FUNCTIONS[name]
    worst = 0.0
    for label, bits, x, expected, condition in rows(name):
        if name.startswith("theta"):
            x[0] = int(x[0])
        values, singles = [], []
        for function in functions:
            ufunc = getattr(kyvadlo, function)
            values += np.atleast_1d(ufunc(*x)).tolist()
            if bits == 32:
                single = ufunc(*(number if isinstance(number, int) else np.float32(number) for number in x))
                singles += np.atleast_1d(single).tolist()
        for i, value in enumerate(values):
            function = functions[min(i, len(functions) - 1)]
            is_outside = ((function in ("ellipkinc", "ellipeinc") and x[1] > 1)
                          or (function == "ellipj" and not 0 <= x[1] <= 1)
                          or (function == "elliprc" and x[1] == 0) or (function == "elliprj" and x[3] == 0))
            if is_outside:   # of SciPy's domain
                assert np.isnan(value)
                continue
            units, slack = bounds[function]
            error = ulps(value, expected[i])
            assert error <= units + slack*condition[i], (label, x, value, expected[i], error)
            worst = max(worst, error/(units + slack*condition[i]))
            if bits == 32 and is_finite(expected[i]):   # computed in double, rounded once
                with np.errstate(all="ignore"):
                    assert singles[i] == np.float32(value), (label, x)
    assert worst > 0.01   # errors were measured


def test_theta_of_complex_arguments():
    for label, bits, (i, re, im, q), expected, condition in rows("theta_complex"):
        for part, function in ((0, kyvadlo.theta), (2, kyvadlo.theta_derivative)):
            value = function(int(i), complex(re, im), q)
            unit = np.spacing(abs(complex(float(expected[part]), float(expected[part + 1]))))
            for k, number in enumerate((value.real, value.imag)):
                error = abs(Fraction(float(number)) - exact(expected[part + k]))/Fraction(float(unit))
                assert error <= 8 + 4*condition[part + k], (label, i, re, im, q, value)


def test_cubics():
    for label, bits, x, expected, condition in rows("cubic"):
        *roots, count = kyvadlo.cubic_roots(*x)
        assert count == int(expected[0])
        for i in range(count):
            slack = 0 if label.startswith("exact_") else 1
            assert ulps(roots[i], expected[i + 1]) <= 4 + slack*condition[i + 1], (label, x, roots)
        assert np.isnan(roots[count:]).all()


def test_extremes_of_legendres_integrals():
    for label, bits, (n, phi, mc), expected, condition in rows("legendre_extremes"):
        value = kyvadlo.ellippic(n, mc) if label == "complete" else kyvadlo.ellippiincc(n, phi, mc)
        assert ulps(value, expected[0]) <= 8 + 4*condition[0]


def test_arguments_at_which_peers_failed():
    """From a modulus or parameter next to 1, whose complement is formed in more digits and rounded once."""
    used = 0
    for label, bits, (n, phi, last), expected, condition in rows("legendre_peers"):
        mc = 1 - Fraction(last)
        if label.endswith("_k"):
            mc *= 1 + Fraction(last)
        mc = float(mc)
        values = {"f": lambda: kyvadlo.ellipkincc(phi, mc), "e": lambda: kyvadlo.ellipeincc(phi, mc),
                  "d": lambda: kyvadlo.ellipdincc(phi, mc), "pi": lambda: kyvadlo.ellippiincc(n, phi, mc),
                  "cpi": lambda: kyvadlo.ellippic(n, mc), "k": lambda: kyvadlo.ellipkc(mc)}
        what = label.split("_")[1]
        if what == "z":   # its argument F is not known to the digits that it takes
            continue
        assert ulps(values[what](), expected[0]) <= 8, label
        used += 1
    assert used > 15


@pytest.mark.parametrize("start", ["heights", "gaps", "rises"])
def test_constants_of_orbits(start):
    for label, bits, x, expected, condition in rows(f"orbit_{start}"):
        orbit = MAKERS[start](*x)
        answers = (orbit.period, orbit.modulus, orbit.complementary_modulus, orbit.quarter_period, orbit.nome,
                   orbit.azimuth_rate, orbit.azimuth_per_period, orbit.advance)
        for i, answer in enumerate(answers):
            if is_finite(expected[i]):
                assert ulps(answer, expected[i]) <= (4, 4, 4, 4, 6, 64, 4, 4)[i], (label, x, i)


@pytest.mark.parametrize("start", ["energy", "top", "bottom"])
def test_turning_heights(start):
    for label, bits, x, expected, condition in rows(f"turning_{start}"):
        for i, value in enumerate(MAKERS[start](*x).turning_heights):
            assert ulps(value, expected[i]) <= 4 + condition[i], (label, x, i)


@pytest.mark.parametrize("start", ["heights", "gaps", "rises"])
def test_azimuths(start):
    for label, bits, x, expected, condition in rows(f"azimuth_{start}"):
        unit = np.spacing(abs(float(expected[0])))
        error = abs(Fraction(float(MAKERS[start](*x[:4]).azimuth(x[4]))) - exact(expected[0]))
        assert float(error) <= (8 + condition[0])*unit + 8*EPS, (label, x)


@pytest.mark.parametrize("start", ["heights", "gaps", "rises"])
def test_positions(start):
    for label, bits, x, expected, condition in rows(f"position_{start}"):
        orbit = MAKERS[start](*x[:4])
        state = np.concatenate(orbit.state(x[4]))
        error = np.array([float(Fraction(float(value)) - exact(word)) for value, word in zip(state, expected)])
        fastest = orbit.speed(orbit.period/2)
        fastest = fastest if fastest > 0 else 1.0
        room = 1 if abs(x[4]) <= 1001*orbit.period else 4
        assert np.linalg.norm(error[:3]) <= 8*room*EPS*x[0], (label, x)
        assert np.linalg.norm(error[3:]) <= 16*room*EPS*fastest, (label, x)


def test_states():
    for label, bits, x, expected, condition in rows("state"):
        orbit = kyvadlo.Orbit.from_state(x[0], x[1], x[2:5], x[5:8])
        state = np.concatenate(orbit.state(x[8]))
        turning = orbit.turning_heights
        fastest = np.sqrt(2*x[1]*(orbit.length + turning.upper + turning.outer_excess)) or 1.0
        for i, (value, word) in enumerate(zip(state, expected)):
            room = 16*EPS*(x[0] if i < 3 else fastest) + 8*condition[i]*np.spacing(abs(float(word)))
            assert float(abs(Fraction(float(value)) - exact(word))) <= room, (label, x, i)


@pytest.mark.parametrize("what", ["height", "azimuth"])
def test_passages(what):
    for label, bits, x, expected, condition in rows(f"passage_{what}"):
        orbit = kyvadlo.Orbit.from_heights(*x[:4])
        t = (orbit.time_to_height if what == "height" else orbit.time_to_azimuth)(x[4])
        room = 8*EPS*orbit.period + (1 + condition[0])*np.spacing(abs(float(expected[0])))
        assert float(abs(Fraction(float(t)) - exact(expected[0]))) <= room, (label, x)


def share(matrix, expected, change, units):
    """The greatest error of the columns, as a share of what test/unit/test_derivatives.pf allows."""
    allowed = units*EPS*np.abs(expected).max(axis=0) + 8*change
    error = np.abs(matrix - expected)
    return np.max(error/(allowed + np.finfo(float).tiny))


def changes(matrix_of, x, numbers):
    """The matrix, and what half an ulp of every argument makes of it: moved by 4096 ulps, that rounding does not count."""
    matrix, change = matrix_of(x), 0
    for k in range(numbers):
        if x[k] == 0:
            continue
        for sign in (1, -1):
            moved = list(x)
            moved[k] += sign*4096*np.spacing(x[k])
            try:
                other = matrix_of(moved)
            except ValueError:
                continue
            break
        else:
            return matrix, None
        change = change + np.abs(other - matrix)/8192
    return matrix, change


@pytest.mark.parametrize("name", STATES)
def test_derivatives_from_states(name):
    # As test/unit/test_derivatives.pf, but of the vector kernels, whose worst is 36.
    for label, bits, x, expected, condition in rows(name):
        def matrix_of(x):
            return kyvadlo.Orbit.from_state(x[0], x[1], x[2:5], x[5:8]).derivatives(x[8]).matrices
        matrix, change = changes(matrix_of, x, 9)
        assert share(matrix, np.reshape([float(word) for word in expected], (6, 9)), change, 48) <= 1, (label, x)


@pytest.mark.parametrize("start", ["heights", "gaps", "rises", "energy", "release"])
def test_derivatives_from_turning_heights(start):
    compared = total = 0
    for label, bits, x, expected, condition in rows(f"derivatives_{start}"):
        total += 1
        matrix, change = changes(lambda x: MAKERS[start](*x[:4]).derivatives(x[4]).matrices, x, 5)
        if change is None or np.isnan(change).any():
            continue
        compared += 1
        assert share(matrix, np.reshape([float(word) for word in expected], (6, 5)), change, 128) <= 1, (label, x)
    assert compared >= 0.8*total


@pytest.mark.parametrize("start", ["heights", "gaps", "rises", "energy"])
def test_derivatives_of_periods(start):
    for label, bits, x, expected, condition in rows(f"periods_{start}"):
        def of_period(x):
            found = MAKERS[start](*x).derivatives(0.0)
            return np.array([found.period, found.advance])
        slopes, change = changes(of_period, x, 4)
        if change is None or np.isnan(change).any():
            continue
        reference = np.reshape([float(word) for word in expected], (2, 4))
        scale = np.abs(reference*x[:4]).max(axis=1, keepdims=True)/np.abs(np.where(np.array(x[:4]) == 0, np.inf, x[:4]))
        error = np.abs(slopes - reference)
        assert (error <= 128*EPS*scale + 8*change + np.where(np.array(x[:4]) == 0, np.inf, 0)).all(), (label, x)
