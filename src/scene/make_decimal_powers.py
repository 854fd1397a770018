#!/usr/bin/env python3
"""Writes decimal_powers.inc: powers of ten by their first 126 bits, rounded up, as decimal.f90 multiplies with them."""

FIRST, LAST = -324, 292


def power(k):
    """The two halves of 63 bits of floor(10**-k 2**-r) + 1, r = floor(log2(10**-k)) - 125."""
    r = ((-k * 913124641741) >> 38) - 125
    numerator, denominator = (10**-k, 1) if k <= 0 else (1, 10**k)
    number = (numerator << -r if r < 0 else numerator) // (denominator << r if r > 0 else denominator) + 1
    assert number.bit_length() == 126
    return number >> 63, number & (2**63 - 1)


with open("decimal_powers.inc", "w") as out:
    out.write("   ! Written by make_decimal_powers.py.\n")
    for half, name in enumerate(("power_high", "power_low")):
        out.write(f"   integer(int64), parameter :: {name}({FIRST}:{LAST}) = [integer(int64) :: &\n")
        numbers = [f"{power(k)[half]}_int64" for k in range(FIRST, LAST + 1)]
        lines = [", ".join(numbers[i:i + 4]) for i in range(0, len(numbers), 4)]
        out.write(", &\n".join("      " + line for line in lines) + "]\n")
