#!/usr/bin/env python3
"""Looks that each test that a table names exists: check_guarantees.py ROOT PAGE

A row of the table "fault | what happens | test" names its test by title and file: "title" in `path`. Prints a line for each
row whose test is not there, and how many rows there are; ends with 1 if one is missing or the table has no rows.
"""
import re
import sys
from pathlib import Path


def titles(path):
    """The titles of a file's tests; a title that is broken over lines is one."""
    text = re.sub(r'"\s*\n\s*"', "", path.read_text(encoding="utf-8"))
    return set(re.findall(r'TEST_CASE\(\s*"((?:[^"\\]|\\.)*)"', text))


def main():
    root, page = Path(sys.argv[1]), Path(sys.argv[2])
    rows = 0
    missing = 0
    in_table = False
    for number, line in enumerate(page.read_text(encoding="utf-8").splitlines(), 1):
        if line.startswith("| fault |"):
            in_table = True
            continue
        in_table = in_table and line.startswith("|")
        if not in_table or line.startswith("| ---"):
            continue
        rows += 1
        named = re.search(r'"([^"]+)" in `([^`]+)` \|$', line)
        if not named:
            problem = "names no test"
        elif not (root / named[2]).is_file():
            problem = f"{named[2]} does not exist"
        elif named[1] not in titles(root / named[2]):
            problem = f'{named[2]} has no test "{named[1]}"'
        else:
            continue
        missing += 1
        print(f"{page.name}:{number}: {problem}")
    print(f"{rows} rows")
    return 1 if missing or rows == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
