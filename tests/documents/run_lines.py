"""Runs the lines of a page's ```sh run fences, as a reader types them from the project's folder.

    run_lines.py PAGE ROOT FOLDER

FOLDER is emptied first; it stands for the project's folder ROOT, whose visible folders (but for build and out) are
linked there. The programs are found on PATH. Ends with 1, and names the line, at the first command that does not end
with 0.
"""
import re
import shutil
import subprocess
import sys
from pathlib import Path

page, root, folder = (Path(argument) for argument in sys.argv[1:4])
shutil.rmtree(folder, ignore_errors=True)
folder.mkdir(parents=True)
for entry in root.iterdir():
    if entry.is_dir() and entry.name not in ("build", "out") and not entry.name.startswith("."):
        (folder / entry.name).symlink_to(entry)

fences = re.findall(r"^```sh run\n((?:(?!```).*\n)*)```$", page.read_text(encoding="utf-8"), re.MULTILINE)
lines = sum(len([line for line in fence.splitlines() if line.strip()]) for fence in fences)
for fence in fences:
    script = "set -eu\ntrap 'echo \"fails: $BASH_COMMAND\"' ERR\n" + fence
    done = subprocess.run(["bash", "-c", script], cwd=folder, text=True, timeout=300,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if done.returncode != 0:
        sys.exit(done.stdout)
print(f"{lines} lines run")
sys.exit(0 if lines else 1)
