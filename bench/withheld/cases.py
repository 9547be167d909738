"""Draws cases: a scene, a sensor, a baseline model, and the cause that the world has and the model has not.

A slot (class, name, number) and the seed give a case; its id is a meaningless number. Classes:

  effect      one effect of the library withheld
  pair        two effects withheld
  parameter   a wrong value in the model under test: of the sensor, a material, or an effect that it has
  reference   a target stands elsewhere than recorded, everywhere or per set-up
  none        nothing missing, with and without set-up scatter
  outside     an effect that no library has (a law put on the data, or x-... of the foreign generator)
  removed     an effect withheld from the model, and from the library too
  hidden      an effect withheld, and the baseline recalibrated so that the mean of one channel agrees
  ambiguous   a design that cannot tell: one range, one channel
  beside      two sensors side by side, set-up by set-up: an effect of one of them, of both, a reference error that both
              see, or nothing

`Draft.cause(u)` says what the true world has at strength u (0 barely, 1 strong) beyond the baseline. The two of a pair have a
strength each: at one strength for both, one of them mostly hides the other.
"""

import copy
import random
from dataclasses import dataclass, field

import effects
import outside
import packages
import recorded
import scenes
import sensors

CLASSES = {"effect": 0.48, "pair": 0.10, "parameter": 0.10, "reference": 0.10, "none": 0.08, "outside": 0.04, "removed": 0.04,
           "hidden": 0.04, "ambiguous": 0.02, "beside": 0.06}
PARAMETERS = ["reflectivity", "emitter/peak_power_w", "receiver/threshold_w", "receiver/noise_w", "detection/range_noise_m",
              "detection/epw_noise_m", "emitter/pulse_fwhm_ns", "visibility_m"]
BUDGET = 3000  # about so many beams of all frames in a sample
REFERENCES = ["everywhere", "per-setup"]
BESIDE = ["one", "one", "both", "reference", "nothing"]
SIGMAS_KNOWN = 2  # standard deviations of set-ups: half of the interval that is recorded
AMBIGUOUS = ["range-offset", "clock-drift", "reference", "atmospheric-attenuation", "reflectivity"]


@dataclass
class Cause:
    """What the true world has beyond the recorded experiment and the baseline."""
    effects: dict = field(default_factory=dict)
    put: list = field(default_factory=list)      # (pointer, true value), in the experiment, and in the model where it has it
    offsets: dict = field(default_factory=dict)  # {pointer: {"everywhere": x, "per_setup": {...}}}
    after: object = None                         # law on the detections
    parameters: dict = field(default_factory=dict)
    where: dict = field(default_factory=dict)


@dataclass
class Draft:
    experiment: dict
    baseline: dict
    family: str
    kind: str
    names: list
    cause: object  # strength -> Cause; of a pair: {name: strength} -> Cause
    scatter: dict  # {pointer: standard deviation over set-ups}
    library: list = field(default_factory=list)  # effects left out of the library
    hide_by: str = ""                            # pointer of what is recalibrated
    sensors: list = field(default_factory=list)  # on which alone the effect exists
    members: dict = field(default_factory=dict)  # of a pair, {name: strength -> Cause}: each by itself


# What both sensors have (weather) or what the geometry of both hangs on is not given to one of them.
NEVER_BESIDE = ["beam-divergence", "pulse-broadening", "atmospheric-attenuation", "atmospheric-backscatter", "precipitation-clutter",
                "road-spray", "exhaust-cloud", "angular-reflection", "transmission", "multipath", "retroreflection"]


class Impossible(Exception):
    """This draw cannot show what was asked for; draw again."""


def laws_of(generator):
    return tuple(outside.LAWS) + (tuple(outside.FOREIGN) if generator == "foreign" else ())


def names_of(class_name, laws=laws_of("foreign")):
    """What a class goes through in turn."""
    return {"effect": list(effects.LIBRARY), "removed": list(effects.LIBRARY), "pair": ["two"], "parameter": PARAMETERS,
            "reference": REFERENCES, "none": ["scatter", "quiet"], "outside": list(laws), "hidden": effects.WEAKENING,
            "ambiguous": AMBIGUOUS, "beside": BESIDE}[class_name]


