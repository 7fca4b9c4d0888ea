"""What JUnit readers ask of a report: of each suite Maven's Surefire schema 3.0, of the whole that of Jenkins, as far as they go beyond XML."""
import re
import xml.etree.ElementTree

SECONDS = re.compile(r"\d+\.\d+")
SUITE = {"name", "tests", "failures", "errors", "skipped", "time"}
CASE = {"name", "classname", "time"}
RESULT = {"failure": {"message", "type"}, "error": {"message", "type"}, "skipped": {"message"}}


def check_junit(text):
    """Raises ValueError if `text` is no such report."""
    root = xml.etree.ElementTree.fromstring(text)

    def need(condition, what):
        if not condition:
            raise ValueError(what)

    need(root.tag == "testsuites", f"the root is {root.tag}")
    need(len(root) > 0, "there is no suite")
    names = set()
    for suite in root:
        need(suite.tag == "testsuite" and set(suite.keys()) == SUITE, f"{suite.tag} has {sorted(suite.keys())}")
        need(SECONDS.fullmatch(suite.get("time")), "the time of a suite")
        need(int(suite.get("tests")) == len(suite), "the number of cases")
        for word, kind in [("failures", "failure"), ("errors", "error"), ("skipped", "skipped")]:
            need(int(suite.get(word)) == len(suite.findall(f"testcase/{kind}")), f"the number of {word}")
        for case in suite:
            need(case.tag == "testcase" and set(case.keys()) == CASE, f"{case.tag} has {sorted(case.keys())}")
            need(SECONDS.fullmatch(case.get("time")), "the time of a case")
            need(len(case) <= 1, f"{case.get('name')} has two results")
            need((suite.get("name"), case.get("name")) not in names, f"two cases {case.get('name')} in {suite.get('name')}")
            names.add((suite.get("name"), case.get("name")))
            for result in case:
                need(result.tag in RESULT and set(result.keys()) == RESULT[result.tag], f"{result.tag} has {sorted(result.keys())}")
                need(len(result) == 0 and result.get("message"), "the message of a result")
    need(any(len(suite) for suite in root), "there is no case")
