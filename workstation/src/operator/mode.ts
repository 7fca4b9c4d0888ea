// Who sees which page. An operator's and a viewer's token show the operator's page and no other; a programmer may
// look at it. What each may do is decided by the server alone.
import { create } from "zustand";
import { useCell } from "../state/cell";

const key = "workcell-mode";

export const useMode = create<{ looks: boolean }>()(() => ({ looks: sessionStorage.getItem(key) === "operator" }));

export function lookAsOperator(looks: boolean): void {
  sessionStorage.setItem(key, looks ? "operator" : "");
  useMode.setState({ looks });
}

export function useOperatorMode(): boolean {
  const looks = useMode((state) => state.looks);
  const role = useCell((cell) => cell.present?.snapshot.role);
  return looks || (role !== undefined && role !== "programmer");
}
