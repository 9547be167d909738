"""Runs `fidelis gap` on cases, one result file per case and program, so that a second call runs only what is missing.

The key of a result is a hash of the case's files, the program's bytes and the options. A crash or a time-out is a result, too.
"""

import copy
import csv
import hashlib
import json
import os
import random
import resource
import shutil
import subprocess
import tempfile
import time
from pathlib import Path

import ablation
import packages
import severity
import worlds

KEEP = ("gap", "where", "verdict", "causes", "shrink", "rest", "next_experiment", "elapsed_s")
TRIED = ("kind", "name", "variant")  # of every hypothesis that was tried, beside what baselines.py judges by


def digest(*files):
    h = hashlib.sha256()
    for file in files:
        h.update(Path(file).read_bytes())
    return h.hexdigest()[:12]


def library_names(program):
    declared = json.loads(subprocess.run([program, "effects", "--json", "-"], capture_output=True, text=True, check=True).stdout)
    return [e["name"] for e in declared["effects"]]


def knows(program, option):
    """Whether `fidelis gap` has an option: programs of other days are compared, too."""
    return option in subprocess.run([program, "gap", "--help"], capture_output=True, text=True).stdout


def read_tried(path):
    number = lambda text: float(text) if text else None
    with open(path, newline="") as lines:
        return [{k: row[k] for k in TRIED} | {k: number(row[k]) for k in ("explained", "bic", "similarity")} for row in csv.DictReader(lines)]


def options_of(variant, case, program):
    """What `fidelis gap` is called with beside experiment and model."""
    if variant == "oracle":
        return ["--library", ",".join(case["truth"]["names"]), "--without", "references,parameters"]
    left_out = ["--without", ablation.LEFT_OUT[variant]] if variant in ablation.LEFT_OUT else []
    if case["without"]:
        left_out += ["--library", ",".join(n for n in library_names(program) if n not in case["without"])]
    return left_out


def result_path(home, program_key, variant):
    files = sorted((home / "experiment").rglob("*.*")) + [home / "model.json", home / "case.json"]
    files = [f for f in files if f.is_file()]
    return home / "results" / f"{variant}-{program_key}-{digest(*files)}.json"


def limited(command, log, limit_s):
    """(exit status, processor seconds, peak memory in MiB). Stopped after `limit_s` of processor time, so that a busy machine
    does not make a diagnosis late; exit status None then."""
    with open(log, "w") as stream:
        process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=stream,
                                   preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_CPU, (int(limit_s), int(limit_s) + 1)))
        _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    seconds = usage.ru_utime + usage.ru_stime
    out_of_time = process.returncode < 0 and seconds >= limit_s - 2
    return None if out_of_time else process.returncode, seconds, usage.ru_maxrss / 1024


def diagnose(home, bin_folder, program_key, time_limit_s=300, variant="full"):
    """The result of a case, run if it is not there. `variant`: full, oracle (nothing is tried but the true effects), or what
    ablation.py leaves out.
    `elapsed_s` is processor time of one thread."""
    home, program = Path(home), str(Path(bin_folder) / "fidelis")
    case = packages.read(home / "case.json")
    target = result_path(home, program_key, variant)
    if target.exists():
        return packages.read(target)
    folder = Path(tempfile.mkdtemp(prefix="withheld-run-"))
    try:
        asked = variant == "full" and knows(program, "--candidates")
        listed = ["--candidates", str(folder / "tried.csv")] if asked else []
        experiment = home / "experiment"
        if variant == ablation.ONE_CHANNEL:
            experiment = ablation.with_one_channel(experiment, folder / "experiment")
        command = [program, "--threads", "1", "gap", str(experiment), "--model", str(home / "model.json"),
                   *options_of(variant, case, program), *listed, "--json", str(folder / "report.json"),
                   "--write-model", str(folder / "better.json")]
        result = {"id": case["id"], "variant": variant, "program": program_key, "date": time.strftime("%Y-%m-%d")}
        code, seconds, memory = limited(command, folder / "log", time_limit_s)
        result.update(exit=code, elapsed_s=round(seconds, 2), peak_mib=round(memory))
        if code is None:
            result.update(status="timeout", message=f"not done after {time_limit_s} s of processor time")
        elif code not in (0, 1) or not (folder / "report.json").exists():
            result.update(status="failed", message=(folder / "log").read_text().strip()[-400:])
        else:
            report = packages.read(folder / "report.json")
            result.update(status="done", report={k: report[k] for k in KEEP if k in report})
            if asked:
                result["tried"] = read_tried(folder / "tried.csv")
            result["report"]["where"] = result["report"].get("where", [])[:5]
            better = packages.read(folder / "better.json") if (folder / "better.json").exists() else None
            if variant not in ablation.VARIANTS:
                result["actual"] = actual_shrink(home, case, report, better, bin_folder)
        packages.write(target, result)
        return result
    finally:
        shutil.rmtree(folder, ignore_errors=True)


def believed(experiment, report, better, baseline):
    """(experiment, model) as the first verdict says that they are: the model that it wrote, and the values that it fitted."""
    offsets, experiment, model = {}, copy.deepcopy(experiment), copy.deepcopy(better or baseline)
    verdict = report["verdict"]
    for name in verdict.get("names", []) + verdict.get("beside", []):
        cause = next((c for c in report["causes"] if name in (c.get("name"), *c.get("names", []))), None)
        if not cause or cause["kind"] == "effect":
            continue
        values = cause.get("parameters", {})
        number = next((v["value"] for v in values.values() if isinstance(v, dict) and "value" in v), None)
        if cause["kind"] == "reference":
            per_setup = {s: v["value"] for s, v in cause.get("setups", {}).items()}
            offsets[name] = {"per_setup": per_setup} if per_setup else {"everywhere": number or 0.0}
        elif number is not None:
            for document in (experiment, model):
                if name.split("/")[1] in document:
                    packages.put(document, name, number)
    return packages.displaced(experiment, offsets), model


def actual_shrink(home, case, report, better, bin_folder):
    """What the verdict's cure brings on held-out samples that are measured anew in the true world (new noise, new set-up
    scatter). None where there is no cure, or where the true world cannot be measured again (laws outside every library)."""
    if report["verdict"]["kind"] not in ("effect", "parameter", "reference") or "law" in case["truth"]["parameters"]:
        return None
    import cases
    rng = random.Random("fresh/" + case["id"])
    held = packages.only(packages.read(home / "experiment" / "experiment.json"), {"prediction"})
    world = packages.only(packages.read(home / "world" / "experiment.json"), {"prediction"})
    baseline = packages.read(home / "model.json")
    try:
        real = worlds.simulate(cases.scattered(rng, world, case["scatter"]), packages.read(home / "world" / "model.json"),
                               rng.randrange(1, 10**9), bin_folder, case["generator"])
        seed = rng.randrange(1, 10**9)
        experiment, model = believed(held, report, better, baseline)
        gap = lambda e, m: sum(severity.gaps(held, real, worlds.simulate(e, m, seed, bin_folder))) / len(held["samples"])
        before, after = gap(held, baseline), gap(experiment, model)
    except (worlds.GeneratorFailed, KeyError, IndexError) as error:
        return {"error": str(error)[-300:]}
    return {"before": before, "after": after, "shrink": 1 - after / before if before > 0 else 0.0}
