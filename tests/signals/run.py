"""Interrupts `pal check` and `pal simulate` at work, and gives it nowhere to write, and little memory: run.py PAL. What it knows by then must be reported, and files be whole or as they were."""
import json
import pathlib
import random
import resource
import signal
import subprocess
import sys
import tempfile
import time
import xml.etree.ElementTree

PERIODS = [7, 11, 13, 17, 19, 23, 29]  # ms: without a common divisor, so the exact analysis is not done for hours

SKILL = """
SKILL drivers
  MACHINE CONTROLLER {machines}, MC0
  SKILL METHOD SM1
  COMPLETION 0 NORMAL "done"
  COMPLETION 1 ERROR  "any other error"
{requirements}
END SKILL
Machine Controller: MC0
Skill Module: SM1
BEGIN
  WTM( Coordinator )
  WTM( stop from MC0 )
  TXM( Completion Protocol 0 )
END
MESSAGE stop : SIGNAL
"""

DRIVER = """
MESSAGE tick-{k} : SIGNAL
DEVICE clock-{k} "every {period} ms"
Machine Controller: MC{k}
  ACTIVITY work-{k}
BEGIN
  REPEAT
    WTM( tick-{k} from clock-{k} )
    work-{k}
  UNTIL( forever )
END
"""


def specification():
    """Periodic drivers on one processor, and requirements that take long to decide exactly."""
    numbers = range(1, len(PERIODS) + 1)
    drivers = "".join(DRIVER.format(k=k, period=p) for k, p in zip(numbers, PERIODS))
    requirements = "\n".join(
        f"  REQUIREMENT r{k} : RESPONSE FROM tick-{k} OF clock-{k} TO work-{k} IN MC{k} AT MOST 100 ms" for k in numbers)
    items = "".join(f"  DEVICE clock-{k} EVENT tick-{k} EVERY {p} ms\n  TIME work-{k} : 0.5 TO 1 ms\n"
                    f"  PLACE MC{k} ON P0 PRIORITY {k}\n" for k, p in zip(numbers, PERIODS))
    return (drivers + SKILL.format(machines=", ".join(f"MC{k}" for k in numbers), requirements=requirements) +
            "ENVIRONMENT cell\n  PROCESSOR P0\n  PROCESSOR P1\n  DEVICE MC0 EVENT stop SPORADIC 1 ms\n"
            "  PLACE SM1 ON P1 PRIORITY 1\n" + items + "END ENVIRONMENT\n")


def is_at_work(process):
    """Whether it has used so much processor time that it must be proving."""
    fields = pathlib.Path(f"/proc/{process.pid}/stat").read_text().rpartition(")")[2].split()
    return int(fields[11]) > 30  # clock ticks in user mode: a start takes one or two


CHECK = ["check", "drivers.pal", "--analysis", "exact", "--max-states", "1000000000", "--format", "json", "--witness", "runs.json"]
SIMULATE = ["simulate", "drivers.pal", "--runs", "1000000", "--format", "json"]


def interrupted(pal, folder, signals, arguments=CHECK):
    """Status and report of a command that gets `signals` when it is at work."""
    command = [pal, *arguments]
    with open(folder / "report", "wb") as out, open(folder / "errors", "wb") as err:
        process = subprocess.Popen(command, cwd=folder, stdout=out, stderr=err)
        deadline = time.monotonic() + 60
        while not is_at_work(process):
            assert process.poll() is None, "it ended by itself: " + (folder / "errors").read_text()
            assert time.monotonic() < deadline, "it does not begin to prove"
        for each in signals:
            process.send_signal(each)
        status = process.wait(timeout=60)
    return status, (folder / "report").read_text()


def check_one_signal(pal, which):
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "drivers.pal").write_text(specification())
        status, report = interrupted(pal, folder, [which])
        assert status == 3, f"{which.name}: status {status}"
        rows = json.loads(report)["requirements"]
        assert len(rows) == len(PERIODS), f"{which.name}: {len(rows)} requirements"
        undecided = [row for row in rows if row["verdict"] == "undecided"]
        assert undecided, f"{which.name}: all was decided before the signal"
        assert not any(row["exact"] for row in undecided), f"{which.name}: an undecided bound is called exact"
        attained = [row["attained_ns"] for row in rows if row["attained_ns"] is not None]
        assert attained and all(value > 0 for value in attained), f"{which.name}: nothing was shown to be attained"
        assert "witnesses" in json.loads((folder / "runs.json").read_text())


