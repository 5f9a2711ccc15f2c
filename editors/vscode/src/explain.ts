// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
// Pages of rules, as `rigor explain` prints them.

import * as vscode from 'vscode';
import type { LanguageClient } from 'vscode-languageclient/node';

const SCHEME = 'rigor-rule';

export function explainRules(client: LanguageClient): vscode.Disposable {
  const provider: vscode.TextDocumentContentProvider = {
    async provideTextDocumentContent(uri) {
      const answer = await client.sendRequest<{ text: string }>('rigor/explain', {
        rule: uri.path.replace(/^\/|\.txt$/g, ''),
      });
      return answer.text;
    },
  };
  const explain = async (asked?: unknown) => {
    const rule =
      typeof asked === 'string'
        ? asked
        : await vscode.window.showInputBox({ prompt: 'Rule', placeHolder: 'joint-limit-inverted' });
    if (!rule) return;
    const uri = vscode.Uri.from({ scheme: SCHEME, path: `/${rule}.txt` });
    await vscode.window.showTextDocument(uri, { viewColumn: vscode.ViewColumn.Beside });
  };
  return vscode.Disposable.from(
    vscode.workspace.registerTextDocumentContentProvider(SCHEME, provider),
    vscode.commands.registerCommand('rigor.explain', explain),
  );
}
