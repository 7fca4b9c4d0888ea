// The windows on what the cell does: its sensors, its requirements.
import { useState } from "react";
import { Button, Header, Menu, MenuItem, MenuTrigger, Popover, Section, Separator } from "react-aria-components";
import { Item } from "../canvas/IconMenu";
import type { Channel } from "../../generated/protocol";
import { call } from "../state/cell";
import { openWindow, type WindowKind } from "../state/windows";
import type { SymbolName } from "../symbols/drawings";
import { Symbol } from "../symbols/Symbol";
import { channelName, t, unitText } from "../words/words";

const symbols: Record<string, SymbolName> = { force: "sense", contacts: "press", gripper: "grip", profile: "scan", pose: "axes", "set-point": "axes" };

export function ViewsMenu() {
  const [channels, setChannels] = useState<readonly Channel[]>([]);
  const opened = (open: boolean) => open && channels.length === 0 && void call("channels.list").then((all) => setChannels(all.filter((each) => each.form !== "rows")), () => {});
  const act = (key: string) => {
    const [kind, about] = key.split("/");
    openWindow(kind as WindowKind, about ?? "");
  };
  return (
    <MenuTrigger onOpenChange={opened}>
      <Button className="button quiet only" aria-label={t("views.label")}><Symbol name="chart" /></Button>
      <Popover className="popover" placement="bottom end">
        <Menu className="menu" onAction={(key) => act(String(key))}>
          <Item id="scene" symbol="cube" word="scene.title" />
          <Item id="gauges" symbol="gauge" word="gauges.title" />
          <Item id="sensors" symbol="test" word="sensors.title" />
          <Item id="locations" symbol="move-to-location" word="teach.title" />
          <Item id="jog" symbol="hand" word="jog.title" />
          <Item id="production" symbol="list" word="production.title" />
          <Separator />
          <Section items={channels} aria-label={t("views.channels")}>
            <Header className="menu-header">{t("views.channels")}</Header>
            {channels.map((each) => (
              <MenuItem key={each.channel} id={`channel/${each.channel}`} className="menu-item" textValue={channelName(each.channel)}>
                <Symbol name={symbols[each.channel] ?? "chart"} size={18} /><span className="name">{channelName(each.channel)}</span>
                <span className="aside">{[...new Set(each.fields.map((one) => unitText(one.unit)))].join(", ")}</span>
              </MenuItem>
            ))}
          </Section>
        </Menu>
      </Popover>
    </MenuTrigger>
  );
}
