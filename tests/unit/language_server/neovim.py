"""Neovim, headless, as a client of pal language-server: findings, hover, completion, rename, format.

Usage: neovim.py NVIM PAL SOURCE_DIR. Neovim 0.7 or newer.
"""
import json
import pathlib
import shutil
import subprocess
import sys
import tempfile

SCRIPT = """
local out, pal, root = OUT, PAL, ROOT
local result = {}
local function finish() local f = io.open(out, "w"); f:write(vim.json.encode(result)); f:close(); vim.cmd("qa!") end
local ok, why = pcall(function()
  vim.cmd("edit " .. root .. "/touch/touch.pal")
  local client = vim.lsp.start_client({ name = "pal", cmd = { pal, "language-server" }, root_dir = root })
  vim.lsp.buf_attach_client(0, client)
  assert(vim.wait(10000, function() return vim.lsp.buf_get_clients(0)[client] ~= nil end, 10), "no client")
  local function place(pattern)
    vim.fn.cursor(1, 1)
    assert(vim.fn.search(pattern, "c") > 0, pattern)
    return vim.lsp.util.make_position_params()
  end
  local function ask(method, params)
    local answers = assert(vim.lsp.buf_request_sync(0, method, params, 10000), method)
    return answers[client].result
  end
  result.clean = #vim.diagnostic.get(0)
  result.hover = ask("textDocument/hover", place("Zforce from LS1")).contents.value
  local line = vim.fn.search("WTM( Zforce from LS1 )", "cw")
  local written = vim.fn.getline(line)
  vim.fn.setline(line, (written:gsub("Zforce", "Zforse")))
  assert(vim.wait(10000, function() return #vim.diagnostic.get(0) > 0 end, 10), "no finding")
  result.finding = vim.diagnostic.get(0)[1].message
  vim.fn.setline(line, (written:gsub("LS1 %)", "")))
  vim.fn.cursor(line, #vim.fn.getline(line))
  local params = vim.lsp.util.make_position_params()
  params.position.character = #vim.fn.getline(line)
  result.completion = {}
  for _, item in ipairs(ask("textDocument/completion", params)) do table.insert(result.completion, item.label) end
  vim.fn.setline(line, "      " .. written)
  vim.lsp.buf.formatting_sync(nil, 10000)
  result.formatted = vim.fn.getline(line) == written
  local renaming = place("pc-reach")
  renaming.newName = "reached"
  vim.lsp.util.apply_workspace_edit(ask("textDocument/rename", renaming), "utf-16")
  result.renamed = vim.fn.search("pc-reach", "cw") == 0 and vim.fn.search("SPC( reached )", "cw") > 0
  result.definition = #ask("textDocument/definition", place("Zforce from LS1"))
end)
result.error = not ok and tostring(why) or nil
finish()
"""


def main(nvim, pal, source):
    with tempfile.TemporaryDirectory() as folder:
        work = pathlib.Path(folder)
        shutil.copytree(pathlib.Path(source) / "skills_pal", work / "skills", ignore=shutil.ignore_patterns("*.cpp", "*.hpp"))
        script = SCRIPT.replace("OUT", json.dumps(str(work / "out.json"))).replace("PAL,", json.dumps(pal) + ",", 1)
        script = script.replace("out, pal, root = ", "out, pal, root = ", 1).replace("ROOT", json.dumps(str(work / "skills")), 1)
        (work / "client.lua").write_text(script)
        subprocess.run([nvim, "--headless", "-u", "NONE", "-i", "NONE", "-c", f"luafile {work}/client.lua"],
                       timeout=60, check=True, env={"HOME": folder, "PATH": "/usr/bin:/bin", "XDG_RUNTIME_DIR": folder})
        result = json.loads((work / "out.json").read_text())
    print(json.dumps(result, indent=1))
    assert "error" not in result, result["error"]
    assert result["clean"] == 0
    assert "Content: value, greatest: real, in N" in result["hover"]
    assert "there is no message 'Zforse'" in result["finding"]
    assert "LS1" in result["completion"] and "SD1" not in result["completion"]
    assert result["formatted"] and result["renamed"] and result["definition"] == 1


main(*sys.argv[1:])
