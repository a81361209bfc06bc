"""From samples as they were recorded to uniform records: time bases, gaps, decimation, signal quality."""
