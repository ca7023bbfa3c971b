"""Packaging of socialnav_core; pip and colcon both read this file."""

from setuptools import find_packages, setup

setup(
    name='socialnav_core',
    version='0.1.0',
    description='Robots that move among people: crowd simulator, value networks, offline trainer',
    license='Apache-2.0',
    maintainer='socialnav developers',
    maintainer_email='socialnav@example.com',
    packages=find_packages(include=['socialnav_core', 'socialnav_core.*']),
    package_data={
        'socialnav_core': [
            'config/recipes/*.yaml',
            'config/recipes/prediction/*.yaml',
            'viewing/ros2msg.txt',
        ]
    },
    data_files=[
        ('share/ament_index/resource_index/packages', ['socialnav_core/resource/socialnav_core']),
        ('share/socialnav_core', ['package.xml']),
    ],
    install_requires=['setuptools'],
    extras_require={'test': ['pytest']},
    entry_points={'console_scripts': ['socialnav = socialnav_core.cli:main']},
    zip_safe=False,
)
