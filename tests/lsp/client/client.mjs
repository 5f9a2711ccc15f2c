// Copyright 2026 The rigor authors
// SPDX-License-Identifier: Apache-2.0
//
// Every feature of `rigor lsp` through vscode-languageserver-protocol over stdio, on a robot that the client keeps:
// what the server edits, the client applies, and tells it.

import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { mkdtempSync, writeFileSync } from "node:fs";
import { connect, createServer } from "node:net";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import rpc from "vscode-jsonrpc/node.js";
import * as lsp from "vscode-languageserver-protocol";

const folder = mkdtempSync(join(tmpdir(), "rigor-lsp-"));
const path = join(folder, "robot.urdf");
const uri = pathToFileURL(path).toString();
let text = `<robot name="r">
  <link name="base"/>
  <link name="arm">
    <collision>
      <geometry>
        <box size="1 1 1"/>
      </geometry>
    </collision>
  </link>
  <joint name="turn" type="revolute">
    <parent link="base"/>
    <child link="arm"/>
    <axis xyz="0 0 1"/>
    <limit lower="1" upper="-1" effort="1" velocity="1"/>
  </joint>
  <material name="red"><color rgba="1 0 0 1"/></material>
</robot>
`;
writeFileSync(path, text);
writeFileSync(join(folder, "controllers.yaml"), "arm:\n  ros__parameters:\n    joints: [turn, other]\n");

let version = 1;
const server = spawn(process.argv[2], ["lsp"], { stdio: ["pipe", "pipe", "inherit"] });
const exited = new Promise((resolve) => server.on("exit", resolve));
const connection = rpc.createMessageConnection(
  new rpc.StreamMessageReader(server.stdout), new rpc.StreamMessageWriter(server.stdin));
const waiting = [];
connection.onNotification(lsp.PublishDiagnosticsNotification.method, (params) => {
  if (params.uri === uri && params.version === version) waiting.splice(0).forEach((take) => take(params));
});
connection.listen();
const published = () => new Promise((resolve) => waiting.push(resolve));
const ask = (request, params) => connection.sendRequest(request.method ?? request, params);

const document = { uri };
const offsetOf = (position) => text.split("\n").slice(0, position.line).reduce((sum, line) => sum + line.length + 1, 0) + position.character;
const positionOf = (mark, moved = 0) => {
  const before = text.slice(0, text.indexOf(mark) + moved);
  const lines = before.split("\n");
  return { line: lines.length - 1, character: lines[lines.length - 1].length };
};
const at = (mark, moved) => ({ textDocument: document, position: positionOf(mark, moved) });
const apply = async (edits) => {
  const sorted = [...edits].sort((a, b) => offsetOf(b.range.start) - offsetOf(a.range.start));
  const contentChanges = sorted.map((edit) => ({ range: edit.range, text: edit.newText }));
  for (const edit of sorted) text = text.slice(0, offsetOf(edit.range.start)) + edit.newText + text.slice(offsetOf(edit.range.end));
  const next = published();
  await connection.sendNotification(lsp.DidChangeTextDocumentNotification.method,
    { textDocument: { uri, version: ++version }, contentChanges });
  return next;
};

const { capabilities } = await ask(lsp.InitializeRequest, {
  processId: process.pid, rootUri: pathToFileURL(folder).toString(),
  capabilities: { textDocument: { completion: { completionItem: { snippetSupport: true } } } },
  initializationOptions: { rulePages: "https://example.org/rules/" } });
assert.equal(capabilities.positionEncoding, "utf-16");
await connection.sendNotification(lsp.InitializedNotification.method, {});
const first = published();
await connection.sendNotification(lsp.DidOpenTextDocumentNotification.method,
  { textDocument: { uri, languageId: "xml", version, text } });
const found = (await first).diagnostics;
const inverted = found.find((each) => each.code === "joint-limit-inverted");
assert.ok(inverted, JSON.stringify(found));
assert.equal(inverted.codeDescription.href, "https://example.org/rules/joint-limit-inverted.html");

// A fix is applied, and its finding is gone.
const actions = await ask(lsp.CodeActionRequest, { textDocument: document, range: inverted.range, context: { diagnostics: [inverted] } });
const swap = actions.find((action) => action.kind === "quickfix" && action.title.includes("swap"));
assert.ok(swap, JSON.stringify(actions.map((action) => action.title)));
const after = await apply(swap.edit.changes[uri]);
assert.ok(!after.diagnostics.some((each) => each.code === "joint-limit-inverted"));
assert.equal(after.version, version);

