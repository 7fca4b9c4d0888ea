"""Every operation that people read is valid by the published schema, and what the reader refuses is not.

Usage: schema.py SOURCE_DIR. Exit status 1 and a line for each file that is not as it should be.
"""
import json
import pathlib
import sys

import jsonschema

root = pathlib.Path(sys.argv[1])
schema = json.loads((root / "operations/schema/operation.schema.json").read_text(encoding="utf-8"))
jsonschema.Draft202012Validator.check_schema(schema)
validator = jsonschema.Draft202012Validator(schema)
# Of the goldens only these break the schema; the others break rules that no schema can state.
BROKEN = {"fail_field.op.json", "fail_fields.op.json", "fail_sensor_fields.op.json"}
wrong = []
count = 0
for folder in ["examples/operations", "tests/golden/operation"]:
    for file in sorted((root / folder).glob("*.op.json")):
        if file.name in {"fail_no_json.op.json", "fail_merge_conflict.op.json"}:
            continue
        count += 1
        errors = [error.message for error in validator.iter_errors(json.loads(file.read_text(encoding="utf-8")))]
        if bool(errors) != (file.name in BROKEN):
            wrong.append(f"{file}: {errors or 'the schema allows it'}")
print("\n".join(wrong) or f"{count} operations are as they should be")
sys.exit(1 if wrong or count == 0 else 0)
