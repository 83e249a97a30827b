"""Executors of `concurrent.futures` over schedulers that have none of their own."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import Executor, Future
from typing import Any

from ._table import optional


class RayExecutor(Executor):
    """Tasks on Ray, for `study.run()` and whatever else takes an executor of `concurrent.futures`:

        ray.init(address="auto")
        with physim.RayExecutor() as executor:
            result = study.run(executor)

    Ray must be installed; without a `ray.init()` it starts on this machine. If a worker dies, Ray gives its tasks to
    another one. Options are those of `ray.remote()`: `num_cpus=1` of each task, `max_retries=3`. It does not end Ray.
    """

    def __init__(self, **options: Any) -> None:
        ray = optional("ray")
        self._cancel = ray.cancel
        self._call = ray.remote(**{"num_cpus": 1, "max_retries": 3, **options})(_called)
        self._tasks: dict[Future[Any], Any] = {}
        self._is_shut = False

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        """A call on one of Ray's workers."""
        if self._is_shut:
            raise RuntimeError("cannot schedule new futures after shutdown")
        task = self._call.remote(fn, args, kwargs)
        future: Future[Any] = task.future()
        self._tasks[future] = task
        future.add_done_callback(lambda done: self._tasks.pop(done, None))
        return future

    def shutdown(self, wait: bool = True, *, cancel_futures: bool = False) -> None:
        """No more calls are taken; waits for those that run."""
        self._is_shut = True
        tasks = list(self._tasks.items())
        for future, task in tasks if cancel_futures else ():
            future.cancel()
            self._cancel(task)
        for future, _ in tasks if wait else ():
            if not future.cancelled():
                future.exception()


def _called(function: Callable[..., Any], args: tuple[Any, ...], kwargs: dict[str, Any]) -> Any:
    return function(*args, **kwargs)
