"""Differences between operating systems: processes, files, names, threads."""
