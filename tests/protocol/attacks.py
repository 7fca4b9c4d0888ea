"""Each way that once kept a stop out, or left somebody in the dark, against the program: sockets that say nothing, texts
that take long to check, clients that are killed while the arm moves, servers that are started again.

Usage: attacks.py WORKCELL
"""
import json
import os
import pathlib
import signal
import socket
import subprocess
import sys
import tempfile
import time

from cell_client import Client, Refused, Server

workcell = sys.argv[1]
far = {"skill": "relative-move", "parameters": {"dz": -100, "speed": 5}}  # 20 s of motion


def operation(server, *words, status=0):
    done = subprocess.run([workcell, "operation", *words, "--at", server.announcement], capture_output=True, text=True, timeout=60)
    assert done.returncode == status, (words, done)
    return done.stdout + done.stderr


def refused(why, call, *names, **params):
    try:
        call(*names, **params)
    except Refused as problem:
        assert problem.data["why"] == why, (why, problem.data)
        return problem.data
    raise AssertionError(f"not refused: {names} {params}")


def rests(client, within):
    """The skill that runs ends within so many seconds."""
    end = time.monotonic() + within
    while client.call("state")["running"] is not None:
        assert time.monotonic() < end, f"it moves after {within} s"
        time.sleep(0.02)


def moves(client):
    """Until the skill runs that was asked for."""
    end = time.monotonic() + 30
    while client.call("state")["running"] is None:
        assert time.monotonic() < end, "nothing moves"
        time.sleep(0.02)


def drawn(name, icons):
    return json.dumps({"operation-format": 1, "name": name, "icons": icons})


def chain(length):
    """Sub-operations, each in the one before."""
    end = {"id": "end", "kind": "exit"}
    operations = [{"name": f"o{i}", "icons": [{"id": "start", "kind": "start", "next": "in"},
                                              {"id": "in", "kind": "operation", "operation": f"o{i + 1}", "next": "end", "error": "end"}, end]}
                  for i in range(1, length)]
    operations.append({"name": f"o{length}", "icons": [{"id": "start", "kind": "start", "next": "end"}, end]})
    whole = json.loads(drawn("chain", [{"id": "start", "kind": "start", "next": "in"},
                                       {"id": "in", "kind": "operation", "operation": "o1", "next": "end", "error": "end"}, end]))
    return json.dumps({**whole, "operations": operations})


def merges(count):
    return drawn("merges", [{"id": "start", "kind": "start", "next": "m0"},
                            *({"id": f"m{i}", "kind": "merge", "next": f"m{i + 1}" if i + 1 < count else "end"} for i in range(count)),
                            {"id": "end", "kind": "exit"}])


def strangers_keep_nobody_out():
    server = Server(workcell, "--scene", "touch")
    try:
        watcher, mover = server.client(role="viewer"), server.client()
        silent = [socket.create_connection(("127.0.0.1", server.port)) for _ in range(64)]
        for _ in range(3):
            mover.send("skill.run", **far)
            moves(watcher)
            operation(server, "stop")
            rests(watcher, 1)
        # All places taken by clients with a token: the next may look and stop, and is told so in words.
        crowd = [server.client(role="viewer", name=f"{i}") for i in range(20)]
        last = server.client()
        assert "places for clients are taken" in refused("role", last.call, "controls.take")["hint"]
        mover.send("skill.run", **far)
        moves(watcher)
        last.call("stop")
        rests(watcher, 1)
        for each in [*silent, *crowd]:
            each.close()
    finally:
        server.end()


def texts_keep_no_stop_waiting():
    server = Server(workcell, "--scene", "touch")
    try:
        hurts, stops = server.client(), server.client(role="viewer")
        hurts.socket.settimeout(60)
        for text in (chain(4000), merges(1000)):
            hurts.send("operation.check", main="f", files={"f": text})
            begin, longest = time.monotonic(), 0
            load = hurts.send("operation.load", main="f", files={"f": text})
            for _ in range(20):
                asked = time.monotonic()
                stops.call("stop")
                longest = max(longest, time.monotonic() - asked)
            try:
                hurts.wait(load)
            except Refused:
                pass  # too deep, or a loop in which nothing happens
            # Far more than it takes, so that a machine that does much else does not matter; both took minutes, and every stop with them.
            assert longest < 1 and time.monotonic() - begin < 30, (longest, time.monotonic() - begin)
        # A check that is not wanted any more ends.
        request = hurts.send("operation.check", main="f", files={"f": chain(4000)})
        hurts.call("cancel", request=request)
    finally:
        server.end()


killed = """
import sys; sys.path.insert(0, sys.argv[1])
from cell_client import Client
client = Client(int(sys.argv[2]))
client.call("hello", token=sys.argv[3], name="mortal")
client.send("skill.run", **eval(sys.argv[4]))
client.step()
"""


