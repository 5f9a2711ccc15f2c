// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// VS Code as a person uses it, by keyboard, in a browser.
//
//   const workbench = await Workbench.open(command, { user, folder, browser });
//   await workbench.openFile('robot.urdf');
//   await workbench.close();

import { spawn } from 'node:child_process';
import { mkdirSync, openSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

import { chromium } from 'playwright-core';

const SETTINGS = {
  'chat.commandCenter.enabled': false,
  'editor.minimap.enabled': false,
  'extensions.ignoreRecommendations': true,
  'files.autoSave': 'afterDelay',
  'files.autoSaveDelay': 50,
  'git.enabled': false,
  'security.workspace.trust.enabled': false,
  'telemetry.telemetryLevel': 'off',
  'terminal.integrated.gpuAcceleration': 'off', // what is written in it is then in the page
  'window.commandCenter': false,
  'workbench.colorTheme': 'Default Light Modern',
  'workbench.layoutControl.enabled': false,
  'workbench.startupEditor': 'none',
  'workbench.tips.enabled': false,
};

const SOFTWARE = ['--use-gl=angle', '--use-angle=swiftshader', '--enable-unsafe-swiftshader'];

/** ms. Two cores that do other things as well. */
const PATIENCE = 60_000;

/** `condition` is asked until it gives something. */
export async function until(what, condition, patience = PATIENCE) {
  const end = Date.now() + patience;
  for (;;) {
    const found = await condition();
    if (found) return found;
    if (Date.now() > end) throw new Error(`waited in vain for ${what}`);
    await new Promise((done) => setTimeout(done, 50));
  }
}

export class Workbench {
  static async open(command, { user, folder, browser }) {
    mkdirSync(join(user, 'User'), { recursive: true });
    writeFileSync(join(user, 'User', 'settings.json'), JSON.stringify(SETTINGS));
    const [program, ...options] = command;
    const workbench = new Workbench();
    const quiet = ['--disable-telemetry', '--disable-update-check'];
    const log = openSync(join(user, 'server.log'), 'w');
    workbench.server = spawn(program, [...options, '--bind-addr', '127.0.0.1:0', ...quiet], {
      stdio: ['ignore', 'pipe', log],
    });
    const address = await new Promise((resolve, reject) => {
      let said = '';
      workbench.server.stdout.setEncoding('utf8').on('data', (text) => {
        said += text;
        const found = said.match(/listening on (http:\S+)/);
        if (found) resolve(found[1]);
      });
      workbench.server.on('close', () => reject(new Error(`code-server ended:\n${said}`)));
    });
    workbench.browser = await chromium.launch({
      executablePath: browser,
      args: ['--no-sandbox', ...SOFTWARE],
    });
    workbench.page = await workbench.browser.newPage({ viewport: { width: 1100, height: 620 } });
    workbench.page.setDefaultTimeout(PATIENCE);
    await workbench.page.goto(`${address}?folder=${encodeURIComponent(folder)}`);
    await workbench.page.locator('.explorer-folders-view .monaco-list-row').first().waitFor();
    return workbench;
  }

  async close() {
    await this.browser?.close();
    this.server.kill();
  }

  key(keys) {
    return this.page.keyboard.press(keys);
  }

  type(text) {
    return this.page.keyboard.type(text);
  }

  /** Fills in the box at the top, and takes the first that is offered. What is loaded meanwhile may close it: then once more. */
  async quick(keys, text, offered) {
    const widget = this.page.locator('.quick-input-widget');
    const box = widget.locator('.quick-input-box input.input');
    const row = widget.locator('.quick-input-list .monaco-list-row', { hasText: offered ?? '' });
    await until(`the box for ${text}`, async () => {
      await this.key(keys);
      try {
        await box.fill(text, { timeout: 5000 });
        if (offered) await row.first().waitFor({ timeout: 15_000 });
        await box.press('Enter', { timeout: 20_000 });
        return true;
      } catch {
        await this.key('Escape');
        return false;
      }
    });
    // What was run may ask at once, in the same box, which is then never seen hidden.
    await until(`the box for ${text} to be gone`, async () => {
      const said = await box.inputValue({ timeout: 1000 }).catch(() => undefined);
      return said !== text || !(await widget.isVisible());
    });
  }

  run(title) {
    return this.quick('F1', `>${title}`, title);
  }

  /** Of the dialog of that title, which asks for a file: the one that it offers. */
  async acceptPath(title) {
    await this.page.locator('.quick-input-title', { hasText: title }).waitFor();
    const box = this.page.locator('.quick-input-box input.input');
    await until('a path that is offered', async () => (await box.inputValue()).includes('/'));
    await this.page.locator('.quick-input-widget').getByRole('button', { name: 'OK' }).click();
    await this.page.locator('.quick-input-widget').waitFor({ state: 'hidden' });
  }

  /** By the explorer, as the search for files needs a program of its own. */
  async openFile(name) {
    await this.page.locator('.explorer-folders-view .monaco-list-row', { hasText: name }).dblclick();
    await this.isEditing(name);
  }

  async showTab(name) {
    await this.page.locator('.tab', { hasText: name }).first().click();
    await this.isEditing(name);
  }

  /** Until keys go to the file's text. */
  async isEditing(name) {
    const group = this.page.locator('.editor-group-container.active');
    await group.locator('.tab.active', { hasText: name }).waitFor();
    await group.locator('.monaco-editor.focused .view-lines').waitFor();
  }

  /** Into the first `mark` of what the editor shows as `text`, `moved` characters on. Lines and columns count from 1. */
  async goTo(text, mark, moved = 0) {
    const before = text.slice(0, text.indexOf(mark) + moved).split('\n');
    const [line, column] = [before.length, before.at(-1).length + 1];
    await this.quick('Control+G', `:${line}:${column}`);
    await this.page.locator('.statusbar-item', { hasText: `Ln ${line}, Col ${column}` }).waitFor();
  }

  /** The problems that are listed, each a line of text. */
  problems() {
    return this.page.locator('.markers-panel .monaco-list-row').allInnerTexts();
  }

  /** The frame in which the page of `rigor view` is. */
  viewFrame() {
    return until('the page of the view', async () => {
      for (const frame of this.page.frames()) {
        const is = await frame.evaluate(() => typeof window.rigor === 'object').catch(() => false);
        if (is) return frame;
      }
      return null;
    });
  }
}
