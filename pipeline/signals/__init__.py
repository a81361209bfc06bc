"""Raw samples to uniform records with derivatives: time bases, gaps, decimation, quality, differentiation."""
