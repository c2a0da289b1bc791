"""Play pool: `python main.py`."""

import sys

from pool2d.cli import main

if __name__ == "__main__":
    sys.exit(main())
