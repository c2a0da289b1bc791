"""How fast pool2d is: `python -m benchmarks.speed`."""
