// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
// The page of `rigor view` in a panel beside the text. The link or joint at the cursor is selected in it, and what is
// selected in it is shown in the text.

import * as vscode from 'vscode';

import { isModel, modelAsked, saved } from './documents';
import { PageServer } from './page_server';
import type { Program } from './program';
import { followsCursor } from './settings';

/** ms without a movement of the cursor before the panel follows. */
const PAUSE = 80;

/** In a file, from 1; columns count code points. Of a link or joint the line alone is known. */
interface Place {
  path: string;
  line: number;
  column?: number;
}

function positionOf({ line, column }: Place, document: vscode.TextDocument): vscode.Position {
  const text = document.lineAt(Math.min(Math.max(line, 1), document.lineCount) - 1);
  if (!column) return text.range.start.translate(0, text.firstNonWhitespaceCharacterIndex);
  return text.range.start.translate(0, [...text.text].slice(0, column - 1).join('').length);
}

/** The cursor; before the text of a line it stands for what begins there. */
function placeAtCursor({ document, selection }: vscode.TextEditor): vscode.Position {
  const { active } = selection;
  const first = document.lineAt(active.line).firstNonWhitespaceCharacterIndex;
  return active.with({ character: Math.max(active.character, first) });
}

/** The links, joints and models around a place, the innermost last. */
function around(symbols: vscode.DocumentSymbol[], at: vscode.Position): vscode.DocumentSymbol[] {
  const here = symbols.find((symbol) => symbol.range.contains(at));
  if (!here) return [];
  const shown = ['link', 'joint', 'model', 'robot'].includes(here.detail);
  return [...(shown ? [here] : []), ...around(here.children, at)];
}

const escaped = (text: string) =>
  text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('>', '&gt;');

class ViewPanel {
  private server: PageServer | undefined;
  private generation = 0;
  private closed = false;

  constructor(
    private readonly program: Program,
    readonly model: vscode.Uri,
    readonly panel: vscode.WebviewPanel,
    icon: vscode.Uri,
  ) {
    panel.iconPath = icon;
    panel.webview.onDidReceiveMessage((message) => this.receive(message));
    panel.onDidDispose(() => {
      this.closed = true;
      this.server?.stop();
    });
    void this.start();
  }

  private async start(): Promise<void> {
    const generation = ++this.generation;
    try {
      const server = await PageServer.start(this.program, this.model);
      if (this.closed || generation !== this.generation) return server.stop();
      this.server = server;
      server.listen((change) => this.panel.webview.postMessage({ type: 'changed', ...change }));
      server.onEnd(() => (this.server = undefined));
      this.panel.webview.html = await server.page();
    } catch (error) {
      if (this.closed) return;
      this.panel.webview.html = `<pre style="white-space: pre-wrap">${escaped((error as Error).message)}\n\nThe view opens when the model is saved without this.</pre>`;
    }
  }

  /** A model that could not be shown may be one now. */
  retry(): void {
    if (!this.server) void this.start();
  }

  /** Selects what is at the cursor. */
  async reveal(editor: vscode.TextEditor): Promise<void> {
    const symbols = await vscode.commands.executeCommand<vscode.DocumentSymbol[]>(
      'vscode.executeDocumentSymbolProvider',
      editor.document.uri,
    );
    const found = around(symbols ?? [], placeAtCursor(editor)).at(-1);
    if (!found) return;
    await this.panel.webview.postMessage({
      type: 'reveal',
      kind: found.detail,
      name: found.name,
      path: editor.document.uri.fsPath,
      line: found.range.start.line + 1,
    });
  }

  private async receive(message: { type: string } & Place): Promise<void> {
    if (message.type === 'ready') {
      const [editor] = vscode.window.visibleTextEditors.filter((each) => isModel(each.document));
      if (editor && followsCursor()) await this.reveal(editor);
    } else if (message.type === 'selected' && message.path) {
      await this.showSource(message);
    }
  }

  private async showSource(place: Place): Promise<void> {
    const document = await vscode.workspace.openTextDocument(vscode.Uri.file(place.path));
    const position = positionOf(place, document);
    const shown = vscode.window.visibleTextEditors.find((each) => each.document === document);
    const editor = await vscode.window.showTextDocument(document, {
      viewColumn: shown?.viewColumn ?? vscode.ViewColumn.One,
      preserveFocus: true,
    });
    editor.selection = new vscode.Selection(position, position);
    editor.revealRange(editor.selection, vscode.TextEditorRevealType.InCenterIfOutsideViewport);
  }
}

export function viewModels(program: Program, extension: vscode.Uri): vscode.Disposable {
  const panels = new Map<string, ViewPanel>();
  const icon = vscode.Uri.joinPath(extension, 'icon.png');
  let timer: NodeJS.Timeout | undefined;

  const view = async (asked?: unknown) => {
    const model = modelAsked(asked);
    if (!model) return;
    await saved(model);
    const key = model.toString();
    const open = panels.get(key);
    if (open) return open.panel.reveal(undefined, true);
    const name = model.path.split('/').at(-1);
    const panel = vscode.window.createWebviewPanel(
      'rigor.view',
      `View of ${name}`,
      { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true },
      { enableScripts: true, retainContextWhenHidden: true, localResourceRoots: [] },
    );
    panels.set(key, new ViewPanel(program, model, panel, icon));
    panel.onDidDispose(() => panels.delete(key));
  };
  const follow = ({ textEditor }: vscode.TextEditorSelectionChangeEvent) => {
    if (panels.size === 0 || !followsCursor() || !isModel(textEditor.document)) return;
    clearTimeout(timer);
    timer = setTimeout(() => {
      for (const panel of panels.values()) void panel.reveal(textEditor);
    }, PAUSE);
  };
  return vscode.Disposable.from(
    { dispose: () => clearTimeout(timer) },
    { dispose: () => panels.forEach(({ panel }) => panel.dispose()) },
    vscode.commands.registerCommand('rigor.view', view),
    vscode.window.onDidChangeTextEditorSelection(follow),
    vscode.workspace.onDidSaveTextDocument(() => panels.forEach((panel) => panel.retry())),
  );
}
