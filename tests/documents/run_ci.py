"""A pipeline written from docs/how-to/ci.md alone turns red for whatever is wrong: run_ci.py PAL SOURCE_DIR FOLDER.

Takes the commands of both services' files and of "Try it first" from the page, and runs each as the service does (sh -e) in a folder with
dip.pal and bench.pal. It must end with 0 where all holds, and with another status in every other case; its report must be red, too.
"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import xml.etree.ElementTree

PAGE = "docs/how-to/ci.md"
FAULTS = []


def commands(page):
    """The lines of the page that run pal, by where they stand."""
    found = {}
    for title, block in re.findall(r"^## (.*?)\n(.*?)(?=^## |\Z)", page, re.M | re.S):
        for line in block.splitlines():
            match = re.fullmatch(r"\s*(?:run: |- )?(pal check .*)", line)
            if match:
                found.setdefault(title, []).append(re.sub(r"; echo \$\?$", "", match[1]))
    return [(title, command) for title, lines in found.items() for command in lines]


def scenarios(source):
    """Name, the files (text, bytes or None for a folder of that name), whether it must be green."""
    skill = (source / "tests/documents/ci/dip.pal").read_text()
    bench = (source / "tests/documents/ci/bench.pal").read_text()
    undecided = (source / "tests/unit/program/unknown_load.pal").read_text()
    begin = undecided.index("ENVIRONMENT")
    return [
        ("all holds", {"dip.pal": skill, "bench.pal": bench}, True),
        ("late skill", {"dip.pal": skill.replace("6 ms", "5 ms"), "bench.pal": bench}, False),
        ("undecided requirement", {"dip.pal": undecided[:begin], "bench.pal": undecided[begin:]}, False),
        ("never measured", {"dip.pal": skill.replace("INTERVAL OF WTM( force from LS1 )", "DURATION TO COMPLETION 1"),
                            "bench.pal": bench}, False),
        ("missing environment", {"dip.pal": skill, "bench.pal": "MESSAGE other : SIGNAL\n"}, False),
        ("empty environment file", {"dip.pal": skill, "bench.pal": ""}, False),
        ("no requirement", {"dip.pal": re.sub(r".*REQUIREMENT.*\n", "", skill), "bench.pal": bench}, False),
        ("one skill of two without a requirement",
         {"dip.pal": skill + skill.replace("SKILL press", "SKILL other").split("Logical Sensor:")[0].split("pressed FROM force\n")[1]
          .replace("  REQUIREMENT brisk : INTERVAL OF WTM( force from LS1 ) AT MOST 6 ms\n", ""), "bench.pal": bench}, False),
        ("no skill", {"dip.pal": "MESSAGE force : REAL N\n", "bench.pal": bench}, False),
        ("missing file", {"bench.pal": bench}, False),
        ("missing file of the environment", {"dip.pal": skill}, False),
        ("missing file of a USES", {"dip.pal": 'USES "gone.pal"\n' + skill, "bench.pal": bench}, False),
        ("unreadable file", {"dip.pal": None, "bench.pal": bench}, False),
        ("file that is no text", {"dip.pal": b"\xff\xfe\x00" + skill.encode(), "bench.pal": bench}, False),
        ("wrong specification", {"dip.pal": skill.replace("SPC( pressed )", "SPC( presed )"), "bench.pal": bench}, False),
    ]


def is_red(command, folder):
    """Whether a service that looks at the report only shows something red, or refuses it."""
    name = re.search(r"> (\S+)", command)
    if name is None:
        return True
    text = (folder / name[1]).read_bytes()
    if name[1].endswith(".sarif"):
        if not text:
            return True
        (run,) = json.loads(text)["runs"]
        for result in run["results"]:
            place = result["locations"][0]["physicalLocation"]
            if not place["artifactLocation"]["uri"] or place["region"]["startLine"] < 1:
                FAULTS.append(f"{folder.name}: {result['ruleId']} has no place")
        return any(result["level"] == "error" for result in run["results"])
    if not text:
        return True
    suites = xml.etree.ElementTree.fromstring(text)
    return any(suite.get("failures") != "0" or suite.get("errors") != "0" for suite in suites)


def run(command, folder, path, what, green):
    done = subprocess.run(["sh", "-e", "-c", command], cwd=folder, env={**os.environ, "PATH": path, "BASE": "origin/main"}, capture_output=True,
                          check=False)
    if (done.returncode == 0) != green:
        FAULTS.append(f"{what}: `{command}` ended with {done.returncode}\n{done.stderr.decode(errors='replace')[-800:]}")
    return done.returncode


def main(pal, source, folder):
    source, folder = pathlib.Path(source), pathlib.Path(folder)
    lines = commands((source / PAGE).read_text(encoding="utf-8"))
    if len(lines) != 9 or {"GitHub", "GitLab"} - {title.split(":")[0] for title, _ in lines}:
        sys.exit(f"{PAGE}: {len(lines)} commands, where three pairs for two services and three trials were expected")
    path = f"{pathlib.Path(pal).resolve().parent}:{os.environ['PATH']}"
    shutil.rmtree(folder, ignore_errors=True)
    for what, files, green in scenarios(source):
        place = folder / what.replace(" ", "-")
        place.mkdir(parents=True)
        # The branch that a change goes into has none of the files yet.
        for words in (["init", "-q"], ["-c", "user.name=t", "-c", "user.email=t@t", "commit", "-q", "--allow-empty", "-m", "base"],
                      ["update-ref", "refs/remotes/origin/main", "HEAD"]):
            subprocess.run(["git", *words], cwd=place, check=True)
        for name, text in files.items():
            if text is None:
                (place / name).mkdir()
            else:
                (place / name).write_bytes(text if isinstance(text, bytes) else text.encode())
        for title, command in lines:
            if what == "undecided requirement":  # not in five minutes, but at once
                command = re.sub(r"--timeout 5min|(?=--quiet)|(?=--format (?!.*--timeout))", " --timeout 1ms ", command, count=1)
            run(command, place, path, f"{what} ({title})", green)
            if is_red(command, place) == green and "> " in command:
                FAULTS.append(f"{what} ({title}): the report is {'red' if green else 'green'}")
    # A pal that breaks down, before it has written anything and in the middle.
    crash = folder / "crash"
    for name, body in [("at-once", "kill -SEGV $$"), ("halfway", "printf '<?xml version=\"1.0\"?><testsuites>'; kill -ABRT $$")]:
        place = crash / name
        place.mkdir(parents=True)
        (place / "pal").write_text(f"#!/bin/sh\n{body}\n")
        (place / "pal").chmod(0o755)
        for title, command in lines:
            run(command, place, f"{place}:{os.environ['PATH']}", f"crash {name} ({title})", False)
    print("\n".join(FAULTS))
    return 1 if FAULTS else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
