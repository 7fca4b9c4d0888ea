// A gamepad that moves the arm: the shoulder button is held, the sticks say where to.
import { useEffect, useState } from "react";
import { hold, letGo, type Axes } from "./hold";

const deadMan = 5; // the right shoulder button of the standard layout
const still = 0.15; // of a stick: what its spring leaves

const pull = (value: number | undefined) => (value === undefined || Math.abs(value) < still ? 0 : value);

/** Sticks to the first three axes, the cross and the lower shoulders to the others. */
export function axesOf(pad: Pick<Gamepad, "axes" | "buttons">): Axes | undefined {
  if (!pad.buttons[deadMan]?.pressed) return undefined;
  const pressed = (plus: number, minus: number) => Number(pad.buttons[plus]?.pressed ?? false) - Number(pad.buttons[minus]?.pressed ?? false);
  return [pull(pad.axes[0]), -pull(pad.axes[1]) || 0, -pull(pad.axes[3]) || 0, pressed(15, 14), pressed(12, 13), pressed(7, 6)];
}

/** Watches the gamepads while `on`; whether there is one. */
export function useGamepad(on: boolean): boolean {
  const [there, setThere] = useState(false);
  useEffect(() => {
    const look = () => setThere(navigator.getGamepads().some((each) => each?.mapping === "standard"));
    look();
    addEventListener("gamepadconnected", look);
    addEventListener("gamepaddisconnected", look);
    return () => {
      removeEventListener("gamepadconnected", look);
      removeEventListener("gamepaddisconnected", look);
    };
  }, []);
  useEffect(() => {
    if (!there || !on) return;
    const each = setInterval(() => {
      const axes = navigator.getGamepads().map((pad) => (pad?.mapping === "standard" ? axesOf(pad) : undefined)).find((found) => found);
      if (axes) hold("gamepad", axes);
      else letGo("gamepad");
    }, 25);
    return () => {
      clearInterval(each);
      letGo("gamepad");
    };
  }, [there, on]);
  return there;
}
