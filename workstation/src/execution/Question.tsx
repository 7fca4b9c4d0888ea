// A question of the operation to the person, with its answers.
import { Button } from "react-aria-components";
import { ask } from "../state/acts";
import { useCell } from "../state/cell";
import { Symbol } from "../symbols/Symbol";
import { t } from "../words/words";

export function Question() {
  const question = useCell((cell) => cell.present?.snapshot.question);
  if (!question) return null;
  return (
    <section className="asks" role="alertdialog" aria-label={t("asks.label")}>
      <Symbol name="question" size={24} />
      <h2>{question.text}</h2>
      <div className="chips">
        {question.answers.map((each, i) => (
          <Button key={i} className="button primary" onPress={() => void ask("operation.answer", { icon: question.icon, answer: i })}>{each || t("asks.go")}</Button>
        ))}
      </div>
    </section>
  );
}
