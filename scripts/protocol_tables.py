"""Writes the tables of methods, errors and notifications in docs/reference/protocols.md from the schema of the
protocol, between its two marks.

Usage: protocol_tables.py, in the top folder
"""
import json
import pathlib

BEGIN, END = "<!-- from server/schema/protocol.json -->", "<!-- until here -->"


def kind(schema):
    """A type in a word or two."""
    if "$ref" in schema:
        return schema["$ref"].rsplit("/", 1)[1]
    if "allOf" in schema:
        return kind(schema["allOf"][0])
    if "anyOf" in schema:
        return " or ".join(kind(each) for each in schema["anyOf"])
    of = schema.get("type")
    if isinstance(of, list):
        return " or ".join(of)
    if of == "array":
        return f"list of {kind(schema['items'])}"
    if of == "object":
        fields = ", ".join(f"`{name}`" for name in schema.get("properties", {}))
        return fields or "`{}`"
    return of or "JSON"


def tables(schema):
    lines = [BEGIN, "", "| method | params | result | least role |", "| --- | --- | --- | --- |"]
    for method in schema["methods"]:
        params = ", ".join(f"`{each['name']}`" + ("" if each["required"] else "?") for each in method["params"])
        lines.append(f"| `{method['name']}` | {params} | {kind(method['result']['schema'])} | {method['x-role']} |")
    lines += ["", "| code | `why` | meaning |", "| --- | --- | --- |"]
    lines += [f"| {each['code']} | `{each['data']['why']}` | {each['message']} |"
              for each in schema["components"]["errors"].values()]
    lines += ["", END]
    return "\n".join(lines)


def main():
    path = pathlib.Path("docs/reference/protocols.md")
    page = path.read_text()
    head, rest = page.split(BEGIN, 1)
    path.write_text(head + tables(json.loads(pathlib.Path("server/schema/protocol.json").read_text())) + rest.split(END, 1)[1])


if __name__ == "__main__":
    main()
