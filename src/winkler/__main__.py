"""``python -m winkler`` is the command ``winkler``."""

import sys

from winkler.cli import main

if __name__ == "__main__":
    sys.exit(main())
