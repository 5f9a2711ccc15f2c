;; Copyright 2026 The rigor authors
;; SPDX-License-Identifier: Apache-2.0
;; eglot is part of Emacs from 29 on; before, it is the package eglot.
(require 'eglot)
(add-to-list 'auto-mode-alist '("\\.\\(sdf\\|world\\|urdf\\|xacro\\|srdf\\)\\'" . nxml-mode))
(add-to-list 'eglot-server-programs '(nxml-mode . ("rigor" "lsp")))
(add-hook 'nxml-mode-hook #'eglot-ensure)
