"""What `socialnav report` writes: one page with figures, plots and episodes to play."""

from socialnav_core.viewing.report.contents import Order, World
from socialnav_core.viewing.report.page import report_page

__all__ = ['Order', 'World', 'report_page']
