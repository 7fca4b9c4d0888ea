#!/usr/bin/env python3
"""Prints a skill of about so many statements: long_skill.py STATEMENTS SENSORS.

The skill module asks logical sensors in one long loop, and they work in loops as long, on four processors.
"""
import sys

PROCESSORS = 4


def main():
    statements, sensors = int(sys.argv[1]), int(sys.argv[2])
    names = [f"LS{i}" for i in range(sensors)]
    each = statements // (sensors + 1)
    out = ["MESSAGE tick : SIGNAL"]
    out += [f"MESSAGE v{name} : REAL N" for name in names]
    out.append('CONDITION pc-high FROM vLS0 "high"')
    out.append(f"SKILL long\n  LOGICAL SENSOR {', '.join(names)}\n  MACHINE CONTROLLER MC1\n  SKILL METHOD SM1")
    out.append("  COMPLETION 0 NORMAL\n  COMPLETION 1 ERROR")
    out.append("  REQUIREMENT whole : RESPONSE FROM tick OF MC1 TO work AT MOST 900 s")
    out.append("  REQUIREMENT busy : BUSY PERIOD OF P0 AT MOST 900 s\nEND SKILL\nMachine Controller: MC1")
    for name in names:
        out.append(f"Logical Sensor: {name}\n  ACTIVITY look WRITES v{name}\nBEGIN\n  REPEAT")
        out.append(f"    WTM( request v{name} from SM1 )")
        out += ["    look"] * max(1, each - 4)
        out.append(f"    TXM( v{name} to SM1 )\n  UNTIL( forever )\nEND")
    out.append("Skill Module: SM1\n  ACTIVITY work READS vLS0\nBEGIN\n  WTM( Coordinator )\n  REPEAT\n    WTM( tick from MC1 )")
    for turn in range((each + 2) // 3):
        name = names[turn % sensors]
        out.append(f"    TXM( request v{name} from {name} )\n    WTM( v{name} from {name} )\n    work")
    out.append("    SPC( pc-high )\n  UNTIL( pc-high )\n  TXM( Completion Protocol 0 )\nEND\nENVIRONMENT cell")
    out += [f"  PROCESSOR P{p}" for p in range(PROCESSORS)]
    out.append("  DEVICE MC1 EVENT tick EVERY 1000 s\n  TIME look : 1 ms TO 2 ms\n  TIME work : 1 ms TO 2 ms")
    out += [f"  PLACE {name} ON P{i % PROCESSORS} PRIORITY {i + 2}" for i, name in enumerate(names)]
    out.append("  PLACE SM1 ON P0 PRIORITY 1\nEND ENVIRONMENT")
    print("\n".join(out))


if __name__ == "__main__":
    main()
