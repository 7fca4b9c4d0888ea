"""A fuzzer driven by the schema of the protocol. Requests are made from the schema's types, right ones and wrong ones, and
sent to the program by clients of all roles. Every message that comes back is compared with the schema.

Usage: fuzz.py WORKCELL SCHEMA [--seconds N] [--seed N] [--scene NAME] [--patience N]
"""
import argparse
import json
import os
import pathlib
import random
import select
import threading
import time

import jsonschema

from cell_client import Client, Server

options = argparse.ArgumentParser()
options.add_argument("workcell")
options.add_argument("schema")
options.add_argument("--seconds", type=float, default=5)
options.add_argument("--seed", type=int, default=int.from_bytes(os.urandom(4), "little"))
options.add_argument("--scene", default="touch")
options.add_argument("--patience", type=float, default=60, help="seconds for an answer; more on a machine that does much else")
given = options.parse_args()
print(f"seed {given.seed}")
draw = random.Random(given.seed)
schema = json.load(open(given.schema))
methods = {method["name"]: method for method in schema["methods"]}


def validator(part):
    return jsonschema.Draft202012Validator({**part, "components": schema["components"]})


results = {name: validator(method["result"]["schema"]) for name, method in methods.items()}
notices = {each["name"]: validator(each["params"][0]["schema"]) for each in schema["x-notifications"]}
heads = [validator(each["schema"]) for each in schema["x-binary"]["heads"]]
error_data = validator({"$ref": "#/components/schemas/ErrorData"})
ours = {each["code"]: name for name, each in schema["components"]["errors"].items()}

# Words that mean something to the cell.
root = pathlib.Path(given.schema).resolve().parents[2]
texts = [path.read_text() for path in sorted((root / "examples/operations").glob("*.op.json"))]
texts.append(json.dumps({"operation-format": 1, "name": "up", "icons": [
    {"id": "start", "kind": "start", "next": "up"},
    {"id": "up", "kind": "skill", "skill": "relative-move", "parameters": {"dz": -1},
     "operator": {"dz": {"from": -5, "to": 5}}, "next": "ask", "error": "end"},
    {"id": "ask", "kind": "question", "text": "Again?", "answers": [{"text": "Yes", "to": "up"}, {"text": "No", "to": "end"}], "error": "end"},
    {"id": "end", "kind": "exit"}]}))
words = {
    "icon": ["start", "up", "ask", "end", "touch", "up/up"], "skill": ["touch", "relative-move", "move-to-location", "pick-at-location"],
    "sensor": ["force-x", "force-z", "gripper-width"], "channel": ["force", "pose", "speed", "profile"],
    "location": ["HOME", "A", "B", "SIDE"], "to": ["A", "B", "C"], "name": ["one", "two", "three", "up"], "code": ["PAL1006", "PAL9999"],
    "parameter": ["dz", "speed"], "main": ["up.op.json"], "role": ["viewer", "operator", "programmer"], "epoch": ["nothing"],
    "text": texts, "before": texts, "after": texts, "answer": ["Yes", "No"], "operation": ["up"]}
odd_texts = ["", " ", "\0", "\x1b[2J", "é\U0001f600", "../..", "a" * 300, "NaN", "-1"]
odd = [None, True, False, 0, -1, 1e308, 2**53 + 1, 2**64, -2**63, 0.5, "", [], {}, [[[]]], {"": None}]


