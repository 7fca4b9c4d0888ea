"""Links of the documents: every relative link and every path docs/… that is mentioned leads somewhere.

    check_links.py ROOT [FILE…]

Without FILE: all Markdown below ROOT, and all mentions of docs/….md in any text below it. With FILE: only these documents.
Pages that guide through the source (GUIDES) also name its files between backticks, alone or with a folder: each exists.
A link `#heading` must be a heading of the document that it leads to. Prints one line for each that does not, and ends with 1.
"""
import os
import re
import sys
from pathlib import Path
from urllib.parse import unquote

LINK = re.compile(r"\]\((?:<([^>]+)>|([^)\s]+))\)")
SOURCE = re.compile(r"`([\w/*.-]+\.(?:cpp|hpp|g4|def|css|json|pal|py|ts|tsx))`")
GUIDES = {"docs/architecture.md", "CONTRIBUTING.md"}
MENTION = re.compile(r"(?<![\w/.-])docs/[\w./-]+\.md\b")
SKIPPED_FOLDERS = {".git", "build", "out", "broken", "node_modules"}
TEXTS = {".md", ".cpp", ".hpp", ".txt", ".cmake", ".py", ".pal", ".g4", ".in", ".def", ""}


def lines_outside_fences(path):
    fenced = False
    for number, line in enumerate(path.read_text(encoding="utf-8").split("\n"), 1):
        if line.lstrip().startswith("```"):
            fenced = not fenced
        elif not fenced:
            yield number, line


def headings(path):
    """The anchors that GitHub and GitLab give to a document's headings."""
    anchors = {}
    for _, line in lines_outside_fences(path):
        if not re.match(r"#{1,6} ", line):
            continue
        text = re.sub(r"\[([^\]]*)\]\([^)]*\)", r"\1", line.lstrip("#").strip()).lower()
        anchor = re.sub(r"[^\w\- ]", "", text).replace(" ", "-")
        again = anchors.get(anchor, 0)
        anchors[anchor] = again + 1
        yield anchor if again == 0 else f"{anchor}-{again}"


def wrong_links(path):
    for number, line in lines_outside_fences(path):
        for match in LINK.finditer(re.sub(r"`[^`]*`", "code", line)):
            link = match.group(1) or match.group(2)
            if re.match(r"[a-z]+:", link):
                continue
            file, _, anchor = link.partition("#")
            target = path.parent / unquote(file) if file else path
            if not target.exists():
                yield number, f"{link} does not exist"
            elif anchor and target.suffix == ".md" and anchor not in set(headings(target)):
                yield number, f"{link}: no such heading"


def files_below(root, everything=False):
    for folder, folders, names in os.walk(root):
        folders[:] = sorted(name for name in folders if name not in SKIPPED_FOLDERS)
        for name in sorted(names):
            path = Path(folder) / name
            if (everything or path.suffix in TEXTS) and not path.is_symlink():
                yield path


def wrong_mentions(root, path):
    try:
        text = path.read_text(encoding="utf-8")
    except UnicodeDecodeError:
        return
    for number, line in enumerate(text.split("\n"), 1):
        for mention in MENTION.findall(line):
            if not (root / mention).exists():
                yield number, f"{mention} does not exist"


def wrong_sources(root, path):
    names = {each.name for each in files_below(root, everything=True)}
    for number, line in lines_outside_fences(path):
        for file in SOURCE.findall(line):
            places = [file, "**/" + file] if "/" in file or "*" in file else []
            if file not in names and not any(found for place in places for found in root.glob(place)):
                yield number, f"there is no file {file}"


def main(root, documents):
    root = Path(root)
    wrong = []
    links = 0
    for path in [Path(name) for name in documents] or list(files_below(root)):
        found = []
        # Expected outputs are no documents; the pages of the findings are checked where they stand, in diagnostics.md.
        if path.suffix == ".md" and (documents or not {"golden", "unit", "pages"} & set(path.relative_to(root).parts)):
            links += 1
            found += wrong_links(path)
            if path.resolve().relative_to(root.resolve()).as_posix() in GUIDES or path.name == "guide.md":
                found += wrong_sources(root, path)
        if not documents:
            found += wrong_mentions(root, path)
        wrong += [f"{path}:{number}: {what}" for number, what in found]
    print("\n".join(wrong) if wrong else f"the links of {links} documents lead somewhere")
    return 1 if wrong or links == 0 else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1], sys.argv[2:]))
