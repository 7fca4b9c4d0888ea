#!/usr/bin/env python3
"""Checks the table of findings against the sources and the tests.

    check_findings.py ROOT [--self-test]

- Each row is reported somewhere, and stands below its code. Each note is used.
- A row whose hint shows JSON says that its hint is for those who write the file, and no other does.
- No source beside pal/support writes the message or the code of a finding itself.
- Each text is expected by a test: a golden, a unit test, or an example that `pal explain` shows. Those that are not
  are printed, and may be at most MOST_UNSEEN.
Ends with 1 if one of these does not hold.
"""
import re
import sys
from pathlib import Path

MOST_UNSEEN = 0
ROW = re.compile(r'^PAL_FINDING(_IN_FILE)?\((PAL\d{4}), (\w+), ("(?:[^"\\]|\\.)*"), ("(?:[^"\\]|\\.)*")\)$')
NOTE = re.compile(r'^PAL_NOTE\((\w+), ("(?:[^"\\]|\\.)*")\)$')
CODE = re.compile(r"^PAL_DIAGNOSTIC\((PAL\d{4}), (?:error|warning|note), \"[^\"]+\"\)$")
OWN_TEXT = [(re.compile(r"\breport\(\s*Code::"), "reports a code; name a finding"),
            (re.compile(r"\b(?:finding|diagnostic|told)\w*(?:\.|->)(?:message|hint)\s*\+?=\s*[^=]*\""), "writes a text; the table has it"),
            (re.compile(r"\bnotes(?:\.|->)(?:push|emplace)_back\([^;]*\""), "writes a text; the table of notes has it"),
            (re.compile(r"\bDiagnostic\{"), "makes a finding; report it")]


def unquoted(literal):
    return literal[1:-1].replace('\\"', '"').replace("\\\\", "\\")


def read_rows(tables):
    """The rows as (code, name, text), notes without a code, and what is wrong with their order or form."""
    rows, wrong = [], []
    for table, text in tables:
        code = None
        for number, line in enumerate(text.splitlines(), 1):
            if heading := CODE.match(line):
                code = heading.group(1)
            elif row := ROW.match(line):
                in_file, of, name, message, hint = row.groups()
                if of != code:
                    wrong.append(f"{table}:{number}: {name} does not stand below {of}")
                if bool(in_file) != ('{\\"' in hint):
                    wrong.append(f"{table}:{number}: {name} says wrongly whom its hint is for")
                rows.append((of, name, unquoted(message)))
            elif note := NOTE.match(line):
                rows.append((None, note.group(1), unquoted(note.group(2))))
            elif not line.startswith("//"):
                wrong.append(f"{table}:{number}: is no row on one line")
    return rows, wrong


def own_texts(sources):
    return [f"{name}:{text.count(chr(10), 0, found.start()) + 1}: {what}"
            for name, text in sources for form, what in OWN_TEXT for found in form.finditer(text)]


def unused(rows, sources):
    named = {found for _, text in sources for found in re.findall(r"\b(Finding|Remark)::(\w+)", text)}
    return [f"{name} ({code or 'a note'}) is reported nowhere" for code, name, _ in rows
            if ("Finding" if code else "Remark", name) not in named]


def lines_with(part, text):
    """Each line of a text that has a part."""
    at = text.find(part)
    while at >= 0:
        begin, end = text.rfind("\n", 0, at) + 1, text.find("\n", at)
        yield text[begin:end if end >= 0 else len(text)]
        at = text.find(part, end) if end >= 0 else -1


def unseen(rows, expected):
    """The rows whose text is found nowhere, with anything on one line in the place of each placeholder."""
    result = []
    for code, name, text in rows:
        parts = re.split(r"\{[a-z_]+\}", text)
        form = re.compile(".*?".join(re.escape(part) for part in parts))
        if not any(form.search(line) for line in lines_with(max(parts, key=len), expected)):
            result.append(f"{code or 'note'} {name}: {text}")
    return result


def self_test():
    table = ('PAL_DIAGNOSTIC(PAL0101, error, "t")\nPAL_FINDING(PAL0102, a, "no {x}", "")\nPAL_FINDING(PAL0101, b, "gone",\n'
             'PAL_FINDING(PAL0101, c, "d", "write {\\"e\\"}")\nPAL_NOTE(here, "it is here")\n')
    rows, wrong = read_rows([("t.def", table)])
    assert wrong == ["t.def:2: a does not stand below PAL0102", "t.def:3: is no row on one line",
                     "t.def:4: c says wrongly whom its hint is for"], wrong
    assert rows.pop() == (None, "here", "it is here") and rows.pop()[1] == "c"
    assert unused([(None, "here", "")], [("s.cpp", "Finding::here")]) == ["here (a note) is reported nowhere"]
    source = [("s.cpp", "report(Finding::b);\nreport(Code::PAL0101, where);\nfinding.message = \"x\" + y;\n")]
    assert unused(rows, source) == ["a (PAL0102) is reported nowhere"]
    assert [each.split(": ")[0] for each in own_texts(source)] == ["s.cpp:2", "s.cpp:3"]
    assert unseen(rows, "error: no shoe") == [] and unseen(rows, "no\nshoe") == ["PAL0102 a: no {x}"]


def main():
    if "--self-test" in sys.argv:
        return self_test()
    root = Path(sys.argv[1])
    folders = [folder for folder in root.iterdir() if folder.is_dir() and folder.name not in ("build", ".git")]

    def read(suffixes, inside):
        return [(str(path.relative_to(root)), path.read_text(errors="replace"))
                for folder in folders for path in sorted(folder.rglob("*"))
                if path.suffix in suffixes and inside(path.relative_to(root)) and "node_modules" not in path.parts]

    rows, wrong = read_rows(read([".def"], lambda path: path.parts[1:3] == ("support", "findings")))
    is_test = lambda path: path.parts[0] == "tests"
    sources = read([".cpp", ".hpp"], lambda path: not is_test(path))
    wrong += own_texts(each for each in sources if not each[0].startswith("pal/support/")) + unused(rows, sources)
    tests = read([".expected", ".cpp", ".hpp", ".py"], is_test)
    expected = "\n".join(re.sub(r'"\n\s*"', "", text).replace('\\"', '"').replace("\\\\", "\\") for _, text in tests)
    missing = unseen(rows, expected)
    for each in missing:
        print("in no test:", each)
    for each in wrong:
        print(each)
    print(f"{len(rows)} findings and notes, {len(missing)} of which no test expects (at most {MOST_UNSEEN})")
    return 1 if wrong or len(missing) > MOST_UNSEEN else 0


if __name__ == "__main__":
    sys.exit(main())
