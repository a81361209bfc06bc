"""What a model or a log says of the device: wells, barriers, basins, ring-downs, the datasheet, the verdict."""
