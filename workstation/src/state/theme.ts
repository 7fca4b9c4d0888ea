// Light or dark: as the system has it, or as the switch says.
export const themes = ["system", "light", "dark"] as const;
export type Theme = (typeof themes)[number];

const key = "workcell-theme";
const dark = matchMedia("(prefers-color-scheme: dark)");

export const theme = (): Theme => (localStorage.getItem(key) as Theme | null) ?? "system";

export function applyTheme(): void {
  const wanted = theme();
  document.documentElement.dataset.theme = wanted === "system" ? (dark.matches ? "dark" : "light") : wanted;
}

export function setTheme(wanted: Theme): void {
  localStorage.setItem(key, wanted);
  applyTheme();
}

dark.addEventListener("change", applyTheme);
