"""The ufuncs: SciPy's names, orders, domains and edges; shapes, types, memory, threads."""
import inspect
import itertools
import warnings
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra import numpy as shapes

import kyvadlo
from kyvadlo.functions import __all__ as names

FUNCTIONS = {name: getattr(kyvadlo, name) for name in names}
OF_REALS = [name for name in names if not name.startswith("theta")]
SCIPYS = ["ellipk", "ellipkm1", "ellipe", "ellipkinc", "ellipeinc", "ellipj", "elliprc", "elliprd", "elliprf", "elliprg",
          "elliprj"]


def outputs(result):
    return result if isinstance(result, tuple) else (result,)


def same_bits(a, b):
    """Equal bit for bit; one NaN is as good as another."""
    a, b = np.ascontiguousarray(a), np.ascontiguousarray(b)
    return a.shape == b.shape and a.dtype == b.dtype and bool(
        np.all((a == b) & (np.signbit(a) == np.signbit(b)) | np.isnan(a) & np.isnan(b)))


def arguments(name, shape=(), seed=0, dtype=np.float64):
    """Random arguments, most of them inside the domain."""
    random = np.random.default_rng(seed)
    return [random.uniform(0.01, 0.99, shape).astype(dtype) for _ in range(FUNCTIONS[name].nin)]


# --- SciPy ---

def is_wrong_in_scipy(name, x):
    """Where SciPy's own value is wrong: the sign of an odd function (F(-2, 1), E(phi, -inf)), E(0, -inf) = 0, a phase without
    digits; Carlson's: overflow and underflow on the way, NaN among zeros, the sign of some principal values."""
    if name in ("ellipk", "ellipkm1", "ellipe"):
        return False
    if name == "ellipkinc":
        return (x[1] == 1 and x[0] < 0) or (abs(x[0]) == np.pi/2 and x[1] > 0.99) or (abs(x[0]) >= 3 and x[1] == -1e308)
    if name == "ellipeinc":
        return np.isinf(x[1]) and x[0] <= 0
    if name == "ellipj":
        return abs(x[0]) == 1e-300 or abs(x[0]) >= 1e16
    return not np.isfinite(x).all() or any(abs(number) == 1e308 or 0 < abs(number) < 1e-300 for number in x) or x[-1] < 0


@pytest.mark.parametrize("name", SCIPYS)
def test_domains_and_edges_are_scipys(name):
    special = pytest.importorskip("scipy.special")
    function, theirs = FUNCTIONS[name], getattr(special, name)
    assert (function.nin, function.nout) == (theirs.nin, theirs.nout)
    values = [-np.inf, -1e308, -2., -1., -1e-300, -0., 0., 1e-300, 0.5, 1 - 1e-16, 1., 1 + 3e-16, np.pi/2, 2., np.pi, 1e16,
              1e308, np.inf, np.nan]
    if function.nin > 2:
        values = [-np.inf, -1., -0., 0., 5e-324, 1., 2.5, 1e308, np.inf, np.nan]
    compared = 0
    with np.errstate(all="ignore"):
        for x in itertools.product(*[values]*function.nin):
            expected = np.array(outputs(theirs(*x)))
            if is_wrong_in_scipy(name, x):
                continue
            np.testing.assert_allclose(np.array(outputs(function(*x))), expected, rtol=1e-13, atol=1e-300, err_msg=f"{name}{x}")
            compared += 1
    assert compared > 15


def test_a_program_for_scipy_runs():
    program = """from scipy.special import ellipk, ellipe, ellipkinc, ellipeinc, ellipj, ellipkm1, elliprf
import numpy as np
m = np.linspace(0, 0.99, 12)
perimeter = 4*ellipe(m)
sn, cn, dn, ph = ellipj(0.7, m)
answer = [perimeter, ellipk(m), ellipkm1(1 - m), ellipkinc(0.3, m), ellipeinc(0.3, m), sn, cn, dn, ph, elliprf(0, 1 - m, 1)]
"""
    pytest.importorskip("scipy")
    spaces = {}, {}
    exec(program, spaces[0])
    exec(program.replace("from scipy.special import", "from kyvadlo import"), spaces[1])
    np.testing.assert_allclose(spaces[1]["answer"], spaces[0]["answer"], rtol=1e-14)


def test_what_scipy_has_not_agrees_with_carlsons_forms():
    n, phi, m = 0.3, 0.9, 0.6
    s, c = np.sin(phi), np.cos(phi)
    expected = s*kyvadlo.elliprf(c*c, 1 - m*s*s, 1) + n/3*s**3*kyvadlo.elliprj(c*c, 1 - m*s*s, 1, 1 - n*s*s)   # DLMF 19.25.14
    assert kyvadlo.ellippiinc(n, phi, m) == pytest.approx(expected, rel=1e-14)
    assert kyvadlo.ellippi(n, m) == pytest.approx(kyvadlo.ellippiinc(n, np.pi/2, m), rel=1e-14)


# --- Shapes, types, memory ---

@settings(deadline=None, max_examples=60)
@given(st.data())
@pytest.mark.parametrize("name", ["ellipk", "ellipkinc", "elliprd", "elliprj", "ellipj", "cubic_roots"])
def test_broadcasting(name, data):
    """Any shapes that broadcast, 0-d and empty too: elements are those of single calls."""
    function = FUNCTIONS[name]
    found = data.draw(shapes.mutually_broadcastable_shapes(num_shapes=function.nin, max_dims=4, max_side=4, min_side=0))
    numbers = st.floats(allow_nan=True, allow_infinity=True, width=64)
    x = [data.draw(shapes.arrays(np.float64, shape, elements=numbers)) for shape in found.input_shapes]
    for i, values in enumerate(outputs(function(*x))):
        assert np.shape(values) == found.result_shape
        for index, *single in zip(np.ndindex(found.result_shape), *(a.ravel() for a in np.broadcast_arrays(*x))):
            assert same_bits(values[index], outputs(function(*single))[i])


