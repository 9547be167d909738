"""Regressions with bounds by statsmodels (linear families) and scipy (exponential, sigmoid).

  apt-get install python3-numpy python3-scipy python3-statsmodels
  /usr/bin/python3 make_regressions.py > regressions.json

Made with numpy 1.24.2, scipy 1.10.1, statsmodels 0.13.5. The data are rounded, so that the file holds what was fitted.
"""
import itertools
import json

import numpy as np
import statsmodels.api as sm
from scipy import optimize, stats

LEVEL = 0.9
random = np.random.default_rng(20230314)


def polynomial(x, squares):
    columns = [np.ones(len(x))] + list(x.T)
    if squares:
        columns += [x[:, i] * x[:, j] for i, j in itertools.combinations_with_replacement(range(x.shape[1]), 2)]
    return np.column_stack(columns)


def linear_case(name, family, x, y, queries, weights=None):
    squares = family == "quadratic"
    weights = np.ones(len(y)) if weights is None else weights / np.mean(weights)
    fit = sm.WLS(y, polynomial(x, squares), weights=weights).fit()
    frame = fit.get_prediction(polynomial(queries, squares)).summary_frame(alpha=1.0 - LEVEL)
    at = [dict(x=list(q), value=row["mean"], confidence=[row["mean_ci_lower"], row["mean_ci_upper"]],
               observation=[row["obs_ci_lower"], row["obs_ci_upper"]])
          for q, (_, row) in zip(queries, frame.iterrows())]
    return dict(name=name, family=family, level=LEVEL, points=x.tolist(), errors=y.tolist(), weights=weights.tolist(),
                coefficients=fit.params.tolist(), standard_errors=fit.bse.tolist(), residual_sd=float(np.sqrt(fit.scale)),
                dof=int(fit.df_resid), at=at)


def exponential(x, a, b, *c):
    return a + b * np.exp(x @ np.array(c))


def sigmoid(x, a, b, s, *c):
    return a + b / (1.0 + np.exp(-(s + x @ np.array(c))))


def gradient_of(function, parameters, x):
    """Central differences of the fourth order, good to some 1e-10."""
    gradient = np.zeros((len(x), len(parameters)))
    for k in range(len(parameters)):
        shift = np.eye(len(parameters))[k] * 1e-3 * max(1e-3, abs(parameters[k]))
        gradient[:, k] = (8 * (function(x, *(parameters + shift)) - function(x, *(parameters - shift)))
                          - (function(x, *(parameters + 2 * shift)) - function(x, *(parameters - 2 * shift)))
                          ) / (12 * shift[k])
    return gradient


def curve_case(name, family, function, x, y, truth, queries):
    fitted, _ = optimize.curve_fit(function, x, y, p0=truth, xtol=1e-15, ftol=1e-15, gtol=1e-15, maxfev=100000)
    dof = len(y) - len(fitted)
    sd = np.sqrt(np.sum((y - function(x, *fitted)) ** 2) / dof)
    jacobian = gradient_of(function, fitted, x)
    covariance = sd**2 * np.linalg.inv(jacobian.T @ jacobian)
    t = stats.t.ppf(0.5 + 0.5 * LEVEL, dof)
    at = []
    for q in queries:
        gradient = gradient_of(function, fitted, q[None, :])[0]
        variance = gradient @ covariance @ gradient
        mean = function(q[None, :], *fitted)[0]
        half, half_one = t * np.sqrt(variance), t * np.sqrt(variance + sd**2)
        at.append(dict(x=list(q), value=mean, confidence=[mean - half, mean + half],
                       observation=[mean - half_one, mean + half_one]))
    return dict(name=name, family=family, level=LEVEL, points=x.tolist(), errors=y.tolist(),
                weights=[1.0] * len(y), coefficients=list(fitted), standard_errors=list(np.sqrt(np.diag(covariance))),
                residual_sd=float(sd), dof=dof, at=at)


def noisy(values, sd):
    return np.round(values + sd * random.standard_normal(len(values)), 5)


cases = []
range_m = np.round(np.linspace(5.0, 120.0, 14), 2)[:, None]
queries = np.array([[3.0], [5.0], [47.3], [120.0], [200.0]])
cases.append(linear_case("line", "linear", range_m, noisy(0.02 + 0.001 * range_m[:, 0], 0.01), queries))
cases.append(linear_case("weighted line", "linear", range_m, noisy(0.02 + 0.001 * range_m[:, 0], 0.01), queries,
                         np.round(random.uniform(0.2, 5.0, 14), 2)))
cases.append(linear_case("parabola", "quadratic", range_m, noisy(0.02 + 1e-5 * (range_m[:, 0] - 60.0) ** 2, 0.01), queries))
cases.append(linear_case("three points", "linear", np.array([[1.0], [2.0], [4.0]]), np.array([0.3, 0.1, 0.2]),
                         np.array([[2.5]])))
plane = np.round(random.uniform([5.0, 0.0], [120.0, 70.0], (20, 2)), 2)
queries_2d = np.array([[50.0, 30.0], [5.0, 70.0], [130.0, 80.0]])
bias = 0.02 + 0.001 * plane[:, 0] - 0.002 * plane[:, 1]
cases.append(linear_case("plane", "linear", plane, noisy(bias, 0.01), queries_2d))
cases.append(linear_case("surface", "quadratic", plane, noisy(bias + 2e-5 * plane[:, 0] * plane[:, 1], 0.01), queries_2d))
cases.append(curve_case("decay", "exponential", exponential, range_m, noisy(exponential(range_m, 0.01, 0.3, -0.03), 0.004),
                        (0.01, 0.3, -0.03), queries))
cases.append(curve_case("growth in two", "exponential", exponential, plane,
                        noisy(exponential(plane, -0.1, 0.02, 0.02, 0.03), 0.01), (-0.1, 0.02, 0.02, 0.03), queries_2d))
cases.append(curve_case("step", "sigmoid", sigmoid, range_m, noisy(sigmoid(range_m, -0.1, 0.5, -5.0, 0.09), 0.01),
                        (-0.1, 0.5, -5.0, 0.09), queries))
print("[" + ",\n".join(json.dumps(case) for case in cases) + "]")
