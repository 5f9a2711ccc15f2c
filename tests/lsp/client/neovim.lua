-- Copyright 2026 The rigor authors
-- SPDX-License-Identifier: Apache-2.0
--
-- A person in Neovim: opens a robot, sees a finding, applies its fix, renames a link, completes a value. Run as
--   RIGOR=... nvim --headless --clean -c 'luafile neovim.lua'

local function fail(message)
  io.stderr:write(message .. "\n")
  vim.cmd("cquit 1")
end

local function wait_for(what, condition)
  if not vim.wait(20000, condition, 20) then fail("waited in vain for " .. what) end
end

local folder = vim.fn.tempname()
vim.fn.mkdir(folder, "p")
local path = folder .. "/robot.urdf"
vim.fn.writefile({
  '<robot name="r">',
  '  <link name="base"/>',
  '  <link name="arm"/>',
  '  <joint name="turn" type="revolute">',
  '    <parent link="base"/>',
  '    <child link="arm"/>',
  '    <axis xyz="0 0 1"/>',
  '    <limit lower="1" upper="-1" effort="1" velocity="1"/>',
  "  </joint>",
  "</robot>",
}, path)
vim.cmd("edit " .. path)
local buffer = vim.api.nvim_get_current_buf()
local text = function() return table.concat(vim.api.nvim_buf_get_lines(buffer, 0, -1, false), "\n") end

local id = vim.lsp.start_client({ name = "rigor", cmd = { vim.env.RIGOR, "lsp" }, root_dir = folder })
vim.lsp.buf_attach_client(buffer, id)
local client = vim.lsp.get_client_by_id(id)

local function inverted()
  for _, each in ipairs(vim.diagnostic.get(buffer)) do
    if each.code == "joint-limit-inverted" then return each end
  end
end
wait_for("a finding", inverted)

local function ask(method, params)
  local response = client.request_sync(method, params, 20000, buffer)
  if not response or response.err then fail(method .. ": " .. vim.inspect(response)) end
  return response.result
end

local document = { uri = vim.uri_from_bufnr(buffer) }
local function at(line, character) return { textDocument = document, position = { line = line, character = character } } end

local finding = inverted()
local range = {
  start = { line = finding.lnum, character = finding.col },
  ["end"] = { line = finding.end_lnum, character = finding.end_col },
}
local actions = ask("textDocument/codeAction", { textDocument = document, range = range, context = { diagnostics = {} } })
for _, action in ipairs(actions) do
  if action.title:find("swap") then
    vim.lsp.util.apply_workspace_edit(action.edit, client.offset_encoding)
    break
  end
end
wait_for("the finding to go", function() return not inverted() end)
if not text():find('lower="-1" upper="1"', 1, true) then fail("the fix was not applied: " .. text()) end

local rename = at(2, 15)
rename.newName = "forearm"
vim.lsp.util.apply_workspace_edit(ask("textDocument/rename", rename), client.offset_encoding)
if not text():find('<child link="forearm"/>', 1, true) then fail("the link was not renamed: " .. text()) end

local offered = {}
for _, item in ipairs(ask("textDocument/completion", at(4, 18))) do offered[item.label] = true end
if not (offered.base and offered.forearm) then fail("links were not offered: " .. vim.inspect(offered)) end

local target = ask("textDocument/definition", at(5, 18))
if target.range.start.line ~= 2 then fail("the definition is elsewhere: " .. vim.inspect(target)) end

vim.lsp.stop_client(id)
print("ok")
vim.cmd("qall!")
