// Finds a program: where the setting says, or on the path. Knows nothing of VS Code.
import { execFile } from "node:child_process";
import { accessSync, constants, statSync } from "node:fs";
import { homedir } from "node:os";
import { delimiter, isAbsolute, join } from "node:path";

function isProgram(path: string): boolean {
  try {
    accessSync(path, constants.X_OK);
    return statSync(path).isFile();
  } catch {
    return false;
  }
}

/** `set`: the setting, may begin with ~; "" is none. `folder`: what a relative setting is relative to. */
export function findProgram(name: string, set: string, folder: string | undefined, path = process.env.PATH ?? ""): string | undefined {
  if (set !== "") {
    const whole = set.startsWith("~/") ? join(homedir(), set.slice(2)) : isAbsolute(set) || folder === undefined ? set : join(folder, set);
    return isProgram(whole) ? whole : undefined;
  }
  return path
    .split(delimiter)
    .filter((each) => each !== "")
    .map((each) => join(each, name))
    .find(isProgram);
}

/** The version that `program --version` prints, if it is PAL's: other programs are called pal, too. */
export function versionOf(program: string): Promise<string | undefined> {
  return new Promise((resolve) => {
    execFile(program, ["--version"], { timeout: 10000 }, (error, out) => {
      resolve(error ? undefined : /^pal (\d+\.\d+\.\d+)\s*$/.exec(out)?.[1]);
    });
  });
}
