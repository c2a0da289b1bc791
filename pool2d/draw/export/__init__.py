"""Pictures and animations of a shot as files, without a window."""
