"""Trivial judges, to be printed beside every rate: if one of them comes close, the cases are too easy.

  random             one of all hypotheses (library, parameters and references of the case, none, unknown), evenly
  most frequent      the answer that is right most often, given without looking
  largest shrink     the first of the report's causes by the shrink that it claims

Not here: BIC with independent errors needs the fits' likelihoods, which the report does not give.
"""

from collections import Counter


def hypotheses_of(case, experiment, library):
    """How many answers a guess has to choose from."""
    return (len(library) - len(case["without"]) + len(experiment["materials"]) + 7 + 3 * len(experiment["scene"]) + 2)


def random_guess(rows, counts):
    """Expected share of right answers of one guess among a case's hypotheses."""
    pairs = [1 / counts[r["id"]] if len(r["truth"]) == 1 else 1 / (counts[r["id"]] * (counts[r["id"]] - 1) / 2) for r in rows]
    return sum(pairs) / len(pairs) if pairs else None


def most_frequent(rows):
    if not rows:
        return None
    return Counter("+".join(r["truth"]) for r in rows).most_common(1)[0][1] / len(rows)


def largest_shrink(rows, results):
    """Share of cases whose true cause is the one with the largest claimed shrink."""
    right = count = 0
    for row in rows:
        report = results[row["id"]].get("report")
        if row["truth_kind"] not in ("effect", "parameter", "reference"):
            continue
        count += 1
        causes = [c for c in (report or {}).get("causes", []) if c.get("shrink", {}).get("fraction") is not None]
        if causes:
            best = max(causes, key=lambda c: c["shrink"]["fraction"])
            right += row["truth"] == (best.get("names") or [best["name"]])
    return right / count if count else None


def table(rows, cases, results, experiments, library):
    counts = {c["id"]: hypotheses_of(c, experiments[c["id"]], library) for c in cases}
    single = [r for r in rows if r["class"] == "effect"]
    return [("random", random_guess(single, counts)), ("most frequent answer", most_frequent(single)),
            ("largest claimed shrink", largest_shrink(single, results))]
