"""Families of scenes. Each draws what stands where, what is varied from sample to sample, and what it can show.

`shows` are the traits that effects ask for (effects.py): "edges", "ranges", "angles", "contrast" (reflectivities),
"moving", "fast", "retro", "pane", "echoes" (several on one beam), "mirror", "spots" (small targets).
New family: one function and its line in FAMILIES.
"""

import math
from dataclasses import dataclass, field


@dataclass
class Scene:
    materials: dict
    objects: list
    samples: list  # [(parameters, [(pointer, value), ...]), ...]
    shows: set
    reach_m: float
    half_width_deg: float
    elevation_deg: tuple
    least_layers: int = 1
    references: list = field(default_factory=list)  # pointers whose true value may differ from the recorded one
    effects: dict = field(default_factory=dict)     # what the scene's materials need in the model


def grey(rng, low=0.05, high=0.85):
    return {"reflectivity": round(rng.uniform(low, high), 2), "brdf": {"model": "lambertian"}}


def thing(name, shape, position, material, yaw=0.0, velocity=None):
    item = {"id": name, "shape": shape, "pose": {"position_m": [float(p) for p in position], "yaw_pitch_roll_deg": [yaw, 0.0, 0.0]},
            "material": material}
    if velocity:
        item["velocity_m_s"] = velocity
    return item


def board(width, height):
    return {"type": "rectangle", "width_m": width, "height_m": height}


def x_of(i):
    return f"/scene/{i}/pose/position_m/0"


def y_of(i):
    return f"/scene/{i}/pose/position_m/1"


def yaw_of(i):
    return f"/scene/{i}/pose/yaw_pitch_roll_deg/0"


def ladder(rng, low, high, count):
    """Ranges between, evenly in their logarithm, slightly moved."""
    return [round(low * (high / low) ** ((i + rng.uniform(-0.2, 0.2)) / (count - 1)), 2) for i in range(count)]


def range_sweep(rng):
    count, far = rng.randint(9, 13), rng.uniform(25, 70)
    ranges = ladder(rng, rng.uniform(4, 9), far, count)
    width = round(rng.uniform(1.5, 4), 1)
    return Scene({"board": grey(rng, 0.1)}, [thing("target", board(width, round(width * 0.8, 1)), (ranges[0], 0, 0), "board")],
                 [({"range_m": r}, [(x_of(0), r)]) for r in ranges], {"edges", "ranges"}, far,
                 math.degrees(math.atan(width / ranges[0])) * 0.6, (-3, 3), references=[x_of(0), x_of(0), y_of(0), yaw_of(0)])


def panels(rng):
    number, count = rng.randint(2, 4), rng.randint(8, 12)
    width, far = round(rng.uniform(0.8, 1.6), 1), rng.uniform(15, 40)
    ranges = ladder(rng, rng.uniform(4, 8), far, count)
    materials = {f"grey-{i + 1}": {"reflectivity": round(0.06 * 13 ** (i / max(1, number - 1)) * rng.uniform(0.8, 1.15), 3),
                                   "brdf": {"model": "lambertian"}} for i in range(number)}
    objects = [thing(f"panel-{i + 1}", board(width, 2.0), (ranges[0], (i - (number - 1) / 2) * width * 1.05, 0), f"grey-{i + 1}")
               for i in range(number)]
    return Scene(materials, objects, [({"range_m": r}, [(x_of(i), r) for i in range(number)]) for r in ranges],
                 {"edges", "ranges", "contrast"}, far, math.degrees(math.atan(number * width / 2 / ranges[0])) + 2, (-2.5, 2.5),
                 references=[x_of(i) for i in range(number)])


def oblique(rng):
    near = rng.uniform(6, 12)
    distances = [round(near * f, 2) for f in rng.choice([(1,), (1, 1.9), (1, 2.6)])]
    angles = [0, 15, 30, 45, 55, 65, 72] if len(distances) == 1 else [0, 25, 45, 60, 72]
    width = round(rng.uniform(2.5, 5), 1)
    sign = rng.choice([-1, 1])
    grid = [(d, sign * (a + rng.uniform(0, 3))) for d in distances for a in angles]
    grid = [(d, round(a, 1)) for d, a in grid] + ([(distances[0], round(-sign * 35.0, 1))] if rng.random() < 0.7 else [])
    return Scene({"board": grey(rng, 0.15)}, [thing("board", board(width, round(rng.uniform(1.5, 3), 1)), (distances[0], 0, 0), "board")],
                 [({"range_m": d, "angle_deg": a}, [(x_of(0), d), (yaw_of(0), a)]) for d, a in grid],
                 {"edges", "angles"} | ({"ranges"} if len(distances) > 1 else set()), max(distances) * 1.6,
                 math.degrees(math.atan(width / 2 / near)) + 1, (-4, 4), references=[x_of(0), yaw_of(0), yaw_of(0)])


