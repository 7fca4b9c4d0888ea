"""The dialogue of docs/reference/protocols.md, held with the program. Virtual time and a fixed seed make each one the
same. Only what is new at each start is replaced: token, epoch, date and version.

Usage: recorded.py WORKCELL PAGE [--write]; with --write the page gets the dialogue
"""
import json
import pathlib
import re
import sys

from cell_client import Refused, Server

BEGIN, END = "<!-- held by tests/protocol/recorded.py -->\n", "<!-- until there -->\n"
workcell, page = sys.argv[1], pathlib.Path(sys.argv[2])

operation = json.dumps({"operation-format": 1, "name": "feel", "icons": [
    {"id": "start", "kind": "start", "next": "touch"},
    {"id": "touch", "kind": "skill", "skill": "touch", "parameters": {"approach-speed": 10}, "next": "done", "error": "done"},
    {"id": "done", "kind": "exit"}]})
lines = []


def plain(text):
    for pattern, instead in ((r'"wall":"[^"]*"', '"wall":"2026-11-28T10:59:24.123Z"'),
                             (r'"(since|begun|ended)":"[^"]*"', r'"\1":"2026-11-28T10:59:24.123Z"'),
                             (r'"epoch":"[^"]*"', '"epoch":"9c41d07be2a5"'),
                             (r'"version":"[^"]*"', '"version":"1.0.0"'),
                             (r'"token": "[^"]*"', '"token": "3f…"')):
        text = re.sub(pattern, instead, text)
    return text


def told(message):
    lines.append("← " + plain(json.dumps(message, separators=(",", ":"), ensure_ascii=False)))


def ask(method, **params):
    """The request and its answer."""
    request = {"jsonrpc": "2.0", "id": client.last + 1, "method": method}
    lines.append("→ " + plain(json.dumps({**request, "params": params} if params else request, ensure_ascii=False)))
    answers = []
    client.seen = lambda of, message: answers.append(message) if of else None
    try:
        client.call(method, **params)
    except Refused:
        pass
    told(answers[-1])


def events(**last):
    """Those up to this one."""
    while True:
        while client.events:
            message = client.events.pop(0)
            told(message)
            if all(message["params"].get(name) == value for name, value in last.items()):
                return
        client.step()


server = Server(workcell, "--scene", "touch", "--fast", "--seed", "1")
try:
    from cell_client import Client
    client = Client(server.port)
    ask("hello", token=server.announced["token"], name="bench")
    ask("watch")
    ask("operation.load", main="feel.op.json", files={"feel.op.json": operation})
    events(event="loaded")
    ask("operation.run")
    events(event="state", state="ended")
    ask("operation.set", icon="touch", parameter="approach-speed", value=600)
    ask("history.list")
    client.close()
finally:
    server.end()

dialogue = BEGIN + "\n```\n" + "\n".join(lines) + "\n```\n\n" + END
text = page.read_text()
if "--write" in sys.argv:
    head, rest = text.split(BEGIN, 1)
    page.write_text(head + dialogue + rest.split(END, 1)[1])
elif dialogue not in text:
    print("the dialogue of the page is not what the program says now; run this with --write\n" + dialogue)
    sys.exit(1)
