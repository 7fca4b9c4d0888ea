"""Makes, saves, checks, runs, pauses, changes and resumes an operation by the protocol alone, in the program
`workcell serve`, and reads what it felt. Every message is checked against the schema, and each method of the schema is asked for.

Usage: dialogue.py WORKCELL SCHEMA PAGE_FOLDER
"""
import json
import sys
import time

import jsonschema

from cell_client import Client, Refused, Server

workcell, schema_path, page = sys.argv[1:]
schema = json.load(open(schema_path))
methods = {method["name"]: method for method in schema["methods"]}
asked = set()


def validator(part):
    return jsonschema.Draft202012Validator({**part, "components": schema["components"]})


results = {name: validator(method["result"]["schema"]) for name, method in methods.items()}
heads = [validator(each["schema"]) for each in schema["x-binary"]["heads"]]
notices = {each["name"]: validator(each["params"][0]["schema"]) for each in schema["x-notifications"]}
error_data = validator({"$ref": "#/components/schemas/ErrorData"})
codes = {each["data"]["why"]: each["code"] for each in schema["components"]["errors"].values()}
problems = []


def seen(method, message):
    """Compares a message with the schema."""
    def compare(what, value):
        for error in what.iter_errors(value):
            problems.append(f"{method or message.get('method')}: {error.json_path}: {error.message[:200]}")
    if message.get("method") == "binary":
        if not any(each.is_valid(message["head"]) for each in heads):
            problems.append(f"the head of a binary message: {message['head']}")
    elif method is None:
        compare(notices[message["method"]], message["params"])
    elif "result" in message:
        asked.add(method)
        compare(results[method], message["result"])
    else:
        error = message["error"]
        compare(error_data, error["data"])
        why = error["data"]["why"]
        if codes[why] != error["code"]:
            problems.append(f"{method}: {why} has code {error['code']}")
        declared = {each["$ref"].rsplit("/", 1)[1] for each in methods.get(method, {"errors": []})["errors"]}
        if error["code"] > 0 and why not in declared:
            problems.append(f"{method}: the schema does not declare {why}")


def refused(why, call, *names, **params):
    try:
        call(*names, **params)
    except Refused as problem:
        assert problem.data["why"] == why, (why, problem.data)
        return problem.data
    raise AssertionError(f"not refused: {names} {params}")


text = json.dumps({
    "operation-format": 1, "name": "feel",
    "icons": [
        {"id": "start", "kind": "start", "next": "touch"},
        {"id": "touch", "kind": "skill", "skill": "touch", "parameters": {"approach-speed": 10},
         "operator": {"approach-speed": {"from": 5, "to": 15}}, "next": "ask", "error": "end"},
        {"id": "ask", "kind": "question", "text": "Again?", "answers": [{"text": "No", "to": "look"}, {"text": "Yes", "to": "up"}],
         "error": "end"},
        {"id": "up", "kind": "skill", "skill": "relative-move", "parameters": {"dz": -20}, "next": "touch", "error": "end"},
        {"id": "look", "kind": "test", "sensor": "force-z", "limits": [-1000], "next": "end", "error": "end"},
        {"id": "end", "kind": "exit"}]})

