#!/usr/bin/env python3
"""Writes the ready scenes beside this file: python3 resources/scenes/make_scenes.py

Lengths in m, angles in degrees, ISO 8855 (x forward, y left, z up); the sensor stands in the origin. Reflectivities are
round figures to start from, places are invented. Seeded: the same bytes every time.
"""

import json
import math
import pathlib
import random

HERE = pathlib.Path(__file__).parent
ROUND_SENSOR = "velodyne-vlp-16"

MATERIALS = {"asphalt": 0.15, "bark": 0.3, "black-paint": 0.06, "board": 0.5, "car-paint": 0.4, "car-window": 0.1,
             "clothing": 0.4, "concrete": 0.35, "dark-board": 0.1, "foliage": 0.5, "metal": 0.3, "plaster": 0.6,
             "skin": 0.5, "tarpaulin": 0.5, "tyre": 0.05}
RETROREFLECTOR = {"reflectivity": 0.5, "brdf": {"model": "retroreflector", "gain": 300, "half_width_rad": 0.015}}


class Scene:
    """Objects with unique ids; a velocity goes to everything that is added while it is set."""

    def __init__(self):
        self.objects, self.velocity = [], (0, 0, 0)

    def add(self, name, shape, position, material, yaw=0.0, pitch=0.0, roll=0.0):
        thing = {"id": name, "shape": shape,
                 "pose": {"position_m": [round(float(x), 4) + 0.0 for x in position],
                          "yaw_pitch_roll_deg": [yaw, pitch, roll]}}
        if any(self.velocity):
            thing["velocity_m_s"] = [round(x, 3) for x in self.velocity]
        thing["material"] = material
        self.objects.append(thing)

    def box(self, name, size, position, material, yaw=0.0):
        self.add(name, {"type": "box", "size_m": [round(x, 4) for x in size]}, position, material, yaw)

    def post(self, name, radius, height, foot, material):
        self.add(name, {"type": "cylinder", "radius_m": radius, "height_m": round(height, 4)},
                 (foot[0], foot[1], foot[2] + height / 2), material)

    def ball(self, name, radius, position, material):
        self.add(name, {"type": "sphere", "radius_m": round(radius, 4)}, position, material)

    def ground(self, z):
        self.add("ground", {"type": "plane"}, (0, 0, z), "asphalt")

    def part(self, foot, yaw, forward, left, up):
        c, s = math.cos(math.radians(yaw)), math.sin(math.radians(yaw))
        return (foot[0] + c * forward - s * left, foot[1] + s * forward + c * left, foot[2] + up)

    def wheels(self, name, foot, yaw, axles, track, radius, width):
        for axle, x in axles.items():
            for side, y in (("left", track / 2), ("right", -track / 2)):
                self.add(f"{name}-wheel-{axle}-{side}", {"type": "cylinder", "radius_m": radius, "height_m": width},
                         self.part(foot, yaw, x, y, radius), "tyre", yaw, 0.0, 90.0)

    def car(self, name, foot, yaw=0.0, paint="car-paint", length=4.5, width=1.8, height=1.5):
        """Body to the belt line, cabin, wheels: the proportions of model/scene/refined_shapes.h."""
        low, belt = 0.18, 0.62 * height
        self.box(f"{name}-body", (length, width, belt - low), self.part(foot, yaw, 0, 0, (belt + low) / 2), paint, yaw)
        self.box(f"{name}-cabin", (0.55 * length, 0.85 * width, height - belt),
                 self.part(foot, yaw, -0.05 * length, 0, (belt + height) / 2), "car-window", yaw)
        self.wheels(name, foot, yaw, {"rear": -0.29 * length, "front": 0.31 * length}, width - 0.2, 0.316, 0.2)

    def truck(self, name, foot, yaw=0.0, length=12.0, width=2.5, height=3.8):
        cab, load = 0.24 * length, 0.72 * length
        self.box(f"{name}-cab", (cab, width, 0.85 * height - 0.3),
                 self.part(foot, yaw, (length - cab) / 2, 0, (0.85 * height + 0.3) / 2), "car-paint", yaw)
        self.box(f"{name}-load", (load, width, height - 1.0),
                 self.part(foot, yaw, (load - length) / 2, 0, (height + 1.0) / 2), "tarpaulin", yaw)
        self.wheels(name, foot, yaw, {"rear": -0.3 * length, "front": 0.36 * length}, width - 0.3, 0.506, 0.3)

    def person(self, name, foot, height=1.75):
        head = height / 16
        self.post(f"{name}-body", 0.22, height - 2 * head, foot, "clothing")
        self.ball(f"{name}-head", head, (foot[0], foot[1], foot[2] + height - head), "skin")

    def tree(self, name, foot, height=8.0, crown=2.2):
        self.post(f"{name}-trunk", 0.15, height - crown, foot, "bark")
        self.ball(f"{name}-crown", crown, (foot[0], foot[1], foot[2] + height - crown), "foliage")


