"""The time of a call."""

import time
from collections.abc import Callable


def seconds(work: Callable[[], object], least: float = 0.2) -> float:
    """The shortest of five means."""
    number = 1
    while True:
        start = time.perf_counter()
        for _ in range(number):
            work()
        if time.perf_counter() - start > least / 5:
            break
        number *= 2
    best = float("inf")
    for _ in range(5):
        start = time.perf_counter()
        for _ in range(number):
            work()
        best = min(best, (time.perf_counter() - start) / number)
    return best
