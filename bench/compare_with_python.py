#!/usr/bin/env python3
"""How fast the metrics are beside numpy, scipy, one std::sort and one pass over the memory.

    apt-get install python3-numpy python3-scipy
    cmake --preset release && cmake --build --preset release --target metrics_bench
    bench/compare_with_python.py [build/bin/metrics_bench] [rounds]

Each round runs the C++ benchmarks and then the Python tasks once, on samples of the same distributions and sizes; ratios
are taken within a round, and the table shows their median and range over the rounds. Times are processor time, so that
other programs on the machine count little; both sides work on one thread.
"""

import json
import statistics
import subprocess
import sys
import time

import numpy
import scipy
import scipy.stats

RANDOM = numpy.random.default_rng(1)


def normal(size, mean, resolution=0.0):
    values = RANDOM.normal(mean, 0.2, size)
    return resolution * numpy.round(values / resolution) if resolution else values


def p_box_area(runs, measured):
    """Area between the box of the runs and the measurement: envelope of the EDFs on the union of all values."""
    runs = [numpy.sort(run) for run in runs]
    measured = numpy.sort(measured)
    union = numpy.concatenate(runs + [measured])
    union.sort(kind="stable")  # merges ascending stretches
    x = union[:-1]
    upper = numpy.zeros(x.size)
    lower = numpy.ones(x.size)
    for run in runs:
        cdf = numpy.searchsorted(run, x, side="right") / run.size
        numpy.maximum(upper, cdf, out=upper)
        numpy.minimum(lower, cdf, out=lower)
    cdf = numpy.searchsorted(measured, x, side="right") / measured.size
    gap = numpy.maximum(0.0, numpy.maximum(cdf - upper, lower - cdf))
    return numpy.dot(gap, numpy.diff(union))


def p_box_area_of_steps(runs, measured):
    """The same on the distinct values: much shorter with a counter's ties, a waste without."""
    values = [numpy.unique(run, return_counts=True) for run in runs + [measured]]
    union = numpy.unique(numpy.concatenate([v for v, _ in values]))
    cdfs = []
    for steps, counts in values:
        heights = numpy.concatenate([[0.0], numpy.cumsum(counts) / counts.sum()])
        cdfs.append(heights[numpy.searchsorted(steps, union[:-1], side="right")])
    box = numpy.array(cdfs[:-1])
    gap = numpy.maximum(0.0, numpy.maximum(cdfs[-1] - box.max(axis=0), box.min(axis=0) - cdfs[-1]))
    return numpy.dot(gap, numpy.diff(union))


def corners(sizes, resolution=0.0):
    runs = [normal(size, 22.0 + 0.01 * (k + 1), resolution) for k, size in enumerate(sizes)]
    return runs, normal(69000, 22.0, resolution)


def python_tasks():
    one_size = corners([70000] * 17)
    sizes = corners([69100 + 100 * (k + 1) for k in range(17)])
    counter = corners([70000] * 17, 0.01)
    million = normal(1_000_000, 22.0), normal(1_000_000, 22.1)
    hundred_thousand = normal(100_000, 22.0), normal(100_000, 22.0)
    return {
        "numpy p-box": lambda: p_box_area(*one_size),
        "numpy p-box, sizes": lambda: p_box_area(*sizes),
        "numpy p-box, counter": lambda: p_box_area_of_steps(*counter),
        "scipy wasserstein_distance": lambda: scipy.stats.wasserstein_distance(*million),
        "scipy ks_2samp": lambda: scipy.stats.ks_2samp(*hundred_thousand, method="asymp"),
    }


