// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
// What is a model among the documents of the editor.

import * as vscode from 'vscode';

const LANGUAGES = ['sdf', 'urdf', 'xacro', 'srdf'];

/** All that the server speaks of: models, and the files beside them. */
export const SELECTOR: { language?: string; pattern?: string; scheme: string }[] = [
  ...['file', 'untitled'].flatMap((scheme) => LANGUAGES.map((language) => ({ scheme, language }))),
  ...['model.config', 'package.xml', 'rigor.toml'].map((name) => ({
    scheme: 'file',
    pattern: `**/${name}`,
  })),
];

export function isModel(document: vscode.TextDocument): boolean {
  return document.uri.scheme === 'file' && LANGUAGES.includes(document.languageId);
}

/** What a command was called for: a file of the explorer, else the document that is edited. */
export function modelAsked(asked: unknown): vscode.Uri | undefined {
  if (asked instanceof vscode.Uri) return asked;
  if (typeof asked === 'string') return vscode.Uri.parse(asked);
  const document = vscode.window.activeTextEditor?.document;
  if (document && isModel(document)) return document.uri;
  void vscode.window.showInformationMessage('Open a model first: SDF, URDF or xacro.');
  return undefined;
}

/** The document as it is on the disk, for programs that read it there. */
export async function saved(uri: vscode.Uri): Promise<void> {
  const open = vscode.workspace.textDocuments.find((each) => each.uri.toString() === uri.toString());
  if (open?.isDirty) await open.save();
}
