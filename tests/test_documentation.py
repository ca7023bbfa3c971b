"""Laws of the pages and of the files for GitHub: what they name is there."""

import json
from pathlib import Path
import re
import subprocess

import pytest
import yaml

ROOT = Path(__file__).parents[1]
NODES = ROOT / 'ros_ws' / 'src' / 'socialnav' / 'socialnav'
NODES = ROOT / 'ros_ws' / 'src' / 'socialnav' / 'socialnav'
ARCHITECTURE = (ROOT / 'docs' / 'architecture.md').read_text()
LINK = re.compile(r'\]\(([^)\s]+)\)')
FRAGMENTS = 'notes'
"""Folder of texts that become parts of the pages beside it."""
PARTS = ('models', 'tests', 'docs', 'studies/founding_report', '.github', 'ros_ws/wheels')
"""Folders that the page describes together with all that they hold."""
INSIDE = re.compile(r'/(config|data|launch|msg|recipes|resource|rviz|srv|test)(/|$)')
"""Folders of data and tests; what holds them says what they are."""
EXPLAINED = re.compile(r'socialnav_core/config$')


def tracked(*patterns):
    """Return the files that git knows, and new ones that it would take, as paths from the root."""
    command = ['git', 'ls-files', '-co', '--exclude-standard', *patterns]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True)
    if done.returncode:
        pytest.skip('the sources are no git repository here')
    return [Path(name) for name in done.stdout.splitlines() if (ROOT / name).exists()]


def headings(text):
    """Return the anchors of a page as GitHub makes them."""
    titles = re.findall(r'^#+ (.+)$', text, re.MULTILINE)
    return {re.sub(r'[^\w\- ]', '', title.lower()).replace(' ', '-') for title in titles}


def test_every_relative_link_of_every_page_leads_somewhere():
    pages = [page for page in tracked('*.md') if page.parent.name != FRAGMENTS]
    assert len(pages) > 10
    for page in pages:
        for link in LINK.findall((ROOT / page).read_text()):
            target, _, anchor = link.partition('#')
            if re.match(r'\w+:', target):
                continue
            file = (ROOT / page).parent / target if target else ROOT / page
            assert file.exists(), (page, link)
            assert not anchor or anchor in headings(file.read_text()), (page, link)


def test_the_map_of_the_architecture_has_every_folder_and_no_other():
    listed = re.findall(r'^\| `([^`]+)/` \|', ARCHITECTURE, re.MULTILINE)
    folders = {path.parent.as_posix() for path in tracked()} - {'.', 'ros_ws'}
    for part in PARTS:
        folders = {part if f'{name}/'.startswith(f'{part}/') else name for name in folders}
    folders = {name for name in folders if not INSIDE.search(name) or EXPLAINED.search(name)}
    assert sorted(listed) == sorted(folders)


def test_the_table_of_folders_in_the_readme_names_folders_that_exist():
    table = (ROOT / 'README.md').read_text().split('| folder | what is there |')[1]
    rows = table.split('\n\n')[0].splitlines()[2:]
    names = [name for row in rows for name in re.findall(r'`([\w./]+)/`', row.split('|')[1])]
    assert len(names) > 5
    assert all((ROOT / name).is_dir() for name in names)


def test_the_paths_through_the_code_name_functions_that_exist():
    rows = re.findall(r'^\| .* \| `([\w/]+\.py)` \| `(\w+)` \|$', ARCHITECTURE, re.MULTILINE)
    assert len(rows) > 20
    for file, name in rows:
        folder = ROOT if file.startswith('socialnav_core/') else NODES
        assert re.search(rf'(def|class) {name}\b', (folder / file).read_text()), (file, name)


def test_every_yaml_and_json_file_can_be_read():
    files = tracked('*.yaml', '*.yml', '*.cff')
    assert len(files) > 20
    for file in files:
        assert yaml.safe_load((ROOT / file).read_text()) is not None, file
    json.loads((ROOT / '.devcontainer' / 'devcontainer.json').read_text())


def test_github_runs_what_can_be_typed_here():
    workflow = yaml.safe_load((ROOT / '.github' / 'workflows' / 'ci.yml').read_text())
    jobs = workflow['jobs'].values()
    commands = [step['run'] for job in jobs for step in job['steps'] if 'run' in step]
    targets = re.findall(r'^([a-z-]+):', (ROOT / 'Makefile').read_text(), re.MULTILINE)
    assert {'make lint', 'make test'} == set(commands)
    assert {command.split()[1] for command in commands} <= set(targets)
    assert all(job['runs-on'] == 'ubuntu-24.04' for job in jobs)
    assert all('uses' in step or 'run' in step for job in jobs for step in job['steps'])


def test_the_container_to_develop_in_ends_in_the_tests():
    container = json.loads((ROOT / '.devcontainer' / 'devcontainer.json').read_text())
    assert container['postCreateCommand'] == 'make test'
    assert container['image'].endswith(':ubuntu-24.04')


def test_the_templates_of_issues_ask_for_something():
    for file in (ROOT / '.github' / 'ISSUE_TEMPLATE').glob('[!c]*.yml'):
        form = yaml.safe_load(file.read_text())
        assert {'name', 'description', 'body'} <= form.keys(), file
        assert all({'type', 'id', 'attributes'} <= field.keys() for field in form['body']), file
