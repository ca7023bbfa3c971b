"""Speed of the simulator, of decisions and of training, beside a plain reference."""
