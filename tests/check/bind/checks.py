"""Checks that count what is wrong and print it."""

failed = 0


def check(condition, what):
    global failed
    if not condition:
        failed += 1
        print(f"failed: {what}")


def raises(kind, call, *arguments, status=None, **named):
    """The error that a call raises."""
    try:
        call(*arguments, **named)
    except kind as error:
        check(status is None or error.status == status, f"{call.__name__}: {error}")
        return error
    check(False, f"{call.__name__}{arguments} does not raise {kind.__name__}")
    return None


def run(*parts):
    """Calls each part. 0: nothing is wrong."""
    for part in parts:
        part()
    return int(failed != 0)
