"""Effects that no library has: laws put on the finished detections in any generator's world, and those of the foreign one.

Each law takes a strength from 0 to 1 and changes the table of a sample in place. None of them moves a detection as an effect of
the library would: they are periodic in range, in azimuth or in the frames.
"""

import math


def cyclic_range_error(rng):
    period, phase = rng.uniform(0.3, 2.0), rng.uniform(0, 6.28)

    def apply(table, strength):
        amplitude = 0.004 * 40 ** strength
        table["range_m"] = [r + amplitude * math.sin(2 * math.pi * r / period + phase) for r in table["range_m"]]
    return apply


def mirror_wobble(rng):
    periods = rng.uniform(10, 25)

    def apply(table, strength):
        amplitude = 0.004 * 40 ** strength
        table["range_m"] = [r + amplitude * math.sin(periods * a) for r, a in zip(table["range_m"], table["azimuth_rad"])]
    return apply


def facet_pattern(rng):
    """Every second frame comes from another mirror facet."""
    def apply(table, strength):
        shift = 0.006 * 30 ** strength
        table["range_m"] = [r + (shift if int(f) % 2 else -shift) for r, f in zip(table["range_m"], table["frame"])]
    return apply


def ringing_width(rng):
    """The comparator rings: the pulse width oscillates with itself."""
    period = rng.uniform(0.4, 1.0)

    def apply(table, strength):
        amplitude = 0.01 * 30 ** strength
        if "epw_m" in table:
            table["epw_m"] = [max(0.0, w + amplitude * math.sin(2 * math.pi * w / period)) for w in table["epw_m"]]
        else:
            cyclic(table, strength)
    cyclic = cyclic_range_error(rng)
    return apply


LAWS = {"cyclic-range-error": cyclic_range_error, "mirror-wobble": mirror_wobble, "facet-pattern": facet_pattern,
        "ringing-width": ringing_width}


def grown(low, high):
    return lambda u: float(f"{low * (high / low) ** u:.4g}")


# Of the second generator (generator/effects.cpp): name -> (needs, recipe), as effects.LIBRARY has them.
FOREIGN = {
    "x-range-ripple": (set(), lambda rng, c: (lambda p: lambda u: {"amplitude_m": grown(0.004, 0.15)(u), "period_m": p})(
        round(rng.uniform(0.3, 2.0), 2))),
    "x-facet-wobble": (set(), lambda rng, c: (lambda n: lambda u: {"amplitude_m": grown(0.004, 0.15)(u), "facets": n})(rng.randint(2, 6))),
    "x-layer-skew": ({"layers", "epw"}, lambda rng, c: lambda u: {"epw_per_layer_m": grown(0.004, 0.15)(u)}),
    "x-epw-compression": ({"epw"}, lambda rng, c: (lambda knee: lambda u: {"knee_m": knee, "slope": round(1 - grown(0.02, 0.9)(u), 4)})(
        round(0.3 * c.profile["emitter"]["pulse_fwhm_ns"] * rng.uniform(0.8, 1.4), 2))),
    "x-dropout-stripes": (set(), lambda rng, c: (lambda p: lambda u: {"period_deg": p, "width_deg": round(p / 3, 2),
                                                                      "probability": grown(0.02, 0.9)(u)})(round(rng.uniform(2, 8), 1))),
    "x-gain-ramp": ({"epw-or-intensity"}, lambda rng, c: (lambda s: lambda u: {"per_degree": s * grown(0.001, 0.05)(u)})(rng.choice([-1, 1]))),
    "x-range-scatter": ({"ranges"}, lambda rng, c: lambda u: {"per_metre": grown(0.0003, 0.02)(u)}),
    "x-warm-up": (set(), lambda rng, c: (lambda f: lambda u: {"range_m": grown(0.01, 0.3)(u), "frames": f})(round(rng.uniform(3, 15), 1))),
    "x-layer-range": ({"layers"}, lambda rng, c: lambda u: {"amplitude_m": grown(0.004, 0.15)(u)}),
}
