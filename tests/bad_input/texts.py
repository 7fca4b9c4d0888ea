"""Texts: nesting, sizes, bytes, files that are none."""
from an_input import N, an_input, file, module, skill


def nested(before, after, inner=""):
    return lambda folder: ([file(folder, module(before * N + inner + after * N))], 1, ["PAL0105"])


def nested_input(name, before, after, inner=""):
    function = nested(before, after, inner)
    function.__doc__ = f"{N} levels of {name}"
    an_input(function)


nested_input("CASE", "CASE ( c ):\n", "END CASE\n")
nested_input("REPEAT", "REPEAT\n", "UNTIL( c )\n")
nested_input("CONCURRENT", "CONCURRENT BEGIN\n", "END END CONCURRENT\n")
nested_input("WTM WITHIN", "WTM( m from d ) WITHIN 1 ms\n", "ELSE END WTM\n")
nested_input("WTM FIRST", "WTM FIRST ( m from d ):\n", "END WTM\n")
nested_input("REPEAT that are never closed", "REPEAT\n", "")


@an_input
def not_not_not(folder):
    """a hundred thousand NOT"""
    return [file(folder, module("SPC( c )\nREPEAT\nDo Nothing\nUNTIL( " + "NOT " * N + "c )"))], 0, []


@an_input
def parentheses_in_a_guard(folder):
    """a hundred thousand parentheses in a guard"""
    return [file(folder, module("REPEAT UNTIL( " + "(" * N + "c" + ")" * N + " )"))], 1, ["PAL0105"]


@an_input
def ends(folder):
    """a hundred thousand END that end nothing"""
    return [file(folder, module("END\n" * N))], 1, ["PAL0101"]


