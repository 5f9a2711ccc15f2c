// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
// The page as a panel of VS Code: it selects what is at the cursor, and tells where that is which was selected here.
//
//   from the editor   {type: 'reveal', kind, name, path, line}   {type: 'changed', page, changes}
//   to the editor     {type: 'ready'}   {type: 'selected', path, line, column}
//
// A link or joint has no column, a finding has one.
// `page` and `changes` are JSON texts, as a server sends them to a page in a browser.

import { readText } from './data.js';
import { LISTS } from './state.js';
import { sayChanges, toast } from './toast.js';

/** Null in a browser. */
export function editorAround() {
  return globalThis.acquireVsCodeApi?.() ?? null;
}

/** The entity of that name in that line; else the first in the line, as a template's name is another; else the first of the name. */
export function indexAt(data, { kind, name, path, line }) {
  const list = data[LISTS[kind]] ?? [];
  const find = (fits) =>
    list.findIndex((entity) => data.files[entity.file]?.path === path && fits(entity));
  const found = [
    find((entity) => entity.line === line && entity.name === name),
    find((entity) => entity.line === line),
    find((entity) => entity.name === name),
  ];
  return found.find((index) => index >= 0) ?? -1;
}

/** The editor's theme, which need not be the system's. */
function takeTheme(onChange) {
  const take = () => {
    const dark = ['vscode-dark', 'vscode-high-contrast'].some((name) =>
      document.body.classList.contains(name),
    );
    const light = document.body.classList.contains('vscode-high-contrast-light');
    document.documentElement.dataset.theme = dark && !light ? 'dark' : 'light';
    onChange();
  };
  new MutationObserver(take).observe(document.body, { attributeFilter: ['class'] });
  take();
}

export function followEditor(editor, app) {
  const { state } = app;
  let revealing = false;
  let last = Promise.resolve();

  const tell = ({ file, line, column }) => {
    const path = state.data.files[file]?.path;
    if (!path || !(line > 0) || revealing) return;
    editor.postMessage({ type: 'selected', path, line, column });
  };
  const reveal = (message) => {
    const kind = message.kind === 'robot' ? 'model' : message.kind;
    const index = indexAt(state.data, { ...message, kind });
    if (index < 0 || state.isSelected(kind, index)) return;
    revealing = true;
    state.select(kind, index);
    revealing = false;
  };
  const change = async ({ page, changes }) => {
    try {
      await app.swap(await readText(page));
      sayChanges(JSON.parse(changes));
    } catch (error) {
      toast(`The changed model could not be shown: ${error.message}`);
    }
  };
  addEventListener('message', ({ data }) => {
    // One after the other: a model that is read slowly would take the place of a newer one.
    if (data.type === 'changed') last = last.then(() => change(data));
    else if (data.type === 'reveal') last = last.then(() => reveal(data));
  });
  state.on('selection', () => {
    if (state.selection && state.finding < 0) tell(state.selected());
  });
  state.on('source', tell);
  takeTheme(() => app.stage?.draw());
  editor.postMessage({ type: 'ready' });
}
