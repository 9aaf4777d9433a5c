// What all views share: elements, the module, questions to it, and the address.
'use strict';

const ONE = 65536, UNIT = 1 << 30;

// element('button', {class: 'x', onclick: f}, 'text', child): an HTML element, or with svg() an SVG one.
function fill(made, attributes, children) {
  for (const [name, value] of Object.entries(attributes ?? {})) {
    if (name.startsWith('on')) {
      made.addEventListener(name.slice(2), value);
    } else if (value === true) {
      made.setAttribute(name, '');
    } else if (value !== false && value != null) {
      made.setAttribute(name, value);
    }
  }
  made.append(...children);
  return made;
}

function element(name, attributes, ...children) {
  return fill(document.createElement(name), attributes, children);
}

function svg(name, attributes, ...children) {
  return fill(document.createElementNS('http://www.w3.org/2000/svg', name), attributes, children);
}

// A row of buttons of which one is pressed. choices: [[value, label], ...].
function choiceOf(label, choices, chosen) {
  const buttons = choices.map(([value, text]) =>
    element('button', { type: 'button', 'data-value': value, onclick: () => set(value, true) }, text));
  const group = element('div', { class: 'group', role: 'group', 'aria-label': label }, ...buttons);
  function set(value, told) {
    group.value = value;
    for (const button of buttons) {
      button.setAttribute('aria-pressed', button.dataset.value === value);
    }
    if (told) {
      chosen(value);
    }
  }
  group.set = (value) => set(value, false);
  return group;
}

// A view that is not shown has no size to draw in.
function redrawWhenResized(view) {
  new ResizeObserver(() => {
    if (view.element.classList.contains('shown')) {
      view.draw();
    }
  }).observe(view.element);
}

// Thousands apart by thin spaces: exact integers are long.
function exact(value) {
  return String(value).replace(/^-/, '−').replace(/\B(?=(\d{3})+$)/g, '\u2009');
}

// LSB as units, for people.
function units(lsb) {
  const text = Math.abs(lsb / ONE).toFixed(Math.abs(lsb) < ONE / 10 ? 5 : 3);
  return (lsb < 0 ? '−' : '') + text;
}

let gjk;  // the module, see port/wasm/gjk.js

const ASK = { distance: 0, intersect: 1, within: 2, penetration: 3, contacts: 4, cast: 5, ray: 6, impact: 7 };
const TRACE = 1, PROOF = 2, POSED = 4, REFERENCE = 8, CASE = 16;

// The text that gjk-query prints about cases.
function query(cases, ask, number = 0, flags = 0) {
  const at = gjk.putText(cases);
  const text = gjk.getText(gjk.exports.page_answer(at, ASK[ask], number, flags));
  gjk.exports.gjk_port_release(at);
  return text;
}

function complaints() {
  return gjk.getText(gjk.exports.page_messages()).trim();
}

// The answer to one case, read from gjk-query's lines.
//   line       the answer itself
//   word       separated, intersecting, hit, miss, error ...; fields: distance, a, b, normal ... as numbers or lists
//   contacts, steps, stop, proof, posed, text (of the case)
function ask(cases, question, number = 0, flags = 0) {
  const lines = query(cases, question, number, flags).trimEnd().split('\n');
  const answer = { line: lines[0], contacts: [], steps: [], posed: {}, ...fieldsOf(lines[0]) };
  answer.word = lines[0].split(' ')[1];
  let at = 1;
  for (; at < lines.length && lines[at].startsWith('  '); at++) {
    const words = lines[at].trim().split(' ');
    switch (words[0]) {
      case 'contact': answer.contacts.push(fieldsOf(lines[at])); break;
      case 'iteration': answer.steps.push(stepOf(words)); break;
      case 'stop': answer.stop = { word: words[1].slice(0, -1), text: words.slice(2).join(' ') }; break;
      case 'walk': answer.walk = Number(words[1].slice(0, -1)); break;
      case 'proof': answer.proof = { name: words[1], proven: words.at(-1) === 'proven', ...fieldsOf(lines[at]) }; break;
      case 'posed': answer.posed[words[1]] = words.slice(2).map(listOf); break;
      default: break;
    }
  }
  answer.text = lines.slice(at).join('\n');
  return answer;
}

function listOf(text) {
  return text.split(',').map(Number);
}

// name=value pairs of a line: one number, several as a list, or text.
function fieldsOf(line) {
  const fields = {};
  for (const [, name, value] of line.matchAll(/ ([a-z-]+)=(\S+)/g)) {
    fields[name] = /^[-\d,]+$/.test(value) ? (value.includes(',') ? listOf(value) : Number(value)) : value.split(',');
  }
  return fields;
}

// 'iteration 2 d=1,2 A0=3,4 B1=5,6 w2=7,8 before=w1 after=w2,w1'
function stepOf(words) {
  const step = { number: Number(words[1]), recalled: words.at(-1) === 'recalled' };
  for (const word of words.slice(2)) {
    const [name, value] = word.split('=');
    if (name === 'd' || name === 'rounded') {
      step.direction = listOf(value);
      step.rounded = name === 'rounded';
    } else if (name === 'before' || name === 'after') {
      step[name] = value === '-' ? [] : value.split(',');
    } else if (/^A\d*$/.test(name)) {
      step.a = { name, at: listOf(value) };
    } else if (/^B\d*$/.test(name)) {
      step.b = { name, at: listOf(value) };
    } else if (/^w\d+$/.test(name)) {
      step.w = { name, at: listOf(value) };
    }
  }
  return step;
}

// The address says what is shown: #VIEW?NAME=VALUE&... Values are texts; cases have ; for line feeds.
const address = {
  known: location.hash,

  read() {
    this.known = location.hash;
    const [view, rest] = location.hash.slice(1).split('?');
    return { view, values: new URLSearchParams(rest ?? '') };
  },
  write(view, values) {
    const text = Object.entries(values).filter(([, value]) => value !== '' && value != null)
      .map(([name, value]) => name + '=' + encodeURIComponent(value).replace(/%20/g, '+').replace(/%3B/gi, ';'));
    const hash = '#' + view + (text.length > 0 ? '?' + text.join('&') : '');
    // Another hash than the one known is a link that has been followed and is about to be shown.
    if (hash !== location.hash && location.hash === this.known) {
      history.replaceState(null, '', hash);
      this.known = location.hash;
    }
  },
  pack(cases) {
    return cases.trim().split('\n').map((line) => line.trim()).filter((line) => line !== '' && line[0] !== '#').join(';');
  },
  unpack(text) {
    return text.split(';').join('\n') + '\n';
  },
};
