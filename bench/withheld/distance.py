"""The gap of a sample as formats.md section 6 defines it, written anew here so that the judge shares no code with the judged.

Tables are {column: list}; a sample's gap is the sum over the measurands of (|d_bias| + d_cavm)/resolution plus
100 (missing + extra fraction).
"""

import math
import statistics
from collections import Counter

CELL_DEG = 2.0
BEAM_DEG = 0.05  # less than any step of a scan, more than rounding
LEAST_ECHOES = 3  # of a beam, for a mean


def double_validation(real, simulated):
    """(d_bias, d_cavm): difference of the means, and the area between the EDFs once the simulation is moved by it."""
    bias = math.fsum(simulated) / len(simulated) - math.fsum(real) / len(real)
    steps = Counter()
    for value, count in Counter(real).items():
        steps[value] += count / len(real)
    for value, count in Counter(simulated).items():
        steps[value - bias] -= count / len(simulated)
    area, height, last = 0.0, 0.0, None
    for value in sorted(steps):
        if last is not None:
            area += abs(height) * (value - last)
        height += steps[value]
        last = value
    return bias, area


def existence(real, simulated, frames):
    """(missing, extra) as shares of the simulated echoes, over cells of layer and azimuth."""
    if not simulated["layer"]:
        return 0.0, (1.0 if real["layer"] else 0.0)
    cells = Counter()
    for table, sign in ((simulated, 1), (real, -1)):
        for layer, azimuth in zip(table["layer"], table["azimuth_rad"]):
            cells[layer, math.floor(math.degrees(azimuth) / CELL_DEG + 1e-9)] += sign
    count = len(simulated["layer"])
    return sum(max(0, d) for d in cells.values()) / count, sum(max(0, -d) for d in cells.values()) / count


def sample_gap(measurands, real, simulated, frames):
    total, parts = 0.0, {}
    for m in measurands:
        a, b = real.get(m["column"]), simulated.get(m["column"])
        if not a or not b:
            continue
        bias, scatter = double_validation(a, b)
        parts[m["name"]] = (bias, scatter)
        total += (abs(bias) + scatter) / m["resolution"]
    missing, extra = existence(real, simulated, frames)
    parts["existence"] = (missing, extra)
    return total + 100 * (missing + extra), parts


def beams_of(table):
    """(layer, azimuth) of each detection"""
    return [(layer, round(math.degrees(azimuth) / BEAM_DEG)) for layer, azimuth in zip(table["layer"], table["azimuth_rad"])]


def first_echoes(table, column):
    """{beam: values of its first echoes}"""
    values = {}
    for beam, echo, value in zip(beams_of(table), table.get("echo") or [1] * len(table["layer"]), table[column]):
        if echo == 1:
            values.setdefault(beam, []).append(value)
    return values


def beam_by_beam(measurands, real, simulated, frames):
    """{measurand: mean over beams of the difference of their means and of their spreads}, and of echoes per shot.

    The EDF of a whole sample moves by metres where a few echoes are lost; what a measurand deviates by, beams that both
    have show."""
    parts = {}
    for m in measurands:
        if not real.get(m["column"]) or not simulated.get(m["column"]):
            continue
        a, b = first_echoes(real, m["column"]), first_echoes(simulated, m["column"])
        both = [(a[beam], b[beam]) for beam in a.keys() & b.keys() if min(len(a[beam]), len(b[beam])) >= LEAST_ECHOES]
        off = [abs(statistics.fmean(x) - statistics.fmean(y)) + abs(statistics.pstdev(x) - statistics.pstdev(y)) for x, y in both]
        parts[m["name"]] = statistics.fmean(off) if off else 0.0
    cells = Counter()
    for table, sign in ((simulated, 1), (real, -1)):
        for beam in beams_of(table):
            cells[beam] += sign / frames
    parts["existence"] = statistics.fmean(map(abs, cells.values())) if cells else 0.0
    return parts
