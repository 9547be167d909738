#!/usr/bin/env python3
"""OSPA, GOSPA, OSPA-T, OSPA(2) and the track metric of random tracks from scipy, for tests/metrics/objects.
Run: python3 set_oracles.py > set_oracles.csv

  track,CASE,SIDE,ROW,STEP,x,y,z       a position; side s (simulated) or m (measured); rows and steps from 0
  value,CASE,P,C,LABEL,SWITCH,NAME,NUMBER

Positions lie on a grid of 1/8 m. OSPA and GOSPA are those of step 0. The linear program is the one of the paper
(doi:10.1109/TSP.2020.3005309), with a column and a row for `none`, nothing left out; solver: HiGHS in scipy.
"""
import numpy as np
from scipy.optimize import linear_sum_assignment, linprog

random = np.random.default_rng(29)


def track(steps, start):
    """Positions of a walk, NaN where the track does not exist; exists somewhere."""
    walk = start + np.cumsum(random.normal(0.0, 0.8, (steps, 3)), axis=0)
    walk = np.round(walk * 8) / 8
    walk[random.random(steps) < 0.3] = np.nan
    if np.isnan(walk).all():
        walk[0] = start
    return walk


def exists(track):
    return ~np.isnan(track[:, 0])


def ospa(distances, p, c):
    n, m = distances.shape
    if max(n, m) == 0:
        return 0.0
    cost = np.minimum(distances, c) ** p
    rows, columns = linear_sum_assignment(cost)
    return ((cost[rows, columns].sum() + c**p * abs(n - m)) / max(n, m)) ** (1 / p)


def gospa(distances, p, c):
    """One row or column of `none` for each object: the assignment chooses freely who stays alone."""
    n, m = distances.shape
    cost = np.zeros((n + m, n + m))
    cost[:n, :m] = distances**p
    cost[:n, m:] = c**p / 2
    cost[n:, :m] = c**p / 2
    rows, columns = linear_sum_assignment(cost)
    return cost[rows, columns].sum() ** (1 / p)


def at(step, tracks):
    return [i for i, one in enumerate(tracks) if exists(one)[step]]


def distances_at(step, real, simulated):
    rows, columns = at(step, real), at(step, simulated)
    d = [[np.linalg.norm(real[i][step] - simulated[j][step]) for j in columns] for i in rows]
    return np.array(d).reshape(len(rows), len(columns))


def over_time(a, b, c):
    """Sum over steps where a or b exists of the cut-off distance, and the number of those steps."""
    both, either = exists(a) & exists(b), exists(a) | exists(b)
    d = np.where(both, np.minimum(c, np.linalg.norm(np.nan_to_num(a) - np.nan_to_num(b), axis=1)), c)
    return d[either].sum(), either.sum()


def ospa_t(real, simulated, p, c, label):
    size = max(len(real), len(simulated))  # filled up with tracks that never exist
    nothing = np.full_like((real + simulated)[0], np.nan)
    cost = [
        [over_time(a, b, c)[0] for b in simulated + [nothing] * (size - len(simulated))]
        for a in real + [nothing] * (size - len(real))
    ]
    _, partner = linear_sum_assignment(np.array(cost))
    values = []
    for step in range(len(nothing)):
        d = distances_at(step, real, simulated)
        for r, i in enumerate(at(step, real)):
            for s, j in enumerate(at(step, simulated)):
                if partner[i] != j:
                    d[r, s] = (d[r, s] ** p + label**p) ** (1 / p)
        values.append(ospa(d, p, c))
    return float(np.mean(values))


def track_metric(real, simulated, p, c, switch):
    n, m, steps = len(real), len(simulated), len((real + simulated)[0])
    shares = (n + 1) * (m + 1) * steps
    w = np.arange(shares).reshape(steps, n + 1, m + 1)
    e = shares + np.arange(n * m * (steps - 1)).reshape(steps - 1, n, m)
    cost = np.zeros(shares + e.size)
    cost[shares:] = switch**p / 2
    equal, equal_to, below = [], [], []
    for k in range(steps):
        for i in range(n + 1):
            for j in range(m + 1):
                a = i < n and exists(real[i])[k]
                b = j < m and exists(simulated[j])[k]
                d = min(c, np.linalg.norm(real[i][k] - simulated[j][k])) ** p if a and b else (a + b) * c**p / 2
                cost[w[k, i, j]] = d
        for i in range(n):
            equal.append(w[k, i, :])
            equal_to.append(1.0)
        for j in range(m):
            equal.append(w[k, :, j])
            equal_to.append(1.0)
        equal.append(w[k, n : n + 1, m])
        equal_to.append(0.0)
    equalities = np.zeros((len(equal), len(cost)))
    for row, columns in zip(equalities, equal):
        row[columns] = 1.0
    for k in range(steps - 1):
        for i in range(n):
            for j in range(m):
                for sign in (1.0, -1.0):
                    row = np.zeros(len(cost))
                    row[[w[k, i, j], w[k + 1, i, j], e[k, i, j]]] = sign, -sign, -1.0
                    below.append(row)
    result = linprog(cost, np.array(below), np.zeros(len(below)), equalities, equal_to, method="highs")
    assert result.status == 0
    return max(0.0, result.fun) ** (1 / p)


for case in range(30):
    steps = int(random.integers(2, 7))
    starts = random.normal(0.0, 2.0, (3, 3))
    real = [track(steps, starts[k % 3]) for k in range(random.integers(1, 5))]
    simulated = [track(steps, starts[k % 3] + 0.5) for k in range(random.integers(1, 5))]
    for side, tracks in (("m", real), ("s", simulated)):
        for row, one in enumerate(tracks):
            for step in range(steps):
                if exists(one)[step]:
                    print(f"track,{case},{side},{row},{step}," + ",".join(repr(float(x)) for x in one[step]))
    for p, c, label, switch in ((1.0, 3.0, 1.5, 0.5), (2.0, 5.0, 2.5, 1.0), (1.0, 10.0, 0.0, 4.0)):
        between = np.array([[np.divide(*over_time(a, b, c)) for b in simulated] for a in real])
        values = {
            "ospa": ospa(distances_at(0, real, simulated), p, c),
            "gospa": gospa(distances_at(0, real, simulated), p, c),
            "ospa_t": ospa_t(real, simulated, p, c, label),
            "ospa_2": ospa(between, p, c),
            "track_metric": track_metric(real, simulated, p, c, switch),
        }
        for name, value in values.items():
            print(f"value,{case},{p},{c},{label},{switch},{name},{float(value)!r}")
