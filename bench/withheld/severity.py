"""How visible a withheld cause is above the noise of the set-ups.

  s = (mean gap without the cause - mean gap with it) / half-width of the gap's 95 % interval over set-ups,

both on the held-out samples, against measurements of the true world drawn anew REPLICATES times with new seeds and new
set-up scatter. The half-width is that of a mean over the held-out set-ups: 1.96 sqrt(v / n), v the variance of a sample's
gap over the draws, averaged over the samples. A world without set-up scatter has only counting noise left: there even weak
causes are severe.
"""

import math

import distance

BINS = {0.5: (0.35, 0.7), 1: (0.7, 1.4), 2: (1.4, 2.8), 4: (2.8, math.inf)}
REPLICATES = 4


def bin_of(severity):
    """0.5, 1, 2 or 4; None where nobody could see it."""
    return next((name for name, (low, high) in BINS.items() if low <= severity < high), None)


def gaps(experiment, real, simulated):
    return [distance.sample_gap(experiment["measurands"], real[s["id"]], simulated[s["id"]], s["frames"])[0]
            for s in experiment["samples"]]


def measure(experiment, draws, complete, lacking):
    """`draws`: lists of tables measured in the true world; `complete`, `lacking`: simulated with and without the cause."""
    with_cause = [gaps(experiment, draw, complete) for draw in draws]
    without = [gaps(experiment, draw, lacking) for draw in draws]
    mean = lambda rows: sum(map(sum, rows)) / sum(map(len, rows))
    variance = 0.0
    for column in zip(*with_cause):
        centre = sum(column) / len(column)
        variance += sum((x - centre) ** 2 for x in column) / (len(column) - 1) / len(with_cause[0])
    setups = len({s.get("setup", s["id"]) for s in experiment["samples"]})
    half = 1.96 * math.sqrt(variance / setups)
    before, after = mean(without), mean(with_cause)
    return {"value": (before - after) / max(half, 1e-9), "half_width": half, "gap_without": before, "gap_with": after}
