"""Experiment packages as Python values: pointers into them, worlds that differ from what was recorded, tables of detections."""

import copy
import gzip
import json


def steps(pointer):
    return [s.replace("~1", "/").replace("~0", "~") for s in pointer.split("/")[1:]]


def get(document, pointer):
    for step in steps(pointer):
        document = document[int(step)] if isinstance(document, list) else document[step]
    return document


def put(document, pointer, value):
    *way, last = steps(pointer)
    for step in way:
        document = document[int(step)] if isinstance(document, list) else document[step]
    document[int(last) if isinstance(document, list) else last] = value


def setup_of(sample):
    return sample.get("setup", sample["id"])


def value_in(experiment, sample, pointer):
    """What holds in a sample after its patch."""
    for operation in reversed(sample["patch"]):
        if operation["path"] == pointer:
            return operation["value"]
    return get(experiment, pointer)


def displaced(experiment, offsets):
    """The experiment with true minus recorded values added: {pointer: {"everywhere": x, "per_setup": {setup: y}}}."""
    world = copy.deepcopy(experiment)
    for sample in world["samples"]:
        for pointer, offset in offsets.items():
            shift = offset.get("everywhere", 0.0) + offset.get("per_setup", {}).get(setup_of(sample), 0.0)
            if shift:
                value = value_in(world, sample, pointer) + shift
                sample["patch"].append({"op": "replace", "path": pointer, "value": value})
    return world


def only(experiment, roles):
    part = copy.deepcopy(experiment)
    part["samples"] = [s for s in part["samples"] if s["role"] in roles]
    return part


def read(path):
    return json.loads(path.read_text())


def write(path, value):
    """Whole or not at all."""
    path.parent.mkdir(parents=True, exist_ok=True)
    part = path.with_name(path.name + ".part")
    part.write_text(json.dumps(value, indent=1) + "\n")
    part.replace(path)


def read_table(path):
    with gzip.open(path, "rt") if path.name.endswith(".gz") else open(path) as stream:
        names = stream.readline().rstrip("\r\n").split(",")
        rows = [line.rstrip("\r\n").split(",") for line in stream if line.strip()]
    columns = zip(*rows) if rows else [()] * len(names)
    table = {name: [float(x) for x in column] for name, column in zip(names, columns)}
    for name in ("frame", "layer", "azimuth_rad"):
        table.setdefault(name, [])
    return table


def write_table(path, table):
    path.parent.mkdir(parents=True, exist_ok=True)
    form = {"frame": "%d", "layer": "%d", "echo": "%d", "time_s": "%.6f", "azimuth_rad": "%.6f", "elevation_rad": "%.6f"}
    lines = [",".join(table)]
    lines += [",".join(form.get(n, "%.6g") % v for n, v in zip(table, row)) for row in zip(*table.values())]
    with open(path, "wb") as raw, gzip.GzipFile(fileobj=raw, mode="wb", mtime=0, filename="") as stream:
        stream.write(("\n".join(lines) + "\n").encode())
