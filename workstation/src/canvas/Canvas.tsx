// The canvas: icons and lines of the operation that is shown, an overview, and everything that is done there by
// mouse or finger. The keyboard is in keys.ts.
import { Background, BackgroundVariant, ConnectionMode, ReactFlow, useReactFlow, type Connection, type NodeChange, type OnConnectEnd, type ReactFlowInstance } from "@xyflow/react";
import "@xyflow/react/dist/base.css";
import { useCallback, useEffect, useLayoutEffect, useMemo, useRef, type DragEvent, type MouseEvent } from "react";
import type { Point } from "../model/operation";
import { useCell } from "../state/cell";
import { select, shownOperation, useDrawing } from "../state/drawing";
import { connectIcons, insertIcon, moveTo, type Offer } from "../state/edits";
import { openIcon } from "../state/windows";
import { t } from "../words/words";
import { CanvasTools } from "./CanvasTools";
import { ConnectList } from "./ConnectList";
import { EmptyCanvas } from "./EmptyCanvas";
import { Follow, readable } from "./Follow";
import { FlowNodes } from "./flow";
import { IconMenu } from "./IconMenu";
import { IconNode, type IconNodeType } from "./IconNode";
import { InsertList } from "./InsertList";
import { besides, everywhere, onCanvas, openMenu } from "./keys";
import { Lines } from "./Lines";
import { Overview } from "./Overview";
import { useView } from "./view";
import "./canvas.css";

const nodeTypes = { icon: IconNode };
export const offerType = "application/x-workcell-icon";

export function Canvas() {
  const operation = useDrawing(shownOperation);
  const trail = useDrawing((state) => state.trail);
  const selected = useDrawing((state) => state.selected);
  const skills = useCell((state) => state.skills);
  const dragged = useView((state) => state.dragged);
  const flow = useReactFlow();
  const flowNodes = useRef<FlowNodes>(undefined);
  flowNodes.current ??= new FlowNodes();
  const prefix = trail.length > 0 ? `${trail.join("/")}/` : "";
  const nodes = useMemo(() => flowNodes.current!.of(operation, prefix, selected, dragged, skills), [operation, prefix, selected, dragged, skills]);

  useKeys();
  const fits = `${useDrawing((state) => state.opened)}:${prefix}`;
  useEffect(() => void requestAnimationFrame(() => {
    // An empty canvas begins at the left, where START goes.
    const height = document.querySelector(".canvas")?.clientHeight ?? 800;
    if (shownOperation(useDrawing.getState()).icons.length === 0) void flow.setViewport({ x: 64, y: Math.round(height / 2.5), zoom: 1 });
    else void flow.fitView({ maxZoom: 1, padding: 0.06 }).then(() => beginAtLeft(flow));
  }), [fits, flow]);

  const onNodesChange = useCallback((changes: NodeChange<IconNodeType>[]) => changed(changes), []);
  const onConnect = useCallback(({ source, sourceHandle, target }: Connection) => {
    if (sourceHandle) connectIcons(source, sourceHandle, target);
  }, []);
  const onConnectEnd = useCallback<OnConnectEnd>((event, state) => {
    if (state.isValid || !state.fromNode || !state.fromHandle?.id || state.fromHandle.type !== "source") return;
    const point = "changedTouches" in event ? event.changedTouches[0]! : event;
    const over = document.elementFromPoint(point.clientX, point.clientY)?.closest<HTMLElement>(".icon");
    const from = { icon: state.fromNode.id, port: state.fromHandle.id };
    if (over?.dataset.id && over.dataset.id !== from.icon) return connectIcons(from.icon, from.port, over.dataset.id);
    if (over) return;
    // On the empty canvas: which icon shall the line lead to?
    const at = flow.screenToFlowPosition({ x: point.clientX, y: point.clientY });
    useView.setState({ insert: { at: [at.x, at.y - 20], screen: [point.clientX, point.clientY], text: "", from } });
  }, [flow]);

  const onDrop = useCallback((event: DragEvent) => {
    const text = event.dataTransfer.getData(offerType);
    if (text === "") return;
    event.preventDefault();
    const at = flow.screenToFlowPosition({ x: event.clientX, y: event.clientY });
    insertIcon(JSON.parse(text) as Offer, besides(shownOperation(useDrawing.getState()), [at.x - 92, at.y - 28]));
  }, [flow]);

  return (
    <div className="canvas" role="application" aria-label={t("canvas.label", { name: operation.name })} tabIndex={operation.icons.length === 0 ? 0 : -1}
      onDrop={onDrop} onDragOver={(event) => event.dataTransfer.types.includes(offerType) && event.preventDefault()}
      onFocus={(event) => focused(event.target as HTMLElement)} onMouseDownCapture={toNearestConnector}>
      <ReactFlow<IconNodeType> nodes={nodes} edges={[]} nodeTypes={nodeTypes} onNodesChange={onNodesChange} onConnect={onConnect} onConnectEnd={onConnectEnd}
        onNodeDoubleClick={(_, node) => openIcon(node.data.operation, node.id)} zoomOnDoubleClick={false}
        onNodeContextMenu={(event, node) => (event.preventDefault(), openMenu(node.id, [event.clientX, event.clientY]))}
        onNodeDragStop={dropped} onSelectionDragStop={dropped}
        onPaneClick={() => (useView.setState({ line: undefined, insert: undefined, menu: undefined }), select([]))}
        onDoubleClick={(event) => insertAt(event.target as HTMLElement, [event.clientX, event.clientY], flow.screenToFlowPosition({ x: event.clientX, y: event.clientY }))}
        connectionMode={ConnectionMode.Strict} connectionRadius={28} minZoom={0.1} maxZoom={2} nodesFocusable={false} edgesFocusable={false}
        disableKeyboardA11y deleteKeyCode={null} multiSelectionKeyCode={["Shift", "Control", "Meta"]} selectionKeyCode="Shift" snapToGrid snapGrid={[8, 8]}
        elevateNodesOnSelect={false} proOptions={{ hideAttribution: true }}>
        <Background variant={BackgroundVariant.Dots} gap={24} size={1.5} color="var(--dots)" bgColor="var(--canvas)" />
        <Lines operation={operation} prefix={prefix} />
        {operation.icons.length > 4 && <Overview />}
        <CanvasTools />
        <Follow />
      </ReactFlow>
      {operation.icons.length === 0 && <EmptyCanvas />}
      <InsertList />
      <ConnectList />
      <IconMenu />
    </div>
  );
}

