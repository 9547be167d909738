#!/usr/bin/env python3
"""How often verdicts of fresh cases were right, by what they said and how far they were believed.

    bench/withheld/calibration.py [--since 2026-11-25] [--sets docs/withheld]

The confidences of docs/diagnosis.md were chosen by this table. Verdicts with which other causes are tied stand in rows of their own.
"""

import argparse
from pathlib import Path

import chance
import score
import sets

EDGES = (0.0, 0.45, 0.505, 0.6, 0.7, 0.8, 0.9, 1.0)


def told_as(row):
    """What kind of verdict a row is (score.SAID), and with how many other causes it is tied."""
    return score.kind_said(row) + ("", ", tied with one", ", tied with more")[min(2, len(row["equivalents"]))]


def lines(rows):
    for said in sorted({told_as(r) for r in rows}):
        of_kind = [r for r in rows if told_as(r) == said]
        for low, high in zip(EDGES, EDGES[1:]):
            part = [r for r in of_kind if low <= r["confidence"] < high]
            if part:
                right = sum(bool(r["right"]) for r in part)
                interval = chance.wilson(right, len(part))
                mean = sum(r["confidence"] for r in part) / len(part)
                yield f"| {said} | {mean:.2f} | {right} of {len(part)} | {right / len(part):.2f} [{interval[0]:.2f}, {interval[1]:.2f}] |"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--since", default="", metavar="DATE", help="only sets of this day and later")
    parser.add_argument("--sets", type=Path, default=Path(__file__).parents[2] / "docs" / "withheld", help="folder with sets/")
    options = parser.parse_args()
    rows = [r for s in sets.read(options.sets) if s["date"] >= options.since for r in s["cases"] if r["confidence"] is not None]
    print("| verdict | believed | right | rate |\n|-|-|-|-|")
    print("\n".join(lines(rows)))
    ece = chance.expected_calibration_error([r["confidence"] for r in rows], [r["right"] for r in rows])
    print(f"\n{len(rows)} verdicts, expected calibration error {ece:.3f}")


if __name__ == "__main__":
    main()
