"""Every SARIF log of `pal operation check` on the goldens is valid, with the findings of the JSON form.

Usage: sarif.py PAL SOURCE_DIR. Exit status 1 at the first that is not.
"""
import json
import pathlib
import subprocess
import sys

import jsonschema

pal = sys.argv[1]
root = pathlib.Path(sys.argv[2])
schema = json.loads((root / "tests/sarif/sarif-2.1.0-rtm.5.json").read_text(encoding="utf-8"))
folder = root / "tests/golden/operation"
count = 0
for file in sorted(folder.glob("*.op.json")):
    command = [pal, "operation", "check", file.name, "--skills", "skills.pal", "-e", "cell.pal", "--location", "HOME"]
    logs = {}
    for form in ["sarif", "json"]:
        answer = subprocess.run([*command, "--format", form], cwd=folder, capture_output=True, text=True, check=False)
        logs[form] = json.loads(answer.stdout)
    jsonschema.validate(logs["sarif"], schema)
    found = [(result["ruleId"], result["level"]) for result in logs["sarif"]["runs"][0]["results"]]
    if found != [(each["code"], each["severity"]) for each in logs["json"]["diagnostics"]]:
        sys.exit(f"{file}: the two forms differ")
    count += 1
print(f"{count} logs are valid")
sys.exit(0 if count else 1)
