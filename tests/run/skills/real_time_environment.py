"""The times of runs in real time: real_time_environment.py PAL SOURCE.

workcell_real_time.pal has the devices and costs of workcell.pal with the tolerances of `workcell run --real-time`, and nothing else
differs. The skills hold their requirements there; two, whose loads take several seconds, are left out.
"""
import re
import subprocess
import sys
from pathlib import Path

pal, source = sys.argv[1], Path(sys.argv[2])
command = (source / "programs/workcell/commands/run_command.cpp").read_text()
tolerance = float(re.search(r"\.device = std::chrono::milliseconds\((\d+)\)", command).group(1))
cost_tolerance = float(re.search(r"\.cost = std::chrono::microseconds\((\d+)\)", command).group(1)) / 1e3
UNITS = {"ms": 1.0, "s": 1e3, "min": 6e4}


def widened(line):
    """The line of a device or a cost as it is watched in real time: its times in ms."""
    words = line.split()
    if words[0] == "COST":
        return words[:3] + ["TO", f"{float(words[2]) + cost_tolerance:g}", "ms"]
    if "FRAMES" in words:
        return words  # PAL has no word for frames that are late
    if "EVENT" in words:
        at = words.index("EVERY") + 3
        return words[:at] + ["JITTER", f"{tolerance:g}", "ms"] + words[at:]
    best, worst = times(words)
    return words[:4] + [round(best - tolerance, 6), round(worst + tolerance, 6)]


def times(words):
    units = [UNITS[word] for word in words if word in UNITS]
    numbers = [float(word) for word in words if re.fullmatch(r"[\d.]+", word)]
    return [number * units[0 if len(units) > 1 and i == 0 else -1] for i, number in enumerate(numbers)]


def as_told(line):
    words = line.split()
    return words if "ON" not in words else words[:4] + [round(each, 6) for each in times(words)]


def items(name):
    lines = (source / "skills_pal" / name).read_text().splitlines()
    return [line for line in lines if not line.startswith("#")]


for declared, late in zip(items("workcell.pal"), items("workcell_real_time.pal"), strict=True):
    late_there = declared.split()[:1] in (["DEVICE"], ["COST"])
    expected, found = (widened(declared), as_told(late)) if late_there else (declared, late)
    if expected != found:
        sys.exit(f"workcell.pal:          {declared}\nworkcell_real_time.pal: {late}\nexpected: {expected}")

ELSEWHERE = {"jog", "touch_read_first"}  # of another workcell; made to fail
SLOW = {"press", "rub"}  # their loads take several seconds each
for skill in sorted(source.glob("skills_pal/*/*.pal")):
    text = skill.read_text()
    if skill.stem in ELSEWHERE | SLOW or not re.search(r"^SKILL ", text, re.M):
        continue
    requirements = len(re.findall(r"^ *REQUIREMENT ", text, re.M))
    done = subprocess.run([pal, "check", skill, "-e", source / "skills_pal/workcell_real_time.pal"], capture_output=True, text=True)
    if done.returncode != 0 or done.stdout.count("  holds ") < requirements:
        sys.exit(f"{skill}: status {done.returncode}\n{done.stdout}{done.stderr}")
