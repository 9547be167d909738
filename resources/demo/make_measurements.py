#!/usr/bin/env python3
"""Makes the measurements of the demo's two experiments. No real sensor was involved.

    python3 make_measurements.py            run in this folder; rewrites */measurements/*.csv

A small stand-in for a measurement campaign that shares no code with the simulation it is compared with: closed forms
for one beam on one flat surface, no ray tracing, no waveform, noise of its own. Standard library only; a fixed seed,
so that the same files come out again.

    P(r)  = P_t eta A cos(theta) rho / (pi r^2) * exp(-2 alpha r)      laser radar equation, Beer-Lambert out and back
    EPW   = c FWHM sqrt(log2(P / (T - n)))                             time of a Gaussian pulse above a threshold
    alpha = 3.912 / V                                                  fog, 2 % contrast at the visibility V < 500 m

P_t peak power, A aperture, rho reflectivity, T threshold, n receiver noise of the shot; there is no detection if
P + n < T. Sources: Rasshofer et al. 2011, doi:10.5194/ars-9-49-2011; Kim et al. 2001, doi:10.1117/12.417512.

The sensor's numbers are those of resources/sensors/ibeo-lux-2010.json, repeated here on purpose. What the simulation
does not know: each target stands up to 2 mm beside its reference, every shot differs a little in power, and in the
second experiment fog lies over the proving ground.
"""
import csv
import json
import math
import pathlib
import random

C = 299792458.0
PEAK_POWER_W, APERTURE_M, EFFICIENCY, FWHM_S = 100.0, 0.002, 0.9, 2.08e-9
THRESHOLD_W, NOISE_W, SHOT_POWER = 2.7e-10, 1.35e-11, 0.02
RANGE_NOISE_M, EPW_NOISE_M, RANGE_STEP_M, EPW_STEP_M = 0.025, 0.03, 0.01, 0.04
REFERENCE_ERROR_M = 0.002
FOG_VISIBILITY_M = 200.0

HERE = pathlib.Path(__file__).resolve().parent


def received_power_w(range_m, incidence_rad, reflectivity, extinction_1_m):
    area_m2 = math.pi * APERTURE_M**2 / 4
    clear = PEAK_POWER_W * EFFICIENCY * area_m2 * math.cos(incidence_rad) * reflectivity / (math.pi * range_m**2)
    return clear * math.exp(-2 * extinction_1_m * range_m)


def rounded(value, step):
    return round(value / step) * step


def shot(rng, range_m, mean_power_w):
    """Range and echo pulse width of one shot, or None if the echo stays below the threshold."""
    power_w = mean_power_w * (1 + rng.gauss(0, SHOT_POWER))
    level_w = max(THRESHOLD_W - rng.gauss(0, NOISE_W), 0.05 * THRESHOLD_W)
    if power_w < level_w:
        return None
    epw_m = C * FWHM_S * math.sqrt(math.log2(power_w / level_w)) + rng.gauss(0, EPW_NOISE_M)
    return rounded(range_m + rng.gauss(0, RANGE_NOISE_M), RANGE_STEP_M), rounded(max(epw_m, 0), EPW_STEP_M)


def measure(rng, stand_off_m, frames, beams, extinction_1_m, file):
    """One sample: a flat target across the x axis, hit by beams of (layer, azimuth, elevation, reflectivity)."""
    true_x_m = stand_off_m + rng.uniform(-REFERENCE_ERROR_M, REFERENCE_ERROR_M)
    with open(file, "w", newline="", encoding="utf-8") as out:
        write = csv.writer(out, lineterminator="\n").writerow
        write(["frame", "layer", "azimuth_rad", "elevation_rad", "echo", "range_m", "epw_m"])
        for frame in range(frames):
            for layer, azimuth, elevation, reflectivity in beams:
                cosine = math.cos(azimuth) * math.cos(elevation)  # of the incidence angle
                range_m = true_x_m / cosine
                power_w = received_power_w(range_m, math.acos(cosine), reflectivity, extinction_1_m)
                echo = shot(rng, range_m, power_w)
                if echo:
                    write([frame, layer, azimuth, elevation, 1, f"{echo[0]:.2f}", f"{echo[1]:.2f}"])


def run(package, reflectivity_of_beam, extinction_1_m, seed):
    rng = random.Random(seed)
    experiment = json.loads((HERE / package / "experiment.json").read_text(encoding="utf-8"))
    (HERE / package / "measurements").mkdir(exist_ok=True)
    for sample in experiment["samples"]:
        with open(HERE / package / sample["beams"], newline="", encoding="utf-8") as lines:
            directions = list(csv.DictReader(lines))
        beams = [(int(b["layer"]), float(b["azimuth_rad"]), float(b["elevation_rad"]), rho)
                 for b, rho in zip(directions, reflectivity_of_beam, strict=True)]
        measure(rng, sample["patch"][0]["value"], sample["frames"], beams, extinction_1_m,
                HERE / package / sample["measurements"])


run("range-sweep", [0.5], 0.0, "range sweep of a sensor that does not exist")
run("foggy-sweep", [0.5, 0.1], 3.912 / FOG_VISIBILITY_M, "two panels on a morning that never was")