def measurands(*names):
    known = {"range": ("range_m", "m", "ratio", 0.01), "epw": ("epw_m", "m", "interval", 0.04),
             "intensity": ("intensity", "nW", "ratio", 1)}
    return [dict(zip(("name", "column", "unit", "scale", "resolution"), (n, *known[n]))) for n in names]


def compact(value, indent=0):
    """JSON in which whatever fits into a line stands in one."""
    line = json.dumps(value, ensure_ascii=False)
    if len(line) + indent <= 118 or not isinstance(value, (dict, list)):
        return line
    pad = " " * (indent + 2)
    if isinstance(value, dict):
        inner = [f"{pad}{json.dumps(k)}: {compact(v, indent + 2)}" for k, v in value.items()]
        return "{\n" + ",\n".join(inner) + "\n" + " " * indent + "}"
    return "[\n" + ",\n".join(pad + compact(v, indent + 2) for v in value) + "\n" + " " * indent + "]"


def write(name, title, source, scene, samples, model, sensor, environment=None, gates=(), quantities=("range", "epw")):
    used = {o["material"] for o in scene.objects}
    materials = {m: {"reflectivity": MATERIALS[m]} for m in sorted(used & MATERIALS.keys())}
    if "retroreflector" in used:
        materials["retroreflector"] = RETROREFLECTOR
    experiment = {"format": "fidelis-experiment", "version": 1, "id": name, "title": title,
                  "source": "scene: " + source + " Written by resources/scenes/make_scenes.py; places and reflectivities "
                            "are invented, nothing was measured.",
                  "sensor": sensor, "measurands": measurands(*quantities)}
    if environment:
        experiment["environment"] = environment
    experiment |= {"materials": materials, "scene": scene.objects}
    if gates:
        experiment["gates"] = list(gates)
    experiment["samples"] = samples
    folder = HERE / name
    folder.mkdir(exist_ok=True)
    (folder / "experiment.json").write_text(compact(experiment) + "\n", encoding="utf-8")
    rays, effects = model
    (folder / "model.json").write_text(compact({"format": "fidelis-model", "version": 1, "id": name + "-baseline",
                                                "sensor": sensor, "rays_per_beam": rays, "seed": 1,
                                                "effects": effects}) + "\n", encoding="utf-8")


def wall():
    scene = Scene()
    scene.add("wall", {"type": "rectangle", "width_m": 6.0, "height_m": 3.0}, (10, 0, 0), "plaster")
    write("wall", "One wall across the beam",
          "a plastered wall of 6 m by 3 m, 10 m ahead and square to the sensor's axis: the first thing to try.",
          scene, [{"id": "wall", "frames": 50}], ([3, 11], {"beam-divergence": {}, "pulse-broadening": {}}),
          "demo-scanner", gates=[{"id": "wall", "object": "wall", "margin_m": 0.1}],
          quantities=("range", "epw", "intensity"))


def hangar():
    scene = Scene()
    scene.add("target", {"type": "rectangle", "width_m": 1.0, "height_m": 1.0}, (5, 0, 0), "board")
    scene.ground(-1.2)
    for side, y in (("left", 9.0), ("right", -9.0)):
        scene.box(f"wall-{side}", (80, 0.2, 8), (30, y, 2.8), "concrete")
        for i in range(8):
            scene.post(f"pillar-{side}-{i}", 0.25, 8.0, (5.0 + 8.0 * i, y * 0.93, -1.2), "metal")
    scene.box("gate", (0.2, 18, 8), (70, 0, 2.8), "metal")
    for i in range(8):
        scene.box(f"truss-{i}", (0.2, 18, 0.4), (5.0 + 8.0 * i, 0, 6.0), "metal")
    samples = []
    for i, distance in enumerate((2.5, 5, 7.5, 10, 15, 20, 25, 30, 40, 50, 60)):
        samples.append({"id": f"r{distance:g}".replace(".", "_"), "role": "calibration" if i % 3 == 1 else "validation",
                        "parameters": {"range_m": distance},
                        "patch": [{"op": "replace", "path": "/scene/0/pose/position_m/0", "value": distance}],
                        "epistemic": [{"path": "/scene/0/pose/position_m/0", "offset_interval": [-0.002, 0.002]}],
                        "frames": 20})
    write("hangar-sweep", "Range sweep of a board in a hangar",
          "a grey board of 1 m by 1 m at eleven ranges from 2.5 m to 60 m in a hall with pillars, trusses and a gate.",
          scene, samples, ([3, 11], {"beam-divergence": {}, "pulse-broadening": {}}), "ibeo-lux-2010",
          gates=[{"id": "target", "object": "target", "margin_m": 0.15}])