// What a link weighs is computed.
const rewrites = await ask(lsp.CodeActionRequest, { textDocument: document, range: { start: positionOf("<box"), end: positionOf("<box") }, context: { diagnostics: [] } });
const inertial = await ask(lsp.CodeActionResolveRequest, rewrites.find((action) => action.title.startsWith("compute this inertial")));
await apply(inertial.edit.changes[uri]);
assert.match(text, /<mass value="1000"\/>/);

// Names.
const definition = await ask(lsp.DefinitionRequest, at('child link="arm"', 12));
assert.deepEqual(definition.range.start, positionOf('name="arm"', 6));
assert.equal((await ask(lsp.ReferencesRequest, { ...at('name="arm"', 7), context: { includeDeclaration: true } })).length, 2);
assert.equal((await ask(lsp.DocumentHighlightRequest, at('name="arm"', 7))).length, 2);
assert.equal((await ask(lsp.PrepareRenameRequest, at('name="arm"', 7))).placeholder, "arm");
await apply((await ask(lsp.RenameRequest, { ...at('name="arm"', 7), newName: "forearm" })).changes[uri]);
assert.match(text, /<child link="forearm"\/>/);
await assert.rejects(ask(lsp.RenameRequest, { ...at('name="forearm"', 7), newName: "base" }), /already/);

// What is offered and shown.
assert.ok((await ask(lsp.CompletionRequest, at('type="revolute"', 6))).some((item) => item.label === "prismatic"));
assert.match((await ask(lsp.HoverRequest, at('name="forearm"', 7))).contents.value, /1000 kg/);
assert.equal((await ask(lsp.DocumentSymbolRequest, { textDocument: document }))[0].children.length, 4);
assert.ok((await ask(lsp.WorkspaceSymbolRequest, { query: "frm" })).some((symbol) => symbol.name === "forearm"));
assert.ok((await ask(lsp.FoldingRangeRequest, { textDocument: document })).length > 3);
assert.equal((await ask(lsp.SelectionRangeRequest, { textDocument: document, positions: [positionOf("1 1 1")] })).length, 1);
assert.deepEqual((await ask(lsp.DocumentColorRequest, { textDocument: document }))[0].color, { red: 1, green: 0, blue: 0, alpha: 1 });
const whole = { start: { line: 0, character: 0 }, end: { line: 99, character: 0 } };
assert.equal((await ask(lsp.ColorPresentationRequest, { textDocument: document, range: whole, color: { red: 0.5, green: 0, blue: 0, alpha: 1 } }))[0].label, "0.5 0 0 1");
assert.equal((await ask(lsp.InlayHintRequest, { textDocument: document, range: whole })).length, 2);
assert.match((await ask(lsp.CodeLensRequest, { textDocument: document }))[0].command.title, /2 links/);
assert.equal((await ask(lsp.LinkedEditingRangeRequest, at("<collision", 3))).ranges.length, 2);
assert.deepEqual(await ask(lsp.DocumentLinkRequest, { textDocument: document }), []);
await ask(lsp.SemanticTokensRequest, { textDocument: document });
assert.equal((await ask("textDocument/diagnostic", { textDocument: document })).kind, "full");

// Formatting, and typing an end tag.
await apply([{ range: { start: positionOf("<axis"), end: positionOf("<axis") }, newText: "   " }]);
await apply(await ask(lsp.DocumentFormattingRequest, { textDocument: document, options: { tabSize: 2, insertSpaces: true } }));
assert.match(text, /\n    <axis xyz/);
assert.deepEqual(await ask(lsp.DocumentRangeFormattingRequest, { textDocument: document, range: whole, options: { tabSize: 2, insertSpaces: true } }), []);
await apply([{ range: { start: positionOf("</robot>"), end: positionOf("</robot>") }, newText: '<link name="é">' }]);
const typed = await ask(lsp.DocumentOnTypeFormattingRequest, { ...at('name="é">', 9), ch: ">", options: { tabSize: 2, insertSpaces: true } });
assert.equal(typed[0].newText, "</link>");
await apply(typed);

