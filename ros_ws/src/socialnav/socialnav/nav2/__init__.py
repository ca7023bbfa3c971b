"""What nav2 calls, and is told, where its packages are installed."""
