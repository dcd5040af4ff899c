#!/usr/bin/env python3
"""Holds every Markdown page to the tree that it stands in, and to each tree that students get.

    check_guides.py TREE --programs build/cpu/app/raylab build/cpu/app/course/raylab-check ...

Commands exist with their options, labs, tasks, scenes and files; links lead to files and headings; API sheets name
what the headers have. raylab-check writes the students' trees into a temporary folder. Ends with 1 and a list if not.
"""
import argparse
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
from commands import Commands, false_commands  # noqa: E402
from links import broken_links, unknown_names  # noqa: E402


def problems(tree, released, commands):
    yield from broken_links(tree)
    yield from unknown_names(tree)
    yield from false_commands(tree, released, commands)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("tree", type=pathlib.Path)
    parser.add_argument("--programs", nargs="+", required=True)
    options = parser.parse_args()
    tree, commands = options.tree.resolve(), Commands(options.programs)
    found = list(problems(tree, False, commands))
    # In memory where that is possible: release waits for the disk after each of some thousand files.
    memory = "/dev/shm"
    if not os.access(memory, os.W_OK) or shutil.disk_usage(memory).free < 1 << 30:
        memory = None
    with tempfile.TemporaryDirectory(dir=memory) as folder:
        check = next(program for program in options.programs if program.endswith("raylab-check"))
        release = [check, "release", "-o", folder, "--no-build", "--give-away"]
        done = subprocess.run(release, cwd=tree, capture_output=True, text=True)
        if done.returncode != 0:
            found.append(f"release ended with {done.returncode}: {done.stdout}{done.stderr}")
        trees = sorted(path for path in pathlib.Path(folder).iterdir() if path.is_dir())
        for student in trees:
            found += [f"released {student.name}: {problem}" for problem in problems(student, True, commands)]
    print("\n".join(found) or f"pages: commands, links and names hold, here and in {len(trees)} released trees")
    return 1 if found or not trees else 0


if __name__ == "__main__":
    sys.exit(main())
