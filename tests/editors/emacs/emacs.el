;;; emacs.el --- A person in Emacs, with eglot  -*- lexical-binding: t; -*-
;; Copyright 2026 The rigor authors
;; SPDX-License-Identifier: Apache-2.0
;;
;; Opens a robot, sees a finding, applies its fix, renames a link in two files, completes a name, formats. Run as
;;   RIGOR=... RIGOR_EMACS_CONFIGURATION=editors/emacs/rigor.el emacs --batch -q -l emacs.el

(require 'package)
(package-initialize)
(unless (require 'eglot nil t)
  (message "Emacs with rigor is not tested: there is no eglot (apt install elpa-eglot)")
  (kill-emacs (if (getenv "RIGOR_REQUIRE_EMACS") 1 77)))
(require 'flymake)

(setq exec-path (cons (file-name-directory (getenv "RIGOR")) exec-path)
      make-backup-files nil
      eglot-autoshutdown t
      last-nonmenu-event t)  ; choices are made by keyboard
(load (expand-file-name (getenv "RIGOR_EMACS_CONFIGURATION")))

(defun wait-for (what condition)
  "Handle the server's messages until CONDITION gives something; WHAT it is."
  (let ((end (+ (float-time) 20)) found)
    (while (not (setq found (funcall condition)))
      (when (> (float-time) end) (error "Waited in vain for %s" what))
      (accept-process-output nil 0.02))
    found))

(defun expect (text)
  "Fail unless the buffer holds TEXT."
  (unless (save-excursion (goto-char (point-min)) (search-forward text nil t))
    (error "%S is not in the text:\n%s" text (buffer-string))))

(defun go-to (text moved)
  "Move to the first TEXT, and MOVED characters on."
  (goto-char (point-min))
  (search-forward text)
  (goto-char (+ (match-beginning 0) moved)))

(defconst folder (file-name-as-directory (make-temp-file "rigor-emacs-" t)))
(write-region "<robot name=\"r\">
  <group name=\"all\"><chain base_link=\"base\" tip_link=\"arm\"/></group>
</robot>
" nil (concat folder "robot.srdf"))
(write-region "" nil (concat folder "rigor.toml"))
(find-file (concat folder "robot.urdf"))
(insert "<robot name=\"r\">
  <link name=\"base\"/>
  <link name=\"arm\"/>
  <joint name=\"turn\" type=\"revolute\">
    <parent link=\"base\"/>
    <child link=\"arm\"/>
      <axis xyz=\"0 0 1\"/>
    <limit lower=\"1\" upper=\"-1\" effort=\"1\" velocity=\"1\"/>
  </joint>
</robot>
")
(save-buffer)
(unless (derived-mode-p 'nxml-mode) (error "A URDF is opened in %s" major-mode))
;; In a batch no command ends; eglot connects then.
(run-hooks 'post-command-hook)
(wait-for "the server" #'eglot-current-server)

(defun inverted ()
  "The finding that the limits are inverted."
  (flymake-start)
  (seq-find (lambda (each) (string-match-p "above the upper" (flymake-diagnostic-text each)))
            (flymake-diagnostics)))

(let ((finding (wait-for "a finding" #'inverted)))
  (cl-letf (((symbol-function 'completing-read)
             (lambda (_prompt choices &rest _)
               (let ((titles (mapcar (lambda (each) (if (consp each) (car each) each)) choices)))
                 (or (seq-find (lambda (title) (string-match-p "swap" title)) titles)
                     (error "No fix swaps the limits: %S" titles))))))
    (eglot-code-actions (flymake-diagnostic-beg finding) (flymake-diagnostic-end finding) nil t)))
(expect "lower=\"-1\" upper=\"1\"")
(eglot--signal-textDocument/didChange)
(wait-for "the finding to go" (lambda () (not (inverted))))

(go-to "name=\"arm\"" 7)
;; It asks before it changes files that are not open.
(cl-letf (((symbol-function 'y-or-n-p) (lambda (_) t)))
  (eglot-rename "forearm"))
(expect "<link name=\"forearm\"/>")
(expect "<child link=\"forearm\"/>")
(with-current-buffer (find-file-noselect (concat folder "robot.srdf"))
  (expect "tip_link=\"forearm\""))

(go-to "parent link=\"base\"" 13)
(pcase-let* ((`(,begin ,end ,table . ,_) (eglot-completion-at-point))
             (offered (all-completions (buffer-substring begin (min (point) end)) table)))
  (dolist (name '("base" "forearm"))
    (unless (member name offered) (error "%s is not offered: %S" name offered))))

(eglot-format-buffer)
(expect "\n    <axis xyz=\"0 0 1\"/>")

(delete-directory folder t)
(message "ok")
(set-buffer-modified-p nil)
(kill-emacs 0)
;;; emacs.el ends here
