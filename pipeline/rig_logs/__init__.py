"""Raw logs of test rigs: one reader per format, run in a guarded child process."""

from pipeline.rig_logs.guarded import read_recording
from pipeline.rig_logs.recording import Channel, Recording
from pipeline.rig_logs.source import CsvOptions, Limits

__all__ = ["Channel", "CsvOptions", "Limits", "Recording", "read_recording"]
