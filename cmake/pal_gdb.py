# For gdb: `source` this file, or the .gdb file beside a skill's generated code, which does it.
#
# A body is a coroutine. At each `co_await` it leaves its stack frame, and the runtime goes on with others. Later it
# is resumed in a new frame. gdb's `next` would follow the old frame into the runtime; pal-next follows the body.
import gdb

# `step` goes into activities and devices, not into what lies between.
gdb.execute("skip -rfunction ^(std|pal::runtime)::", to_string=True)


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
    """Goes on to the next statement of a body of a module, whatever runs meanwhile.

Usage: pal-next, or pn
The body is that of the selected frame; where the frame is in no body (in an activity, in the runtime) it is that of
the last pal-next. A module that the body executes, activities and all other threads run on. Breakpoints stop as
always. If several threads execute one module, the body is that of this thread."""

    def __init__(self):
        super().__init__("pal-next", gdb.COMMAND_RUNNING)
        self.last = None

    def invoke(self, argument, from_tty):
        try:
            frame = gdb.selected_frame()
        except gdb.error:
            raise gdb.GdbError("the program does not run; break at a line of PAL, and run")
        body = body_at(frame)
        if body is not None:
            block = frame.block()
            while block.function is None:
                block = block.superblock
            symtab = frame.find_sal().symtab
            heading = body.line if body.symtab == symtab else 0
            self.last = (body.name, int(frame.read_var("frame_ptr")), first_addresses(symtab, block, heading))
        if self.last is None:
            raise gdb.GdbError("no body of a module is known; break at a line of PAL first")
        name, coroutine, addresses = self.last
        points = []
        for address in addresses:
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
        self.show(name)

    def show(self, name):
        try:
            frame = gdb.selected_frame()
        except gdb.error:
            self.last = None
            print("the program has ended")
            return
        here = frame.find_sal()
        at = body_at(frame)
        if at is not None and at.name == name and here.symtab is not None:
            gdb.execute("list %d,%d" % (here.line, here.line))
        else:
            gdb.execute("frame")


PalNext()
gdb.execute("alias pn = pal-next", to_string=True)
