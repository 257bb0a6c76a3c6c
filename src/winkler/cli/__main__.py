"""``python -m winkler.cli`` is the command ``winkler``."""

import sys

from winkler.__main__ import main

if __name__ == "__main__":
    sys.exit(main())
