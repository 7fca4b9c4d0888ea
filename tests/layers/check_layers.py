"""Checks that each library includes only what stands left of it, and that no public header shows a third party's types.

Usage: check_layers.py SOURCE_DIR | --self-test. Exit status 1 and one line a break.
"""
import pathlib
import re
import sys

# The proof, from the bottom up: each stage may use those before it.
BOUNDS = [f"compositional/{stage}" for stage in ["causes", "times", "measures"]]
PROOF = ["problem", "machine", "slice", "zones", "runs", "verdict", "load", "exact", "compositional/saturating.hpp", *BOUNDS, "compositional"]
MODEL = ["pal/support", "pal/pan", "runtime/trace"]
STAGES = [f"analyzer/{stage}" for stage in PROOF]

# Longest matching prefix names the layer of a file; its list is what it may include besides itself.
LAYERS = {
    "runtime/trace": [],
    "pal/support": [],
    "pal/units": [],
    "pal/explain": ["pal/support"],
    "pal/pan": ["pal/support"],
    "pal/doc": ["pal/support", "pal/pan"],
    "grammar": [],
    "pal/syntax": ["pal/support", "pal/units", "pal/pan", "grammar"],
    "pal/rewrite": ["pal/support", "pal/pan", "pal/syntax"],
    "pal/check": ["pal/support", "pal/units", "pal/pan", "pal/syntax"],
    "analyzer/chart": ["pal/support", "runtime/trace"],
    **{stage: STAGES[:i] + MODEL for i, stage in enumerate(STAGES)},
    "analyzer": STAGES + MODEL,
    "analyzer/whatif": ["analyzer"] + STAGES + MODEL,
    "analyzer/run_checker": ["analyzer/problem"] + MODEL,  # of the analysis nothing
    "codegen": ["pal/support", "pal/pan"],
    "operations": ["pal/support", "pal/pan"],  # neither robots nor simulators: it asks a SkillRunner
    "runtime_system": ["operations", "pal/support", "pal/pan"],  # likewise
    "pal/driver": ["pal/support", "pal/explain", "pal/doc", "pal/pan", "pal/syntax", "pal/rewrite", "pal/check", "analyzer", "analyzer/chart",
                   "analyzer/run_checker", "analyzer/whatif", *STAGES, "codegen", "operations", "runtime/trace"],
    "pal/program": ["pal/driver", "pal/support"],
    "runtime": ["runtime/trace"],
    "runtime/drivers/val/command.hpp": ["runtime", "runtime/trace"],
    "runtime/drivers": ["runtime", "runtime/trace", "runtime/drivers/val/command.hpp"],
    "skills_pal": ["runtime", "runtime/trace", "runtime/drivers/val/command.hpp"],  # VAL's verbs and errors
    "sim": ["runtime", "runtime/trace", "runtime/drivers", "runtime/drivers/val/command.hpp"],
    "sim/program": ["sim", "runtime", "runtime/trace", "runtime/drivers", "skills_pal", "pal/support", "pal/pan",
                    "pal/check", "pal/syntax", "analyzer", *STAGES, "analyzer/chart", "pal/driver", "operations",
                    "runtime_system"],
}
# Third-party headers that must stay inside .cpp files.
PRIVATE = re.compile(r"^(antlr4-runtime|graphviz|mujoco|EGL|GL|cairo|nlohmann|CLI|boost)/|^(cgraph|gvc|png)\.h")
INCLUDE = re.compile(r'^\s*#\s*include\s+["<]([^">]+)[">]', re.M)


def layer(path):
    fitting = [name for name in LAYERS if path == name or path.startswith(name + "/")]
    return max(fitting, key=len) if fitting else None


def breaks(path, text):
    """The includes of the file `path` with content `text` that it must not have."""
    own = layer(path)
    if own is None:
        return
    for include in INCLUDE.findall(text):
        other = layer(include.removeprefix("pal/") if include.startswith("pal/runtime/") else include)
        if other is not None and other != own and other not in LAYERS[own]:
            yield f"{path}: {own} must not use {other} (includes {include})"
        if path.endswith(".hpp") and PRIVATE.search(include) and "/private/" not in path:
            yield f"{path}: {include} must stay inside a .cpp file"


def self_test():
    assert list(breaks("runtime/task.cpp", '#include "pal/pan/graph.hpp"\n'))
    assert list(breaks("codegen/plan.cpp", '#include "pal/runtime/skill.hpp"\n'))  # a public name of runtime/skill.hpp
    assert list(breaks("codegen/plan.cpp", '#include "analyzer/problem/problem.hpp"\n'))
    assert list(breaks("sim/model.hpp", "#include <mujoco/mujoco.h>\n"))
    assert list(breaks("analyzer/problem/compile.cpp", '#include "analyzer/zones/dbm.hpp"\n'))
    assert list(breaks("analyzer/compositional/times/slots.cpp", '#include "analyzer/compositional/measures/sum.hpp"\n'))
    assert list(breaks("analyzer/run_checker/referee.cpp", '#include "analyzer/machine/machine.hpp"\n'))
    assert not list(breaks("analyzer/exact/exact.cpp", '#include "pal/pan/graph.hpp"\n#include <vector>\n'))


def main(argument):
    if argument == "--self-test":
        self_test()
        return 0
    root = pathlib.Path(argument)
    found = []
    for name in sorted({name.split("/")[0] for name in LAYERS}):
        for file in sorted((root / name).rglob("*")):
            if file.suffix in {".cpp", ".hpp"}:
                path = file.relative_to(root).as_posix()
                found += breaks(path, file.read_text(encoding="utf-8"))
    print("\n".join(found) or "every include follows the order")
    return 1 if found else 0


sys.exit(main(sys.argv[1]))
