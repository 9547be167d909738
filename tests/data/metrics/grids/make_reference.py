"""Values of numpy and scipy for pairs of occupancy grids and range images.
Run once: python3 make_reference.py > reference.json

Made with numpy 1.24.2, scipy 1.10.1 (Debian 12). Grids are stored beside their values, so that only those who doubt
the values need to run it again. JSON has no NaN: a pixel without an echo is null.
"""
import json

import numpy as np
from scipy import ndimage, spatial, stats


def directed(a, b):
    """Mean taxicab distance of the set cells of a to the nearest one of b."""
    return ndimage.distance_transform_cdt(~b, metric="taxicab")[a].mean()


def colour_distance(a, b):
    return directed(a, b) + directed(b, a)


def grids(p, q, clip):
    """p simulated, q measured"""
    pc, qc = np.clip(p, clip, 1 - clip), np.clip(q, clip, 1 - clip)
    score = np.sum(1 + np.log2(pc * qc + (1 - pc) * (1 - qc)))
    opd, upd = colour_distance(p > 0.5, q > 0.5), colour_distance(p < 0.5, q < 0.5)
    return {
        "rows": p.shape[0],
        "columns": p.shape[1],
        "clip": clip,
        "simulated": p.ravel().tolist(),
        "measured": q.ravel().tolist(),
        "overall_error": np.abs(p - q).sum(),
        "mean_error": np.abs(p - q).mean(),
        "map_score": score,
        "map_score_per_cell": score / p.size,
        "occupied_cells_ratio": np.sum(p > 0.5) / np.sum(q > 0.5),
        "free_cells_ratio": np.sum(p < 0.5) / np.sum(q < 0.5),
        "opd": opd,
        "upd": upd,
        "picture_distance": opd + upd,
        "baron_correlation": (np.mean(p * q) - np.mean(p) * np.mean(q)) / (np.std(p) * np.std(q)),
        "pearson": stats.pearsonr(p.ravel(), q.ravel())[0],
        "jaccard": spatial.distance.jaccard((p > 0.5).ravel(), (q > 0.5).ravel()),
    }


def images(y, x):
    """y simulated, x measured"""
    seen_y, seen_x = ~np.isnan(y), ~np.isnan(x)
    both = seen_y & seen_x
    d = y[both] - x[both]

    def plain(image):
        return [None if np.isnan(r) else r for r in image.ravel().tolist()]

    return {
        "rows": x.shape[0],
        "columns": x.shape[1],
        "simulated": plain(y),
        "measured": plain(x),
        "mean_error": np.abs(d).mean(),
        "mean_signed_error": d.mean(),
        "chebyshev": np.abs(d).max(),
        "rmse": np.sqrt((d**2).mean()),
        "picture_distance": colour_distance(seen_y, seen_x),
        "pearson": stats.pearsonr(y[both], x[both])[0],
        "measured_only_pixels": np.mean(seen_x & ~seen_y),
        "simulated_only_pixels": np.mean(seen_y & ~seen_x),
    }


rng = np.random.default_rng(13)
noise = rng.uniform(size=(2, 7, 11))
world = np.full((12, 15), 0.5)
world[2:9, 1:13] = 0.02  # seen and free
world[2, 3:11] = 1.0  # a wall
world[8, 12] = 0.97  # a post
ranges = 20.0 + 5.0 * rng.normal(size=(2, 6, 9))
ranges[:, rng.uniform(size=(6, 9)) < 0.3] = np.nan
ranges[0, rng.uniform(size=(6, 9)) < 0.2] = np.nan
ranges[1, rng.uniform(size=(6, 9)) < 0.1] = np.nan
print(json.dumps({
    "grids": {
        "noise": grids(noise[0], noise[1], 1e-3),
        "certain_noise": grids(np.round(noise[0]), np.round(noise[1]), 1e-2),
        "world_seen_one_row_and_two_columns_off": grids(np.roll(world, (1, 2), (0, 1)), world, 1e-3),
        "one_row": grids(np.array([[0.1, 0.9, 0.4, 0.5]]), np.array([[0.2, 0.3, 0.8, 0.5]]), 1e-3),
    },
    "range_images": {"noise_with_holes": images(ranges[0], ranges[1])},
}, indent=1))