def made(part, name="", depth=0):
    """A value of this type, mostly."""
    if "$ref" in part:
        kind = part["$ref"].rsplit("/", 1)[1]
        if kind == "Files" and draw.random() < 0.9:
            return {"up.op.json": mutated(draw.choice(texts))}
        return made(schema["components"]["schemas"][kind], name, depth + 1)
    for group in ("allOf", "anyOf", "oneOf"):
        if group in part:
            return made(draw.choice(part[group]), name, depth + 1)
    if "const" in part:
        return part["const"]
    if "enum" in part:
        return draw.choice(part["enum"])
    kind = part.get("type")
    kind = draw.choice(kind) if isinstance(kind, list) else kind
    if kind == "string":
        if name in words and draw.random() < 0.85:
            return mutated(draw.choice(words[name]))
        return draw.choice(odd_texts)
    if kind in ("integer", "number"):
        low, high = part.get("minimum", 0), part.get("maximum", 20)
        choice = draw.choice([low, high, draw.randint(int(low), max(int(low), int(high))), low - 1, high + 1, 1, 2])
        return choice if kind == "integer" else choice + draw.choice([0, 0.25])
    if kind == "boolean":
        return draw.random() < 0.5
    if kind == "array":
        return [made(part.get("items", {}), name, depth + 1) for _ in range(draw.choice([0, 1, 1, 2, 2, 6]))] if depth < 8 else []
    if kind == "object":
        wanted = part.get("required", [])
        result = {each: made(inner, each, depth + 1) for each, inner in part.get("properties", {}).items()
                  if each in wanted or draw.random() < 0.5}
        if not result and isinstance(part.get("additionalProperties"), dict):
            result = {draw.choice(["dz", "speed", "location"]): made(part["additionalProperties"], name, depth + 1)}
        return result
    return draw.choice(odd)


def mutated(text):
    """The text, or one that was hurt."""
    if draw.random() < 0.8 or not text:
        return text
    at, kind = draw.randrange(len(text)), draw.random()
    if kind < 0.4:
        return text[:at] + draw.choice(['"', "{", "}", ",", "0", "x", "\\"]) + text[at + 1:]
    if kind < 0.7:
        return text[:at] + text[at + draw.randint(1, 20):]
    return text[:at] + text[at:at + 50] * draw.randint(2, 5) + text[at:]


def params_of(method):
    result = {each["name"]: made(each["schema"], each["name"]) for each in method["params"]
              if each["required"] or draw.random() < 0.5}
    if draw.random() < 0.1 and result:
        result[draw.choice(list(result))] = draw.choice(odd)
    if draw.random() < 0.05 and result:
        del result[draw.choice(list(result))]
    return result


def raw():
    """What is no request."""
    # Half of a pair is no text, so the whole is no JSON, and its id is not known.
    return draw.choice([b'{"jsonrpc":"2.0","id":1,"method":"explain","params":{"code":"\\ud83d"}}', b"", b"{", b"[]", b"null", b"[" * 5000, b'{"jsonrpc":"2.0"}', b'{"jsonrpc":"2.0","id":1,"method":7}',
                        b'{"jsonrpc":"2.0","id":{},"method":"state"}', b'{"jsonrpc":"2.0","id":1,"method":"state","params":[]}',
                        b'"' + b"x" * 70000 + b'"', json.dumps("\0" * 40).encode()])


problems, asked, refusals, sent = [], {}, {}, 0


def seen(method, message):
    """Compares what came with the schema."""
    where = method or message.get("method")
    if message.get("method") == "binary":
        bad = [] if any(each.is_valid(message["head"]) for each in heads) else [message["head"]]
    elif "result" in message and method:
        asked[method] = asked.get(method, 0) + 1
        bad = [error.message for error in results[method].iter_errors(message["result"])]
    elif "error" in message:
        error = message["error"]
        name = ours.get(error["code"])
        refusals[name] = refusals.get(name, 0) + 1
        bad = [each.message for each in error_data.iter_errors(error["data"])]
        if name is None or name == "internal" or error["data"]["why"] != name:
            bad.append(f"the error {error}")
        declared = {each["$ref"].rsplit("/", 1)[1] for each in methods[method]["errors"]} if method in methods else set()
        if error["code"] > 0 and method in methods and name not in declared:
            bad.append(f"{name} is not declared: {error['message']}")
    else:
        bad = [error.message for error in notices[message["method"]].iter_errors(message["params"])]
    problems.extend(f"{where}: {str(each)[:300]}" for each in bad)


