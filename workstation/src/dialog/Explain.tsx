// The page on a finding: what it means, why it matters, an example and a cure.
import { useEffect, useState } from "react";
import { Refused } from "../protocol/connection";
import { call } from "../state/cell";
import { t } from "../words/words";
import { Markdown } from "./Markdown";

export default function Explain({ about }: { about: string }) {
  const [page, setPage] = useState<{ title: string; markdown: string } | string>();
  useEffect(() => {
    let current = true;
    call("explain", { code: about }).then(
      (result) => current && setPage(result),
      (problem: Error) => current && setPage(problem instanceof Refused ? problem.message : t("said.away")));
    return () => void (current = false);
  }, [about]);
  if (page === undefined) return <p className="nothing">{t("loading")}</p>;
  if (typeof page === "string") return <p className="nothing">{page}</p>;
  return <article className="explained"><h3>{page.title}</h3><Markdown text={page.markdown} /></article>;
}
