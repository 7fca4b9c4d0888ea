// Where the page itself made a mistake, it says so, and that nothing was lost. Stop stays within reach.
import { Component, type ReactNode } from "react";
import { Button } from "react-aria-components";
import { stop } from "./state/acts";
import { t } from "./words/words";

export class Fallen extends Component<{ children: ReactNode }, { what: string | undefined }> {
  override state: { what: string | undefined } = { what: undefined };

  static getDerivedStateFromError(what: unknown): { what: string } {
    return { what: String(what) };
  }

  override render(): ReactNode {
    if (this.state.what === undefined) return this.props.children;
    return (
      <main className="no-token">
        <form>
          <h1>{t("fallen.title")}</h1>
          <p>{t("fallen.text")}</p>
          <p className="hint">{this.state.what}</p>
          <div className="chips">
            <Button className="button primary" onPress={() => location.reload()}>{t("fallen.again")}</Button>
            <Button className="button act stop" onPress={() => void stop()}>{t("run.stop")}</Button>
          </div>
        </form>
      </main>
    );
  }
}
