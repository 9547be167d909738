# Floors of distances by their definition, independent samples of N(0, 1), for permutation_floor_test.cpp and
# box_width_floor_test.cpp; written with numpy 1.24.2:
#   python3 tests/data/metrics/resampling/floors.py
import numpy as np

rng = np.random.default_rng(1)
for n, pairs in [(30, 40000), (100, 20000), (1000, 4000)]:
    d = np.sort(rng.normal(size=(pairs, n)), axis=1) - np.sort(rng.normal(size=(pairs, n)), axis=1)
    area = np.abs(d).mean(axis=1)
    scatter = np.abs(d - d.mean(axis=1)[:, None]).mean(axis=1)
    for name, x in [("d_avm", area), ("d_cavm", scatter)]:
        print(n, name, "mean", x.mean(), "2.5, 50, 97.5 %", np.quantile(x, [0.025, 0.5, 0.975]))
for runs, n in [(17, 100), (17, 1000), (3, 100), (3, 1000)]:
    widths = [np.ptp(np.sort(rng.normal(size=(runs, n)), axis=1), axis=0).mean() for _ in range(400)]
    print(runs, "runs of", n, "mean width", np.mean(widths), "+-", np.std(widths) / 20)
