"""Facts of the device from a model or a log: wells, barriers, basins, ring-downs, the datasheet, the assessment."""
