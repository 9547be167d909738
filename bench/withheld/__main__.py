"""scripts/withheld: the benchmark of the diagnosis. Start at cases.py (what is drawn) and score.py (what counts)."""

import argparse
import concurrent.futures
import itertools
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import ablation
import baselines
import build
import cases
import packages
import recorded
import report
import run
import score

ROOT = Path(__file__).resolve().parents[2]

EPILOG = """
examples:
  scripts/withheld                                       build what is missing, run, report into docs/withheld
  scripts/withheld build --count 40 --class effect       cases only
  scripts/withheld run --effects range-walk,saturation   only cases about these
  scripts/withheld run --case 0123456                    one case: verdict beside truth
  scripts/withheld report --out /tmp/withheld
  scripts/withheld list
  scripts/withheld ablate --effects speckle --without no-references,one-channel

classes: """ + ", ".join(cases.CLASSES) + """
A result is kept per case and program: a second call runs what is missing only, and may be interrupted at any time.
"""


class UserError(Exception):
    pass


def arguments(argv):
    parser = argparse.ArgumentParser(prog="scripts/withheld", description="Does the diagnosis find causes that the model lacks? "
                                     "Builds cases of known cause, runs `fidelis gap` on them, and scores its verdicts.",
                                     epilog=EPILOG, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", nargs="?", default="all", choices=["all", "build", "run", "report", "list", "ablate"],
                        help="default: all; ablate: run with parts of the diagnosis left out, too, and print what each brings")
    parser.add_argument("--cases", type=Path, default=Path(os.environ.get("WITHHELD_CASES", ROOT / "build" / "withheld")),
                        help="folder of the cases (default: build/withheld, or $WITHHELD_CASES)")
    parser.add_argument("--bin", type=Path, default=ROOT / "build" / "bin", help="folder of the programs (default: build/bin)")
    parser.add_argument("--out", type=Path, default=ROOT / "docs" / "withheld", help="where the report goes (default: docs/withheld)")
    parser.add_argument("--generator", choices=["own", "foreign"], default=None,
                        help="who makes the data: the built-in model, or the second generator (default: own for build, both for run)")
    parser.add_argument("--count", type=int, default=100, help="cases to build (default: 100)")
    parser.add_argument("--seed", type=int, default=1, help="of the cases (default: 1)")
    parser.add_argument("--scenes", type=Path, default=None, metavar="FOLDER",
                        help="build in the scenes of the packages in this folder, with their sensors (default: invented ones)")
    parser.add_argument("--class", dest="classes", default="", help="only these classes, a,b")
    parser.add_argument("--effects", default="", help="only these causes, a,b: effects, parameters as `cases` names them")
    parser.add_argument("--case", default="", help="only this case; prints its verdict beside the truth")
    parser.add_argument("--jobs", type=int, default=2, help="cases at once, one thread each (default: 2)")
    parser.add_argument("--time-limit", type=float, default=300, metavar="S", help="processor time of a diagnosis; past it the case is wrong (300)")
    parser.add_argument("--fresh", action="store_true", help="no build has seen these cases: keep them in OUT/sets, beside those of earlier versions")
    parser.add_argument("--oracle", action="store_true", help="run with nothing tried but the true effects, too")
    parser.add_argument("--without", default=",".join(ablation.VARIANTS), help="what ablate leaves out, a,b (default: each of %(default)s)")
    options = parser.parse_args(argv)
    options.without = [w for w in options.without.split(",") if w]
    for w in options.without:
        if w not in ablation.VARIANTS:
            parser.error(f"'{w}' cannot be left out; there are {', '.join(ablation.VARIANTS)}")
    options.classes = [c for c in options.classes.split(",") if c]
    options.effects = [e for e in options.effects.split(",") if e]
    for c in options.classes:
        if c not in cases.CLASSES:
            parser.error(f"there is no class '{c}'; classes are {', '.join(cases.CLASSES)}")
    known = {n for c in cases.CLASSES for n in cases.names_of(c)}
    for e in options.effects:
        if e not in known:
            parser.error(f"no case is about '{e}'; there are {', '.join(sorted(known))}")
    return options


class Progress:
    """A bar on stderr; silent lines where stderr is no terminal."""

    def __init__(self, title, total):
        self.title, self.total, self.done, self.started = title, total, 0, time.monotonic()
        self.terminal = sys.stderr.isatty()

    def step(self, text):
        self.done += 1
        left = (time.monotonic() - self.started) / self.done * (self.total - self.done)
        bar = "#" * round(24 * self.done / self.total)
        line = f"{self.title} [{bar:<24}] {self.done}/{self.total}, {left:.0f} s left  {text}"
        print(("\r\033[K" if self.terminal else "") + line[:160], end="" if self.terminal else "\n", file=sys.stderr, flush=True)
        if self.terminal and self.done == self.total:
            print(file=sys.stderr)


