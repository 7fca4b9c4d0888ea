"""Validates the SARIF logs of pal against the official schema, and against what the JSON form says of the same files.

Usage: validate.py PAL SOURCE_DIR [PART OF]. With two numbers a part of the files: every OF-th, from
the PART-th on. Exit status 1 and a line a fault.
"""
import json
import pathlib
import subprocess
import sys
import urllib.parse

import jsonschema

FAULTS = []


def run(pal, arguments, folder, form):
    done = subprocess.run([pal, "check", *arguments, "--format", form], cwd=folder, capture_output=True, check=False)
    return done.returncode, json.loads(done.stdout.decode("utf-8"))


def place(result):
    """(file, line, column, end line, end column) as the JSON form gives them."""
    physical = result["locations"][0]["physicalLocation"]
    region = physical["region"]
    return [urllib.parse.unquote(physical["artifactLocation"]["uri"]), region["startLine"], region["startColumn"], region["endLine"],
            region["endColumn"]]


def compare(what, status, log, document):
    """What the schema cannot say: that the log is about the same findings, at the same places, with their rules."""
    (one,) = log["runs"]
    rules = one["tool"]["driver"]["rules"]
    if one["invocations"][0]["exitCode"] != status:
        FAULTS.append(f"{what}: exit code {one['invocations'][0]['exitCode']}, ended with {status}")
    results = one["results"]
    if len(results) != len(document["diagnostics"]):
        FAULTS.append(f"{what}: {len(results)} results of {len(document['diagnostics'])} findings")
    for result, finding in zip(results, document["diagnostics"]):
        expected = [finding[key] for key in ("file", "line", "column", "end_line", "end_column")]
        # What has no place stands at the beginning of the first file: code hosts refuse a result without one.
        same = ((place(result) == expected or expected == ["", 0, 0, 0, 0] and place(result)[1:] == [1, 1, 1, 1]) and result["ruleId"] == finding["code"] ==
                rules[result["ruleIndex"]]["id"] and result["level"] == finding["severity"] and
                result["message"]["text"].startswith(finding["message"]) and
                len(result.get("relatedLocations", [])) == len(finding["notes"]) and
                bool(result.get("fixes")) == bool(finding["fix"]))
        if not same:
            FAULTS.append(f"{what}: {finding['code']} at {expected} is told otherwise in SARIF")
    if {rule["id"] for rule in rules} != {finding["code"] for finding in document["diagnostics"]}:
        FAULTS.append(f"{what}: the rules are not those that occur")


def main(pal, source, part=1, of=1):
    source = pathlib.Path(source)
    schema = json.loads((source / "tests/sarif/sarif-2.1.0-rtm.5.json").read_text(encoding="utf-8"))
    validator = jsonschema.Draft4Validator(schema)
    golden = source / "tests/golden/check"
    cases = [(golden, [file.name]) for file in sorted(golden.glob("*.pal"))]
    cases += [(golden, ["there is none.pal"])]
    skills = source / "skills_pal"
    cases += [(skills, [f"touch/{name}.pal", "-e", "workcell.pal"]) for name in ("touch", "touch_read_first")]
    cases = cases[int(part) - 1::int(of)]
    for folder, arguments in cases:
        what = " ".join(arguments)
        status, log = run(pal, arguments, folder, "sarif")
        status_of_json, document = run(pal, arguments, folder, "json")
        if status != status_of_json:
            FAULTS.append(f"{what}: ends with {status} in SARIF and with {status_of_json} in JSON")
        compare(what, status, log, document)
        for error in validator.iter_errors(log):
            FAULTS.append(f"{what}: {'/'.join(map(str, error.absolute_path))}: {error.message}")
    print("\n".join(FAULTS) or f"{len(cases)} logs are valid")
    return 1 if FAULTS else 0


sys.exit(main(*sys.argv[1:]))