def parked_cars():
    scene = Scene()
    scene.ground(-0.6)
    scene.car("front", (12.0, 0.0, -0.6))
    scene.car("rear", (22.0, 1.2, -0.6), paint="black-paint")
    write("parked-cars", "Two parked cars, one half hidden behind the other",
          "a car 12 m ahead hides the right part of a black one at 22 m, which stands 1.2 m further left; the sensor sits "
          "in the bumper, 0.6 m above the road.",
          scene, [{"id": "parked", "frames": 20}], ([3, 11], {"beam-divergence": {}, "pulse-broadening": {}}),
          "ibeo-lux-2010",
          gates=[{"id": "front", "object": "front-body", "margin_m": 0.1},
                 {"id": "rear", "object": "rear-body", "margin_m": 0.1}])


def crossing():
    scene, rng, z = Scene(), random.Random(1), -1.8
    scene.ground(z)
    for qx in (1, -1):  # four corners: houses along both streets, pavement, trees, lights, signs
        for qy in (1, -1):
            corner = f"{'front' if qx > 0 else 'back'}-{'left' if qy > 0 else 'right'}"
            scene.box(f"pavement-x-{corner}", (50, 3, 0.12), (qx * 33, qy * 8.5, z + 0.06), "concrete")
            scene.box(f"pavement-y-{corner}", (3, 40, 0.12), (qx * 8.5, qy * 30, z + 0.06), "concrete")
            for i in range(4):
                height = rng.uniform(9, 18)
                scene.box(f"house-x-{corner}-{i}", (12, 10, height), (qx * (16.2 + 12.2 * i), qy * 15.2, z + height / 2),
                          "plaster")
                for k in range(3):
                    scene.box(f"bay-x-{corner}-{i}-{k}", (1.4, 0.5, 2.0),
                              (qx * (12.5 + 12.2 * i + 3.5 * k), qy * 10.0, z + 4.5), "car-window")
                if i > 0:
                    height = rng.uniform(9, 18)
                    scene.box(f"house-y-{corner}-{i}", (10, 10, height), (qx * 15.2, qy * (15.2 + 10.4 * i),
                                                                        z + height / 2), "plaster")
                scene.tree(f"tree-{corner}-{i}", (qx * (16 + 11 * i), qy * 7.6, z), rng.uniform(6, 9), 1.8)
            scene.post(f"light-pole-{corner}", 0.06, 3.2, (qx * 7.4, qy * 7.4, z), "metal")
            scene.box(f"light-{corner}", (0.3, 0.3, 0.9), (qx * 7.4, qy * 7.4, z + 3.6), "black-paint")
            scene.post(f"lamp-{corner}", 0.08, 7.0, (qx * 22, qy * 7.2, z), "metal")
            scene.post(f"sign-pole-{corner}", 0.04, 2.4, (qx * 12, qy * 7.3, z), "metal")
            scene.add(f"sign-{corner}", {"type": "rectangle", "width_m": 0.6, "height_m": 0.6},
                      (qx * 12, qy * 7.3, z + 2.4), "retroreflector")
            for i in range(5):
                paint = rng.choice(("car-paint", "car-paint", "black-paint"))
                scene.car(f"parked-{corner}-{i}", (qx * (14.5 + 6.2 * i), qy * 5.9 + rng.uniform(-0.1, 0.1), z),
                          0.0 if qy < 0 else 180.0, paint)
            for i in range(3):
                scene.velocity = (0, rng.choice((-1.3, 1.3)), 0)
                scene.person(f"person-{corner}-{i}", (qx * rng.uniform(9, 30), qy * rng.uniform(7.6, 9.6), z + 0.12),
                             rng.uniform(1.6, 1.9))
            scene.velocity = (0, 0, 0)
    for i, (x, y, yaw, speed) in enumerate(((16, -1.75, 0, 9), (33, -1.75, 0, 11), (-14, -1.75, 0, 8), (24, 1.75, 180, 12),
                                            (9.5, 14, 270, 6), (6.6, -13, 90, 7))):
        c, s = math.cos(math.radians(yaw)), math.sin(math.radians(yaw))
        scene.velocity = (speed * c, speed * s, 0)
        scene.car(f"moving-{i}", (x, y, z), yaw)
    scene.velocity = (0, 0, 0)
    write("urban-crossing", "Crossing of two streets in a town",
          "the sensor stands on a car's roof before a crossing, 1.8 m above the road: houses with bays, trees, lamps, "
          "lights, signs, parked and moving cars, people on the pavements.",
          scene, [{"id": "noon", "frames": 2}], ([3, 3], {"beam-divergence": {}, "pulse-broadening": {}}), ROUND_SENSOR,
          quantities=("range",))


