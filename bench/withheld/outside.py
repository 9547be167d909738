"""Effects that no library has: laws put on the finished detections, in any generator's world.

Each takes a strength from 0 to 1 and changes the table of a sample in place. None of them moves a detection as an effect of
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
