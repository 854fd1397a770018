"""Elliptic integrals and functions as NumPy ufuncs.

SciPy's names and argument orders where SciPy has them, with SciPy's domains and edges; ours where it has not. A name
that ends in ``c`` takes the complementary parameter ``mc = 1 - m``, which holds what ``m`` cannot near 1, and has a value
wherever the function has one. Outside the domain the value is NaN, without a warning. float32 in gives float32 out,
computed in double.
"""
from __future__ import annotations

import numpy as np

from . import _kyvadlo

__all__ = [
    "ellipk", "ellipkm1", "ellipkc", "ellipe", "ellipec", "ellipd", "ellipdc", "ellipb", "ellipbc", "ellippi",
    "ellippic", "nome", "nomec", "ellipkinc", "ellipkincc", "ellipeinc", "ellipeincc", "ellipdinc",
    "ellipdincc", "ellipbinc", "ellipbincc", "ellippiinc", "ellippiincc", "jacobi_zeta", "jacobi_zetac",
    "heuman_lambda", "heuman_lambdac", "elliprc", "elliprf", "elliprd", "elliprg", "elliprj", "cel", "el1",
    "el2", "el3", "ellipj", "ellipjc", "theta", "theta_derivative", "cubic_roots",
]

#: What the docstrings promise and the tests hold against every stored reference: so many ulps (units in the last place)
#: of the value, and so many times what half an ulp of every argument makes of it.
bounds: dict[str, tuple[int, int]] = {}

_MEANINGS = {
    "m": "Parameter, the square of the modulus.",
    "mc": "Complementary parameter, 1 - m.",
    "n": "Characteristic, in 1 - n sin(t)**2.",
    "phi": "Amplitude [rad].",
    "u": "Argument.",
    "x": "First argument.",
    "y": "Second argument.",
    "z": "Third argument.",
    "p": "Last argument of R_J; 1 - n of Bulirsch's integrals.",
    "i": "Which of the four: whole numbers from 1 to 4.",
    "v": "Argument [rad], real or complex.",
    "q": "Nome.",
    "kc": "Complementary modulus of either sign, kc**2 = 1 - m.",
    "t": "Tangent of the amplitude.",
    "a": "Coefficient.",
    "b": "Coefficient.",
    "c": "Coefficient.",
    "d": "Coefficient.",
}

def _ufunc(name: str, loop: str, arguments: str, summary: str, formula: str, domain: str, source: str, example: str,
           error: tuple[int, int] = (8, 4), results: str = "value") -> np.ufunc:
    """The ufunc ``name`` over the array loop ``loop``, with a docstring in the form of numpydoc."""
    bounds[name] = error
    parameters = "".join(f"{word} : array_like\n    {_MEANINGS[word]}\n" for word in arguments.split())
    condition = f", plus {error[1]} times what half an ulp of every argument makes" if error[1] else ""
    if " -> " in example:
        numbers, value = example.split(" -> ")
        example = f">>> print(f\"{{kyvadlo.{name}({numbers}):.12g}}\")\n{value}"
    return _kyvadlo.ufunc(loop, name, f"""{summary}

Parameters
----------
{parameters}out : ndarray or tuple of ndarray, optional
    Where the results go. ``where`` and further keywords are those of every ufunc.

Returns
-------
{results} : ndarray or scalar
    Of the shape to which the arguments broadcast. No unit; angles in rad.

Notes
-----
Formula: {formula}.

Domain: {domain}. NaN outside.

Error: at most {error[0]} ulp{condition}.

Source: {source}.

Examples
--------
>>> import kyvadlo
{example}
""")


_DELTA = "sqrt(1 - m sin(t)**2)"
_BELOW_1 = "m <= 1, down to minus infinity"
_SCIPY = "m <= 1; an infinite amplitude has an infinite integral"
_WIDE = "finite phi; m <= 1, and m > 1 as long as m sin(t)**2 <= 1 from 0 to phi"
_WIDE_C = "finite phi; mc >= 0, and mc < 0 as long as (1 - mc) sin(t)**2 <= 1 from 0 to phi"