server = Server(workcell, "--scene", "touch", "--fast", "--page", page)
try:
    stranger = Client(server.port)
    refused("not-admitted", stranger.call, "state")
    cell = server.client(seen)
    seen("hello", {"result": cell.hello})
    call = cell.call
    assert cell.hello["protocol"] == 2 and "store" in cell.hello["offers"], cell.hello
    assert call("watch", since=cell.hello["last_event"], epoch=cell.hello["epoch"])["complete"]
    assert not call("watch", since=0, epoch="another")["complete"]

    # Files for browsers.
    status, fields, body = server.get("/")
    assert status == 200 and b"page" in body and "unsafe" not in fields["Content-Security-Policy"], (status, fields)
    assert server.get("/../cell.json")[0] == 404

    # What there is.
    skills = {each["skill"]: each for each in call("skills")}
    assert skills["touch"]["able"] and not skills["pick-at-location"]["able"], skills["pick-at-location"]
    assert any(each["sensor"] == "force-z" for each in call("sensors"))
    told = call("skill.check", skill="touch", parameters={"approach-speed": 10})
    assert told["runs"] and told["findings"] == [], told
    told = call("skill.check", skill="touch", parameters={"approach-speed": 6000, "colour": 1})
    assert not told["runs"] and {each["field"] for each in told["findings"]} == {"parameters/approach-speed", "parameters/colour"}, told
    told = call("skill.check", skill="pick-at-location")
    assert not told["runs"] and "tool gripper" in told["findings"][0]["message"] + told["findings"][0]["hint"], told
    assert call("clients")[-1]["name"] == "script"
    assert "PAL1006" in call("explain", code="PAL1006")["code"]
    refused("absent", call, "explain", code="PAL9999")

    # Made, checked, saved.
    text = call("operation.format", text=text)["text"]
    told = call("operation.check", main="feel.op.json", files={"feel.op.json": text})
    assert told["runs"] and {"touch", "ask"} <= {each["icon"] for each in told["icons"]}, told["findings"]
    wrong = call("operation.check", main="f", files={"f": text.replace('"touch", "parameters"', '"tough", "parameters"')})
    assert [(each["code"], each["icon"], each["field"]) for each in wrong["findings"]][0] == ("PAL1007", "touch", "skill"), wrong
    places = call("operation.tidy", main="f", files={"f": text}, sizes={"skill": [160, 80]})["places"]
    assert len(places) == 6
    chapter = call("operation.storyboard", main="f", files={"f": text})["chapters"][0]
    assert "touch" in [each["icon"] for each in chapter["scenes"]] and chapter["picture"].count("<svg") == 1, chapter
    refused("wrong", call, "operation.storyboard", main="f", files={"f": text.replace('"kind": "start"', '"kind": "exit"')})
    assert call("store.save", name="feel", text=text, based_on=0, note="first")["version"] == 1
    assert refused("exists", call, "store.save", name="feel", text=text, based_on=0)["newest"] == 1
    slower = text.replace('"approach-speed": 10', '"approach-speed": 12')
    assert call("store.save", name="feel", text=slower, based_on=1)["version"] == 2
    assert call("operation.difference", before=text, after=slower)["changes"][0]["icon"] == "touch"
    assert len(call("store.versions", name="feel")) == 2 and call("store.read", name="feel", version=1)["text"] == text
    call("store.rename", name="feel", to="feel it", based_on=2)
    assert call("store.list")[0]["name"] == "feel it"
    call("store.save", name="other", text=text, based_on=0)
    call("store.delete", name="other", based_on=1)
    refused("absent", call, "store.read", name="other")
    refused("wrong", call, "store.read", name="../cell")
    assert not call("cancel", request=12345)["found"]

    # Loaded, run, paused, changed, resumed.
    assert call("operation.load", name="feel it")["operation"] == "feel"
    first = call("operation.break", icon="end", enabled=False)["breakpoint"]
    call("operation.break", breakpoint=first, icon="ask", condition={"count-of": "touch", "at-least": 1})
    assert len(call("operation.breakpoints")) == 1
    call("operation.run")
    ended = cell.until(event="ends", icon="touch")
    assert ended["kind"] == "normal" and ended["figures"]["force"] > 0, ended
    assert cell.until(event="state", state="paused")["token"] == "ask"
    call("operation.unbreak", breakpoint=first)
    assert call("operation.set", icon="touch", parameter="approach-speed", value=6) == {"value": 6, "before": 12}
    refused("wrong", call, "operation.set", icon="touch", parameter="approach-speed", value=6000)
    assert call("snapshot")["changed"][0]["before"] == 12
    assert call("operation.values", icon="touch")["parameters"][0]["name"]
    assert call("operation.outlook")["choices"][0]["method"] == "operation.resume"
    refused("nothing", call, "operation.pause")
    call("operation.resume")
    assert cell.until(event="question")["question"]["answers"] == ["No", "Yes"]
    assert call("state")["question"]["icon"] == "ask"
    call("operation.answer", icon="ask", answer="Yes")
    assert cell.until(event="begins", icon="touch")["parameters"]["approach-speed"] == 6
    cell.until(event="question")
    # A late client sees the same, and may stop.
    late = server.client(seen, "viewer", "late")
    assert late.hello["question"]["icon"] == "ask" and late.hello["icons"], late.hello
    touched = next(each for each in late.hello["icons"] if each["icon"] == "touch")
    assert touched["reason"] == "The tool touches the surface." and touched["took_s"] > 0, touched
    refused("role", late.call, "operation.answer", icon="ask", answer=0)
    late.call("operation.pause")
    assert cell.until(event="pausing")["by"] == "late"
    cell.until(event="state", state="paused")
    late.call("stop")
    assert cell.until(event="state")["state"] == "stopped"
    call("hold.set", reason="look inside")
    refused("held", call, "operation.resume")
    call("hold.release")
    call("operation.from", icon="look")
    call("operation.step")
    assert cell.until(event="ends", icon="look")["kind"] == "normal"
    cell.until(event="state", state="ended")
    call("operation.clear")
    call("operation.stop")

    # Forces come to whoever asks, while a skill runs.
    call("watch", telemetry=0.02)
    run = call("skill.run", skill="relative-move", parameters={"dz": -20})
    assert run["kind"] == "normal", run
    cell.notice("telemetry")
    call("watch", telemetry=0)

    # Live data: what it feels while it touches, with each peak, as text and as bytes.
    channels = {each["channel"]: each for each in call("channels.list")}
    assert {"force", "pose", "set-point", "joints", "speed", "contacts"} <= channels.keys(), channels.keys()
    refused("absent", call, "channels.watch", channels=[{"channel": "colour"}])
    call("channels.watch", channels=[{"channel": "force", "period_s": 0.02}, {"channel": "speed", "period_s": 0.5},
                                     {"channel": "pose", "period_s": 0.1, "binary": True}])
    cell.events.clear()
    felt = call("skill.run", skill="touch", parameters={"approach-speed": 10})
    assert felt["kind"] == "normal", felt
    call("skill.run", skill="relative-move", parameters={"dz": -1})  # samples come in blocks: those of the touch are full then
    spans = []
    while not spans or spans[-1]["end_s"] < felt["end_s"]:
        spans += cell.notice("samples", lambda each: each["params"]["channel"] == "force")["params"]["spans"]
    # A span has 20 ms, or on a quick machine, which is given no more bytes, twice that and more; no sample is missing.
    assert all(span["count"] >= 20 for span in spans[1:-1]), [span["count"] for span in spans]
    assert all(abs(after["begin_s"] - span["end_s"] - 0.001) < 1e-9 for span, after in zip(spans, spans[1:])), spans
    assert min(span["low"][2] for span in spans) < -5, "it pressed with its threshold"
    assert cell.notice("samples", lambda each: each["params"]["channel"] == "speed")["params"]["spans"][0]["high"][0] > 0
    frame = cell.notice("binary")
    assert frame["head"]["channel"] == "pose" and len(frame["numbers"]) == frame["head"]["spans"] * (3 + 3 * 6), frame
    call("channels.watch", channels=[])

    # Pictures of skills, which are drawn meanwhile.
    while not (drawn := {each["skill"]: each for each in call("skills")}["touch"]["pictures"]):
        time.sleep(0.2)
    for picture in drawn:
        status, fields, body = server.get(picture["path"])
        assert status == 200 and fields["Content-Type"] == "image/svg+xml" and b"<svg" in body, (picture, status)

    # How near it came to its requirements. Bounds come while the server proves.
    fresh = {each["name"]: each for each in call("requirements", skill="touch")[0]["requirements"]}["fresh-force"]
    assert 0 < fresh["measured"] <= fresh["limit"] == 0.01 and abs(fresh["margin"] - (0.01 - fresh["measured"])) < 1e-12, fresh
    while not (proved := [one for each in call("requirements") for one in each["requirements"] if one["verdict"] != "proving"]):
        time.sleep(0.2)
    assert all(each["verdict"] == "holds" and each["bound"] <= each["limit"] for each in proved), proved
    refused("absent", call, "requirements", skill="juggle")

    # Sensors.
    read = call("sensor.read", sensor="force-z")
    assert read["unit"] == "N" and read["value"] < 0, read
    known = {each["sensor"]: each for each in call("sensors")}["force-z"]
    assert known["value"] == read["value"] and known["high"] == 65, known
    refused("absent", call, "sensor.read", sensor="colour")

    # Locations.
    call("skill.run", skill="relative-move", parameters={"dz": -20})
    taught = call("locations.teach", location="TOUCHED", based_on=0)
    assert taught["version"] == 1 and taught["by"] == "script" and len(taught["joints"]) == 6, taught
    assert cell.until(event="location")["location"] == "TOUCHED"
    assert refused("newer", call, "locations.teach", location="TOUCHED", based_on=0)["newest"] == 1
    refused("wrong", call, "locations.teach", location="no name")
    refused("wrong", call, "skill.run", skill="move-to-location", parameters={"location": "SIDE"})
    assert call("locations.rename", location="TOUCHED", to="SIDE", based_on=1)["location"] == "SIDE"
    call("skill.run", skill="relative-move", parameters={"dz": -10})
    assert call("skill.run", skill="move-to-location", parameters={"location": "SIDE"})["kind"] == "normal"
    there = call("locations.teach", location="AGAIN")
    here = call("locations.here")
    assert here["pose"] == there["pose"], (here, there)
    above = call("locations.teach", location="ABOVE", pose=[*here["pose"][:2], here["pose"][2] + 20, *here["pose"][3:]])
    assert above["joints"] is None and above["pose"][2] == here["pose"][2] + 20, above
    assert all(abs(a - b) < 0.5 for a, b in zip(there["pose"][:3], taught["pose"][:3])), (there, taught)
    x, y, z, *turn = there["pose"]
    call("locations.teach", location="ALONG", pose=[x + 30, y, z, *turn])
    call("locations.teach", location="BESIDE", pose=[x, y + 30, z + 30, *turn])
    square = call("locations.surface", origin="AGAIN", along="ALONG", beside="BESIDE")["pose"]
    # The tool that hung upright leans by 45 degrees about the x axis.
    assert all(abs(a - b) < 0.01 for a, b in zip(square, [x, y, z])) and abs(abs(square[4]) - 45) < 0.1, (square, there)
    refused("wrong", call, "locations.surface", origin="AGAIN", along="ALONG", beside="ALONG")
    refused("absent", call, "locations.surface", origin="AGAIN", along="ALONG", beside="NOWHERE")
    for each in ["ALONG", "BESIDE"]:
        call("locations.delete", location=each)
    call("locations.delete", location="AGAIN", based_on=1)
    assert "AGAIN" not in [each["location"] for each in call("locations.list")]

    # What was run, and what was felt.
    runs = call("history.list", limit=5)
    assert runs["more"] and runs["runs"][0]["name"] == "move-to-location" and runs["runs"][0]["by"] == "script", runs
    past = call("history.list", name="feel")["runs"]
    assert past[0]["state"] == "ended" and past[0]["kind"] == "operation", past
    read = call("history.read", run=past[-1]["run"])
    touches = [each for each in read["steps"] if each["step"].get("skill") == "touch"]
    assert len(touches) == 2 and touches[0]["step"]["figures"]["greatest-force"] > 5, touches
    assert touches[1]["parameters"]["approach-speed"] == 6 and touches[1]["parameters"]["threshold"] == 5, touches
    assert read["text"] == slower
    refused("absent", call, "history.read", run=10**6)
    felt = call("history.steps", skill="touch", limit=2)
    assert felt["more"] and all(each["step"]["skill"] == "touch" for each in felt["rows"]), felt
    assert felt["rows"][0]["step"]["measured"]["fresh-force"] < 0.01, felt

    # What the cell looks like, and a run again.
    looks = call("scene.get")
    assert any(each["moves"] for each in looks["bodies"]) and any(each["kind"] == "sphere" for each in looks["shapes"]), looks["bodies"]
    assert "SIDE" in [each["location"] for each in call("scene.locations")]
    kept = call("replay.list")
    assert kept[0]["run"] == runs["runs"][0]["run"] and {"poses", "force"} <= set(kept[0]["channels"]), kept
    assert len(call("replay.read", run=kept[0]["run"], channel="poses")["times_s"]) > 3
    call("channels.watch", channels=[{"channel": "poses"}, {"channel": "contact-points", "binary": True}])
    cell.notice("rows")
    cell.notice("binary", lambda each: each["head"]["channel"] == "contact-points")
    call("channels.watch", channels=[])

    # Aside: the cell does not move.
    before = call("locations.here")
    tried = call("study.try", skill="touch", parameters={"approach-speed": 10}, before=[{"skill": "relative-move", "parameters": {"dz": -5}}])
    assert tried["kind"] == "normal" and tried["figures"]["greatest-force"] > 5 and tried["measured"]["fresh-force"] < 0.01, tried
    assert call("study.try", skill="move-to-location", parameters={"location": "ABOVE"}, joints=before["joints"])["kind"] == "normal"
    assert call("locations.here") == before
    refused("wrong", call, "study.try", skill="touch", parameters={"approach-speed": 1000})

    # Nobody moves by hand an arm whose time does not go by the clock.
    refused("absent", call, "jog.start", frame="tool")
    refused("nothing", call, "jog.keep", axes=[0, 0, 1, 0, 0, 0])
    refused("nothing", call, "jog.stop")

    # Controls.
    operator = server.client(seen, "operator", "operator")
    refused("not-yours", operator.call, "controls.take")
    operator.call("controls.ask", reason="my turn")
    assert cell.until(event="asked")["name"] == "operator"
    call("controls.give", client=operator.hello["client"])
    refused("role", operator.call, "operation.set", icon="touch", parameter="approach-speed", value=16)
    operator.call("operation.set", icon="touch", parameter="approach-speed", value=15)
    call("controls.take", force=True)
    call("controls.release")

    missing = methods.keys() - asked - {"jog.start", "jog.keep", "jog.stop"}  # jog.py: only at the pace of the wall
    assert not missing, f"not asked for: {sorted(missing)}"
    refused("no-method", call, "operation.fly")
    late.close()
finally:
    out = server.end()
assert "served for" in out and "ended with" not in out, out
assert not problems, "\n".join(sorted(set(problems)))
print(f"{len(asked)} methods, as the schema says")
