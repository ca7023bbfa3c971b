"""The founding report's tables and figures again: trained, measured, set beside ours."""
