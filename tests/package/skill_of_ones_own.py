"""A skill for the workcell from the installed parts alone: skill_of_ones_own.py BUILD WORK GENERATOR COMPILER [FLAGS].

It is begun as a copy of touch and from a PAL file, built, proved, listed, run, and run in an operation. A file that is no
skill is refused, and a PAL file that has changed since is told.
"""
import re
import shutil
import subprocess
import sys
from pathlib import Path

build, work, generator, compiler = sys.argv[1:5]
build = Path(build).resolve()
flags = sys.argv[5] if len(sys.argv) > 5 else ""
work = Path(work)
shutil.rmtree(work, ignore_errors=True)
prefix = work / "installed"
workcell = prefix / "bin/workcell"


def run(*command, status=0, folder=work):
    folder.mkdir(parents=True, exist_ok=True)
    done = subprocess.run([str(each) for each in command], cwd=folder, capture_output=True, text=True)
    text = done.stdout + done.stderr
    if done.returncode != status:
        sys.exit(f"{' '.join(map(str, command))}: status {done.returncode}, not {status}\n{text}")
    return text


def expect(words, text):
    if words not in text:
        sys.exit(f"'{words}' is not in:\n{text}")


def build_skill(name):
    run("cmake", "-S", name, "-B", f"{name}/build", "-G", generator, f"-DCMAKE_CXX_COMPILER={compiler}", f"-DCMAKE_CXX_FLAGS={flags}",
        f"-DCMAKE_PREFIX_PATH={prefix}")
    run("cmake", "--build", f"{name}/build")


for part in ["tools", "development", "workcell"]:
    run("cmake", "--install", build, "--prefix", prefix, "--component", part, folder=build)

# A copy of touch: it builds, holds its requirements, and does what touch does.
expect("tap/tap.pal", run(workcell, "new-skill", "tap", "--like", "touch"))
expect("not empty", run(workcell, "new-skill", "tap", "--like", "touch", status=2))
build_skill("tap")
plain = ["--no-picture", "--no-plots"]
first = run(workcell, "run", "tap/build/tap.so", *plain)
expect("The tool touches the surface.", first)
if "has changed" in first:
    sys.exit(f"nothing has changed:\n{first}")

# The copy has what touch declares, and is told with it.
listed = run(workcell, "list", "--skills", "tap/build/tap.so")
own = listed[listed.index("  tap\n"):].split("\n  touch\n")[0]
expect("longest time in s: 2 * reach / approach-speed + 2", own)

# In the operation of robot-skill.md, beside the skills that are installed.
page = (Path(__file__).resolve().parents[2] / "docs/how-to/robot-skill.md").read_text()
(work / "twice.op.json").write_text(re.search(r"^```json file=twice.op.json\n(.*?)^```$", page, re.M | re.S)[1])
ran = run(workcell, "operation", "run", "--skills", "tap/build/tap.so", "twice.op.json")
expect("again: tap ended with code 0", ran)
expect("ended after 2 steps: exit 'end' with code 0", ran)
expect("tap", run(workcell, "operation", "run", "twice.op.json", status=1))
expect("PAL1007", run(prefix / "bin/pal", "operation", "check", "twice.op.json", "--scene", "touch", status=1))
told = run(prefix / "bin/pal", "operation", "check", "twice.op.json", "--scene", "touch", "--skills", "tap/build/tap.so")
expect("tap in workcell\n  holds", told)

# The page of the workstation is installed, too, and offers the skill.
if (build / "share/pal/workstation/index.html").exists():
    sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "protocol"))
    from cell_client import Server

    server = Server(workcell, "--skills", work / "tap/build/tap.so")
    status, fields, html = server.get("/")
    if status != 200 or "script-src 'self'" not in fields["Content-Security-Policy"]:
        sys.exit(f"the page: {status} {fields}")
    for name in re.findall(r'(?:src|href)="([^"]+)"', html.decode()):
        if server.get(f"/{name}")[0] != 200:
            sys.exit(f"the page's {name} is missing")
    if "tap" not in [each["skill"] for each in server.client().call("skills")]:
        sys.exit("the page's cell has no skill tap")
    force = next(each for each in server.client().call("channels.list") if each["channel"] == "force")
    if ["threshold"] != [each["parameter"] for each in force["limits"] if each["skill"] == "tap"]:
        sys.exit(f"charts have not the limit of tap: {force['limits']}")
    server.end()

