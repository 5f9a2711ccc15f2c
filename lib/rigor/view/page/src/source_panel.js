// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
// The files' text with line numbers, and in it the place that is spoken of.

import { byId, el } from './dom.js';

/** Columns count code points from 1, as the findings' do. */
function cut(line, from, to) {
  const points = [...line];
  return [points.slice(0, from - 1), points.slice(from - 1, to - 1), points.slice(to - 1)].map(
    (part) => part.join(''),
  );
}

/** Text before, in and after the span; a span without an end is its line. */
export function splitAt(lines, { line, column, endLine, endColumn }) {
  const first = Math.min(line, lines.length) - 1;
  const last = Math.min(Math.max(endLine ?? line, line), lines.length) - 1;
  const isSpan = column > 0 && endColumn > 0 && (last > first || endColumn > column);
  const [before] = isSpan ? cut(lines[first], column, column) : [''];
  const after = isSpan ? cut(lines[last], endColumn, endColumn)[2] : '';
  const marked = lines.slice(first, last + 1).join('\n');
  return {
    first,
    last,
    isSpan,
    before: [...lines.slice(0, first), before].join('\n'),
    marked: marked.slice(before.length, marked.length - after.length),
    after: [after, ...lines.slice(last + 1)].join('\n'),
  };
}

export function showSource(state) {
  const panel = byId('source');
  const choice = byId('source-file');
  const scroller = byId('source-text');
  let shown = { file: 0 };

  const show = (place) => {
    shown = place;
    const file = state.data.files[place.file];
    choice.value = String(place.file);
    if (!file) {
      scroller.replaceChildren();
      return;
    }
    const lines = file.text.split(/\r\n|\r|\n/);
    const numbers = el(
      'pre',
      { class: 'numbers', 'aria-hidden': true },
      lines.map((_, i) => i + 1).join('\n'),
    );
    const code = el('pre', { class: 'code' });
    const body = el('div', { class: 'sheet' }, numbers, code);
    scroller.replaceChildren(body);
    if (!place.line) {
      code.append(file.text);
      return;
    }
    const { first, last, isSpan, before, marked, after } = splitAt(lines, place);
    const band = el('div', { class: 'band' });
    band.style.setProperty('--first', first);
    band.style.setProperty('--lines', last - first + 1);
    const severity = state.data.findings[state.finding]?.severity ?? '';
    const mark = el('mark', { class: isSpan ? severity : 'line' }, marked);
    code.append(before, mark, after);
    body.prepend(band);
    const top = mark.getBoundingClientRect().top - body.getBoundingClientRect().top;
    scroller.scrollTop = top - scroller.clientHeight / 3;
    scroller.scrollLeft = 0;
    const right = mark.getBoundingClientRect().right - scroller.getBoundingClientRect().right;
    if (isSpan && first === last && right > 0) scroller.scrollLeft = right + 40;
  };

  const open = (isOpen) => {
    panel.hidden = !isOpen;
    byId('source-toggle').setAttribute('aria-pressed', isOpen);
  };

  choice.addEventListener('change', () => show({ file: Number(choice.value) }));
  byId('source-close').addEventListener('click', () => open(false));
  byId('source-toggle').addEventListener('click', () => open(panel.hidden));
  state.on('source', (place) => {
    open(true);
    show(place);
  });
  state.on('model', () => {
    const { files } = state.data;
    choice.replaceChildren(...files.map(({ path }, i) => el('option', { value: i }, path)));
    choice.disabled = files.length < 2;
    byId('source-toggle').disabled = files.length === 0;
    show({ file: shown.file < files.length ? shown.file : 0 });
  });
}
