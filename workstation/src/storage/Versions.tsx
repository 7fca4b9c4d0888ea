// The versions of a stored operation, and what one changed: content apart from layout.
import { useEffect, useState } from "react";
import { Button } from "react-aria-components";
import type { Change, Version } from "../../generated/protocol";
import { amountText } from "../canvas/summary";
import type { Result } from "../protocol/connection";
import { ask } from "../state/acts";
import { call, useCell } from "../state/cell";
import { textOf } from "../state/checks";
import { useDrawing } from "../state/drawing";
import { openStored, unlessChanged } from "../state/keep";
import { moment, t } from "../words/words";

type Difference = Result<"operation.difference">;

export default function Versions({ about }: { about: string }) {
  const stored = useCell((state) => state.stored?.find((each) => each.name === about)?.version);
  const [versions, setVersions] = useState<readonly Version[]>();
  const [shown, setShown] = useState<{ of: number; difference: Difference }>();
  useEffect(() => {
    call("store.versions", { name: about }).then(setVersions, () => setVersions([]));
  }, [about, stored]);
  /** Between the version and what is on the canvas; or, for another operation, the version before it. */
  const compare = async (version: number) => {
    const text = (await ask("store.read", { name: about, version }))?.text;
    const { name, drawing } = useDrawing.getState();
    const other = name === about ? textOf(drawing) : version > 1 ? (await ask("store.read", { name: about, version: version - 1 }))?.text : undefined;
    if (text === undefined || other === undefined) return;
    const difference = await ask("operation.difference", name === about ? { before: text, after: other } : { before: other, after: text });
    if (difference) setShown({ of: version, difference });
  };
  if (!versions) return <p className="nothing">{t("loading")}</p>;
  return (
    <ul className="versions">
      {versions.map((each) => (
        <li key={each.version}>
          <div className="version-row">
            <b>{t("versions.number", { version: each.version })}</b>
            <span className="hint">{t("versions.saved", { when: moment(each.saved), by: each.by || t("store.nobody") })} {each.note}</span>
            <Button className="button small" onPress={() => void compare(each.version)}>{t("versions.compare")}</Button>
            <Button className="button small" onPress={() => unlessChanged(() => void openStored(about, each.version))}>{t("versions.open")}</Button>
          </div>
          {shown?.of === each.version && <Changes difference={shown.difference} />}
        </li>
      ))}
    </ul>
  );
}

function Changes({ difference }: { difference: Difference }) {
  const content = difference.changes.filter((each) => each.change !== "moved"), moved = difference.changes.length - content.length;
  if (difference.changes.length === 0) return <p className="hint">{t("versions.same")}</p>;
  return (
    <div className="changes">
      <ul>{content.map((each, i) => <ChangeRow key={i} change={each} />)}</ul>
      {moved > 0 && <p className="hint">{t(content.length === 0 ? "versions.onlyMoved" : "versions.moved", { count: moved })}</p>}
    </div>
  );
}

const shown = (value: unknown) => (value === undefined ? "–" : typeof value === "object" && value !== null ? JSON.stringify(value) : amountText(value));

type FieldChange = Change["fields"][number];
const members = (value: unknown): Record<string, unknown> | undefined => (typeof value === "object" && value !== null && !Array.isArray(value) ? (value as Record<string, unknown>) : undefined);

/** Of parameters only those that differ, by name. */
function spread(each: FieldChange): FieldChange[] {
  const before = members(each.before), after = members(each.after);
  if (!before && !after) return [each];
  const names = [...new Set([...Object.keys(before ?? {}), ...Object.keys(after ?? {})])];
  return names.filter((name) => JSON.stringify(before?.[name]) !== JSON.stringify(after?.[name]))
    .map((field) => ({ field, ...(before?.[field] === undefined ? {} : { before: before[field] }), ...(after?.[field] === undefined ? {} : { after: after[field] }) }));
}

function ChangeRow({ change }: { change: Change }) {
  return (
    <li className="change" data-change={change.change}>
      <b>{change.icon || change.operation}</b> <span>{t(`versions.${change.change}`)}</span>
      {change.change === "changed" && <ul>{change.fields.flatMap(spread).map((each) => <li key={each.field}><span>{each.field}</span> <s>{shown(each.before)}</s> → <b>{shown(each.after)}</b></li>)}</ul>}
    </li>
  );
}
