"""Compares the methods of the schema with those of the server's source, with their roles, and with the tables of
docs/reference/protocols.md.

Usage: methods.py SOURCE_DIR
"""
import json
import pathlib
import re
import sys

root = pathlib.Path(sys.argv[1])
sys.path.insert(0, str(root / "scripts"))
from protocol_tables import tables  # noqa: E402

schema = json.loads((root / "server/schema/protocol.json").read_text())
source = "".join(path.read_text() for path in sorted((root / "server").glob("json_*.cpp")))
served = dict(re.findall(r'Method\{"([\w.]+)", Role::(\w+)', source))
served.update({name: "viewer" for name in re.findall(r'name == "([\w.]+)"\) return', source)})
served = {name: "operator" if role == "operating" else role for name, role in served.items()}
written = {each["name"]: each["x-role"] for each in schema["methods"]}
problems = [f"{name}: served for {served.get(name)}, the schema says {written.get(name)}"
            for name in sorted(served.keys() | written.keys()) if served.get(name) != written.get(name)]
page = (root / "docs/reference/protocols.md").read_text()
if tables(schema) not in page:
    problems.append("docs/reference/protocols.md: run scripts/protocol_tables, which writes its tables")
print("\n".join(problems))
sys.exit(1 if problems else 0)
