"""What may be withheld: for each effect of the library its parameters from barely there (0) to strong (1).

`draw(rng, context)` fixes what does not belong to the strength (sector, place, sign) and returns strength -> parameters.
`needs`: traits of the scene ("epw", "intensity", "layers" and "gate" come from the sensor).
Not among them: angle-clipping (it always holds in the formats' signal chain).
"""

import math
from dataclasses import dataclass


@dataclass
class Context:
    scene: object
    profile: dict
    near_m: float
    far_m: float

    def peak_w(self, reflectivity, range_m):
        """Received peak power of a beam-filling Lambertian target (laser radar equation)."""
        emitter, receiver = self.profile["emitter"], self.profile["receiver"]
        area = math.pi * receiver["aperture_diameter_m"] ** 2 / 4
        return emitter["peak_power_w"] * receiver["efficiency"] * area * reflectivity / math.pi / range_m**2

    @property
    def brightest_w(self):
        gain = 30 if "retro" in self.scene.shows else 1
        return gain * self.peak_w(max(m["reflectivity"] for m in self.scene.materials.values()), self.near_m)


def digits(x, n=4):
    return float(f"{x:.{n}g}")


def between(low, high):
    """Strength to value, evenly in the logarithm; low > high for what gets stronger as it gets smaller."""
    return lambda u: digits(low * (high / low) ** u)


def one(name, low, high, **fixed):
    """Recipe with a single parameter."""
    return lambda rng, context: lambda u: {name: between(low, high)(u), **fixed}


def signed(name, low, high):
    def draw(rng, context):
        sign = rng.choice([-1, 1])
        return lambda u: {name: sign * between(low, high)(u)}
    return draw


def nothing(rng, context):
    return lambda u: {}


def mounting(rng, context):
    name, sign = rng.choice(["yaw_deg", "pitch_deg"]), rng.choice([-1, 1])
    return lambda u: {name: sign * between(0.05, 3)(u)}


def jitter(rng, context):
    if rng.random() < 0.5:
        return lambda u: {"duration_stddev_ns": between(0.05, 0.9)(u)}
    return lambda u: {"power_stddev": between(0.01, 0.2)(u)}


def exhaust(rng, context):
    place = round(context.near_m * rng.uniform(0.4, 0.8), 2)
    size = round(rng.uniform(0.5, 1.5), 2)
    return lambda u: {"extinction_1_m": between(0.002, 3)(u), "size_m": size, "centre": [place, 0.0, 0.0]}


def sector(rng, context, share):
    """A part of the scan: centre and width. [deg]"""
    half = context.scene.half_width_deg
    return round(rng.uniform(-0.5, 0.5) * half, 2), round(share * half * rng.uniform(0.6, 1.4), 2)


def spoofing(rng, context):
    centre, _ = sector(rng, context, 0)
    place = round(rng.uniform(0.3, 0.9) * context.near_m, 2)
    return lambda u: {"azimuth_deg": centre, "range_m": place, "width_deg": between(0.05, 0.7 * context.scene.half_width_deg)(u)}


def blinding(rng, context):
    centre, width = sector(rng, context, 0.8)
    return lambda u: {"azimuth_deg": centre, "irradiance": between(0.3, 9.5)(u), "width_deg": width}


def reflection(rng, context):
    if rng.random() < 0.5:
        return lambda u: {"model": "oren-nayar", "roughness_rad": between(0.1, 0.9)(u)}
    exponent = rng.choice([5, 10, 20, 50])
    return lambda u: {"model": "phong", "diffuse_fraction": round(1 - between(0.03, 0.7)(u), 4), "exponent": exponent}


def contamination(rng, context):
    centre, width = sector(rng, context, 0.9)
    return lambda u: {"attenuation": between(0.02, 0.7)(u), "azimuth_from_deg": round(centre - width / 2, 2),
                      "azimuth_to_deg": round(centre + width / 2, 2)}


def nonuniformity(rng, context):
    gains = [rng.gauss(0, 1) for _ in context.profile["scan"]["layers"]]
    mean = sum(gains) / len(gains)
    return lambda u: {"gain_per_layer": [round(math.exp(between(0.01, 0.4)(u) * (g - mean)), 4) for g in gains]}


def saturation(rng, context):
    return lambda u: {"saturation_w": digits(max(context.brightest_w * between(1.0, 0.02)(u),
                                                 1.5 * context.profile["receiver"]["threshold_w"]))}


def walk(rng, context):
    """A comparator that was trimmed at an echo brighter and brighter than those that are seen."""
    threshold = context.profile["receiver"]["threshold_w"]
    middle = max(2.0, context.peak_w(0.4, math.sqrt(context.near_m * context.far_m)) / threshold)
    return lambda u: {"calibrated_at_snr": digits(middle * 30 ** u)}


def threshold_factor(rng, context):
    factor = context.profile["receiver"]["threshold_w"] / context.profile["receiver"]["noise_w"]
    return lambda u: {"factor": digits(min(50.0, factor * between(1.04, 6)(u)))}


