"""Writes a libFuzzer dictionary from the one place where the words stand.

Usage: make_dictionary.py pal grammar/PalLexer.g4 | make_dictionary.py dot pal/syntax/dot/vocabulary.cpp
"""
import re
import sys

DOT_WORDS = ["strict", "digraph", "subgraph", "graph", "node", "edge", "true", "TRUE", "FALSE", "->", "--", "{", "}",
             "[", "]", "=", ";", ",", ":", "+", '"', "\\\"", "<", ">", "/*", "*/", "//", "#", "rankdir", "label"]


def pal_words(text):
    """Keywords, which the grammar spells as fragments (`W T M ;`), and signs in quotes."""
    for match in re.finditer(r"^[A-Z_]+\s*:\s*((?:[A-Z]\s+)+);", text, re.M):
        yield "".join(match.group(1).split())
    for match in re.finditer(r"^[A-Z_]+\s*:\s*'([^']+)'\s*;", text, re.M):
        yield match.group(1)


def dot_words(text):
    """Attributes and kinds of the table, and the words of DOT itself."""
    yield from DOT_WORDS
    yield from sorted(set(re.findall(r'"(pal_\w+)"', text)))
    yield from re.findall(r'^\s*\{"(\w+)", \{', text, re.M)


def quoted(word):
    return '"' + word.replace("\\", "\\\\").replace('"', '\\"') + '"'


language, source = sys.argv[1:]
with open(source, encoding="utf-8") as file:
    words = list({"pal": pal_words, "dot": dot_words}[language](file.read()))
if len(words) < 40:
    sys.exit(f"only {len(words)} words in {source}: its form has changed")
print("\n".join(quoted(word) for word in words))
