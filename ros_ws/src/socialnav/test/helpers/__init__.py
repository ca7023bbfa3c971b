"""What tests of all folders use."""
