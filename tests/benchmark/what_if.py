#!/usr/bin/env python3
"""Times `pal whatif` on skills of the examples, of skills_pal and of tests/benchmark/cases, in the 60 s that it takes at most
unless told otherwise, and in 10 s.

Prints for each skill how many figures it has, how many have an answer after 10 s, how many are exact and how many known on
both sides at the end, and the seconds by the clock and of the processors. A skill that does not hold as it is has no slack:
then every figure has its answer when a requirement is shown to fail, and the rest of the time is for remedies.
"""
import argparse
import json
import pathlib
import resource
import subprocess
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
CASES = {
    "touch": ("skills_pal/touch/touch.pal", "skills_pal/workcell.pal"),
    "insertion": ("examples/insertion/insertion.pal", None),
    "standoff (example)": ("examples/standoff/standoff.pal", None),
    "standoff": ("skills_pal/standoff/standoff.pal", "skills_pal/workcell.pal"),
    "surface-following": ("examples/surface_following/surface_following.pal", None),
    "pull-test": ("examples/pull_test/pull_test.pal", None),
    "pick": ("tests/benchmark/cases/pick/pick.pal", "tests/benchmark/cases/pick/cell.pal"),
    "range": ("tests/benchmark/cases/range/courier2.pal", "tests/benchmark/cases/range/cell.pal"),
    "edge": ("tests/benchmark/cases/edge/force_only.pal", "tests/benchmark/cases/edge/three.pal"),
    "big": ("tests/benchmark/cases/big/big.pal", None),
}


def processor_time():
    """Of all programs that were run, in seconds."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def what_if(pal, case, timeout):
    """The slacks, whether all requirements hold as things are, and both times."""
    file, environment = CASES[case]
    command = [pal, "whatif", str(ROOT / file), "--timeout", timeout, "--format", "json"]
    if environment:
        command += ["--environment", str(ROOT / environment)]
    before, begin = processor_time(), time.monotonic()
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    slacks = [each for answer in json.loads(run.stdout)["what_if"] for each in answer["slack"]]
    return slacks, time.monotonic() - begin, processor_time() - before


def answered(slack):
    """Something is known beyond how things are: a growth that holds, or one that fails."""
    return slack["unlimited"] or (slack["holds_with_growth_ns"] or 0) > 0 or slack["fails_with_growth_ns"] is not None


def both_sided(slack):
    return slack["holds_with_growth_ns"] is not None and slack["fails_with_growth_ns"] is not None


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--pal", default=str(ROOT / "build/release/bin/pal"))
    parser.add_argument("--timeout", default="60s", help="instead of 60 s: where others use the processors")
    parser.add_argument("cases", nargs="*", metavar="CASE", help="some of: " + ", ".join(CASES))
    options = parser.parse_args()
    print("| skill | figures | answered after 10 s | exact | both-sided | one-sided | clock | processors |")
    print("| --- | --- | --- | --- | --- | --- | --- | --- |", flush=True)
    for case in options.cases or CASES:
        first, _, _ = what_if(options.pal, case, "10s")
        slacks, clock, processors = what_if(options.pal, case, options.timeout)
        exact = [each for each in slacks if each["exact"] or each["unlimited"]]
        open_ones = [each for each in slacks if each not in exact]
        both = [each for each in open_ones if both_sided(each)]
        print(f"| {case} | {len(slacks)} | {sum(map(answered, first))} | {len(exact)} | {len(both)} "
              f"| {len(open_ones) - len(both)} | {clock:.0f} s | {processors:.0f} s |", flush=True)


if __name__ == "__main__":
    main()
