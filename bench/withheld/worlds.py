"""A world, and what a sensor would measure in it: runs a generator and reads its detections.

Generators take the command line of `fidelis simulate`. "own" is the program's own model, "foreign" the second one.
"""

import shutil
import subprocess
import tempfile
from pathlib import Path

import packages

PROGRAMS = {"own": "fidelis", "foreign": "withheld_generator"}


class GeneratorFailed(Exception):
    pass


def command(bin_folder, generator, seed):
    program = str(Path(bin_folder) / PROGRAMS[generator])
    if generator == "own":
        return [program, "--quiet", "--threads", "1", "--seed", str(seed), "simulate"]
    return [program, "--seed", str(seed), "--threads", "1"]


def simulate(experiment, model, seed, bin_folder, generator="own", after=None, keep=None):
    """{sample id: table}. `after` changes each table (effects outside every library); `keep` is a folder to leave the files in."""
    folder = Path(tempfile.mkdtemp(prefix="withheld-"))
    try:
        packages.write(folder / "in" / "experiment.json", experiment)
        packages.write(folder / "model.json", model)
        run = subprocess.run([*command(bin_folder, generator, seed), str(folder / "in"), "--model", str(folder / "model.json"),
                              "--out", str(folder / "out")], capture_output=True, text=True)
        if run.returncode != 0:
            raise GeneratorFailed(run.stderr.strip()[-600:])
        tables = {s["id"]: packages.read_table(folder / "out" / s["measurements"]) for s in experiment["samples"]}
        if after:
            resolution = {m["column"]: m["resolution"] for m in experiment["measurands"]}
            for table in tables.values():
                if table["layer"]:
                    after(table)
                for column, step in resolution.items():
                    if column not in table:
                        continue
                    table[column] = [round(round(v / step) * step, 6) for v in table[column]]
        if keep:
            for sample in experiment["samples"]:
                packages.write_table(Path(keep) / sample["measurements"], tables[sample["id"]])
        return tables
    finally:
        shutil.rmtree(folder, ignore_errors=True)
