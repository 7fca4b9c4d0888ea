"""Feeds odd names, texts and paths into every writer of pal, and reads back what it writes.

Usage: fuzz_writers.py PAL SOURCE_DIR FOLDER [--seed N] [--rounds N] [--seconds N]. Each round writes a skill, an environment and an
operation whose texts, comments and file names hold what XML, JSON, DOT and HTML find hard: control characters, U+FFFE, bytes that are no
UTF-8, signs of markup. Every XML is read by expat, every JSON strictly and against its schema, every SARIF against the official schema,
every DOT by pal itself. Exit status 1 and a line a fault; the round is left in FOLDER.
"""
import argparse
import html.parser
import json
import os
import pathlib
import random
import re
import shutil
import subprocess
import sys
import time
import xml.etree.ElementTree

import jsonschema

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import forms

# What may stand in a file name: any byte but / and NUL. What may stand in PAL: UTF-8 without NUL.
NASTY = ["\ufffe", "\uffff", "\ufffd", "\x01", "\x08", "\x0b", "\x0c", "\x1b[31m", "\x7f", "\x85", "\u2028", "\u202e", "\ufeff", "\u0300",
         "\U0001f916", "\U0010ffff", "]]>", "<!--", "-->", "</script>", "</title>", "<svg>", "&", "&#0;", "&amp;", "<", ">", "'", "`", "|",
         "%", "%s", "%00", "{}", "${x}", "@", "~", "*", "_", "#", "//", ";", "\u00a0", "\u200b", "é", "µ", "𝔘", "x" * 300, " ", "  ", "\t"]
BYTES = [b"\xff", b"\xc3", b"\xed\xa0\x80", b"\xf8\x88\x80\x80\x80", b"\xef\xbf\xbe", b"\xef\xbf\xbf", b"\xc0\x80", b"\n", b"\r", b"\x01", b"&", b"<",
         b">", b"\"", b"'", b"\\", b" ", b"%", b"#", b"?", b"\xe2\x80\xae", b"\xc3\xa9", b"]]>", b"--", b":", b"@"]
SKILL = """# {comment}
MESSAGE force : REAL N
CONDITION pressed FROM force "{t0}"
SKILL press
  DESCRIPTION "{t1}"
  PRECONDITION "{t2}"
  POSTCONDITION "{t3}"
  MODEL DATA "{t4}"
  LOGICAL SENSOR LS1
  SKILL METHOD SM1
  CONTINGENCY 1 "{t5}" METHOD CM1
  PARAMETER far : REAL mm DEFAULT 1 RANGE 0 TO 2 "{t6}"
  COMPLETION 0 NORMAL "{t7}"
  COMPLETION 1 CONTINGENCY 1 "{t8}"
  COMPLETION 2 ERROR "{t9}"
  REQUIREMENT brisk : INTERVAL OF WTM( force from LS1 ) AT MOST {limit} ms
END SKILL
Logical Sensor: LS1
Contingency Module: CM1
BEGIN
  Do Nothing
END
Skill Module: SM1
BEGIN
  WTM( Coordinator )
  REPEAT
    TXM( request force from LS1 )
    WTM( force from LS1 )
    SPC( pressed )
  UNTIL( pressed )
  CASE
    ( pressed = TRUE ):
      TXM( Completion Protocol 0 )
    ( pressed = FALSE ):
      Execute CM1
      TXM( Completion Protocol 1 )
  END CASE
END
{broken}
"""
BENCH = """# {comment}
ENVIRONMENT bench
  PROCESSOR P0
  DEVICE LS1 ON REQUEST 5 TO 6 ms
  PLACE SM1 ON P0 PRIORITY 1
END ENVIRONMENT
"""


