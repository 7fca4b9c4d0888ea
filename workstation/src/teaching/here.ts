// Where the robot is, and what its description calls the figures of a place.
import { useEffect, useState } from "react";
import { trackOf, useChannels, watch } from "../live/live";
import { call, useCell } from "../state/cell";

const none: readonly string[] = [];

/** The six figures of a place, by the names that the robot's description gives them. */
export function usePoseNames(): readonly string[] {
  const fields = useChannels((state) => state.channels)?.find((each) => each.channel === "pose")?.fields;
  return fields?.map((each) => each.name) ?? none;
}

export interface Here {
  pose: readonly number[];
  joints: readonly number[];
}

/** Where the tip is, and the joints: by the encoders while the robot rests, and as they come while it moves. */
export function useHere(): Here | undefined {
  const [here, setHere] = useState<Here>();
  const rests = useCell((cell) => cell.link === "ready" && cell.present?.snapshot.activity === "idle");
  useEffect(() => {
    if (!rests) return;
    let current = true;
    call("locations.here").then((found) => current && setHere(found), () => {});
    return () => void (current = false);
  }, [rests]);
  useEffect(() => {
    if (rests) return;
    const ends = [watch("pose", 0.02), watch("joints", 0.02)];
    const pose = trackOf("pose", 6), joints = trackOf("joints", 6);
    let seen = pose.version;
    const timer = setInterval(() => {
      if (pose.size === 0 || joints.size === 0 || seen === pose.version) return;
      seen = pose.version;
      setHere({ pose: pose.last.map((each) => each[pose.size - 1]!), joints: joints.last.map((each) => each[joints.size - 1]!) });
    }, 100);
    return () => {
      clearInterval(timer);
      for (const end of ends) end();
    };
  }, [rests]);
  return here;
}
