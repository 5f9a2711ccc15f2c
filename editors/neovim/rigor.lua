-- Copyright 2026 The rigor authors
-- SPDX-License-Identifier: Apache-2.0
-- 0.8 or later, in init.lua
vim.filetype.add({ extension = { sdf = "xml", world = "xml", urdf = "xml", xacro = "xml", srdf = "xml" } })
vim.api.nvim_create_autocmd("FileType", {
  pattern = "xml",
  callback = function(event)
    vim.lsp.start({
      name = "rigor",
      cmd = { "rigor", "lsp" },
      root_dir = vim.fs.dirname(vim.fs.find({ "rigor.toml", "package.xml", ".git" }, { upward = true,
        path = vim.api.nvim_buf_get_name(event.buf) })[1]),
    })
  end,
})
