#!/usr/bin/env python3
"""Figures of the server: from an event to its clients, from a stop to its answer under load, what an idle cell costs, what
live channels cost the simulation, memory over time. Prints them with the machine.

Usage: server.py WORKCELL [--only NAME …] [--minutes N], where NAME is events, stop, idle, channels or memory
"""
import argparse
import json
import multiprocessing
import os
import pathlib
import platform
import socket
import statistics
import sys
import threading
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "protocol"))
from cell_client import Client, Refused, Server  # noqa: E402

options = argparse.ArgumentParser()
options.add_argument("workcell")
options.add_argument("--only", nargs="+", default=["events", "stop", "idle", "channels", "memory"])
options.add_argument("--minutes", type=float, default=60, help="of the memory's growth")
given = options.parse_args()


def machine():
    cpu = next((line.split(":")[1].strip() for line in open("/proc/cpuinfo") if line.startswith("model name")), platform.machine())
    load = " ".join(open("/proc/loadavg").read().split()[:3])
    return f"{cpu}, {os.cpu_count()} cores, Linux {platform.release()}, load {load}"


def spread(values):
    """In ms."""
    values = sorted(1000 * value for value in values)
    return (f"median {statistics.median(values):.2f} ms, 99 % {values[int(0.99 * (len(values) - 1))]:.2f} ms, "
            f"most {values[-1]:.2f} ms of {len(values)}")


def quiet(server, role="programmer"):
    """A client that does not sleep in Nagle's algorithm."""
    client = server.client(role=role)
    client.socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
    return client


def cpu_seconds(process):
    fields = open(f"/proc/{process.pid}/stat").read().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def resident(process):
    return next(int(line.split()[1]) / 1024 for line in open(f"/proc/{process.pid}/status") if line.startswith("VmRSS"))


def events():
    server = Server(given.workcell)
    try:
        asks, watchers = quiet(server), [quiet(server, "viewer") for _ in range(5)]
        for each in watchers:
            each.call("watch")
        first, last = [], []
        for i in range(2000):
            begin = time.perf_counter()
            asks.send("controls.release" if i % 2 else "controls.take")
            for k, each in enumerate(watchers):
                each.until(event="controls")
                if k == 0:
                    first.append(time.perf_counter() - begin)
            last.append(time.perf_counter() - begin)
            asks.step()
            time.sleep(0.002)
        print(f"events: from a request to its event at the first of five clients, {spread(first)}")
        print(f"events: … at the last of the five, {spread(last)}")
    finally:
        server.end()


def long_operation(icons):
    made = [{"id": "start", "kind": "start", "next": "i0"}]
    for i in range(icons):
        made.append({"id": f"i{i}", "kind": "skill", "skill": "relative-move", "parameters": {"dz": -1},
                     "next": f"i{i + 1}" if i + 1 < icons else "end", "error": "end"})
    return json.dumps({"operation-format": 1, "name": "long", "icons": made + [{"id": "end", "kind": "exit"}]})


class Attack(multiprocessing.Process):
    """Does it again and again, until it is ended: in a process of its own, so that what is measured does not wait for it."""

    def __init__(self, server, what):
        super().__init__(daemon=True)
        self.server, self.what = server, what
        self.over, self.rounds = multiprocessing.Event(), multiprocessing.Value("i", 0)

    def run(self):
        busy = Hasty(quiet(self.server))
        while not self.over.is_set():
            self.what(busy)
            self.rounds.value += 1


class Hasty:
    """Asks for the next before it has the answer, and looks into none: it leaves the processors to the server."""

    def __init__(self, client):
        self.client, self.owed = client, 0
        client.socket.settimeout(None)
        self.answers = client.socket.makefile("rb", buffering=1 << 16)

    def ask(self, method, ahead=1, **params):
        self.client.send(method, **params)
        self.owed += 1
        while self.owed > ahead:
            self.skip()

    def skip(self):
        """Takes one message."""
        while True:
            first, second = self.answers.read(2)
            size = second & 0x7f
            if size > 125:
                size = int.from_bytes(self.answers.read(2 if size == 126 else 8), "big")
            data = self.answers.read(size)
            assert first & 0x0f != 8, data
            if first & 0x0f == 9:
                self.client.frame(10, data)
            elif first & 0x80:
                self.owed -= 1
                return


