"""Checks that each file includes, directly or by way of what it includes, the header of each project type that it names.

The release preset compiles several files as one, which hides a missing include. Only types whose name is declared
once in the whole project are looked for, so nothing is reported wrongly.

Usage: check_includes.py SOURCE_DIR | --self-test. Exit status 1 and one line a missing include.
"""
import collections
import pathlib
import re
import sys

FOLDERS = ["trace", "pal", "analyzer", "codegen", "operations", "server", "language_server", "runtime", "skills_pal", "sim", "programs", "tests"]
NOT_CODE = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\((?:.*?)\)\1"|"(?:\\.|[^"\\\n])*"', re.S)
INCLUDE = re.compile(r'^\s*#\s*include\s+"([^"]+)"', re.M)
# At the beginning of a line: of a namespace.
DEFINED = re.compile(r"^(?:(?:class|struct|enum class|enum)\s+([A-Z]\w+)\b(?!::)[^;{(]*\{|using\s+([A-Z]\w+)\s*=)", re.M)
DECLARED = re.compile(r"\b(?:class|struct|enum|using|typename|concept)\s+([A-Z]\w+)\b(?!::)")
NAME = re.compile(r"\b[A-Z]\w+\b")


def own_names(match):
    return next(name for name in match if name)


def missing(texts):
    """Of the files `texts`, by path: pairs of a file and the header that it does not reach."""
    code = {path: NOT_CODE.sub(" ", text) for path, text in texts.items()}
    places = collections.defaultdict(set)
    for path, text in code.items():
        for name in DECLARED.findall(text):
            places[name].add(path)
    home = {}
    for path, text in code.items():
        if path.endswith(".hpp"):
            home.update({name: path for name in map(own_names, DEFINED.findall(text)) if len(places[name]) == 1})
    includes = {path: [each for each in map(real_path, INCLUDE.findall(text)) if each in texts] for path, text in texts.items()}
    for path, text in code.items():
        if includes_generated(path, texts):
            continue
        reached = closure(path, includes)
        for name in sorted(set(NAME.findall(text))):
            if name in home and home[name] not in reached:
                yield f"{path}: names {name} and does not include {home[name]}"


def includes_generated(path, texts):
    """Its names may be of a header that only the build has."""
    local = path.rpartition("/")[0]
    return any(real_path(each) not in texts and f"{local}/{each}" not in texts for each in INCLUDE.findall(texts[path]))


def real_path(include):
    """The headers of runtime/include and trace/include are named as they are installed."""
    for library in ["runtime", "trace"]:
        if include.startswith(f"pal/{library}/"):
            return f"{library}/include/{include}"
    return include


def closure(path, includes):
    reached, open_ones = {path}, [path]
    while open_ones:
        for each in includes[open_ones.pop()]:
            if each not in reached:
                reached.add(each)
                open_ones.append(each)
    return reached


def self_test():
    header = {"pal/a.hpp": "struct Alpha {\n};\n", "pal/b.hpp": '#include "pal/a.hpp"\nusing Beta = Alpha;\n'}
    assert not list(missing(header))
    assert list(missing({**header, "pal/c.cpp": "Alpha a;\n"}))
    assert not list(missing({**header, "pal/c.cpp": '#include "pal/b.hpp"\nAlpha a;  // and Beta\n'}))
    assert not list(missing({**header, "pal/c.cpp": 'auto text = "Alpha";\n'}))
    assert not list(missing({**header, "pal/c.cpp": "class Alpha;\nAlpha* a;\n"}))
    assert not list(missing({**header, "pal/c.cpp": '#include "generated.hpp"\nAlpha a;\n'}))


def main(argument):
    if argument == "--self-test":
        self_test()
        return 0
    root = pathlib.Path(argument)
    files = (file for folder in FOLDERS for file in (root / folder).rglob("*") if file.suffix in {".cpp", ".hpp"})
    found = list(missing({file.relative_to(root).as_posix(): file.read_text(encoding="utf-8") for file in files}))
    print("\n".join(found) or "every type that is named is included")
    return 1 if found else 0


sys.exit(main(sys.argv[1]))
