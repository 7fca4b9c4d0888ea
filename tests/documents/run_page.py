"""Follows a page as a reader would: saves its files, makes its changes, types its commands, and compares what they print.

    run_page.py PAGE FOLDER [--build PREFIX] [--with EXAMPLE]

FOLDER is emptied first; with EXAMPLE it begins with the files of that folder. `pal` is found on PATH. The page's fences say what is done, in their order:

    ```LANGUAGE file=NAME    the file NAME
    ```diff file=NAME        a change in NAME: lines that begin with - (or a blank) stand there once, + (or a blank) afterwards
    ```console               commands behind `$ `, each with all that it prints; a line `…` stands for any lines
    ```console build         the same, only with --build, where PREFIX has an installed pal

Ends with 1 at the first command that prints something else.
"""
import argparse
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path


def fences(text):
    for match in re.finditer(r"^```(\S+)[ ]*(.*)\n((?:(?!```).*\n)*)```$", text, re.MULTILINE):
        yield match.group(1), match.group(2), match.group(3)


def change(path, diff):
    lines = diff.splitlines()
    old = "".join(line[1:] + "\n" for line in lines if line[:1] in "- ")
    new = "".join(line[1:] + "\n" for line in lines if line[:1] in "+ ")
    text = path.read_text(encoding="utf-8")
    if text.count(old) != 1:
        sys.exit(f"{path}: the page changes what stands there {text.count(old)} times:\n{old}")
    path.write_text(text.replace(old, new), encoding="utf-8")


def commands(text):
    found = []
    for line in text.splitlines():
        if line.startswith("$ "):
            found.append((line[2:], []))
        elif not found:
            sys.exit(f"a console that does not begin with a command: {line}")
        else:
            found[-1][1].append(line.rstrip())
    return found


def matches(expected, printed):
    if not expected:
        return not printed
    if expected[0] == "…":
        return any(matches(expected[1:], printed[at:]) for at in range(len(printed) + 1))
    return bool(printed) and expected[0] == printed[0] and matches(expected[1:], printed[1:])


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("page", type=Path)
    arguments.add_argument("folder", type=Path)
    arguments.add_argument("--build", type=Path)
    arguments.add_argument("--with", type=Path, dest="example")
    options = arguments.parse_args()
    shutil.rmtree(options.folder, ignore_errors=True)
    if options.example:
        shutil.copytree(options.example, options.folder)
    else:
        options.folder.mkdir(parents=True)
    environment = dict(os.environ)
    if options.build:
        environment["CMAKE_PREFIX_PATH"] = str(options.build)
    run = 0
    for language, words, text in fences(options.page.read_text(encoding="utf-8")):
        name = re.search(r"file=(\S+)", words)
        if language == "diff" and name:
            change(options.folder / name.group(1), text)
        elif name:
            (options.folder / name.group(1)).write_text(text, encoding="utf-8")
        elif language == "console" and ("build" not in words.split() or options.build):
            for command, expected in commands(text):
                done = subprocess.run(command, shell=True, cwd=options.folder, env=environment, text=True, timeout=300,
                                      stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
                printed = [line.rstrip() for line in done.stdout.splitlines()]
                run += 1
                if not matches(expected, printed):
                    print(f"$ {command}\nthe page says:\n" + "\n".join(expected) + "\nit prints:\n" + "\n".join(printed))
                    return 1
    print(f"{run} commands print what the page says")
    return 0 if run else 1


if __name__ == "__main__":
    sys.exit(main())
