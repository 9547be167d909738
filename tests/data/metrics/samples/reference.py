#!/usr/bin/env python3
"""Reference values of scipy for tests/metrics/samples, written to reference.json beside this file.

  /usr/bin/python3 tests/data/metrics/samples/reference.py      (numpy 1.24.2, scipy 1.10.1, Debian 12)
"""
import json
import pathlib
import re
import warnings

import numpy as np
import scipy
from scipy import integrate, special, stats
from scipy.spatial import distance

warnings.simplefilter("ignore")  # scipy warns where its p-values are cut off at 0.1 % and 25 %
rng = np.random.default_rng(1987)


def sample(mean, deviation, n, decimals):
    return [float(x) for x in np.round(rng.normal(mean, deviation, n), decimals)]


def bandwidth(x):
    return 1.06 * stats.median_abs_deviation(x, scale="normal") * len(x) ** -0.2


def kde(x, y):
    """Divergences of the densities on 100 places that reach 3 bandwidths beyond either sample; y is measured."""
    places = np.linspace(min(np.min(s) - 3 * bandwidth(s) for s in (x, y)),
                         max(np.max(s) + 3 * bandwidth(s) for s in (x, y)), 100)
    q, p = (stats.gaussian_kde(s, bandwidth(s) / np.std(s, ddof=1))(places) for s in (x, y))
    return {
        "kde_kl_bit": float(stats.entropy(p, q, base=2)), "kde_kl_reverse_bit": float(stats.entropy(q, p, base=2)),
        "kde_js_distance_bit": float(distance.jensenshannon(p, q, 2.0)),
    }


def two_samples(name, x, y):
    exact = stats.ks_2samp(x, y, method="exact")
    ad = stats.anderson_ksamp([x, y])
    return {
        "name": name, "simulated": x, "measured": y,
        "ks": exact.statistic, "ks_exact_p": exact.pvalue,
        "ad_standardised": ad.statistic, "ad_p": ad.significance_level, **kde(x, y),
    }


def ad_tail_by_series(z):
    """1 - P(A^2 <= z) by the series of Anderson & Darling 1954; the library uses another formula."""
    total = 0.0
    for j in range(12):
        a = (4 * j + 1) ** 2 * np.pi ** 2 / (8 * z)
        inner, _ = integrate.quad(lambda w: np.exp(z / (8 * (w * w + 1)) - a * w * w), 0, np.inf, epsabs=1e-14)
        total += special.binom(-0.5, j) * (4 * j + 1) * np.exp(-a) * inner
    return 1 - np.sqrt(2 * np.pi) / z * total


def ad_to_normal(x, mean, deviation):
    """Textbook sum over the ordered sample, with scipy's logarithms of both tails."""
    z = (np.sort(x) - mean) / deviation
    n = len(z)
    i = np.arange(1, n + 1)
    return float(-n - np.mean((2 * i - 1) * (stats.norm.logcdf(z) + stats.norm.logsf(z[::-1]))))


def discrete(p, q):
    p, q = np.array(p), np.array(q)
    return {
        "measured": p.tolist(), "simulated": q.tolist(),
        "kl_nat": float(stats.entropy(p, q)), "kl_bit": float(stats.entropy(p, q, base=2)),
        "kl_reverse_bit": float(stats.entropy(q, p, base=2)),
        "js_distance_bit": float(distance.jensenshannon(p, q, 2.0)),
        "js_distance_nat": float(distance.jensenshannon(p, q)),
    }


far = sample(27, 0.6, 40, 3)  # 22 to 30 deviations away
measured = sample(22, 0.2, 50, 3)
reference = {
    "numpy": np.__version__, "scipy": scipy.__version__,
    "two_samples": [
        two_samples("equal normals", sample(22, 0.2, 60, 6), sample(22, 0.2, 45, 6)),
        two_samples("shifted", sample(22.1, 0.2, 60, 6), sample(22, 0.2, 45, 6)),
        two_samples("wider", sample(22, 0.3, 80, 6), sample(22, 0.2, 70, 6)),
        two_samples("far apart", sample(22.5, 0.2, 100, 6), sample(22, 0.2, 100, 6)),
        two_samples("small", sample(0, 1, 7, 6), sample(0.5, 1, 5, 6)),
        two_samples("counters of 0.1", sample(22.1, 0.3, 60, 1), sample(22, 0.3, 40, 1)),
        two_samples("coprime sizes", sample(0, 1, 101, 6), sample(0.3, 1, 97, 6)),
    ],
    "ad_tail": [[z, ad_tail_by_series(z)] for z in (0.2, 0.5, 1.0, 1.933, 2.492, 3.857, 6.0)],
    "ad_to_normal": {
        "simulated": far, "measured": measured,
        "statistic": ad_to_normal(far, np.mean(measured), np.std(measured, ddof=1)),
        "near": ad_to_normal(measured, 22.0, 0.2),
    },
    "discrete": [
        discrete([0.5, 0.5], [0.9, 0.1]), discrete([0.1, 0.2, 0.3, 0.4], [0.25, 0.25, 0.25, 0.25]),
        discrete([0.7, 0.2, 0.1, 0.0], [0.1, 0.2, 0.3, 0.4]),
    ],
}
path = pathlib.Path(__file__).with_suffix(".json")
text = json.dumps(reference, indent=1).replace("Infinity", "null")
text = re.sub(r"\[([^\[\]{}]*)\]", lambda row: "[" + " ".join(row[1].split()) + "]", text)  # numbers on one line
path.write_text(text + "\n")