# --- Legendre's complete integrals ---
ellipk = _ufunc("ellipk", "elliptic_k", "m", "Complete elliptic integral of the first kind.",
    f"K(m) = integral of 1/{_DELTA} over t from 0 to pi/2", f"{_BELOW_1}; K(1) is infinite", "DLMF 19.2.8",
    "0.5 -> 1.8540746773", (4, 0))
ellipkm1 = _ufunc("ellipkm1", "elliptic_kc", "p", "Complete elliptic integral of the first kind about m = 1.",
    "K(1 - p), by the name that SciPy gives `ellipkc`", "p >= 0; infinite at 0", "DLMF 19.2.8",
    "1e-300 -> 346.77405831", (4, 0))
ellipkc = _ufunc("ellipkc", "elliptic_kc", "mc", "Complete elliptic integral of the first kind, of the complement.",
    "K(1 - mc)", "mc >= 0; infinite at 0", "DLMF 19.2.8", "1e-300 -> 346.77405831", (4, 0))
ellipe = _ufunc("ellipe", "elliptic_e", "m", "Complete elliptic integral of the second kind.",
    f"E(m) = integral of {_DELTA} over t from 0 to pi/2", f"{_BELOW_1}; E(1) = 1", "DLMF 19.2.8",
    "0.5 -> 1.35064388105", (4, 0))
ellipec = _ufunc("ellipec", "elliptic_ec", "mc", "Complete elliptic integral of the second kind, of the complement.",
    "E(1 - mc)", "mc >= 0", "DLMF 19.2.8", "1e-10 -> 1.00000000062", (4, 0))
ellipd = _ufunc("ellipd", "elliptic_d", "m", "Complete elliptic integral D, which loses nothing at small m.",
    f"D(m) = integral of sin(t)**2/{_DELTA} over t from 0 to pi/2 = (K - E)/m", f"{_BELOW_1}; D(1) is infinite",
    "DLMF 19.2.6", "0.5 -> 1.00686159251", (4, 0))
ellipdc = _ufunc("ellipdc", "elliptic_dc", "mc", "Complete elliptic integral D, of the complement.", "D(1 - mc)",
    "mc >= 0; infinite at 0", "DLMF 19.2.6", "1e-10 -> 11.899219827", (4, 0))
ellipb = _ufunc("ellipb", "elliptic_b", "m", "Complete elliptic integral B.",
    f"B(m) = integral of cos(t)**2/{_DELTA} over t from 0 to pi/2 = K - D", f"{_BELOW_1}; B(1) = 1",
    "Bulirsch, Numer. Math. 7 (1965) 78", "0.5 -> 0.847213084794", (4, 0))
ellipbc = _ufunc("ellipbc", "elliptic_bc", "mc", "Complete elliptic integral B, of the complement.", "B(1 - mc)",
    "mc >= 0", "Bulirsch, Numer. Math. 7 (1965) 78", "1e-10 -> 0.99999999943", (4, 0))
ellippi = _ufunc("ellippi", "elliptic_pi", "n m", "Complete elliptic integral of the third kind.",
    f"Pi(n, m) = integral of 1/((1 - n sin(t)**2) {_DELTA}) over t from 0 to pi/2; for n > 1 Cauchy's principal "
    f"value", f"any n; {_BELOW_1}; infinite at n = 1 and at m = 1", "DLMF 19.2.7", "0.3, 0.5 -> 2.25037682194")
ellippic = _ufunc("ellippic", "elliptic_pic", "n mc",
    "Complete elliptic integral of the third kind, of the complement.", "Pi(n, 1 - mc)",
    "any n; mc >= 0; infinite at n = 1 and at mc = 0", "DLMF 19.2.7", "0.3, 1e-10 -> 17.9461480415")
