#!/usr/bin/env python3
"""Times studies: a study on one process and on two, by GNU parallel in blocks, again with nothing changed, and one of 100,000 cells.

Prints seconds; what two processes reach of half the time of one; what they reach of two studies of half the size at the same time, which
is what the machine's two cores can do; what GNU parallel adds to two processes, on the wall and in processor time, which other work on the
machine changes less; and the time and memory of a study of which all proofs are kept. The large study is of a small skill, so that its proofs are made in minutes.
"""
import argparse
import os
import pathlib
import platform
import resource
import shutil
import statistics
import subprocess
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
HEAD = """title = "A benchmark"
files = ["{root}/{skill}"]
environments = ["{root}/{cell}"]
environment-names = ["{environment}"]
[[figure]]
name = "SEND"
from = "{first} us"
to = "{send} us"
step = "1 us"
[[figure]]
name = "RECEIVE"
from = "1 us"
to = "{receive} us"
step = "1 us"
"""


SKILL = {"skill": "skills_pal/move_cartesian/move_cartesian.pal", "cell": "skills_pal/workcell_one_processor.pal",
         "environment": "one-processor"}
SMALL = {"skill": "tests/documents/ci/dip.pal", "cell": "tests/documents/ci/bench.pal", "environment": "bench"}


def timed(words):
    """Seconds, and the most memory in MB of what was run up to now."""
    begin = time.monotonic()
    subprocess.run(words, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return time.monotonic() - begin, resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024


def worked():
    """Seconds of processor time of all that was run up to now, and of what that has run."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--pal", default=str(ROOT / "build/release/bin/pal"))
    parser.add_argument("--proofs", type=int, default=2000)
    parser.add_argument("--repeats", type=int, default=3, help="the median of so many runs, one after another in turn")
    parser.add_argument("--cells", type=int, default=100_000, help="of the large study; 0: none")
    options = parser.parse_args()
    place = pathlib.Path(tempfile.mkdtemp(prefix="pal-studies-"))
    print(f"{platform.machine()}, {os.cpu_count()} cores, load {os.getloadavg()[0]:.1f}")
    study = place / "study.toml"
    study.write_text(HEAD.format(root=ROOT, first=1, send=50, receive=options.proofs // 50, **SKILL))
    halves = [place / "low.toml", place / "high.toml"]
    for half, first in zip(halves, [1, 26]):
        half.write_text(HEAD.format(root=ROOT, first=first, send=first + 24, receive=options.proofs // 50, **SKILL))
    large = place / "large.toml"
    large.write_text(HEAD.format(root=ROOT, first=1, send=1000, receive=options.cells // 1000, **SMALL))
    try:
        def sweep(folder, *more):
            return timed([options.pal, "sweep", str(study), "-o", str(place / folder), *more])[0]

        def apart():
            """Seconds in which both halves of the study are made at the same time, each by a process of its own."""
            begin = time.monotonic()
            running = [subprocess.Popen([options.pal, "sweep", str(half), "-o", str(place / half.stem), "--jobs", "1"],
                                        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL) for half in halves]
            if any([process.wait() for process in running]):
                raise RuntimeError("half of the study failed")
            return time.monotonic() - begin
        times = {"one": [], "two": [], "apart": [], "parallel": []}
        work = {"two": [], "parallel": []}

        def noted(what, *more):
            before = worked()
            times[what].append(sweep(what, *more))
            if what in work:
                work[what].append(worked() - before)
        for _ in range(options.repeats):
            for folder in ["one", "two", "low", "high", "parallel"]:
                shutil.rmtree(place / folder, ignore_errors=True)
            noted("one", "--jobs", "1")
            noted("two", "--jobs", "2")
            times["apart"].append(apart())
            noted("parallel", "--engine", "parallel", "--jobs", "2", "--block", str(options.proofs // 4))
        one, two, split, blocks = (statistics.median(times[what]) for what in times)
        print(f"{options.proofs} proofs: one process {one:.1f} s, two {two:.1f} s: {100 * one / 2 / two:.1f} % of half of one")
        print(f"two studies of half the size at the same time: {split:.1f} s: {100 * split / two:.1f} % of what two cores can do")
        print(f"GNU parallel, four blocks: {blocks:.1f} s, {100 * (blocks / two - 1):+.1f} % beside two processes")
        alone, with_blocks = (statistics.median(each) for each in work.values())
        print(f"processor time: two processes {alone:.1f} s, GNU parallel {with_blocks:.1f} s, {100 * (with_blocks / alone - 1):+.1f} %")
        same = all((place / "one" / name).read_bytes() == (place / other / name).read_bytes()
                   for name in ["table.csv", "table.json", "summary.md"] for other in ["two", "parallel"])
        print(f"the same tables: {'yes' if same else 'NO'}")
        print(f"again with nothing changed: {sweep('two'):.2f} s")
        if options.cells:
            timed([options.pal, "sweep", str(large), "-o", str(place / "large"), "--jobs", "2"])
            seconds, memory = timed([options.pal, "sweep", str(large), "-o", str(place / "large")])
            print(f"{options.cells} proofs, all kept: {seconds:.1f} s, at most {memory:.0f} MB in any run")
    finally:
        shutil.rmtree(place)


if __name__ == "__main__":
    main()