def quiet_worker():
    signal.signal(signal.SIGINT, signal.SIG_IGN)


def at_once(title, jobs, function, tasks):
    """Results in the order of completion; Ctrl-C stops after the tasks that run."""
    tasks = list(tasks)
    progress = Progress(title, len(tasks))
    with concurrent.futures.ProcessPoolExecutor(jobs, initializer=quiet_worker) as pool:
        futures = [pool.submit(function, *task) for task in tasks]
        try:
            for future in concurrent.futures.as_completed(futures):
                try:
                    result = future.result()
                except Exception as error:  # one case that breaks must not stop the others, nor go unseen
                    result = None, f"FAILED: {error!r}"
                progress.step(result[1])
                yield result
        except KeyboardInterrupt:
            pool.shutdown(cancel_futures=True)
            raise


def program(options, name):
    path = options.bin / name
    if not path.exists():
        raise UserError(f"{path} is missing\n  Build it first (scripts/test), or say where it is with --bin.")
    return path


def scenes_of(options):
    """Packages in whose scenes cases are built; none: invented scenes."""
    if options.scenes is None:
        return []
    try:
        given = recorded.read(options.scenes)
    except (OSError, ValueError) as error:
        raise UserError(f"a package in {options.scenes} cannot be read: {error}\n  Each needs an experiment.json and a model.json.") from error
    if not given:
        raise UserError(f"no package with one sensor in {options.scenes}\n  Name a folder with NAME/experiment.json and NAME/model.json in it.")
    return given


def build_cases(options):
    generator = options.generator or "own"
    program(options, "fidelis"), program(options, {"own": "fidelis", "foreign": "withheld_generator"}[generator])
    given = scenes_of(options)
    classes = options.classes
    if given and not classes:
        classes = [c for c in cases.CLASSES if c != "ambiguous"]  # whose design is an invented one
    slots = itertools.islice(cases.slots(options.seed, classes, options.effects, cases.laws_of(generator)), options.count)
    failed = [text for number, text in at_once("build", options.jobs, build.build, (
        (options.seed, slot, options.cases, options.bin, generator, given) for slot in slots)) if number is None]
    for text in failed:
        print("  not built:", text, file=sys.stderr)


def chosen(options):
    """[(folder, case)] that the options ask for."""
    found = []
    for path in sorted(options.cases.glob("*/case.json")):
        case = packages.read(path)
        names = {case["name"], *case["truth"]["names"]}
        if (not options.case or case["id"] == options.case) and (not options.classes or case["class"] in options.classes) and \
                (not options.effects or names & set(options.effects)) and (not options.generator or case["generator"] == options.generator):
            found.append((path.parent, case))
    if not found:
        raise UserError(f"no such cases in {options.cases}\n  Build some: scripts/withheld build")
    return found


def diagnose(home, bin_folder, key, limit, variant):
    result = run.diagnose(home, bin_folder, key, limit, variant)
    case = packages.read(home / "case.json")
    row = score.judge(case, result)
    return result, f"{row['id']} {'+'.join(row['truth'])} -> {row['kind']} {'+'.join(row['found'])} {'right' if row['right'] else 'WRONG'}"


def run_cases(options, found, variants=("full",)):
    fidelis = program(options, "fidelis")
    if (options.oracle or len(variants) > 1) and not run.knows(str(fidelis), "--without"):
        raise UserError(f"{fidelis} has no option --without\n  Build a newer one, or leave out what needs it (--oracle, ablate).")
    key = run.digest(fidelis)
    tasks = [(home, options.bin, key, options.time_limit, variant) for home, _ in found for variant in variants]
    if options.oracle:
        tasks += [(home, options.bin, key, options.time_limit, "oracle") for home, c in found if c["truth"]["kind"] == "effect"]
    todo = [t for t in tasks if not run.result_path(t[0], key, t[4]).exists()]
    if todo:
        for _ in at_once("run", options.jobs, diagnose, todo):
            pass


def results_of(found, key, variant="full"):
    pairs = [(case, run.result_path(home, key, variant)) for home, case in found]
    return [(case, packages.read(path)) for case, path in pairs if path.exists()]


def version():
    said = subprocess.run(["git", "-C", str(ROOT), "describe", "--always", "--tags", "--dirty"], capture_output=True, text=True)
    return said.stdout.strip() or "unknown"


