# Copyright 2026 The rigor authors
# SPDX-License-Identifier: Apache-2.0
"""Volume, center and inertia (density 1, about the center) of binary STL files, in exact fractions.

    python3 exact.py FILE.stl...
"""

import struct
import sys
from fractions import Fraction


def facets(path):
    data = open(path, "rb").read()
    (count,) = struct.unpack_from("<I", data, 80)
    for i in range(count):
        values = [Fraction(x) for x in struct.unpack_from("<9f", data, 84 + 50 * i + 12)]
        yield values[0:3], values[3:6], values[6:9]


def moments(path):
    volume = Fraction(0)
    first = [Fraction(0)] * 3
    second = [[Fraction(0)] * 3 for _ in range(3)]
    for a, b, c in facets(path):
        det = (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
               + a[2] * (b[0] * c[1] - b[1] * c[0]))
        s = [a[k] + b[k] + c[k] for k in range(3)]
        volume += det
        for k in range(3):
            first[k] += det * s[k]
            for m in range(k, 3):
                second[k][m] += det * (a[k] * a[m] + b[k] * b[m] + c[k] * c[m] + s[k] * s[m])
    volume /= 6
    com = [f / 24 / volume for f in first]
    spread = lambda k, m: second[k][m] / 120 - volume * com[k] * com[m]
    xx, yy, zz = spread(0, 0), spread(1, 1), spread(2, 2)
    return volume, com, [yy + zz, -spread(0, 1), -spread(0, 2), xx + zz, -spread(1, 2), xx + yy]


for path in sys.argv[1:]:
    volume, com, inertia = moments(path)
    numbers = lambda values: " ".join("%.12g" % float(v) for v in values)
    print(path, "%.12g" % float(volume), numbers(com), numbers(inertia), sep="\t")
