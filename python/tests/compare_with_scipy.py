"""Functions of kyvadlo beside SciPy's: time of an element, and error.

    python python/tests/compare_with_scipy.py [--count N] [--check]

Time: N elements (a million) of random benign arguments, float64; medians, of the ratios too, over passes in which all are
measured in turn. "loop" is the Fortran array loop by itself, called through C into memory that is there; "kyvadlo" the ufunc,
its result newly allocated.
Error: the worst of the rows of test/reference (values of 40 digits or more at these very arguments), on benign sets and on all
the others, in ulps beyond what half an ulp of each argument makes; `fail`: rows with NaN or an error
above 1e-6 beyond that. With --check
the status is 1 if a function is slower or less accurate than SciPy's, or takes more than 1.3 times the loop.
"""
import argparse
import ctypes
import statistics
import sys
import time
from pathlib import Path

import numpy as np
import scipy
from scipy import special

from test_references import rows, ulps

import kyvadlo

#: Name, its loop in Fortran, its file of references and the result's column in it, ranges of benign arguments.
FUNCTIONS = [
    ("ellipk", "elliptic_k", "complete", 0, [(0, 1)]),
    ("ellipkm1", "elliptic_kc", "complete_c", 0, [(0, 1)]),
    ("ellipe", "elliptic_e", "complete", 1, [(0, 1)]),
    ("ellipkinc", "elliptic_f", "incomplete", 0, [(0, 1.5), (0, 1)]),
    ("ellipeinc", "elliptic_einc", "incomplete", 1, [(0, 1.5), (0, 1)]),
    ("ellipj", "sncndn", "jacobi", slice(0, 4), [(0, 3), (0, 1)]),
    ("elliprc", "carlson_rc", "carlson_rc", 0, [(0.1, 10)]*2),
    ("elliprf", "carlson_rf", "carlson_rf", 0, [(0.1, 10)]*3),
    ("elliprd", "carlson_rd", "carlson_rd", 0, [(0.1, 10)]*3),
    ("elliprg", "carlson_rg", "carlson_rg", 0, [(0.1, 10)]*3),
    ("elliprj", "carlson_rj", "carlson_rj", 0, [(0.1, 10)]*4),
]


def times(name, loop, ranges, count, passes):
    """Nanoseconds an element: the loop, kyvadlo, SciPy; kyvadlo over the loop, SciPy over kyvadlo."""
    random = np.random.default_rng(1)
    x = [random.uniform(*limits, count) for limits in ranges]
    ours, theirs = getattr(kyvadlo, name), getattr(special, name)
    results = [np.empty(count) for _ in range(ours.nout)]
    library = ctypes.CDLL(str(Path(kyvadlo.__file__).parent/"libkyvadlo_c.so"))
    bare = library[f"kyvadlo_{loop}_many"]
    pointers = [ctypes.c_void_p(a.ctypes.data) for a in x + results]
    calls = [lambda: bare(ctypes.c_size_t(count), *pointers), lambda: ours(*x), lambda: theirs(*x)]
    taken = [[], [], []]
    for number in range(passes + 1):   # the first one warms up
        for call, found in zip(calls, taken):
            start = time.perf_counter()
            call()
            if number:
                found.append((time.perf_counter() - start)*1e9/count)
    bare, ours, theirs = taken
    ratios = [[a/b for a, b in zip(*pair)] for pair in ((ours, bare), (theirs, ours))]
    return [statistics.median(found) for found in taken + ratios]


def errors(name, file, part):
    """Of kyvadlo and SciPy: worst errors on benign and hard sets, and the rows that fail."""
    found = []
    for function in (getattr(kyvadlo, name), getattr(special, name)):
        worst, failed = {True: 0.0, False: 0.0}, 0
        for label, bits, x, expected, condition in rows(file):
            expected, condition = np.atleast_1d(expected)[part], np.atleast_1d(condition)[part]
            if np.isnan(np.atleast_1d(special_value := function(*x))).any() and is_outside(name, x):
                continue
            for value, word, room in zip(np.atleast_1d(special_value), np.atleast_1d(expected), np.atleast_1d(condition)):
                error = ulps(value, str(word))
                if not error - room < 1e-6/np.finfo(float).eps:
                    failed += 1
                else:
                    is_benign = label.startswith("benign")
                    worst[is_benign] = max(worst[is_benign], error - room)
        found.append((worst[True], worst[False], failed))
    return found


def is_outside(name, x):
    """Where SciPy has no value by its own definition."""
    return (name in ("ellipkinc", "ellipeinc") and x[1] > 1) or (name == "ellipj" and not 0 <= x[1] <= 1) or \
        (name == "elliprc" and x[1] == 0) or (name == "elliprj" and x[3] == 0)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--count", type=int, default=1000000, help="elements to time")
    parser.add_argument("--passes", type=int, default=21)
    parser.add_argument("--check", action="store_true", help="status 1 if one is slower or less accurate")
    chosen = parser.parse_args()
    print(f"kyvadlo {kyvadlo.__version__}, SciPy {scipy.__version__}, NumPy {np.__version__}; {chosen.count} elements\n")
    print("                 ns an element                          error beyond the condition, ulp: benign / hard, fail")
    print("function        loop  kyvadlo    SciPy  of loop  faster          kyvadlo            SciPy")
    bad = []
    for name, loop, file, part, ranges in FUNCTIONS:
        bare, ours, theirs, of_loop, faster = times(name, loop, ranges, chosen.count, chosen.passes)
        mine, scipys = errors(name, file, part)
        texts = [f"{benign:8.2g} /{hard:8.2g}" + (f" {failed:4d}" if failed else "     ") for benign, hard, failed in (mine, scipys)]
        print(f"{name:12s} {bare:7.1f} {ours:8.1f} {theirs:8.1f} {of_loop:8.2f} {faster:7.2f}  {texts[0]}  {texts[1]}", flush=True)
        bad += [name]*(faster < 1 or of_loop > 1.3 or any(a > b for a, b in zip(mine, scipys)))
    if bad:
        print("slower or less accurate:", *bad)
    return 1 if bad and chosen.check else 0


if __name__ == "__main__":
    sys.exit(main())
