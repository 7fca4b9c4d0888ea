"""Skills that code is generated of."""
from an_input import generated, file


def executes(depth, last):
    """Modules that execute the next one twice each, `depth` of them; `last` is the body of the last."""
    modules = "".join(f"Skill Module: M{i}\nBEGIN\nExecute M{i + 1}\nExecute M{i + 1}\nEND\n" for i in range(depth))
    methods = "".join(f"SKILL METHOD M{i}\n" for i in range(depth + 1))
    return ("MESSAGE m : SIGNAL\nMachine Controller: MC1\nSKILL s\nMACHINE CONTROLLER MC1\nSKILL METHOD SM1\n" + methods +
            "COMPLETION 0 NORMAL\nCOMPLETION 1 ERROR\nEND SKILL\n" + modules +
            f"Skill Module: M{depth}\nACTIVITY look\nBEGIN\n{last}\nEND\n"
            "Skill Module: SM1\nBEGIN\nWTM( Coordinator )\nTXM( m to MC1 )\nExecute M0\nTXM( Completion Protocol 0 )\nEND\n"
            f"ENVIRONMENT e\nPROCESSOR P\nPLACE SM1 ON P PRIORITY 1\nTIME look OF M{depth} : 1 ms\nEND ENVIRONMENT\n")


@generated
def execute_twice_and_twice(folder):
    """sixty modules, each of which executes the next twice"""
    return [file(folder, executes(60, "look")), "-o", str(folder), "--allow-failing"], 0, []


@generated
def execute_without_end(folder):
    """the same, and the last never ends"""
    return [file(folder, executes(60, "REPEAT\nlook\nUNTIL( forever )")), "-o", str(folder), "--allow-failing"], 0, []


@generated
def skill_of_many_blocks(folder):
    """a skill whose method has a thousand blocks, each with a thread of its own"""
    blocks = "".join("BEGIN look END\n" for _ in range(1000))
    return [file(folder, executes(0, "CONCURRENT\n" + blocks + "END CONCURRENT")), "-o", str(folder), "--allow-failing"], 0, []
