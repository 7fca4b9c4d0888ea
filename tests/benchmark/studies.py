#!/usr/bin/env python3
"""Times studies: a study on one process and on two, by GNU parallel in blocks, again with nothing changed, and one of 100,000 cells.

Prints seconds, what two processes reach of half the time of one, what GNU parallel adds to two processes, and the time and memory of
a study of which all proofs are kept.
"""
import argparse
import os
import pathlib
import platform
import resource
import shutil
import subprocess
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
HEAD = """title = "A benchmark"
files = ["{root}/skills_pal/{skill}.pal"]
environments = ["{root}/skills_pal/workcell_one_processor.pal"]
environment-names = ["one-processor"]
[[figure]]
name = "SEND"
from = "1 us"
to = "{send} us"
step = "1 us"
[[figure]]
name = "RECEIVE"
from = "1 us"
to = "{receive} us"
step = "1 us"
"""


def timed(words):
    """Seconds, and the most memory in MB of what was run up to now."""
    begin = time.monotonic()
    subprocess.run(words, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return time.monotonic() - begin, resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--pal", default=str(ROOT / "build/release/bin/pal"))
    parser.add_argument("--proofs", type=int, default=2000)
    parser.add_argument("--cells", type=int, default=100_000, help="of the large study; 0: none")
    options = parser.parse_args()
    place = pathlib.Path(tempfile.mkdtemp(prefix="pal-studies-"))
    print(f"{platform.machine()}, {os.cpu_count()} cores, load {os.getloadavg()[0]:.1f}")
    study = place / "study.toml"
    study.write_text(HEAD.format(root=ROOT, skill="move_cartesian/move_cartesian", send=50, receive=options.proofs // 50))
    large = place / "large.toml"
    large.write_text(HEAD.format(root=ROOT, skill="move_cartesian/move_cartesian", send=1000, receive=options.cells // 1000))
    try:
        def sweep(folder, *more):
            return timed([options.pal, "sweep", str(study), "-o", str(place / folder), *more])[0]
        one, two = sweep("one", "--jobs", "1"), sweep("two", "--jobs", "2")
        print(f"{options.proofs} proofs: one process {one:.1f} s, two {two:.1f} s: {100 * one / 2 / two:.1f} % of ideal")
        blocks = sweep("parallel", "--engine", "parallel", "--jobs", "2", "--block", str(options.proofs // 4))
        print(f"GNU parallel, four blocks: {blocks:.1f} s, {100 * (blocks / two - 1):+.1f} % beside two processes")
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
