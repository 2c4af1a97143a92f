"""Counts what the tools here test.

A test is a subject with all that is asserted of it, as a test of Rust is: `check("docs/api.md: a link", …)` is part
of the test of `docs/api.md`. Its name is what stands before the first colon.
"""

import threading

# Whether all checks of a test hold.
tests = {}
# Pages are checked side by side.
counting = threading.Lock()


def check(what, ok, detail=""):
    test = what.split(": ")[0]
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
