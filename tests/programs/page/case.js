// Cases as objects: {plane, id, A, B}, each shape with kind, size, vertices, faces, round, at, turn, to, turnTo, spin.
'use strict';

// Reads a case as the module prints it: raw integers, one property a line.
function readCase(text) {
  const lines = text.trim().split('\n');
  const found = { plane: lines[0].startsWith('case2'), id: lines[0].split(' ')[1] };
  for (let i = 1; i < lines.length; i++) {
    const [name, word, ...rest] = lines[i].split(' ');
    const numbers = rest.map(Number);
    const shape = found[name] ??= { vertices: [], faces: [], round: 0, to: null, turnTo: null, spin: null };
    const list = (count) => lines.slice(i + 1, (i += count) + 1).map((line) => line.split(' ').map(Number));
    switch (word) {
      case 'round': shape.round = numbers[0]; break;
      case 'at': shape.at = numbers; break;
      case 'turn': shape.turn = numbers; break;
      case 'to': shape.to = numbers; break;
      case 'turn-to': shape.turnTo = numbers; break;
      case 'spin': shape.spin = numbers; break;
      case 'faces': shape.faces = list(numbers[0]); break;
      default:
        shape.kind = word;
        shape.size = numbers;
        if (word === 'triangle') {
          shape.vertices = list(3);
        } else if (word === 'polygon' || word === 'hull') {
          shape.size = [];
          shape.vertices = list(numbers[0]);
        }
    }
  }
  return found;
}

// The case as the module reads it.
function writeCase(shown) {
  const lines = [(shown.plane ? 'case2 ' : 'case ') + (shown.id || 'page')];
  for (const name of ['A', 'B']) {
    const { kind, size, vertices, faces, round, at, turn, to, turnTo, spin } = shown[name];
    const listed = kind === 'polygon' || kind === 'hull';
    lines.push([name, kind, ...(listed ? [vertices.length] : size)].join(' '));
    lines.push(...vertices.map((v) => v.join(' ')));
    if (faces.length > 0) {
      lines.push(name + ' faces ' + faces.length, ...faces.map((f) => f.join(' ')));
    }
    for (const [word, value] of [['round', round === 0 ? null : [round]], ['at', at], ['turn', turn], ['to', to],
      ['turn-to', turnTo], ['spin', spin]]) {
      if (value !== null) {
        lines.push([name, word, ...value].join(' '));
      }
    }
  }
  return lines.join('\n') + '\n';
}

// A case in any writing that gjk-query takes, read; null if it is none.
function parseCase(text) {
  const answer = ask(text, 'distance', 0, CASE);
  return complaints() === '' && answer.text.startsWith('case') ? readCase(answer.text) : null;
}

// What an address asks; the distance if it asks nothing that is known.
function askedOf(values) {
  return ['distance', 'penetration', 'contacts', 'cast'].includes(values.get('ask')) ? values.get('ask') : 'distance';
}

// A cast needs a way: B goes through A where it has none. Returns whether it got one.
function giveWay(shown, question) {
  if (question !== 'cast' || shown.B.to !== null) {
    return false;
  }
  shown.B.to = shown.B.at.map((x, k) => Math.round(2 * shown.A.at[k] - x));
  return true;
}
