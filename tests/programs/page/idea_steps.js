// The steps of the first view: what is said, which integers, and what is drawn beside the difference.
//
// A step: {say, numbers: [[name, value], ...], w: {name: [x, y]} found so far, and what of it is drawn: simplex, direction,
// found, support: {a, b}, polygon, edge, answer}.
'use strict';

const SAY = {
  nearest: 'No vertex of A − B lies nearer: this is the nearest feature, and its distance is that of the shapes.',
  enclosing: 'The origin lies in the simplex: A and B share a point.',
  separated: 'All of A − B lies beyond the origin: the shapes are apart.',
  near: 'The simplex is as near as was asked.',
  limit: 'The iterations did not settle it.',
  circles: 'Their bounding circles are apart: there is nothing to search.',
};

// What the library answers, as rows.
function answerRows(answer) {
  const rows = [['answer', answer.line.split(' ').slice(1, 2)[0]]];
  for (const contact of answer.contacts) {
    rows.push(['contact ' + contact.id, 'a ' + contact.a.map(exact).join(', ') + '  b ' + contact.b.map(exact).join(', ') +
      '  gap ' + exact(contact.distance)]);
  }
  for (const name of ['distance', 'depth', 'fraction', 'a', 'b', 'at', 'normal']) {
    if (answer[name] !== undefined) {
      rows.push([name, [answer[name]].flat().map(exact).join(', ') +
        (name === 'distance' || name === 'depth' ? ' LSB = ' + units(answer[name]) + ' units' : '')]);
    }
  }
  if (answer.proof !== undefined) {
    const { name, proven, pairs, direction } = answer.proof;
    rows.push(['certificate', name + (pairs ? ' ' + pairs.map((p) => p.replace('-', '−')).join(', ') : '') +
      (direction ? ' along ' + direction.map(exact).join(', ') : '') + (proven ? ': proven in integers' : ': not provable')]);
  }
  return rows;
}

function gjkSteps(answer) {
  const steps = [{
    say: 'A − B is every point of A minus every point of B. A and B touch exactly if the origin O is one of them.',
    numbers: [], w: {}, simplex: [],
  }];
  const found = {};
  for (const step of answer.steps) {
    const known = { ...found };
    found[step.w.name] = step.w.at;
    const added = step.after.includes(step.w.name) && !step.before.includes(step.w.name);
    const letters = `${step.a.name} − ${step.b.name}`;
    const d = step.direction.map(BigInt), w = step.w.at.map(BigInt);
    steps.push({
      say: added
        ? `Iteration ${step.number}: ${step.w.name} = ${letters} is farthest towards O, and nearer. Keep what of the simplex is nearest: ${step.after.join(', ')}.`
        : `Iteration ${step.number}: farthest towards O is ${step.w.name} = ${letters}, which is not nearer than what we have.`,
      numbers: [['direction d', step.direction.map(exact).join(', ') + (step.rounded ? ' (rounded)' : '')],
        [`${step.w.name} = ${letters}`, step.w.at.map(exact).join(', ')],
        ['d · ' + step.w.name, exact(d[0] * w[0] + d[1] * w[1])],
        ['simplex', `${step.before.join(', ') || 'none'} → ${step.after.join(', ')}`]],
      w: { ...found }, before: step.before.map((name) => known[name] ?? found[name]), direction: step.direction, found: step.w.name,
      simplex: step.after, support: { a: step.a.at, b: step.b.at },
    });
  }
  return steps;
}

function expandingSteps(answer, gjkEnd) {
  const of = (name) => answer.steps.find((s) => s.w.name === name);
  const number = (text) => Number(text.slice(1));
  const start = gjkEnd.map((name) => (/^w/.test(name) ? [number(of(name).a.name), number(of(name).b.name)]
    : name.split('-').map(number)));
  return expandPolygon(answer.posed.A, answer.posed.B, start).map(({ edge, polygon, found, done }) => {
    const name = (p) => `A${p.a} − B${p.b}`;
    return {
      say: done
        ? `No vertex lies beyond this edge: it is an edge of A − B, and its distance from O, rounded up, is the depth.`
        : `The edge nearest to O is ${name(edge.p)} to ${name(edge.q)}. ${name(found)} lies beyond it: the polygon expands.`,
      numbers: [['edge', `${name(edge.p)}, ${name(edge.q)}`],
        ['height', `${exact(edge.height)} / √${exact(edge.square)}`],
        ['outward normal', edge.normal.map(exact).join(', ')],
        [done ? 'depth' : 'farthest', done ? exact(depthOf(edge)) + ' LSB' : `${name(found)} = ${found.w.map(exact).join(', ')}`]],
      w: {}, simplex: [], polygon: polygon.map((p) => p.w.map(Number)), edge: [edge.p, edge.q].map((p) => p.w.map(Number)),
      support: { a: answer.posed.A[found.a], b: answer.posed.B[found.b] }, foundAt: found.w.map(Number),
      depth: done ? Number(depthOf(edge)) : undefined,
    };
  });
}

// All steps of a question. answer: with TRACE | PROOF | POSED.
function stepsOf(question, answer) {
  if (answer.word === 'error') {
    return [{ say: 'The library refuses this pair.', numbers: [['answer', answer.line]], w: {}, simplex: [] }];
  }
  if (question === 'cast') {
    return [{
      say: answer.word === 'hit'
        ? 'B goes its way until it touches A: the way, drawn from O, enters A − B. Hit or miss is exact, and so is the fraction.'
        : 'B goes its way and misses A: the way, drawn from O, does not meet A − B.',
      numbers: answerRows(answer), w: {}, simplex: [], answer: true,
    }];
  }
  const steps = gjkSteps(answer);
  const end = steps.at(-1).simplex, last = steps.at(-1), stop = answer.stop?.word;
  const curved = answer.posed.A === undefined || [answer.posed.A, answer.posed.B].some((p) => p.length < 1);
  if (answer.word === 'intersecting' && stop === 'enclosing' && question !== 'distance' && !curved) {
    steps.push(...expandingSteps(answer, end));
  }
  const touching = answer.word === 'intersecting';
  const final = question === 'contacts' && answer.contacts.length > 0
    ? `They touch in ${answer.contacts.length === 1 ? 'one point' : 'two points'}, whose names last from tick to tick: what a solver needs.`
    : touching && question !== 'distance' ? `They overlap: moved by ${units(answer.depth)} units along the normal, B is out.`
      : touching ? SAY.enclosing : (SAY[stop] ?? SAY.nearest);
  steps.push({ ...last, say: final, numbers: answerRows(answer), found: undefined, direction: undefined, answer: true,
    support: undefined, stop });
  return steps;
}
