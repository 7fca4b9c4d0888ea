// Who has the controls: shown, taken, asked for, handed over, given back.
import { Button, Menu, MenuItem, MenuTrigger, Popover, Section, Header, Separator } from "react-aria-components";
import { ask } from "../state/acts";
import { useCell } from "../state/cell";
import { Symbol } from "../symbols/Symbol";
import { t } from "../words/words";

export function ControlsButton() {
  const snapshot = useCell((cell) => cell.present?.snapshot);
  if (!snapshot) return null;
  const { yours, controls, asking, clients, client } = snapshot;
  const others = clients.filter((each) => each.client !== client);
  const text = yours ? t("controls.yours") : controls === "" ? t("controls.free") : t("controls.of", { name: controls });
  const act = (key: string) => {
    const [what, number] = key.split(":");
    if (what === "take") void ask("controls.take", {});
    if (what === "ask") void ask("controls.ask", {});
    if (what === "release") void ask("controls.release", {});
    if (what === "give") void ask("controls.give", { client: Number(number) });
  };
  return (
    <MenuTrigger>
      <Button className="button controls" data-yours={yours || undefined} data-asked={(yours && asking.length > 0) || undefined}>
        <Symbol name={yours ? "hand" : controls === "" ? "person" : "lock"} size={18} /><span>{text}</span>
        {yours && asking.length > 0 && <span className="asked">{t("controls.asked", { name: asking[0]!.name })}</span>}
      </Button>
      <Popover className="popover" placement="bottom end">
        <Menu className="menu" onAction={(key) => act(String(key))}>
          {yours ? <MenuItem id="release" className="menu-item"><Symbol name="person" size={18} /><span className="name">{t("controls.release")}</span></MenuItem>
            : controls === "" ? <MenuItem id="take" className="menu-item"><Symbol name="hand" size={18} /><span className="name">{t("controls.take")}</span></MenuItem>
              : <MenuItem id="ask" className="menu-item"><Symbol name="hand" size={18} /><span className="name">{t("controls.ask", { name: controls })}</span></MenuItem>}
          {yours && others.map((each) => (
            <MenuItem key={each.client} id={`give:${each.client}`} className="menu-item">
              <Symbol name="right" size={18} /><span className="name">{t("controls.give", { name: `${each.name} (${each.client})` })}</span>
              {asking.some((one) => one.client === each.client) && <span className="aside">{t("controls.wants")}</span>}
            </MenuItem>
          ))}
          <Separator />
          <Section>
            <Header className="menu-header">{t("controls.clients")}</Header>
            {clients.map((each) => (
              <MenuItem key={each.client} id={`who:${each.client}`} className="menu-item" isDisabled>
                <Symbol name={each.controls ? "hand" : "person"} size={18} /><span className="name">{each.name} ({each.client})</span>
                <span className="aside">{each.client === client ? t("controls.you") : t(`role.${each.role}`)}</span>
              </MenuItem>
            ))}
          </Section>
        </Menu>
      </Popover>
    </MenuTrigger>
  );
}
