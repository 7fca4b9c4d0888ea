#!/usr/bin/env python3
"""Times `pal check` on every skill of skills_pal, in the workcell with one to four of its processors.

A thread of a processor that is left out runs on one that is not: P3 on P1, P2 on P0, P1 on P0. Prints, for each number of
processors, how many skills are checked and refused, how many verdicts are undecided, and the most processor time and memory
that one skill took, with all its requirements.
"""
import argparse
import json
import pathlib
import re
import resource
import subprocess
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
INSTEAD = {"P3": "P1", "P2": "P0", "P1": "P0"}


def workcell(processors):
    """The workcell with so many processors."""
    text = (ROOT / "skills_pal/workcell.pal").read_text()
    for name, other in INSTEAD.items():
        if int(name[1:]) < processors:
            continue
        text = re.sub(rf"^\s*PROCESSOR {name}\b.*\n", "", text, flags=re.MULTILINE)
        text = re.sub(rf"\bON {name}\b", f"ON {other}", text)
    return text


def skills():
    """Files with a skill of this workcell, in order; one that has a workcell of its own beside it is not of this one."""
    files = sorted((ROOT / "skills_pal").glob("*/*.pal"))
    return [file for file in files
            if re.search(r"^SKILL ", file.read_text(), re.MULTILINE) and not (file.parent / "workcell.pal").exists()]


def processor_time():
    """Of all programs that were run, in seconds."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def check(pal, skill, environment):
    """What `pal check` says of each requirement (nothing if the skill may not run so), and its processor time."""
    before = processor_time()
    run = subprocess.run(
        [pal, "check", str(skill), "--environment", str(environment), "--format", "json", "--statistics"],
        capture_output=True, text=True, check=False)
    return json.loads(run.stdout)["requirements"], processor_time() - before


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--pal", default=str(ROOT / "build/release/bin/pal"))
    options = parser.parse_args()
    print("| processors | skills | refused | requirements | undecided | most processor time | most memory |")
    print("| --- | --- | --- | --- | --- | --- | --- |")
    for processors in (4, 3, 2, 1):
        with tempfile.NamedTemporaryFile("w", suffix=".pal", dir=ROOT / "skills_pal") as file:
            file.write(workcell(processors))
            file.flush()
            found = [check(options.pal, skill, file.name) for skill in skills()]
        every = [each for of, _ in found for each in of]
        undecided = [f"{each['skill']}.{each['name']}" for each in every if each["verdict"] == "undecided"]
        print("| {} | {} | {} | {} | {} | {:.2f} s | {:.0f} MB |".format(
            processors, len(found), sum(1 for of, _ in found if not of), len(every), ", ".join(undecided) or "none",
            max(seconds for _, seconds in found),
            max(each["statistics"]["peak_bytes"] for each in every) / 1e6), flush=True)


if __name__ == "__main__":
    main()
