// Starts the page: the views by their tabs, the theme, cases as text, the golden hash.
'use strict';

const VIEWS = [];  // {name, title, make()}: in the order of their tabs

const page = {
  views: {},
  current: null,
  name: null,

  async start() {
    for (const view of VIEWS) {
      this.tab(view);
    }
    this.listen();
    const text = document.getElementById('wasm').textContent.trim();
    gjk = await gjkLoad(Uint8Array.from(atob(text), (c) => c.charCodeAt(0)));
    this.open();
    setTimeout(() => this.golden(), 30);
  },

  tab({ name, title }) {
    const number = document.querySelectorAll('nav a').length + 1;
    document.querySelector('nav').append(
      element('a', { href: '#' + name, id: 'tab-' + name, title: 'Key ' + number }, title));
  },

  // Shows the view that the address names, as the address has it.
  open() {
    const { view, values } = address.read();
    clearTimeout(this.saving);
    this.saving = undefined;
    const found = VIEWS.find(({ name }) => name === view) ?? VIEWS[0];
    if (this.views[found.name] === undefined) {
      this.views[found.name] = found.make();
      document.querySelector('main').append(this.views[found.name].element);
    }
    if (this.current !== null && this.current !== this.views[found.name]) {
      this.current.element.classList.remove('shown');
      this.current.hide?.();
    }
    this.current = this.views[found.name];
    this.name = found.name;
    for (const link of document.querySelectorAll('nav a')) {
      link.toggleAttribute('aria-current', link.id === 'tab-' + found.name);
    }
    this.current.element.classList.add('shown');
    this.current.load(values);
  },

  // The state of the view has changed. Browsers allow few changes of the address a second.
  save() {
    this.saving ??= setTimeout(() => this.saveNow(), 300);
  },

  saveNow() {
    clearTimeout(this.saving);
    this.saving = undefined;
    address.write(this.name, this.current.save());
  },

  listen() {
    addEventListener('hashchange', () => this.open());
    addEventListener('resize', () => this.current?.resize?.());
    document.getElementById('theme').addEventListener('click', () => this.turnTheme());
    document.getElementById('exchange').addEventListener('click', () => this.exchange());
    document.getElementById('case-copy').addEventListener('click', () => this.copy());
    document.getElementById('case-show').addEventListener('click', () => this.paste(this.textarea().value));
    addEventListener('paste', (event) => {
      const text = event.clipboardData?.getData('text') ?? '';
      if (/^\s*(#.*\n\s*)*case2? /.test(text) && !/TEXTAREA|INPUT/.test(document.activeElement.tagName)) {
        this.paste(text);
      }
    });
    addEventListener('keydown', (event) => this.key(event));
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.current?.repaint?.());
  },

  key(event) {
    if (event.ctrlKey || event.metaKey || event.altKey || /TEXTAREA|INPUT|SELECT/.test(event.target.tagName) ||
        document.querySelector('dialog[open]') !== null) {
      return;
    }
    const view = VIEWS[Number(event.key) - 1];
    if (view !== undefined) {
      location.hash = '#' + view.name;
    } else if (event.key === 't') {
      this.turnTheme();
    } else if (event.key === 'c') {
      this.exchange();
    } else {
      return;
    }
    event.preventDefault();
  },

  turnTheme() {
    const root = document.documentElement;
    const dark = root.dataset.theme === 'dark' ||
      (root.dataset.theme === undefined && matchMedia('(prefers-color-scheme: dark)').matches);
    root.dataset.theme = dark ? 'light' : 'dark';
    this.current?.repaint?.();
  },

  textarea() {
    return document.querySelector('#case-dialog textarea');
  },

  exchange() {
    this.textarea().value = this.current.caseText?.() ?? '';
    this.complain('');
    document.getElementById('case-dialog').showModal();
  },

  complain(text) {
    document.querySelector('#case-dialog .complaint').textContent = text;
  },

  async copy() {
    this.textarea().select();
    try {
      await navigator.clipboard.writeText(this.textarea().value);
    } catch {
      document.execCommand('copy');
    }
  },

  // Shows the first case of a text: one of the plane as the idea, one of space in space.
  paste(text) {
    const [shown] = query(text, 'distance', 0, CASE).split(/\n(?=case)/).slice(1);
    const lines = shown?.split('\n') ?? [];
    const end = lines.findIndex((line, i) => i > 0 && !/^[AB\d-]/.test(line));
    const found = lines.slice(0, end < 0 ? undefined : end).join('\n');
    if (complaints() !== '' || found === '') {
      this.complain(complaints() || 'no case found');
      if (document.querySelector('dialog[open]') === null) {
        this.textarea().value = text;
        document.getElementById('case-dialog').showModal();
      }
      return false;
    }
    document.getElementById('case-dialog').close();
    location.hash = (found.startsWith('case2') ? '#idea?case=' : '#space?case=') + encodeURIComponent(address.pack(found));
    return true;
  },

  // The same 6,000 pairs as on every platform; what they answer is one number.
  golden() {
    const start = performance.now();
    const equal = gjk.exports.page_golden() === 1 && gjk.exports.page_golden_plane() === 1;
    const hash = gjk.getText(gjk.exports.page_golden_text());
    const taken = Math.max(1, Math.round(performance.now() - start));
    document.getElementById('golden').textContent = equal
      ? `6,000 pairs in ${taken} ms: ${hash}, equal to the hash of every other platform.`
      : `6,000 pairs: ${hash}. These are NOT the bits of the other platforms.`;
    document.body.dataset.gjk = equal ? 'ok' : 'wrong';
  },
};