/** A finger needs icons of a finger's size: where all of a drawing is too small for that, its beginning is shown, and the overview has the rest. */
function beginAtLeft(flow: ReactFlowInstance): void {
  if (flow.getZoom() >= readable || !matchMedia("(pointer: coarse)").matches) return;
  const { icons } = shownOperation(useDrawing.getState()), height = document.querySelector(".canvas")?.clientHeight ?? 600;
  const first = icons.find((each) => each.kind === "start")?.at ?? [0, 0];
  void flow.setViewport({ x: 24 - first[0] * readable, y: height / 2 - (first[1] + 20) * readable, zoom: readable });
}

function changed(changes: NodeChange<IconNodeType>[]): void {
  const moves = new Map(useView.getState().dragged);
  const chosen = new Set(useDrawing.getState().selected);
  let selects = false;
  for (const each of changes) {
    if (each.type === "position" && each.dragging && each.position) moves.set(each.id, [each.position.x, each.position.y]);
    if (each.type === "select") {
      selects = true;
      if (each.selected) chosen.add(each.id);
      else chosen.delete(each.id);
    }
  }
  if (moves.size > 0) useView.setState({ dragged: moves });
  if (selects) select(chosen);
}

/** Of connectors that lie close together the nearest one is meant, whichever lies on top. */
function toNearestConnector(event: MouseEvent): void {
  const pressed = (event.target as Element).closest(".connector");
  if (!pressed) return;
  const away = (each: Element) => {
    const box = each.getBoundingClientRect();
    return Math.hypot(box.left + box.width / 2 - event.clientX, box.top + box.height / 2 - event.clientY);
  };
  const near = [...event.currentTarget.querySelectorAll(".connector")].reduce((best, each) => (away(each) < away(best) ? each : best), pressed);
  if (near === pressed) return;
  event.stopPropagation();
  event.preventDefault();
  const { clientX, clientY, button, buttons } = event;
  near.dispatchEvent(new globalThis.MouseEvent("mousedown", { bubbles: true, cancelable: true, view: window, clientX, clientY, button, buttons }));
}

/** A drag is one entry of the history, from its beginning to its end. */
function dropped(): void {
  const { dragged } = useView.getState();
  useView.setState({ dragged: new Map() });
  if (dragged.size > 0) moveTo(new Map([...dragged].map(([id, at]) => [id, [Math.round(at[0]), Math.round(at[1])] as Point])));
}

function focused(target: HTMLElement): void {
  const id = target.classList.contains("icon") ? target.dataset.id : undefined;
  if (id !== undefined && useDrawing.getState().focus !== id) useDrawing.setState({ focus: id });
}

function insertAt(target: HTMLElement, screen: Point, at: { x: number; y: number }): void {
  if (!target.classList.contains("react-flow__pane")) return;
  useView.setState({ insert: { at: [at.x, at.y - 28], screen, text: "" } });
}

const writes = (element: Element | null) => element?.closest("input, textarea, [contenteditable], [role='listbox'], [role='menu'], [role='dialog'] select") !== null;

/** Bound to the document: after a deletion the focus may be nowhere. */
function useKeys(): void {
  useLayoutEffect(() => {
    const pressed = (event: KeyboardEvent) => {
      const active = document.activeElement;
      if (event.defaultPrevented || writes(active)) return;
      const canvas = active === document.body || active?.closest(".canvas") !== null;
      const onButton = active?.tagName === "BUTTON" && (event.key === "Enter" || event.key === " ");
      const modal = document.querySelector(".modal-back") !== null;
      if (modal) return;
      if (everywhere(event) || (canvas && !onButton && onCanvas(event))) event.preventDefault();
    };
    document.addEventListener("keydown", pressed);
    return () => document.removeEventListener("keydown", pressed);
  }, []);
}
