"""A client moves the arm by hand, in the program `workcell serve` at the pace of the wall: while it sends orders the arm moves; a release
stops it; and when the client is gone in the middle, the arm is at rest within the proved time, as a second client sees by its joints.

Usage: jog.py WORKCELL SCHEMA
"""
import json
import sys
import time

import jsonschema
from cell_client import Refused, Server

workcell, schema_path = sys.argv[1:]
schema = json.load(open(schema_path))
parts = {each["name"]: jsonschema.Draft202012Validator({**each["result"]["schema"], "components": schema["components"]})
         for each in schema["methods"]}

PROVED = 0.210  # s: nothing that is decided later than this after the last order moves the arm on (the requirement `silence`)
MADE = 0.056    # s: a motion begins and ends within two cycles of the controller
SETTLES = 0.060
STILL = 0.2     # deg/s of a joint that is held
ON_THE_WAY = 0.1  # s: from this client to the server, on a busy machine
UP, DOWN = [0, 0, -1, 0, 0, 0], [0, 0, 1, 0, 0, 0]  # the tool points down


def jog(client, seconds, axes):
    """Holds for so long; the request that will be answered when the arm is at rest, and the cell's time at the last order."""
    request = client.send("jog.start", frame="tool", speed=50)
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        client.send("jog.keep", axes=axes)
        time.sleep(0.05)
    client.call("jog.keep", axes=axes)
    return request, client.call("state")["time_s"]


def joints(client, until):
    """The greatest change of a joint in each span of 20 ms that came, deg/s, with the cell's time; until the wall says so."""
    speeds = []
    while time.monotonic() < until:
        told = client.notice("samples", lambda each: each["params"]["channel"] == "joints")["params"]
        for span in told["spans"]:
            change = max(high - low for high, low in zip(span["high"], span["low"]))
            speeds.append((span["end_s"], change / max(span["end_s"] - span["begin_s"], 1e-9)))
    return speeds


server = Server(workcell, "--scene", "nothing")
try:
    person, witness = server.client(name="person"), server.client(name="witness")
    # A viewer and an operator are refused.
    for role in ("viewer", "operator"):
        try:
            server.client(role=role).call("jog.start", frame="tool")
            raise AssertionError(f"{role} moved the arm")
        except Refused as problem:
            assert problem.data["why"] == "role", problem.data
    # A release ends it, normally.
    request, _ = jog(person, 1, UP)
    person.send("jog.stop")
    done = person.wait(request)
    parts["jog.start"].validate(done)
    assert (done["kind"], done["code"]) == ("normal", 0), done
    assert done["end_s"] - done["begin_s"] < 3, done
    person.call("controls.release")

    # It falls silent while it holds; then another one is gone.
    witness.call("channels.watch", channels=[{"channel": "joints", "period_s": 0.02}])
    for leave, code, axes in ((lambda client: None, 1, UP), (lambda client: client.close(), 3, DOWN)):
        witness.events.clear()
        client = server.client(name="leaves")
        request, last = jog(client, 1.5, axes)
        leave(client)
        speeds = joints(witness, time.monotonic() + 2)
        moving = [at for at, speed in speeds if speed > STILL and at > last - 1]
        assert moving and max(speed for _, speed in speeds) > 1, "the arm never moved"
        after = moving[-1] - last
        assert after < PROVED + MADE + SETTLES + ON_THE_WAY, f"{after:.3f} s after the last order the arm moves"
        assert speeds[-1][0] - moving[-1] > 0.5, f"the arm moves again: {speeds[-5:]}"
        run = witness.call("history.list")["runs"][0]
        assert (run["name"], run["code"]) == ("jog", code), run
        print(f"at rest {after:.3f} s after the last order: {run['reason']}")
        if code == 1:
            client.call("controls.release")
finally:
    out = server.end()
assert "ended with" not in out, out
