#!/usr/bin/env python3
"""Elementary functions at a few hundred arguments, each to 60 digits and then rounded to a double:
portable.json. Python's decimal and integers only. python3 tests/golden/make_portable.py"""

import json
import pathlib
import random
from decimal import Decimal, getcontext

getcontext().prec = 60


def arctan_of_one_over(n):
    term = total = Decimal(1) / n
    k = 1
    while abs(term) > Decimal(10) ** -70:
        term = -term / (n * n)
        k += 2
        total += term / k
    return total


getcontext().prec = 90
PI = 4 * (4 * arctan_of_one_over(5) - arctan_of_one_over(239))


def sin(x):
    x = x % (2 * PI)
    term = total = x
    n = 1
    while abs(term) > Decimal(10) ** -75:
        term = -term * x * x / ((n + 1) * (n + 2))
        n += 2
        total += term
    return total


def cos(x):
    return sin(x + PI / 2)


def atan(x):
    if abs(x) > 1:
        return (PI / 2).copy_sign(x) - atan(1 / x)
    halvings = 0
    while abs(x) > Decimal("0.05"):
        x = x / (1 + (1 + x * x).sqrt())
        halvings += 1
    term = total = x
    k = 1
    while abs(term) > Decimal(10) ** -75:
        term = -term * x * x
        k += 2
        total += term / k
    return total * 2**halvings


def erfc(x):
    """1 - 2/sqrt(pi) sum (-1)^n x^(2n+1) / (n! (2n+1)), for |x| < 6."""
    term = total = x
    n = 0
    while abs(term) > Decimal(10) ** -80 or n < x * x:
        n += 1
        term = -term * x * x / n
        total += term / (2 * n + 1)
    return 1 - 2 / PI.sqrt() * total


def main():
    rng = random.Random(2023)
    even = lambda low, high: rng.uniform(low, high)
    ratio = lambda low, high: 10 ** rng.uniform(low, high)
    ln2, ln10 = Decimal(2).ln(), Decimal(10).ln()
    functions = {
        "sin": (sin, [even(-4, 4) for _ in range(60)] + [even(0, 2e6) for _ in range(60)]
                + [3.141592653589793, 1e-9, 3141592.653589793, 1e12]),
        "cos": (cos, [even(-4, 4) for _ in range(60)] + [1.5707963267948966, 1e7]),
        "tan": (lambda x: sin(x) / cos(x), [even(-1.5, 1.5) for _ in range(60)]),
        "atan": (atan, [ratio(-4, 4) for _ in range(60)] + [-1.0, 0.5]),
        "exp": (lambda x: x.exp(), [even(-700, 700) for _ in range(40)]
                + [even(-1, 1) for _ in range(40)] + [-740.0]),
        "log": (lambda x: x.ln(), [ratio(-300, 300) for _ in range(40)]
                + [even(0.9, 1.1) for _ in range(40)] + [5e-324, 1.0000000000000002]),
        "log2": (lambda x: x.ln() / ln2, [ratio(-10, 10) for _ in range(60)]),
        "log10": (lambda x: x.ln() / ln10, [ratio(-10, 10) for _ in range(60)]),
        "pow10": (lambda x: (x * ln10).exp(), [even(-10, 10) for _ in range(60)] + [-310.0]),
        "erfc": (erfc, [even(-3, 5.5) for _ in range(40)]),
    }
    table = {
        name: [[x.hex(), float(function(Decimal(x))).hex()] for x in arguments]
        for name, (function, arguments) in functions.items()
    }
    path = pathlib.Path(__file__).parent / "portable.json"
    path.write_text(json.dumps(table).replace("]], ", "]],\n") + "\n")


main()
