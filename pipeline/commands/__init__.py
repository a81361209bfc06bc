"""The commands of `debist`, one file per group, with the console output and the error boundary that they share."""
