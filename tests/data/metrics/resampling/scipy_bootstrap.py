# Bootstrap intervals of scipy for bootstrap_test.cpp; written with scipy 1.10.1, numpy 1.24.2:
#   python3 tests/data/metrics/resampling/scipy_bootstrap.py
# Data: spatial test A of Efron & Tibshirani 1993, table 14.1. Half a million replicates: the limits scatter by less
# than 0.5 between seeds.
import numpy as np
from scipy.stats import bootstrap

a = np.array([48, 36, 20, 29, 42, 42, 20, 42, 22, 41, 45, 14, 6, 0, 33, 28, 34, 4, 32, 24, 47, 41, 24, 26, 30, 41.0])
for method in ["percentile", "BCa"]:
    result = bootstrap((a,), np.var, confidence_level=0.9, n_resamples=500_000, method=method, batch=10_000,
                       random_state=np.random.default_rng(1))
    print(method, result.confidence_interval, result.standard_error)

u = a - np.mean(a)
jackknife = np.array([np.var(np.delete(a, i)) for i in range(a.size)])
d = np.mean(jackknife) - jackknife
print("estimate", np.var(a), "acceleration", np.sum(d**3) / (6 * np.sum(d**2) ** 1.5))
