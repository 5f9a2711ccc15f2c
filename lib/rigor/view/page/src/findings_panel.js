// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
// What `rigor validate` found, the worst first.

import { byId, counted, el } from './dom.js';

const SEVERITIES = [
  ['error', 'error'],
  ['warning', 'warning'],
  ['info', 'note'],
];

export function showFindings(state) {
  const panel = byId('findings');
  const badges = byId('badges');
  let buttons = [];

  const button = (finding, index) => {
    const file = state.data.files[finding.file];
    const made = el(
      'button',
      {
        type: 'button',
        class: `finding ${finding.severity}`,
        click: () => state.selectFinding(index),
      },
      el('span', { class: 'rule' }, finding.rule),
      el('span', { class: 'message' }, finding.message),
      finding.hint ? el('span', { class: 'hint' }, finding.hint) : null,
      el(
        'span',
        { class: 'place' },
        [finding.where, file && `${file.path}${finding.line ? `:${finding.line}` : ''}`].filter(Boolean).join(' · '),
      ),
    );
    buttons[index] = made;
    return el('li', {}, made);
  };

  const mark = () => {
    buttons.forEach((made, index) => made.setAttribute('aria-current', index === state.finding));
    buttons[state.finding]?.closest('details')?.setAttribute('open', '');
    buttons[state.finding]?.scrollIntoView({ block: 'nearest' });
  };

  const build = () => {
    const { findings } = state.data;
    buttons = [];
    const groups = SEVERITIES.map(([severity, noun]) => ({
      severity,
      noun,
      members: findings.flatMap((finding, i) =>
        finding.severity === severity ? [button(finding, i)] : [],
      ),
    })).filter(({ members }) => members.length > 0);
    panel.replaceChildren(
      ...groups.map(({ severity, noun, members }) =>
        el(
          'details',
          { open: true },
          el(
            'summary',
            {},
            el('span', { class: `dot ${severity}`, 'aria-hidden': true }),
            counted(members.length, noun),
          ),
          el('ul', {}, ...members),
        ),
      ),
    );
    if (groups.length === 0) panel.append(el('p', { class: 'muted' }, 'Nothing was found.'));
    badges.replaceChildren(
      ...groups.map(({ severity, noun, members }) =>
        el('span', { class: `badge ${severity}` }, counted(members.length, noun)),
      ),
    );
    if (groups.length === 0) badges.append(el('span', { class: 'badge clean' }, 'nothing found'));
    mark();
  };

  state.on('model', build);
  state.on('finding', mark);
}