nome = _ufunc("nome", "elliptic_nome", "m", "Nome of the parameter.",
    "q(m) = exp(-pi K(1 - m)/K(m)), continued to m < 0", f"{_BELOW_1}; q(1) = 1", "DLMF 22.2.1",
    "0.5 -> 0.0432139182638", (6, 0))
nomec = _ufunc("nomec", "elliptic_nomec", "mc", "Nome of the complementary parameter.", "q(1 - mc)", "mc >= 0",
    "DLMF 22.2.1", "1e-300 -> 0.985870178415", (6, 0))

# --- Legendre's incomplete integrals ---
ellipkinc = _ufunc("ellipkinc", "elliptic_f", "phi m", "Incomplete elliptic integral of the first kind.",
    f"F(phi, m) = integral of 1/{_DELTA} over t from 0 to phi",
    f"{_SCIPY}; F is infinite at m = 1 from pi/2 on, for which the double next to it counts", "DLMF 19.2.4",
    "1, 0.5 -> 1.08321677285")
ellipkincc = _ufunc("ellipkincc", "elliptic_fc", "phi mc",
    "Incomplete elliptic integral of the first kind, of the complement.", "F(phi, 1 - mc)", _WIDE_C,
    "DLMF 19.2.4", "1, -0.2 -> 1.33302183966")
ellipeinc = _ufunc("ellipeinc", "elliptic_einc", "phi m", "Incomplete elliptic integral of the second kind.",
    f"E(phi, m) = integral of {_DELTA} over t from 0 to phi", _SCIPY, "DLMF 19.2.5", "1, 0.5 -> 0.927329883624")
ellipeincc = _ufunc("ellipeincc", "elliptic_eincc", "phi mc",
    "Incomplete elliptic integral of the second kind, of the complement.", "E(phi, 1 - mc)", _WIDE_C,
    "DLMF 19.2.5", "1, 1e-10 -> 0.841470984827")
ellipdinc = _ufunc("ellipdinc", "elliptic_dinc", "phi m", "Incomplete elliptic integral D.",
    f"D(phi, m) = integral of sin(t)**2/{_DELTA} over t from 0 to phi = (F - E)/m", _WIDE, "DLMF 19.2.6",
    "1, 0.5 -> 0.311773778441")
ellipdincc = _ufunc("ellipdincc", "elliptic_dincc", "phi mc", "Incomplete elliptic integral D, of the complement.",
    "D(phi, 1 - mc)", _WIDE_C, "DLMF 19.2.6", "1, 1e-10 -> 0.384720186053")
ellipbinc = _ufunc("ellipbinc", "elliptic_binc", "phi m", "Incomplete elliptic integral B.",
    f"B(phi, m) = integral of cos(t)**2/{_DELTA} over t from 0 to phi = F - D", _WIDE,
    "Bulirsch, Numer. Math. 7 (1965) 78", "1, 0.5 -> 0.771442994404")
ellipbincc = _ufunc("ellipbincc", "elliptic_bincc", "phi mc", "Incomplete elliptic integral B, of the complement.",
    "B(phi, 1 - mc)", _WIDE_C, "Bulirsch, Numer. Math. 7 (1965) 78", "1, 1e-10 -> 0.841470984789")
ellippiinc = _ufunc("ellippiinc", "elliptic_piinc", "n phi m", "Incomplete elliptic integral of the third kind.",
    f"Pi(n; phi, m) = integral of 1/((1 - n sin(t)**2) {_DELTA}) over t from 0 to phi; beyond a pole Cauchy's "
    f"principal value", f"any n; {_WIDE}; infinite where n sin(phi)**2 = 1", "DLMF 19.2.7",
    "0.3, 1, 0.5 -> 1.19232543693")
ellippiincc = _ufunc("ellippiincc", "elliptic_piincc", "n phi mc",
    "Incomplete elliptic integral of the third kind, of the complement.", "Pi(n; phi, 1 - mc)",
    f"any n; {_WIDE_C}; infinite where n sin(phi)**2 = 1", "DLMF 19.2.7", "0.3, 1, 1e-10 -> 1.36168870907")
