"""What the cell looks like, and the channels of it, as clients of the program get them: poses at 30 in a second and under
100 kB/s, however quick the cell is; and a run that is read again agrees with what came live.

Usage: scene.py WORKCELL SCHEMA
"""
import base64
import json
import struct
import sys
import time

import jsonschema
from cell_client import Server

workcell, schema_path = sys.argv[1:]
schema = json.load(open(schema_path))
parts = {each["name"]: jsonschema.Draft202012Validator({**each["result"]["schema"], "components": schema["components"]})
         for each in schema["methods"]}
notice = jsonschema.Draft202012Validator({**next(each for each in schema["x-notifications"] if each["name"] == "rows")["params"][0]["schema"],
                                          "components": schema["components"]})
most_a_second, most_bytes = 30, 100_000


def checked(client, method, **params):
    result = client.call(method, **params)
    parts[method].validate(result)
    return result


def frames(client, channel):
    return [each for each in client.events if each["method"] == "binary" and each["head"]["channel"] == channel]


def moved(options, skill, parameters):
    """Runs a skill while poses and contacts are watched. How long it took on the wall, and what came."""
    server = Server(workcell, *options)
    try:
        client = server.client()
        scene = checked(client, "scene.get")
        moving = [each["name"] for each in scene["bodies"] if each["moves"]]
        client.call("channels.watch", channels=[{"channel": "poses", "period_s": 0.001, "binary": True},
                                                {"channel": "contact-points", "period_s": 0.001, "binary": True}])
        first = client.notice("binary", lambda each: each["head"]["channel"] == "poses")
        assert first["head"]["rows"] == len(moving) and first["head"]["fields"] == 7, first["head"]
        begin = time.monotonic()
        done = client.call("skill.run", skill=skill, parameters=parameters)
        assert done["kind"] == "normal", done
        # The last poses come although the cell stands then. There is one for each millisecond.
        last = done["end_s"] - (0.001 if "--fast" in options else 0.05)
        while not frames(client, "poses") or frames(client, "poses")[-1]["head"]["time_s"] < last:
            client.step()
        took = time.monotonic() - begin
        came = frames(client, "poses")
        for each in came:
            for row in range(len(moving)):
                turn = each["numbers"][7 * row + 3:7 * row + 7]
                assert abs(sum(number * number for number in turn) - 1) < 1e-5, turn
        runs = checked(client, "replay.list")
        assert runs[0]["run"] == checked(client, "history.list")["runs"][0]["run"], runs
        return scene, took, came, client, server, runs[0]
    except BaseException:
        server.end()
        raise


# At the pace of the wall, in the scene that has most bodies which move.
scene, took, came, client, server, run = moved(["--scene", "parts"], "relative-move", {"dz": -60})
try:
    lasted = came[-1]["head"]["time_s"] - came[0]["head"]["time_s"]
    rate, bytes_a_second = (len(came) - 1) / lasted, sum(each["bytes"] for each in came) / lasted
    print(f"{sum(each['moves'] for each in scene['bodies'])} bodies: {rate:.1f} poses a second, {bytes_a_second / 1000:.1f} kB/s; the scene once {len(json.dumps(scene)) / 1000:.1f} kB")
    assert rate <= most_a_second and bytes_a_second < most_bytes, (rate, bytes_a_second)
    assert rate > 10, f"only {rate} in a second of the cell"
    # The text form, too.
    client.call("channels.watch", channels=[{"channel": "poses", "period_s": 0.05}])
    told = client.notice("rows")["params"]
    notice.validate(told)
    assert len(told["rows"]) == sum(each["moves"] for each in scene["bodies"]), told
    # The same, read again: page by page.
    page = checked(client, "replay.read", run=run["run"], channel="poses", limit=5)
    assert page["more"] and len(page["times_s"]) == 5, page["times_s"]
    numbers = struct.unpack(f"<{len(base64.b64decode(page['numbers'])) // 4}f", base64.b64decode(page["numbers"]))
    live = {round(each["head"]["time_s"], 6): each["numbers"] for each in came}
    width = 7 * page["rows"][0]
    both = [i for i, at in enumerate(page["times_s"]) if round(at, 6) in live]
    assert all(numbers[width * i:width * (i + 1)] == tuple(live[round(page["times_s"][i], 6)]) for i in both), "what is kept is what came"
    rest = checked(client, "replay.read", run=run["run"], channel="poses", after_s=page["times_s"][-1], limit=3000)
    assert not rest["more"] and rest["times_s"][0] > page["times_s"][-1] and len(rest["times_s"]) > 10, rest["times_s"]
    force = checked(client, "replay.read", run=run["run"], channel="force")
    assert set(force["rows"]) == {3} and len(force["times_s"]) > 20, force["times_s"]
    assert checked(client, "scene.locations"), "the scene has locations"
finally:
    server.end()

# In virtual time, many times as quick: still no more on the wall.
scene, took, came, client, server, run = moved(["--scene", "touch", "--fast"], "touch", {})
try:
    assert len(came) <= most_a_second * took + 3, (len(came), took)
    assert sum(each["bytes"] for each in came) < most_bytes * max(took, 0.1), took
    page = checked(client, "replay.read", run=run["run"], channel="contact-points", limit=3000)
    assert any(page["rows"]), "it touched"
    poses = checked(client, "replay.read", run=run["run"], channel="poses", limit=3000)
    gaps = [after - before for before, after in zip(poses["times_s"], poses["times_s"][1:])]
    assert max(gaps) < 0.1, f"the cell keeps all poses, also those that no client got: {max(gaps)}"
finally:
    out = server.end()
assert "ended with" not in out, out
