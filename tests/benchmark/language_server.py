"""How long an editor waits: from an edit to findings, to the first bounds and to all verdicts, for hover and completion; memory.

Usage: language_server.py PAL SOURCE_DIR [skills|open|lines|edits|clangd] [NUMBER].

skills  Two lines a skill, after NUMBER edits of each kind, in milliseconds: median and greatest.
open    Memory with all PAL files of the tree open.
lines   An edit with NUMBER lines of PAL open, of which it changes one.
edits   Memory after each tenth of NUMBER edits; fails if it grows by more than 2 MB after the first tenth.
clangd  The same of clangd (apt-get install clangd) in a file of this project, in turns with pal in a skill: NUMBER edits each.
"""
import json
import pathlib
import re
import statistics
import subprocess
import sys
import tempfile
import threading
import time


class Client:
    def __init__(self, command):
        self.process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE)
        self.sent = []
        self.changed = threading.Condition()
        self.number = 0
        threading.Thread(target=self.read, daemon=True).start()

    def read(self):
        stream = self.process.stdout
        while line := stream.readline():
            length = int(line.split(b":")[1])
            while stream.readline() != b"\r\n":
                pass
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


def is_method(name, **params):
    return lambda each: each.get("method") == name and all(each["params"].get(key) == value for key, value in params.items())


def memory(client, what="VmRSS"):
    """In megabytes."""
    status = pathlib.Path(f"/proc/{client.process.pid}/status").read_text()
    return int(status.split(what + ":")[1].split()[0]) // 1024


def cpu(client):
    """Milliseconds of processor time so far: what a busy machine does not change."""
    fields = pathlib.Path(f"/proc/{client.process.pid}/stat").read_text().rsplit(") ", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) * 10


def start(pal, folder, **settings):
    client = Client([pal, "language-server"])
    client.ask("initialize", {"rootUri": folder.as_uri(), "capabilities": {}, "initializationOptions": {"pictures": True, **settings}})
    client.tell("initialized", {})
    return client


def open_file(client, uri, text):
    begin = time.perf_counter()
    client.tell("textDocument/didOpen", {"textDocument": {"uri": uri, "languageId": "pal", "version": 0, "text": text}})
    return begin


def append(client, uri, version, line, text):
    """Writes a line at the end, and says when."""
    where = {"line": line, "character": 0}
    begin = time.perf_counter()
    client.tell("textDocument/didChange", {"textDocument": {"uri": uri, "version": version},
                                           "contentChanges": [{"range": {"start": where, "end": where}, "text": text}]})
    return begin


def replace(client, uri, version, line, begin, end, text):
    """Puts a text in the place of a part of a line, and says when."""
    when = time.perf_counter()
    client.tell("textDocument/didChange", {"textDocument": {"uri": uri, "version": version}, "contentChanges": [
        {"range": {"start": {"line": line, "character": begin}, "end": {"line": line, "character": end}}, "text": text}]})
    return when


class TimeOfActivity:
    """The worst time of an activity of the skill's method, in the environment: with another one every proof is another."""

    def __init__(self, cell, skill_text):
        activities = set(re.findall(r"ACTIVITY +([\w-]+)", skill_text))
        for self.line, text in enumerate(cell.split("\n")):
            found = re.match(r" *TIME +([\w-]+) +OF SM1 : ([\d.]+ TO )?([\d.]+) ms", text)
            if found and found[1] in activities:
                self.begin, self.end, self.value = found.start(3), found.end(3), float(found[3])
                return
        raise ValueError("no TIME of an activity of SM1")

    def edit(self, client, uri, version):
        text = f"{self.value + 0.05 * version:.2f}"
        when = replace(client, uri, version, self.line, self.begin, self.end, text)
        self.end = self.begin + len(text)
        return when


def states_of(client, uri):
    asked = time.perf_counter()
    client.ask("pal/requirements", {"textDocument": {"uri": uri}})
    with client.changed:
        answer = next(each for at, each in reversed(client.sent) if at > asked and "result" in each)
    return [each["state"] for skill in answer["result"] for each in skill["requirements"]]


