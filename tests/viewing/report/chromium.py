"""A headless Chromium that is told what to do through a pipe, so that no network is involved."""

import base64
import itertools
import json
import os
from pathlib import Path
import select
import shutil
import subprocess
import time

NAMES = ('chromium', 'chromium-browser', 'google-chrome')
PATIENCE = 120.0  # s; a busy machine may need a while to start a browser


def find_chromium():
    """Return the command of an installed Chromium, None without one."""
    return next(filter(None, map(shutil.which, NAMES)), None)


class Chromium:
    """One page of a browser, and what it complained of."""

    def __init__(self, folder: Path):
        """
        Start the browser.

        :param folder: for its profile.
        """
        read_command, self._commands = os.pipe()
        self._answers, write_answer = os.pipe()
        self._numbers, self._buffer, self.complaints = itertools.count(1), b'', []
        self._deadline = time.monotonic() + PATIENCE
        switches = [
            '--headless=new',
            '--no-sandbox',
            '--disable-gpu',
            '--disable-dev-shm-usage',
            '--no-first-run',
            '--remote-debugging-pipe',
            f'--user-data-dir={folder}',
        ]
        script = f'exec 3<&{read_command} 4>&{write_answer}; exec "$@"'
        self._process = subprocess.Popen(
            ['bash', '-c', script, 'bash', find_chromium(), *switches, 'about:blank'],
            pass_fds=(read_command, write_answer), stderr=subprocess.DEVNULL,
        )  # fmt: skip
        os.close(read_command)
        os.close(write_answer)
        self._session = None
        [page] = [
            target
            for target in self.send('Target.getTargets')['targetInfos']
            if target['type'] == 'page'
        ]
        attached = self.send('Target.attachToTarget', targetId=page['targetId'], flatten=True)
        self._session = attached['sessionId']
        for domain in ('Page', 'Runtime', 'Log', 'Network'):
            self.send(f'{domain}.enable')

    def __enter__(self):
        return self

    def __exit__(self, *error):
        self._process.terminate()
        self._process.wait(30)
        os.close(self._commands)
        os.close(self._answers)

    def send(self, method, **parameters):
        """Give a command and return its answer."""
        number = next(self._numbers)
        message = {'id': number, 'method': method, 'params': parameters}
        if self._session:
            message['sessionId'] = self._session
        os.write(self._commands, json.dumps(message).encode() + b'\0')
        while True:
            answer = self._receive()
            if answer.get('id') == number:
                assert 'error' not in answer, answer
                return answer['result']

    def _receive(self):
        """Return the next message; keep what the page complained of."""
        while b'\0' not in self._buffer:
            left = self._deadline - time.monotonic()
            assert left > 0 and select.select([self._answers], [], [], left)[0], 'no answer'
            self._buffer += os.read(self._answers, 2**20)
        text, _, self._buffer = self._buffer.partition(b'\0')
        message = json.loads(text)
        kind, parameters = message.get('method', ''), message.get('params', {})
        told = kind == 'Runtime.consoleAPICalled' and parameters['type'] in ('error', 'warning')
        if told or kind in ('Runtime.exceptionThrown', 'Log.entryAdded'):
            self.complaints.append(parameters)
        elif kind == 'Network.requestWillBeSent':
            address = parameters['request']['url']
            if not address.startswith(('file:', 'data:', 'about:')):
                self.complaints.append(address)
        return message

    def open(self, path: Path):
        """Load a file and wait until its scripts have run."""
        self.send('Page.navigate', url=path.as_uri())
        self.wait_for('document.readyState === "complete" && location.protocol === "file:"')

    def value(self, expression):
        """Return the value of an expression of the page."""
        answer = self.send('Runtime.evaluate', expression=expression, returnByValue=True,
                           awaitPromise=True)  # fmt: skip
        assert 'exceptionDetails' not in answer, answer
        return answer['result'].get('value')

    def wait_for(self, expression):
        """Wait until an expression of the page is true."""
        while not self.value(expression):
            assert time.monotonic() < self._deadline, expression
            time.sleep(0.05)

    def press(self, key, code=0):
        """Press a key and let it go."""
        text = {'text': key} if len(key) == 1 else {}
        for kind in ('keyDown', 'keyUp'):
            self.send('Input.dispatchKeyEvent', type=kind, key=key,
                      windowsVirtualKeyCode=code or ord(key[0]), **text)  # fmt: skip
            text = {}

    def look(self, width, height, dark=False):
        """Set the size of the window, in pixels, and the scheme of colours."""
        self.send('Emulation.setDeviceMetricsOverride', width=width, height=height,
                  deviceScaleFactor=1, mobile=width < 600)  # fmt: skip
        scheme = {'name': 'prefers-color-scheme', 'value': 'dark' if dark else 'light'}
        self.send('Emulation.setEmulatedMedia', features=[scheme])

    def picture(self, whole=False):
        """Return a PNG of what is seen, or of the whole page."""
        answer = self.send('Page.captureScreenshot', captureBeyondViewport=whole)
        return base64.b64decode(answer['data'])
