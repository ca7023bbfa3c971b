"""Laws of the page in a browser: it plays, hears keys, fits a phone and never complains."""

import io

from chromium import Chromium, find_chromium
from made_report import made_order, made_world
import numpy as np
from PIL import Image
import pytest

from socialnav_core.viewing.report import report_page

READOUT = 'document.getElementById("readout").textContent'


@pytest.mark.skipif(find_chromium() is None, reason='no Chromium is installed')
def test_a_browser_plays_the_page_without_complaint(tmp_path):
    file = tmp_path / 'index.html'
    worlds = [made_world('circle', 4, 2), made_world('simple', 4, 2)]
    file.write_text(report_page(worlds, [], made_order()), encoding='utf-8')
    with Chromium(tmp_path / 'profile') as browser:
        browser.look(1200, 900)
        browser.open(file)
        check_keyboard(browser)
        check_buttons(browser)
        check_pictures(browser)
        for width in (1200, 360):
            for dark in (False, True):
                check_look(browser, width, dark)
        assert browser.complaints == []


def check_keyboard(browser):
    """Drive the player by keys alone."""
    browser.value('document.getElementById("canvas").focus()')
    for key, code, step in (('ArrowRight', 39, 1), ('ArrowRight', 39, 2), ('ArrowLeft', 37, 1)):
        browser.press(key, code)
        assert f'step {step} of' in browser.value(READOUT)
    browser.press('End', 35)
    last = browser.value('document.getElementById("time").max')
    assert f'step {last} of {last}' in browser.value(READOUT)
    browser.press('Home', 36)
    browser.press(' ', 32)
    browser.wait_for('document.getElementById("play").getAttribute("aria-pressed") === "true"')
    browser.wait_for(f'!{READOUT}.includes("step 0 of")')
    browser.press(' ', 32)
    assert browser.value('document.getElementById("play").textContent').endswith('Play')


def check_buttons(browser):
    """Load every episode; its title must be that of its button."""
    count = browser.value('document.querySelectorAll(".episode").length')
    assert count > 2
    for number in range(count):
        button = f'document.querySelectorAll(".episode")[{number}]'
        browser.value(f'{button}.click()')
        words = browser.value(f'{button}.getAttribute("aria-label")').split(': ')[-1]
        title = browser.value('document.getElementById("title").textContent')
        assert title.endswith(words)
        assert browser.value(f'{button}.dataset.command') == browser.value(
            'document.getElementById("command").textContent'
        )


def check_pictures(browser):
    """See that the robot is drawn where it is: the canvas changes with the time."""
    drawn = 'document.getElementById("canvas").toDataURL()'
    browser.value('document.getElementById("canvas").focus()')
    before = browser.value(drawn)
    browser.press('ArrowRight', 39)
    assert browser.value(drawn) != before
    assert browser.value('[...document.images].every((image) => image.naturalWidth > 0)')


def check_look(browser, width, dark):
    """See that nothing reaches beyond the window, and that the ground is light or dark."""
    browser.look(width, 800, dark)
    assert browser.value('document.documentElement.scrollWidth') <= width
    assert browser.value('document.getElementById("canvas").clientWidth') > 0.4 * min(width, 720)
    pixels = np.asarray(Image.open(io.BytesIO(browser.picture())).convert('L'))
    assert (np.median(pixels) < 80) == dark
