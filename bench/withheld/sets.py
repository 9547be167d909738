"""Sets of cases that no build had seen when they were run: kept as they were judged, shown side by side and pooled.

  OUT/sets/DATE-VERSION-SEED.json   {"date", "version", "command", "generators", "cases": rows of score.judge}, a line a case

A case that was looked at while the program was changed tells how the change went, not how good the program is; only `--fresh`
keeps a set.
"""

import json
import re

import packages
import score

NEWEST = 3  # sets of the last versions, pooled: programs of other weeks answer for themselves
PICTURED = 10  # the newest, pooled


def seed_of(about):
    found = re.search(r"--seed (\d+)", about["command"])
    return int(found.group(1)) if found else 1


def heading(about):
    scenes = ", scenes of packages" if "--scenes" in about["command"] else ""
    return f"seed {seed_of(about)}{scenes}, {about['version']}, {about['date'][5:]}"


def keep(out, about, rows):
    """Writes the set and returns its file."""
    path = out / "sets" / f"{about['date']}-{about['version']}-{seed_of(about)}.json"
    path.parent.mkdir(parents=True, exist_ok=True)
    head = ",\n ".join(f"{json.dumps(k)}: {json.dumps(v)}" for k, v in about.items())
    lines = ",\n  ".join(json.dumps(row, separators=(",", ":")) for row in rows)
    path.write_text("{" + head + ',\n "cases": [\n  ' + lines + "\n ]}\n")
    return path


def read(out):
    """All sets, the newest first."""
    kept = [packages.read(path) for path in (out / "sets").glob("*.json")]
    return sorted(kept, key=lambda s: (s["date"], seed_of(s)), reverse=True)


def pictured(kept):
    return [row for s in kept[:PICTURED] for row in s["cases"]]


def brief(result):
    if result["value"] is None:
        return "–"
    return f"{result['value']:.2f} ({result['n']})" if result["interval"] else f"{result['value']:.3g}"


def full(result):
    if result["value"] is None or not result["interval"]:
        return brief(result)
    return f"{result['value']:.2f} [{result['interval'][0]:.2f}, {result['interval'][1]:.2f}], n={result['n']}"


def pooled(sets):
    return score.table([row for s in sets for row in s["cases"]])


def markdown(sets):
    """Aims down, sets across."""
    tables = [score.table(s["cases"]) for s in sets]
    newest, everything = pooled(sets[:NEWEST]), pooled(sets)
    head = ["what", "wanted", f"newest {len(sets[:NEWEST])} together", "all together",
            *map(heading, sets)]
    lines = ["| " + " | ".join(head) + " |", "|" + "-|" * len(head)]
    for i, (what, wanted, together) in enumerate(everything):
        if together["n"]:
            cells = [what, wanted, full(newest[i][2]), full(together), *(brief(t[i][2]) for t in tables)]
            lines.append("| " + " | ".join(cells) + " |")
    return lines
