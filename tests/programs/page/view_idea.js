// The idea.
'use strict';
VIEWS.push({ name: 'idea', title: 'The idea', make: () => ({
  element: element('section', { class: 'view', id: 'idea' }, element('h2', {}, 'The idea')),
  load() {}, save() { return {}; },
}) });
