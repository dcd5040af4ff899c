#!/usr/bin/env python3
"""Holds the handouts of all labs to what lab.json and the sources say.

    python3 tools/figures/check_handouts.py

Every task's section stands under the heading that `raylab check` names, every picture shown is
there and small, and no line of a solution stands in a handout. Ends with 1 and a list if not.
"""
import json
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
LARGEST_PICTURE = 80_000  # bytes
SHORTEST = 28  # characters of a line that gives something away, as in grader/course/release.cpp


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
