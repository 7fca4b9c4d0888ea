// Type to insert: a list of all icons over the canvas. Enter puts the one that is marked there.
import { useEffect, useMemo, useRef } from "react";
import { insertIcon } from "../state/edits";
import { Miniature } from "../palette/Miniature";
import { matching } from "../palette/offers";
import { useOffers } from "../palette/useOffers";
import { t } from "../words/words";
import { ChoiceList } from "./ChoiceList";
import { focusIcon } from "./keys";
import { useView } from "./view";

export function InsertList() {
  const insert = useView((state) => state.insert);
  const offered = useOffers();
  const all = useMemo(() => offered.flatMap((group) => group.offers), [offered]);
  const before = useRef<Element | null>(null);
  useEffect(() => {
    if (insert) before.current ??= document.activeElement;
    else before.current = null;
  }, [insert]);
  if (!insert) return null;
  const choices = matching(insert.from ? all.filter((each) => each.offer.kind !== "start") : all, insert.text).map((each) => ({
    key: each.key, name: each.name, aside: each.unable === "" ? "" : t("palette.unable"), picture: <Miniature family={each.family} symbol={each.symbol} />, value: each,
  }));
  const close = () => {
    useView.setState({ insert: undefined });
    if (before.current instanceof HTMLElement) before.current.focus();
  };
  return (
    <ChoiceList label={t("insert.label")} title={insert.from ? t("insert.behind", { icon: insert.from.icon }) : t("insert.title")} text={insert.text} screen={insert.screen}
      onText={(text) => useView.setState({ insert: { ...insert, text } })} choices={choices} onClose={close} nothing={t("palette.nothing", { text: insert.text })}
      onChoose={(each) => {
        useView.setState({ insert: undefined });
        focusIcon(insertIcon(each.offer, insert.at, insert.from));
      }} />
  );
}
