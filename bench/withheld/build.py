"""Builds cases: searches the strength that has the wanted severity, measures, and writes the case's folder.

  CASES/ID/experiment/   what the tool under test is given, with model.json beside it
  CASES/ID/case.json     the truth, the severity, the class: nothing of it is shown to the tool
  CASES/ID/world/        experiment and model as they truly are
"""

import copy
import dataclasses
import random
import shutil
from pathlib import Path

import cases
import distance
import packages
import severity
import standing
import worlds

ATTEMPTS = 8
LARGEST = 20  # more is redrawn at first: nobody needs a tool to see that
TARGETS = [0.5, 1, 1, 2, 2, 4, 8]
LEAST_OF_A_PAIR = 0.7  # severity of each member, the other one known: what hardly acts nobody can be asked to find
FORMAT = 1
LEAST_DETECTIONS = 40  # in a held-out sample: below it there is no measurement to speak of


def case_id(seed, slot, generator):
    return f"{random.Random(f'id/{seed}/{slot}/{generator}').randrange(10**7):07d}"


class Lab:
    """A draft with its generator: simulates worlds of the held-out samples at a strength."""

    def __init__(self, draft, rng, bin_folder, generator):
        self.draft, self.rng, self.bin, self.generator = draft, rng, bin_folder, generator
        self.held = packages.only(draft.experiment, {"prediction"})

    def run(self, experiment, model, after=None, keep=None, generator=None, seed=None):
        seed = seed or self.rng.randrange(1, 10**9)
        return worlds.simulate(experiment, model, seed, self.bin, generator or self.generator, after, keep)

    def with_and_without(self, world, model, lacking, after=None, generator=None):
        """Held-out samples in the true world, and as recorded by the model that lacks the cause, under the same noise: a cause that
        changes nothing makes no difference."""
        seed = self.rng.randrange(1, 10**9)
        return (self.run(packages.only(world, {"prediction"}), model, after, generator=generator, seed=seed),
                self.run(self.held, lacking, generator=generator, seed=seed))

    def severity_of(self, u, draws, lacking=None):
        """`lacking`: cause that remains in the model (of a pair); None: the baseline."""
        cause = self.draft.cause(u)
        world, model = cases.truth_world(self.draft, cause)
        world = packages.only(world, {"prediction"})
        real = [self.run(cases.scattered(self.rng, world, self.draft.scatter), model, cause.after) for _ in range(draws)]
        partial = copy.deepcopy(self.draft.baseline)
        partial["effects"].update(lacking or {})
        return severity.measure(self.held, real, *self.with_and_without(world, model, partial, cause.after))

    def search(self, target):
        """Strength of about the wanted severity; a few steps of bisection, for severity is noisy and bins are wide. By the
        built-in model where it knows the cause, for it is fast; what counts is the severity that is measured afterwards."""
        if self.generator != "own" and not any(name.startswith("x-") for name in self.draft.cause(0.5).effects):
            fast = Lab(self.draft, self.rng, self.bin, "own")
            return fast.search(target)
        low, high = 0.0, 1.0
        u = 0.5
        for _ in range(5):
            found = self.severity_of(u, 2)["value"]
            if 0.75 * target <= found <= 1.6 * target:
                break
            low, high = (u, high) if found < target else (low, u)
            u = (low + high) / 2
        return u


def recalibrate(lab, cause):
    """Refits one quantity of the baseline so that the mean of one channel agrees on the samples that are not held out."""
    draft, pointer = lab.draft, lab.draft.hide_by
    part = packages.only(draft.experiment, {"calibration", "validation"})
    column = next(m["column"] for m in draft.experiment["measurands"] if m["name"] in ("epw", "intensity"))
    mean = lambda tables: sum(sum(t.get(column, [])) for t in tables.values()) / max(1, sum(len(t["layer"]) for t in tables.values()))
    world, model = cases.truth_world(draft, cause)
    wanted = mean(lab.run(packages.only(world, {"calibration", "validation"}), model))
    document = draft.experiment if pointer.startswith("/materials") else draft.baseline
    nominal = packages.get(document, pointer)
    low, high = 0.05, 1.5 if pointer.startswith("/sensor") else min(1.5, 1 / nominal)
    for _ in range(8):
        factor = (low * high) ** 0.5
        set_value(draft, pointer, nominal * factor)
        set_value_in(part, pointer, nominal * factor)
        low, high = (factor, high) if mean(lab.run(part, draft.baseline)) < wanted else (low, factor)
    lab.held = packages.only(draft.experiment, {"prediction"})


def set_value_in(document, pointer, value):
    if pointer.split("/")[1] in document:
        packages.put(document, pointer, float(f"{value:.4g}"))


def set_value(draft, pointer, value):
    for document in (draft.experiment, draft.baseline):
        set_value_in(document, pointer, value)


def shift_by_measurand(lab, tables, complete, lacking):
    """How much less each measurand deviates beam by beam with the cause in the simulation, in steps of its resolution (existence: per cent)."""
    totals = {}
    for sample in lab.held["samples"]:
        for sign, simulated in ((1, lacking), (-1, complete)):
            parts = distance.beam_by_beam(lab.held["measurands"], tables[sample["id"]], simulated[sample["id"]], sample["frames"])
            for name, deviation in parts.items():
                unit = 100 if name == "existence" else 1 / next(m["resolution"] for m in lab.held["measurands"] if m["name"] == name)
                totals[name] = totals.get(name, 0) + sign * unit * deviation / len(lab.held["samples"])
    return totals