def resident(process):
    for line in open(f"/proc/{process.pid}/status"):
        if line.startswith("VmRSS"):
            return int(line.split()[1]) / 1024
    return 0


def come(role, name="script"):
    client = server.client(seen, role, name)
    client.socket.settimeout(given.patience)
    return client


def watch():
    client = come("programmer")
    client.call("watch")
    return client


class RunningTime(threading.Thread):
    """The time in which this program was not held up by a signal, in seconds."""

    tick = 0.1

    def __init__(self):
        super().__init__(daemon=True)
        self.seconds = 0.0
        self.start()

    def run(self):
        while True:
            time.sleep(self.tick)
            self.seconds += self.tick


clock = RunningTime()
server = Server(given.workcell, "--scene", given.scene, "--fast")
clients = []
try:
    watcher = watch()
    first_size = resident(server.process)
    size, told, hung_up = 0, 0, 0
    while (spent := clock.seconds) < given.seconds and len(problems) < 20:
        if spent >= told + 60:
            told += 60
            print(f"{spent / 60:.0f} min, {sent} requests, {len(problems)} problems, memory {resident(server.process):.0f} MiB", flush=True)
        client = None
        try:
            watcher = watcher or watch()
            if len(clients) < 4:
                clients.append(come(draw.choice(["viewer", "operator", "programmer", "programmer"]), "fuzzer"))
            client = draw.choice(clients)
            requests = []
            for _ in range(draw.choice([1, 1, 1, 5])):
                sent += 1
                name = draw.choice(list(methods))
                # hello has been said; it is refused. What never ends is ended by a stop from the watcher.
                if draw.random() < 0.03:
                    client.frame(1, raw())
                    continue
                params = params_of(methods[name])
                if name == "skill.run":
                    params["skill"] = draw.choice(["relative-move", "touch", params.get("skill", "")])
                requests.append(client.send(name, **params) if draw.random() < 0.95 else client.send("x" + name, **params))
            if draw.random() < 0.02:
                client.close()
                clients.remove(client)
                continue
            waiting = set(requests)
            looked = time.monotonic()
            patience = looked + given.patience
            while waiting & client.waiting.keys():
                # A question, or a loop, may keep an answer waiting until a stop that comes behind it.
                watcher.call(draw.choice(["stop", "operation.stop"]))
                # All that has come: answers stand behind the events of an operation that goes round and round.
                for k in range(1000):
                    if not client.buffer and not select.select([client.socket], [], [], 0 if k else 0.2)[0]:
                        break
                    client.step()
                    client.events.clear()
                now = time.monotonic()
                if now - looked > 5:  # held up by a signal, as below
                    patience += now - looked
                looked = now
                assert now < patience, f"no answer to {[client.waiting[each] for each in waiting & client.waiting.keys()]}"
        except ConnectionError as problem:
            # The server hangs up on a client that has not answered a ping for 30 s, as one that is not drawn for long. Which
            # of two it was is not known, and a signal that holds this program up cuts all.
            time.sleep(0.1)
            assert server.process.poll() is None, f"{problem}; {sorted(client.waiting.values()) if client else 'a new client'}"
            if client in clients:
                clients.remove(client)
            watcher = None
            hung_up += 1
        for each in filter(None, (client, watcher)):
            each.events.clear()
        size = max(size, resident(server.process))
    assert server.process.poll() is None, "the server has ended"
    watcher = watcher or watch()
    begin = time.monotonic()
    watcher.call("stop")
    assert watcher.call("state")["cell"] == given.scene
    print(f"{sent} requests, {sum(asked.values())} answered of {len(asked)} methods of {len(methods)}, "
          f"refused {dict(sorted(refusals.items(), key=str))}; memory {first_size:.0f} to {size:.0f} MiB; {hung_up} times hung up; "
          f"last stop {1000 * (time.monotonic() - begin):.1f} ms")
finally:
    out = server.end()
    if "ended with" in out:
        print(out)
assert "ended with" not in out, out
assert not problems, "\n".join(sorted(set(problems)))
