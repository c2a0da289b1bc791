"""Parameters, described once, and where they are kept: files, folders, the user's settings."""