def build(seed, slot, folder, bin_folder, generator="own", given=()):
    """Writes the case and returns (id, text about it); a case that exists is left alone. `given`: packages whose scenes are used."""
    number = case_id(seed, slot, generator)
    home = Path(folder) / number
    if (home / "case.json").exists():
        return number, "is there"
    why = "no draw could show it"
    for attempt in range(ATTEMPTS):
        try:
            text = try_build(seed, slot, attempt, number, home, bin_folder, generator, given)
            if text:
                return number, text
            why = "never visible above the set-up noise"
        except cases.Impossible:
            continue
        except worlds.GeneratorFailed as error:
            why = f"the generator failed: {error}"
    return None, f"{slot[0]} {slot[1]}: {why}"


def try_build(seed, slot, attempt, number, home, bin_folder, generator, given):
    class_name, name, _ = slot
    for again in range(40):  # draws that cannot show the cause cost nothing
        try:
            draft = cases.draw(seed, slot, f"{attempt}.{again}", given)
            break
        except cases.Impossible:
            continue
    else:
        raise cases.Impossible(name)
    rng = random.Random(f"noise/{seed}/{slot}/{attempt}/{generator}")
    lab = Lab(draft, rng, bin_folder, generator)
    visible = draft.kind != "none"
    u = strength_of(lab) if visible else 0.0
    cause = draft.cause(u)
    world, model = cases.truth_world(draft, cause)  # before the baseline is recalibrated
    if draft.hide_by:
        recalibrate(lab, cause)
    held_world = packages.only(world, {"prediction"})
    real = [lab.run(cases.scattered(rng, held_world, draft.scatter), model, cause.after) for _ in range(severity.REPLICATES)]
    complete, lacking = lab.with_and_without(world, model, draft.baseline, cause.after)
    if min(len(table["layer"]) for tables in (lacking, *real) for table in tables.values()) < LEAST_DETECTIONS:
        return None
    s = severity.measure(lab.held, real, complete, lacking)
    s["bin"] = severity.bin_of(s["value"])
    if visible and (s["bin"] is None or s["value"] > LARGEST and attempt < ATTEMPTS // 3):
        return None
    sizes = standing.sizes(lab.held, complete, lacking) if visible else {}
    if visible and not sizes:
        return None  # a handful of echoes from afar moved the pooled gap
    members = {name: severity_beside(lab, u, cause, name) for name in draft.members}
    if any(value < LEAST_OF_A_PAIR for value in members.values()):
        return None
    if home.exists():
        shutil.rmtree(home)
    measured_world = cases.scattered(rng, world, draft.scatter)
    tables = lab.run(measured_world, model, cause.after, keep=home / "experiment")
    packages.write(home / "experiment" / "experiment.json", draft.experiment)
    packages.write(home / "model.json", draft.baseline)
    packages.write(home / "world" / "experiment.json", world)
    packages.write(home / "world" / "model.json", model)
    shifts = shift_by_measurand(lab, tables, complete, lacking)
    largest = max(shifts.values(), default=0)
    packages.write(home / "case.json", {
        "format": "fidelis-withheld-case", "version": FORMAT, "id": number, "class": class_name, "name": name, "family": draft.family,
        "generator": generator, "without": draft.library, "seed": seed, "slot": list(slot), "scatter": draft.scatter,
        "severity": s | {"members": members}, "strength": u,
        "truth": {"kind": draft.kind, "names": draft.names, "parameters": cause.parameters, "where": cause.where, "sensors": draft.sensors,
                  "hidden_by": draft.hide_by, "measurands": [n for n, v in shifts.items() if visible and v > 0.3 * largest],
                  "stands_out": standing.measurands(sizes),
                  "shifts": shifts, "oracle": oracle(lab, tables, world, model, lacking)},
        "detections": sum(len(t["layer"]) for t in tables.values())})
    return f"{class_name} {'+'.join(draft.names) or name} in {draft.family}, severity {s['value']:.2g}"


def strength_of(lab):
    """Of the cause, for a severity drawn at random; of a pair one for each member, as if it were alone."""
    alone = {name: Lab(dataclasses.replace(lab.draft, cause=cause), lab.rng, lab.bin, lab.generator) for name, cause in lab.draft.members.items()}
    if alone:
        return {name: one.search(lab.rng.choice([t for t in TARGETS if t >= 1])) for name, one in alone.items()}
    return lab.search(lab.rng.choice(TARGETS))


def severity_beside(lab, u, cause, name):
    """Severity of one member of a pair, where the model lacks nothing but it."""
    return lab.severity_of(u, 3, {n: p for n, p in cause.effects.items() if n != name})["value"]


def oracle(lab, tables, world, model, lacking):
    """Gap of the held-out measurement without and with the true cause, the latter by the built-in model where it knows it."""
    if lab.draft.kind == "none" or any(name.startswith("x-") for name in model["effects"]):
        return None
    best, base = lab.with_and_without(world, model, lab.draft.baseline, generator="own")
    mean = lambda simulated: sum(severity.gaps(lab.held, tables, simulated)) / len(lab.held["samples"])
    before, after = mean(base), mean(best)
    return {"before": before, "after": after, "shrink": 1 - after / before if before > 0 else 0.0}