def of_skills(pal, source, edits):
    folder = source / "skills_pal"
    print("time: a worst time changes, and with it every proof; words: a comment does")
    print(f"{'skill':18} {'edit':5} {'findings':>15} {'first bounds':>15} {'verdicts':>15} {'hover':>15} {'completion':>15} undecided")
    greatest = 0
    for path in sorted(folder.glob("*/*.pal")):
        text = path.read_text()
        if "END SKILL" not in text:
            continue
        cell = path.parent / "workcell.pal"
        if not cell.exists():
            cell = folder / "workcell.pal"
        client = start(pal, folder)
        begin = open_file(client, path.as_uri(), text)
        open_file(client, cell.as_uri(), cell.read_text())
        client.wait(is_method("textDocument/publishDiagnostics"), begin)
        longer = TimeOfActivity(cell.read_text(), text)
        here = {"textDocument": {"uri": path.as_uri()}, "position": {"line": 2, "character": 8}}
        for kind in ("time", "words"):
            first, found, proved, hover, completion = [], [], [], [], []
            undecided = 0
            for i in range(1, edits + 1):
                if kind == "time":
                    begin = longer.edit(client, cell.as_uri(), i)
                else:
                    begin = append(client, path.as_uri(), i, text.count("\n"), f"# {i}\n")
                uri = cell.as_uri() if kind == "time" else path.as_uri()
                found.append(client.wait(is_method("textDocument/publishDiagnostics", uri=uri, version=i), begin))
                first.append(client.wait(is_method("pal/changed", what="proof"), begin))
                # Every verdict is known once none is open; what 2 s did not suffice for stays undecided.
                for _ in range(1000):
                    states = states_of(client, path.as_uri())
                    if "open" not in states:
                        break
                    time.sleep(0.005)
                undecided = max(undecided, states.count("undecided"))
                proved.append((time.perf_counter() - begin) * 1000)
                hover.append(client.ask("textDocument/hover", here))
                completion.append(client.ask("textDocument/completion", here))
            print(f"{path.stem:18} {kind:5} {figures(found)} {figures(first)} {figures(proved)} {figures(hover)} {figures(completion)} {undecided}",
                  flush=True)
        greatest = max(greatest, memory(client, "VmHWM"))
        client.process.kill()
    print(f"the most memory of one server: {greatest} MB")


def texts(source):
    for path in sorted(source.rglob("*.pal")):
        if not any(part.startswith(("build", ".")) for part in path.relative_to(source).parts):
            try:
                yield path, path.read_text(encoding="utf-8")
            except UnicodeDecodeError:
                pass


def with_all_open(pal, source, _):
    client = start(pal, source, proofTimeSeconds=0)
    count = 0
    for path, text in texts(source):
        open_file(client, path.as_uri(), text)
        count += 1
    client.wait(is_method("textDocument/publishDiagnostics", uri=path.as_uri()), 0, 600)
    client.ask("shutdown", None)
    print(f"{count} files open: {memory(client)} MB, at most {memory(client, 'VmHWM')} MB, {cpu(client)} ms of processor time")
    client.process.kill()


