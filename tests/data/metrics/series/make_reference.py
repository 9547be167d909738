"""Values of numpy and scipy for pairs of series. Run once: python3 make_reference.py > reference.json

Made with numpy 1.24.2, scipy 1.10.1 (Debian 12). Series are stored beside their values, so that only those who
doubt the values need to run it again.
"""
import json

import numpy as np
from scipy import signal, spatial, stats


def reference(simulated, measured, largest_lag):
    x, y = np.array(measured), np.array(simulated)
    n = len(x)
    xc, yc = x - x.mean(), y - y.mean()

    def correlogram(a, b):  # element n - 1 + k pairs a[i + k] with b[i]
        return signal.correlate(a, b, method="direct") / np.sqrt((a @ a) * (b @ b))

    cross = correlogram(yc, xc)[n - 1 - largest_lag : n + largest_lag]
    auto_x = correlogram(xc, xc)[n : n + largest_lag]
    auto_y = correlogram(yc, yc)[n : n + largest_lag]
    return {
        "simulated": list(map(float, y)),
        "measured": list(map(float, x)),
        "largest_lag": largest_lag,
        "manhattan": spatial.distance.cityblock(y, x),
        "euclidean": spatial.distance.euclidean(y, x),
        "rss": spatial.distance.sqeuclidean(y, x),
        "chebyshev": spatial.distance.chebyshev(y, x),
        "mean_error": np.mean(np.abs(y - x)),
        "mean_signed_error": np.mean(y - x),
        "mean_square_error": np.mean((y - x) ** 2),
        "rmse": np.sqrt(np.mean((y - x) ** 2)),
        "pearson": stats.pearsonr(y, x)[0],
        "r_squared": 1.0 - np.sum((y - x) ** 2) / (n * np.var(x)),
        "cross_correlation": {"maximum": np.max(cross), "lag": int(np.argmax(cross)) - largest_lag},
        "autocorrelation_difference": np.mean(np.abs(auto_x - auto_y)),
    }


rng = np.random.default_rng(20)
t = np.arange(60)
wave = np.sin(2 * np.pi * t / 25)
noise = rng.normal(size=(4, 60))
cases = {
    "noise_against_noise": (noise[0], noise[1], 15),
    "late_wave": (np.roll(wave, 4) + 0.1 * noise[2], wave + 0.1 * noise[3], 15),
    "early_wave_with_offset": (3.0 + 1.2 * np.roll(wave, -6), wave, 20),
    "counter_steps": (np.round(8 * noise[0]) / 4, np.round(8 * noise[0] + noise[1]) / 4, 30),
    "far_from_zero": (1e6 + noise[2], 1e6 + 0.5 * noise[2] + noise[3], 59),
    "two_values": (np.array([1.0, 4.0]), np.array([2.0, 3.0]), 1),
}
print(json.dumps({name: reference(*case) for name, case in cases.items()}, indent=1))
