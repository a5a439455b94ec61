"""A control loop of three joints that run after the goals of the page. Usage: own_loop.py FOLDER PORT; FOLDER has _show.py."""

import sys
import time

sys.path.insert(0, sys.argv[1])
from _show import Show  # noqa: E402

q = [0.2, 0.4, 0.6]
with Show(nq=3, nv=3, port=int(sys.argv[2])) as page:
    print("listens", flush=True)
    while True:
        was_enabled = page.enabled
        before, step = q, 0.1 if page.receive() else 0
        if was_enabled != page.enabled:
            print("enabled" if page.enabled else "stopped", flush=True)
        q = [at + step * (goal - at) for at, goal in zip(q, page.q or q)]
        page.send(q, [(now - then) / 5e-3 for now, then in zip(q, before)], [1, 2, 3], error=max(page.q or q) - max(q))
        time.sleep(5e-3)
