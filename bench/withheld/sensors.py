"""Sensors of the cases: invented ones of many kinds, and the profiles that come with the program, with a thinner scan."""

import copy
import json
import math
from pathlib import Path

PROFILES = Path(__file__).resolve().parents[2] / "resources" / "sensors"
RESOURCES = ["demo-scanner", "ibeo-lux-2010", "valeo-scala-1", "velodyne-vlp-16", "velodyne-vlp-32c", "flash-spad-array"]

CHANNELS = {
    "range": ("range_m", "m", "ratio", "range_resolution_m"),
    "epw": ("epw_m", "m", "interval", "epw_resolution_m"),
    "intensity": ("intensity", "nW", "ratio", "intensity_resolution"),
}


def log_uniform(rng, low, high):
    return math.exp(rng.uniform(math.log(low), math.log(high)))


def rounded(value, digits=3):
    """To some significant digits, as data sheets give them."""
    return 0.0 if value == 0 else round(value, digits - 1 - math.floor(math.log10(abs(value))))


def invented(rng, reach_m):
    """A scanner that sees a tenth-reflecting surface as far as `reach_m` with a few times its threshold."""
    power, aperture = rounded(log_uniform(rng, 15, 120)), rounded(rng.uniform(0.01, 0.035))
    efficiency, duration = round(rng.uniform(0.4, 0.9), 2), round(rng.uniform(2.0, 8.0), 1)
    at_reach = power * efficiency * math.pi * aperture**2 / 4 * (0.1 / math.pi) / reach_m**2
    threshold = rounded(at_reach / rng.uniform(1.2, 4.0))
    divergence = {"horizontal": rounded(log_uniform(rng, 0.0008, 0.006)), "vertical": rounded(log_uniform(rng, 0.001, 0.014))}
    outputs = rng.choice([["range", "epw"], ["range", "intensity"], ["range", "epw", "intensity"], ["range", "epw", "intensity"]])
    return {
        "format": "fidelis-sensor", "version": 1, "id": "scanner", "title": "synthetic scanner", "source": "synthetic",
        "emitter": {"wavelength_nm": rng.choice([905, 905, 940, 1550]), "peak_power_w": power, "pulse_fwhm_ns": duration,
                    "divergence_rad": divergence, "beam_profile": rng.choice(["uniform", "gaussian"])},
        "receiver": {"aperture_diameter_m": aperture, "efficiency": efficiency, "axis_offset_m": 0.0,
                     "field_of_view_rad": {k: rounded(v * rng.uniform(1.3, 3)) for k, v in divergence.items()},
                     "noise_w": rounded(threshold / rng.uniform(5, 12)), "threshold_w": threshold, "saturation_w": None},
        "scan": {"frame_rate_hz": rng.choice([10, 12.5, 20, 25]), "duty": rng.choice([0.3, 0.5, 0.8]),
                 "direction": rng.choice(["left-to-right", "right-to-left"]), "layers": []},
        "detection": {"max_echoes": rng.choice([1, 2, 3, 3, 4]), "echo_separation_m": round(rng.uniform(0.4, 1.5), 1),
                      "range_mode": rng.choice(["peak", "peak", "leading-edge", "centre"]),
                      "min_range_m": 0.5, "max_range_m": 200,
                      "range_resolution_m": rng.choice([0.002, 0.005, 0.01, 0.02]), "epw_resolution_m": rng.choice([0.02, 0.03, 0.04]),
                      "intensity_resolution": rounded(threshold * 1e9 / rng.uniform(1, 5), 1),
                      "range_noise_m": round(rng.uniform(0.004, 0.03), 3), "epw_noise_m": round(rng.uniform(0.02, 0.08), 3),
                      "output": outputs}}


def known(rng):
    """One of the program's profiles; what section 2 of the formats does not name is left out, for other programs to read."""
    profile = json.loads((PROFILES / (rng.choice(RESOURCES) + ".json")).read_text())
    profile = copy.deepcopy(profile)
    for part, keys in (("emitter", ("wavelength_nm", "peak_power_w", "pulse_fwhm_ns", "divergence_rad", "beam_profile")),
                       ("receiver", ("aperture_diameter_m", "efficiency", "axis_offset_m", "field_of_view_rad", "noise_w",
                                     "threshold_w", "saturation_w")),
                       ("scan", ("frame_rate_hz", "duty", "direction"))):
        profile[part] = {k: profile[part][k] for k in keys if k in profile[part]}
    profile["scan"].setdefault("direction", "left-to-right")
    detection = profile["detection"]
    detection["epw_noise_m"] = detection.get("epw_noise_m", 0.05)
    detection["epw_resolution_m"] = detection.get("epw_resolution_m", 0.04)
    detection["intensity_resolution"] = detection.get("intensity_resolution", rounded(profile["receiver"]["threshold_w"] * 1e9 / 5, 1))
    return {k: profile[k] for k in ("format", "version", "id", "title", "source", "emitter", "receiver", "scan", "detection")}


def scan(rng, half_width_deg, elevations_deg, beams):
    """Layers over +-half_width, about `beams` of them a frame."""
    columns = max(9, round(beams / len(elevations_deg)))
    step = max(0.05, round(2 * half_width_deg / (columns - 1), 3))
    half = round(step * (columns - 1) / 2, 4)
    return [{"elevation_deg": e, "azimuth_deg": {"from": half, "to": -half, "step": step}} for e in elevations_deg]


def draw(rng, scene):
    """The sensor for a scene, its scan laid over what there is to see."""
    profile = invented(rng, scene.reach_m) if rng.random() < 0.75 or scene.reach_m > 40 else known(rng)
    count = rng.choice([n for n in (1, 2, 4, 6, 8) if n >= scene.least_layers])
    span = scene.elevation_deg
    middle, half = sum(span) / 2, (span[1] - span[0]) / 2
    elevations = [round(middle + (2 * i / (count - 1) - 1) * half, 2) if count > 1 else round(middle, 2) for i in range(count)]
    profile["scan"]["layers"] = scan(rng, scene.half_width_deg, elevations, log_uniform(rng, 150, 700))
    return profile


def measurands(profile):
    return [{"name": name, "column": CHANNELS[name][0], "unit": CHANNELS[name][1], "scale": CHANNELS[name][2],
             "resolution": profile["detection"][CHANNELS[name][3]]} for name in profile["detection"]["output"]]


def beams(profile):
    """Beams a frame."""
    total = 0
    for layer in profile["scan"]["layers"]:
        azimuth = layer["azimuth_deg"]
        total += math.floor(abs(azimuth["to"] - azimuth["from"]) / azimuth["step"] + 1e-6) + 1
    return total
