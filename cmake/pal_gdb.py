# For gdb: `source` this file, or the .gdb file beside a skill's generated code, which does it.
#
# A body is a coroutine. At each `co_await` it leaves its stack frame, the runtime goes on with others, and it is
# resumed later, in a new frame. gdb's `next` would follow the old frame into the runtime; pal-next follows the body.
import gdb

# `step` goes into activities and devices, not into what lies between.
for pattern in ("*/pal/runtime/*", "*/c++/*"):
    gdb.execute("skip -gfile " + pattern, to_string=True)


def body_at(frame):
    """The function of a body that has begun, None if the frame has no such function."""
    function = frame.function()
    # GCC's name for the function that resumes a coroutine.
    return function if function is not None and ".Frame *" in function.name else None


def first_addresses(symtab, block, heading):
    """Where each line of the block begins. The lines of the function's heading and of its end are left out: there
    a coroutine leaves and comes back."""
    first = {}
    for entry in symtab.linetable():
        if entry.line > 0 and block.start <= entry.pc < block.end:
            first[entry.line] = min(entry.pc, first.get(entry.line, entry.pc))
    if heading in first:
        del first[heading]
        if first:
            del first[max(first)]
    return list(first.values())


class PalNext(gdb.Command):
    """Goes on to the next statement of this body, whatever runs meanwhile.

Usage: pal-next, or pn
A module that it executes, its activities and all other threads run on. Breakpoints stop as always. The body is that
of the selected frame; if several threads execute one module, it is the one of this thread."""

    def __init__(self):
        super().__init__("pal-next", gdb.COMMAND_RUNNING)

    def invoke(self, argument, from_tty):
        frame = gdb.selected_frame()
        body = body_at(frame)
        if body is None:
            raise gdb.GdbError("the selected frame is in no body of a module; use break and continue")
        block = frame.block()
        while block.function is None:
            block = block.superblock
        here = frame.find_sal()
        coroutine = int(frame.read_var("frame_ptr"))
        points = []
        for address in first_addresses(here.symtab, block, body.line if body.symtab == here.symtab else 0):
            point = gdb.Breakpoint("*%d" % address, internal=True)
            point.silent = True
            point.condition = "(unsigned long) frame_ptr == %d" % coroutine
            points.append(point)
        try:
            gdb.execute("continue", to_string=True)
        finally:
            for point in points:
                if point.is_valid():
                    point.delete()
        self.show(body)

    def show(self, body):
        try:
            frame = gdb.selected_frame()
        except gdb.error:
            print("the program has ended")
            return
        here = frame.find_sal()
        at = body_at(frame)
        if at is not None and at.name == body.name and here.symtab is not None:
            gdb.execute("list %d,%d" % (here.line, here.line))
        else:
            gdb.execute("frame")


PalNext()
gdb.execute("alias pn = pal-next", to_string=True)
