"""The tests of pool2d."""
