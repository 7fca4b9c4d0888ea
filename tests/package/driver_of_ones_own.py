"""A driver as docs/workcell/links.md writes it, from the installed packages: driver_of_ones_own.py SOURCE PREFIX WORK GENERATOR COMPILER [FLAGS].

The skill is that of docs/how-to/device.md. This program is the scale, at the far end of a pseudo-terminal. It says hello when it is switched on,
before the first skill, and sends its answer in two pieces.
"""
import os
import re
import shutil
import subprocess
import sys
import threading
import time
import tty
from pathlib import Path

source, prefix, work, generator, compiler = sys.argv[1:6]
flags = sys.argv[6] if len(sys.argv) > 6 else ""
source, work = Path(source), Path(work)
shutil.rmtree(work, ignore_errors=True)
work.mkdir(parents=True)

for page in ["docs/how-to/device.md", "docs/workcell/links.md"]:
    text = (source / page).read_text()
    for name, content in re.findall(r"^```(?:pal|cpp|cmake) file=(\S+)\n(.*?)^```$", text, re.M | re.S):
        (work / name).write_text(content)
    for name, content in re.findall(r"^```diff file=(\S+)\n(.*?)^```$", text, re.M | re.S):
        lines = content.splitlines()
        before = "\n".join(line[1:] for line in lines if line[:1] != "+")
        after = "\n".join(line[1:] for line in lines if line[:1] != "-")
        old = (work / name).read_text()
        assert before in old, f"{page}: the change of {name} does not fit"
        (work / name).write_text(old.replace(before, after, 1))


def run(*command):
    done = subprocess.run([str(each) for each in command], cwd=work, capture_output=True, text=True, timeout=300)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, command))}: status {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout


run("cmake", "-S", ".", "-B", "build", "-G", generator, f"-DCMAKE_CXX_COMPILER={compiler}", f"-DCMAKE_CXX_FLAGS={flags}", f"-DCMAKE_PREFIX_PATH={prefix}")
run("cmake", "--build", "build")

far, near = os.openpty()
tty.setraw(near)
os.write(far, b"SCALE 7 READY\r\n")


def serve():
    asked = b""
    while not asked.endswith(b"W\r"):
        asked += os.read(far, 1)
    time.sleep(0.09)  # as bench.pal promises, at least 80 ms
    os.write(far, b"312")
    os.write(far, b".5\n")


threading.Thread(target=serve, daemon=True).start()
said = run(work / "build/weigh", os.ttyname(near))
if said != "312.5 g\nThe part is weighed.\n":
    sys.exit(f"the program said:\n{said}")
