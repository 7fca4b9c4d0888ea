// The bar on top: which operation, what the cell does, the acts that move it, and who has the controls.
import { useLayoutEffect } from "react";
import { Button, Menu, MenuTrigger, Popover, Separator, SubmenuTrigger, MenuItem } from "react-aria-components";
import { Tool } from "../canvas/CanvasTools";
import { Item } from "../canvas/IconMenu";
import { useFollow } from "../canvas/Follow";
import { lookAsOperator } from "../operator/mode";
import { isChanged, useDrawing } from "../state/drawing";
import { redoSaid, undoSaid } from "../state/edits";
import { exportFile, importFile, newDrawing, save } from "../state/keep";
import { setTheme, theme, themes, type Theme } from "../state/theme";
import { openWindow, useWindows } from "../state/windows";
import { Symbol } from "../symbols/Symbol";
import { currentLanguage, languages, setLanguage, t, type Language } from "../words/words";
import { ControlsButton } from "./ControlsButton";
import { RunButtons } from "./RunButtons";
import { StateBlock } from "./StateBlock";
import { ViewsMenu } from "./ViewsMenu";
import "./bar.css";

export function Bar() {
  const palette = useWindows((state) => state.palette);
  const inspector = useWindows((state) => state.inspector);
  const past = useDrawing((state) => state.history.past.length > 0), future = useDrawing((state) => state.history.future.length > 0);
  const name = useDrawing((state) => state.drawing.name);
  useSaveKey();
  return (
    <header className="bar" aria-label={t("bar.label")}>
      <h1 className="hidden">{name}</h1>
      <div className="bar-part">
        <Button className="button quiet only" aria-label={t("bar.palette")} data-selected={palette || undefined} onPress={() => useWindows.setState({ palette: !palette, ...(innerWidth < 900 && !palette ? { inspector: false } : {}) })}><Symbol name="panel" /></Button>
        <FileMenu />
        <Tool symbol="undo" text={t("bar.undo")} keys="Ctrl+Z" onPress={undoSaid} disabled={!past} />
        <Tool symbol="redo" text={t("bar.redo")} keys="Ctrl+Shift+Z" onPress={redoSaid} disabled={!future} />
      </div>
      <RunButtons />
      <StateBlock />
      <div className="bar-part">
        <ControlsButton />
        <ViewsMenu />
        <Tool symbol="help" text={t("bar.help")} keys="F1" onPress={() => openWindow("keys")} />
        <SettingsMenu />
        <Button className="button quiet only flip" aria-label={t("bar.inspector")} data-selected={inspector || undefined} onPress={() => useWindows.setState({ inspector: !inspector, ...(innerWidth < 900 && !inspector ? { palette: false } : {}) })}><Symbol name="panel" /></Button>
      </div>
    </header>
  );
}

function FileMenu() {
  const title = useDrawing((state) => state.name ?? state.drawing.name);
  const changed = useDrawing(isChanged);
  const named = useDrawing((state) => state.name !== undefined);
  const act = (key: string) => {
    if (key === "new") newDrawing();
    if (key === "open") openWindow("store");
    if (key === "save") void save();
    if (key === "saveAs") void save({ as: true });
    if (key === "versions") openWindow("versions", useDrawing.getState().name);
    if (key === "export") void exportFile();
    if (key === "story") openWindow("storyboard");
    if (key === "import") void importFile();
  };
  return (
    <>
      <MenuTrigger>
        <Button className="button quiet file" aria-label={t(changed ? "file.labelChanged" : "file.label", { name: title })}>
          <span className="file-name">{title}</span>
          {changed && <span className="unsaved" title={t("file.unsaved")} />}
          <Symbol name="down" size={16} />
        </Button>
        <Popover className="popover">
          <Menu className="menu" onAction={(key) => act(String(key))}>
            <Item id="new" symbol="plus" word="file.new" />
            <Item id="open" symbol="open" word="file.open" keys="Ctrl+O" />
            <Item id="save" symbol="save" word="file.save" keys="Ctrl+S" />
            <Item id="saveAs" symbol="save" word="file.saveAs" keys="Ctrl+Shift+S" />
            <Item id="versions" symbol="versions" word="file.versions" disabled={!named} />
            <Item id="story" symbol="list" word="story.title" />
            <Separator />
            <Item id="import" symbol="upload" word="file.import" />
            <Item id="export" symbol="download" word="file.export" />
          </Menu>
        </Popover>
      </MenuTrigger>
      <span className="save-tool"><Tool symbol="save" text={t("file.save")} keys="Ctrl+S" onPress={() => void save()} disabled={!changed && named} /></span>
    </>
  );
}

function SettingsMenu() {
  const follow = useFollow((state) => state.on);
  const act = (key: string) => {
    const [what, value] = key.split(":");
    if (what === "theme") setTheme(value as Theme);
    if (what === "language") setLanguage(value as Language);
    if (what === "follow") useFollow.setState({ on: !follow });
    if (what === "operator") lookAsOperator(true);
    if (what === "breaks") openWindow("breakpoints");
  };
  return (
    <MenuTrigger>
      <Button className="button quiet only" aria-label={t("settings.label")}><Symbol name="settings" /></Button>
      <Popover className="popover" placement="bottom end">
        <Menu className="menu" onAction={(key) => act(String(key))}>
          <Item id="breaks" symbol="breakpoint" word="settings.breakpoints" />
          <Item id="operator" symbol="person" word="settings.operator" />
          <Item id="follow" symbol="target" word="settings.follow" chosen={follow} />
          <Separator />
          <SubmenuTrigger>
            <MenuItem className="menu-item"><Symbol name="contrast" size={18} /><span className="name">{t("settings.theme")}</span><Symbol name="right" size={16} /></MenuItem>
            <Popover className="popover"><Menu className="menu" onAction={(key) => act(String(key))}>
              {themes.map((each) => <MenuItem key={each} id={`theme:${each}`} className="menu-item" textValue={t(`theme.${each}`)}><span className="name">{t(`theme.${each}`)}</span>{theme() === each && <Symbol name="tick" size={16} />}</MenuItem>)}
            </Menu></Popover>
          </SubmenuTrigger>
          <SubmenuTrigger>
            <MenuItem className="menu-item"><Symbol name="globe" size={18} /><span className="name">{t("settings.language")}</span><Symbol name="right" size={16} /></MenuItem>
            <Popover className="popover"><Menu className="menu" onAction={(key) => act(String(key))}>
              {(Object.keys(languages) as Language[]).map((each) => <MenuItem key={each} id={`language:${each}`} className="menu-item" textValue={languages[each]}><span className="name" lang={each}>{languages[each]}</span>{currentLanguage() === each && <Symbol name="tick" size={16} />}</MenuItem>)}
            </Menu></Popover>
          </SubmenuTrigger>
        </Menu>
      </Popover>
    </MenuTrigger>
  );
}

/** Ctrl+S and Ctrl+O are the page's, wherever the focus is, as soon as it is drawn. */
function useSaveKey(): void {
  useLayoutEffect(() => {
    const pressed = (event: globalThis.KeyboardEvent) => {
      if (!(event.ctrlKey || event.metaKey)) return;
      const key = event.key.toLowerCase();
      if (key === "s") void save({ as: event.shiftKey });
      else if (key === "o") openWindow("store");
      else return;
      event.preventDefault();
    };
    document.addEventListener("keydown", pressed);
    return () => document.removeEventListener("keydown", pressed);
  }, []);
}