def slots(seed, classes=None, names=None, laws=laws_of("own")):
    """Endless, the same from the start for any count: (class, name, number)."""
    rng = random.Random(f"slots/{seed}/{sorted(classes or [])}/{sorted(names or [])}")
    chosen = [c for c in CLASSES if not classes or c in classes]
    decks, numbers = {}, {}
    while True:
        class_name = rng.choices(chosen, [CLASSES[c] for c in chosen])[0]
        allowed = [n for n in names_of(class_name, laws) if not names or n in names or class_name == "pair"]
        if not allowed:
            chosen.remove(class_name)
            if not chosen:
                raise ValueError("no class has any of these names: " + ", ".join(names))
            continue
        deck = decks.setdefault(class_name, [])
        if not deck:
            deck.extend(rng.sample(allowed, len(allowed)))
        name = deck.pop()
        numbers[class_name, name] = numbers.get((class_name, name), 0) + 1
        yield class_name, name, numbers[class_name, name]


def everyday(rng, scene, profile):
    """Effects that the baseline has."""
    present = dict(scene.effects)
    if rng.random() < 0.9:
        present["beam-divergence"] = {}
    if rng.random() < 0.6 and "beam-divergence" in present:
        present["pulse-broadening"] = {}
    for name, share, u in (("atmospheric-attenuation", 0.12, 0.35), ("pulse-jitter", 0.1, 0.3), ("detection-loss", 0.06, 0.4),
                           ("range-walk", 0.08, 0.2), ("speckle", 0.06, 0.3), ("false-alarm", 0.04, 0.2)):
        if rng.random() < share and effects.possible(name, scene, profile):
            present[name] = effects.LIBRARY[name][1](rng, context_of(scene, profile))(u)
    return present


def context_of(scene, profile):
    ranges = [v for parameters, patch in scene.samples for p, v in patch if p.endswith("position_m/0")]
    return effects.Context(scene, profile, min(ranges), max(ranges))


def samples_of(rng, scene, profile, most_frames=30):
    """Roles by set-up, a third held out, in no order that says anything."""
    count = len(scene.samples)
    shared = rng.random() < 0.25
    setups = [f"setup-{(i // 2) + 1}" if shared and i < count - 4 else f"setup-{i + 1}" for i in range(count)]
    distinct = sorted(set(setups))
    held = set(rng.sample(distinct, max(2, round(len(distinct) / 3))))
    frames = max(5, min(most_frames, round(BUDGET / sensors.beams(profile) * rng.uniform(0.7, 1.4))))
    known_m = rng.choice([0.002, 0.005, 0.01])
    result = []
    for i, (parameters, patch) in enumerate(scene.samples):
        sample = {"id": f"s{i + 1:02d}", "role": "prediction" if setups[i] in held else rng.choice(["calibration", "validation"]),
                  "setup": setups[i], "parameters": parameters,
                  "patch": [{"op": "replace", "path": p, "value": v} for p, v in patch],
                  "epistemic": [{"path": scene.references[0], "offset_interval": [-known_m, known_m]}],
                  "frames": frames, "measurements": f"measurements/s{i + 1:02d}.csv.gz"}
        result.append(sample)
    return result, known_m


def package(rng, scene, profile):
    samples, known_m = samples_of(rng, scene, profile)
    return {"format": "fidelis-experiment", "version": 1, "id": "case", "title": "synthetic case", "source": "synthetic",
            "sensor": profile, "measurands": sensors.measurands(profile),
            "environment": {"temperature_degC": 20, "visibility_m": None, "rain_rate_mm_h": None,
                            "background_irradiance_w_m2_nm": None},
            "materials": scene.materials, "scene": scene.objects, "samples": samples}, known_m


