"""What differs between systems: processes, files, names, threads."""
