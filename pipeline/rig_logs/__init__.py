"""Raw logs of test rigs: one reader per format, run in a guarded child process."""

from .guarded import read_recording
from .recording import RecordedChannel, Recording
from .source import CsvOptions, Limits

__all__ = ["CsvOptions", "Limits", "RecordedChannel", "Recording", "read_recording"]
