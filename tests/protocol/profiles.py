"""What the range finder gives to a skill comes to clients of the program: as a notification and as bytes, each with its
points; and gripper or profile are channels only where the tool is one.

Usage: profiles.py WORKCELL
"""
import sys

from cell_client import Server

server = Server(sys.argv[1], "--scene", "seam", "--fast")
try:
    text, binary = server.client(name="text"), server.client(role="viewer", name="bytes")
    channels = {each["channel"]: each for each in text.call("channels.list")}
    assert channels["profile"]["form"] == "profile" and "gripper" not in channels, channels.keys()
    text.call("channels.watch", channels=[{"channel": "profile", "period_s": 0.5}])
    binary.call("channels.watch", channels=[{"channel": "profile", "binary": True}])
    done = text.call("skill.run", skill="follow-edge", parameters={"distance": 10})
    assert done["kind"] == "normal", done
    first, second = (text.notice("profile")["params"] for _ in range(2))
    assert len(first["y_mm"]) == len(first["z_mm"]) > 100 and all(50 < z < 1000 for z in first["z_mm"]), first
    assert second["time_s"] - first["time_s"] >= 0.5, (first["time_s"], second["time_s"])
    frame = binary.notice("binary")
    points = frame["head"]["points"]
    assert frame["head"]["channel"] == "profile" and len(frame["numbers"]) == 2 * points > 200, frame["head"]
    assert all(50 < z < 1000 for z in frame["numbers"][points:]), frame["numbers"][points:]
finally:
    out = server.end()
assert "ended with" not in out, out
