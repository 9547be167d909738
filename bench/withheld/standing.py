"""In which measurands a gap stands out, beam by beam: what the first row of *where* may name.

A stratum is a sample, one of its layers, or an eighth of its view. It stands out if the mean over its beams differs by five standard
errors and by a tenth of one detection's spread (existence: of a shot's). So one measurand among several that a cause moves is not
wrong for being smaller than another in steps of its resolution.
"""

import math
import statistics
from collections import defaultdict

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
    """The same of echoes per shot. Their variance is that of a coin thrown for the last of them once a shot, never quite certain."""
    counts = [defaultdict(int), defaultdict(int)]
    for table, count in zip((real, simulated), counts):
        for beam in distance.beams_of(table):
            count[beam] += 1
    found = {}
    for beam in counts[0].keys() | counts[1].keys():
        rate = (counts[0][beam] + counts[1][beam]) / (2 * frames)
        last = rate - math.floor(rate)
        variance = max(last * (1 - last), 1 / (4 * frames))
        found[beam] = (counts[0][beam] - counts[1][beam]) / frames, 2 * variance / frames, math.sqrt(variance)
    return {"existence": found}


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


def stands_out(by_beam, least=OF_A_SHOT):
    """Whether any stratum does; `least`: of one detection's spread."""
    if not by_beam:
        return False
    for part in strata(list(by_beam)):
        values = [by_beam[beam] for beam in part]
        mean = statistics.fmean(v for v, _, _ in values)
        error = math.sqrt(sum(variance for _, variance, _ in values)) / len(values)
        if abs(mean) > ERRORS * error and abs(mean) >= least * statistics.fmean(s for _, _, s in values):
            return True
    return False


def measurands(experiment, real, simulated, least=OF_A_SHOT):
    """Names of those in which the gap between two lists of tables stands out, in any sample."""
    found = []
    for sample in experiment["samples"]:
        a, b = real[sample["id"]], simulated[sample["id"]]
        tables = {"existence": of_counts(a, b, sample["frames"])}
        for m in experiment["measurands"]:
            if a.get(m["column"]) and b.get(m["column"]):
                tables[m["name"]] = of_echoes(m["column"], m["resolution"], a, b)
        found += [name for name, components in tables.items() if name not in found and any(stands_out(c, least) for c in components.values())]
    return found