# Its PAL has changed, and it was not built again.
pal = work / "tap/tap.pal"
pal.write_text(pal.read_text().replace("Moves the tool", "Drives the tool"))
expect("tap.pal has changed since it was built", run(workcell, "run", "tap/build/tap.so", *plain))

# A requirement that does not hold stops the build.
pal.write_text(pal.read_text().replace("AT MOST 10 ms", "AT MOST 1 ms"))
expect("'fresh-force' fails", run("cmake", "--build", "tap/build", status=1))
pal.write_text(pal.read_text().replace("AT MOST 1 ms", "AT MOST 10 ms"))

# So does a line that declares what the skill has not.
declared = work / "tap/tap.declared"
right = declared.read_text()
declared.write_text(right.replace("longest 2:", "longest 3:"))
expect("tap.declared:8: tap has no completion 3", run("cmake", "--build", "tap/build", status=1))
declared.write_text(right)

# From a PAL file, with activities that do nothing.
(work / "drawn").mkdir()
for each in (work / "tap").rglob("*.pal"):
    to = work / "drawn" / each.relative_to(work / "tap")
    to.parent.mkdir(exist_ok=True)
    to.write_text(each.read_text().replace("SKILL tap\n", "SKILL nod\n"))
(work / "drawn/workcell.pal").unlink()
run(workcell, "new-skill", "nod", "--from", "drawn/tap.pal")
(work / "bare.pal").write_text("CONDITION there \"of no skill\"\n")
expect("choose a file with one SKILL", run(workcell, "new-skill", "bare", "--from", "bare.pal", status=1))
expect("cannot read 'nothing.pal'", run(workcell, "new-skill", "nothing", "--from", "nothing.pal", status=1))
build_skill("nod")
expect("  nod\n", run(workcell, "list", "--skills", "nod/build/nod.so"))

# Each of the workcell's skills can be begun from, and its C++ has the new name in all places.
for like in (each.stem for each in sorted(next(prefix.glob("lib*/**/pal/skills")).glob("*.so"))):
    skill = like.replace("_", "-")
    run(workcell, "new-skill", f"my-{skill}", "--like", skill)
    for file in (work / f"my_{like}").glob("*.?pp"):
        left = re.findall(rf"(?:\b{like}::|namespace {like}\b|\"{like}_).*", file.read_text())
        if left:
            sys.exit(f"{file}: {left[0]}")
build_skill("my_rub")

# Files that are no skills.
(work / "text.so").write_text("no library\n")
expect("pal_add_skill", run(workcell, "run", "text.so", status=2))
expect("there is no such file", run(workcell, "run", "none.so", status=2))
(work / "old.cpp").write_text('extern "C" const void* pal_skill() { static const char* const old[] = {"pal 0.0.1 (of old)"}; return old; }\n')
run(compiler, "-shared", "-fPIC", "old.cpp", "-o", "old.so")
expect("it was built for pal 0.0.1 (of old), and this is pal", run(workcell, "run", "old.so", status=2))

# A broken file among the installed skills is named, and is in no client's way.
broken = next(prefix.glob("lib*/**/pal/skills")) / "broken.so"
broken.write_text("no library\n")
expect("broken.so", run(workcell, "list", status=2))
if "broken.so" in run(workcell, "operation", "stop", "--at", "nowhere.json", status=2):
    sys.exit("a stop looks at the installed skills")
broken.unlink()
expect("no name for a skill", run(workcell, "new-skill", "Tap!", "--like", "touch", status=2))
