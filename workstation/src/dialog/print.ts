// Which window a print shows: of those that can be printed, the one on top, and nothing of the page around it.
const printable = '.window:is([data-window="production"], [data-window="storyboard"])';

addEventListener("beforeprint", () => {
  const shown = [...document.querySelectorAll<HTMLElement>(printable)].at(-1);
  if (shown) shown.dataset["printed"] = "";
});
addEventListener("afterprint", () => {
  for (const each of document.querySelectorAll<HTMLElement>("[data-printed]")) delete each.dataset["printed"];
});
