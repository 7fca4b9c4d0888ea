// The operations on the cell: search, open, rename, delete, older versions.
import { useState } from "react";
import { Button, Input, Menu, MenuTrigger, Popover, SearchField } from "react-aria-components";
import type { Stored } from "../../generated/protocol";
import { Item } from "../canvas/IconMenu";
import { TextBox } from "../dialog/TextBox";
import { ask } from "../state/acts";
import { useCell } from "../state/cell";
import { useDrawing } from "../state/drawing";
import { openStored, save, unlessChanged } from "../state/keep";
import { closeWindow, openWindow } from "../state/windows";
import { Symbol } from "../symbols/Symbol";
import { moment, t } from "../words/words";

export default function StoreWindow() {
  const stored = useCell((state) => state.stored);
  const [text, setText] = useState("");
  if (stored === undefined) return <p className="nothing">{t("keep.noStore")} {t("keep.noStoreHint")}</p>;
  if (stored.length === 0)
    return (
      <div className="nothing store-empty"><p>{t("store.empty")} {t("store.emptyHint")}</p>
        <Button className="button primary" onPress={() => (closeWindow("store:"), void save({ as: true }))}><Symbol name="save" size={18} />{t("file.saveAs")}</Button></div>
    );
  const shown = stored.filter((each) => `${each.name} ${each.operation}`.toLowerCase().includes(text.toLowerCase()));
  return (
    <div className="store">
      <SearchField className="search" aria-label={t("store.search")} value={text} onChange={setText}>
        <Symbol name="search" size={16} /><Input className="input" placeholder={t("store.search")} />
      </SearchField>
      <ul>{shown.map((each) => <Row key={each.name} stored={each} />)}</ul>
    </div>
  );
}

function Row({ stored }: { stored: Stored }) {
  const own = useDrawing((state) => state.name === stored.name);
  const [naming, setNaming] = useState<string>();
  const [asks, setAsks] = useState(false);
  const act = (key: string) => {
    if (key === "versions") openWindow("versions", stored.name);
    if (key === "rename") setNaming(stored.name);
    if (key === "delete") setAsks(true);
  };
  const rename = async () => {
    setNaming(undefined);
    if (naming === undefined || naming === stored.name) return;
    const result = await ask("store.rename", { name: stored.name, to: naming, based_on: stored.version });
    if (result && own) useDrawing.setState({ name: result.name, version: result.version });
  };
  const remove = async () => {
    setAsks(false);
    if ((await ask("store.delete", { name: stored.name, based_on: stored.version })) && own) useDrawing.setState({ name: undefined, version: 0 });
  };
  if (naming !== undefined)
    return (
      <li className="store-row"><form onSubmit={(event) => (event.preventDefault(), void rename())}><TextBox label={t("store.newName")} value={naming} onChange={setNaming} />
        <Button className="button" onPress={() => setNaming(undefined)}>{t("keep.cancel")}</Button><Button className="button primary" type="submit">{t("store.rename")}</Button></form></li>
    );
  if (asks)
    return <li className="store-row asks-row"><p>{t("store.deleteText", { name: stored.name })}</p><Button className="button" onPress={() => setAsks(false)}>{t("keep.cancel")}</Button><Button className="button danger" onPress={() => void remove()}>{t("store.delete")}</Button></li>;
  return (
    <li className="store-row">
      <Button className="button quiet store-open" onPress={() => unlessChanged(() => (void openStored(stored.name), closeWindow("store:")))}>
        <span className="store-name">{stored.name}{own && <span className="store-own">{t("store.here")}</span>}</span>
        <span className="hint">{t("store.saved", { when: moment(stored.saved), by: stored.by || t("store.nobody"), version: stored.version })}</span>
      </Button>
      <MenuTrigger>
        <Button className="button quiet only" aria-label={t("store.more", { name: stored.name })}><Symbol name="more" /></Button>
        <Popover className="popover" placement="bottom end">
          <Menu className="menu" onAction={(key) => act(String(key))}>
            <Item id="versions" symbol="versions" word="file.versions" />
            <Item id="rename" symbol="settings" word="store.rename" />
            <Item id="delete" symbol="trash" word="store.delete" danger />
          </Menu>
        </Popover>
      </MenuTrigger>
    </li>
  );
}
