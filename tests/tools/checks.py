"""Counts what the tools here check."""

import threading

passed = failed = 0
# Pages are checked side by side.
counting = threading.Lock()


def check(what, ok, detail=""):
    global passed, failed
    with counting:
        if ok:
            passed += 1
        else:
            failed += 1
            print(f"FAILED: {what} {detail}")


def exit_code():
    """Prints the counts; the exit code."""
    print(f"{passed} passed, {failed} failed")
    return 1 if failed else 0
