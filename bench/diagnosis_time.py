#!/usr/bin/env python3
"""How long one diagnosis takes: 12 samples of about 10 000 detections, the whole library with pairs.

The scenes and sensors are those of visible cases, each sample three times at other distances, measured anew by the second
generator: a range walk in front of panels; a dirty cover and a range walk in front of a wall; speckle and a clock that is off,
in front of a wall that wide beams meet obliquely.

    FIDELIS_SHARED=../shared bench/diagnosis_time.py --bin build/bin [--threads 2]
"""

import argparse
import copy
import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent / "withheld"))
import packages

DISTANCES = (1.0, 1.13, 1.27)  # of those of the visible case
SAMPLES = 12
CASES = {
    "one cause": ("v03", {"range-walk": {"calibrated_at_snr": 60}}),
    "two causes": ("v04", {"cover-contamination": {"attenuation": 0.28, "azimuth_from_deg": 3, "azimuth_to_deg": 16},
                           "range-walk": {"calibrated_at_snr": 60}}),
    "two that scatter": ("v06", {"speckle": {"looks": 8}, "clock-drift": {"scale_ppm": 200}}),
}


def moved(sample, turn):
    """The sample at another distance, with a name of its own."""
    sample = copy.deepcopy(sample)
    name = f"{sample['id']}{'abc'[turn]}"
    sample["measurements"] = sample["measurements"].replace(sample["id"], name)
    sample["id"] = name
    if "setup" in sample:
        sample["setup"] += "abc"[turn]
    for patch in sample.get("patch", []):
        if "position_m" in patch["path"]:
            patch["value"] = round(patch["value"] * DISTANCES[turn], 3)
    sample["parameters"] = {key: round(value * DISTANCES[turn], 3) for key, value in sample["parameters"].items()}
    return sample


def build(package, effects, programs, folder):
    """The package measured in a world with these effects; its path."""
    experiment = packages.read(package / "experiment.json")
    known = experiment["samples"]
    experiment["samples"] = [moved(known[i % len(known)], i // len(known)) for i in range(SAMPLES)]
    model = packages.read(package / "model.json")
    model["effects"].update(effects)
    packages.write(folder / "in" / "experiment.json", experiment)
    packages.write(folder / "true.json", model)
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
    return time.monotonic() - start, usage.ru_maxrss / 1024, packages.read(report)["verdict"]["names"]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", type=Path, default=Path("build/bin"), help="folder of the programs")
    parser.add_argument("--threads", type=int, default=2)
    options = parser.parse_args()
    visible = Path(os.environ.get("FIDELIS_SHARED", "../shared")) / "experiments"
    if not visible.is_dir():
        raise SystemExit(f"{visible}: no folder of visible cases; name it in FIDELIS_SHARED")
    print("| case | detections | seconds | MiB | named |\n|-|-:|-:|-:|-|")
    for title, (case, effects) in CASES.items():
        with tempfile.TemporaryDirectory() as temporary:
            package = build(visible / case, effects, options.bin, Path(temporary))
            detections = sum(len(packages.read_table(file)["frame"]) for file in (package / "measurements").iterdir())
            seconds, mib, names = diagnose(package, visible / case / "model.json", options.bin, options.threads)
            print(f"| {title} ({case}) | {detections} | {seconds:.0f} | {mib:.0f} | {', '.join(names)} |", flush=True)


if __name__ == "__main__":
    main()
