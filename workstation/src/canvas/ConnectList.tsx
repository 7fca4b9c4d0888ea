// "Connect to…": first the output, if the icon has several, then the icon that its line leads to.
import { useMemo, useState } from "react";
import { iconOf } from "../model/operation";
import { hasInput, outputs } from "../model/ports";
import { shownOperation, useDrawing } from "../state/drawing";
import { connectIcons } from "../state/edits";
import { t } from "../words/words";
import { ChoiceList, type Choice } from "./ChoiceList";
import { portText } from "./describe";
import { focusIcon } from "./keys";
import { useView } from "./view";

export function ConnectList() {
  const connecting = useView((state) => state.connecting);
  return connecting ? <Open key={`${connecting.icon}/${connecting.port}`} icon={connecting.icon} port={connecting.port} /> : null;
}

function Open({ icon: id, port }: { icon: string; port: string | undefined }) {
  const operation = useDrawing(shownOperation);
  const [text, setText] = useState("");
  const icon = iconOf(operation, id);
  const ports = icon ? outputs(icon) : [];
  const chosen = port ?? (ports.length === 1 ? ports[0]!.name : undefined);
  const choices = useMemo((): Choice<string>[] => {
    if (!icon) return [];
    const all = chosen === undefined
      ? ports.map((each) => ({ key: each.name, name: portText(icon, each.name), aside: each.to ?? "", picture: null, value: each.name }))
      : operation.icons.filter((each) => hasInput(each)).map((each) => ({ key: each.id, name: each.id, aside: t(`kind.${each.kind}`), picture: null, value: each.id }));
    return all.filter((each) => each.name.toLowerCase().includes(text.toLowerCase()));
  }, [icon, chosen, ports, operation, text]);
  const close = () => {
    useView.setState({ connecting: undefined });
    focusIcon(id);
  };
  const box = document.querySelector(`.icon[data-id="${CSS.escape(id)}"]`)?.getBoundingClientRect();
  return (
    <ChoiceList label={t("connect.label")} title={chosen === undefined || !icon ? t("connect.which", { icon: id }) : t("connect.to", { port: portText(icon, chosen), icon: id })}
      text={text} onText={setText} screen={box ? [box.right + 16, box.top] : [200, 200]} choices={choices} nothing={t("connect.nothing")} onClose={close}
      onChoose={(value) => {
        if (chosen === undefined) return useView.setState({ connecting: { icon: id, port: value } });
        connectIcons(id, chosen, value);
        close();
      }} />
  );
}
