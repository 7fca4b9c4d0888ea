"""Modules drawn as DOT."""
from an_input import N, an_input, file


def graph(body):
    return "digraph { pal_module=SM1; s [pal_kind=start]; e [pal_kind=end];\n" + body + "}\n"


@an_input
def dot_subgraphs(folder):
    """a hundred thousand subgraphs inside each other"""
    return [file(folder, graph("{" * N + "}" * N), "a.dot")], 1, ["PAL0114"]


@an_input
def dot_html(folder):
    """a hundred thousand '<' inside each other"""
    return [file(folder, graph("s [label=" + "<" * N + ">" * N + "] s -> e"), "a.dot")], 0, []


@an_input
def dot_nested(folder):
    """ten thousand loops inside each other, drawn"""
    n = N // 10
    nodes = "".join(f"r{i} [pal_kind=repeat] u{i} [pal_kind=until]\n" for i in range(n))
    ways = "s" + "".join(f" -> r{i}" for i in range(n)) + "".join(f" -> u{i}" for i in reversed(range(n)))
    return [file(folder, graph(nodes + ways), "a.dot")], 1, ["PAL0105"]


@an_input
def dot_line(folder):
    """a drawing with a line of 100 MB"""
    return [file(folder, b"//" + b"x" * (100 << 20), "a.dot")], 2, ["PAL0111"]


@an_input
def dot_comment(folder):
    """a comment of a megabyte without its end, drawn"""
    return [file(folder, "/*" + "x" * (1 << 20), "a.dot")], 1, ["PAL0114"]


@an_input
def dot_name(folder):
    """a node's name of a megabyte"""
    name = "x" * (1 << 20)
    return [file(folder, graph(f"{name} [pal_kind=perform pal_activity={name}] s -> {name} -> e"), "a.dot")], 0, []


@an_input
def dot_attribute(folder):
    """an attribute's name and a kind of a megabyte"""
    return [file(folder, graph(f'n [pal_{"x" * (1 << 20)}=1 pal_kind={"x" * (1 << 20)}] s -> n -> e'), "a.dot")], 1, ["PAL0115"]


@an_input
def dot_number(folder):
    """a number of a megabyte in a drawing"""
    return [file(folder, graph(f"n [pal_kind=complete pal_code={'9' * (1 << 20)}] s -> n -> e"), "a.dot")], 1, ["PAL0115"]


@an_input
def dot_edges(folder):
    """a million edges in two lines"""
    some = " ".join(f"n{i}" for i in range(1000))
    return [file(folder, graph(f"{{ {some} }} -> {{ {some} }}"), "a.dot")], 1, ["PAL0114"]


@an_input
def dot_nodes(folder):
    """two hundred thousand nodes"""
    return [file(folder, graph("".join(f"n{i};" for i in range(2 * N))), "a.dot")], 1, ["PAL0114"]


@an_input
def dot_statements(folder):
    """fifty thousand statements, drawn"""
    n = N // 2
    nodes = "".join(f"n{i} [pal_kind=nothing]\n" for i in range(n))
    return [file(folder, graph(nodes + "s" + "".join(f" -> n{i}" for i in range(n)) + " -> e"), "a.dot")], 0, []


@an_input
def dot_defaults(folder):
    """a default of a megabyte, given a hundred thousand times"""
    text = f'node [pal_message="{"x" * (1 << 20)}"];' + "node [pal_kind=nothing]\n" * N
    return [file(folder, graph(text + "".join(f"n{i} -> " for i in range(N // 10)) + "e"), "a.dot")], 1, ["PAL0116"]


@an_input
def dot_guard(folder):
    """a guard of a hundred thousand parentheses, drawn"""
    guard = "(" * N + "c" + ")" * N
    return [file(folder, graph(f's -> r -> u -> r u -> e r [pal_kind=repeat] u [pal_kind=until pal_guard="{guard}"]'),
                 "a.dot")], 1, ["PAL0115"]


@an_input
def dot_no_utf8(folder):
    """bytes that are no UTF-8 in a drawing"""
    return [file(folder, b"digraph { \xff }", "a.dot")], 1, ["PAL0112"]


@an_input
def dot_empty(folder):
    """an empty drawing"""
    return [file(folder, "", "a.dot")], 1, ["PAL0114"]