@pytest.mark.parametrize("name", OF_REALS)
def test_memory_of_every_kind(name):
    """Fortran order, steps, backwards, other byte order, unaligned, more than a block: the bits of contiguous memory."""
    function = FUNCTIONS[name]
    x = arguments(name, (41, 37))
    expected = outputs(function(*x))
    for view in (np.asfortranarray, lambda a: np.repeat(a, 3, axis=1)[:, ::3], lambda a: a[::-1, ::-1].copy()[::-1, ::-1],
                 lambda a: a.astype(">f8"), unaligned):
        for got, wanted in zip(outputs(function(*map(view, x))), expected):
            assert same_bits(got, wanted)


def unaligned(a):
    room = np.empty(a.nbytes + 1, dtype=np.uint8)[1:].view(np.float64).reshape(a.shape)
    room[...] = a
    return room


@pytest.mark.parametrize("name", OF_REALS)
def test_out_and_where(name):
    function = FUNCTIONS[name]
    x = arguments(name, 1300)
    expected = outputs(function(*x))
    out = tuple(np.full_like(values, -7) for values in expected)
    where = np.arange(1300) % 3 == 0
    assert all(a is b for a, b in zip(outputs(function(*x, out=out, where=where)), out))
    for got, wanted in zip(out, expected):
        assert same_bits(got[where], wanted[where]) and (got[~where] == -7).all()
    if expected[0].dtype == np.float64:   # into the memory of an argument, and shifted by one
        copy = [a.copy() for a in x]
        first = outputs(function(*copy, out=(copy[-1],) + (None,)*(function.nout - 1)))[0]
        assert first is copy[-1] and same_bits(first, expected[0])
        room = np.concatenate([x[0], [0.5]])
        rest = [a[:1300] for a in x[1:]]
        shifted = outputs(function(room[:-1], *rest, out=(room[1:],) + (None,)*(function.nout - 1)))[0]
        assert same_bits(shifted, expected[0])


@pytest.mark.parametrize("name", OF_REALS)
def test_types(name):
    function = FUNCTIONS[name]
    singles = arguments(name, 700, dtype=np.float32)
    results, doubles = outputs(function(*singles)), outputs(function(*(a.astype(np.float64) for a in singles)))
    for single, double in zip(results, doubles):
        if double.dtype == np.float64:
            assert single.dtype == np.float32 and same_bits(single, double.astype(np.float32))
    whole = [np.ones(3, dtype=np.int64) for _ in singles]
    for got, wanted in zip(outputs(function(*whole)), outputs(function(*(a.astype(np.float64) for a in whole)))):
        assert same_bits(got, wanted)
    assert np.isscalar(outputs(function(*(0.5 for _ in singles)))[0])
    with pytest.raises(TypeError):
        function(*(["a"] for _ in singles))


def test_theta_takes_whole_numbers_and_complex_arguments():
    i = np.arange(1, 5)[:, None]
    v = np.array([0.3, 1.7, -2])
    assert kyvadlo.theta(i, v, 0.2).shape == (4, 3)
    np.testing.assert_allclose(kyvadlo.theta(i, v + 0j, 0.2), kyvadlo.theta(i, v, 0.2), rtol=1e-14)
    assert kyvadlo.theta(1, np.float32(1), np.float32(0.1)).dtype == np.float32
    assert kyvadlo.theta(1, np.complex64(1j), np.float32(0.1)).dtype == np.complex64
    assert np.isnan(kyvadlo.theta([0, 5, -1, 2**40], 0.3, 0.2)).all()
    with pytest.raises(TypeError):
        kyvadlo.theta(1.5, 0.3, 0.2)


def test_masked_arrays_keep_their_mask():
    m = np.ma.masked_array([0.1, 0.5, 2.0], mask=[False, True, False])
    k = kyvadlo.ellipk(m)
    assert isinstance(k, np.ma.MaskedArray) and k.mask.tolist() == [False, True, False]
    assert k[0] == kyvadlo.ellipk(0.1)


@pytest.mark.parametrize("name", OF_REALS)
def test_nan_in_nan_out_and_no_warning(name):
    function = FUNCTIONS[name]
    with warnings.catch_warnings(), np.errstate(all="raise"):
        warnings.simplefilter("error")
        for i in range(function.nin):
            x = [0.5]*function.nin
            x[i] = np.nan
            assert np.isnan(outputs(function(*x))[0])
            for edge in (np.inf, -np.inf, 0.0, -5.0, 1.0, 1e308, 5e-324):
                x[i] = edge
                function(*x)


def test_every_lock_is_released_and_threads_change_no_bit():
    x = {name: arguments(name, 20000, seed=3) for name in OF_REALS}
    expected = {name: outputs(FUNCTIONS[name](*x[name])) for name in OF_REALS}
    with ThreadPoolExecutor(4) as pool:
        for name, got in zip(OF_REALS*2, pool.map(lambda name: outputs(FUNCTIONS[name](*x[name])), OF_REALS*2)):
            assert all(same_bits(a, b) for a, b in zip(got, expected[name]))


@pytest.mark.parametrize("name", names)
def test_docstrings_are_numpydoc(name):
    doc = inspect.getdoc(FUNCTIONS[name])
    for section in ("Parameters", "Returns", "Notes", "Examples"):
        assert f"\n{section}\n{'-'*len(section)}\n" in doc
    for word in ("Formula: ", "Domain: ", "Error: at most ", "Source: ", ">>> ", "rad"):
        assert word in doc
