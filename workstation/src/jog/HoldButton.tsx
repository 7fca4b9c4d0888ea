// A button that acts only while it is held: by the pointer, by a finger, by Space or Enter.
import { useEffect, useState, type KeyboardEvent, type PointerEvent } from "react";
import { hold, letGo, type Axes } from "./hold";

interface Props {
  /** Of its own among all that hold. */
  id: string;
  label: string;
  /** The key that does the same in this window. */
  keyHint: string;
  sign: string;
  axes: Axes;
  disabled: boolean;
}

export function HoldButton({ id, label, keyHint, sign, axes, disabled }: Props) {
  const [held, setHeld] = useState(false);
  const begin = () => {
    if (disabled) return;
    setHeld(true);
    hold(id, axes);
  };
  const end = () => {
    setHeld(false);
    letGo(id);
  };
  useEffect(() => () => letGo(id), [id]);
  const down = (event: PointerEvent<HTMLButtonElement>) => {
    if (event.button !== 0) return;
    event.currentTarget.setPointerCapture(event.pointerId);
    begin();
  };
  // A finger that slides off the button no longer holds it.
  const move = (event: PointerEvent<HTMLButtonElement>) => {
    if (!held) return;
    const box = event.currentTarget.getBoundingClientRect();
    if (event.clientX < box.left || event.clientX > box.right || event.clientY < box.top || event.clientY > box.bottom) end();
  };
  const key = (event: KeyboardEvent) => {
    if (event.key !== " " && event.key !== "Enter") return;
    event.preventDefault();
    if (!event.repeat) begin();
  };
  return (
    <button type="button" className="button hold-button" aria-label={label} aria-keyshortcuts={keyHint} aria-pressed={held} disabled={disabled} data-held={held || undefined} title={label}
      onPointerDown={down} onPointerMove={move} onPointerUp={end} onPointerCancel={end} onLostPointerCapture={end} onContextMenu={(event) => event.preventDefault()}
      onKeyDown={key} onKeyUp={(event) => (event.key === " " || event.key === "Enter") && end()} onBlur={end}>
      <span aria-hidden="true">{sign}</span><kbd aria-hidden="true">{keyHint}</kbd>
    </button>
  );
}
