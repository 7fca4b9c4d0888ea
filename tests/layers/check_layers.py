"""Checks the order of the libraries: what each includes, its namespace, and where third parties' types are shown.

Usage: check_layers.py SOURCE_DIR | --self-test. Exit status 1 and one line a break.
"""
import pathlib
import re
import sys

# The proof, from the bottom up: each part may use those before it.
PROOF = ["problem", "machine", "slice", "zones", "runs", "verdict", "load", "exact",
         "compositional/causes", "compositional/times", "compositional/measures", "compositional"]
MODEL = ["pal/support", "pal/pan", "trace"]
PARTS = [f"analyzer/{part}" for part in PROOF]
# The runtime, likewise. Other libraries see what it installs, and its drivers.
KERNEL = ["runtime/include", "runtime/plugin", "runtime/watch", "runtime/kernel", "runtime/executives", "runtime"]
RUNTIME = ["runtime/include", "trace"]
PROTOCOLS = ["runtime/drivers/val/protocol.hpp", "runtime/drivers/alter/protocol.hpp"]
COMPILER = ["pal/support", "pal/explain", "pal/doc", "pal/pan", "pal/syntax", "pal/rewrite", "pal/check", "analyzer", "analyzer/chart",
            "analyzer/run_checker", "analyzer/whatif", *PARTS, "codegen", "operations", "language_server", "study", "trace"]
# Each program: a room may use those before it.
ROOMS = {"pal": ["session", "reports", "studies", "commands", "options"], "workcell": ["session", "reports", "options", "commands"]}


def rooms(program, uses):
    names = [f"programs/{program}/{room}" for room in ROOMS[program]]
    return {**{name: names[:i] + uses for i, name in enumerate(names)}, f"programs/{program}": names + ["pal/support"]}


# The longest prefix names the layer of a file; its list is what it may include besides itself.
LAYERS = {
    "trace": [],
    "pal/support": [],
    "pal/units": [],
    "pal/explain": ["pal/support"],
    "pal/pan": ["pal/support"],
    "pal/doc": ["pal/support", "pal/pan"],
    "grammar": [],
    "pal/syntax": ["pal/support", "pal/units", "pal/pan", "grammar"],
    "pal/rewrite": ["pal/support", "pal/pan", "pal/syntax"],
    "pal/check": ["pal/support", "pal/units", "pal/pan", "pal/syntax"],
    "analyzer/chart": ["pal/support", "trace"],
    **{part: PARTS[:i] + MODEL for i, part in enumerate(PARTS)},
    "analyzer": PARTS + MODEL,
    "analyzer/whatif": ["analyzer"] + PARTS + MODEL,
    "analyzer/run_checker": ["analyzer/problem"] + MODEL,  # of the analysis nothing
    "codegen": ["pal/support", "pal/pan"],
    "operations": ["pal/support", "pal/pan"],  # neither robots nor simulators: it asks a SkillRunner
    "server": ["operations", "pal/explain", "pal/support", "pal/pan"],  # likewise
    "language_server": ["pal/support", "pal/pan", "pal/doc", "pal/explain", "pal/syntax", "pal/rewrite", "pal/check", "operations"],  # proofs come from the program
    "study": ["pal/support", "pal/pan", "analyzer", "analyzer/whatif", "analyzer/chart"] + PARTS + ["trace"],
    **rooms("pal", COMPILER),
    **{room: KERNEL[:i] + ["trace"] for i, room in enumerate(KERNEL)},
    **{protocol: RUNTIME for protocol in PROTOCOLS},
    "runtime/drivers": KERNEL + ["trace"] + PROTOCOLS,
    "skills_pal": RUNTIME + PROTOCOLS,  # VAL's verbs and errors, ALTER's period
    "sim": RUNTIME + ["runtime/drivers"] + PROTOCOLS,
    **rooms("workcell", COMPILER + RUNTIME + [f"programs/pal/{room}" for room in ROOMS["pal"]] + ["sim", "runtime/drivers", "runtime/watch", "skills_pal", "server"] + PROTOCOLS),
}
# The namespace of a file is that of the longest prefix here. Folders that are not named add none.
NAMESPACES = {
    "trace": "pal::trace",
    "pal/support": "pal",  # the ground: all that stands on it uses its names as they are
    **{f"pal/{folder}": f"pal::{folder}" for folder in ["units", "explain", "pan", "doc", "syntax", "rewrite", "check"]},
    **{f"pal/check/{folder}": f"pal::check::{folder}" for folder in ["conditions", "deadlock"]},
    "analyzer": "pal::analyzer",
    **{f"analyzer/{folder}": f"pal::analyzer::{folder}" for folder in ["compositional", "run_checker", "whatif", "chart"]},
    "codegen": "pal::codegen",
    "operations": "pal::operations",
    "server": "pal::server",
    "language_server": "pal::language_server",
    "study": "pal::study",
    "runtime": "pal::runtime",
    "runtime/drivers": "pal::runtime::drivers",
    **{f"runtime/drivers/{device}": f"pal::runtime::drivers::{device}" for device in ["alter", "force_torque", "gripper", "range_finder", "val"]},
    "skills_pal": "pal::skills",
    "skills_pal/sensing": "pal::skills::sensing",
    "sim": "pal::sim",
    "sim/val": "pal::sim::val",
    "programs/pal": "pal::program",
    "programs/workcell": "pal::workcell",
}
THIRD_PARTY = re.compile(r"^(antlr4-runtime|graphviz|mujoco|EGL|GL|cairo|nlohmann|CLI|boost|openssl|toml\+\+)/|^(cgraph|gvc|png)\.h")
INCLUDE = re.compile(r'^\s*#\s*include\s+["<]([^">]+)[">]', re.M)
PERIOD = re.compile(r"milliseconds\(28\)|\b28ms\b|\b0\.028\b|/ 28\b|[pP]eriod = 28\b|within\(0, 28\)")
NAMESPACE = re.compile(r"^namespace ([\w:]+) \{", re.M)