jacobi_zeta = _ufunc("jacobi_zeta", "jacobi_zeta", "u m", "Jacobi's zeta function of the argument u.",
    "Z(u, m) = E(am(u, m), m) - u E(m)/K(m)", f"finite u; {_BELOW_1}; Z(u, 1) = tanh(u)", "DLMF 22.16.32",
    "1, 0.5 -> 0.143801986499")
jacobi_zetac = _ufunc("jacobi_zetac", "jacobi_zetac", "u mc", "Jacobi's zeta function, of the complement.",
    "Z(u, 1 - mc)", "finite u; mc >= 0", "DLMF 22.16.32", "1, 1e-10 -> 0.684070087538")
heuman_lambda = _ufunc("heuman_lambda", "heuman_lambda", "phi m", "Heuman's lambda function.",
    "Lambda_0(phi, m) = F(phi, 1 - m)/K(1 - m) + (2/pi) K(m) Z(F(phi, 1 - m), 1 - m)", "finite phi; 0 <= m <= 1",
    "Abramowitz and Stegun 17.4.39", "1, 0.5 -> 0.747400635103")
heuman_lambdac = _ufunc("heuman_lambdac", "heuman_lambdac", "phi mc", "Heuman's lambda function, of the complement.",
    "Lambda_0(phi, 1 - mc)", "finite phi; 0 <= mc <= 1", "Abramowitz and Stegun 17.4.39", "1, 0.5 -> 0.747400635103")

# --- Carlson's and Bulirsch's integrals ---
elliprc = _ufunc("elliprc", "carlson_rc", "x y", "Carlson's degenerate integral R_C.",
    "R_C(x, y) = R_F(x, y, y); for y < 0 Cauchy's principal value", "x >= 0; y not 0", "DLMF 19.2.17",
    "1, -2 -> 0.38017299815", (4, 0))
elliprf = _ufunc("elliprf", "carlson_rf", "x y z", "Carlson's symmetric integral of the first kind.",
    "R_F(x, y, z) = 1/2 of the integral of 1/sqrt((t + x)(t + y)(t + z)) over t from 0 to infinity",
    "all >= 0, at most one of them 0: infinite where two are", "DLMF 19.16.1", "0, 1, 2 -> 1.31102877715", (4, 0))
elliprd = _ufunc("elliprd", "carlson_rd", "x y z", "Carlson's symmetric integral of the second kind.",
    "R_D(x, y, z) = R_J(x, y, z, z)", "x, y >= 0, not both 0; z > 0; infinite at the ends", "DLMF 19.16.5",
    "0, 2, 1 -> 1.7972103521", (5, 0))
elliprg = _ufunc("elliprg", "carlson_rg", "x y z", "Carlson's completely symmetric integral of the second kind.",
    "R_G(x, y, z) = 1/4 of the integral of t/sqrt((t + x)(t + y)(t + z)) (x/(t + x) + y/(t + y) + z/(t + z)) "
    "over t from 0 to infinity", "all >= 0", "DLMF 19.16.3, 19.23.7", "0, 1, 2 -> 0.955049447257", (4, 0))
elliprj = _ufunc("elliprj", "carlson_rj", "x y z p", "Carlson's symmetric integral of the third kind.",
    "R_J(x, y, z, p) = 3/2 of the integral of 1/((t + p) sqrt((t + x)(t + y)(t + z))) over t from 0 to infinity; "
    "for p < 0 Cauchy's principal value", "x, y, z >= 0, at most one of them 0; p not 0", "DLMF 19.16.2",
    "1, 2, 3, -1 -> -0.0932404524387", (6, 1))
cel = _ufunc("cel", "bulirsch_cel", "kc p a b", "Bulirsch's complete integral.",
    "integral of (a cos(t)**2 + b sin(t)**2)/((cos(t)**2 + p sin(t)**2) sqrt(cos(t)**2 + kc**2 sin(t)**2)) over "
    "t from 0 to pi/2; for p < 0 Cauchy's principal value",
    "finite arguments; infinite at kc = 0 or p = 0 unless b = 0",
    "DLMF 19.2.11; Bulirsch, Numer. Math. 13 (1969) 305", "0.5, 0.7, 1, 1 -> 2.65683963236")