def who_goes_leaves_no_motion():
    server = Server(workcell, "--scene", "touch")
    try:
        watcher = server.client()
        for goes_on in (False, True):
            wanted = {**far, **({"goes_on": True} if goes_on else {})}
            process = subprocess.Popen([sys.executable, "-c", killed, str(pathlib.Path(__file__).parent), str(server.port),
                                        server.announced["tokens"]["programmer"], repr(wanted)])
            moves(watcher)
            process.kill()
            process.wait()
            if goes_on:
                time.sleep(1.2)
                assert watcher.call("state")["running"]["alone"], "it was to go on"
                watcher.call("stop")
            rests(watcher, 1)
        # A hold outlives what is stopped: nothing moves, whoever asks, until it is released.
        other = server.client(name="other")
        watcher.call("hold.set", reason="a hand is in the cell")
        refused("held", other.call, "skill.run", **far)
        refused("held", watcher.call, "skill.run", **far)
        refused("held", other.call, "hold.release")
        watcher.call("hold.release")
        other.call("skill.run", skill="relative-move", parameters={"dz": -1})
    finally:
        server.end()


def a_server_that_was_started_again():
    first = Server(workcell, "--scene", "touch", "--fast")
    second = None
    try:
        # While it answers, nobody takes its place.
        taken = subprocess.run([workcell, "serve", "--port", "0", "--announce", first.announcement], capture_output=True, text=True, timeout=60)
        assert taken.returncode == 2 and str(first.announcement) in taken.stderr, taken
        assert operation(first, "state").startswith("cell touch:")
        watcher = first.client()
        for _ in range(5):
            watcher.call("skill.run", skill="relative-move", parameters={"dz": -1})
        known = {key: watcher.call("snapshot")[key] for key in ("epoch", "last_event")}
        # Its end is told, and takes its own file only.
        watcher.call("watch")
        first.process.send_signal(signal.SIGTERM)
        try:
            while True:
                watcher.step()
        except ConnectionError as problem:
            assert "the server ends" in str(problem), problem
        assert any(each["params"].get("event") == "ending" for each in watcher.events), watcher.events
        first.process.wait(30)
        assert not first.announcement.exists()
        second = Server(workcell, "--scene", "touch", "--fast")
        again = second.client()
        told = again.call("watch", since=known["last_event"], epoch=known["epoch"])
        assert not told["complete"] and told["epoch"] != known["epoch"] and told["snapshot"]["epoch"] == told["epoch"], told
        again.events.clear()
        again.call("controls.take")
        assert again.until(event="controls"), "it is not deaf"
        stranger = Client(second.port)
        refused("not-admitted", stranger.call, "hello", token="wrong")
        try:
            stranger.call("state")
            raise AssertionError("a stranger is heard")
        except ConnectionError as problem:
            assert "token" in str(problem), problem
    finally:
        for each in (first, second):
            if each is not None:
                each.end()


def a_text_that_was_not_sent():
    server = Server(workcell, "--scene", "touch", "--fast")
    try:
        client = server.client()
        icons = [{"id": "start", "kind": "start", "next": "in"},
                 {"id": "in", "kind": "operation", "file": "other.op.json", "next": "end", "error": "end"}, {"id": "end", "kind": "exit"}]
        told = client.call("operation.check", main="f", files={"f": drawn("outer", icons)})
        assert any("was not sent" in each["message"] for each in told["findings"]), told["findings"]
    finally:
        server.end()


def an_output_that_breaks_off():
    """Its reader goes while the server still tells its addresses, and serves a client already."""
    read, write = os.pipe()
    os.set_blocking(write, False)
    try:
        while True:
            os.write(write, b" ")
    except BlockingIOError:
        os.set_blocking(write, True)
    with tempfile.TemporaryDirectory() as folder:
        announcement = pathlib.Path(folder) / "cell.json"
        # A broken pipe is a refusal, as for a service of the system; memory that was given back holds nothing of use.
        process = subprocess.Popen([workcell, "serve", "--fast", "--port", "0", "--announce", announcement], stdout=write,
                                   stderr=subprocess.PIPE, text=True, restore_signals=False,
                                   env={**os.environ, "MALLOC_PERTURB_": "165"})
        try:
            os.close(write)
            end = time.monotonic() + 60
            while not announcement.exists():
                assert time.monotonic() < end and process.poll() is None, "the server does not start"
                time.sleep(0.02)
            announced = json.loads(announcement.read_text())
            client = Client(announced["port"])
            client.call("hello", token=announced["token"], name="early")
            os.close(read)
            try:
                while True:
                    client.step()
            except ConnectionError as problem:
                assert "the server ends" in str(problem), problem
            _, told = process.communicate(timeout=60)
            assert process.returncode == 2 and "standard output" in told, (process.returncode, told)
            assert not announcement.exists()
        finally:
            process.kill()
            process.wait()


for attack in (strangers_keep_nobody_out, texts_keep_no_stop_waiting, who_goes_leaves_no_motion, a_server_that_was_started_again,
               a_text_that_was_not_sent, an_output_that_breaks_off):
    begin = time.monotonic()
    attack()
    print(f"{attack.__name__.replace('_', ' ')}: {time.monotonic() - begin:.1f} s", flush=True)
