"""What the parts of the diagnosis bring: right answers without each of them, beside those of the whole, on the same cases.

  no references   recorded poses taken as exact (`fidelis gap --without references`)
  no parameters   recorded parameters taken as right (`--without parameters`)
  no hold-out     judged on the samples that were fitted (`--without hold-out`)
  one channel     one measurand left in experiment.json: range, or what there is
"""

from pathlib import Path

import packages
import score

LEFT_OUT = {"no-references": "references", "no-parameters": "parameters", "no-hold-out": "hold-out"}
ONE_CHANNEL = "one-channel"
VARIANTS = [*LEFT_OUT, ONE_CHANNEL]

COLUMNS = [
    ("right first, all classes", lambda r: True, lambda r: r["right"]),
    ("one effect", lambda r: r["class"] == "effect", lambda r: r["right"]),
    ("parameter", lambda r: r["class"] == "parameter", lambda r: r["right"]),
    ("reference", lambda r: r["class"] == "reference", lambda r: r["right"]),
    ("nothing missing", lambda r: r["class"] == "none", lambda r: r["right"]),
    ("effect blamed for a reference or for nothing", lambda r: r["class"] in ("none", "reference"), score.claims_effect),
]


def with_one_channel(experiment, folder):
    """A copy of the package with one measurand, in `folder`; the measurements are the same files."""
    experiment, folder = Path(experiment).resolve(), Path(folder)
    folder.mkdir(parents=True)
    for part in experiment.iterdir():
        if part.name != "experiment.json":
            (folder / part.name).symlink_to(part)
    package = packages.read(experiment / "experiment.json")
    measurands = package["measurands"]
    package["measurands"] = [m for m in measurands if m["name"] == "range"] or measurands[:1]
    packages.write(folder / "experiment.json", package)
    return folder


def table(rows):
    """[(variant, {column: rate}, lost, won)] of {variant: {id: row}}; each variant on the cases that the whole was run on, too.
    `lost`: right as a whole and wrong without; `won`: the reverse."""
    whole = rows["full"]
    result = []
    for variant, found in rows.items():
        common = [r for number, r in found.items() if number in whole]
        rates = {title: score.rate([r for r in common if member(r)], test) for title, member, test in COLUMNS}
        lost = sum(whole[r["id"]]["right"] and not r["right"] for r in common)
        won = sum(r["right"] and not whole[r["id"]]["right"] for r in common)
        result.append((variant, rates, lost, won))
    return result


def markdown(lines, shown, about):
    """`shown`: a rate as text."""
    titles = [title for title, _, _ in COLUMNS]
    text = ["# What the parts of the diagnosis bring", "",
            f"{about['date']}, version {about['version']}, {about['generators']}, command `{about['command']}`.",
            "Rates with Wilson 95 % intervals, number of cases in brackets; lost and won against the whole, case by case.",
            "What is left out: bench/withheld/ablation.py.", "",
            "| | " + " | ".join(titles) + " | lost | won |", "|-|" + "-|" * (len(titles) + 2)]
    for variant, rates, lost, won in lines:
        cells = [f"{shown(rates[t])} ({rates[t]['n']})" for t in titles]
        name = "the whole" if variant == "full" else variant.replace("-", " ", 1)
        text.append(f"| {name} | " + " | ".join(cells) + (" | | |" if variant == "full" else f" | {lost} | {won} |"))
    return "\n".join(text) + "\n"
