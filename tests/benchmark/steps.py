#!/usr/bin/env python3
"""Times `pal check` on systems of many steps, beside the time of the bounds alone: steps.py [--pal PAL …] [--print STEPS] [STEPS …].

A system has chains of four threads, each started by the message of the one before, the first by a timer. The chains share
16 processors at 60 % load, and each has a requirement on its response. Times are processor times, the best of three. Several programs are
timed in turn. `--print` writes the system of so many steps.
"""
import argparse
import json
import pathlib
import random
import resource
import subprocess
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
PROCESSORS = 16
LOAD = 0.6
STAGES = 4
PERIODS_MS = (50, 100, 200, 250, 400, 500, 1000, 2000)
MICROSECONDS = 1000
TURNS = 3


def system(steps, processors=PROCESSORS, seed=1):
    """The text of a system; the same arguments give the same text."""
    draw = random.Random(seed)
    chains = sorted(draw.choice(PERIODS_MS) for _ in range(steps // STAGES))
    on = [[draw.randrange(processors) for _ in range(STAGES)] for _ in chains]
    weight = [[0.1 + draw.random() for _ in range(STAGES)] for _ in chains]
    sums = [sum(w for c, places in enumerate(on) for s, w in enumerate(weight[c]) if places[s] == p) for p in range(processors)]

    name = lambda c, s: f"{'SD' if s % 2 == 0 else 'LS'}-{c}-{s}"
    of_kind = lambda kind: ", ".join(name(c, s) for c in range(len(chains)) for s in range(STAGES) if s % 2 == kind)
    out = ["MESSAGE stop : SIGNAL", "DEVICE button"]
    out += [f"MESSAGE m{c}-{s} : SIGNAL" for c in range(len(chains)) for s in range(STAGES)]
    out += [f"DEVICE clock-{c}" for c in range(len(chains))]
    out += ["SKILL steps", f"  SENSOR DRIVER {of_kind(0)}", f"  LOGICAL SENSOR {of_kind(1)}", "  MACHINE CONTROLLER Stop\n  SKILL METHOD SM1",
            "  COMPLETION 0 NORMAL", "  COMPLETION 1 ERROR"]
    last = STAGES - 1
    out += [f"  REQUIREMENT chain-{c} : RESPONSE FROM m{c}-0 OF clock-{c} TO work IN {name(c, last)} AT MOST {5 * period} ms"
            for c, period in enumerate(chains)]
    out.append("END SKILL")
    for c in range(len(chains)):
        for s in range(STAGES):
            sender = f"clock-{c}" if s == 0 else name(c, s - 1)
            out.append(f"{'Sensor Driver' if s % 2 == 0 else 'Logical Sensor'}: {name(c, s)}\n  ACTIVITY work\nBEGIN\n  REPEAT")
            out.append(f"    WTM( m{c}-{s} from {sender} )\n    work")
            if s < last:
                out.append(f"    TXM( m{c}-{s + 1} to {name(c, s + 1)} )")
            out.append("  UNTIL( forever )\nEND")
    out.append("Machine Controller: Stop\nBEGIN\n  WTM( stop from button )\n  TXM( stop to SM1 )\nEND")
    out.append("Skill Module: SM1\nBEGIN\n  WTM( Coordinator )\n  WTM( stop from Stop )\n  TXM( Completion Protocol 0 )\nEND")
    out.append("ENVIRONMENT cell\n" + "\n".join(f"  PROCESSOR p{p}" for p in range(processors)) + "\n  PROCESSOR idle")
    out.append("  DEVICE button EVENT stop SPORADIC 1000 s\n  PLACE Stop ON idle PRIORITY 2\n  PLACE SM1 ON idle PRIORITY 1")
    for c, period in enumerate(chains):
        out.append(f"  DEVICE clock-{c} EVENT m{c}-0 EVERY {period} ms")
        for s in range(STAGES):
            processor = on[c][s]
            share = LOAD * weight[c][s] / sums[processor]
            worst = max(1, int(share * period * MICROSECONDS))
            out.append(f"  PLACE {name(c, s)} ON p{processor} PRIORITY {(len(chains) - c) * STAGES + s}")
            out.append(f"  TIME work OF {name(c, s)} : {(worst + 1) // 2} TO {worst} us")
    out.append("END ENVIRONMENT\n")
    return "\n".join(out)


def check(pal, files, *options):
    """What `pal check` prints of each file, and the processor time of all of them in seconds."""
    def used():
        children = resource.getrusage(resource.RUSAGE_CHILDREN)
        return children.ru_utime + children.ru_stime
    begin = used()
    runs = [subprocess.run([pal, "check", file, *options], capture_output=True, text=True, check=False) for file in files]
    return [run.stdout for run in runs], used() - begin


def row(pals, name, texts, folder):
    files = []
    for number, text in enumerate(texts):
        files.append(str(folder / f"{number}.pal"))
        pathlib.Path(files[-1]).write_text(text)
    best = {}
    for _ in range(TURNS):
        for pal in pals:
            for analysis in ("auto", "compositional"):
                best[pal, analysis] = min(best.get((pal, analysis), 1e9), check(pal, files, "--analysis", analysis)[1])
            texts, seconds = check(pal, files, "--analysis", "compositional", "--format", "json", "--statistics")
            reports = [json.loads(text) for text in texts]
            proofs = sum(report["statistics"]["seconds"] for report in reports)
            best[pal, "json"] = min(best.get((pal, "json"), (seconds, proofs)), (seconds, proofs))
    rows = [each for report in reports for each in report["requirements"]]
    held = sum(1 for each in rows if each["verdict"] == "holds")
    for pal in pals:
        default, compositional, (as_json, proofs) = best[pal, "auto"], best[pal, "compositional"], best[pal, "json"]
        print(f"| {name} | {default:.2f} s | {compositional:.2f} s | {as_json:.2f} s | {proofs:.2f} s | {held} of {len(rows)} |"
              + (f" {pal} |" if len(pals) > 1 else ""), flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("sizes", nargs="*", type=int, metavar="STEPS")
    parser.add_argument("--pal", action="append")
    parser.add_argument("--print", type=int, metavar="STEPS", dest="steps")
    options = parser.parse_args()
    if options.steps:
        print(system(options.steps), end="")
        return
    pals = options.pal or [str(ROOT / "build/release/bin/pal")]
    print("| steps | default | compositional | as JSON, with all addends | of it the bounds, by the clock | hold |\n| --- | --- | --- | --- | --- | --- |")
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for steps in options.sizes or (400, 2000, 10000):
            row(pals, steps, [system(steps)], folder)
        if options.sizes:
            return
        row(pals, "60 × 400", [system(400, seed=seed) for seed in range(1, 61)], folder)
        row(pals, "60 × 40, 4 processors", [system(40, 4, seed) for seed in range(1, 61)], folder)


if __name__ == "__main__":
    main()
