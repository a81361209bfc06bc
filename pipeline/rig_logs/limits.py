"""What reading one raw log may cost."""

from dataclasses import dataclass

MEGABYTE = 1 << 20


@dataclass(frozen=True)
class Limits:
    """Bounds on the child process that parses a raw log.

    Attributes
    ----------
    memory_bytes : int
        Address space of the child (RLIMIT_AS), libraries included.
    processor_seconds : int
        Processor time of the child (RLIMIT_CPU); a hung child is ended after ten times that.
    data_bytes : int
        Most bytes of samples, in float64, that are taken from one log.
    expansion : float
        Most bytes of samples per byte of file, unless they are fewer than `small_bytes`: a constant signal
        compresses a thousandfold, and so does a bomb.
    small_bytes : int
        Samples of fewer bytes than this are taken however well they were compressed.
    """

    memory_bytes: int = 12_288 * MEGABYTE
    processor_seconds: int = 300
    data_bytes: int = 8_192 * MEGABYTE
    expansion: float = 200.0
    small_bytes: int = 256 * MEGABYTE

    def largest(self, file_bytes: int) -> int:
        """Most bytes of samples that a file of that size may declare."""
        return min(self.data_bytes, max(self.small_bytes, int(self.expansion * file_bytes)))
