#!/usr/bin/env python3
"""Prints the coefficients of q = epsilon (1 + 2 epsilon**4 + 15 epsilon**8 + ...), exact integers: the inverse of
2 epsilon = theta_2(q**4)/theta_3(q**4), that is epsilon = (q + q**9 + q**25 + ...)/(1 + 2 q**4 + 2 q**16 + ...), by Lagrange's formula
in x = q**4: with epsilon = q f(x), coefficient i is [x**i] f**-(4 i + 1) / (4 i + 1)."""
TERMS = 21


def multiply(a, b):
    return [sum(a[j]*b[i - j] for j in range(i + 1)) for i in range(TERMS)]


def inverse(a):
    b = [1]
    for i in range(1, TERMS):
        b.append(-sum(a[j]*b[i - j] for j in range(1, i + 1)))
    return b


top, bottom = [0]*TERMS, [0]*TERMS
for n in range(TERMS):
    if n*(n + 1) < TERMS:
        top[n*(n + 1)] = 1
    if n*n < TERMS:
        bottom[n*n] = 2 if n else 1
ratio = multiply(bottom, inverse(top))
power, coefficients = ratio, []
for i in range(TERMS):
    assert power[i] % (4*i + 1) == 0
    coefficients.append(power[i]//(4*i + 1))
    for _ in range(4):
        power = multiply(power, ratio)
print(', &\n'.join(f'      {c}.0_wp' for c in coefficients))
