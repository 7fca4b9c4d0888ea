#!/usr/bin/env python3
"""Every completion of every skill has a run that ends with it.

Completions stand in the templates, skills_pal/*/*.pal. Runs are test cases that compare end_of( ... ) with
"SKILL CODE". The table of both is docs/skills_endings.md.

  endings.py ROOT           fails if a completion has no run, a run is of no completion, or the table is old
  endings.py ROOT --write   writes the table
  endings.py ROOT --physics FILE    puts the table that skill_endings wrote to FILE into the page's second part
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


PHYSICS = "## What completions say, and what physics shows\n"
ABOUT_PHYSICS = PHYSICS + """
The program `skill_endings` runs skills and holds each completion against what the simulator knows: forces at
rest, where the tool and the parts are, what the fingers hold. It runs each skill's defaults in every shipped
scene in which they make sense, and each parameter at both ends of its range; skills that press also begin in
contact. Each seed is another machine, too, and another height above what is met. The program ends with 1 if
what a completion says is not so, and writes **false** in that row. A share of the rows runs with the tests.

| completion | is so if |
| --- | --- |
| touch 0 | the tool presses and stands; it never overloads the sensor |
| touch 1, press 1 | the tool is within 0.2 mm of where it began; no force reached the threshold |
| press 0 | the true force was within the band and 0.25 N for the whole time, and is at rest |
| press 2, rub 1 | the stop force was met, and nothing touches any more |
| rub 0 | the way is gone within 1 mm, without 0.2 s in the air once the tool has touched; the force at rest is in the band within 0.25 N |
| standoff 0, align 0 | the nearest point, the surface's normal, by rays from where the tool stands |
| follow-edge 0 | never more than 4 mm from where the tool should be above the seam; by the thesis's law 6 mm and twice the translation |
| follow-edge 1 | more than 2.5 mm off, or the seam has ended below the tool |
| moves 0 | within 0.2 mm of the goal; 1: within 0.2 mm of where it began |
| pick 0, 3 | both pads press on one loose part, or on none, 0.3 s after the end |
| place 0, palletize 0 | a part within 2 mm of the place, the fingers open |
| all others | the arm stands still, 0.8 s after the end |

"5 of 5: 0": how many of the runs of a row ended with which code.
{seeds} `skill_endings --row N --seed N` runs one of them.
Force "at the most" is what the tool or the fingers meet; "pressed" is how hard the sensor is pushed, also by what the fingers hold.
Reasons are cut.

"""
NUMBERS = {1: "one seed", 2: "two seeds", 3: "three seeds", 4: "four seeds", 5: "five seeds"}


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


def seeds_of(rows):
    """How many rows ran with how many seeds, in words."""
    seeds = {tuple(row.split(" | ")[:4]): int(row.split(" | ")[4].split()[2].rstrip(":")) for row in rows.splitlines()[2:]}
    counts = [(number, list(seeds.values()).count(number)) for number in sorted(set(seeds.values()), reverse=True)]
    if len(counts) == 1:
        return f"Each of the {len(seeds)} rows ran with {NUMBERS[counts[0][0]]}."
    return f"Of {len(seeds)} rows " + ", ".join(f"{count} ran with {NUMBERS[number]}" for number, count in counts) + "."


def falsehoods(rows):
    """The rows that are false, in words: the page says so before its table."""
    false = [" ".join(part.strip() for part in row.strip("| ").split(" | ")[:4]) for row in rows.splitlines()[2:] if "**false**" in row]
    if not false:
        return "No row is false."
    return f"**False today**, {len(false)} of the rows: {'; '.join(false)}. There the code 0 says more than physics shows."


def self_test():
    pal = 'SKILL a-b\n  COMPLETION 0 NORMAL        "Good."\n  COMPLETION 1 CONTINGENCY 1 "Bad."\nEND SKILL\n'
    wanted = completions(pal)
    assert wanted == [("a-b", 0, "Good."), ("a-b", 1, "Bad.")], wanted
    test = 'TEST_CASE("one") {\n  CHECK(end_of(run({1})\n      .outcome) ==\n    "a-b 0");\n}\n'
    found = runs(test)
    assert found == {("a-b", 0): ["one"]}, found
    assert problems(wanted, found) == ["no run ends with a-b 1"]
    rows = "| head |\n| --- |\n" + "| a | b | free | defaults | 4 of 5: 0 | x | |\n| a | b | free | defaults | 1 of 5: 1 | x | |\n"
    assert seeds_of(rows) == "Each of the 1 rows ran with five seeds.", seeds_of(rows)
    rows += "| a | c | free | defaults | 1 of 1: 0 | x | |\n"
    assert falsehoods(rows) == "No row is false."
    assert "1 of the rows: a d free defaults." in falsehoods(rows + "| a | d | free | defaults | 1 of 1: 0 | x | **false**: off |\n")
    assert seeds_of(rows) == "Of 2 rows 1 ran with five seeds, 1 ran with one seed.", seeds_of(rows)
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
    page = (root / TABLE).read_text() if (root / TABLE).is_file() else ""
    physics = page[page.index(PHYSICS):] if PHYSICS in page else ""
    if "--physics" in arguments:
        rows = Path(arguments[arguments.index("--physics") + 1]).read_text()
        if "**false**" in rows:
            wrong.append("a row of the table in physics is false")
        physics = ABOUT_PHYSICS.format(seeds=seeds_of(rows) + "\n" + falsehoods(rows)) + rows
    text = table(wanted, found) + ("\n" + physics if physics else "")
    if "--write" in arguments or "--physics" in arguments:
        (root / TABLE).write_text(text)
    elif not (root / TABLE).is_file() or (root / TABLE).read_text() != text:
        wrong.append(f"{TABLE} is old: tests/run/skills/endings.py . --write")
    for line in wrong:
        print(line, file=sys.stderr)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
