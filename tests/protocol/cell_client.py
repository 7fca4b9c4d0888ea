"""A client of the server's JSON protocol, with the standard library alone, and the server that it talks to."""
import base64
import json
import os
import pathlib
import socket
import struct
import subprocess
import tempfile
import time
import urllib.request


class Refused(Exception):
    """An error of the protocol."""

    def __init__(self, error):
        super().__init__(f"{error['code']}: {error['message']}; {error.get('data', {}).get('hint', '')}")
        self.code, self.data = error["code"], error.get("data")


def frame_of(data):
    """A binary message of live data: its head, and the numbers behind it."""
    length = struct.unpack_from("<I", data)[0]
    head = json.loads(data[4:4 + length])
    size, kind = (4, "f") if "rows" in head else (8, "d")
    assert (4 + length) % 8 == 0 and (len(data) - 4 - length) % size == 0, len(data)
    return {"method": "binary", "head": head, "bytes": len(data),
            "numbers": struct.unpack_from(f"<{(len(data) - 4 - length) // size}{kind}", data, 4 + length)}


class Client:
    """One connection. `seen` is called with each message, and with the method that it answers, if there is one."""

    def __init__(self, port, seen=lambda method, message: None):
        self.seen, self.last, self.waiting, self.events = seen, 0, {}, []
        self.socket = socket.create_connection(("127.0.0.1", port), timeout=20)
        self.buffer = b""
        key = base64.b64encode(os.urandom(16)).decode()
        self.socket.sendall((f"GET / HTTP/1.1\r\nHost: 127.0.0.1:{port}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n"
                             f"Sec-WebSocket-Version: 13\r\nSec-WebSocket-Key: {key}\r\n\r\n").encode())
        while b"\r\n\r\n" not in self.buffer:
            self.buffer += self.more()
        head, self.buffer = self.buffer.split(b"\r\n\r\n", 1)
        assert head.startswith(b"HTTP/1.1 101"), head

    def more(self):
        data = self.socket.recv(65536)
        if not data:
            raise ConnectionError("the server has hung up")
        return data

    def take(self, count):
        while len(self.buffer) < count:
            self.buffer += self.more()
        data, self.buffer = self.buffer[:count], self.buffer[count:]
        return data

    def frame(self, kind, data):
        mask = os.urandom(4)
        size = len(data)
        head = bytes([0x80 | kind]) + (bytes([0x80 | size]) if size < 126 else
                                       b"\xfe" + struct.pack(">H", size) if size < 65536 else
                                       b"\xff" + struct.pack(">Q", size))
        key = (mask * (size // 4 + 1))[:size]
        masked = int.from_bytes(data, "little") ^ int.from_bytes(key, "little")
        self.socket.sendall(head + mask + masked.to_bytes(size, "little"))

    def receive(self):
        """The next message: text, or bytes."""
        text, binary = b"", False
        while True:
            first, second = self.take(2)
            size = second & 0x7f
            if size == 126:
                size = struct.unpack(">H", self.take(2))[0]
            elif size == 127:
                size = struct.unpack(">Q", self.take(8))[0]
            data = self.take(size)
            kind = first & 0x0f
            if kind == 8:
                raise ConnectionError(f"closed: {data[2:].decode()}")
            if kind == 9:
                self.frame(10, data)
            elif kind in (0, 1, 2):
                text, binary = text + data, binary or kind == 2
                if first & 0x80:
                    return text if binary else text.decode()

    def send(self, method, **params):
        self.last += 1
        self.waiting[self.last] = method
        self.frame(1, json.dumps({"jsonrpc": "2.0", "id": self.last, "method": method, "params": params}).encode())
        return self.last

    def step(self):
        """Takes one message; events are kept."""
        received = self.receive()
        message = frame_of(received) if isinstance(received, bytes) else json.loads(received)
        if "id" not in message:
            self.seen(None, message)
            self.events.append(message)
            return None
        self.seen(self.waiting.pop(message["id"], None), message)
        return message

    def wait(self, request):
        while True:
            message = self.step()
            if message is None or message["id"] != request:
                continue
            if "error" in message:
                raise Refused(message["error"])
            return message["result"]

    def call(self, method, **params):
        return self.wait(self.send(method, **params))

    def until(self, **fields):
        """The first event, of those that are kept or come, with these fields."""
        while True:
            for i, message in enumerate(self.events):
                if message["method"] == "event" and all(message["params"].get(k) == v for k, v in fields.items()):
                    del self.events[:i + 1]
                    return message["params"]
            self.step()

    def notice(self, method, fits=lambda message: True):
        """The first notification of this method that fits, of those that are kept or come; it alone is taken."""
        while True:
            for i, message in enumerate(self.events):
                if message["method"] == method and fits(message):
                    return self.events.pop(i)
            self.step()

    def close(self):
        self.socket.close()


class Server:
    """`workcell serve` in a folder of its own."""

    def __init__(self, workcell, *options, page=None):
        self.folder = tempfile.TemporaryDirectory()
        path = pathlib.Path(self.folder.name)
        self.announcement = path / "cell.json"
        self.store = path / "store"
        self.process = subprocess.Popen([workcell, "serve", "--port", "0", "--announce", self.announcement, "--store",
                                         self.store, *options], stdout=subprocess.PIPE, text=True)
        end = time.monotonic() + 60
        while not self.announcement.exists():
            assert time.monotonic() < end and self.process.poll() is None, "the server does not start"
            time.sleep(0.02)
        self.announced = json.loads(self.announcement.read_text())
        self.port = self.announced["port"]

    def client(self, seen=lambda method, message: None, role="programmer", name="script"):
        client = Client(self.port, seen)
        client.hello = client.call("hello", token=self.announced["tokens"][role], name=name)
        return client

    def get(self, target):
        """Status, fields and bytes of a file."""
        try:
            with urllib.request.urlopen(f"http://127.0.0.1:{self.port}{target}", timeout=10) as answer:
                return answer.status, answer.headers, answer.read()
        except urllib.error.HTTPError as problem:
            return problem.code, problem.headers, problem.read()

    def end(self):
        self.process.terminate()
        out, _ = self.process.communicate(timeout=30)
        if self.process.returncode != 0:
            out += f"ended with {self.process.returncode}"
        self.folder.cleanup()
        return out
