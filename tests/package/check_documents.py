"""The documents of the Debian packages, unpacked beside each other: check_documents.py SOURCE PACKAGES PAL.

Every relative link leads somewhere, no page speaks of a build folder that a reader does not have, and the manual page has each command,
each of its options and each exit status that the program's help has.
"""
import gzip
import re
import subprocess
import sys
import tempfile
from pathlib import Path

source, packages, pal = Path(sys.argv[1]), Path(sys.argv[2]), sys.argv[3]


def helps(path=()):
    """The help of the program and of all its commands."""
    text = subprocess.run([pal, *path, "--help"], check=True, capture_output=True, text=True).stdout
    yield path, text
    _, _, commands = text.partition("Subcommands:\n")
    for command in re.findall(r"^  (\S+)  ", commands, re.M):
        yield from helps((*path, command))


def manual_lacks(page):
    for path, text in helps():
        if path and f".SS {' '.join(path)}\n" not in page:
            yield f"the command {' '.join(path)}"
        for option in re.findall(r"^  (-\S+)", text, re.M) if path else ():
            if not option.startswith("-h,") and ".B " + option.replace("-", "\\-") not in page:
                yield f"{' '.join(path)} {option}"
    for status in "0123":
        if f".TP\n.B {status}\n" not in page:
            yield f"exit status {status}"


with tempfile.TemporaryDirectory() as folder:
    for package in packages.glob("*/*.deb"):
        subprocess.run(["dpkg-deb", "-x", package, folder], check=True)
    share = Path(folder) / "usr/share"
    documents = sorted((share / "doc/pal-tools").rglob("*.md"))
    links = subprocess.run([sys.executable, source / "tests/documents/check_links.py", share, *documents], capture_output=True, text=True)
    print(links.stdout, end="")
    manual = gzip.decompress((share / "man/man1/pal.1.gz").read_bytes()).decode()
    lacking = list(manual_lacks(manual))
    print("".join(f"the manual page lacks {what}\n" for what in lacking), end="")
sys.exit(1 if links.returncode or lacking or len(documents) < 40 or len(manual) < 10_000 else 0)
