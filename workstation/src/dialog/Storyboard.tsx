// The operation as a story: its picture, and a scene for each icon that acts. The server tells it, and it can be printed.
import { useEffect, useState } from "react";
import { Button } from "react-aria-components";
import { call, useCell } from "../state/cell";
import { mainFile, textOf } from "../state/checks";
import { useDrawing } from "../state/drawing";
import { Symbol } from "../symbols/Symbol";
import { t } from "../words/words";
import type { Result } from "../protocol/connection";

type Story = Result<"operation.storyboard">;

export default function Storyboard() {
  const drawing = useDrawing((state) => state.drawing), ready = useCell((state) => state.link === "ready");
  const [story, setStory] = useState<Story>(), [refused, setRefused] = useState("");
  useEffect(() => {
    if (!ready) return;
    let current = true;
    const told = (found: Story | undefined, problem: string) => {
      if (!current) return;
      setStory(found);
      setRefused(problem);
    };
    // A drawing that is being changed is told when the hand rests.
    const timer = setTimeout(() => call("operation.storyboard", { main: mainFile, files: { [mainFile]: textOf(drawing) } }).then((found) => told(found, ""), (problem: Error) => told(undefined, problem.message)), 300);
    return () => {
      current = false;
      clearTimeout(timer);
    };
  }, [drawing, ready]);
  if (refused !== "") return <p className="refusal" role="alert"><Symbol name="error" size={14} />{t("story.refused")} {refused}</p>;
  if (!story) return <p className="nothing loading">{t("loading")}</p>;
  return (
    <article className="story" lang="en">
      <Button className="button story-print" onPress={() => print()}><Symbol name="download" size={16} />{t("production.print")}</Button>
      {story.chapters.map((chapter) => (
        <section key={chapter.operation} className="chapter">
          <h3>{chapter.operation}</h3>
          {chapter.introduction.map((each, i) => <p key={i}>{each}</p>)}
          <img className="story-picture" alt={t("story.picture", { name: chapter.operation })} src={`data:image/svg+xml;charset=utf-8,${encodeURIComponent(chapter.picture)}`} />
          {chapter.scenes.map((scene) => (
            <section key={scene.icon} className="scene-of-story">
              <h4>{scene.title}</h4>
              {scene.sentences.map((each, i) => <p key={i}>{each}</p>)}
              <ul className="bulleted">{scene.branches.map((each, i) => <li key={i}>{each}</li>)}</ul>
            </section>
          ))}
        </section>
      ))}
    </article>
  );
}
