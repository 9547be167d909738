"""Judges verdicts: one case at a time (`judge`), then rates over many (`table`).

A case without a verdict (crash, time-out) counts as wrong in every row that it belongs to.
"""

import chance

CONFIDENT = 0.8


def cause_names(cause):
    return cause.get("names") or [cause["name"]]


def equivalents(verdict):
    """All causes that the verdict does not tell apart from its own."""
    return set(verdict.get("names", [])) | set(verdict.get("indistinguishable_from", []))


def named_first(truth, verdict):
    """The right cause first; one of at most two that the data cannot tell apart counts as well."""
    wanted = set(truth["names"])
    names = verdict.get("names", [])
    if truth["kind"] in ("none", "unknown"):
        return verdict["kind"] == truth["kind"]
    if verdict["kind"] == truth["kind"] and (set(names) == wanted or (len(wanted) == 1 and names[:1] == truth["names"])):
        return True
    members = equivalents(verdict)
    return len(wanted) == 1 and len(members) <= 2 and wanted <= members


def among_first(truth, report, count=3):
    """Every true cause is in one of the first causes, or in the verdict itself."""
    listed = [name for cause in report.get("causes", [])[:count] for name in cause_names(cause)]
    return set(truth["names"]) <= set(listed) | set(report["verdict"].get("names", []))


def overlap(a, b):
    """Common part of two strata over their union."""
    if all(isinstance(x, (int, float)) for x in (*a, *b)) and len(a) == len(b) == 2:
        common, union = min(a[1], b[1]) - max(a[0], b[0]), max(a[1], b[1]) - min(a[0], b[0])
        return max(0.0, common) / union if union > 0 else 1.0
    return len(set(a) & set(b)) / len(set(a) | set(b))


# These change where echoes are rather than what they carry: "missing" or "extra" names them as well as the pooled ranges, which a
# few echoes from far away move most.
OF_EXISTENCE = {"crosstalk", "false-alarm", "detection-loss", "precipitation-clutter", "atmospheric-backscatter", "road-spray",
                "exhaust-cloud", "stray-radiation", "spoofing", "range-gating", "transmission", "multipath", "blooming",
                "echo-merging", "dead-time"}


def in_standing_measurand(truth, report):
    """Whether the first row is in a measurand in which the gap stands out beam by beam (standing.py); None where none does."""
    if not truth.get("stands_out"):
        return None
    return bool(report.get("where")) and report["where"][0]["measurand"] in {*truth["stands_out"], *existence_of(truth)}


def existence_of(truth):
    return {"existence"} if OF_EXISTENCE & set(truth["names"]) else set()


def judge_where(truth, report):
    """(right measurand, right stratum) of the first row; None where the truth does not say."""
    rows = report.get("where", [])
    if not truth["measurands"]:
        return None, None
    if not rows:
        return False, (False if truth["where"] else None)
    measurand = rows[0]["measurand"] in {*truth["measurands"], *existence_of(truth)}
    if not truth["where"]:
        return measurand, None
    first = next((r for r in rows if r["covariate"] == truth["where"]["covariate"]), None)
    return measurand, bool(first) and is_stratum(first, truth["where"]["stratum"])


def is_stratum(row, true):
    """Whether a row's stratum overlaps the true one by half, or lies in it and holds half of the gap: its ends are beams, and a sector of
    a fifth of a degree holds one."""
    stratum = row["stratum"]
    if overlap(stratum, true) >= 0.5:
        return True
    numeric = all(isinstance(x, (int, float)) for x in (*stratum, *true)) and len(stratum) == len(true) == 2
    return numeric and row["share"] >= 0.5 and true[0] <= stratum[0] <= stratum[1] <= true[1]


