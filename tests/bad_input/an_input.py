"""What each input is: a function that writes files into a folder and gives (arguments of its command, exit status,
codes that must be shown), with its name as its text. Status None: anything but a crash.
"""

N = 100_000
INPUTS = []


def an_input(function, command="check"):
    INPUTS.append((command, function))
    return function


def generated(function):
    return an_input(function, "generate")


def file(folder, text, name="a.pal"):
    path = folder / name
    path.write_bytes(text if isinstance(text, bytes) else text.encode())
    return str(path)


def module(body):
    return "CONDITION c\nMESSAGE m : SIGNAL\nDEVICE d\nSkill Module: SM1\nBEGIN\n" + body + "\nEND\n"


def skill(body, declared=""):
    return (declared + "CONDITION c\nMESSAGE m : SIGNAL\nDEVICE d\nMachine Controller: MC1\nSKILL s\nMACHINE CONTROLLER MC1\n"
            "SKILL METHOD SM1\nCOMPLETION 0 NORMAL\nCOMPLETION 1 ERROR\nEND SKILL\nSkill Module: SM1\nBEGIN\n"
            "WTM( Coordinator )\n" + body + "\nTXM( Completion Protocol 0 )\nEND\n")
