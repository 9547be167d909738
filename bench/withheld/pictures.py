"""Confusion matrix and reliability diagram as SVG. The only place that needs matplotlib."""

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

import chance

plt.rcParams.update({"svg.hashsalt": "withheld", "font.size": 8, "svg.fonttype": "none"})
NO_DATE = {"Date": None}


def label(kind, names):
    if kind in ("parameter", "reference"):
        return f"{kind}: " + "/".join(names[0].split("/")[-2:]) if names else kind
    return "+".join(names) or kind


def confusion(rows, path):
    """Rows: what is true. Columns: what was said. Pairs and ambiguous designs are left out."""
    rows = [r for r in rows if r["class"] not in ("pair", "ambiguous")]
    group = lambda kind, names: kind if kind in ("parameter", "reference") else label(kind, names[:1])
    truth = [group(r["truth_kind"], r["truth"] if r["truth_kind"] in ("effect",) else []) for r in rows]
    said = [r["found"][0] if r["kind"] == "effect" and len(r["found"]) == 1 else "two effects" if r["kind"] == "effect" else r["kind"]
            for r in rows]
    down, across = sorted(set(truth)), sorted(set(truth) | set(said))
    counts = [[sum(t == a and s == b for t, s in zip(truth, said)) for b in across] for a in down]
    shares = [[n / max(1, sum(line)) for n in line] for line in counts]
    figure, axes = plt.subplots(figsize=(2 + 0.22 * len(across), 1.8 + 0.2 * len(down)))
    axes.imshow(shares, cmap="Blues", vmin=0, vmax=1, aspect="auto")
    for i, line in enumerate(counts):
        for j, n in enumerate(line):
            if n:
                axes.text(j, i, n, ha="center", va="center", fontsize=6, color="white" if shares[i][j] > 0.5 else "black")
    axes.set_xticks(range(len(across)), across, rotation=90)
    axes.set_yticks(range(len(down)), down)
    axes.set_xlabel("said")
    axes.set_ylabel("true")
    figure.savefig(path, bbox_inches="tight", metadata=NO_DATE)
    plt.close(figure)


def reliability(rows, path):
    told = [r for r in rows if r["confidence"] is not None]
    points = chance.reliability([r["confidence"] for r in told], [r["right"] for r in told])
    figure, axes = plt.subplots(figsize=(3.6, 3.4))
    axes.plot([0, 1], [0, 1], color="grey", linewidth=0.8)
    for confidence, right, n in points:
        low, high = chance.wilson(round(right * n), n)
        axes.plot([confidence, confidence], [low, high], color="tab:blue", linewidth=1)
        axes.plot(confidence, right, "o", color="tab:blue", markersize=4)
        axes.annotate(n, (confidence, right), textcoords="offset points", xytext=(5, -8), fontsize=7)
    axes.set(xlabel="confidence", ylabel="share right", xlim=(0, 1.03), ylim=(0, 1.03))
    figure.savefig(path, bbox_inches="tight", metadata=NO_DATE)
    plt.close(figure)
