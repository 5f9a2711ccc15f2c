// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
// What a template expands to, as a document beside it that follows what is typed.

import * as vscode from 'vscode';
import type { LanguageClient } from 'vscode-languageclient/node';

import { modelAsked } from './documents';

const SCHEME = 'rigor-expanded';

/** ms without a key before it is expanded anew. */
const PAUSE = 200;

/** "arm.urdf" for "arm.urdf.xacro" and "arm.xacro"; the template is the query. */
function expandedUri(template: vscode.Uri): vscode.Uri {
  const name = template.path.replace(/\.xacro$/, '');
  const path = /\.(urdf|sdf|world|srdf)$/.test(name) ? name : `${name}.urdf`;
  return vscode.Uri.from({ scheme: SCHEME, path, query: template.toString() });
}

export function showExpansions(client: LanguageClient): vscode.Disposable {
  const changed = new vscode.EventEmitter<vscode.Uri>();
  const shown = () =>
    vscode.workspace.textDocuments.filter((document) => document.uri.scheme === SCHEME);
  let timer: NodeJS.Timeout | undefined;

  const provider: vscode.TextDocumentContentProvider = {
    onDidChange: changed.event,
    async provideTextDocumentContent(uri) {
      try {
        const answer = await client.sendRequest<{ text: string }>('rigor/expanded', {
          textDocument: { uri: uri.query },
        });
        return answer.text;
      } catch (error) {
        return `<!-- ${(error as Error).message.replaceAll('--', '- -')} -->\n`;
      }
    },
  };
  const show = async (asked?: unknown) => {
    const template = modelAsked(asked);
    if (!template) return;
    await vscode.workspace.openTextDocument(template); // the server knows open documents
    const document = await vscode.workspace.openTextDocument(expandedUri(template));
    await vscode.window.showTextDocument(document, {
      viewColumn: vscode.ViewColumn.Beside,
      preserveFocus: true,
      preview: false,
    });
  };
  const follow = (event: vscode.TextDocumentChangeEvent) => {
    if (event.document.uri.scheme === SCHEME) return;
    clearTimeout(timer);
    timer = setTimeout(() => {
      for (const document of shown()) changed.fire(document.uri);
    }, PAUSE);
  };
  return vscode.Disposable.from(
    changed,
    { dispose: () => clearTimeout(timer) },
    vscode.workspace.registerTextDocumentContentProvider(SCHEME, provider),
    vscode.workspace.onDidChangeTextDocument(follow),
    vscode.commands.registerCommand('rigor.showExpanded', show),
  );
}
