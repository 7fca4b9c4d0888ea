"""`pal operation check --scene` knows the skills, sensors, figures and locations of a scene of the workcell.

It also knows a skill that was built as a file: FILE, the built `touch`.

Usage: check_scene.py PAL OPERATION FILE
"""
import json
import pathlib
import subprocess
import sys
import tempfile

pal, operation, built = sys.argv[1:]


def check(text, scene, *further):
    with tempfile.TemporaryDirectory() as folder:
        path = pathlib.Path(folder) / "o.op.json"
        path.write_text(text)
        done = subprocess.run([pal, "operation", "check", path, "--scene", scene, "--format", "json", *further], capture_output=True, text=True)
        found = json.loads(done.stdout)["diagnostics"] if done.stdout else []
        return done.returncode, [(each["code"], each.get("icon")) for each in found if each["severity"] == "error"], done.stderr


def one(icon):
    return json.dumps({"operation-format": 1, "name": "one", "icons": [
        {"id": "start", "kind": "start", "next": "a"}, {"id": "a", "next": "end", "error": "end", **icon}, {"id": "end", "kind": "exit"}]})


home = one({"kind": "skill", "skill": "move-to-location", "parameters": {"location": "HOME"}})
assert check(home, "touch")[:2] == (0, []), check(home, "touch")
# The longest time is what the cell declares for these parameters.
with tempfile.TemporaryDirectory() as folder:
    path = pathlib.Path(folder) / "o.op.json"
    path.write_text(one({"kind": "skill", "skill": "relative-move", "parameters": {"dz": -60, "speed": 20}}))
    done = subprocess.run([pal, "operation", "check", path, "--scene", "touch", "--format", "json"], capture_output=True, text=True)
    ways = json.loads(done.stdout)["operations"][0]["ways"]
    assert [(way["longest_ns"], way["declared"]) for way in ways] == [(7 * 10**9, True), (4 * 10**9, True), (120 * 10**9, True)], ways
# A whole operation of that cell, without proofs of its own: those of its skills take their time.
text = pathlib.Path(operation).read_text()
untaught = text.replace('"PLACE"', '"SHELF"', 1)  # the argument's default names it, too
assert check(untaught, "parts")[1] == [("PAL1010", "put-heavy")], check(untaught, "parts")
assert [code for code, _ in check(text, "touch")[1]].count("PAL1010") >= 1, check(text, "touch")
assert check(one({"kind": "test", "sensor": "colour", "limits": [1]}), "parts")[1] == [("PAL1017", "a")]
assert check(one({"kind": "skill", "skill": "juggle"}), "parts")[1] == [("PAL1007", "a")]
grip = one({"kind": "skill", "skill": "pick-at-location", "parameters": {"location": "HOME"}})
assert check(grip, "touch")[0] == 1, check(grip, "touch")
status, _, error = check(home, "nowhere")
assert status == 2 and "nowhere" in error, (status, error)

# A built skill takes the place of the scene's own of its name, and is proved once, with the texts in its file.
both = json.dumps({"operation-format": 1, "name": "both", "icons": [
    {"id": "start", "kind": "start", "next": "up"},
    {"id": "up", "kind": "skill", "skill": "relative-move", "parameters": {"dz": -5}, "next": "down", "error": "end"},
    {"id": "down", "kind": "skill", "skill": "touch", "next": "end", "error": "end"}, {"id": "end", "kind": "exit"}]})
with tempfile.TemporaryDirectory() as folder:
    path = pathlib.Path(folder) / "o.op.json"
    path.write_text(both)
    done = subprocess.run([pal, "operation", "check", path, "--scene", "touch", "--skills", built], capture_output=True, text=True)
    assert done.returncode == 0 and done.stdout.count("touch in workcell") == 1 and done.stdout.count("relative-move in workcell") == 1, done
    assert done.stderr == "", done.stderr
wrong = both.replace('"skill": "touch"', '"skill": "touch", "parameters": {"colour": 1}')
assert check(wrong, "touch", "--skills", built)[1] == [("PAL1008", "down")], check(wrong, "touch", "--skills", built)
status, _, error = check(home, "touch", "--skills", operation + ".so")
assert status == 2 and "there is no such file" in error, (status, error)
with tempfile.TemporaryDirectory() as folder:
    path = pathlib.Path(folder) / "o.op.json"
    path.write_text(both)
    done = subprocess.run([pal, "operation", "check", path, "--skills", built], capture_output=True, text=True)
    assert done.returncode == 2 and "--scene SCENE" in done.stderr, done
