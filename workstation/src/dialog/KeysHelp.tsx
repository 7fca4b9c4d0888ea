// All keys of the canvas, and what no key of this page can do.
import { keys } from "../canvas/keys";
import { t } from "../words/words";

export default function KeysHelp() {
  return (
    <div className="help">
      <table>
        <tbody>{keys.map((each) => <tr key={each.word}><th scope="row"><kbd>{each.keys}</kbd></th><td>{t(each.word)}</td></tr>)}</tbody>
      </table>
      <section><h3>{t("stop.title")}</h3><p>{t("stop.meaning")}</p></section>
      <section><h3>{t("about.title")}</h3><p className="hint">{t("about.licences")} <a href="LICENSES.txt" target="_blank" rel="noreferrer">LICENSES.txt</a></p></section>
    </div>
  );
}
