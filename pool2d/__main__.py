"""`python -m pool2d`."""

import sys
from pathlib import Path

# Started beside a folder that is called pool2d too, as a clone is, Python takes that for the package.
if getattr(sys.modules.get("pool2d"), "__file__", None) is None:
    sys.modules.pop("pool2d", None)
    sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from pool2d.cli import main

if __name__ == "__main__":
    sys.exit(main())
