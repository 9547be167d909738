"""Judges to be printed beside every rate: some that do not think (if one of them comes close, the cases are too easy or the
thinking is idle), and one that knows.

  random                   one of all hypotheses (library, parameters and references of the case, none, unknown), evenly
  most frequent answer     the answer that is right most often in the group, given without looking
  largest claimed shrink   the first of the report's causes by the shrink that it claims
  nearest signature        the cause whose changes of the data, at any strength, point most nearly where the measurement differs
  BIC                      the smallest BIC of all that was tried, all cell means taken for independent and normal
  oracle                   a diagnosis that tries the true effects only (`--oracle`): whether it names them, and the shrink of its
                           cure (where it names nothing, of the true effects at their true values)

The two before the oracle read the list of `fidelis gap --candidates`; rows without one (older programs) do not count.
"""

from collections import Counter

import chance
import score

REACHED = 0.97  # of the oracle's shrink

GROUPS = [
    ("one effect", lambda r: r["class"] == "effect"),
    ("one effect, s >= 2", lambda r: r["class"] == "effect" and r["bin"] in (2, 4)),
    ("one effect, s = 1", lambda r: r["class"] == "effect" and r["bin"] == 1),
    ("one effect, s = 0.5", lambda r: r["class"] == "effect" and r["bin"] == 0.5),
    ("all classes", lambda r: True),
    ("all classes, programs agree", lambda r: not score.programs_differ(r)),
    ("programs differ by more than the cause", score.programs_differ),
]


def hypotheses_of(case, experiment, library):
    """How many answers a guess has to choose from."""
    return (len(library) - len(case["without"]) + len(experiment["materials"]) + 7 + 3 * len(experiment["scene"]) + 2)


def random_guess(rows, counts):
    """Expected share of right answers of one guess among a case's hypotheses."""
    chances = [1 / counts[r["id"]] if len(r["truth"]) == 1 else 1 / (counts[r["id"]] * (counts[r["id"]] - 1) / 2) for r in rows]
    return {"value": sum(chances) / len(chances) if chances else None, "interval": None, "n": len(chances)}


def most_frequent(rows):
    """Hits of the one answer that has most of them."""
    best = Counter("+".join(r["truth"]) for r in rows).most_common(1)
    return score.rate(rows, lambda r: "+".join(r["truth"]) == best[0][0])


def answer(kind, names):
    return {"kind": kind, "names": names, "indistinguishable_from": []}


NOTHING = answer("nothing", [])  # never right: who looks for the largest of something does not say none or unknown


def largest_shrink(result):
    causes = [c for c in result["report"].get("causes", []) if (c.get("shrink") or {}).get("fraction") is not None]
    if not causes:
        return NOTHING
    best = max(causes, key=lambda c: c["shrink"]["fraction"])
    return answer(best["kind"], score.cause_names(best))


def nearest_signature(result):
    listed = [t for t in result["tried"] if t["similarity"] is not None]
    best = max(listed, key=lambda t: t["similarity"], default=None)
    return answer(best["kind"], [best["name"]]) if best else NOTHING


def smallest_bic(result):
    best = min(result["tried"], key=lambda t: t["bic"])
    names = best["name"].split(" + ") if best["kind"] == "pair" else [best["name"]] if best["name"] else []
    if best["kind"] != "pair":
        return answer(best["kind"], names)
    effects = [n for n in names if not n.startswith("/")]  # a parameter or reference beside an effect is not named, as in a verdict
    if effects:
        return answer("effect", effects)
    return answer("reference" if names[0].startswith("/scene/") else "parameter", names)


def judged(case, result, judge, needs="report"):
    """Whether a judge is right; None where it had nothing to look at. A diagnosis that failed leaves it nothing either: wrong."""
    if result["status"] == "done" and needs not in result:
        return None
    return result["status"] == "done" and score.named_first(case["truth"], judge(result))


def shrink_of(result):
    return max(0.0, (result.get("actual") or {}).get("shrink", 0.0))


def shrink_of_oracle(case, oracle):
    """What the cure of the true effects brings: refitted, if they alone are tried and found enough; else at their true values."""
    if (oracle.get("actual") or {}).get("shrink") is not None:
        return shrink_of(oracle)
    return max(0.0, (case["truth"].get("oracle") or {}).get("shrink", 0.0))


def oracle_reached(case, result, oracle):
    """Whether the full diagnosis' cure brings what the oracle's does; None where the oracle's brings nothing."""
    if not oracle or shrink_of_oracle(case, oracle) <= 0:
        return None
    return shrink_of(result) >= REACHED * shrink_of_oracle(case, oracle)


def median_shrink(shrinks):
    return {"value": chance.median(shrinks), "interval": None, "n": len(shrinks)}


def table(rows, cases, results, oracles, experiments, library):
    """[(judge, {group: {value, interval, n}})]. `results`, `oracles`: by id, of the full diagnosis and of the oracle's where it ran."""
    counts = {c["id"]: hypotheses_of(c, experiments[c["id"]], library) for c in cases}
    case_of = {c["id"]: c for c in cases}
    by = lambda judge, needs: lambda rs: score.rate(rs, lambda r: judged(case_of[r["id"]], results[r["id"]], judge, needs))
    judges = [
        ("this diagnosis", lambda rs: score.rate(rs, lambda r: r["right"])),
        ("random", lambda rs: random_guess(rs, counts)),
        ("most frequent answer", most_frequent),
        ("largest claimed shrink", by(largest_shrink, "report")),
        ("nearest signature", by(nearest_signature, "tried")),
        ("BIC, errors taken for independent", by(smallest_bic, "tried")),
        ("oracle: names the true effect", lambda rs: score.rate(rs, lambda r: None if r["id"] not in oracles else judged(
            case_of[r["id"]], oracles[r["id"]], lambda o: o["report"]["verdict"]))),
        ("oracle: shrink of its cure, median", lambda rs: median_shrink(
            [shrink_of_oracle(case_of[r["id"]], oracles[r["id"]]) for r in rs if r["id"] in oracles])),
        (f"this diagnosis reaches {REACHED} of the oracle's shrink",
         lambda rs: score.rate(rs, lambda r: oracle_reached(case_of[r["id"]], results[r["id"]], oracles.get(r["id"])))),
    ]
    groups = [(name, [r for r in rows if member(r)]) for name, member in GROUPS]
    return [(name, {group: judge(part) for group, part in groups if part}) for name, judge in judges]


def too_close(trivial, group="all classes"):
    """Judges that do not think and come within three points of the diagnosis."""
    values = {name: by_group[group]["value"] for name, by_group in trivial if group in by_group}
    ours = values.get("this diagnosis")
    return [n for n, v in values.items() if ours is not None and v is not None and v >= ours - 0.03
            and n != "this diagnosis" and "oracle" not in n]
