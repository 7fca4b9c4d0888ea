"""The nightly study of docs/how-to/ci.md does what the page says: run_nightly.py PAL SOURCE_DIR FOLDER.

Takes both services' commands from the page, and runs each as the service does (sh -e) in a folder with a small study. A night that is long
enough leaves the table and the pictures. A night that is too short ends with 3, and the next one takes what it proved. With --all-hold the
job is red where something fails. Kept folders and uploaded ones must be those of the command.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys

PAGE = "docs/how-to/ci.md"
STUDY = """title = "How slow may sending be?"
files = ["dip.pal"]
environments = ["bench.pal"]

[[figure]]
name = "SEND"
from = "1 us"
to = "{longest} us"
step = "1 us"
"""
FAULTS = []


def expect(fact, text):
    if not fact:
        FAULTS.append(text)


def begin(folder, source, longest):
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    for name in ("dip.pal", "bench.pal"):
        shutil.copy(source / "tests/documents/ci" / name, folder)
    (folder / "study.toml").write_text(STUDY.format(longest=longest))


def run(command, folder, pal):
    path = f"{pathlib.Path(pal).resolve().parent}:{os.environ['PATH']}"
    return subprocess.run(["sh", "-e", "-c", command], cwd=folder, env={**os.environ, "PATH": path}, capture_output=True, text=True,
                          check=False)


def made_before(done):
    match = re.search(r"(\d+) proofs, (\d+) of them made before", done.stderr)
    return int(match[2]) if match else -1


def play(command, folder, source, pal):
    begin(folder, source, 40)
    done = run(command, folder, pal)
    expect(done.returncode == 0, f"`{command}` ended with {done.returncode}\n{done.stderr}")
    for name in ("table.csv", "table.json", "summary.md", "slack-over-SEND.svg"):
        expect((folder / "study" / name).is_file(), f"`{command}` wrote no study/{name}")
    done = run(command, folder, pal)
    expect(made_before(done) == 40, f"the next night makes proofs again that were made:\n{done.stderr}")

    begin(folder, source, 2000)  # the sensor is too slow then
    expect(" 5h " in command, f"`{command}` has no limit of five hours")
    for night in ("0.3s", "0.6s", "1.2s", "2.4s"):  # the first in which anything is proved, however slow the machine
        done = run(command.replace(" 5h ", f" {night} "), folder, pal)
        expect(done.returncode == 3, f"`{command}` in {night} ended with {done.returncode}, not 3\n{done.stderr}")
        if any((folder / ".pal-proofs").rglob("*")):
            break
    done = run(command, folder, pal)
    expect(done.returncode == 0 and 0 < made_before(done) < 2000, f"the next night does not go on:\n{done.stderr}")
    done = run(command + " --all-hold", folder, pal)
    expect(done.returncode == 3, f"with --all-hold a study with failures ended with {done.returncode}\n{done.stderr}")


def main(pal, source, folder):
    source, folder = pathlib.Path(source), pathlib.Path(folder)
    section = re.search(r"^## A study each night\n(.*?)(?=^## )", (source / PAGE).read_text(encoding="utf-8"), re.M | re.S)[1]
    commands = re.findall(r"^\s*- (?:run: )?(timeout .*)$", section, re.M)
    if len(commands) != 2:
        sys.exit(f"{PAGE}: {len(commands)} nightly commands, where one for each of two services was expected")
    kept, written = re.findall(r"path: (\.\S+)", section), re.findall(r"path: ([a-z]\S*)", section)
    for number, command in enumerate(commands):
        cache, results = re.search(r"--cache (\S+)", command)[1], re.search(r"-o (\S+)", command)[1]
        expect(kept == [cache, cache] and written == [results], f"GitHub's steps keep {kept} and {written}, not {cache} and {results}")
        expect(f"paths: [{cache}]" in section and f"paths: [{results}]" in section, f"GitLab's job does not keep {cache} and {results}")
        play(command, folder / str(number), source, pal)
    # Both services must keep proofs of a red job, or the next night begins again.
    expect(re.search(r"uses: actions/cache/save@v\d+\n\s*if: always\(\)", section), "GitHub's step saves proofs of green jobs only")
    expect(re.search(r"paths: \[\.pal-proofs\]\n\s*when: always", section), "GitLab's job saves proofs of green jobs only")
    print("\n".join(FAULTS))
    return 1 if FAULTS else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