# task, ours, peer, its title, True: the goal is how many times faster than the peer, False: how many times its time; goal
PLAIN_SUM = "adding up both arrays, plain loop"
LANES = "same, 16 sums side by side"
ROWS = [
    ("AVM portions, 10^6 + 10^6 unsorted values", "portionsOfUnsortedSamples/1000000", "standardSort/1000000",
     "one `std::sort` of 10^6", False, 2.2),
    ("AVM portions of two `Edf`, 10^6 + 10^6", "portionsOfTwoEdfs/1000000", "streamingSum/1000000", PLAIN_SUM, False, 1.0),
    ("", "portionsOfTwoEdfs/1000000", "streamingSumOfLanes/1000000", LANES, False, None),
    ("same, 10^7 + 10^7", "portionsOfTwoEdfs/10000000", "streamingSum/10000000", PLAIN_SUM, False, 1.0),
    ("", "portionsOfTwoEdfs/10000000", "streamingSumOfLanes/10000000", LANES, False, None),
    ("from sorted values, 10^6 + 10^6", "portionsOfSortedSamples/1000000", "streamingSum/1000000", PLAIN_SUM, False, 1.0),
    ("", "portionsOfSortedSamples/1000000", "streamingSumOfLanes/1000000", LANES, False, None),
    ("same, 10^7 + 10^7", "portionsOfSortedSamples/10000000", "streamingSum/10000000", PLAIN_SUM, False, 1.0),
    ("", "portionsOfSortedSamples/10000000", "streamingSumOfLanes/10000000", LANES, False, None),
    ("p-box of 17 x 70 000 values against 69 000", "areaOfSeventeenRuns/0", "numpy p-box", "numpy, value domain", True,
     8.0),
    ("same, 17 sizes 69 200 … 70 800", "areaOfSeventeenSizes/0", "numpy p-box, sizes", "numpy, value domain", True, 8.0),
    ("same, counter of 1 cm (ties)", "areaOfSeventeenRuns/10", "numpy p-box, counter", "numpy, distinct values", True,
     8.0),
    ("1-Wasserstein, 10^6 + 10^6", "wassersteinOfTwoSamples/1000000", "scipy wasserstein_distance",
     "`scipy.stats.wasserstein_distance`", True, 4.0),
    ("two-sample KS, 10^5 + 10^5", "kolmogorovSmirnovOfTwoSamples/100000", "scipy ks_2samp",
     "`scipy.stats.ks_2samp`, asymptotic", True, None),
]


def cpp_times(program):
    names = {name for row in ROWS for name in row[1:3] if "/" in name}
    command = [program, "--benchmark_format=json", "--benchmark_min_time=0.05",
               "--benchmark_filter=^(" + "|".join(sorted(names)) + ")$"]
    output = subprocess.run(command, check=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL).stdout
    return {run["name"]: run["cpu_time"] for run in json.loads(output)["benchmarks"]}  # ms


def python_times(tasks):
    times = {}
    for name, task in tasks.items():
        start = time.process_time()
        task()
        times[name] = 1e3 * (time.process_time() - start)
    return times


def line(row, rounds):
    task, ours, peer, title, faster, goal = row
    ratios = sorted(times[peer] / times[ours] if faster else times[ours] / times[peer] for times in rounds)
    ratio = statistics.median(ratios)

    def time_of(name):
        milliseconds = statistics.median(times[name] for times in rounds)
        if "streamingSum" not in peer:
            return f"{milliseconds:.3g} ms"
        return f"{milliseconds:.3g} ms, {16e-6 * int(name.split('/')[1]) / milliseconds:.3g} GB/s"

    unit = "x faster" if faster else "x its time"
    verdict = "" if goal is None else f"{'>=' if faster else '<='} {goal:g} " + (
        "(met)" if (ratio >= goal if faster else ratio <= goal) else "(missed)")
    return (f"| {task} | {time_of(ours)} | {title} | {time_of(peer)} | "
            f"{ratio:.2f} {unit} ({ratios[0]:.2f} … {ratios[-1]:.2f}) | {verdict} |")


def main():
    program = sys.argv[1] if len(sys.argv) > 1 else "build/bin/metrics_bench"
    count = int(sys.argv[2]) if len(sys.argv) > 2 else 11
    tasks = python_tasks()
    python_times(tasks)  # once for what is loaded late
    rounds = [cpp_times(program) | python_times(tasks) for _ in range(count)]
    print(f"numpy {numpy.__version__}, scipy {scipy.__version__}, median of {count} rounds (range of the ratio)\n")
    print("| task | ours | bound or peer | its time | ratio | goal |\n|-|-|-|-|-|-|")
    for row in ROWS:
        print(line(row, rounds))


if __name__ == "__main__":
    main()
