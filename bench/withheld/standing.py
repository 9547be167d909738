"""In which measurands a gap stands out, beam by beam: what the first row of *where* may name.

A stratum is a sample, one of its layers, or an eighth of its view. It stands out if the mean over its beams differs by five standard
errors and by a tenth of one detection's spread; echoes per shot by five standard errors. So one measurand among several that a cause moves is not
wrong for being smaller than another in steps of its resolution.
"""

import math
import statistics
from collections import Counter, defaultdict

import distance

ERRORS = 5.0   # standard errors of the mean: with a few hundred strata none by chance
OF_A_SHOT = 0.1  # of one detection's spread: less no one would call a gap
SECTORS = 8


def deviation(a, b):
    """Differences (a - b) of mean and of spread of one beam's detections: [(value, variance of the value, spread)]."""
    va, vb = statistics.variance(a), statistics.variance(b)
    spread = math.sqrt((va + vb) / 2)
    mean = (statistics.fmean(a) - statistics.fmean(b), va / len(a) + vb / len(b), spread)
    return [mean, (math.sqrt(va) - math.sqrt(vb), va / (2 * (len(a) - 1)) + vb / (2 * (len(b) - 1)), spread)]


def of_echoes(column, step, real, simulated):
    """{component: {beam: (value, variance, spread)}} of first echoes that both sides have."""
    a, b = distance.first_echoes(real, column), distance.first_echoes(simulated, column)
    least = step**2 / 12  # of values that are rounded to a step
    found = {"bias": {}, "scatter": {}}
    for beam in a.keys() & b.keys():
        if min(len(a[beam]), len(b[beam])) < distance.LEAST_ECHOES:
            continue
        for component, (value, variance, spread) in zip(found, deviation(a[beam], b[beam])):
            found[component][beam] = value, variance + least / len(a[beam]), math.hypot(spread, math.sqrt(least))
    return found


def of_counts(real, simulated, frames):
    """The same of echoes per shot; their variance is that from frame to frame."""
    counts = [defaultdict(Counter), defaultdict(Counter)]
    for table, count in zip((real, simulated), counts):
        for beam, frame in zip(distance.beams_of(table), table["frame"]):
            count[beam][frame] += 1
    found = {}
    for beam in counts[0].keys() | counts[1].keys():
        a, b = ([c[beam][frame] for frame in range(frames)] for c in counts)
        va, vb = statistics.pvariance(a), statistics.pvariance(b)
        found[beam] = statistics.fmean(a) - statistics.fmean(b), (va + vb) / frames, 0.0
    return found


def strata(beams):
    """Lists of beams: all, each layer, each eighth of the view."""
    azimuths = [azimuth for _, azimuth in beams]
    low, span = min(azimuths), max(azimuths) - min(azimuths) + 1
    parts = defaultdict(list)
    for beam in beams:
        parts["all"].append(beam)
        parts["layer", beam[0]].append(beam)
        parts["sector", (beam[1] - low) * SECTORS // span].append(beam)
    return parts.values()


def size_of(values, one_more=0.0):
    """Of the mean over the beams of a stratum, in detections' spreads; 0 where it is within ERRORS. What has no spread that it could
    be small beside is infinite. `one_more`: in one beam, what nobody would count as a difference."""
    mean = statistics.fmean(v for v, _, _ in values)
    error = max(math.sqrt(sum(variance for _, variance, _ in values)), one_more) / len(values)
    if abs(mean) <= ERRORS * error:
        return 0.0
    spread = statistics.fmean(s for _, _, s in values)
    return abs(mean) / spread if spread else math.inf


def largest(by_beam, one_more=0.0):
    """Size in the stratum in which it is largest."""
    return max((size_of([by_beam[b] for b in part], one_more) for part in strata(list(by_beam))), default=0.0) if by_beam else 0.0


def size_of_existence(experiment, real, simulated):
    """In a stratum of a sample, or in all samples together: what is rare in each may be many in all."""
    found, everything, most = 0.0, [], 0.0
    for sample in experiment["samples"]:
        by_beam, one_more = of_counts(real[sample["id"]], simulated[sample["id"]], sample["frames"]), 1 / sample["frames"]
        found = max(found, largest(by_beam, one_more))
        everything += by_beam.values()
        most = max(most, one_more)
    return max(found, size_of(everything, most)) if everything else found


def size_of_values(experiment, measurand, real, simulated):
    """Of the means or the spreads, in any sample."""
    found = 0.0
    for sample in experiment["samples"]:
        a, b = real[sample["id"]], simulated[sample["id"]]
        if a.get(measurand["column"]) and b.get(measurand["column"]):
            found = max(found, *map(largest, of_echoes(measurand["column"], measurand["resolution"], a, b).values()))
    return found


def sizes(experiment, real, simulated):
    """{measurand: size} of the gaps between two lists of tables that are beyond ERRORS in any stratum, however small."""
    found = {m["name"]: size_of_values(experiment, m, real, simulated) for m in experiment["measurands"]}
    found["existence"] = size_of_existence(experiment, real, simulated)
    return {name: size for name, size in found.items() if size > 0.0}


def measurands(found):
    """Those of `sizes` in which the gap stands out."""
    return [name for name, size in found.items() if size >= OF_A_SHOT]
