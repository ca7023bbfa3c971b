"""Packaging of the ROS 2 nodes; the trained models of the repository go into the share folder."""

from glob import glob
import os

from setuptools import find_packages, setup

PACKAGE = 'socialnav'
MODELS = os.path.join('..', '..', '..', 'models')


def model_files():
    """Return a (destination, files) pair of each trained model; none where there is no model."""
    pairs = []
    for folder in sorted(glob(os.path.join(MODELS, '*', ''))):
        files = sorted(path for path in glob(f'{folder}*') if os.path.isfile(path))
        name = os.path.basename(os.path.dirname(folder))
        pairs.append((f'share/{PACKAGE}/models/{name}', files))
    return [pair for pair in pairs if pair[1]]


setup(
    name=PACKAGE,
    version='0.1.0',
    packages=find_packages(include=[PACKAGE, f'{PACKAGE}.*']),
    data_files=[
        ('share/ament_index/resource_index/packages', [f'resource/{PACKAGE}']),
        (f'share/{PACKAGE}', ['package.xml']),
        *(
            (f'share/{PACKAGE}/{folder}', sorted(glob(f'{folder}/*.*')))
            for folder in ('config', 'launch', 'rviz')
        ),
        *model_files(),
    ],
    install_requires=['setuptools'],
    extras_require={'test': ['pytest']},
    zip_safe=True,
    maintainer='socialnav developers',
    maintainer_email='socialnav@example.com',
    description='Drives a robot among pedestrians and simulates a crowd to drive in.',
    license='Apache-2.0',
    entry_points={
        'console_scripts': [
            'demo = socialnav.programs:demo',
            'obstacle_node = socialnav.programs:obstacle_node',
            'policy_node = socialnav.programs:policy_node',
            'simulator_node = socialnav.programs:simulator_node',
            'tracker_node = socialnav.programs:tracker_node',
        ],
    },
)
