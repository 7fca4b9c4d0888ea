// The dialog of a question to a person: its text, and its answers, each of which is a way.
import { Button } from "react-aria-components";
import { setField } from "../model/edit";
import type { Icon } from "../model/operation";
import { change } from "../state/edits";
import { Symbol } from "../symbols/Symbol";
import { t } from "../words/words";
import { AmountBox } from "./AmountBox";
import { NextField } from "./NextField";
import { TextBox } from "./TextBox";

export function QuestionFields({ icon, operation }: { icon: Icon; operation: string }) {
  const answers = icon.answers ?? [];
  const put = <K extends keyof Icon>(field: K, value: Icon[K] | undefined) =>
    change(operation, icon.id, "edit.field", (each) => setField(each, field, value), `${operation}/${icon.id}/${field}`);
  return (
    <div className="ways">
      <TextBox label={t("question.text")} long value={icon.text ?? ""} onChange={(text) => put("text", text)} />
      {answers.map((answer, i) => (
        <div key={i} role="group" className="way" aria-label={t("question.answer", { number: i + 1 })}>
          <div className="way-head">
            <TextBox label={t("question.answer", { number: i + 1 })} value={answer.text} onChange={(text) => put("answers", answers.map((each, j) => (j === i ? { ...each, text } : each)))} />
            <Button className="button quiet only" aria-label={t("question.remove", { number: i + 1 })} isDisabled={answers.length <= 1} onPress={() => put("answers", answers.filter((_, j) => j !== i))}><Symbol name="trash" size={16} /></Button>
          </div>
          <NextField operation={operation} icon={icon} port={`answer:${i}`} />
        </div>
      ))}
      {answers.length < 6 && <Button className="button" onPress={() => put("answers", [...answers, { text: "" }])}><Symbol name="plus" size={16} />{t("question.add")}</Button>}
      <AmountBox label={t("form.timeout")} operation={operation} value={icon.timeout} onChange={(value) => put("timeout", value)} unit="s" low={0} high={86400} optional hint={t("question.timeoutHint")} />
      <NextField operation={operation} icon={icon} port="error" />
    </div>
  );
}