class Round:
    def __init__(self, pal, folder, seed, schemas):
        self.pal, self.folder, self.schemas = pal, folder, schemas
        self.dice = random.Random(seed)
        self.faults = []

    def text(self):
        """A text of PAL in quotes, without the quotes."""
        parts = self.dice.choices(NASTY + ["plain", "words"], k=self.dice.randint(0, 4))
        return "".join(parts).replace("\\", "\\\\").replace('"', '\\"')

    def name(self, ending):
        parts = self.dice.choices(BYTES + [b"a", b"b"], k=self.dice.randint(1, 4))
        return b"n" + b"".join(parts) + ending

    def run(self, *arguments):
        command = [os.fsencode(self.pal), *(os.fsencode(each) for each in arguments)]
        done = subprocess.run(command, cwd=self.folder, capture_output=True, check=False, timeout=60)
        if done.returncode not in (0, 1, 2, 3) or b"internal error" in done.stderr:
            self.fault(arguments, f"ended with {done.returncode}: {done.stderr[-300:]!r}")
        return done.stdout

    def fault(self, arguments, why):
        self.faults.append(f"{arguments}: {why}")

    def must(self, arguments, text, check):
        try:
            check(text)
        except Exception as error:  # whatever a reader finds
            self.fault(arguments, f"{type(error).__name__}: {str(error)[:300]}")

    def xml(self, text):
        xml.etree.ElementTree.fromstring(text)

    def json(self, schema):
        def check(text):
            document = json.loads(text.decode("utf-8"), parse_constant=lambda word: self.fault((), f"{word} is no JSON"))
            if schema:
                self.schemas[schema].validate(document)
        return check

    def page(self, text):
        html.parser.HTMLParser().feed(text.decode("utf-8"))
        for control in re.findall(rb"[\x00-\x08\x0b\x0c\x0e-\x1f]|\xef\xbf[\xbe\xbf]", text):
            raise ValueError(f"{control!r} stands in the page")
        for data in re.findall(rb'<script[^>]*type="application/json"[^>]*>(.*?)</script>', text, re.S):
            json.loads(data.decode("utf-8"))

    def write(self):
        broken = self.dice.random() < 0.4
        skill = SKILL.format(comment=self.text(), limit=self.dice.choice([5, 6]),
                             broken=self.text().replace("#", "") if broken else "",
                             **{f"t{i}": self.text() for i in range(10)})
        names = [self.name(b".pal"), self.name(b"2.pal")]
        for name, text in zip(names, [skill.encode(), BENCH.format(comment=self.text()).encode()]):
            if self.dice.random() < 0.05:
                text = text.replace(b"press", self.dice.choice(BYTES))
            (pathlib.Path(os.fsdecode(os.fsencode(self.folder))) / os.fsdecode(name)).write_bytes(text)
        operation = {"format_version": 1, "name": self.text(), "icons": [{"name": self.text(), "type": "START", "next": self.text()}],
                     self.text(): self.text()}
        plan = self.name(b".op.json")
        (self.folder / os.fsdecode(plan)).write_text(json.dumps(operation), encoding="utf-8", errors="surrogatepass")
        return names[0], names[1], plan

    def all_writers(self):
        skill, bench, plan = self.write()
        gone = self.name(b"-gone.pal")
        sets = [(skill, "-e", bench), (skill,), (skill, "-e", gone), (gone,)]
        for files in sets:
            for form, check in [("json", self.json("check")), ("sarif", self.json("sarif")), ("junit", forms.check_junit)]:
                extra = self.dice.choice([(), ("--require-verdicts",), ("--warnings-as-errors",), ("--without-times",)])
                arguments = ("check", *files, "--format", form, *extra)
                self.must(arguments, self.run(*arguments), check)
        text = self.run("check", *sets[0])
        self.must(("check", *sets[0]), text, lambda it: it.decode("utf-8"))
        for command in ("whatif", "simulate", "resources"):
            arguments = (command, *sets[0], "--format", "json", *(("--runs", "2") if command == "simulate" else ()))
            out = self.run(*arguments)
            if out:
                self.must(arguments, out, self.json(None))
        for form in ("json", "sarif"):
            arguments = ("operation", "check", plan, "--skills", skill, "-e", bench, "--format", form)
            self.must(arguments, self.run(*arguments), self.json("sarif" if form == "sarif" else None))
        self.files("atc.svg", self.xml, "atc", *sets[0], "-o", "atc.svg", "--trace", "trace.json")
        self.files("trace.json", self.json(None), "atc", *sets[0], "-o", "atc.svg", "--trace", "trace.json")
        self.files("atc.html", self.page, "atc", *sets[0], "--format", "html", "-o", "atc.html")
        self.files("sim.svg", self.xml, "simulate", *sets[0], "--runs", "1", "--chart", "sim.svg")
        self.files("w.json", self.json(None), "check", *sets[0], "--witness", "w.json")
        self.files("doc.html", self.page, "doc", skill, "-o", "doc.html")
        self.files("doc.md", lambda it: it.decode("utf-8"), "doc", skill, "-o", "doc.md")
        self.files("story.html", self.page, "operation", "storyboard", plan, "--skills", skill, "-o", "story.html")
        self.files("pan", None, "pan", *sets[0], "-o", "pan")
        self.files("dot", None, "pan", *sets[0], "-o", "dot", "--dot")
        for drawing in (self.folder / "pan").glob("*.svg"):
            self.must(("pan", drawing.name), drawing.read_bytes(), self.xml)
        for drawing in (self.folder / "dot").glob("*.dot"):
            self.must(("pan --dot", drawing.name), drawing.read_bytes(), lambda it: it.decode("utf-8"))
            read_back = json.loads(self.run("check", f"dot/{drawing.name}", "--format", "json", "--without-times"))
            if any(finding["code"] in ("PAL0114", "PAL0112") for finding in read_back["diagnostics"]):
                self.fault(("pan --dot", drawing.name), "pal does not read it back")
        return self.faults

    def files(self, name, check, *arguments):
        self.run(*arguments)
        if check and (self.folder / name).exists():
            self.must(arguments, (self.folder / name).read_bytes(), check)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("pal")
    parser.add_argument("source", type=pathlib.Path)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--rounds", type=int, default=8)
    parser.add_argument("--seconds", type=float, help="instead of rounds")
    options = parser.parse_args()
    schemas = {"sarif": jsonschema.Draft4Validator(json.loads((options.source / "tests/sarif/sarif-2.1.0-rtm.5.json").read_text())),
               "check": jsonschema.Draft202012Validator(json.loads((options.source / "tests/formats/check.schema.json").read_text()))}
    begin, seed = time.monotonic(), options.seed
    while (time.monotonic() - begin < options.seconds) if options.seconds else (seed < options.seed + options.rounds):
        folder = options.folder / str(seed)
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        faults = Round(pathlib.Path(options.pal).resolve(), folder, seed, schemas).all_writers()
        if faults:
            print(f"seed {seed}, in {folder}:", *faults, sep="\n  ")
            return 1
        shutil.rmtree(folder)
        seed += 1
    print(f"{seed - options.seed} rounds from seed {options.seed}: every writer is well-formed")
    return 0


if __name__ == "__main__":
    sys.exit(main())
