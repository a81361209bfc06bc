"""Is a log what the settings say: sides, delays, time base, scale and device, before anything is fitted."""
