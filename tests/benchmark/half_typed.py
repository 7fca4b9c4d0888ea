"""What is said of a line while it is typed: half_typed.py PAL SOURCE_DIR [EVERY].

Each line of the shipped skills is cut behind each of its words; what follows the line stays. A state that has no error is complete,
and is left out. Of the others, every EVERYth: the share with exactly one error, with no error on the typed line, and with a rest
that was not read (PAL0104). The status is 1 unless at least 97 % have exactly one, at most 3 % have none on the typed line, and all is read.
"""
import json
import pathlib
import re
import subprocess
import sys
import tempfile


def states(text):
    lines = text.split("\n")
    for number, line in enumerate(lines):
        if line.lstrip().startswith("#"):
            continue
        words = [found.end() for found in re.finditer(r"\S+", line.split(" #")[0])]
        for end in words[:-1]:
            yield number + 1, "\n".join(lines[:number] + [line[:end]] + lines[number + 1:])


def findings(pal, path):
    done = subprocess.run([pal, "check", path, "--without-times", "--format", "json", "--max-errors", "0"], capture_output=True, text=True)
    return [each for each in json.loads(done.stdout)["diagnostics"] if each["severity"] == "error"]


def main(pal, source, every="20"):
    seen = one = elsewhere = unread = 0
    source = pathlib.Path(source)
    with tempfile.TemporaryDirectory() as folder:
        for file in source.glob("skills_pal/*/*.pal"):
            copy = pathlib.Path(folder) / file.parent.name / file.name
            copy.parent.mkdir(exist_ok=True)
            copy.write_text(file.read_text())
        all_states = [(file, *state) for file in sorted(pathlib.Path(folder).glob("*/*.pal")) for state in states(file.read_text())]
        for file, line, text in all_states[::int(every)]:
            typed = file.with_name("typed.pal")
            typed.write_text(text)
            errors = findings(pal, str(typed))
            typed.unlink()
            if not errors:
                continue
            seen += 1
            one += len(errors) == 1
            unread += any(each["code"] == "PAL0104" for each in errors)
            elsewhere += not any(each["line"] == line and pathlib.Path(each["file"]).name == typed.name for each in errors)
    print(f"{seen} states: exactly one error {100 * one / seen:.1f} %, none on the typed line {100 * elsewhere / seen:.1f} %, "
          f"rest unread {100 * unread / seen:.1f} %")
    return 100 * one >= 97 * seen and 100 * elsewhere <= 3 * seen and unread == 0


sys.exit(0 if main(*sys.argv[1:]) else 1)