def about_cases(rows):
    generators = ", ".join(f"{sum(r['generator'] == g for r in rows)} {g}" for g in sorted({r["generator"] for r in rows}))
    return {"date": time.strftime("%Y-%m-%d"), "version": version(), "command": "scripts/withheld " + " ".join(sys.argv[1:]), "generators": generators}


def ablate(options, found):
    """Runs what is missing and prints what each part brings; ablations.md keeps it."""
    variants = ["full", *options.without]
    run_cases(options, found, variants)
    key = run.digest(program(options, "fidelis"))
    rows = {v: {case["id"]: score.judge(case, result) for case, result in results_of(found, key, v)} for v in variants}
    page = ablation.markdown(ablation.table(rows), report.shown, about_cases(rows["full"].values()))
    options.out.mkdir(parents=True, exist_ok=True)
    (options.out / "ablations.md").write_text(page)
    print(page + f"report: {options.out}/ablations.md")


def make_report(options, found):
    key = run.digest(program(options, "fidelis"))
    done = results_of(found, key)
    if not done:
        raise UserError("no results of this program\n  Run the cases: scripts/withheld run")
    rows = [score.judge(case, result) for case, result in done]
    homes = {case["id"]: home for home, case in found}
    oracles = {c["id"]: r for c, r in results_of(found, key, "oracle")}
    trivial = baselines.table(rows, [c for c, _ in done], {c["id"]: r for c, r in done}, oracles,
                              {c["id"]: packages.read(homes[c["id"]] / "experiment" / "experiment.json") for c, _ in done},
                              run.library_names(str(program(options, "fidelis"))))
    about = about_cases(rows)
    for remark in report.write(options.out, rows, trivial, about, fresh=options.fresh):
        print(remark, file=sys.stderr)
    for what, wanted, result in score.table(rows):
        if result["n"]:
            print(f"{what:68} {wanted:14} {report.shown(result):22} n={result['n']}")
    for judge, by_group in trivial:
        for group in ("one effect", "all classes"):
            if by_group.get(group, {}).get("n"):
                print(f"  beside it: {judge + ', ' + group:60} {report.shown(by_group[group]):22} n={by_group[group]['n']}")
    missing = len(found) - len(done)
    print(f"report: {options.out}/README.md" + (f"; {missing} cases have no result yet" if missing else ""))


def show(options, found):
    """One case: verdict beside truth."""
    home, case = found[0]
    result = run.diagnose(home, options.bin, run.digest(program(options, "fidelis")), options.time_limit)
    truth, row = case["truth"], score.judge(case, result)
    print(f"case {case['id']} ({case['class']}, {case['family']}, {case['generator']}), severity {case['severity']['value']:.3g}")
    print(f"  truth    {truth['kind']} {' + '.join(truth['names'])} {truth['parameters']}")
    if result["status"] != "done":
        print(f"  {result['status']}: {result.get('message', '')}")
        return
    print(f"  verdict  {row['text']}")
    print(f"  {'right' if row['right'] else 'WRONG'}; kind {row['kind']}, names {row['found']}, confidence {row['confidence']:.3f}, "
          f"not told apart from {row['equivalents']}")
    print(f"  shrink   claimed {row['claimed']} {row['interval']}, actual {row.get('actual')}, with the true cause {row.get('oracle')}")
    for cause in result["report"]["causes"][:5]:
        values = {k: v.get("value") for k, v in cause.get("parameters", {}).items() if isinstance(v, dict)}
        print(f"    cause {cause['kind']} {' + '.join(score.cause_names(cause))}: confidence {cause['confidence']:.3g}, "
              f"shrink {(cause.get('shrink') or {}).get('fraction')}, {values}")
    for where in result["report"]["where"][:3]:
        print(f"    where {where.get('text', where['measurand'])}")
    print(f"  reproduce: {options.bin / 'fidelis'} gap {home / 'experiment'} --model {home / 'model.json'} --json -"
          + (f"  (library without {', '.join(case['without'])})" if case["without"] else ""))


def list_cases(found):
    for home, case in found:
        print(f"{case['id']}  {case['class']:10} {case['name']:28} {case['family']:16} {case['generator']:8} s {case['severity']['value']:.2g}")


def main(argv):
    options = arguments(argv)
    try:
        if options.what in ("all", "build"):
            build_cases(options)
        if options.what == "build":
            return 0
        found = chosen(options)
        if options.what == "list":
            list_cases(found)
        elif options.what == "ablate":
            ablate(options, found)
        elif options.case:
            show(options, found)
        else:
            if options.what in ("all", "run"):
                run_cases(options, found)
            make_report(options, found)
        return 0
    except UserError as error:
        print(f"scripts/withheld: {error}", file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        print("\nstopped; call again to go on", file=sys.stderr)
        return 130


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
