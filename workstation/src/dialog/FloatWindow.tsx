// A window over the page. Several stay open, the one that has the focus lies on top; Escape closes it.
import { useEffect, useId, useLayoutEffect, useRef, type KeyboardEvent, type PointerEvent, type ReactNode } from "react";
import { Button } from "react-aria-components";
import { focusIcon } from "../canvas/keys";
import { useDrawing } from "../state/drawing";
import { closeWindow, moveWindow, raise, useWindows, type OpenWindow } from "../state/windows";
import { Symbol } from "../symbols/Symbol";
import { t } from "../words/words";
import "./windows.css";

interface Props {
  window: OpenWindow;
  title: string;
  wide?: boolean;
  /** Its corner can be drawn. */
  sizable?: boolean;
  footer?: ReactNode;
  children: ReactNode;
}

export function FloatWindow({ window: own, title, wide = false, sizable = false, footer, children }: Props) {
  const id = useId();
  const box = useRef<HTMLElement>(null);
  const before = useRef<Element | null>(null);
  const grip = useRef<{ x: number; y: number } | undefined>(undefined);
  const moved = useRef(false); // by a person, who may put it beyond the edge

  // The focus comes into the window, and goes back to where it was.
  useEffect(() => {
    before.current = document.activeElement;
    const first = box.current?.querySelector<HTMLElement>(".window-body input, .window-body button, .window-body textarea");
    (first ?? box.current)?.focus();
    return () => {
      if (before.current instanceof HTMLElement && before.current.isConnected && before.current !== document.body) before.current.focus();
      else focusIcon(useDrawing.getState().focus);
    };
  }, []);

  // A wide window that would open beyond the edge is put within it: its head has the button that closes it. Some are wide only
  // when their part of the page has come.
  useLayoutEffect(() => {
    const within = () => {
      const now = useWindows.getState().open.find((each) => each.id === own.id);
      const most = Math.max(8, innerWidth - (box.current?.offsetWidth ?? 0) - 12);
      if (now && !moved.current && now.x > most) moveWindow(own.id, most, now.y);
    };
    within();
    const watch = new ResizeObserver(within);
    watch.observe(box.current!);
    return () => watch.disconnect();
  }, []);

  const close = () => closeWindow(own.id);
  const pressed = (event: KeyboardEvent) => {
    if (event.key !== "Escape" || event.defaultPrevented) return;
    event.stopPropagation();
    close();
  };
  const held = (event: PointerEvent) => {
    if ((event.target as Element).closest("button")) return;
    grip.current = { x: event.clientX - own.x, y: event.clientY - own.y };
    event.currentTarget.setPointerCapture(event.pointerId);
  };
  const dragged = (event: PointerEvent) => {
    if (!grip.current) return;
    moved.current = true;
    const x = Math.min(innerWidth - 80, Math.max(80 - (box.current?.offsetWidth ?? 0), event.clientX - grip.current.x));
    moveWindow(own.id, x, Math.min(innerHeight - 48, Math.max(0, event.clientY - grip.current.y)));
  };
  return (
    <section ref={box} className={wide ? "window wide" : "window"} role="dialog" aria-labelledby={id} tabIndex={-1} data-window={own.kind} data-about={own.about} data-sizable={sizable || undefined}
      style={{ left: own.x, top: own.y, maxHeight: `calc(100vh - ${Math.min(own.y, innerHeight - 240) + 12}px)` }} onKeyDown={pressed} onPointerDownCapture={() => raise(own.id)}>
      <div className="window-head" onPointerDown={held} onPointerMove={dragged} onPointerUp={() => (grip.current = undefined)}>
        <h2 id={id}>{title}</h2>
        <Button className="button quiet only" aria-label={t("window.close", { title })} onPress={close}><Symbol name="cross" size={18} /></Button>
      </div>
      <div className="window-body" tabIndex={0}>{children}</div>
      {footer && <div className="window-foot">{footer}</div>}
    </section>
  );
}
