"""The same part weighed twice reads the same: `weigh_and_sort` of the examples, twice in one cell. The readings are taken from
the history.

Usage: weighed.py WORKCELL OPERATION
"""
import pathlib
import sys

from cell_client import Server

server = Server(sys.argv[1], "--scene", "parts", "--fast")
try:
    cell = server.client()
    cell.call("watch")
    text = pathlib.Path(sys.argv[2]).read_text()
    # The part goes back to where it was.
    cell.call("operation.load", main="w", files={"w": text.replace('{"place": "PLACE"}', '{"place": "PART"}')})
    for _ in range(2):
        cell.call("operation.run")
        cell.until(event="ends", icon="weigh")
        while (state := cell.until(event="state"))["state"] == "running":
            pass
        assert state["state"] == "ended", state
    readings = []
    for run in cell.call("history.list", name="weigh-and-sort")["runs"]:
        steps = [each["step"] for each in cell.call("history.read", run=run["run"])["steps"]]
        readings.append(next(each["reading"] for each in steps if each["icon"] == "weigh"))
    assert len(readings) == 2 and abs(readings[0]) > 0.5, readings
    assert abs(readings[0] - readings[1]) < 0.1, readings
    print(f"{readings[0]:.3f} N and {readings[1]:.3f} N")
finally:
    out = server.end()
assert "ended with" not in out, out
