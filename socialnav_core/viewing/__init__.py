"""Episodes kept step by step, and shown: pictures, films and bags."""

from socialnav_core.viewing.recording import record, Recording

__all__ = ['Recording', 'record']
