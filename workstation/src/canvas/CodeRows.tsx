// The outputs of a CASE with their codes in words, and the answers of a question.
import { useMemo } from "react";
import { meaningsBefore, type CodeMeaning } from "../model/codes";
import { operationNamed, type Icon } from "../model/operation";
import { useCell } from "../state/cell";
import { useDrawing } from "../state/drawing";
import { t } from "../words/words";

export const meaningText = (each: CodeMeaning): string => each.text ?? (each.word ? t(each.word, each.values) : "");

export function useMeanings(icon: Icon, operation: string): CodeMeaning[] {
  const drawing = useDrawing((state) => state.drawing);
  const skills = useCell((state) => state.skills);
  return useMemo(() => {
    const there = operationNamed(drawing, operation);
    return there && icon.kind === "case" ? meaningsBefore(drawing, there, icon.id, skills) : [];
  }, [drawing, operation, icon, skills]);
}

export function CodeRows({ icon, operation }: { icon: Icon; operation: string }) {
  const meanings = useMeanings(icon, operation);
  if (icon.kind === "question")
    return <ol className="rows">{icon.answers?.map((answer, i) => <li key={i}><span className="words-of">{answer.text || "–"}</span></li>)}</ol>;
  return (
    <ol className="rows">
      {icon.ways?.map((way, i) => {
        const words = [...new Set(meanings.filter((each) => way.codes.includes(each.code)).map(meaningText))].join(" / ");
        return (
          <li key={i} title={words}>
            <span className="number">{way.codes.join(", ")}</span>
            <span className="words-of">{words}</span>
          </li>
        );
      })}
      <li><span className="words-of">{t("case.otherwise")}</span></li>
    </ol>
  );
}
