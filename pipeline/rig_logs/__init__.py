"""Raw logs of test rigs: one reader per format, run in a guarded child process."""

from pipeline.rig_logs.guarded import read_recording
from pipeline.rig_logs.recording import RecordedChannel, Recording
from pipeline.rig_logs.source import CsvOptions, Limits

__all__ = ["CsvOptions", "Limits", "RecordedChannel", "Recording", "read_recording"]
