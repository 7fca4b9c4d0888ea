#!/usr/bin/env python3
"""Every completion of every skill has a run that ends with it.

Completions stand in the templates, skills_pal/*/*.pal. Runs are test cases that compare end_of( ... ) with
"SKILL CODE". The table of both is docs/skills_endings.md.

  endings.py ROOT           fails if a completion has no run, a run is of no completion, or the table is old
  endings.py ROOT --write   writes the table
  endings.py --self-test
"""
import re
import sys
from pathlib import Path

TABLE = "docs/skills_endings.md"
INTRODUCTION = """# How each skill ends

This page lists every completion of every template, with the test cases in physics that end with it. These
tests check the code, and the arm afterwards. `tests/run/skills/endings.py . --write` writes the table from
the templates and the tests. A test fails when a completion has no run.

"""


def completions(pal):
    """[(skill, code, description)] of a PAL file."""
    found = []
    skill = None
    for line in pal.splitlines():
        head = re.match(r"SKILL\s+([\w-]+)\s*$", line)
        if head:
            skill = head.group(1)
        ending = re.match(r'\s*COMPLETION\s+(\d+)\s+[A-Z]+[ \d]*"([^"]*)"', line)
        if ending and skill:
            found.append((skill, int(ending.group(1)), ending.group(2)))
    return found


def runs(test):
    """{(skill, code): [test case]} of a C++ file."""
    found = {}
    for case in re.split(r"(?=^TEST_CASE\()", test, flags=re.M)[1:]:
        title = re.match(r'TEST_CASE\(\s*((?:"[^"]*"\s*)+)', case).group(1)
        name = "".join(re.findall(r'"([^"]*)"', title))
        compared = re.findall(r'end_of\((?:[^;]|\n)*?\)\s*==\s*"([\w-]+) (\d+)"', case)
        for skill, code in compared:
            cases = found.setdefault((skill, int(code)), [])
            if name not in cases:
                cases.append(name)
    return found


def problems(wanted, found):
    codes = {(skill, code) for skill, code, _ in wanted}
    result = [f"no run ends with {skill} {code}" for skill, code, _ in wanted if (skill, code) not in found]
    return result + [f"'{cases[0]}' ends with {skill} {code}, which no template has"
                     for (skill, code), cases in found.items() if (skill, code) not in codes]


def table(wanted, found):
    lines = ["| skill | code | | test cases |", "| --- | --- | --- | --- |"]
    for skill, code, description in wanted:
        cases = "; ".join(found.get((skill, code), []))
        lines.append(f"| {skill} | {code} | {description} | {cases} |")
    return INTRODUCTION + "\n".join(lines) + "\n"


def self_test():
    pal = 'SKILL a-b\n  COMPLETION 0 NORMAL        "Good."\n  COMPLETION 1 CONTINGENCY 1 "Bad."\nEND SKILL\n'
    wanted = completions(pal)
    assert wanted == [("a-b", 0, "Good."), ("a-b", 1, "Bad.")], wanted
    test = 'TEST_CASE("one") {\n  CHECK(end_of(run({1})\n      .outcome) ==\n    "a-b 0");\n}\n'
    found = runs(test)
    assert found == {("a-b", 0): ["one"]}, found
    assert problems(wanted, found) == ["no run ends with a-b 1"]
    assert problems(wanted, runs(test.replace("a-b 0", "a-b 7")))[-1] == "'one' ends with a-b 7, which no template has"


def main(arguments):
    if "--self-test" in arguments:
        self_test()
        return 0
    root = Path(arguments[0])
    wanted = [each for file in sorted(root.glob("skills_pal/*/*.pal")) for each in completions(file.read_text())]
    found = {}
    for folder in ("skills", "skills_val"):
        for file in sorted((root / "tests/run" / folder).glob("*_test.cpp")):
            for ending, cases in runs(file.read_text()).items():
                found.setdefault(ending, []).extend(cases)
    wrong = problems(wanted, found)
    if not wanted:
        wrong.append(f"no template below {root}/skills_pal")
    text = table(wanted, found)
    if "--write" in arguments:
        (root / TABLE).write_text(text)
    elif not (root / TABLE).is_file() or (root / TABLE).read_text() != text:
        wrong.append(f"{TABLE} is old: tests/run/skills/endings.py . --write")
    for line in wrong:
        print(line, file=sys.stderr)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
