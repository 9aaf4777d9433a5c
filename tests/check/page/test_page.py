"""The page in a headless Chromium: test_page.py BUILD CHROMIUM. Prints what fails, and counts."""
import base64
import glob
import json
import os
import shutil
import subprocess
import sys

from chromium import Chromium

BUILD, PROGRAM = sys.argv[1:3]
PAGE = 'file://' + os.path.abspath(BUILD + '/page/index.html')
counts = {True: 0, False: 0}


def check(what, holds, seen=''):
    counts[bool(holds)] += 1
    if not holds:
        print('failed: %s %s' % (what, seen))


def load(browser, hash_part=''):
    browser.open('about:blank')
    browser.open(PAGE + hash_part)
    browser.wait("document.body?.dataset.gjk !== undefined && document.body.dataset.gjk !== 'loading'")


def test_start(browser):
    load(browser)
    check('the golden hash is the one of all platforms', browser.run('document.body.dataset.gjk') == 'ok')
    check('it is shown', '048919c62155e23e' in browser.run("document.getElementById('golden').textContent"))
    check('the module imports nothing', browser.run(
        "WebAssembly.compile(Uint8Array.from(atob(document.getElementById('wasm').textContent.trim()),"
        "c => c.charCodeAt(0))).then(m => WebAssembly.Module.imports(m).length)") == 0)
    check('one file of less than 1 MB', os.path.getsize(BUILD + '/page/index.html') < 1000000)


QUESTIONS = (('distance', []), ('intersect', ['--intersect']), ('penetration', ['--penetration']),
             ('contacts', ['--contacts', '0.25']), ('cast', ['--cast']), ('impact', ['--impact']))


def test_answers(browser):
    """Every case of tests/data has the same line here and from the host's gjk-query."""
    for name in sorted(glob.glob('tests/data/*.txt')):
        with open(name, encoding='utf-8') as file:
            text = file.read()
        if 'case' not in text:
            continue
        browser.run('window.cases = ' + json.dumps(text))
        for question, options in QUESTIONS:
            # Impacts of all cases take long; those of the files about motion are enough.
            if question == 'impact' and 'motion' not in name:
                continue
            number = 16384 if question == 'contacts' else 0
            here = browser.run("query(window.cases, '%s', %d)" % (question, number))
            host = subprocess.run([BUILD + '/gjk-query', *options, name], stdout=subprocess.PIPE,
                                  stderr=subprocess.DEVNULL, check=False).stdout.decode()
            check('%s of %s: %d lines' % (question, name, host.count('\n')), here == host and host,
                  first_difference(here, host))


LIBRARY = """(async () => {
  const gjk = await gjkLoad(Uint8Array.from(atob('%s'), (c) => c.charCodeAt(0)));
  const crate = gjk.box(32768, 32768, 32768), ball = gjk.sphere(16384), cube = gjk.box(16384, 16384, 16384);
  const corner = gjk.hull([[0, 0, 0], [65536, 0, 0], [0, 65536, 0], [0, 0, 65536]]);
  const refused = [];
  for (const make of [() => gjk.sphere(-1), () => gjk.hull([]), () => gjk.shape(9, [0, 0, 0], 0),
    () => gjk.pose(ball, [0, 0, 0], [0, 0, 0, 5])]) {
    try { make(); refused.push(0); } catch (error) { refused.push(error.status); }
  }
  gjk.pose(ball, [98304, 0, 0]);
  gjk.pose(cube, [98304, 0, 0]);
  gjk.pose(corner, [32768, 0, 0]);
  const before = gjk.bytes().length;
  for (let i = 0; i < 20000; i++) {
    gjk.release(gjk.hull([[i, 0, 0], [65536, 0, 0], [0, 65536, 0], [0, 0, 65536]]));
  }
  return JSON.stringify([gjk.distance(crate, ball), gjk.cast(crate, cube, [-98304, 0, 0]), gjk.intersect(crate, ball),
    gjk.penetration(crate, corner), gjk.contacts(crate, corner, 0), refused, gjk.bytes().length - before]);
})()"""
LIBRARY_SAYS = [
    {'intersecting': False, 'iterations': 3, 'proven': True, 'distance': 49152, 'pointA': [32768, 0, 0],
     'pointB': [81920, 0, 0], 'normal': [1 << 30, 0, 0]},
    {'hit': True, 'fraction': 1 << 28, 'pointA': [32768, 16384, 5461], 'pointB': [32768, 16384, 5461],
     'normal': [1 << 30, 0, 0], 'restB': [49152, 0, 0], 'iterations': 6},
    {'intersecting': False, 'iterations': 0},
    {'intersecting': True, 'iterations': 4, 'proven': True, 'depth': 0, 'pointA': [32768, 16384, 8192],
     'pointB': [32768, 16384, 8192], 'normal': [1 << 30, 0, 0]},
    {'normal': [1 << 30, 0, 0], 'points': [
        {'pointA': [32768, 16384, 8192], 'pointB': [32768, 16384, 8192], 'distance': 0, 'id': 128}]},
]


def test_library(browser):
    """gjk.js with the whole library."""
    with open(BUILD + '/page/gjk.wasm', 'rb') as file:
        said = json.loads(browser.run(LIBRARY % base64.b64encode(file.read()).decode()))
    for here, wanted in zip(said, LIBRARY_SAYS):
        check('gjk.js: an answer', here == wanted, here)
    check('gjk.js: what is refused throws its status', 0 not in said[5] and None not in said[5], said[5])
    check('gjk.js: released memory is used again', said[6] == 0, said[6])


def first_difference(a, b):
    for p, q in zip(a.split('\n'), b.split('\n')):
        if p != q:
            return '\n  page %s\n  host %s' % (p, q)
    return 'lengths %d and %d' % (len(a), len(b))


def main():
    profile = BUILD + '/page-test/profile'
    shutil.rmtree(BUILD + '/page-test', ignore_errors=True)
    os.makedirs(profile)
    browser = Chromium(PROGRAM, os.path.abspath(profile))
    try:
        for test in (test_start, test_library, test_answers):
            test(browser)
        check('no console errors', not browser.errors, browser.errors)
    finally:
        browser.close()
    shutil.rmtree(profile, ignore_errors=True)
    print('page: %d passed, %d failed' % (counts[True], counts[False]))
    return counts[False] > 0


if __name__ == '__main__':
    sys.exit(main())
