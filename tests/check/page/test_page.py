"""The page in a headless Chromium: test_page.py BUILD CHROMIUM. Prints what fails, and counts."""
import base64
import glob
import json
import os
import re
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


def golden_hash():
    with open('tests/check/target/golden.h', encoding='utf-8') as file:
        return re.search(r'GOLDEN_HASH UINT64_C\(0x([0-9a-f]{16})\)', file.read()).group(1)


def load(browser, hash_part=''):
    browser.open('about:blank')
    browser.open(PAGE + hash_part)
    browser.wait("document.body?.dataset.gjk !== undefined && document.body.dataset.gjk !== 'loading'")


def show(browser, hash_part):
    """As a link on the page does."""
    browser.run('page.saveNow(); page.name = null; location.hash = %s' % json.dumps(hash_part))
    browser.wait("page.name === '%s'" % hash_part[1:].split('?')[0])


def test_start(browser):
    load(browser)
    check('the golden hash is the one of all platforms', browser.run('document.body.dataset.gjk') == 'ok')
    check('it is shown', golden_hash() in browser.run("document.getElementById('golden').textContent"))
    check('the module imports nothing', browser.run(
        "WebAssembly.compile(Uint8Array.from(atob(document.getElementById('wasm').textContent.trim()),"
        "c => c.charCodeAt(0))).then(m => WebAssembly.Module.imports(m).length)") == 0)
    check('one file of less than 1 MB', os.path.getsize(BUILD + '/page/index.html') < 1000000)


VIEWS = ('idea', 'lattice', 'space', 'lockstep', 'game')

QUESTIONS = (('distance', []), ('intersect', ['--intersect']), ('penetration', ['--penetration']),
             ('contacts', ['--contacts', '0.25']), ('cast', ['--cast']), ('impact', ['--impact']))