def with_many_lines(pal, source, lines):
    folder = source / "skills_pal"
    client = start(pal, folder, proofTimeSeconds=0)
    text = (folder / "touch/touch.pal").read_text()
    count = 0
    for i in range(lines // (text.count("\n") + 1) + 1):
        open_file(client, (folder / f"touch/copy_{i}.pal").as_uri(), text)
        count += text.count("\n") + 1
    uri = (folder / "touch/copy_0.pal").as_uri()
    client.wait(is_method("textDocument/publishDiagnostics", uri=uri), 0, 600)
    client.ask("textDocument/hover", {"textDocument": {"uri": uri}, "position": {"line": 2, "character": 8}})
    found, used = [], []
    for i in range(1, 11):
        before = cpu(client)
        begin = append(client, uri, i, text.count("\n"), f"# {i}\n")
        found.append(client.wait(is_method("textDocument/publishDiagnostics", uri=uri, version=i), begin, 120))
        used.append(cpu(client) - before)
    print(f"{count} lines open: edit to findings {figures(found)} ms, processor time {figures(used)} ms; {memory(client)} MB")
    client.process.kill()


def after_edits(pal, source, edits):
    folder = source / "skills_pal"
    path = folder / "touch/touch.pal"
    text = path.read_text()
    client = start(pal, folder, proofTimeSeconds=0)
    begin = open_file(client, path.as_uri(), text)
    client.wait(is_method("textDocument/publishDiagnostics"), begin)
    line = text.count("\n")
    sizes = []
    for i in range(1, edits + 1):
        begin = append(client, path.as_uri(), i, line, "# x")
        client.tell("textDocument/didChange", {"textDocument": {"uri": path.as_uri(), "version": i}, "contentChanges": [
            {"range": {"start": {"line": line, "character": 0}, "end": {"line": line, "character": 3}}, "text": ""}]})
        if i % 50 == 0:
            client.wait(is_method("textDocument/publishDiagnostics", version=i), begin)
            with client.changed:
                client.sent.clear()
        if i % max(1, edits // 10) == 0:
            sizes.append(memory(client))
            print(f"{i} edits: {sizes[-1]} MB", flush=True)
    client.process.kill()
    if sizes[-1] > sizes[0] + 2:
        sys.exit("the memory grows")


class Clangd:
    """clangd in a file of the language server."""

    def __init__(self, source, folder):
        path = source / "language_server/hover.cpp"
        command = {"directory": str(source), "file": str(path), "arguments": ["clang++", "-std=c++20", f"-I{source}", "-c", str(path)]}
        (pathlib.Path(folder) / "compile_commands.json").write_text(json.dumps([command]))
        self.client = Client(["clangd", f"--compile-commands-dir={folder}", "--background-index=0", "--log=error"])
        self.client.ask("initialize", {"rootUri": source.as_uri(), "capabilities": {}})
        self.client.tell("initialized", {})
        self.text = path.read_text()
        self.uri = path.as_uri()
        self.word = place_of(self.text, "index_.path(", len("index_.pa"))


class Pal:
    """pal in a skill, with the environment that is looked for."""

    def __init__(self, pal, source):
        path = source / "skills_pal/touch/touch.pal"
        self.client = start(pal, source / "skills_pal", proofTimeSeconds=0)
        self.text = path.read_text()
        self.uri = path.as_uri()
        self.word = place_of(self.text, "TXM( request Zforce", len("TXM( request Zf"))


def place_of(text, word, behind):
    before = text[:text.index(word) + behind]
    return {"line": before.count("\n"), "character": len(before) - before.rfind("\n") - 1}


def beside_clangd(pal, source, edits):
    with tempfile.TemporaryDirectory() as folder:
        sides = {"clangd": Clangd(source, folder), "pal": Pal(pal, source)}
        print(subprocess.run(["clangd", "--version"], capture_output=True, text=True).stdout.split("\n")[0])
        for name, side in sides.items():
            side.times = {"edit to findings": [], "hover": [], "completion": []}
            begin = open_file(side.client, side.uri, side.text)
            opened = side.client.wait(is_method("textDocument/publishDiagnostics", uri=side.uri), begin, 120)
            print(f"{name}: {side.text.count(chr(10))} lines, {opened:.0f} ms from opening it to findings")
        for i in range(1, edits + 1):
            for side in sides.values():
                comment = f"// {i}\n" if side.uri.endswith("cpp") else f"# {i}\n"
                here = {"textDocument": {"uri": side.uri}, "position": side.word}
                begin = append(side.client, side.uri, i, side.text.count("\n"), comment)
                side.times["edit to findings"].append(side.client.wait(is_method("textDocument/publishDiagnostics", uri=side.uri, version=i), begin))
                side.times["hover"].append(side.client.ask("textDocument/hover", here))
                side.times["completion"].append(side.client.ask("textDocument/completion", here))
        print(f"{'':18} {'pal':>15} {'clangd':>15} ratio")
        for what in sides["pal"].times:
            mine, other = sides["pal"].times[what], sides["clangd"].times[what]
            print(f"{what:18} {figures(mine)} {figures(other)} {statistics.median(mine) / statistics.median(other):.2f}")
        for side in sides.values():
            side.client.process.kill()


def main(pal, source, what="skills", number=None):
    run, usual = {"skills": (of_skills, 10), "open": (with_all_open, 0), "lines": (with_many_lines, 100_000), "edits": (after_edits, 10_000),
                  "clangd": (beside_clangd, 20)}[what]
    run(pal, pathlib.Path(source).resolve(), int(number or usual))


main(*sys.argv[1:])
