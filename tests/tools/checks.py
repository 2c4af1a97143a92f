"""Counts what the tools here test.

A test is a function with its subject and all that it asserts of it, as a test of Rust is: each
`check("docs/api.md: a link", …)` of a function is part of its test of `docs/api.md`. The subject is what stands before
the first colon.
"""

import sys
import threading

# Whether all checks of a test hold.
tests = {}
# Pages are checked side by side.
counting = threading.Lock()
# Functions that only pass a check on.
PASSED_ON = ("check", "passes", "__call__", "between")


def check(what, ok, detail=""):
    frame = sys._getframe(1)
    while frame.f_code.co_name in PASSED_ON:
        frame = frame.f_back
    test = (frame.f_code.co_filename, frame.f_code.co_name, what.split(": ")[0])
    with counting:
        tests[test] = tests.get(test, True) and bool(ok)
        if not ok:
            print(f"FAILED: {what} {detail}")


def failed():
    """Number of tests that failed."""
    return sum(not ok for ok in tests.values())


def exit_code():
    """Prints the counts; the exit code."""
    print(f"{len(tests) - failed()} passed, {failed()} failed")
    return 1 if failed() else 0