class Echo(multiprocessing.Process):
    """A server that does nothing else than to answer: how long the machine itself takes for a request and its answer."""

    def __init__(self):
        super().__init__(daemon=True)
        self.listens = socket.create_server(("127.0.0.1", 0))
        self.start()
        self.socket = socket.create_connection(self.listens.getsockname())
        self.socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)

    def run(self):
        answers, _ = self.listens.accept()
        answers.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        while data := answers.recv(1000):
            answers.sendall(data)

    def call(self):
        self.socket.sendall(b"a stop as long as those of the protocol, in its frame and as JSON")
        self.socket.recv(1000)


def stop():
    server, echo = Server(given.workcell), Echo()
    try:
        text = long_operation(7000)
        half = long_operation(3500)  # both together fit into a request
        half_changed = half.replace("-1", "-2")

        def strangers(busy):
            with socket.create_connection(("127.0.0.1", server.port), timeout=5):
                pass

        def tokens(busy):
            wrong = Client(server.port)
            try:
                wrong.call("hello", token="wrong")
            except Refused:
                pass
            finally:
                wrong.close()

        held = []

        def silent(busy):
            if len(held) < 16:
                held.append(socket.create_connection(("127.0.0.1", server.port), timeout=1))
            time.sleep(0.01)

        attacks = {
            "nothing": None,
            f"checks of an operation of {len(text) // 1024} KiB": lambda busy: busy.ask("operation.check", main="f", files={"f": text}),
            "loads of it": lambda busy: busy.ask("operation.load", main="f", files={"f": text}),
            "snapshots with it": lambda busy: busy.ask("snapshot"),
            "comparisons of it": lambda busy: busy.ask("operation.difference", before=half, after=half_changed),
            "a flood of requests": lambda busy: busy.ask("state", ahead=50),
            "sockets without a token": strangers,
            "wrong tokens": tokens,
            "16 silent sockets": silent}
        for name, attack in attacks.items():
            thread = Attack(server, attack) if attack else None
            if thread:
                thread.start()
            client, times, plain = quiet(server, "viewer"), [], []
            time.sleep(0.2)
            for _ in range(400):
                for values, call in ((times, lambda: client.call("stop")), (plain, echo.call)):
                    begin = time.perf_counter()
                    call()
                    values.append(time.perf_counter() - begin)
                    time.sleep(0.005)
            client.close()
            if thread:
                thread.over.set()
                thread.join(60)
            print(f"stop: during {name}: {spread(times)}; an echo meanwhile: {spread(plain)}"
                  + (f"; {thread.rounds.value} rounds" if thread else ""), flush=True)
    finally:
        echo.terminate()
        server.end()


def idle():
    server = Server(given.workcell)
    try:
        time.sleep(60)  # the proofs of the skills end
        for name, watches in (("nobody", False), ("two clients that watch events", True)):
            clients = [quiet(server, "viewer") for _ in range(2)] if watches else []
            for each in clients:
                each.call("watch")
            begin, wall = cpu_seconds(server.process), time.monotonic()
            time.sleep(20)
            used = (cpu_seconds(server.process) - begin) / (time.monotonic() - wall)
            print(f"idle: a cell at the pace of the wall, with {name}: {100 * used:.2f} % of a core")
    finally:
        server.end()


class Reader(multiprocessing.Process):
    """Takes what comes and counts it: a client as quick as it can be, in a process of its own."""

    def __init__(self, client):
        super().__init__(daemon=True)
        self.socket, self.bytes = client.socket, multiprocessing.Value("q", 0)

    def run(self):
        try:
            while data := self.socket.recv(1 << 20):
                self.bytes.value += len(data)
        except OSError:
            pass


def cell_seconds(process):
    """Processor time of the cell's own thread, which is the program's first."""
    return int(open(f"/proc/{process.pid}/task/{process.pid}/schedstat").read().split()[0]) / 1e9