def draw(seed, slot, attempt, given=()):
    """The draft of a slot. `given`: packages (recorded.py) whose scenes and sensors take the place of the families here. Raises
    Impossible."""
    class_name, name, number = slot
    rng = random.Random(f"case/{seed}/{class_name}/{name}/{number}/{attempt}")
    draft, scene = draw_recorded(rng, rng.choice(given)) if given else draw_invented(rng, class_name, name)
    if class_name == "beside":
        put_beside(rng, draft, scene, draft.baseline["sensor"])
    MAKERS[class_name](rng, draft, scene, name)
    return draft


def draw_invented(rng, class_name, name):
    """(draft without a cause, scene)"""
    family = rng.choice(list(scenes.FAMILIES))
    if class_name == "ambiguous":
        family = "range-sweep"
    scene = scenes.FAMILIES[family](rng)
    profile = sensors.draw(rng, scene)
    if class_name == "ambiguous":
        make_ambiguous(rng, scene, profile, name)
    experiment, known_m = package(rng, scene, profile)
    present = everyday(rng, scene, profile)
    baseline = {"format": "fidelis-model", "version": 1, "id": "baseline", "sensor": profile,
                "rays_per_beam": rng.choice([[11, 11], [11, 15]]), "seed": rng.randint(1, 10**6), "effects": present}
    scatter = {scene.references[0]: known_m / SIGMAS_KNOWN} if rng.random() < 0.9 else {}
    return Draft(experiment, baseline, family, "none", [], lambda u: Cause(), scatter), scene


def draw_recorded(rng, given):
    """The same in the scene of a package, with its sensor and the effects that its model has."""
    scene, experiment = recorded.scene_of(given), recorded.package_of(rng, given)
    baseline = copy.deepcopy(given.model) | {"id": "baseline", "seed": rng.randint(1, 10**6)}
    known_m = recorded.tolerance_m(experiment)
    scatter = {scene.references[0]: known_m / SIGMAS_KNOWN} if known_m else {}
    return Draft(experiment, baseline, given.name, "none", [], lambda u: Cause(), scatter), scene