el1 = _ufunc("el1", "bulirsch_el1", "t kc", "Bulirsch's incomplete integral of the first kind.",
    "F of the amplitude arctan(t) and the modulus sqrt(1 - kc**2)", "any t; finite kc", "DLMF 19.2(iii)",
    "1, 0.5 -> 0.851223749071")
el2 = _ufunc("el2", "bulirsch_el2", "t kc a b", "Bulirsch's incomplete integral of the second kind.",
    "a B + b D of the amplitude arctan(t) and the modulus sqrt(1 - kc**2)", "any t; finite kc, a and b",
    "DLMF 19.2(iii)", "1, 0.5, 1, 0.25 -> 0.728224155457")
el3 = _ufunc("el3", "bulirsch_el3", "t kc p", "Bulirsch's incomplete integral of the third kind.",
    "Pi of the characteristic 1 - p, the amplitude arctan(t) and the modulus sqrt(1 - kc**2); beyond a pole "
    "Cauchy's principal value", "any t; finite kc and p; infinite where p t**2 = -1", "DLMF 19.2(iii)",
    "1, 0.5, 0.7 -> 0.905742900211")

# --- Jacobi's functions, theta functions, cubics ---
ellipj = _ufunc("ellipj", "sncndn", "u m", "Jacobi's elliptic functions sn, cn, dn and the amplitude.",
    "sn(u, m) = sin(ph), cn(u, m) = cos(ph), dn(u, m) = sqrt(1 - m sin(ph)**2) with u = F(ph, m)",
    "finite u; 0 <= m <= 1 (SciPy's; `ellipjc` has values for any m)", "DLMF 22.2, 22.16.1",
    '>>> sn, cn, dn, ph = kyvadlo.ellipj(1.2, 0.5)\n>>> print(f"{sn:.12g} {cn:.12g} {dn:.12g} {ph:.12g}")\n'
    '0.887715488619 0.460392453528 0.778447561261 1.09235908512', results="sn, cn, dn, ph")
ellipjc = _ufunc("ellipjc", "sncndnc", "u mc", "Jacobi's elliptic functions and the amplitude, of the complement.",
    "those of `ellipj` for m = 1 - mc", "finite u and mc", "DLMF 22.2, 22.16.1, 22.17",
    '>>> sn, cn, dn, ph = kyvadlo.ellipjc(40, 1e-188)\n>>> print(f"{cn:.12g}")\n8.49670851058e-18',
    results="sn, cn, dn, ph")
theta = _ufunc("theta", "theta", "i v q", "Jacobi's theta functions.",
    "theta_1(v, q) = 2 sum over k >= 0 of (-1)**k q**((k + 1/2)**2) sin((2 k + 1) v), and so on",
    "i = 1, 2, 3, 4; any finite v, complex too; 0 <= q < 1", "DLMF 20.2.1 to 20.2.4", "1, 1, 0.1 -> 0.944799586679")
theta_derivative = _ufunc("theta_derivative", "theta_derivative", "i v q",
    "The derivative of Jacobi's theta functions along v.", "d theta_i(v, q)/dv", "as `theta`",
    "DLMF 20.2.1 to 20.2.4", "1, 1, 0.1 -> 0.641073046062")
cubic_roots = _ufunc("cubic_roots", "cubic_roots", "a b c d", "Distinct real roots of a cubic.",
    "a x**3 + b x**2 + c x + d = 0; whether roots coincide is decided exactly",
    "finite coefficients, not all 0: count is -1 elsewhere",
    "the exact sign of the discriminant, then Newton's method",
    ">>> [float(root) for root in kyvadlo.cubic_roots(1, 0, -7, 6)[:3]]\n[-3.0, 1.0, 2.0]", (4, 1),
    results="x1, x2, x3, count")
