"""Drives a headless Chromium by its DevTools protocol over two pipes. Only the standard library."""
import json
import os
import select
import subprocess
import time


class Chromium:
    """One browser with one tab. Console errors and exceptions are kept in errors."""

    def __init__(self, program, profile):
        self.errors = []
        self.number = 0
        to_read, self.write_end = os.pipe()
        self.read_end, to_write = os.pipe()

        def take_pipes():
            # Chromium reads commands from 3 and writes answers to 4. The ends may have these numbers already.
            reads, writes = os.dup(to_read), os.dup(to_write)
            os.dup2(reads, 3)
            os.dup2(writes, 4)

        self.process = subprocess.Popen(
            [program, '--headless=new', '--no-sandbox', '--disable-gpu', '--disable-dev-shm-usage', '--no-first-run',
             '--mute-audio', '--hide-scrollbars', '--force-device-scale-factor=1', '--remote-debugging-pipe',
             '--user-data-dir=' + profile, 'about:blank'],
            close_fds=False, preexec_fn=take_pipes, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL)
        os.close(to_read)
        os.close(to_write)
        self.buffer = b''
        self.session = None
        targets = self.send('Target.getTargets')['targetInfos']
        page = next(target for target in targets if target['type'] == 'page')
        self.session = self.send('Target.attachToTarget', targetId=page['targetId'], flatten=True)['sessionId']
        for domain in ('Page', 'Runtime', 'Log'):
            self.send(domain + '.enable')

    def close(self):
        self.session = None
        try:
            self.send('Browser.close')
            self.process.wait(10)
        except (OSError, RuntimeError, subprocess.TimeoutExpired):
            self.process.kill()
            self.process.wait()

    def receive(self, timeout):
        """The next message; None after so many seconds."""
        end = time.monotonic() + timeout
        while b'\0' not in self.buffer:
            ready, _, _ = select.select([self.read_end], [], [], max(0, end - time.monotonic()))
            if not ready:
                return None
            piece = os.read(self.read_end, 1 << 20)
            if piece == b'':
                raise RuntimeError('Chromium has ended')
            self.buffer += piece
        text, self.buffer = self.buffer.split(b'\0', 1)
        message = json.loads(text)
        self.note(message)
        return message

    def note(self, message):
        method, params = message.get('method'), message.get('params', {})
        if method == 'Runtime.exceptionThrown':
            details = params['exceptionDetails']
            self.errors.append(details.get('exception', {}).get('description', details['text']))
        elif method == 'Runtime.consoleAPICalled' and params['type'] in ('error', 'warning', 'assert'):
            self.errors.append(' '.join(str(a.get('value', a.get('description'))) for a in params['args']))
        elif method == 'Log.entryAdded' and params['entry']['level'] in ('error', 'warning'):
            self.errors.append(params['entry']['text'])

    def send(self, method, **params):
        self.number += 1
        message = {'id': self.number, 'method': method, 'params': params}
        if self.session is not None:
            message['sessionId'] = self.session
        os.write(self.write_end, json.dumps(message).encode() + b'\0')
        while True:
            answer = self.receive(60)
            if answer is None:
                raise RuntimeError(method + ': no answer')
            if answer.get('id') == self.number:
                if 'error' in answer:
                    raise RuntimeError(method + ': ' + answer['error']['message'])
                return answer['result']

    def open(self, address):
        self.send('Page.navigate', url=address)

    def run(self, script):
        """The value of an expression in the page; a promise is awaited."""
        result = self.send('Runtime.evaluate', expression=script, awaitPromise=True, returnByValue=True)
        if 'exceptionDetails' in result:
            details = result['exceptionDetails']
            raise RuntimeError(details.get('exception', {}).get('description', details['text']))
        return result['result'].get('value')

    def wait(self, script, seconds=30):
        """Waits until an expression is true."""
        end = time.monotonic() + seconds
        while not self.run(script):
            if time.monotonic() > end:
                raise RuntimeError('never true: ' + script)
            time.sleep(0.05)

    def key(self, key):
        code = {'ArrowLeft': 37, 'ArrowUp': 38, 'ArrowRight': 39, 'ArrowDown': 40, 'Tab': 9, 'Enter': 13, ' ': 32,
                'Escape': 27, 'Home': 36, 'End': 35}.get(key, ord(key[0].upper()))
        text = {'Enter': '\r'}.get(key, key if len(key) == 1 else '')
        self.send('Input.dispatchKeyEvent', type='keyDown' if text else 'rawKeyDown', key=key, text=text,
                  windowsVirtualKeyCode=code)
        self.send('Input.dispatchKeyEvent', type='keyUp', key=key, windowsVirtualKeyCode=code)

    def mouse(self, kind, x, y):
        self.send('Input.dispatchMouseEvent', type=kind, x=x, y=y, button='left',
                  buttons=0 if kind == 'mouseReleased' else 1, clickCount=1, pointerType='mouse')

    def drag(self, start, end, steps=5):
        self.send('Input.dispatchMouseEvent', type='mouseMoved', x=start[0], y=start[1])
        self.mouse('mousePressed', *start)
        for i in range(1, steps + 1):
            self.mouse('mouseMoved', *(p + (q - p) * i / steps for p, q in zip(start, end)))
        self.mouse('mouseReleased', *end)

    def click(self, x, y):
        self.drag((x, y), (x, y), 1)

    def touch(self, kind, *point):
        self.send('Input.dispatchTouchEvent', type=kind, touchPoints=[{'x': point[0], 'y': point[1]}] if point else [])

    def touch_drag(self, start, end, steps=5):
        """One finger, as on a phone; needs touches()."""
        self.touch('touchStart', *start)
        for i in range(1, steps + 1):
            self.touch('touchMove', *(p + (q - p) * i / steps for p, q in zip(start, end)))
        self.touch('touchEnd')

    def touches(self, on):
        self.send('Emulation.setTouchEmulationEnabled', enabled=on, maxTouchPoints=1)

    def size(self, width, height, mobile=False):
        self.send('Emulation.setDeviceMetricsOverride', width=width, height=height, deviceScaleFactor=1, mobile=mobile)

    def theme(self, theme):
        self.send('Emulation.setEmulatedMedia', features=[{'name': 'prefers-color-scheme', 'value': theme}])

    def picture(self, name):
        import base64
        data = self.send('Page.captureScreenshot', format='png')['data']
        with open(name, 'wb') as file:
            file.write(base64.b64decode(data))
