"""From scans, grids and detections to obstacles and pedestrians."""
