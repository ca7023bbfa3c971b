"""Packaging of the study: installed beside socialnav_core it adds `socialnav reproduce`."""

from setuptools import find_packages, setup

setup(
    name='socialnav-founding-report',
    version='0.1.0',
    description="The founding report's tables and figures again, with ours beside them",
    license='Apache-2.0',
    packages=find_packages(include=['founding_report']),
    install_requires=['socialnav_core'],
    entry_points={'socialnav.commands': ['reproduce = founding_report.command']},
    zip_safe=False,
)
