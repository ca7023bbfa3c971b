"""The nodes as processes for some episodes, with a summary, a picture and a bag."""
