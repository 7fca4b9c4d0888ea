// The palette: all icons there are, in groups, with a search. An icon comes to the canvas by drag, by double click,
// by Enter, or by the plus that a finger finds more easily.
import { useMemo, useState, type DragEvent, type KeyboardEvent } from "react";
import { Button, Input, SearchField } from "react-aria-components";
import { offerType } from "../canvas/Canvas";
import { focusIcon, placeBehind } from "../canvas/keys";
import { outputs } from "../model/ports";
import { shownOperation, useDrawing } from "../state/drawing";
import { insertIcon } from "../state/edits";
import { useWindows, openWindow } from "../state/windows";
import { Symbol } from "../symbols/Symbol";
import { t } from "../words/words";
import { Miniature } from "./Miniature";
import { matching, type Offered } from "./offers";
import { useOffers } from "./useOffers";
import "./palette.css";

/** At the end of the line from the icon that is selected, else in the middle. */
function add({ offer }: Offered): void {
  const state = useDrawing.getState();
  const operation = shownOperation(state);
  const beside = operation.icons.find((icon) => icon.id === state.focus) ?? operation.icons.at(-1);
  const open = beside && outputs(beside).find((port) => port.to === undefined);
  const id = insertIcon(offer, placeBehind(operation, beside), beside && open && offer.kind !== "start" ? { icon: beside.id, port: open.name } : undefined);
  focusIcon(id);
}

export function Palette() {
  const [text, setText] = useState("");
  const offered = useOffers();
  const shown = useMemo(() => (text === "" ? offered : offered.map((group) => ({ ...group, offers: matching(group.offers, text) })).filter((group) => group.offers.length > 0)), [offered, text]);
  const first = shown[0]?.offers[0];
  // One stop of Tab; arrows lead through the list.
  const [at, setAt] = useState("");
  const stop = shown.some((group) => group.offers.some((each) => each.key === at)) ? at : first?.key;
  return (
    <nav className="palette panel" aria-label={t("palette.label")}>
      <div className="panel-head">
        <SearchField aria-label={t("palette.search")} value={text} onChange={setText} onSubmit={() => first && add(first)} className="search">
          <Symbol name="search" size={16} />
          <Input className="input" placeholder={t("palette.search")} />
          <Button className="clear" aria-label={t("palette.clear")}><Symbol name="cross" size={14} /></Button>
        </SearchField>
        <Button className="button quiet only" aria-label={t("palette.fold")} onPress={() => useWindows.setState({ palette: false })}><Symbol name="left" /></Button>
      </div>
      <div className="groups" onKeyDown={arrows}>
        {shown.map((group) => (
          <section key={group.word} aria-label={t(group.word)}>
            <h2>{t(group.word)}</h2>
            <ul>{group.offers.map((each) => <li key={each.key}><OfferItem offered={each} stop={each.key === stop} onFocus={() => setAt(each.key)} /></li>)}</ul>
          </section>
        ))}
        {shown.length === 0 && <p className="nothing">{t("palette.nothing", { text })}</p>}
      </div>
    </nav>
  );
}

function arrows(event: KeyboardEvent<HTMLElement>): void {
  const by = { ArrowDown: 1, ArrowUp: -1 }[event.key];
  const all = [...event.currentTarget.querySelectorAll<HTMLElement>(".offer-main")];
  const here = all.indexOf(document.activeElement as HTMLElement);
  if (by === undefined || here < 0) return;
  event.preventDefault();
  all[here + by]?.focus();
}

function OfferItem({ offered, stop, onFocus }: { offered: Offered; stop: boolean; onFocus(): void }) {
  const skill = offered.offer.kind === "skill" ? offered.offer.skill : undefined;
  const pressed = (event: KeyboardEvent) => {
    if (event.key === "Enter") add(offered);
    else if (event.key === "?" && skill !== undefined) openWindow("skill", skill);
    else return;
    event.preventDefault();
  };
  const drag = (event: DragEvent) => {
    event.dataTransfer.setData(offerType, JSON.stringify(offered.offer));
    event.dataTransfer.effectAllowed = "copy";
  };
  return (
    <div className="offer" data-unable={offered.unable !== "" || undefined} title={offered.unable || offered.text}>
      <button type="button" className="offer-main" tabIndex={stop ? 0 : -1} onFocus={onFocus} draggable onDragStart={drag} onDoubleClick={() => add(offered)}
        onKeyDown={pressed} data-offer={offered.key}>
        <Miniature family={offered.family} symbol={offered.symbol} />
        <span className="offer-words">
          <span className="offer-name">{offered.name}</span>
          {offered.unable !== "" && <span className="offer-unable">{t("palette.unable")}</span>}
        </span>
      </button>
      {skill !== undefined && (
        <Button excludeFromTabOrder className="button quiet only offer-act offer-help" aria-label={t("palette.help", { name: offered.name })} onPress={() => openWindow("skill", skill)}><Symbol name="help" size={16} /></Button>
      )}
      <Button excludeFromTabOrder className="button quiet only offer-act" aria-label={t("palette.add", { name: offered.name })} onPress={() => add(offered)}><Symbol name="plus" size={16} /></Button>
    </div>
  );
}
