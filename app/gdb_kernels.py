"""gdb for kernels on the CPU machine: who is this CUDA thread, and which path does it work for?

    (gdb) source app/gdb_kernels.py
    (gdb) print $pixel()
    (gdb) break raylab::lab02::trace_path if $pixel() == 2080
    (gdb) print $threadIdx("x")

Functions: $threadIdx, $blockIdx, $blockDim, $gridDim, each with "x", "y" or "z"; $pixel, $sample and
$bounce, which look for the names below in the frames of the stack, from the inside out.
`raylab debug` starts gdb with this file. At a stop in path_stop() the frame is shown that is not in
common/: the lab's.
"""
import os
import re

import gdb

# Where the labs and common keep a path's numbers: the first expression that has a value is taken.
# `this` is the Sampler in whose functions the stop is.
PIXEL = ["pixel", "sampler.pixel", "path.sampler.pixel", "this->pixel", "wave.pool.pixel[slot]"]
SAMPLE = ["sample", "sampler.sample", "path.sampler.sample", "iteration.sample", "this->sample", "wave.sample"]
BOUNCE = ["bounce", "path.bounce", "wave.pool.bounce[slot]"]


def frames():
    frame = gdb.newest_frame()
    while frame is not None:
        yield frame
        frame = frame.older()


def file_of(frame):
    table = frame.find_sal().symtab
    return table.fullname() if table else ""


def variables(frame):
    """The names of a frame's variables and arguments: gdb would look for others in the whole program."""
    names = set()
    try:
        block = frame.block()
    except RuntimeError:  # a frame without debug information
        return names
    while block is not None and not block.is_global and not block.is_static:
        names.update(symbol.name for symbol in block)
        block = None if block.function else block.superblock
    return names


def find(expressions):
    """The first of the expressions that is an integer in a frame, the innermost frame first."""
    chosen = gdb.selected_frame()
    try:
        for frame in frames():
            if "common/simt/" in file_of(frame):
                break  # the machine's own frames follow
            names = variables(frame)
            for expression in expressions:
                if re.match(r"\w+", expression).group() not in names:
                    continue
                frame.select()
                try:
                    return int(gdb.parse_and_eval(expression))
                except (gdb.error, OverflowError):
                    continue
    finally:
        chosen.select()
    return None


class PathNumber(gdb.Function):
    def __init__(self, name, expressions):
        super().__init__(name)
        self.name, self.expressions = name, expressions

    def invoke(self):
        number = find(self.expressions)
        return -1 if number is None else number  # no number of a path: no condition holds


class Index(gdb.Function):
    def __init__(self, name):
        super().__init__(name)
        self.name = name

    def invoke(self, axis=None):
        axis = axis.string() if axis is not None else "x"
        return gdb.parse_and_eval("%s.%s" % (self.name, axis))


def triple(name):
    return "(%s)" % ",".join(str(gdb.parse_and_eval("%s.%s" % (name, axis))) for axis in "xyz")


def in_kernel():
    return any("call_kernel" in (frame.name() or "") for frame in frames())


def show_lab(event):
    """At a stop in path_stop(): who is here, and the innermost frame that is not common's."""
    if not isinstance(event, gdb.BreakpointEvent) or "path_stop" not in (gdb.newest_frame().name() or ""):
        return
    for frame in frames():
        if os.sep + "common" + os.sep not in file_of(frame):
            frame.select()
            break
    numbers = "pixel %s, sample %s" % (find(PIXEL), find(SAMPLE))
    thread = " by thread %s of block %s" % (triple("threadIdx"), triple("blockIdx")) if in_kernel() else ""
    print("\nThe path of %s%s. Here it takes random numbers:" % (numbers, thread))
    gdb.execute("frame")


for name, expressions in (("pixel", PIXEL), ("sample", SAMPLE), ("bounce", BOUNCE)):
    PathNumber(name, expressions)
for name in ("threadIdx", "blockIdx", "blockDim", "gridDim"):
    Index(name)
gdb.events.stop.connect(show_lab)