def recovery(truth, report):
    """Relative errors of the true cause's parameters, where the verdict names it and fits numbers."""
    errors = []
    for name in truth["names"]:
        cause = next((c for c in report.get("causes", []) if name in cause_names(c) and name in report["verdict"].get("names", [])), None)
        if not cause:
            continue
        true = truth["parameters"].get(name, truth["parameters"]) if truth["kind"] == "effect" else truth["parameters"]
        found = cause.get("parameters", {})
        if truth["kind"] == "parameter":
            pairs = [(true.get("value"), next(iter(found.values()), None))]
        elif truth["kind"] == "reference":
            pairs = [(true.get("everywhere"), next(iter(found.values()), None))]
        else:
            pairs = [(v, found.get(k)) for k, v in true.items()] if isinstance(true, dict) else []
        for value, fit in pairs:
            if isinstance(value, (int, float)) and isinstance(fit, dict) and isinstance(fit.get("value"), (int, float)) and value:
                errors.append(abs(fit["value"] - value) / abs(value))
    return errors


def right_sensors(truth, report):
    """Whether the cause is said to hold on the sensors on which it does; None where one sensor measured."""
    if truth.get("sensors") is None or not truth["names"]:
        return None
    cause = next((c for c in report.get("causes", []) if truth["names"][0] in cause_names(c)), {})
    return sorted(cause.get("sensors", [])) == sorted(truth["sensors"])


def judge(case, result):
    """Everything that the table counts, of one case."""
    truth = case["truth"]
    row = {"id": case["id"], "class": case["class"], "name": case["name"], "truth": truth["names"] or [truth["kind"]],
           "truth_kind": truth["kind"], "family": case["family"], "generator": case["generator"], "severity": case["severity"]["value"],
           "bin": case["severity"].get("bin"), "status": result["status"], "elapsed_s": result["elapsed_s"], "peak_mib": result.get("peak_mib"), "right": False,
           "top3": False, "found": [], "kind": result["status"], "confidence": None, "where": None, "stratum": None, "errors": []}
    if case["severity"].get("members"):
        row["least_member"] = min(case["severity"]["members"].values())
    if truth["measurands"]:
        row["where"] = False
    if truth.get("stands_out"):
        row["standing"] = False
    if truth.get("oracle"):
        row["oracle"] = truth["oracle"]["shrink"]
    if result["status"] != "done":
        return row
    report, verdict = result["report"], result["report"]["verdict"]
    confidence = float(verdict.get("confidence") or 0.0)
    where, stratum = judge_where(truth, report)
    right = named_first(truth, verdict)
    if case["class"] == "ambiguous":  # a large set, or low confidence, is the honest answer there
        right = right or set(truth["names"]) <= equivalents(verdict)
    if case["class"] == "beside":
        row["sensors"] = right and right_sensors(truth, report)
    claimed = report.get("shrink") or {}
    claimed = claimed.get("as_run") or claimed  # what it brings is measured with the model as it is run
    row.update(right=right, top3=right or bool(truth["names"]) and among_first(truth, report), kind=verdict["kind"],
               found=verdict.get("names", []), equivalents=sorted(equivalents(verdict) - set(verdict.get("names", []))),
               confidence=confidence, where=where, stratum=stratum,
               standing=in_standing_measurand(truth, report), errors=recovery(truth, report) if right else [],
               both=set(truth["names"]) <= set(verdict.get("names", [])), exact=set(truth["names"]) == set(verdict.get("names", [])),
               claimed=claimed.get("fraction"), interval=claimed.get("interval"), text=verdict.get("text", ""), evidence=verdict.get("evidence", {}))
    actual = result.get("actual") or {}
    if "shrink" in actual:
        row["actual"] = actual["shrink"]
    return row


def rate(rows, test):
    """{value, interval, n}; rows for which the test says None do not count."""
    verdicts = [v for v in map(test, rows) if v is not None]
    hits = sum(map(bool, verdicts))
    low, high = chance.wilson(hits, len(verdicts))
    return {"value": hits / len(verdicts) if verdicts else None, "interval": [low, high], "n": len(verdicts)}


def of_class(rows, *classes):
    return [r for r in rows if r["class"] in classes]


