#!/usr/bin/env python3
"""Values of point metrics from scipy, for tests/metrics/points. Run: python3 point_oracles.py > point_oracles.csv

Each case is two clouds of points on a grid of 1/8 m, so that the CSV holds them exactly:
  cloud,CASE,SIDE,x,y,z     one line a point; side s (simulated) or m (measured)
  value,CASE,NAME,NUMBER    what scipy says
Wasserstein distances of unequal sizes repeat the points up to the least common multiple of the sizes.
"""
import math

import numpy as np
from scipy.optimize import linear_sum_assignment
from scipy.spatial.distance import cdist, directed_hausdorff

random = np.random.default_rng(20220912)
for case, (n, m) in enumerate([(1, 1), (5, 5), (40, 40), (3, 7), (12, 18), (30, 1), (25, 16)]):
    s = np.round(random.normal(0.0, 3.0, (n, 3)) * 8) / 8
    r = np.round((random.normal(0.0, 3.0, (m, 3)) + [1.0, 0.5, 0.0]) * 8) / 8
    for side, cloud in (("s", s), ("m", r)):
        for x, y, z in cloud:
            print(f"cloud,{case},{side},{x},{y},{z}")
    d = cdist(s, r)
    units = math.lcm(n, m)
    repeated = np.repeat(np.repeat(d, units // n, axis=0), units // m, axis=1)
    values = {
        "hausdorff_of_simulated": directed_hausdorff(s, r)[0],
        "hausdorff_of_measured": directed_hausdorff(r, s)[0],
        "sum_of_simulated": d.min(axis=1).sum(),
        "sum_of_measured": d.min(axis=0).sum(),
    }
    for p in (1, 2):
        rows, columns = linear_sum_assignment(repeated**p)
        values[f"wasserstein_{p}"] = (repeated[rows, columns] ** p).mean() ** (1 / p)
    for name, value in values.items():
        print(f"value,{case},{name},{value!r}")
