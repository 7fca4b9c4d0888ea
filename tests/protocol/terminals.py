"""Two cells on one machine, seen from terminals: each has a place of its own for its token, `workcell operation`
finds the one that there is and asks which if there are two, and no name of another client commands a terminal.

Usage: terminals.py WORKCELL
"""
import json
import os
import subprocess
import sys
import tempfile
import time

from cell_client import Client

workcell = sys.argv[1]
folder = tempfile.TemporaryDirectory()
os.environ["XDG_RUNTIME_DIR"] = folder.name


def serve(scene):
    known = set(os.listdir(folder.name))
    process = subprocess.Popen([workcell, "serve", "--scene", scene, "--fast", "--port", "0"], stdout=subprocess.PIPE, text=True)
    end = time.monotonic() + 60
    while not (fresh := {each for each in os.listdir(folder.name) if each.endswith(".json")} - known):
        assert time.monotonic() < end and process.poll() is None, "the server does not start"
        time.sleep(0.02)
    return process, os.path.join(folder.name, fresh.pop())


def operation(*words):
    done = subprocess.run([workcell, "operation", *words], capture_output=True, text=True, timeout=60)
    return done.returncode, done.stdout, done.stderr


one = two = None
try:
    status, _, error = operation("state")
    assert status == 2 and "no server is there" in error, (status, error)
    one, first = serve("touch")
    status, out, error = operation("state")
    assert status == 0 and out.startswith("cell touch:"), (status, out, error)
    two, second = serve("parts")
    assert first != second and "touch" in first and "parts" in second, (first, second)
    status, _, error = operation("state")
    assert status == 2 and first in error and second in error, error
    status, out, _ = operation("state", "--at", second)
    assert status == 0 and out.startswith("cell parts:"), out

    # A name that would clear the screen.
    evil = "\x1b[2J\x07\nname"
    announced = json.load(open(first))
    client = Client(announced["port"])
    client.call("hello", token=announced["token"], name=evil)
    text = json.dumps({"operation-format": 1, "name": "quick", "icons": [
        {"id": "start", "kind": "start", "next": "up"},
        {"id": "up", "kind": "skill", "skill": "relative-move", "parameters": {"dz": -5}, "next": "end", "error": "end"},
        {"id": "end", "kind": "exit"}]})
    # Where a text of a file gets through, as it is.
    for name in ("quick", evil):
        changed = json.dumps({**json.loads(text), "name": name})
        try:
            client.call("operation.load", main="q", files={"q": changed})
        except Exception as problem:  # names with control characters may be refused
            assert name == evil, problem
    watcher = subprocess.Popen([workcell, "operation", "watch", "--at", first], stdout=subprocess.PIPE, text=True)
    client.call("operation.run")
    told = watcher.stdout.readline()
    while "up" not in told:
        told += watcher.stdout.readline()
    watcher.terminate()
    watcher.communicate(timeout=20)
    status, out, _ = operation("state", "--at", first)
    for each in (told, out):
        assert all(letter == "\n" or letter.isprintable() for letter in each), repr(each)
    assert "name" in out, out  # who has the controls
    client.close()
finally:
    for each in (one, two):
        if each is not None:
            each.terminate()
            each.communicate(timeout=30)
    folder.cleanup()