@an_input
def long_guard(folder):
    """a guard of a hundred thousand terms"""
    return [file(folder, module("SPC( c )\nREPEAT\nTXM( m to d )\nUNTIL( " + "c AND c OR " * (N // 2) + "c )"))], 0, []


@an_input
def execute_chain(folder):
    """ten thousand modules, each of which executes the next"""
    n = N // 10
    text = "".join(f"Contingency Module: CM{i}\nBEGIN\n  Execute CM{i + 1}\nEND\n" for i in range(n))
    return [file(folder, text + f"Contingency Module: CM{n}\nBEGIN\nDo Nothing\nEND\n")], None, []


@an_input
def execute_circle(folder):
    """ten thousand modules that execute each other in a circle"""
    n = N // 10
    text = "".join(f"Contingency Module: CM{i}\nBEGIN\n  Execute CM{(i + 1) % n}\nEND\n" for i in range(n))
    return [file(folder, text)], 1, ["PAL0212"]


@an_input
def many_statements(folder):
    """a module of a hundred thousand statements"""
    return [file(folder, module("SPC( c )\nRPC( c )\n" * (N // 2)))], None, []


@an_input
def many_arms(folder):
    """a CASE of ten thousand arms"""
    return [file(folder, module("SPC( c )\nCASE\n" + "( c ): Do Nothing\n( NOT c ): TXM( m to d )\n" * (N // 20)
                                + "END CASE"))], None, []


@an_input
def many_blocks(folder):
    """a CONCURRENT of ten thousand blocks"""
    return [file(folder, module("CONCURRENT\n" + "BEGIN TXM( m to d ) END\n" * (N // 10) + "END CONCURRENT"))], None, []


@an_input
def skill_of_many_blocks(folder):
    """a skill whose method has ten thousand blocks"""
    return [file(folder, skill("CONCURRENT\n" + "BEGIN SPC( c ) END\n" * (N // 10) + "END CONCURRENT"))], 1, ["PAL0402"]


@an_input
def skill_of_many_sends(folder):
    """a skill whose method has a thousand blocks that send"""
    body = "".join(f"BEGIN TXM( m{i} to MC1 ) END\n" for i in range(N // 100))
    declared = "".join(f"MESSAGE m{i} : SIGNAL\n" for i in range(N // 100))
    return [file(folder, skill("CONCURRENT\n" + body + "END CONCURRENT", declared))], None, []


@an_input
def skill_of_many_statements(folder):
    """a skill whose method has a hundred thousand statements"""
    return [file(folder, skill("SPC( c )\nRPC( c )\n" * (N // 2)))], None, []


@an_input
def skill_of_many_cases(folder):
    """a skill whose method has ten thousand CASE"""
    body = "SPC( c )\nCASE ( c ): Do Nothing ( NOT c ): TXM( m to MC1 ) END CASE\n" * (N // 10)
    return [file(folder, skill(body))], None, []


@an_input
def skill_of_many_modules(folder):
    """a skill of a thousand modules that talk in a chain"""
    n = N // 100
    text = "".join(f"MESSAGE m{i} : SIGNAL\nLogical Sensor: LS{i}\nBEGIN\nREPEAT\nWTM( request m{i} from SM1 )\n"
                   f"TXM( m{i} to SM1 )\nUNTIL( forever )\nEND\n" for i in range(n))
    body = "".join(f"TXM( request m{i} from LS{i} )\n" for i in range(n))
    body += "".join(f"WTM( m{i} from LS{i} )\n" for i in range(n))
    sensors = "LOGICAL SENSOR " + ", ".join(f"LS{i}" for i in range(n)) + "\n"
    return [file(folder, skill(body, text).replace("SKILL METHOD", sensors + "SKILL METHOD"))], None, []


@an_input
def hundred_megabytes(folder):
    """a line of 100 MB"""
    return [file(folder, b"#" + b"x" * (100 << 20))], 2, ["PAL0111"]


@an_input
def long_comment(folder):
    """a comment of 15 MB"""
    return [file(folder, b"#" + b"x" * (15 << 20))], 0, []


@an_input
def long_name(folder):
    """an identifier of a megabyte"""
    name = "c" + "x" * (1 << 20)
    return [file(folder, skill("SPC( y" + name + " )", f"CONDITION {name}\n"))], 1, ["PAL0203"]


@an_input
def long_number(folder):
    """a number of a megabyte"""
    return [file(folder, module("TXM( Completion Protocol 1" + "0" * (1 << 20) + " )"))], 1, ["PAL0107"]


@an_input
def long_time(folder):
    """a time of a megabyte"""
    return [file(folder, module("WTM( m from d ) WITHIN 1" + "0" * (1 << 20) + " ms ELSE END WTM"))], 1, ["PAL0704"]


@an_input
def long_text(folder):
    """a text of a megabyte"""
    return [file(folder, 'CONDITION c "' + "x" * (1 << 20) + '"\n')], 0, []


@an_input
def open_text(folder):
    """a text of a megabyte without its end"""
    return [file(folder, 'CONDITION c "' + "x" * (1 << 20) + '\n')], 1, ["PAL0103"]


@an_input
def many_words(folder):
    """eight million words that mean nothing"""
    return [file(folder, b"a b " * (4 << 20))], 1, ["PAL0111"]


@an_input
def many_strays(folder):
    """a hundred thousand characters that mean nothing"""
    return [file(folder, "? ! " * (N // 2))], 1, ["PAL0102", "PAL0104"]


@an_input
def many_unknown_names(folder):
    """ten thousand unknown names among ten thousand known ones"""
    declared = "".join(f"CONDITION known-{i}-name\n" for i in range(N // 10))
    return [file(folder, skill("".join(f"SPC( unknown-{i}-name )\n" for i in range(N // 10)), declared))], 1, ["PAL0203"]


@an_input
def many_unknown_activities(folder):
    """a hundred thousand unknown activities among as many known ones"""
    known = "".join(f"ACTIVITY known-{i}\n" for i in range(N))
    body = "".join(f"unknown-{i}\n" for i in range(N))
    return [file(folder, skill(body).replace("SM1\nBEGIN", "SM1\n" + known + "BEGIN"))], 1, ["PAL0204", "more; --max-errors 0"]


@an_input
def many_unknown_units(folder):
    """half a million errors, as a program reads them"""
    return ["--format", "json", file(folder, "MESSAGE m : REAL furlong\n" * (N * 5 // 2))], 1, ["PAL0601", "not_kept"]


@an_input
def many_unknown_processors(folder):
    """a hundred thousand unknown processors among as many known ones"""
    known = "".join(f"PROCESSOR processor-{i}\n" for i in range(N))
    placed = "".join(f"PLACE SM1.{i + 1} ON processer-{i} PRIORITY 1\n" for i in range(N))
    return [file(folder, "ENVIRONMENT e\n" + known + placed + "END ENVIRONMENT\n")], 1, ["PAL0713", "more; --max-errors 0"]


@an_input
def twice(folder):
    """a name declared ten thousand times"""
    return [file(folder, "CONDITION c\n" * (N // 10))], None, []


@an_input
def many_fields(folder):
    """a message of ten thousand fields"""
    fields = ", ".join(f"f{i}" for i in range(N // 10))
    return [file(folder, f"MESSAGE m : {fields} : REAL N\n")], 0, []


@an_input
def long_unit(folder):
    """a unit of ten thousand factors"""
    return [file(folder, "MESSAGE m : REAL " + "*".join(["N"] * (N // 10)) + "\n")], None, []


@an_input
def no_utf8(folder):
    """bytes that are no UTF-8"""
    return [file(folder, b"CONDITION c\n# \xff\xfe\n")], 1, ["PAL0112"]


@an_input
def nul(folder):
    """a NUL byte"""
    return [file(folder, b"CONDITION c\0\n")], 1, ["PAL0112"]


@an_input
def zeros(folder):
    """a device file without an end"""
    return ["/dev/zero"], 2, ["PAL0111"]


@an_input
def a_directory(folder):
    """a directory"""
    return [str(folder)], 2, ["PAL0111"]


@an_input
def below_a_file(folder):
    """a file that cannot be read: its folder is a file"""
    return [file(folder, "") + "/b.pal"], 2, ["PAL0111"]


@an_input
def uses_a_directory(folder):
    """USES of a directory"""
    return [file(folder, 'USES "."\n')], 1, ["PAL0111"]


@an_input
def uses_itself(folder):
    """a file that uses itself"""
    return [file(folder, 'USES "a.pal"\n')], 1, ["PAL0113"]


@an_input
def uses_in_a_circle(folder):
    """files that use each other in a circle"""
    file(folder, 'USES "c.pal"\n', "b.pal")
    file(folder, 'USES "a.pal"\n', "c.pal")
    return [file(folder, 'USES "b.pal"\n')], 1, ["PAL0113"]


@an_input
def many_uses(folder):
    """ten thousand USES"""
    for i in range(N // 10):
        file(folder, f"CONDITION c{i}\n", f"{i}.pal")
    return [file(folder, "".join(f'USES "{i}.pal"\n' for i in range(N // 10)))], 0, []


@an_input
def deep_uses(folder):
    """a chain of ten thousand USES"""
    for i in range(N // 10):
        file(folder, f'USES "{i + 1}.pal"\nCONDITION c{i}\n', f"{i}.pal")
    file(folder, "CONDITION last\n", f"{N // 10}.pal")
    return [str(folder / "0.pal")], 0, []


@an_input
def long_path(folder):
    """USES of a path of a megabyte"""
    return [file(folder, 'USES "' + "x/" * (1 << 19) + 'y.pal"\n')], 1, ["PAL0111"]


@an_input
def empty(folder):
    """an empty file"""
    return [file(folder, "")], 0, []


@an_input
def only_a_comment(folder):
    """only a comment, without a line's end"""
    return [file(folder, "# nothing")], 0, []


@an_input
def line_ends(folder):
    """CR LF, with a byte order mark"""
    return [file(folder, "\ufeff" + module("Do Nothing").replace("\n", "\r\n"))], 0, []
