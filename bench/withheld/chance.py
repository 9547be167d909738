"""Statistics of rates and of confidences.

Sources: Wilson 1927, J. Am. Stat. Assoc. 22, 209 (interval of a proportion);
Naeini, Cooper, Hauskrecht 2015, AAAI (expected calibration error).
"""

import math


def wilson(successes, trials, z=1.959963984540054):
    """Interval of a proportion at the confidence that belongs to z; (0, 1) without trials."""
    if trials == 0:
        return 0.0, 1.0
    p = successes / trials
    centre = (p + z * z / (2 * trials)) / (1 + z * z / trials)
    half = z / (1 + z * z / trials) * math.sqrt(p * (1 - p) / trials + z * z / (4 * trials * trials))
    return max(0.0, centre - half), min(1.0, centre + half)


def bin_of(confidence, bins):
    return min(bins - 1, max(0, int(confidence * bins)))


def reliability(confidences, correct, bins=10):
    """Per bin of confidence: (mean confidence, share correct, count); empty bins are left out."""
    table = [[0.0, 0, 0] for _ in range(bins)]
    for confidence, right in zip(confidences, correct):
        row = table[bin_of(confidence, bins)]
        row[0] += confidence
        row[1] += bool(right)
        row[2] += 1
    return [(total / n, right / n, n) for total, right, n in table if n]


def expected_calibration_error(confidences, correct, bins=10):
    """Mean distance of confidence and share correct over the bins, weighted by their counts; None without verdicts."""
    rows = reliability(confidences, correct, bins)
    count = sum(n for _, _, n in rows)
    return sum(n * abs(confidence - right) for confidence, right, n in rows) / count if count else None


def calibration_error_by_chance(confidences, bins=10):
    """What the expected calibration error is on average if every confidence is the probability of being right; None without verdicts.

    The number of right ones in a bin is Poisson binomial: its distribution is built up verdict by verdict."""
    total = 0.0
    for number in range(bins):
        part = [c for c in confidences if bin_of(c, bins) == number]
        right = [1.0]  # probability of 0, 1, 2, ... right ones
        for c in part:
            right = [a * (1 - c) + b * c for a, b in zip([*right, 0.0], [0.0, *right])]
        total += sum(p * abs(k - sum(part)) for k, p in enumerate(right))
    return total / len(confidences) if confidences else None


def median(values):
    """None of nothing."""
    values = sorted(values)
    if not values:
        return None
    middle = len(values) // 2
    return values[middle] if len(values) % 2 else (values[middle - 1] + values[middle]) / 2
