"""pal language-server by its streams: an edit ends proofs, requests are cancelled, any bytes are survived, the exit status.

Usage: streams.py PAL SOURCE_DIR
"""
import json
import pathlib
import random
import subprocess
import sys


def framed(message):
    body = message if isinstance(message, bytes) else json.dumps(message).encode()
    return b"Content-Length: %d\r\n\r\n" % len(body) + body


def messages(data):
    result = []
    while data:
        head, _, rest = data.partition(b"\r\n\r\n")
        length = int(head.split(b":")[1])
        result.append(json.loads(rest[:length]))
        data = rest[length:]
    return result


def run(pal, data):
    done = subprocess.run([pal, "language-server"], input=data, capture_output=True, timeout=60)
    return done.returncode, messages(done.stdout), done.stderr.decode()


def request(number, method, params=None):
    return {"jsonrpc": "2.0", "id": number, "method": method, "params": params or {}}


def note(method, params=None):
    return {"jsonrpc": "2.0", "method": method, "params": params or {}}


def main(pal, source):
    folder = pathlib.Path(source).resolve() / "skills_pal"
    uri = (folder / "touch" / "touch.pal").as_uri()
    text = (folder / "touch" / "touch.pal").read_text()
    begin = [request(1, "initialize", {"rootUri": folder.as_uri(), "capabilities": {}}), note("initialized"),
             note("textDocument/didOpen", {"textDocument": {"uri": uri, "languageId": "pal", "version": 1, "text": text}})]
    # Edits at once behind each other, a request that is cancelled, one that is answered.
    edits = [note("textDocument/didChange", {"textDocument": {"uri": uri, "version": 2 + i},
                                             "contentChanges": [{"text": text + "# " + str(i) + "\n"}]}) for i in range(50)]
    end = [request(3, "textDocument/hover", {"textDocument": {"uri": uri}, "position": {"line": 0, "character": 0}}),
           note("$/cancelRequest", {"id": 3}), request(4, "shutdown"), note("exit")]
    status, answers, errors = run(pal, b"".join(map(framed, begin + edits + end)))
    by_id = {message["id"]: message for message in answers if "id" in message}
    assert status == 0, (status, errors)
    assert by_id[1]["result"]["serverInfo"]["name"] == "pal"
    assert by_id[4]["result"] is None
    # It was cancelled, unless it had been answered before that was read.
    assert "result" in by_id[3] or by_id[3]["error"]["code"] == -32800, by_id[3]

    # The end without shutdown.
    assert run(pal, framed(request(1, "initialize", {"capabilities": {}})))[0] == 1
    assert run(pal, framed(note("exit")))[0] == 1
    assert run(pal, b"")[0] == 1

    # Bytes that are no messages, and messages with pieces missing. The seed is printed by a failure.
    valid = [framed(message) for message in begin]
    for seed in range(40):
        dice = random.Random(seed)
        data = bytearray()
        for message in valid + [framed(request(9, dice.choice(["textDocument/completion", "textDocument/rename", "pal/picture"]),
                                               {"textDocument": {"uri": uri}, "position": {"line": dice.randrange(90), "character": dice.randrange(40)},
                                                "kind": "pan", "newName": dice.choice(["x", "", "CASE", 7])}))]:
            piece = bytearray(message)
            if dice.random() < 0.5:
                for _ in range(dice.randrange(1, 5)):
                    at = dice.randrange(len(piece))
                    if dice.random() < 0.5:
                        piece[at] = dice.randrange(256)
                    else:
                        del piece[at:at + dice.randrange(1, 40)]
            data += piece
        status, _, errors = run(pal, bytes(data))
        assert status == 1 and not errors, (seed, status, errors)
    print("streams: all as they should be")


main(*sys.argv[1:])
