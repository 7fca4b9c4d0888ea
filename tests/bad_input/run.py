"""Runs `pal` on extreme and broken inputs: run.py PAL [WORD | PART OF]. With WORD only inputs whose description has
it; with two numbers a part of them: every OF-th, from the PART-th on.

Each runs in a process of its own that may take so much memory and time and no more, and must end by itself with the
status and the findings that its input asks for.
"""
import os
import pathlib
import resource
import subprocess
import sys
import tempfile
import time

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import drawings  # noqa: F401, each enters its inputs
import generated  # noqa: F401
import texts  # noqa: F401
from an_input import INPUTS

MEMORY = 2 << 30  # bytes of address space
SECONDS = 10      # of the processor


def limit():
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS))


def run(pal, command, an_input):
    """A line on what happened, and whether it should have."""
    with tempfile.TemporaryDirectory() as folder:
        arguments, status, codes = an_input(pathlib.Path(folder))
        output = pathlib.Path(folder) / "output"
        begin = time.perf_counter()
        with open(output, "wb") as out:
            process = subprocess.Popen([pal, command, *arguments], stdout=out, stderr=out, preexec_fn=limit)
            _, wait_status, usage = os.wait4(process.pid, 0)
            process.returncode = os.waitstatus_to_exitcode(wait_status)
        seconds = usage.ru_utime + usage.ru_stime
        text = output.read_bytes()
    ended = process.returncode
    if ended == 3 and b"no time was checked" in text:
        ended = 0  # nothing is wrong with an input that requires no time
    what = []
    if process.returncode < 0:
        what.append(f"killed by signal {-process.returncode}")
    elif ended > 2 or (status is not None and ended != status):
        what.append(f"ended with {process.returncode}, not {status}")
    what += [f"did not say {code}" for code in codes if code.encode() not in text]
    # Ten thousand findings are kept; as JSON each has its text, its arguments and its place.
    if len(text) > 10 << 20:
        what.append("said too much")
    figures = f"{seconds:5.2f} s {usage.ru_maxrss / 1024:5.0f} MB {len(text) / 1024:6.0f} KB said, status {process.returncode}"
    complaint = ": " + ", ".join(what) + "\n" + text[-600:].decode(errors="replace") if what else ""
    return f"{'WRONG ' if what else 'right '}{figures}  {an_input.__doc__}{complaint}", not what


def main():
    pal = sys.argv[1]
    chosen = INPUTS
    if len(sys.argv) == 4:
        part, of = int(sys.argv[2]), int(sys.argv[3])
        chosen = INPUTS[part - 1::of]
    elif len(sys.argv) == 3:
        chosen = [(command, each) for command, each in INPUTS if sys.argv[2] in each.__doc__]
    good = bool(chosen)
    for command, an_input in chosen:
        line, right = run(pal, command, an_input)
        print(line, flush=True)
        good = good and right
    sys.exit(0 if good else 1)


main()
