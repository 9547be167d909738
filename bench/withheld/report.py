"""Writes what the benchmark found: results.json, a Markdown page, and the pictures."""

from pathlib import Path

import baselines
import packages
import score
import sets


def shown(result):
    value = result["value"]
    if value is None:
        return "–"
    if result["interval"] is None:
        return f"{value:.0f}" if abs(value) >= 1000 else f"{value:.3g}"
    return f"{value:.2f} [{result['interval'][0]:.2f}, {result['interval'][1]:.2f}]"


def wrong_cases(rows):
    return [r for r in rows if not r["right"]]


def line_of(row):
    confidence = "–" if row["confidence"] is None else f"{row['confidence']:.2f}"
    found = "+".join(row["found"]) or row["kind"]
    return (f"| {row['id']} | {row['class']} | {'+'.join(row['truth'])} | {row['family']} | {row['severity']:.2g} | "
            f"{row['kind']}: {found} | {confidence} | {'yes' if row['top3'] else 'no'} | {'yes' if score.programs_differ(row) else ''} |")


def judges_beside(trivial):
    """Judges down, groups of cases across."""
    groups = [name for name, _ in baselines.GROUPS if any(name in by_group for _, by_group in trivial)]
    size = {g: max(by_group[g]["n"] for _, by_group in trivial) for g in groups}
    lines = ["| judge | " + " | ".join(f"{g} ({size[g]})" for g in groups) + " |", "|-|" + "-|" * len(groups)]
    for judge, by_group in trivial:
        lines.append(f"| {judge} | " + " | ".join(counted(by_group[g], size[g]) for g in groups) + " |")
    close = baselines.too_close(trivial)
    if close:
        lines += ["", "Within three points of the diagnosis or beyond: " + ", ".join(close) + ". These cases are too easy, or the diagnosis is idle."]
    return lines


def counted(result, size):
    return shown(result) + (f", n={result['n']}" if result["n"] not in (0, size) else "")


def markdown(rows, trivial, about):
    lines = ["# Withheld causes: what the diagnosis finds", "",
             f"{about['date']}, version {about['version']}, {len(rows)} cases ({about['generators']}), command `{about['command']}`.",
             "Rates with Wilson 95 % intervals. How cases are made and judged: bench/withheld/README.md.",
             "The two programs *agree* on a case if its true cause at its true values shrinks the gap in the built-in model; where it",
             "does not, the case measures their difference beside the diagnosis. Rates are given with and without such cases.", ""]
    for name in sorted({r["generator"] for r in rows}):
        part = [r for r in rows if r["generator"] == name]
        lines += [f"## Cases of the {'built-in model' if name == 'own' else 'second generator'} ({len(part)})", "",
                  "| what | wanted | found | n |", "|-|-|-|-|"]
        lines += [f"| {what} | {wanted} | {shown(result)} | {result['n']} |" for what, wanted, result in score.table(part)]
        lines += [""]
    lines += ["## Beside it: judges that do not think, and one that knows", "",
              "Right answer first; number of cases in brackets. What each judge is: bench/withheld/baselines.py.", "", *judges_beside(trivial)]
    lines += ["", "## Per cause", "", "| class | cause | right first | among three | n |", "|-|-|-|-|-|"]
    lines += [f"| {c} | {n} | {shown(first)} | {shown(top)} | {first['n']} |" for c, n, first, top in score.per_name(rows)]
    lines += ["", "## Cases that went wrong", "", "| case | class | truth | scene | s | said | confidence | among three | programs differ |",
              "|-|-|-|-|-|-|-|-|-|"]
    lines += [line_of(r) for r in sorted(wrong_cases(rows), key=lambda r: (r["class"], r["name"]))]
    return "\n".join(lines) + "\n"


def pictures_page(cases, fresh):
    """Shows what `draw` drew. `fresh`: these are cases of kept sets."""
    which = f"the last {len(cases)} cases that no build had seen (those of {sets.PICTURED} sets at most)" if fresh else f"these {len(cases)} cases"
    return "\n".join(["", "## In pictures", "", f"Of {which}: what was said of which cause,", "and how often a confidence was right.", "",
                      "![What was said of which cause](confusion.svg)", "", "![How often a confidence was right](reliability.svg)"]) + "\n"


def sets_page(kept):
    """What the sets of fresh cases said so far, those of earlier versions beside the newest."""
    if not kept:
        return ""
    lines = ["", "## All sets of cases that no build had seen", "",
             f"{sum(len(s['cases']) for s in kept)} cases; number of cases in brackets. Each set was run once, with the version at its head; what its",
             "failures led to shows in later sets only. The files of sets/ have every case; [history.md](history.md) tells what came of them.", "",
             *sets.markdown(kept)]
    return "\n".join(lines) + "\n"


def write(out, rows, trivial, about, fresh=False):
    """Returns remarks for the person who runs it. `fresh`: no build had seen these cases, so they are kept as a set."""
    out = Path(out)
    out.mkdir(parents=True, exist_ok=True)
    if fresh:
        sets.keep(out, about, rows)
    packages.write(out / "results.json", {
        "format": "fidelis-withheld-results", "version": 1, **about,
        "table": {name: [{"what": w, "wanted": t, **r} for w, t, r in score.table([x for x in rows if x["generator"] == name])]
                  for name in sorted({r["generator"] for r in rows})},
        "judges": [{"judge": name, **by_group} for name, by_group in trivial], "cases": rows})
    kept = sets.read(out)
    cases = sets.pictured(kept) or rows  # one set alone has each cause once or twice
    remarks = draw(out, cases)
    parts = "\nWhat the parts of the diagnosis bring: [ablations.md](ablations.md).\n" if (out / "ablations.md").exists() else ""
    shown_there = "" if remarks else pictures_page(cases, fresh=bool(kept))
    (out / "README.md").write_text(markdown(rows, trivial, about) + parts + shown_there + sets_page(kept))
    return remarks


def draw(out, cases):
    """Returns remarks: why it could not."""
    try:
        import pictures as drawn
    except ImportError as error:
        return [f"no pictures: {error.name} is not installed (apt install python3-matplotlib)"]
    drawn.confusion(cases, out / "confusion.svg")
    drawn.reliability(cases, out / "reliability.svg")
    return []