def motorway():
    scene, z = Scene(), -1.5
    scene.ground(z)
    for name, y in (("near", -2.2), ("middle", 17.5), ("far", 37.2)):
        scene.box(f"rail-{name}", (200, 0.1, 0.31), (90, y, z + 0.6), "metal")
        for i in range(20):
            scene.post(f"rail-{name}-post-{i}", 0.05, 0.45, (-5 + 10 * i, y, z), "metal")
    for i in range(8):  # reflector posts every 25 m: their reflectors look at the traffic
        for name, y in (("near", -2.8), ("far", 37.8)):
            scene.box(f"post-{name}-{i}", (0.12, 0.1, 1.0), (12.5 + 25 * i, y, z + 0.5), "plaster")
            scene.add(f"reflector-{name}-{i}", {"type": "rectangle", "width_m": 0.05, "height_m": 0.18},
                      (12.5 + 25 * i - 0.07, y, z + 0.85), "retroreflector")
    scene.box("bridge", (8, 60, 1.5), (120, 17.5, z + 6.0), "concrete")
    for i, y in enumerate((-4.0, 17.5, 39.0)):
        scene.box(f"bridge-pier-{i}", (6, 0.8, 5.25), (120, y, z + 2.6), "concrete")
    lanes = (1.75 + 2.5, 5.5 + 2.5, 9.25 + 2.5)  # hard shoulder of 2.5 m, lanes of 3.75 m
    vehicles = ((0, 25, "truck", 24), (0, 62, "truck", 24), (1, 18, "car", 33), (1, 48, "car", 32), (1, 95, "car", 34),
                (2, 35, "car", 39), (2, 80, "car", 41))
    for i, (lane, x, kind, speed) in enumerate(vehicles):
        scene.velocity = (speed, 0, 0)
        getattr(scene, kind)(f"ahead-{i}", (x, lanes[lane], z))
    for i, (lane, x, kind, speed) in enumerate(vehicles):
        scene.velocity = (-speed, 0, 0)
        getattr(scene, kind)(f"oncoming-{i}", (x + 7, 35.0 - lanes[lane], z), 180.0)
    scene.velocity = (0, 0, 0)

    def weather(name, visibility, rain):
        return {"id": name, "parameters": {"visibility_m": visibility, "rain_rate_mm_h": rain},
                "patch": [{"op": "replace", "path": "/environment/visibility_m", "value": visibility},
                          {"op": "replace", "path": "/environment/rain_rate_mm_h", "value": rain}], "frames": 5}

    write("motorway", "Motorway in clear air, fog and rain",
          "the sensor stands on the hard shoulder, 1.5 m above the road, and looks along the traffic: cars and lorries with "
          "their speeds over ground, rails, reflector posts, a bridge. Clear air, fog and rain are samples of one scene; "
          "wet roads and spray are effects that the model switches on (fidelis effects).",
          scene, [weather("clear", 20000, 0), weather("haze", 1000, 0), weather("fog", 150, 0), weather("rain", 4000, 15)],
          ([3, 11], {"beam-divergence": {}, "pulse-broadening": {}, "atmospheric-attenuation": {}}), "demo-scanner",
          environment={"temperature_degC": 8, "visibility_m": 20000, "rain_rate_mm_h": 0,
                       "background_irradiance_w_m2_nm": None}, quantities=("range", "epw", "intensity"))


for make in (wall, hangar, parked_cars, crossing, motorway):
    make()