def plain(text):
    """Without the iterations, which tell of the way: 64-bit cores may take a shorter one."""
    return re.sub(r' iterations=\d+', '', text)


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
            here = plain(browser.run("query(window.cases, '%s', %d)" % (question, number)))
            host = subprocess.run([BUILD + '/gjk-query', *options, name], stdout=subprocess.PIPE,
                                  stderr=subprocess.DEVNULL, check=False).stdout.decode()
            host = plain(host)
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
    {'normal': [1 << 30, 0, 0], 'features': [0, 0], 'points': [
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


def centre(browser, selector):
    return browser.run("(() => { const b = document.querySelector(%s).getBoundingClientRect();"
                       "return [b.left + b.width / 2, b.top + b.height / 2]; })()" % json.dumps(selector))


def address(browser):
    return browser.run("page.saveNow(), location.hash")


def shown(browser):
    return browser.run("document.querySelector('.view.shown').id")


def state(browser):
    return browser.run("page.saveNow(), [location.hash, document.querySelector('.view.shown').innerText].join('\\n')")


def changes(browser, what, do):
    before = state(browser)
    do()
    after = state(browser)
    check(what, before != after, before[:300])
    return after


def host_query(text, *options):
    return subprocess.run([BUILD + '/gjk-query', *options], input=text.encode(), stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, check=False).stdout.decode().strip()


def test_views(browser):
    """Every view is reached by its key and by its tab; what is no view or case shows the first."""
    load(browser)
    for key, name in zip('12345', VIEWS):
        browser.key(key)
        browser.wait("document.querySelector('.view.shown').id === '%s'" % name, 10)
        check('key %s' % key, shown(browser) == name)
    for name in reversed(VIEWS):
        browser.click(*centre(browser, '#tab-' + name))
        browser.wait("page.name === '%s'" % name, 10)
        check('tab of ' + name, shown(browser) == name)
        check('the address says ' + name, address(browser).startswith('#' + name + '?'), address(browser))
    for wrong in ('#nothing', '#idea?case=nonsense', '#idea?step=-4&ask=x', '#space?case=case2+a;A+point;B+point',
                  '#lattice?pair=x&tolerance=z&i=1e9', '#lockstep?tick=-3&bodies=7',
                  '#game?tick=-1&jumps=x_5', '#%'):
        load(browser, wrong)
        check('address ' + wrong, browser.run("document.querySelectorAll('.view.shown').length") == 1)
    load(browser)
    for _ in range(12):
        browser.key('Tab')
        if browser.run("document.activeElement.id") == 'tab-space':
            browser.key('Enter')
    browser.wait("page.name === 'space'", 10)
    check('tabs by the keyboard', shown(browser) == 'space', shown(browser))
    before = browser.run("getComputedStyle(document.body).backgroundColor")
    browser.key('t')
    check('the theme turns', before != browser.run("getComputedStyle(document.body).backgroundColor"))


def test_idea(browser):
    load(browser)
    body = browser.run("(() => { const p = page.views.idea.left, b = p.element.getBoundingClientRect(),"
                       "q = p.to(page.views.idea.shown.B.at); return [b.left + q[0], b.top + q[1]]; })()")
    said = changes(browser, 'B is dragged', lambda: browser.drag(body, (body[0] - 40, body[1] + 20)))
    link = said.split('\n', maxsplit=1)[0]
    corner = centre(browser, '[data-part=B1]')
    changes(browser, 'a corner is dragged', lambda: browser.drag(corner, (corner[0] + 15, corner[1] + 10)))
    handle = centre(browser, '[data-part=turn]')
    changes(browser, 'B is turned', lambda: browser.drag(handle, (handle[0] - 30, handle[1] - 50)))
    for key in ('ArrowLeft', 'ArrowUp', ']', ','):
        changes(browser, 'key ' + key, lambda key=key: browser.key(key))
    for number, name in enumerate(('Depth', 'Contacts', 'Cast', 'Distance')):
        changes(browser, name, lambda n=number: browser.click(*centre(
            browser, "#idea [data-value=%s]" % ('penetration', 'contacts', 'cast', 'distance')[n])))
    browser.run("document.getElementById('idea-step').focus()")
    for key in ('ArrowLeft', 'ArrowLeft', 'Home'):
        changes(browser, 'the slider, ' + key, lambda key=key: browser.key(key))
    load(browser, link)
    check('a link shows what its sender saw', state(browser) == said, state(browser))
    text = browser.run('page.current.caseText()')
    check('a case copied from the page runs in gjk-query', host_query(text) == browser.run(
        'page.current.answer.line'), host_query(text))
    # The expanding polygon ends at the depth that the library reports, and there are pairs of which it does not end at once.
    steps = browser.run("""(() => {
      let seed = 1, rounds = 0, deep = 0;
      const random = (n) => (seed = (seed * 1103515245 + 12345) % 2147483648) % n - n / 2;
      for (let i = 0; i < 300; i++) {
        const polygon = () => Array.from({length: 3 + i % 6}, () => random(200000) + ' ' + random(200000)).join('\\n');
        const text = `case2 p\\nA polygon ${3 + i % 6}\\n${polygon()}\\nB polygon ${3 + i % 6}\\n${polygon()}\\nB at ${random(90000)} ${random(90000)}\\n`;
        const answer = ask(text, 'penetration', 0, TRACE | PROOF | POSED);
        const last = stepsOf('penetration', answer).findLast((step) => step.depth !== undefined);
        if (answer.word === 'intersecting' && last !== undefined) {
          deep++;
          if (last.depth !== answer.depth) return text + answer.line + ' not ' + last.depth;
          rounds += stepsOf('penetration', answer).filter((step) => step.polygon).length;
        }
      }
      return [deep, rounds];
    })()""")
    check('the expanding polygon ends at the depth', isinstance(steps, list) and steps[0] > 100 and steps[1] > 2 * steps[0], steps)


def test_touch(browser):
    """A finger drags a shape and a corner on a small screen; the page scrolls under a finger beside the panes alone."""
    load(browser, '#idea')
    browser.size(390, 600, mobile=True)
    browser.touches(True)
    scrolled = lambda: browser.run('scrollY')
    body = browser.run("(() => { const p = page.views.idea.left, b = p.element.getBoundingClientRect(),"
                       "q = p.to(page.views.idea.shown.B.at); return [b.left + q[0], b.top + q[1]]; })()")
    before = browser.run('page.current.shown.B.at')
    changes(browser, 'a finger drags B', lambda: browser.touch_drag(body, (body[0] - 20, body[1] - 60)))
    after = browser.run('page.current.shown.B.at')
    check('B goes with the finger', after[0] < before[0] and after[1] > before[1], (before, after))
    check('the page does not scroll under B', scrolled() == 0, scrolled())
    before = browser.run('page.current.shown.B.vertices[1]')
    corner = centre(browser, '[data-part=B1]')
    changes(browser, 'a finger drags a corner', lambda: browser.touch_drag(corner, (corner[0] - 10, corner[1] - 50)))
    check('the corner alone goes with the finger', browser.run('page.current.shown.B.at') == after and
          browser.run('page.current.shown.B.vertices[1]') != before)
    check('the page does not scroll under a corner', scrolled() == 0, scrolled())
    sentence = centre(browser, '#idea .integers')
    browser.touch_drag(sentence, (sentence[0], sentence[1] - 150))
    try:
        browser.wait('scrollY > 50', 10)
    except RuntimeError:
        pass
    check('beside the panes it does scroll', scrolled() > 50, scrolled())
    browser.touches(False)
    browser.size(1280, 800)


def test_cases(browser):
    """Cases are pasted, and shown where they belong; what is none is complained about."""
    load(browser)
    for text, view in (('# a comment\ncase pasted\nA sphere 0.5\nB box 1.0 1.0 1.0\nB at 3.0 0.0 0.0\n', 'space'),
                       ('case2 pasted\nA circle 0.5\nB polygon 3\n0.0 0.0\n1.0 0.0\n0.0 1.0\nB at 3.0 0.0\n\ncase2 second\n'
                        'A point\nB point\n', 'idea')):
        browser.key('c')
        browser.run("document.querySelector('#case-dialog textarea').value = " + json.dumps(text))
        browser.click(*centre(browser, '#case-show'))
        browser.wait("document.querySelector('.view.shown').id === '%s'" % view, 10)
        here, host = browser.run('page.current.answer.line'), host_query(text).split('\n')[0]
        check('a pasted case is shown in ' + view, plain(here) == plain(host), here)
    for wrong in ('A box', 'case x\nA box 1 2\nB point\n', 'case2 x\nA point\n', ''):
        browser.key('c')
        before = state(browser)
        browser.run("document.querySelector('#case-dialog textarea').value = " + json.dumps(wrong))
        browser.click(*centre(browser, '#case-show'))
        check('no case: it says why', len(browser.run("document.querySelector('.complaint').textContent")) > 5)
        browser.key('Escape')
        check('no case: the view stays', state(browser) == before)


def test_lattice(browser):
    load(browser, '#lattice')
    captions = lambda: browser.run("[...document.querySelectorAll('#lattice .caption')].map((c) => c.textContent)")
    wrong = lambda: [int(c.split()[1].replace(',', '')) for c in captions()[1:]]
    check('the library is proven at every point', captions()[0] == 'gjk: 2,025 of 2,025 proven', captions())
    best = wrong()
    check('double and float err as in the README', best == [396, 990], captions())
    point = centre(browser, '#lattice canvas')
    changes(browser, 'the square follows', lambda: browser.click(point[0] - 60, point[1] - 30))
    changes(browser, 'the lattice is dragged', lambda: browser.drag(point, (point[0] + 60, point[1])))
    browser.run("document.querySelector('#lattice canvas').focus()")
    changes(browser, 'the square goes by the keyboard', lambda: browser.key('ArrowLeft'))
    browser.run("page.current.set({tolerance: -12})")
    check('a larger tolerance is wrong farther', wrong()[0] > best[0], captions())
    show(browser, '#lattice?pair=crates')
    check('double is right about crates', wrong()[0] == 0 and captions()[0].endswith('2,025 proven'), captions())
    show(browser, '#lattice?pair=needle&tolerance=-14')
    check('a tolerance moves the fault', wrong()[0] > 0, captions())
    text = browser.run('page.current.caseText()')
    check('the case at the square runs in gjk-query', browser.run("page.current.verdict.textContent").split(';')[0].endswith(
        {'intersecting': 'touching'}.get(host_query(text, '--intersect').split()[1], 'apart')), host_query(text, '--intersect'))


def test_space(browser):
    load(browser, '#space')
    pane = browser.run("(() => { const b = page.current.canvas.getBoundingClientRect();"
                       "return [b.left, b.top, b.width, b.height]; })()")
    corner = (pane[0] + pane[2] - 60, pane[1] + pane[3] - 40)
    changes(browser, 'the view turns', lambda: browser.drag(corner, (corner[0] - 80, corner[1] - 30)))
    body = browser.run("page.current.view.project(page.current.shown.B.at)")
    at = (pane[0] + body[0], pane[1] + body[1])
    changes(browser, 'B is dragged', lambda: browser.drag(at, (at[0] - 50, at[1] + 10)))
    for key in ('ArrowLeft', 'ArrowUp', ']', 'j'):
        changes(browser, 'key ' + key, lambda key=key: browser.key(key))
    for name in ('penetration', 'contacts', 'cast'):
        changes(browser, name, lambda name=name: browser.click(*centre(browser, '#space [data-value=%s]' % name)))
    bad = browser.run("""(() => {
      const view = page.current, bad = [];
      for (const a of Object.keys(SPACE_SHAPES)) {
        for (const b of Object.keys(SPACE_SHAPES)) {
          view.changeKind('A', a);
          view.changeKind('B', b);
          if (view.answer.word === 'error') bad.push(a + ' ' + b);
        }
      }
      return bad;
    })()""")
    check('every pair of kinds has an answer', bad == [], bad)


def test_lockstep(browser):
    """3,000 ticks the same; a flipped bit parts them at its tick; a rollback computes the same again."""
    load(browser, '#lockstep?bodies=200')
    point = centre(browser, '#lockstep canvas')
    browser.click(point[0], point[1] + 60)
    browser.wait('Object.keys(page.current.pushes).length === 1', 10)
    browser.run('page.current.running = false')
    said = browser.run("""(async () => {
      const view = page.current;
      while (view.sides[0].tick < 3000) {
        view.step();
      }
      const equal = view.sides[0].hashes.every((hash, i) => hash === view.sides[1].hashes[i]);
      const hashes = [...view.sides[0].hashes], distinct = new Set(hashes).size;
      view.sides.forEach((side) => side.rollBack(2345));
      const back = view.sides[0].tick;
      while (view.sides[0].tick < 3000) {
        view.step();
      }
      const again = hashes.every((hash, i) => hash === view.sides[0].hashes[i] && hash === view.sides[1].hashes[i]);
      view.sides.forEach((side) => side.rollBack(2400));
      view.flip = {tick: 2450, body: 30};
      while (view.sides[0].tick < 2700) {
        view.step();
      }
      view.draw();
      return [equal, distinct, back, again, view.parted, view.verdict.textContent];
    })()""")
    check('3,000 ticks the same', said[0] and said[1] > 2900, said)
    check('rolled back, the same again', said[2] == 2340 and said[3], said)
    check('a flipped bit parts them at its tick', said[4] == 2450 and 'tick 2450' in said[5], said)


SEEN = """(() => {
  const view = page.current, roles = {};
  view.draw();
  for (const records of view.seen) {
    for (let i = 0; i < records.length; i += 5) {
      const point = records[i + 1] === records[i + 3] && records[i + 2] === records[i + 4];
      const name = records[i] + (point ? ' point' : '');
      roles[name] = (roles[name] ?? 0) + 1;
    }
  }
  return roles;
})()"""
COLOURS = """((name) => {
  const drawn = page.current.canvases[0], copy = element('canvas', { width: drawn.width, height: drawn.height });
  const context = copy.getContext('2d', { willReadFrequently: true });
  context.drawImage(drawn, 0, 0);
  const pixels = new Uint32Array(context.getImageData(0, 0, copy.width, copy.height).data.buffer);
  context.fillStyle = getComputedStyle(document.documentElement).getPropertyValue('--' + name);
  context.fillRect(0, 0, 1, 1);
  const [wanted] = new Uint32Array(context.getImageData(0, 0, 1, 1).data.buffer);
  return pixels.reduce((sum, pixel) => sum + (pixel === wanted), 0);
})('%s')"""


def test_look(browser):
    """What the scene sees is drawn when it is asked for, in the colour of its role, and looking changes no bit."""
    bodies = 60
    load(browser, '#lockstep?bodies=%d&tick=600' % bodies)
    browser.wait('page.current.target === null && !page.current.running', 30)
    hashes = lambda: browser.run("page.current.sides.map((side) => side.hashes.join()).join()")
    unseen = browser.run(SEEN)
    check('nothing is seen when it is not asked for', unseen == {} and browser.run(COLOURS % 'good') == 0, unseen)
    browser.run("document.getElementById('lockstep-look').focus()")
    browser.key(' ')
    check('the keyboard asks for it', address(browser).endswith('&look=scene'), address(browser))
    link, roles, before = address(browser), browser.run(SEEN), hashes()
    pairs, contacts = roles.get('5', 0) / 2, roles.get('6 point', 0) / 4  # of each side; a contact has two points
    # The tiles of floor and walls have no width, so that two edges of their boxes are points and are left out.
    check('a box a body and a tile', roles.get('4') == 2 * (4 * bodies + 2 * 42), roles)
    check('every body is near one below, and hardly one near more than six',
          bodies <= pairs <= 3 * bodies and bodies < contacts <= 2 * pairs, roles)
    check('a normal a contact', roles.get('7') == 2 * contacts, roles)
    check('there are no other roles', set(roles) <= {'4', '5', '6', '6 point', '7'}, roles)
    for theme in ('light', 'dark'):
        browser.theme(theme)
        browser.run('page.current.draw()')
        for name in ('d', 'good', 'ink'):
            check('role %s, %s: its colour is there' % (name, theme), browser.run(COLOURS % name) > 20)
    load(browser, link)
    browser.wait('page.current.target === null && !page.current.running', 30)
    check('a link shows it again', browser.run(SEEN) == roles)
    check('looking changes no bit', hashes() == before)
    browser.click(*centre(browser, '#lockstep-look'))
    check('and it goes away', browser.run(SEEN) == {} and browser.run(COLOURS % 'good') == 0 and 'look' not in address(browser))


SIZES = ((1440, 900), (1024, 768), (768, 1024), (390, 844))
LAYOUT = """(() => {
  const bad = [], seen = (e) => e.getClientRects().length > 0;
  const pieces = [...document.querySelectorAll('h1, h2, p, button, select, input, output, dl, nav a, .pane, .key, footer span, .caption, svg text')]
    .filter((e) => seen(e) && (e.textContent.trim() !== '' || /INPUT|pane/.test(e.tagName + e.className)));
  const boxes = pieces.map((e) => e.getBoundingClientRect());
  pieces.forEach((p, i) => pieces.forEach((q, k) => {
    const w = Math.min(boxes[i].right, boxes[k].right) - Math.max(boxes[i].left, boxes[k].left);
    const h = Math.min(boxes[i].bottom, boxes[k].bottom) - Math.max(boxes[i].top, boxes[k].top);
    if (i < k && w > 1.5 && h > 1.5 && !p.contains(q) && !q.contains(p)) {
      bad.push(`${p.tagName} '${p.textContent.slice(0, 20)}' over ${q.tagName} '${q.textContent.slice(0, 20)}'`);
    }
  }));
  for (const e of document.querySelectorAll('body *')) {
    const own = [...e.childNodes].some((n) => n.nodeType === 3 && n.data.trim() !== '');
    if (own && seen(e) && !/SCRIPT|STYLE/.test(e.tagName) && parseFloat(getComputedStyle(e).fontSize) < 12) {
      bad.push('small text: ' + e.textContent.slice(0, 20));
    }
  }
  for (const e of document.querySelectorAll('button, nav a, .caption')) {
    const box = e.getBoundingClientRect();
    if (seen(e) && (e.scrollWidth > e.clientWidth + 1 || box.right > innerWidth + 1 || box.left < -1)) {
      bad.push('cut: ' + e.textContent);
    }
  }
  if (document.documentElement.scrollWidth > innerWidth) {
    bad.push('wider than the screen');
  }
  return bad;
})()"""


def test_layout(browser):
    """Nothing overlaps, is cut or has text below 12 px, in four sizes and both themes. Pictures stay in BUILD/page-test."""
    hashes = {'idea': '#idea?step=2', 'lattice': '#lattice', 'space': '#space', 'lockstep': '#lockstep?tick=60&bodies=60&look=scene',
              'game': '#game?tick=120'}
    load(browser)
    for width, height in SIZES:
        browser.size(width, height)
        for name in VIEWS:
            show(browser, '#' + name)
            show(browser, hashes[name] + ('&' if '?' in hashes[name] else '?') + 'width=%d' % width)
            browser.wait('page.current.target == null', 10)
            for theme in ('light', 'dark'):
                browser.theme(theme)
                found = browser.run(LAYOUT)
                check('%s, %d x %d, %s' % (name, width, height, theme), found == [], found)
                browser.picture('%s/page-test/%s-%d-%s.png' % (BUILD, name, width, theme))
            before = browser.run("document.querySelector('.view.shown .stage').getBoundingClientRect().top")
            browser.run("page.current.goTo?.(0)")
            check('%s, %d wide: the stage stays' % (name, width),
                  before == browser.run("document.querySelector('.view.shown .stage').getBoundingClientRect().top"))
    browser.size(1280, 800)
    browser.run("document.querySelector('.view.shown h2').style.cssText = 'font-size: 11px; margin-bottom: -20px; width: 5000px'")
    found = ' '.join(browser.run(LAYOUT))
    check('the check of the layout finds faults', all(word in found for word in (' over ', 'small text', 'wider')), found)


GAME = """(() => {
  const view = page.current, count = gjk.exports.page_game_look(), at = gjk.exports.page_game_records() / 4;
  const records = gjk.words().slice(at, at + 5 * count), of = (role) => records.filter((_, i) => records[i - i % 5] === role);
  return {tick: view.tick, fine: view.fine, running: view.running, runner: of(100)[1] / ONE, asleep: of(2).length / 5,
    ground: of(101).length / 5, hash: view.caption.textContent};
})()"""


def test_game(browser):
    """The game of the examples ends where it does as a program; a jump is an input that the address keeps."""
    load(browser, '#game?tick=570')
    said = browser.run(GAME)
    check('after 570 ticks the runner is at column 33', said['fine'] and not said['running'] and said['tick'] == 570 and
          33 <= said['runner'] < 34, said)
    check('crates sleep in the end, and the level is drawn', said['asleep'] >= 200 and said['ground'] > 20, said)
    load(browser, '#game?tick=570')
    check('again the same bits', browser.run(GAME) == said)
    load(browser, '#game?tick=570&jumps=300_420')
    jumped = browser.run(GAME)
    check('a jump leads elsewhere', jumped['fine'] and jumped['hash'] != said['hash'], jumped)
    load(browser, '#game?tick=100')
    browser.click(*centre(browser, '#game canvas'))
    browser.wait('page.current.tick > 130', 20)
    browser.run('page.current.toggle()')
    browser.run('page.saveNow()')
    check('a tap is a jump, and is in the address', 'jumps=100' in address(browser), address(browser))


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
        browser.size(1280, 800)
        for test in (test_start, test_library, test_views, test_idea, test_touch, test_cases, test_lattice, test_space,
                     test_lockstep, test_look, test_game, test_layout, test_answers):
            test(browser)
        check('no console errors', not browser.errors, browser.errors)
    finally:
        browser.close()
    shutil.rmtree(profile, ignore_errors=True)
    print('page: %d passed, %d failed' % (counts[True], counts[False]))
    return counts[False] > 0


if __name__ == '__main__':
    sys.exit(main())
