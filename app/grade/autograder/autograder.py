#!/usr/bin/env python3
"""Checks lab @LAB@ in a student's checkout, as Classroom 50 runs it.

    autograder.py [LIMIT]      LIMIT: seconds for the whole check

It writes result.json and release-body.md and ends with exit code 0 if the lab was checked, whether it passed or
not. Else it ends with exit code 1 and leaves neither file, so that nothing is published.
"""
import json
import os
import signal
import subprocess
import sys

RESULT, BODY = "result.json", "release-body.md"


def remove(*names):
    for name in names:
        if os.path.lexists(name):
            os.remove(name)


def check(limit):
    """What has gone wrong; None if the lab was checked."""
    command = ["./raylab", "check", "@LAB@", "--write", "classroom50:" + RESULT, "--write", "summary:" + BODY]
    try:
        # A session of its own, so that its children can be ended with it.
        process = subprocess.Popen(command, stdin=subprocess.DEVNULL, start_new_session=True)
    except OSError as error:
        return f"this checkout has no ./raylab that starts: {error}"
    try:
        status = process.wait(limit)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        process.wait()
        return f"raylab was ended after {limit:g} s"
    if status not in (0, 1):
        return f"raylab ended with exit code {status}"
    try:
        with open(RESULT, encoding="utf-8") as file:
            json.load(file)
    except (OSError, ValueError) as error:
        return f"raylab has left no {RESULT}: {error}"
    return None


def main():
    remove(RESULT, BODY)  # those of the checkout are not ours
    trouble = check(float(sys.argv[1]) if len(sys.argv) > 1 else @LIMIT@)
    if trouble:
        remove(RESULT, BODY)
        print("INTERNAL:", trouble, file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