def put_beside(rng, draft, scene, profile):
    """A second sensor: it measures every set-up as well, with the same measurands and another power, noise and scan."""
    other = copy.deepcopy(profile)
    other["emitter"]["peak_power_w"] = effects.digits(profile["emitter"]["peak_power_w"] * rng.uniform(0.7, 1.5))
    other["detection"]["range_noise_m"] = round(profile["detection"]["range_noise_m"] * rng.uniform(0.7, 1.5), 4)
    for layer in other["scan"]["layers"]:
        layer["azimuth_deg"]["step"] = round(layer["azimuth_deg"]["step"] * rng.uniform(1.0, 1.4), 3)
    for document in (draft.experiment, draft.baseline):
        del document["sensor"]
        document["sensors"] = {"left": copy.deepcopy(profile), "right": other}
    samples = []
    for sample in draft.experiment["samples"]:
        for sensor in ("left", "right"):
            own = copy.deepcopy(sample)
            own.update(id=f"{sample['id']}-{sensor}", sensor=sensor, frames=max(5, sample["frames"] // 2),
                       measurements=f"measurements/{sample['id']}-{sensor}.csv.gz")
            samples.append(own)
    draft.experiment["samples"] = samples


def make_ambiguous(rng, scene, profile, name):
    """One range only, and one channel that could tell."""
    single = rng.choice(scene.samples)
    scene.samples = [copy.deepcopy(single) for _ in range(8)]
    scene.shows.add("ranges")
    profile["detection"]["output"] = ["range"] if name in ("range-offset", "clock-drift", "reference") else ["range", "epw"]


def a_sensor(draft):
    return draft.baseline["sensor"] if "sensor" in draft.baseline else draft.baseline["sensors"]["left"]


def withhold(rng, draft, scene, name):
    """The effect as a strength -> (name, parameters), and out of the baseline."""
    profile = a_sensor(draft)
    if not effects.possible(name, scene, profile):
        raise Impossible(name)
    draft.baseline["effects"].pop(name, None)
    if name == "pulse-broadening":
        draft.baseline["effects"]["beam-divergence"] = {}
    if name == "beam-divergence":
        draft.baseline["effects"].pop("pulse-broadening", None)
    return effects.LIBRARY[name][1](rng, context_of(scene, profile))


def where_of(name, parameters):
    if name == "cover-contamination":
        return {"covariate": "azimuth_deg", "stratum": [parameters["azimuth_from_deg"], parameters["azimuth_to_deg"]]}
    if name in ("blinding", "spoofing"):
        half = parameters["width_deg"] / 2
        return {"covariate": "azimuth_deg", "stratum": [parameters["azimuth_deg"] - half, parameters["azimuth_deg"] + half]}
    return {}


def make_effect(rng, draft, scene, name):
    recipe = withhold(rng, draft, scene, name)
    draft.kind, draft.names = "effect", [name]
    draft.cause = lambda u: Cause(effects={name: recipe(u)}, parameters=recipe(u), where=where_of(name, recipe(u)))


def make_pair(rng, draft, scene, name):
    able = [n for n in effects.LIBRARY if effects.possible(n, scene, draft.baseline["sensor"])]
    pair = rng.sample([n for n in able if n not in ("beam-divergence", "pulse-broadening")], 2)
    recipes = {n: withhold(rng, draft, scene, n) for n in pair}
    draft.kind, draft.names = "effect", sorted(pair)
    draft.members = {n: lambda u, n=n, r=r: Cause(effects={n: r(u)}) for n, r in recipes.items()}
    together = lambda strengths: {n: r(strengths[n]) for n, r in recipes.items()}
    draft.cause = lambda strengths: Cause(effects=together(strengths), parameters=together(strengths))


def make_removed(rng, draft, scene, name):
    make_effect(rng, draft, scene, name)
    inner = draft.cause
    draft.kind, draft.names, draft.library = "unknown", [], [name]
    draft.cause = inner


def make_hidden(rng, draft, scene, name):
    profile = draft.baseline["sensor"]
    if not {"epw", "intensity"} & set(profile["detection"]["output"]):
        raise Impossible("no channel to recalibrate")
    make_effect(rng, draft, scene, name)
    single = len(scene.materials) == 1
    draft.hide_by = f"/materials/{next(iter(scene.materials))}/reflectivity" if single else "/sensor/emitter/peak_power_w"


def make_parameter(rng, draft, scene, name):
    profile, up = draft.baseline["sensor"], rng.choice([-1, 1])
    output = profile["detection"]["output"]
    if name == "reflectivity":
        material = draft.experiment["scene"][int(scene.references[0].split("/")[2])]["material"]
        pointer, most = f"/materials/{material}/reflectivity", 3.0
        up = -1 if scene.materials[material]["reflectivity"] > 0.32 else up
    elif name == "visibility_m":
        if "ranges" not in scene.shows:
            raise Impossible(name)
        draft.baseline["effects"]["atmospheric-attenuation"] = {"visibility_m": round(rng.uniform(300, 2000))}
        pointer, most = "/effects/atmospheric-attenuation/visibility_m", 6.0
    else:
        if name.endswith("epw_noise_m") and "epw" not in output:
            raise Impossible(name)
        pointer, most = "/sensor/" + name, 8.0 if "noise" in name else 2.5
        if name.endswith("fwhm_ns"):
            most = 1.5
        if name == "receiver/noise_w" and up > 0:
            most = 3.0
    document = draft.baseline if pointer.startswith(("/effects", "/sensor")) else draft.experiment
    recorded = packages.get(document, pointer)
    true = lambda u: effects.digits(recorded * effects.between(1.01, most)(u) ** up)
    draft.kind, draft.names = "parameter", [pointer]
    where = {"covariate": "material", "stratum": [pointer.split("/")[2]]} if name == "reflectivity" and len(scene.materials) > 1 else {}
    draft.cause = lambda u: Cause(put=[(pointer, true(u))], parameters={"value": true(u), "recorded": recorded}, where=where)


def make_reference(rng, draft, scene, name):
    pointer = rng.choice(scene.references)
    angle = "yaw_pitch_roll" in pointer
    setups = sorted({packages.setup_of(s) for s in draft.experiment["samples"]})
    unit = (0.2, 6.0) if angle else (0.015, 0.5)
    if name == "everywhere":
        sign = rng.choice([-1, 1])
        offset = lambda u: {pointer: {"everywhere": sign * effects.between(*unit)(u)}}
    else:
        parts = {s: rng.gauss(0, 1) for s in setups}
        offset = lambda u: {pointer: {"per_setup": {s: effects.digits(effects.between(*unit)(u) * g) for s, g in parts.items()}}}
    draft.kind, draft.names = "reference", [pointer]
    draft.cause = lambda u: Cause(offsets=offset(u), parameters=offset(u)[pointer])


def make_none(rng, draft, scene, name):
    known_m = recorded.tolerance_m(draft.experiment)
    draft.scatter = {} if name == "quiet" or not known_m else {scene.references[0]: known_m / SIGMAS_KNOWN}


def make_outside(rng, draft, scene, name):
    draft.kind, draft.names = "unknown", []
    if name.startswith("x-"):
        needs, recipe = outside.FOREIGN[name]
        if not needs <= effects.traits(scene, draft.baseline["sensor"]):
            raise Impossible(name)
        values = recipe(rng, context_of(scene, draft.baseline["sensor"]))
        draft.cause = lambda u: Cause(effects={name: values(u)}, parameters={"law": name, **values(u)})
        return
    law = outside.LAWS[name](rng)
    draft.cause = lambda u: Cause(after=lambda table: law(table, u), parameters={"law": name, "strength": round(u, 3)})


def make_of_ambiguous(rng, draft, scene, name):
    if name == "reference":
        make_reference(rng, draft, scene, "everywhere")
    elif name == "reflectivity":
        make_parameter(rng, draft, scene, name)
    else:
        make_effect(rng, draft, scene, name)


def make_beside(rng, draft, scene, name):
    if name == "nothing":
        return
    if name == "reference":
        make_reference(rng, draft, scene, "per-setup")
        return
    profile = a_sensor(draft)
    able = [n for n in effects.LIBRARY if effects.possible(n, scene, profile) and n not in NEVER_BESIDE]
    effect = rng.choice(able)
    recipe = withhold(rng, draft, scene, effect)
    sensor = rng.choice(["left", "right"])
    part = {"sensors": [sensor]} if name == "one" else {}
    draft.kind, draft.names = "effect", [effect]
    draft.sensors = part.get("sensors", [])
    draft.cause = lambda u: Cause(effects={effect: {**recipe(u), **part}}, parameters=recipe(u), where=where_of(effect, recipe(u)))


MAKERS = {"effect": make_effect, "pair": make_pair, "parameter": make_parameter, "reference": make_reference, "none": make_none,
          "outside": make_outside, "removed": make_removed, "hidden": make_hidden, "ambiguous": make_of_ambiguous,
          "beside": make_beside}


def truth_world(draft, cause):
    """(experiment, model) as they truly are, set-up scatter not included."""
    experiment, model = copy.deepcopy(draft.experiment), copy.deepcopy(draft.baseline)
    for pointer, value in cause.put:
        if pointer.startswith(("/sensor", "/effects")):
            packages.put(model, pointer, value)
        if pointer.startswith(("/sensor", "/materials")):
            packages.put(experiment, pointer, value)
    model["effects"].update(copy.deepcopy(cause.effects))
    return packages.displaced(experiment, cause.offsets), model


def scattered(rng, experiment, scatter):
    """The world with each set-up a little off, anew at every call; within the interval that is recorded of it, for beyond that a
    reference is wrong (effects.md)."""
    setups = sorted({packages.setup_of(s) for s in experiment["samples"]})
    within = lambda sigma: round(sigma * max(-SIGMAS_KNOWN, min(SIGMAS_KNOWN, rng.gauss(0, 1))), 5)
    offsets = {p: {"per_setup": {s: within(sigma) for s in setups}} for p, sigma in scatter.items()}
    return packages.displaced(experiment, offsets)