def check_bounds_are_kept(pal):
    """The bounds, which come first, are reported whatever the exploration is at."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "drivers.pal").write_text(specification())
        arguments = ["check", "drivers.pal", "--analysis", "thorough", "--max-states", "1000000000", "--format", "json"]
        begin = time.monotonic()
        status, report = interrupted(pal, folder, [signal.SIGINT], arguments)
        assert time.monotonic() - begin < 30, "bounds are kept: the signal was not obeyed"
        rows = json.loads(report)["requirements"]
        assert status == 0 and all(row["verdict"] == "holds" for row in rows), f"bounds are kept: status {status}"


def check_obeyed_at_once(pal):
    """From the signal to the end it takes moments: 0.05 s on an idle machine. Requirements below their bounds stay undecided, and it is said why."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "drivers.pal").write_text(specification().replace("AT MOST 100 ms", "AT MOST 5.5 ms"))
        for which in (signal.SIGINT, signal.SIGTERM):
            with open(folder / "errors", "wb") as err:
                process = subprocess.Popen([pal, "check", "drivers.pal", "--analysis", "thorough", "--max-states", "1000000000"], cwd=folder,
                                           stdout=subprocess.DEVNULL, stderr=err)
                while not is_at_work(process):
                    assert process.poll() is None, "it ended by itself: " + (folder / "errors").read_text()
                begin = time.monotonic()
                process.send_signal(which)
                status = process.wait(timeout=60)
            seconds = time.monotonic() - begin
            assert status == 3, f"{which.name}: status {status}"
            assert seconds < 5, f"{which.name} was obeyed after {seconds:.2f} s"
            assert "ended by you" in (folder / "errors").read_text(), f"{which.name}: nothing says who ended it"


def many_chains(chains):
    """A text whose reading takes long: chains of two threads on one processor, each with a requirement."""
    numbers = range(chains)
    units = "".join(f"MESSAGE a{k} : SIGNAL\nMESSAGE b{k} : SIGNAL\nDEVICE clock{k}\n" for k in numbers)
    modules = "".join(
        f"Sensor Driver: D{k}\n  ACTIVITY work\nBEGIN\n  REPEAT\n    WTM( a{k} from clock{k} )\n    work\n    TXM( b{k} to L{k} )\n  UNTIL( forever )\nEND\n"
        f"Logical Sensor: L{k}\n  ACTIVITY work\nBEGIN\n  REPEAT\n    WTM( b{k} from D{k} )\n    work\n  UNTIL( forever )\nEND\n" for k in numbers)
    skill = ("MESSAGE stop : SIGNAL\nDEVICE button\nSKILL chains\n  SENSOR DRIVER " + ", ".join(f"D{k}" for k in numbers) + "\n  LOGICAL SENSOR " +
             ", ".join(f"L{k}" for k in numbers) + "\n  MACHINE CONTROLLER Stop\n  SKILL METHOD SM1\n  COMPLETION 0 NORMAL\n  COMPLETION 1 ERROR\n" +
             "".join(f"  REQUIREMENT r{k} : RESPONSE FROM a{k} OF clock{k} TO work IN L{k} AT MOST 100 s\n" for k in numbers) + "END SKILL\n"
             "Machine Controller: Stop\nBEGIN\n  WTM( stop from button )\n  TXM( stop to SM1 )\nEND\n"
             "Skill Module: SM1\nBEGIN\n  WTM( Coordinator )\n  WTM( stop from Stop )\n  TXM( Completion Protocol 0 )\nEND\n")
    cell = ("ENVIRONMENT cell\n  PROCESSOR P0\n  PROCESSOR idle\n  DEVICE button EVENT stop SPORADIC 1000 s\n  PLACE Stop ON idle PRIORITY 2\n"
            "  PLACE SM1 ON idle PRIORITY 1\n  TIME work : 1 TO 10 us\n" +
            "".join(f"  DEVICE clock{k} EVENT a{k} EVERY 1 s\n  PLACE D{k} ON P0 PRIORITY {2 * (chains - k)}\n  PLACE L{k} ON P0 PRIORITY {2 * (chains - k) + 1}\n"
                    for k in numbers) + "END ENVIRONMENT\n")
    return units + skill + modules + cell


def seconds_of(process):
    """Its processor time in user and system mode so far."""
    fields = pathlib.Path(f"/proc/{process.pid}/stat").read_text().rpartition(")")[2].split()
    return (int(fields[11]) + int(fields[12])) / 100


