#!/usr/bin/env python3
"""Times `pal check` without times on generated specifications, and `pal --version`.

Usage: tests/benchmark/check.py [--pal PROGRAM] [--runs N] [--lines N …]

Prints the median of the runs, and the greatest memory of any. docs/internals/benchmarks.md has figures and the machine they are of.
"""
import argparse
import os
import statistics
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import specification


def measure(command):
    """Seconds of one run and of its processor, and megabytes at its peak. The command must end with 0."""
    begin = time.perf_counter()
    with subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE) as process:
        text = process.stderr.read()
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
    seconds = time.perf_counter() - begin
    if process.returncode != 0:
        sys.exit(f"{command[:3]} … ended with {process.returncode}:\n{text.decode()[:2000]}")
    return seconds, usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def medians(command, runs):
    results = [measure(command) for _ in range(runs)]
    return (statistics.median(r[0] for r in results), statistics.median(r[1] for r in results),
            max(r[2] for r in results))


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--pal", default="build/release/bin/pal")
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--lines", type=int, nargs="+", default=[1000, 10000, 100000])
    options = parser.parse_args()
    wall, processor, peak = medians([options.pal, "--version"], max(options.runs, 20))
    print(f"pal --version: {wall * 1000:.1f} ms ({processor * 1000:.1f} ms of the processor), {peak:.0f} MB")
    for lines in options.lines:
        with tempfile.TemporaryDirectory() as folder:
            files, written = specification.write(folder, lines)
            wall, processor, peak = medians([options.pal, "check", "--without-times", *files], options.runs)
        print(f"pal check of {written} lines in {2 * len(files) + 1} files: {wall:.3f} s ({processor:.3f} s of the "
              f"processor), {peak:.0f} MB, {1e6 * processor / written:.1f} us a line")


main()
