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


def significant(values, least=0.0, one_more=0.0):
    """Of the beams of a stratum. `least`: of one detection's spread; `one_more`: in one beam, what nobody would count as a difference."""
    mean = statistics.fmean(v for v, _, _ in values)
    error = max(math.sqrt(sum(variance for _, variance, _ in values)), one_more) / len(values)
    return abs(mean) > ERRORS * error and abs(mean) >= least * statistics.fmean(s for _, _, s in values)


def stands_out(by_beam, least=0.0, one_more=0.0):
    """Whether any stratum does."""
    return bool(by_beam) and any(significant([by_beam[b] for b in part], least, one_more) for part in strata(list(by_beam)))


def existence_stands_out(experiment, real, simulated):
    """In a stratum of a sample, or in all samples together: what is rare in each may be many in all. An echo has no spread that it
    could be small beside."""
    everything, most = [], 0.0
    for sample in experiment["samples"]:
        by_beam, one_more = of_counts(real[sample["id"]], simulated[sample["id"]], sample["frames"]), 1 / sample["frames"]
        if stands_out(by_beam, one_more=one_more):
            return True
        everything += by_beam.values()
        most = max(most, one_more)
    return bool(everything) and significant(everything, one_more=most)


def measurands(experiment, real, simulated, least=OF_A_SHOT):
    """Names of those in which the gap between two lists of tables stands out, in any sample."""
    found = []
    for m in experiment["measurands"]:
        for sample in experiment["samples"]:
            a, b = real[sample["id"]], simulated[sample["id"]]
            if not a.get(m["column"]) or not b.get(m["column"]):
                continue
            if any(stands_out(beams, least) for beams in of_echoes(m["column"], m["resolution"], a, b).values()):
                found.append(m["name"])
                break
    return found + (["existence"] if existence_stands_out(experiment, real, simulated) else [])
