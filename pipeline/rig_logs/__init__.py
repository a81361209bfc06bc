"""Raw logs of test rigs: one reader per format, run in a guarded child process."""

from .guarded import RecordedChannel, Recording, read_recording
from .source import CsvOptions, Limits

__all__ = ["CsvOptions", "Limits", "RecordedChannel", "Recording", "read_recording"]
