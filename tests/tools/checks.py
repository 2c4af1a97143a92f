"""Counts what the tools here check."""

passed = failed = 0


def check(what, ok, detail=""):
    global passed, failed
    if ok:
        passed += 1
    else:
        failed += 1
        print(f"FAILED: {what} {detail}")


def exit_code():
    """Prints the counts; the exit code."""
    print(f"{passed} passed, {failed} failed")
    return 1 if failed else 0
