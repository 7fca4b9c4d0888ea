// The menu of an icon: everything that can be done with it, with the keys that do the same.
import { useRef } from "react";
import { Menu, MenuItem, Popover, Separator } from "react-aria-components";
import { iconOf } from "../model/operation";
import { outputs } from "../model/ports";
import { runFrom } from "../state/acts";
import { toggleBreakpoint } from "../state/breakpoints";
import { useCell } from "../state/cell";
import { select, shownOperation, useDrawing } from "../state/drawing";
import { collapseSelected, copySelected, expandIcon, pasteClip, popOpen, removeSelected } from "../state/edits";
import { notice } from "../state/acts";
import { openIcon, openWindow } from "../state/windows";
import type { SymbolName } from "../symbols/drawings";
import { Symbol } from "../symbols/Symbol";
import { t, type Word } from "../words/words";
import { focusIcon } from "./keys";
import { useView } from "./view";

export function Item({ id, symbol, word, keys, danger = false, disabled = false, chosen = false }: { id: string; symbol: SymbolName; word: Word; keys?: string; danger?: boolean; disabled?: boolean; chosen?: boolean }) {
  return (
    <MenuItem id={id} className={danger ? "menu-item danger" : "menu-item"} textValue={t(word)} isDisabled={disabled}>
      <Symbol name={symbol} size={18} />
      <span className="name">{t(word)}</span>
      {keys && <kbd>{keys}</kbd>}
      {chosen && <><Symbol name="tick" size={16} /><span className="hidden">{t("menu.on")}</span></>}
    </MenuItem>
  );
}

export function IconMenu() {
  const menu = useView((state) => state.menu);
  const anchor = useRef<HTMLSpanElement>(null);
  const operation = useDrawing(shownOperation);
  const trail = useDrawing((state) => state.trail);
  const selected = useDrawing((state) => state.selected);
  const icon = menu && iconOf(operation, menu.icon);
  const path = [...trail, menu?.icon].join("/");
  const hasBreak = useCell((cell) => cell.present?.snapshot.breakpoints.some((each) => each.icon === path) ?? false) || icon?.break !== undefined;
  const close = () => useView.setState({ menu: undefined });
  const act = (key: string) => {
    if (!icon) return;
    if (!selected.has(icon.id)) select([icon.id], icon.id);
    const refused = (why: string | undefined) => why !== undefined && notice("error", why);
    if (key === "open") openIcon(operation.name, icon.id);
    if (key === "enter") popOpen(icon.id);
    if (key === "tune") openWindow("tuning", `${operation.name}/${icon.id}`);
    if (key === "help" && icon.skill) openWindow("skill", icon.skill);
    if (key === "connect") useView.setState({ connecting: { icon: icon.id, port: undefined } });
    if (key === "run") void runFrom(path);
    if (key === "break") toggleBreakpoint(path);
    if (key === "collapse") refused(collapseSelected(t("collapse.name")));
    if (key === "expand") refused(expandIcon(icon.id));
    if (key === "copy") copySelected();
    if (key === "paste") pasteClip();
    if (key === "delete") removeSelected();
    if (["enter", "collapse", "expand", "copy"].includes(key)) focusIcon(useDrawing.getState().focus);
  };
  return (
    <>
      <span ref={anchor} className="menu-anchor" style={{ position: "fixed", left: menu?.screen[0] ?? 0, top: menu?.screen[1] ?? 0 }} />
      <Popover className="popover" aria-label={t("menu.label", { icon: menu?.icon ?? "" })} triggerRef={anchor} isOpen={icon !== undefined} placement="bottom start" onOpenChange={(open) => !open && close()}>
        {icon && (
          <Menu className="menu" autoFocus="first" aria-label={t("menu.label", { icon: icon.id })} onAction={(key) => act(String(key))} onClose={close}>
            <Item id="open" symbol="settings" word="menu.open" keys="Enter" />
            {icon.kind === "operation" && !icon.file && <Item id="enter" symbol="enter" word="menu.enter" keys="Ctrl+↓" />}
            {icon.kind === "skill" && <Item id="tune" symbol="settings" word="menu.tune" />}
            {icon.kind === "skill" && <Item id="help" symbol="help" word="menu.help" />}
            {outputs(icon).length > 0 && <Item id="connect" symbol="link" word="menu.connect" keys="Ctrl+K" />}
            <Separator />
            <Item id="run" symbol="from" word="menu.runFrom" disabled={icon.kind === "start"} />
            <Item id="break" symbol={hasBreak ? "breakpoint-off" : "breakpoint"} word={hasBreak ? "menu.unbreak" : "menu.break"} />
            <Separator />
            {icon.kind === "operation" ? <Item id="expand" symbol="expand" word="menu.expand" /> : <Item id="collapse" symbol="collapse" word="menu.collapse" />}
            <Item id="copy" symbol="copy" word="menu.copy" keys="Ctrl+C" />
            <Item id="paste" symbol="paste" word="menu.paste" keys="Ctrl+V" />
            <Item id="delete" symbol="trash" word="menu.delete" keys="Delete" danger />
          </Menu>
        )}
      </Popover>
    </>
  );
}
