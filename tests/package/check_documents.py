"""The documents of the Debian packages, unpacked beside each other: check_documents.py SOURCE PACKAGES PAL [WORKCELL PAGE].

Every relative link leads somewhere, and the manual page has each command, each of its options and each exit status that the program's help
has. So has PAGE, the manual page of WORKCELL, whose package is not made here. A manual page has no sign that man leaves out in the locale C.
"""
import gzip
import re
import subprocess
import sys
import tempfile
from pathlib import Path

source, packages, pal = Path(sys.argv[1]), Path(sys.argv[2]), sys.argv[3]


def helps(program, path=()):
    """The help of the program and of all its commands."""
    text = subprocess.run([program, *path, "--help"], check=True, capture_output=True, text=True).stdout
    yield path, text
    _, _, commands = text.partition("Subcommands:\n")
    for command in re.findall(r"^  (\S+)  ", commands, re.M):
        yield from helps(program, (*path, command))


def manual_lacks(program, page):
    told = ""
    for path, text in helps(program):
        told = told or text
        if path and f".SS {' '.join(path)}\n" not in page:
            yield f"the command {' '.join(path)}"
        for option in re.findall(r"^  (-\S+)", text, re.M) if path else ():
            if not option.startswith("-h,") and ".B " + option.replace("-", "\\-") not in page:
                yield f"{' '.join(path)} {option}"
    for status in re.findall(r"\b(\d) ", told.partition("Exit status:")[2]):
        if f".TP\n.B {status}\n" not in page:
            yield f"exit status {status}"
    for sign in set(re.findall(r"[^\x00-\x7f]", page)):
        yield f"a sign of ASCII in place of {sign}"


with tempfile.TemporaryDirectory() as folder:
    for package in packages.glob("*/*.deb"):
        subprocess.run(["dpkg-deb", "-x", package, folder], check=True)
    share = Path(folder) / "usr/share"
    documents = sorted((share / "doc/pal-tools").rglob("*.md"))
    links = subprocess.run([sys.executable, source / "tests/documents/check_links.py", share, *documents], capture_output=True, text=True)
    print(links.stdout, end="")
    pages = {pal: share / "man/man1/pal.1.gz"}
    if len(sys.argv) > 4:
        pages[sys.argv[4]] = Path(sys.argv[5])
    manuals = {program: gzip.decompress(page.read_bytes()).decode() for program, page in pages.items()}
    lacking = [f"{program}'s manual page lacks {what}" for program, manual in manuals.items() for what in manual_lacks(program, manual)]
    print("".join(f"{each}\n" for each in lacking), end="")
sys.exit(1 if links.returncode or lacking or len(documents) < 40 or any(len(manual) < 10_000 for manual in manuals.values()) else 0)
