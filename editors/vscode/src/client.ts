// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
// The language client. The server does the work; what VS Code alone can do is added to its answers.

import * as vscode from 'vscode';
import { LanguageClient } from 'vscode-languageclient/node';

import { SELECTOR } from './documents';
import type { Program } from './program';
import { serverArguments } from './settings';

/** The code of a finding opens the page of its rule. */
function linkRules(findings: vscode.Diagnostic[]): vscode.Diagnostic[] {
  for (const finding of findings) {
    if (typeof finding.code !== 'string') continue;
    const rule = encodeURIComponent(JSON.stringify([finding.code]));
    finding.code = {
      value: finding.code,
      target: vscode.Uri.parse(`command:rigor.explain?${rule}`, true),
    };
  }
  return findings;
}

export function makeClient(program: Program): LanguageClient {
  return new LanguageClient(
    'rigor',
    'rigor',
    // A function, so that a restart takes the settings as they are then.
    () => program.started(['lsp', ...serverArguments()]),
    {
      documentSelector: SELECTOR,
      diagnosticCollectionName: 'rigor',
      initializationOptions: { commands: ['rigor.view', 'rigor.simulate'], pictures: true },
      middleware: {
        handleDiagnostics: (uri, findings, next) => next(uri, linkRules(findings)),
        provideDiagnostics: async (document, previous, token, next) => {
          const report = await next(document, previous, token);
          if (report && 'items' in report) linkRules(report.items);
          return report;
        },
      },
    },
  );
}
