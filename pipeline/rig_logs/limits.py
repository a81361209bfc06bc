"""What reading one raw log may cost."""

from dataclasses import dataclass

MEGABYTE = 1 << 20


@dataclass(frozen=True)
class Limits:
    """Bounds on the child process that parses a raw log.

    Attributes
    ----------
    memory_bytes : int
        Most address space of the child (RLIMIT_AS), libraries included.
    processor_seconds : int
        Most processor time of the child (RLIMIT_CPU); a hung child is ended after ten times what its file may take.
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

    def memory(self, file_bytes: int) -> int:
        """Address space for a file of that size: the libraries' 3 GB, and four times the samples it may declare."""
        return min(self.memory_bytes, 3072 * MEGABYTE + 4 * self.largest(file_bytes))

    def seconds(self, file_bytes: int) -> int:
        """Processor time for a file of that size: 20 s, and one per MB, ten times what the slowest format takes."""
        return min(self.processor_seconds, 20 + file_bytes // MEGABYTE)