// A rename reaches the YAML of controllers, and lists what may be the name for the user to confirm.
await apply(await ask(lsp.RenameRequest, { ...at('name="turn"', 7), newName: "elbow" }).then((edit) => {
  const controllers = edit.changes[pathToFileURL(join(folder, "controllers.yaml")).toString()];
  assert.equal(controllers.length, 1);
  assert.equal(controllers[0].newText, "elbow");
  return edit.changes[uri];
}));

// Templates: the call hierarchy of macros, colors of their names, and a value that becomes a property and one again.
const templatePath = join(folder, "robot.urdf.xacro");
const template = { uri: pathToFileURL(templatePath).toString() };
const templateText = `<robot name="t" xmlns:xacro="http://www.ros.org/wiki/xacro">
  <xacro:macro name="wheel" params="side"><link name="\${side}_wheel"/></xacro:macro>
  <xacro:macro name="axle" params=""><xacro:wheel side="left"/><xacro:wheel side="right"/></xacro:macro>
  <link name="body"><inertial><mass value="2.5"/></inertial></link>
  <xacro:axle/>
</robot>
`;
const placeIn = (mark, moved = 0) => {
  const lines = templateText.slice(0, templateText.indexOf(mark) + moved).split("\n");
  return { line: lines.length - 1, character: lines[lines.length - 1].length };
};
await connection.sendNotification(lsp.DidOpenTextDocumentNotification.method,
  { textDocument: { ...template, languageId: "xml", version: 1, text: templateText } });
const [wheel] = await ask(lsp.CallHierarchyPrepareRequest, { textDocument: template, position: placeIn('name="wheel"', 7) });
assert.equal(wheel.name, "wheel");
const incoming = await ask(lsp.CallHierarchyIncomingCallsRequest, { item: wheel });
assert.deepEqual(incoming.map((call) => [call.from.name, call.fromRanges.length]), [["axle", 2]]);
const outgoing = await ask(lsp.CallHierarchyOutgoingCallsRequest, { item: incoming[0].from });
assert.deepEqual(outgoing.map((call) => call.to.name), ["wheel"]);
assert.ok((await ask(lsp.SemanticTokensRequest, { textDocument: template })).data.length >= 5 * 6);
const value = placeIn('"2.5"', 2);
const [extract] = await ask(lsp.CodeActionRequest, { textDocument: template, range: { start: value, end: value },
  context: { diagnostics: [], only: ["refactor.extract"] } });
assert.equal(extract.title, "extract to property 'mass_value'");
const extracted = (await ask(lsp.CodeActionResolveRequest, extract)).edit.changes[template.uri];
assert.ok(extracted.some((edit) => edit.newText === "${mass_value}"), JSON.stringify(extracted));
assert.match((await ask("rigor/expanded", { textDocument: template })).text, /left_wheel/);

await assert.rejects(ask("no/such", {}), { code: -32601 });
assert.equal(await ask(lsp.ShutdownRequest), null);
await connection.sendNotification(lsp.ExitNotification.method);
assert.equal(await exited, 0);

// The same on a port of this machine.
const port = await new Promise((resolve) => {
  const probe = createServer().listen(0, "127.0.0.1", () => {
    const { port } = probe.address();
    probe.close(() => resolve(port));
  });
});
const listening = spawn(process.argv[2], ["lsp", "--socket", String(port)], { stdio: ["ignore", "ignore", "inherit"] });
const ended = new Promise((resolve) => listening.on("exit", resolve));
const connected = async () => {
  for (;;) {
    const socket = connect(port, "127.0.0.1");
    const result = await new Promise((resolve) => {
      socket.once("connect", () => resolve(socket));
      socket.once("error", () => resolve(null));
    });
    if (result) return result;
    if (listening.exitCode !== null) throw new Error("the server has ended");
  }
};
const socket = await connected();
const byPort = rpc.createMessageConnection(new rpc.SocketMessageReader(socket), new rpc.SocketMessageWriter(socket));
byPort.listen();
const answer = await byPort.sendRequest("initialize", { processId: null, rootUri: null, capabilities: {} });
assert.equal(answer.serverInfo.name, "rigor");
await byPort.sendRequest("shutdown");
await byPort.sendNotification("exit");
assert.equal(await ended, 0);
console.log("all features answered");
