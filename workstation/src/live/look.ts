// Colours of what is drawn on a canvas, where style sheets do not reach. They follow the theme.
export interface Palette {
  ink: string;
  ink2: string;
  grid: string;
  accent: string;
  error: string;
  warn: string;
  band: string;
  step: string;
  series: readonly string[];
}

let palette: Palette | undefined;
const listeners = new Set<() => void>();

new MutationObserver(() => {
  palette = undefined;
  for (const each of listeners) each();
}).observe(document.documentElement, { attributes: true, attributeFilter: ["data-theme"] });

export function look(): Palette {
  if (palette) return palette;
  const style = getComputedStyle(document.documentElement), of = (name: string) => style.getPropertyValue(name).trim();
  palette = {
    ink: of("--ink"), ink2: of("--ink-2"), grid: of("--edge"), accent: of("--accent"), error: of("--error"), warn: of("--warn-mark"), band: of("--accent-soft"), step: of("--sunken"),
    series: [1, 2, 3, 4, 5, 6].map((each) => of(`--series-${each}`)),
  };
  return palette;
}

export function onLook(listener: () => void): () => void {
  listeners.add(listener);
  return () => listeners.delete(listener);
}

export const seriesColor = (field: number): string => look().series[field % 6]!;
/** The second half of six is dashed, so that no two lines differ by colour alone. */
export const seriesDash = (field: number): number[] => (field % 6 < 3 ? [] : [7, 4]);