def street(rng, moving=False):
    ground = -round(rng.uniform(0.8, 1.9), 2)
    wall = round(rng.uniform(30, 55), 1)
    first = round(rng.uniform(8, 14), 1)
    speed = round(rng.uniform(15, 30) * rng.choice([-1, 1]), 1) if moving else 0.0
    side = round(rng.choice([-1, 1]) * rng.uniform(4, 12), 1) if moving and rng.random() < 0.6 else 0.0
    van = round(rng.uniform(8, 16), 1)
    objects = [
        thing("car", {"type": "box", "size_m": [4.3, 1.8, 1.5]}, (first + 2.2, rng.uniform(-1.5, 1.5), ground + 0.85), "paint",
              velocity=[speed, side, 0.0] if moving else None),
        thing("van", {"type": "box", "size_m": [5.2, 2.0, 2.2]}, (van, 4.5, ground + 1.2), "white"),
        thing("pole", {"type": "cylinder", "radius_m": 0.08, "height_m": 4.0}, (round(rng.uniform(6, 15), 1), -3.0, ground + 2.0), "steel"),
        thing("wall", board(80, 10), (wall, 0, 3), "brick"),
        thing("ground", {"type": "plane"}, (0, 0, ground), "asphalt")]
    objects[4]["pose"]["yaw_pitch_roll_deg"] = [0.0, 0.0, 0.0]
    places = ladder(rng, first, min(30, wall - 6), rng.randint(8, 11))
    samples = [({"range_m": round(p, 2)}, [(x_of(0), round(p + 2.2, 2))]) for p in places]
    return Scene({"paint": grey(rng, 0.1, 0.6), "white": grey(rng, 0.6), "steel": grey(rng, 0.3), "brick": grey(rng, 0.2, 0.4),
                  "asphalt": grey(rng, 0.1, 0.2)}, objects, samples,
                 {"edges", "ranges", "angles", "contrast", "echoes", "mirror", "wide"} | ({"moving", "fast"} if moving else set()),
                 wall, round(rng.uniform(20, 40), 1), (-6, 2), least_layers=4, references=[x_of(0), x_of(0), y_of(0), x_of(3)])


def traffic(rng):
    return street(rng, moving=True)


def occlusion(rng):
    back = round(rng.uniform(10, 25), 1)
    gaps = [round(g, 2) for g in ladder(rng, 0.4, min(8, back - 3), rng.randint(8, 12))]
    rng.shuffle(gaps)
    front = {"type": "box", "size_m": [0.2, round(rng.uniform(0.3, 1.2), 2), 1.2]} if rng.random() < 0.6 else \
        {"type": "cylinder", "radius_m": round(rng.uniform(0.1, 0.3), 2), "height_m": 1.5}
    return Scene({"front": grey(rng, 0.1), "back": grey(rng, 0.1)},
                 [thing("front", front, (back - gaps[0], 0, 0), "front"), thing("back", board(8, 4), (back, 0, 0), "back")],
                 [({"gap_m": g}, [(x_of(0), round(back - g, 2))]) for g in gaps], {"edges", "echoes", "contrast", "mirror", "ranges"}, back,
                 round(rng.uniform(5, 9), 1), (-4, 4), references=[x_of(0), x_of(1), y_of(0)])


def bright_and_dark(rng):
    count, far = rng.randint(8, 12), rng.uniform(15, 35)
    ranges = ladder(rng, rng.uniform(5, 8), far, count)
    sign = {"reflectivity": round(rng.uniform(0.3, 0.6), 2),
            "brdf": {"model": "retroreflector", "gain": round(rng.uniform(30, 600)), "half_width_rad": round(rng.uniform(0.3, 0.6), 2)}}
    objects = [thing("sign", board(0.6, 0.6), (ranges[0], -0.9, 0), "sign"), thing("dark", board(1.2, 1.4), (ranges[0], 0.5, 0), "dark"),
               thing("wall", board(40, 12), (far + 5, 0, 0), "wall")]
    return Scene({"sign": sign, "dark": grey(rng, 0.04, 0.12), "wall": grey(rng, 0.2, 0.6)}, objects,
                 [({"range_m": r}, [(x_of(0), r), (x_of(1), r)]) for r in ranges],
                 {"edges", "ranges", "contrast", "retro", "echoes", "mirror"}, far + 5, round(rng.uniform(9, 14), 1), (-3, 3), least_layers=2,
                 references=[x_of(0), x_of(1), x_of(2)], effects={"retroreflection": {}})


def window_pane(rng):
    behind = [round(x, 1) for x in ladder(rng, 8, rng.uniform(14, 28), rng.randint(8, 11))]
    pane = {"reflectivity": round(rng.uniform(0.05, 0.2), 2), "brdf": {"model": "lambertian"},
            "transmission": round(rng.uniform(0.5, 0.92), 2), "refractive_index": 1.52}
    near = round(rng.uniform(3, 6), 2)
    return Scene({"pane": pane, "board": grey(rng, 0.2)},
                 [thing("pane", board(1.6, 3.0), (near, 0.9, 0), "pane"), thing("board", board(6, 3), (behind[0], 0, 0), "board")],
                 [({"range_m": r}, [(x_of(1), r)]) for r in behind], {"edges", "ranges", "pane", "echoes", "contrast"}, 28,
                 round(rng.uniform(10, 14), 1), (-3, 3), references=[x_of(1), x_of(0)], effects={"transmission": {}})


FAMILIES = {
    "range-sweep": range_sweep,
    "panels": panels,
    "oblique": oblique,
    "street": street,
    "traffic": traffic,
    "occlusion": occlusion,
    "bright-and-dark": bright_and_dark,
    "window-pane": window_pane,
}