def channels():
    for paced in ([], ["--fast"]):
        server = Server(given.workcell, *paced)
        try:
            time.sleep(60 if paced else 0)
            asks = quiet(server)
            names = [each["channel"] for each in asks.call("channels.list")]

            def run():
                begin, cell = time.perf_counter(), cell_seconds(server.process)
                result = asks.call("skill.run", skill="relative-move", parameters={"dz": -20, "speed": 5})
                took, worked = time.perf_counter() - begin, cell_seconds(server.process) - cell
                asks.call("skill.run", skill="relative-move", parameters={"dz": 20, "speed": 5})
                return took, result["end_s"] - result["begin_s"], worked

            run()
            without, with_two, readers = [], [], []
            for _ in range(20 if paced else 3):
                without.append(run())
                watchers = [quiet(server, "viewer") for _ in range(2)]
                for each in watchers:
                    each.call("channels.watch", channels=[{"channel": name, "period_s": 0.001, "binary": True} for name in names])
                    readers.append(Reader(each))
                    readers[-1].start()
                time.sleep(0.2)
                with_two.append(run())
                for each in watchers:
                    each.socket.shutdown(socket.SHUT_RDWR)
                time.sleep(0.2)

            def more(place):
                alone, watched = (statistics.median(each[place] for each in runs) for runs in (without, with_two))
                return alone, watched, f"{100 * (watched / alone - 1):+.1f} %"

            alone, watched, slower = more(0)
            print(f"channels: {'virtual time' if paced else 'at the pace of the wall'}: a skill of {without[0][1]:.2f} s takes {alone:.3f} s alone, "
                  f"{watched:.3f} s with all {len(names)} channels at their full rate to two clients: {slower}; "
                  f"processor time of the cell's thread {more(2)[2]}; "
                  f"{sum(each.bytes.value for each in readers) / 1e6:.0f} MB were read", flush=True)
        finally:
            server.end()


def heard(client):
    """Takes one message; false: the server has ended."""
    try:
        client.step()
        return True
    except ConnectionError:
        return False


class LiveReader(multiprocessing.Process):
    """Takes live data, answers pings, and keeps nothing."""

    def __init__(self, client):
        super().__init__(daemon=True)
        self.client, self.samples = client, multiprocessing.Value("q", 0)

    def run(self):
        while heard(self.client):
            self.samples.value += sum(message["head"].get("spans", 1) for message in self.client.events if "head" in message)
            self.client.events.clear()


class Watcher(threading.Thread):
    """Reads its events as a page does, answers pings, and keeps nothing."""

    def __init__(self, client):
        super().__init__(daemon=True)
        client.call("watch")
        self.client = client

    def run(self):
        while heard(self.client):
            self.client.events.clear()


def memory():
    server = Server(given.workcell, "--fast")
    try:
        asks, watcher = quiet(server), Watcher(quiet(server, "viewer"))
        watcher.start()
        live = quiet(server, "viewer")
        names = [each["channel"] for each in live.call("channels.list")]
        live.call("channels.watch", channels=[{"channel": name, "period_s": 0.001, "binary": True} for name in names])
        reader = LiveReader(live)
        reader.start()
        text = long_operation(20)
        asks.call("operation.load", main="f", files={"f": text})
        marks, runs, spent, last = [], 0, 0, time.monotonic()
        asks.call("watch")
        while spent < 60 * given.minutes:
            asks.call("operation.run")
            asks.until(event="state", state="ended")
            asks.events.clear()
            asks.call("operation.check", main="f", files={"f": text})
            asks.call("snapshot")
            runs += 1
            if spent >= len(marks) * 60 * given.minutes / 12:
                marks.append(resident(server.process))
                print(f"memory: {spent / 60:.0f} min, {runs} runs: {marks[-1]:.1f} MiB", flush=True)
            now = time.monotonic()
            spent, last = spent + min(now - last, 5), now  # the time in which a signal held this program up does not count
        assert watcher.is_alive() and reader.is_alive(), "a client was let go"
        half = marks[len(marks) // 2:]
        print(f"memory: all channels at their full rate went to a client, {reader.samples.value / 1e6:.1f} million spans, profiles and rows; in the second half "
              f"{(half[-1] - half[0]) / max(1, len(half) - 1) * 12 / given.minutes:+.2f} MiB a minute")
        print(f"memory: over {given.minutes:g} min and {runs} runs of an operation of 20 skills: "
              f"{', '.join(f'{each:.0f}' for each in marks)} MiB")
    finally:
        server.end()


print(f"machine: {machine()}")
for name in given.only:
    {"events": events, "stop": stop, "idle": idle, "channels": channels, "memory": memory}[name]()