def check_obeyed_while_reading(pal):
    """A signal at any instant, also before anything is proved, leaves a whole report that says who ended it."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "chains.pal").write_text(many_chains(2000))
        dice = random.Random(1)
        for form in ("text", "json", "junit", "sarif"):
            instant = dice.uniform(0.05, 0.35)  # of processor time; to read it takes about 0.4 s
            with open(folder / "report", "wb") as out, open(folder / "errors", "wb") as err:
                process = subprocess.Popen([pal, "check", "chains.pal", "--format", form], cwd=folder, stdout=out, stderr=err)
                while seconds_of(process) < instant:
                    assert process.poll() is None, "it ended by itself: " + (folder / "errors").read_text()
                begin, used = time.monotonic(), seconds_of(process)
                process.send_signal(signal.SIGTERM)
                status = process.wait(timeout=60)
            seconds = time.monotonic() - begin
            report, errors = (folder / "report").read_text(), (folder / "errors").read_text()
            where = f"{form}, signal after {used:.2f} s"
            assert status == 3, f"{where}: status {status}: {errors[-300:]}"
            assert seconds < 5, f"{where}: obeyed after {seconds:.2f} s"
            assert "ended by you" in report + errors, f"{where}: nothing says who ended it"
            if form == "json":
                assert json.loads(report)["not_checked"] or json.loads(report)["requirements"], where
            elif form == "junit":
                suites = xml.etree.ElementTree.fromstring(report)
                assert any(suite.get("skipped") != "0" or suite.get("errors") != "0" for suite in suites), f"{where}: all is green"
            elif form == "sarif":
                assert json.loads(report)["runs"][0]["invocations"][0]["exitCode"] == 3, where


def check_simulation(pal):
    """What the runs made by then show is said."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "drivers.pal").write_text(specification())
        status, report = interrupted(pal, folder, [signal.SIGINT], SIMULATE)
        assert status == 3, f"simulate: status {status}"
        made = json.loads(report)["simulations"][0]
        assert made["asked"] == 1000000 and made["runs"] < 1000000, "simulate: all runs were made"
        assert len(made["requirements"]) == len(PERIODS), "simulate: a requirement is missing"


def check_two_signals(pal):
    """The second ends it at once, if it has not ended by then; the file is the old one or a whole new one."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "drivers.pal").write_text(specification())
        (folder / "runs.json").write_text("old")
        status, _ = interrupted(pal, folder, [signal.SIGINT, signal.SIGTERM])
        assert status in (-signal.SIGTERM, -signal.SIGINT, 3), f"two signals: status {status}"
        left = (folder / "runs.json").read_text()
        assert left == "old" or "witnesses" in json.loads(left), "two signals: half a file"


def check_full_output(pal):
    """A report that could not be written is no success."""
    with open("/dev/full", "wb") as full:
        for command in (["explain", "--list"], ["--version"]):
            done = subprocess.run([pal, *command], stdout=full, stderr=subprocess.PIPE, check=False)
            assert done.returncode == 2, f"{command} to a full disk: status {done.returncode}"
            assert b"standard output" in done.stderr, f"{command} to a full disk says {done.stderr}"


def check_little_memory(pal):
    """The exploration ends, and what is known by then is reported."""
    def limited():
        resource.setrlimit(resource.RLIMIT_AS, (300 << 20, 300 << 20))
    if subprocess.run([pal, "--version"], capture_output=True, preexec_fn=limited).returncode != 0:
        return  # a sanitizer asks for more
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "drivers.pal").write_text(specification())
        made = subprocess.run([pal, *CHECK], cwd=folder, capture_output=True, text=True, preexec_fn=limited, timeout=120)
        assert made.returncode == 3, f"little memory: status {made.returncode}: {made.stderr}"
        rows = json.loads(made.stdout)["requirements"]
        assert len(rows) == len(PERIODS), "little memory: a requirement is missing"
        assert "witnesses" in json.loads((folder / "runs.json").read_text()), "little memory: no runs were written"


def check_memory_limit(pal):
    """An exploration takes no more than it may, and bounds are known whatever it may take."""
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "drivers.pal").write_text(specification().replace("AT MOST 100 ms", "AT MOST 8 ms"))
        made = subprocess.run([pal, "check", "drivers.pal", "--analysis", "thorough", "--format", "json", "--max-memory", "80MB"],
                              cwd=folder, capture_output=True, text=True, timeout=120)
        peak = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024
        rows = json.loads(made.stdout)["requirements"]
        assert all(row["bound_ns"] is not None for row in rows), "memory limit: a bound is missing"
        assert peak < 300, f"memory limit: {peak:.0f} MB"


def main():
    pal = sys.argv[1]
    check_full_output(pal)
    check_memory_limit(pal)  # first: it asks for the greatest memory of all programs by then
    for which in (signal.SIGINT, signal.SIGTERM):
        check_one_signal(pal, which)
    check_bounds_are_kept(pal)
    check_obeyed_at_once(pal)
    check_obeyed_while_reading(pal)
    check_simulation(pal)
    check_two_signals(pal)
    check_little_memory(pal)


main()
