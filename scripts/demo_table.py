#!/usr/bin/env python3
"""Prints what the demo proved and measured, from the files that it wrote: demo_table.py out/demo"""
import csv
import json
import pathlib
import sys


def load(path):
    return json.loads(path.read_text(encoding="utf-8"))


def figure(measure, value):
    if value is None:
        return "-"
    return f"{value / 1e7:.2f} %" if measure == "load" else f"{value / 1e6:.2f} ms"


def requirement_rows(out):
    """One row a requirement: skill, name, verdict, limit, proved bound, measured in the run in physics."""
    for skill, run in (("touch", "touch"), ("touch-read-first", "read-first")):
        measured = {row["name"]: row["measured_ns"] for row in load(out / run / "run.json")["requirements"]}
        for row in load(out / f"{skill}.check.json")["requirements"]:
            measure = row["measure"]
            yield (skill, row["name"], row["verdict"], figure(measure, row["limit_ns"]),
                   figure(measure, row["bound_ns"]) + (" exact" if row["exact"] else ""),
                   figure(measure, measured.get(row["name"])))


def overshoot_rows(out):
    """One row a skill: runs, least, median, mean and greatest force past the threshold, recomputed from the runs."""
    with open(out / "sweep" / "sweep.csv", encoding="utf-8", newline="") as file:
        runs = [row for row in csv.DictReader(file) if row["completion"] == "0" and row["fault"] == "0"]
    for skill in ("touch", "touch-read-first"):
        values = sorted(float(row["overshoot_N"]) for row in runs if row["skill"] == skill)
        middle = (values[(len(values) - 1) // 2] + values[len(values) // 2]) / 2
        yield (skill, str(len(values)), *(f"{value:.2f}" for value in
                                          (values[0], middle, sum(values) / len(values), values[-1])))


def show(head, rows):
    rows = [head, *rows]
    widths = [max(len(row[i]) for row in rows) for i in range(len(head))]
    for row in rows:
        print("  " + "  ".join(cell.ljust(width) for cell, width in zip(row, widths)).rstrip())


def main(out):
    print("\nProved over all runs, and measured in one run in physics")
    show(("skill", "requirement", "verdict", "limit", "proved", "measured"), list(requirement_rows(out)))
    print("\nForce past the threshold over the phases of the two clocks, N")
    show(("skill", "runs", "least", "median", "mean", "greatest"), list(overshoot_rows(out)))
    comparison = load(out / "sweep" / "sweep.json").get("comparison")
    if comparison:
        print(f"  At rest the read-first order presses {comparison['resting_difference_N']:.2f} N more; its older values predict "
              f"{comparison['predicted_N']:.2f} N.")
    print("\nEndings")
    show(("run", "completion", "reason"),
         [(run, str(load(out / run / "run.json")["completion"]["code"]), load(out / run / "run.json")["completion"]["reason"])
          for run in ("touch", "nothing", "read-first")])
    print("\nPictures")
    for path in sorted([*out.rglob("*.svg"), *out.rglob("*.png")]):
        print(f"  {path}")


main(pathlib.Path(sys.argv[1]))
