"""How long an editor waits: from an edit to findings and to all verdicts, for hover and completion.

Usage: language_server.py PAL SOURCE_DIR [EDITS]. One line a skill, in milliseconds: median and greatest.
"""
import json
import pathlib
import statistics
import subprocess
import sys
import threading
import time


class Client:
    def __init__(self, pal):
        self.process = subprocess.Popen([pal, "language-server"], stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        self.sent = []
        self.changed = threading.Condition()
        self.number = 0
        threading.Thread(target=self.read, daemon=True).start()

    def read(self):
        stream = self.process.stdout
        while line := stream.readline():
            length = int(line.split(b":")[1])
            stream.readline()
            message = json.loads(stream.read(length))
            with self.changed:
                self.sent.append((time.perf_counter(), message))
                self.changed.notify_all()

    def write(self, message):
        body = json.dumps({"jsonrpc": "2.0", **message}).encode()
        self.process.stdin.write(b"Content-Length: %d\r\n\r\n" % len(body) + body)
        self.process.stdin.flush()

    def wait(self, fits, begin, seconds=30):
        """Milliseconds from the instant `begin` to the first message after it that fits."""
        with self.changed:
            found = self.changed.wait_for(lambda: [at for at, each in self.sent if at > begin and fits(each)], seconds)
        if not found:
            raise TimeoutError
        return (found[0] - begin) * 1000

    def ask(self, method, params):
        self.number += 1
        begin = time.perf_counter()
        self.write({"id": self.number, "method": method, "params": params})
        return self.wait(lambda each: each.get("id") == self.number and "method" not in each, begin)

    def tell(self, method, params):
        self.write({"method": method, "params": params})


def figures(times):
    return f"{statistics.median(times):7.1f} {max(times):7.1f}"


def main(pal, source, edits="10"):
    folder = pathlib.Path(source).resolve() / "skills_pal"
    print(f"{'skill':24} {'findings':>15} {'verdicts':>15} {'hover':>15} {'completion':>15}")
    greatest = 0
    for path in sorted(folder.glob("*/*.pal")):
        text = path.read_text()
        if "END SKILL" not in text:
            continue
        client = Client(pal)
        client.ask("initialize", {"rootUri": folder.as_uri(), "capabilities": {}, "initializationOptions": {"pictures": True}})
        client.tell("initialized", {})
        document = {"uri": path.as_uri(), "languageId": "pal", "version": 0, "text": text}
        client.tell("textDocument/didOpen", {"textDocument": document})
        found, proved, hover, completion = [], [], [], []
        client.wait(lambda each: each.get("method") == "textDocument/publishDiagnostics", 0)
        for i in range(1, int(edits) + 1):
            begin = time.perf_counter()
            where = {"line": text.count("\n"), "character": 0}
            client.tell("textDocument/didChange", {"textDocument": {"uri": path.as_uri(), "version": i},
                                                   "contentChanges": [{"range": {"start": where, "end": where}, "text": f"# {i}\n"}]})
            found.append(client.wait(lambda each: each.get("method") == "textDocument/publishDiagnostics" and each["params"].get("version") == i, begin))
            here = {"textDocument": {"uri": path.as_uri()}, "position": {"line": 2, "character": 8}}
            proved.append(client.wait(lambda each: each.get("method") == "pal/changed" and each["params"]["what"] == "proof", begin))
            hover.append(client.ask("textDocument/hover", here))
            completion.append(client.ask("textDocument/completion", here))
        status = pathlib.Path(f"/proc/{client.process.pid}/status").read_text()
        greatest = max(greatest, int(status.split("VmHWM:")[1].split()[0]))
        print(f"{path.stem:24} {figures(found)} {figures(proved)} {figures(hover)} {figures(completion)}", flush=True)
        client.process.kill()
    print(f"the most memory of one server: {greatest // 1024} MB")


main(*sys.argv[1:])
