"""The entry point of the command ``winkler`` and of ``python -m winkler``.

Nothing but the interpreter's own modules is imported before signals are handled: a Ctrl-C while the rest is loaded ends
the process at once, without a traceback.
"""

import sys


def main() -> int:
    """Run the command of this process and end it with its exit code, which is returned after an interrupt alone."""
    try:
        import os
        import signal

        def leave(number: int, frame: object) -> None:
            """End at once: nothing is open yet, and an interrupt that is raised in an import may be lost."""
            try:
                os.write(2, b"winkler: interrupted; nothing was written.\n")
            finally:
                os._exit(130)

        usual = signal.getsignal(signal.SIGINT) is signal.default_int_handler
        if usual:
            signal.signal(signal.SIGINT, leave)
        import gc

        gc.set_threshold(300_000)  # loaded modules stay: searching them for garbage takes a tenth of a short run
        os.environ.setdefault("PYDANTIC_DISABLE_PLUGINS", "__all__")  # sought in all that is installed; none is used
        os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")  # matrices are small: threads cost more than they save
        from winkler.cli import main as command

        if usual:
            signal.signal(signal.SIGINT, signal.default_int_handler)  # which `winkler.io.processes.stopping` replaces
        code = command()
        import atexit
        import threading

        # as Python ends, but for taking apart what was loaded: that would take a twentieth of a short run
        threading._shutdown()  # type: ignore[attr-defined]
        atexit._run_exitfuncs()
        os._exit(code)
    except KeyboardInterrupt:
        return 130


if __name__ == "__main__":
    sys.exit(main())