def claims_effect(row):
    return row["kind"] == "effect"


def programs_differ(row):
    """Even the true cause at its true values does not shrink the gap in the built-in model: what such a case measures is the difference
    between the two programs beside the diagnosis."""
    names_one = row["truth_kind"] in ("effect", "parameter", "reference")
    return names_one and row["generator"] != "own" and row.get("oracle") is not None and row["oracle"] <= 0


SAID = ("none", "unknown", "one effect", "two effects", "parameter", "reference")


def kind_said(row):
    """What the verdict says, one of SAID: kinds of verdict are believed by how often they were right."""
    return row["kind"] if not claims_effect(row) else "one effect" if len(row["found"]) == 1 else "two effects"


def flagged(row):
    return row["kind"] == "unknown"


def confidently_wrong(row):
    return claims_effect(row) and row["confidence"] >= CONFIDENT


def number(value, n):
    return {"value": value, "interval": None, "n": n}


def table(rows):
    """[(what, wanted, result)] in the order of the aims."""
    single = of_class(rows, "effect")
    pairs = [r for r in of_class(rows, "pair") if r.get("least_member") is not None]  # older sets do not say it
    strong, fair, weak = ([r for r in single if r["bin"] in b] for b in ((2, 4), (1,), (0.5,)))
    seen = [r for r in rows if (r["bin"] or 0) >= 1]
    shrunk = [r for r in rows if r.get("actual") is not None and r.get("claimed") is not None]
    for r in shrunk:
        r["shrink_error"] = abs(r["claimed"] - r["actual"])
    reached = [max(0.0, r["actual"]) / r["oracle"] for r in rows if r.get("actual") is not None and (r.get("oracle") or 0) > 0.2]
    agree = lambda part: [r for r in part if not programs_differ(r)]
    errors = [e for r in rows for e in r["errors"]]
    told = [r for r in rows if r["confidence"] is not None]
    ece = chance.expected_calibration_error([r["confidence"] for r in told], [r["right"] for r in told])
    return [
        ("right cause first, s >= 2", ">= 0.95", rate(strong, lambda r: r["right"])),
        ("right cause first, s = 1", ">= 0.85", rate(fair, lambda r: r["right"])),
        ("right cause first, s = 0.5", "", rate(weak, lambda r: r["right"])),
        ("the same where the two programs agree, s >= 2", ">= 0.95", rate(agree(strong), lambda r: r["right"])),
        ("the same where the two programs agree, s = 1", ">= 0.85", rate(agree(fair), lambda r: r["right"])),
        ("the same where the two programs agree, s = 0.5", "", rate(agree(weak), lambda r: r["right"])),
        ("among the first three, s >= 2", ">= 0.99", rate(strong, lambda r: r["top3"])),
        ("among the first three, s = 1", ">= 0.95", rate(fair, lambda r: r["top3"])),
        ("pair: both found", ">= 0.85", rate(of_class(rows, "pair"), lambda r: r.get("both", False))),
        ("pair: exactly these", ">= 0.70", rate(of_class(rows, "pair"), lambda r: r.get("exact", False))),
        ("pair: both found, each with s >= 2 beside the other", "",
         rate([r for r in pairs if r["least_member"] >= 2.0], lambda r: r.get("both", False))),
        ("pair: both found, the weaker one with s < 2", "",
         rate([r for r in pairs if r["least_member"] < 2.0], lambda r: r.get("both", False))),
        ("effect claimed where nothing is missing or the reference is wrong", "<= 0.02",
         rate(of_class(rows, "none", "reference"), claims_effect)),
        ("nothing missing: said so", "", rate(of_class(rows, "none"), lambda r: r["right"])),
        ("reference, with the right quantity", ">= 0.90", rate(of_class(rows, "reference"), lambda r: r["right"])),
        ("parameter, the right one", ">= 0.90", rate(of_class(rows, "parameter"), lambda r: r["right"])),
        ("outside the library: flagged as unknown", ">= 0.90", rate(of_class(rows, "outside", "removed"), flagged)),
        ("outside the library: confidently wrong", "<= 0.03", rate(of_class(rows, "outside", "removed"), confidently_wrong)),
        ("a law that no library has: flagged as unknown", "", rate(of_class(rows, "outside"), flagged)),
        ("a law that no library has: confidently wrong", "", rate(of_class(rows, "outside"), confidently_wrong)),
        ("an effect taken out of the library: flagged as unknown", "", rate(of_class(rows, "removed"), flagged)),
        ("an effect taken out of the library: confidently wrong", "", rate(of_class(rows, "removed"), confidently_wrong)),
        ("hidden by recalibration: right effect", ">= 0.75",
         rate(of_class(rows, "hidden"), lambda r: r["right"] or set(r["truth"]) <= set(r["found"]))),
        ("design that cannot tell: not confidently wrong", "", rate(of_class(rows, "ambiguous"), lambda r: r["right"] or (
            r["confidence"] or 0.0) < CONFIDENT and r["status"] == "done")),
        ("sensors side by side: right cause", "", rate(of_class(rows, "beside"), lambda r: r["right"])),
        ("sensors side by side: right cause on the right sensors", "",
         rate([r for r in of_class(rows, "beside") if r["truth_kind"] == "effect"], lambda r: bool(r.get("sensors")))),
        ("all classes: right", "", rate(rows, lambda r: r["right"])),
        ("all classes: right, where the two programs agree", "", rate(agree(rows), lambda r: r["right"])),
        ("all classes: right, where they differ by more than the cause", "", rate([r for r in rows if programs_differ(r)], lambda r: r["right"])),
        ("first where row in a measurand in which the gap stands out", ">= 0.95",
         rate(seen, lambda r: r.get("standing"))),
        ("first where row in a measurand that holds much of the gap", "", rate(seen, lambda r: r["where"])),
        ("where: right stratum, where the truth has one", ">= 0.95", rate([r for r in seen if r["class"] != "hidden"], lambda r: r["stratum"])),
        ("claimed against actual shrink, median error", "<= 0.05", number(chance.median([r["shrink_error"] for r in shrunk]), len(shrunk))),
        ("actual shrink inside the claimed interval", "0.85 ... 0.95", rate(shrunk, lambda r: None if not r.get("interval") else
         r["interval"][0] <= r["actual"] <= r["interval"][1])),
        ("share of the oracle's shrink reached, median", ">= 0.97", number(chance.median(reached), len(reached))),
        ("parameters recovered, median relative error", "<= 0.05", number(chance.median(errors), len(errors))),
        ("expected calibration error of the confidence", "<= 0.04", number(ece, len(told))),
        ("what chance makes of it where every confidence is true", "",
         number(chance.calibration_error_by_chance([r["confidence"] for r in told]), len(told))),
        *((f"verdicts of this kind that are right: {said}", "", rate(told, lambda r: r["right"] if kind_said(r) == said else None)) for said in SAID),
        ("processor time of a diagnosis in s, median", "", number(chance.median([r["elapsed_s"] for r in rows]), len(rows))),
        ("processor time of a diagnosis in s, longest", "", number(max((r["elapsed_s"] for r in rows), default=None), len(rows))),
        ("memory of a diagnosis in MiB, most", "<= 2048", number(max((r["peak_mib"] for r in rows if r["peak_mib"]), default=None), len(rows))),
        ("without a verdict (crash, time-out)", "0", rate(rows, lambda r: r["status"] != "done")),
    ]


def per_name(rows):
    """Right first and among three for every name in every class: [(class, name, first, top3)]."""
    keys = sorted({(r["class"], r["name"]) for r in rows})
    group = {k: [r for r in rows if (r["class"], r["name"]) == k] for k in keys}
    return [(c, n, rate(group[c, n], lambda r: r["right"]), rate(group[c, n], lambda r: r["top3"])) for c, n in keys]
