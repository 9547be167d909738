#!/usr/bin/env python3
"""How long one diagnosis takes: 12 samples of about 10 000 detections, the whole library with pairs.

The scenes and sensors are those of visible cases, each sample three times at other distances, measured anew by the second
generator: a range walk in front of panels; a dirty cover and a range walk in front of a wall; speckle and a clock that is off,
in front of a wall that wide beams meet obliquely.

    FIDELIS_SHARED=../shared bench/diagnosis_time.py --bin build/bin [--threads 2]
"""

import argparse
import json
import os
import subprocess
import tempfile
import time
from pathlib import Path

DISTANCES = (1.0, 1.13, 1.27)  # of those of the visible case
SAMPLES = 12
CASES = {
    "one cause": ("v03", {"range-walk": {"calibrated_at_snr": 60}}),
    "two causes": ("v04", {"cover-contamination": {"attenuation": 0.28, "azimuth_from_deg": 3, "azimuth_to_deg": 16},
                           "range-walk": {"calibrated_at_snr": 60}}),
    "two that scatter": ("v06", {"speckle": {"looks": 8}, "clock-drift": {"scale_ppm": 200}}),
}


def moved(sample, copy):
    """The sample at another distance, with a name of its own."""
    sample = json.loads(json.dumps(sample))
    name = f"{sample['id']}{'abc'[copy]}"
    sample["measurements"] = sample["measurements"].replace(sample["id"], name)
    sample["id"] = name
    if "setup" in sample:
        sample["setup"] += "abc"[copy]
    for patch in sample.get("patch", []):
        if "position_m" in patch["path"]:
            patch["value"] = round(patch["value"] * DISTANCES[copy], 3)
    sample["parameters"] = {key: round(value * DISTANCES[copy], 3) for key, value in sample["parameters"].items()}
    return sample


def build(package, effects, programs, folder):
    """The package measured in a world with these effects; its path."""
    experiment = json.loads((package / "experiment.json").read_text())
    known = experiment["samples"]
    experiment["samples"] = [moved(known[i % len(known)], i // len(known)) for i in range(SAMPLES)]
    model = json.loads((package / "model.json").read_text())
    model["effects"].update(effects)
    (folder / "in").mkdir()
    (folder / "in" / "experiment.json").write_text(json.dumps(experiment))
    (folder / "true.json").write_text(json.dumps(model))
    subprocess.run([programs / "withheld_generator", folder / "in", "--model", folder / "true.json", "--out", folder / "out"],
                   check=True)
    return folder / "out"


def diagnose(package, model, programs, threads):
    """(seconds, MiB at most, the verdict's names)"""
    report = package / "report.json"
    start = time.monotonic()
    process = subprocess.Popen([programs / "fidelis", "--quiet", "--threads", str(threads), "gap", package, "--model", model,
                                "--json", report], stdout=subprocess.DEVNULL)
    _, status, usage = os.wait4(process.pid, 0)
    if status != 0:
        raise SystemExit(f"fidelis gap {package} failed")
    return time.monotonic() - start, usage.ru_maxrss / 1024, json.loads(report.read_text())["verdict"]["names"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", type=Path, default=Path("build/bin"), help="folder of the programs")
    parser.add_argument("--threads", type=int, default=2)
    options = parser.parse_args()
    packages = Path(os.environ.get("FIDELIS_SHARED", "../shared")) / "experiments"
    if not packages.is_dir():
        raise SystemExit(f"{packages}: no folder of visible cases; name it in FIDELIS_SHARED")
    print("| case | detections | seconds | MiB | named |\n|-|-:|-:|-:|-|")
    for title, (case, effects) in CASES.items():
        with tempfile.TemporaryDirectory() as temporary:
            package = build(packages / case, effects, options.bin, Path(temporary))
            detections = sum(int(subprocess.check_output(f"zcat -f '{file}' | wc -l", shell=True)) - 1
                             for file in (package / "measurements").iterdir())
            seconds, mib, names = diagnose(package, packages / case / "model.json", options.bin, options.threads)
            print(f"| {title} ({case}) | {detections} | {seconds:.0f} | {mib:.0f} | {', '.join(names)} |", flush=True)


if __name__ == "__main__":
    main()
