"""Scenes and sensors of packages that are there already (`--scenes FOLDER`, FOLDER/NAME/experiment.json with model.json beside it):
what stands there, what is varied and what it can show. Their measurements are not used, and the cause is drawn anew.
"""

import copy
from dataclasses import dataclass

import packages
import scenes

WIDE = 4       # breadth over nearest range from which a surface is seen under many angles
VARIED = 1.15  # farthest over nearest place from which ranges count as varied


@dataclass
class Recorded:
    name: str
    experiment: dict
    model: dict


def read(folder):
    """All packages of a folder that has one sensor each, by name."""
    found = []
    for path in sorted(folder.glob("*/experiment.json")):
        experiment = packages.read(path)
        if "sensor" in experiment:
            found.append(Recorded(path.parent.name, experiment, packages.read(path.parent / "model.json")))
    return found


def place(experiment, sample, i):
    return packages.value_in(experiment, sample, scenes.x_of(i))


def shows(experiment, nearest_m, farthest_m):
    """Traits that effects ask for (scenes.py)."""
    materials = list(experiment["materials"].values())
    grey = [m["reflectivity"] for m in materials if m["reflectivity"] > 0]
    models = {m.get("brdf", {}).get("model") for m in materials}
    turned = {o["value"] for s in experiment["samples"] for o in s["patch"] if "yaw_pitch_roll" in o["path"]}
    breadth = max((o["shape"].get("width_m", 0) for o in experiment["scene"]), default=0)
    found = {"edges"}  # something ends somewhere in every scene; where nothing shows of it, severity says so
    found |= {"ranges"} if farthest_m > VARIED * nearest_m else set()
    found |= {"angles"} if len(turned) > 2 or breadth > WIDE * nearest_m else set()
    found |= {"contrast"} if max(grey) > 1.5 * min(grey) else set()
    found |= {"moving", "fast"} if any(o.get("velocity_m_s") for o in experiment["scene"]) else set()
    found |= {"retro"} if "retroreflector" in models else set()
    found |= {"pane"} if any(m.get("transmission") for m in materials) else set()
    return found


def scene_of(recorded):
    """As scenes.FAMILIES draw them; `samples` are what effects.Context asks for."""
    experiment = recorded.experiment
    things = range(len(experiment["scene"]))
    ranges = [place(experiment, s, i) for s in experiment["samples"] for i in things]
    azimuths = [layer["azimuth_deg"] for layer in experiment["sensor"]["scan"]["layers"]]
    return scenes.Scene(
        experiment["materials"], experiment["scene"],
        [(s.get("parameters", {}), [(scenes.x_of(i), place(experiment, s, i)) for i in things]) for s in experiment["samples"]],
        shows(experiment, min(ranges), max(ranges)), max(ranges), max(abs(a[end]) for a in azimuths for end in ("from", "to")), (-3, 3),
        references=[scenes.x_of(i) for i in things] + [scenes.yaw_of(i) for i in things if experiment["scene"][i]["pose"].get("yaw_pitch_roll_deg")])


def package_of(rng, recorded):
    """The package without its name, its roles in another order."""
    experiment = copy.deepcopy(recorded.experiment)
    experiment.update(id="case", title="synthetic case", source="synthetic")
    roles = [s["role"] for s in experiment["samples"]]
    rng.shuffle(roles)
    for sample, role in zip(experiment["samples"], roles):
        sample["role"] = role
    return experiment


def tolerance_m(experiment):
    """Half the width of the interval in which the first recorded quantity may stand; 0 where places are recorded as exact."""
    return max((e["offset_interval"][1] for s in experiment["samples"] for e in s.get("epistemic") or []), default=0.0)
