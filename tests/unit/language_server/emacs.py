"""Emacs without a screen, with eglot, as a client of pal language-server: findings, hover, completion, quick fix, rename.

Usage: emacs.py EMACS PAL SOURCE_DIR. Emacs 28 with elpa-eglot, or 29.
"""
import json
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

SCRIPT = r"""
(setq package-directory-list '("/usr/share/emacs/site-lisp/elpa" "/usr/share/emacs/28.2/site-lisp/elpa"))
(require 'package)
(package-initialize)
(require 'eglot)
SETTINGS
(setq eglot-sync-connect 20 eglot-autoshutdown nil make-backup-files nil create-lockfiles nil)
(fset 'y-or-n-p (lambda (&rest _) t)) ; a rename over several files is asked about
(defvar result nil)
(defun note (key value) (push (cons key value) result))
(defun wait-for (what)
  (let ((end (+ (float-time) 20)))
    (while (and (not (funcall what)) (< (float-time) end)) (accept-process-output nil 0.05))
    (or (funcall what) (error "nothing came of %S" what))))
(defun findings () (mapcar #'flymake-diagnostic-text (flymake-diagnostics)))
(defun ask (method &optional more)
  (jsonrpc-request (eglot--current-server-or-lose) method (append (eglot--TextDocumentPositionParams) more)))
(condition-case why
    (progn
      (find-file "ROOT/touch/touch.pal")
      (note 'mode (symbol-name major-mode))
      (flymake-mode 1)
      (eglot-ensure)
      (run-hooks 'post-command-hook)
      (wait-for (lambda () (eglot-managed-p)))
      (goto-char (point-min))
      (search-forward "WTM( Zforce from LS1")
      (search-backward "Zforce")
      (note 'hover (plist-get (plist-get (ask :textDocument/hover) :contents) :value))
      (delete-char 6)
      (insert "Zforse")
      (eglot--signal-textDocument/didChange)
      (wait-for (lambda () (flymake-start) (cl-some (lambda (each) (string-match-p "Zforse" each)) (findings))))
      (note 'finding (car (findings)))
      (backward-char 2)
      (let* ((actions (eglot-code-actions (line-beginning-position) (line-end-position)))
             (first (cl-find-if (lambda (each) (string-match-p "replace 'Zforse'" (plist-get each :title))) actions)))
        (note 'action (plist-get first :title))
        (eglot--apply-workspace-edit (plist-get first :edit)))
      (eglot--signal-textDocument/didChange)
      (note 'mended (save-excursion (goto-char (point-min)) (not (search-forward "Zforse" nil t))))
      (wait-for (lambda () (flymake-start) (not (cl-some (lambda (each) (string-match-p "Zforse" each)) (findings)))))
      (goto-char (point-min))
      (search-forward "pc-reach")
      (backward-char 2)
      (eglot-rename "reached")
      (note 'renamed (save-excursion (goto-char (point-min)) (and (not (search-forward "pc-reach" nil t)) (search-forward "SPC( reached )" nil t) t)))
      (goto-char (point-min))
      (search-forward "TXM( request Zforce from ")
      (note 'completion (vconcat (mapcar (lambda (each) (plist-get each :label)) (ask :textDocument/completion)))))
  (error (note 'error (format "%S" why))))
(with-temp-file "OUT" (insert (json-encode result)))
(let ((kill-emacs-hook nil)) (kill-emacs 0))
"""


def settings(source):
    """What docs/how-to/editor.md tells users of Emacs to write."""
    text = (pathlib.Path(source) / "docs/how-to/editor.md").read_text()
    return re.search(r"```elisp\n(.*?)```", text, re.S).group(1)


def main(emacs, pal, source):
    with tempfile.TemporaryDirectory() as folder:
        work = pathlib.Path(folder)
        shutil.copytree(pathlib.Path(source) / "skills_pal", work / "skills", ignore=shutil.ignore_patterns("*.cpp", "*.hpp"))
        (work / "skills/.git").mkdir()  # the root of a project
        (work / "bin").mkdir()
        (work / "bin/pal").symlink_to(pathlib.Path(pal).resolve())
        script = SCRIPT.replace("SETTINGS", settings(source)).replace("ROOT", str(work / "skills")).replace("OUT", str(work / "out.json"))
        (work / "client.el").write_text(script)
        subprocess.run([emacs, "--batch", "--no-site-file", "-l", str(work / "client.el")], timeout=100, check=True,
                       env={"HOME": folder, "PATH": f"{work / 'bin'}:/usr/bin:/bin", "LANG": "C.UTF-8"})
        result = json.loads((work / "out.json").read_text())
    print(json.dumps(result, indent=1))
    assert "error" not in result, result["error"]
    assert result["mode"] == "pal-mode"
    assert "Content: value, greatest: real, in N" in result["hover"]
    assert "there is no message 'Zforse'" in result["finding"]
    assert result["mended"] and result["renamed"]
    assert "LS1" in result["completion"] and "SD1" not in result["completion"]


main(*sys.argv[1:])