def quantisation(rng, context):
    step = context.profile["detection"]["range_resolution_m"]
    return lambda u: {"range_step_m": digits(between(2 * step, 0.8)(u), 3)}


def gating(rng, context):
    """Closes from behind, or from in front, over the ranges that occur."""
    span = context.far_m - context.near_m
    if rng.random() < 0.6:
        last = max(context.far_m, context.scene.reach_m) if "echoes" in context.scene.shows else context.far_m
        return lambda u: {"from_m": 0.0, "to_m": round(last + 0.3 - (last - context.near_m) * 0.8 * u, 2)}
    return lambda u: {"from_m": round(max(0.0, context.near_m - 0.3 + 0.6 * span * u), 2), "to_m": 1000.0}


def merging(rng, context):
    base = context.profile["detection"]["echo_separation_m"]
    return lambda u: {"separation_m": digits(min(10.0, base * between(1.2, 8)(u)))}


def divergence(rng, context):
    return lambda u: {}


# name: (needs, draw)
LIBRARY = {
    "beam-divergence": ({"edges"}, divergence),
    "aperture-offset": ({"ranges"}, one("offset_m", 0.003, 0.08)),
    "stray-radiation": ({"retro"}, lambda rng, c: (lambda a: lambda u: {"fraction": between(1e-4, 1e-2)(u), "half_angle_rad": a})(
        round(rng.uniform(0.01, 0.06), 3))),
    "mounting-error": ({"edges", "wide"}, mounting),
    "pulse-jitter": ({"epw-or-intensity"}, jitter),
    "atmospheric-attenuation": ({"ranges"}, one("visibility_m", 5000, 60)),
    "atmospheric-backscatter": ({"ranges"}, one("visibility_m", 1000, 25)),
    "precipitation-clutter": ({"ranges"}, one("rain_rate_mm_h", 2, 100)),
    "road-spray": ({"fast"}, lambda rng, c: (lambda e: lambda u: {"density": between(0.05, 8)(u), "extinction_1_m": e})(
        round(rng.uniform(0.02, 0.3), 3))),
    "exhaust-cloud": ({"edges"}, exhaust),
    "crosstalk": ({"edges"}, one("rate_1_s", 500, 1e6)),
    "spoofing": ({"edges"}, spoofing),
    "blinding": ({"edges"}, blinding),
    "angular-reflection": ({"angles"}, reflection),
    "surface-moisture": ({"angles"}, one("wetness", 0.05, 1.0)),
    "retroreflection": ({"retro"}, nothing),
    "transmission": ({"pane"}, nothing),
    "multipath": ({"mirror"}, one("specular_fraction", 0.02, 0.7)),
    "pulse-broadening": ({"angles", "epw"}, nothing),
    "speckle": ({"epw-or-intensity"}, one("looks", 100, 1.5)),
    "motion-scan": ({"moving"}, nothing),
    "cover-contamination": ({"edges"}, contamination),
    "photo-response-nonuniformity": ({"layers", "epw-or-intensity"}, nonuniformity),
    "background-light": ({"edges"}, one("irradiance_w_m2_nm", 0.01, 1.0)),
    "thermal-noise": ({"edges"}, one("temperature_degC", 28, 85)),
    "saturation": ({"ranges", "epw-or-intensity"}, saturation),
    "blooming": ({"retro"}, lambda rng, c: (lambda n: lambda u: {"fraction": between(1e-3, 0.1)(u), "neighbours": n})(rng.randint(2, 8))),
    "dead-time": ({"echoes"}, one("dead_time_ns", 5, 100)),
    "range-walk": ({"ranges", "no-edge"}, walk),
    "dynamic-threshold": ({"epw"}, threshold_factor),
    "quantisation": ({"edges"}, quantisation),
    "range-gating": ({"ranges"}, gating),
    "echo-merging": ({"echoes", "several-echoes"}, merging),
    "latency": ({"moving"}, one("delay_s", 0.001, 0.2)),
    "clock-drift": ({"ranges"}, signed("scale_ppm", 100, 2000)),
    "range-offset": ({"ranges"}, signed("offset_m", 0.003, 0.4)),
    "false-alarm": ({"edges"}, one("rate_per_beam", 0.0005, 0.1)),
    "detection-loss": ({"edges"}, one("probability", 0.003, 0.6)),
}

# Effects that weaken every echo: a refitted reflectivity or power hides them well.
WEAKENING = ["atmospheric-attenuation", "aperture-offset", "cover-contamination", "angular-reflection", "surface-moisture"]


def traits(scene, profile):
    """What scene and sensor together can show."""
    output, found = set(profile["detection"]["output"]), set(scene.shows)
    found |= output & {"epw", "intensity"}
    if output & {"epw", "intensity"}:
        found.add("epw-or-intensity")
    if len(profile["scan"]["layers"]) >= 4:
        found.add("layers")
    if profile["detection"]["range_mode"] != "leading-edge":
        found.add("no-edge")
    if profile["detection"]["max_echoes"] > 1:
        found.add("several-echoes")
    return found


def possible(name, scene, profile):
    return LIBRARY[name][0] <= traits(scene, profile)
