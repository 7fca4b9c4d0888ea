// Which window a print shows: of those that can be printed, the one on top, and nothing of the page around it. Paper is light.
const printable = '.window:is([data-window="production"], [data-window="storyboard"])';

const root = document.documentElement;
let theme: string | undefined;

addEventListener("beforeprint", () => {
  theme = root.dataset["theme"];
  root.dataset["theme"] = "light";
  const shown = [...document.querySelectorAll<HTMLElement>(printable)].at(-1);
  if (shown) shown.dataset["printed"] = "";
});
addEventListener("afterprint", () => {
  if (theme !== undefined) root.dataset["theme"] = theme;
  for (const each of document.querySelectorAll<HTMLElement>("[data-printed]")) delete each.dataset["printed"];
});