def longest_prefix(path, table):
    fitting = [name for name in table if path == name or path.startswith(name + "/")]
    return max(fitting, key=len) if fitting else None


def place(include):
    """The file that an include names: the headers of runtime/include and trace/include are named as they are installed."""
    for library in ["runtime", "trace"]:
        if include.startswith(f"pal/{library}/"):
            return f"{library}/include/{include}"
    return include


def layer(path):
    name = longest_prefix(path, LAYERS)
    return "trace" if name is None and path.startswith("trace/") else name


def breaks(path, text, third_party=()):
    """The includes of the file `path` with content `text` that it must not have, and a namespace that is not its folder's.

    `third_party`: headers of the project that show a third party's types. Only their own library may include them.
    """
    own = layer(path)
    if own is None:
        return
    for include in map(place, INCLUDE.findall(text)):
        other = layer(include)
        if other is not None and other != own and other not in LAYERS[own]:
            yield f"{path}: {own} must not use {other} (includes {include})"
        if include in third_party and other != own:
            yield f"{path}: {include} shows a third party's types; only its own library may include it"
    if path.startswith(("programs/", "runtime/", "server/", "sim/", "skills_pal/")) and not path.startswith("runtime/drivers/alter/"):
        for period in PERIOD.findall(text):
            yield f"{path}: '{period}' is ALTER's period, which stands in runtime/drivers/alter/protocol.hpp alone"
    expected = NAMESPACES.get(longest_prefix(path, NAMESPACES))
    for namespace in NAMESPACE.findall(text):
        if namespace.startswith("pal") and expected and not (namespace == expected or namespace.startswith(expected + "::")):
            if not (expected.startswith("pal::runtime::drivers::") and namespace == "pal::runtime::drivers"):
                yield f"{path}: namespace {namespace}, expected {expected}"


def self_test():
    assert list(breaks("runtime/kernel/mail.cpp", '#include "pal/pan/graph.hpp"\n'))
    assert list(breaks("runtime/kernel/mail.cpp", '#include "runtime/executives/scheduler.hpp"\n'))
    assert list(breaks("runtime/include/pal/runtime/task.hpp", '#include "runtime/kernel/mail.hpp"\n'))
    assert list(breaks("codegen/plan.cpp", '#include "pal/runtime/skill.hpp"\n'))
    assert list(breaks("analyzer/problem/compile.cpp", '#include "analyzer/zones/dbm.hpp"\n'))
    assert list(breaks("analyzer/compositional/times/slots.cpp", '#include "analyzer/compositional/measures/sum.hpp"\n'))
    assert list(breaks("analyzer/run_checker/referee.cpp", '#include "analyzer/machine/machine.hpp"\n'))
    assert list(breaks("programs/pal/reports/junit.cpp", '#include "programs/pal/commands/commands.hpp"\n'))
    assert list(breaks("programs/workcell/session/session.cpp", '#include "sim/model/compiled.hpp"\n', {"sim/model/compiled.hpp"}))
    assert list(breaks("sim/cell/cell.cpp", "namespace pal::workcell {\n"))
    assert list(breaks("sim/workcell.hpp", "constexpr runtime::Time alter_period = std::chrono::milliseconds(28);\n"))
    assert not list(breaks("runtime/drivers/alter/protocol.hpp", "constexpr Time period = std::chrono::milliseconds(28);\n"))
    assert not list(breaks("sim/model/mjcf.cpp", '#include "sim/model/compiled.hpp"\n', {"sim/model/compiled.hpp"}))
    assert not list(breaks("sim/val/store.cpp", "namespace pal::sim::val {\nnamespace {\n"))
    assert not list(breaks("runtime/kernel/mail.cpp", '#include "pal/trace/trace.hpp"\n#include "pal/runtime/device.hpp"\n'))
    assert not list(breaks("analyzer/exact/exact.cpp", '#include "pal/pan/graph.hpp"\n#include <vector>\n'))


def main(argument):
    if argument == "--self-test":
        self_test()
        return 0
    root = pathlib.Path(argument)
    texts = {}
    for name in sorted({name.split("/")[0] for name in LAYERS}):
        for file in sorted((root / name).rglob("*")):
            if file.suffix in {".cpp", ".hpp"}:
                texts[file.relative_to(root).as_posix()] = file.read_text(encoding="utf-8")
    third_party = {path for path, text in texts.items()
                   if path.endswith(".hpp") and any(THIRD_PARTY.search(include) for include in INCLUDE.findall(text))}
    found = [each for path, text in texts.items() for each in breaks(path, text, third_party)]
    print("\n".join(found) or "every include follows the order")
    return 1 if found else 0


sys.exit(main(sys.argv[1]))
