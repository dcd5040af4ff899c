#!/usr/bin/env python3
"""Holds the handouts of all labs to what lab.json and the sources say.

    python3 tools/figures/check_handouts.py

Every task's section stands under the heading that `raylab check` names, every picture shown is
there and small, a breakpoint stands where the handout says, and no line of a solution stands in a
handout. Ends with 1 and a list if not.
"""
import json
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
LARGEST_PICTURE = 80_000  # bytes
SHORTEST = 28  # characters of a line that gives something away, as in grader/course/release.cpp

# What stands in the line of a breakpoint, or in the next, by its file.
STOPS = {
    "renderer.cu": "sampler_of_path(",
    "path.h": "sample_bsdf<F>(",
    "shade.h": "sample_bsdf<F>(",
    "kernels.cu": "pool.alive[slot]",
    "walk_kernels.h": "Walk::walk(",
    "walk_ropes.h": "query.step()",
}


def squeezed(line):
    return re.sub(r"\s", "", line.split("//")[0])


def solution_lines(lab):
    """Lines between //[ task and //| in the lab's sources."""
    for source in (f for f in lab.rglob("*") if f.suffix in (".h", ".cpp", ".cu")):
        inside = False
        for line in source.read_text().splitlines():
            mark = line.strip()
            inside = mark.startswith("//[ task") or (inside and not mark.startswith(("//|", "//]")))
            if inside and len(squeezed(line)) >= SHORTEST:
                yield squeezed(line)


def stray_stops(lab, handout):
    """Lines that a handout gives to gdb, and that are not what it says they are."""
    for place, number in set(re.findall(r"(?:break|dprintf) ([\w/.]+):(\d+)", handout)):
        name = pathlib.PurePath(place).name
        found = list(lab.rglob(name))
        lines = found[0].read_text().splitlines()[int(number) - 1:][:2] if len(found) == 1 else []
        if not any(STOPS[name] in line for line in lines):
            yield f"{place}:{number} is not where {STOPS[name]} stands"


def problems(lab):
    handout = (lab / "README.md").read_text()
    headings = re.findall(r"^#+ (.*)$", handout, re.MULTILINE)
    for task in json.loads((lab / "lab.json").read_text())["tasks"]:
        if task["hints"] not in headings:
            yield f'no heading "{task["hints"]}" for task {task["id"]}'
    for name in re.findall(r"!\[[^]]*\]\(([^)]*)\)", handout):
        if not (lab / name).is_file():
            yield f"no picture {name}"
        elif (lab / name).stat().st_size > LARGEST_PICTURE:
            yield f"{name} has more than {LARGEST_PICTURE} bytes"
    yield from stray_stops(lab, handout)
    said = squeezed(handout.replace("//", ""))
    for line in set(solution_lines(lab)):
        if line in said:
            yield f"a line of the solution: {line}"


def main():
    found = [f"{lab.relative_to(ROOT)}/README.md: {problem}"
             for lab in sorted(p.parent for p in ROOT.glob("labs/*/lab.json"))
             for problem in problems(lab)]
    print("\n".join(found) or "handouts: headings, pictures and secrets in order")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
