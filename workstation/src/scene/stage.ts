// The cell in space, as the page knows it: where its bodies are, what is marked, from where it is seen. A painter of a thread
// of its own draws it, when something has changed.
import { Box3, MathUtils, Matrix4, PerspectiveCamera, Vector3 } from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import type { Scene } from "../../generated/protocol";
import { look } from "../live/look";
import { Bodies } from "./bodies";
import type { Answer, ArrowNews, Begin, Colours, Corners, FanNews, News, Place, Shows, Wanted } from "./news";
import { Pace } from "./pace";
import painter from "./painter.worker?address";
import { presses } from "./presses";
import { Trail } from "./trail";
import { view } from "./view";

export type NamedView = "front" | "side" | "top" | "iso";

/** From where each looks: azimuth and height, degrees. Azimuth 0 looks along y. */
const views: Record<NamedView, readonly [number, number]> = { front: [0, 4], side: [90, 4], top: [0, 89.99], iso: [38, 26] };
/** An arrow's length for a newton, and its least and greatest, m. */
const m_per_N = 0.006, shortest = 0.045, longest = 0.3;

/** What nobody sees: a body or a contact that moves less, m, and a force that changes less, N. */
const bodyStep = 2e-5, contactStep = 2e-4, forceStep = 0.05;
/** The numbers of a contact: where it is, and its force. */
const contactWidth = 6;

/** The same rows, but for what nobody sees. `step`: by the column of a contact. */
function near(rows: Float32Array, before: Float32Array | undefined, step: (column: number) => number): boolean {
  return before !== undefined && rows.length === before.length && rows.every((each, i) => Math.abs(each - before[i]!) < step(i % contactWidth));
}

const directions = new Vector3(...view.directions);

/** An arrow of a force that begins at a place, or ends there. */
function arrow(force: Vector3, at: Vector3, ends: boolean): ArrowNews & { tail: Vector3; head: Vector3 } {
  const length = MathUtils.clamp(force.length() * m_per_N, shortest, longest), direction = force.clone().normalize();
  const tail = ends ? at.clone().addScaledVector(direction, -length) : at;
  return { begin: tail.toArray(), direction: direction.toArray(), length, tail, head: tail.clone().addScaledVector(direction, length) };
}

export interface Label {
  key: string;
  kind: "location" | "force" | "axis";
  text: string;
  place: Vector3;
}

/** The colours of the page's theme. */
function coloursNow(): Colours {
  const style = getComputedStyle(document.documentElement), of = (name: string) => style.getPropertyValue(name).trim(), { ink, accent, error, series } = look();
  const dark = document.documentElement.dataset["theme"] === "dark";
  return { dark, background: of("--canvas"), grid: of("--edge"), edges: dark ? "#000000" : ink, axes: series.slice(0, 3), path: accent, contact: error, sensor: series[5]! };
}

export class Stage {
  readonly camera = new PerspectiveCamera(view.angle, 1, view.near, view.far);
  readonly controls: OrbitControls;
  readonly path = new Trail();
  /** Of a replay: the whole of it. */
  readonly wholePath = new Trail();
  readonly tipAt = new Vector3();
  follow = false;
  /** Something has changed since a picture was asked for. */
  stale = true;
  labels: Label[] = [];

  #painter: Worker;
  /** Of each body's shapes, in its frame; undefined: the painter has not begun. */
  #boxes: readonly (Corners | null)[] | undefined;
  #graphicsCard = true;
  /** What the painter does not know yet. */
  #news: News = {};
  #pace = new Pace();
  #bodies: Bodies;
  #places: { place: Place; label: Label }[] = [];
  #flight: { from: [number, number, number, Vector3]; to: [number, number, number, Vector3]; begun: number } | undefined;
  #shows: Shows = { path: true, contacts: true, sensor: false, laser: true, locations: true };
  #forces: Label[] = [];
  /** The rows that are in the picture; undefined: none, or a place between two rows. */
  #bodiesPut: Float32Array | undefined;
  #contactsPut: Float32Array | undefined;
  #sensorLabel: Label | undefined;

  /** `failed`: this browser draws nothing in three dimensions. `still`: whether the camera is to jump. */
  constructor(readonly canvas: HTMLCanvasElement, readonly scene: Scene, readonly still: () => boolean, failed: () => void) {
    this.#bodies = new Bodies(scene);
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.enableDamping = false;
    this.controls.maxPolarAngle = MathUtils.degToRad(100);
    this.controls.minDistance = 0.12;
    this.controls.maxDistance = 12;
    this.controls.addEventListener("change", () => (this.stale = true));
    this.controls.addEventListener("start", () => (this.#flight = undefined));
    this.#painter = new Worker(painter, { type: "module" });
    this.#painter.addEventListener("error", failed);
    this.#painter.addEventListener("message", ({ data }: MessageEvent<Answer>) => {
      if (data.kind === "failed") return failed();
      if (data.kind === "drawn") return this.#pace.end(performance.now());
      this.#boxes = data.boxes;
      this.#graphicsCard = data.graphicsCard;
      this.#put(...this.#wanted("iso"));
    });
    const begin: Begin = { canvas: canvas.transferControlToOffscreen(), scene };
    this.#painter.postMessage(begin, [begin.canvas]);
    this.colour();
    this.#name();
  }

  #tell(news: News): void {
    Object.assign(this.#news, news);
    this.stale = true;
  }

  colour(): void {
    this.#tell({ colours: coloursNow() });
  }

  get shown(): Shows {
    return this.#shows;
  }
  show(shows: Shows): void {
    this.#shows = shows;
    this.#tell({ shows });
    this.#name();
  }

  /** Where the bodies are; the tool's tip with them. A cell that rests sends what was there before. */
  put(rows: Float32Array, later?: Float32Array, part = 0): void {
    if (part === 0 && near(rows, this.#bodiesPut, () => bodyStep)) return;
    this.#bodiesPut = part === 0 ? rows : undefined;
    this.#bodies.put(rows, later, part);
    const tip = this.#bodies.frame(this.scene.tip), before = this.tipAt.clone();
    this.tipAt.setFromMatrixPosition(tip);
    if (this.follow) {
      const moved = this.tipAt.clone().sub(before);
      this.camera.position.add(moved);
      this.controls.target.add(moved);
    }
    this.#tell({ bodies: { rows, later, part }, tip: tip.toArray() });
  }

  /** Where the tip is by these rows. */
  tipOf(rows: Float32Array, into: Matrix4): Matrix4 {
    return this.#bodies.frameBy(rows, this.scene.tip, into);
  }

  /** Contacts as rows of the protocol have them. `value`: a force in words. */
  press(rows: Float32Array, value: (newton: number) => string): void {
    if (near(rows, this.#contactsPut, (column) => (column < 3 ? contactStep : forceStep))) return;
    this.#contactsPut = rows;
    const all = presses(rows).map(({ position, force }) => ({ newton: force.length(), ...arrow(force, position, true) }));
    this.#forces = all.map(({ newton, tail }, i) => ({ key: `force ${i}`, kind: "force", text: value(newton), place: tail }));
    this.#tell({ contacts: all.map(({ begin, direction, length }) => ({ begin, direction, length })) });
    this.#name();
  }

  /** What acts on the sensor, N in its frame; undefined: it is not known. */
  feel(force: readonly number[] | undefined, value: (newton: number) => string): void {
    // It always sways a little, and its arrow is seldom asked for.
    if (!this.#shows.sensor && !this.#sensorLabel) return;
    const frame = this.#bodies.frame(this.scene.sensor), newton = force ? Math.hypot(...force) : 0;
    this.#sensorLabel = undefined;
    if (force && newton > 0.05) {
      const along = new Vector3().fromArray(force as number[]).transformDirection(frame).setLength(newton);
      const { begin, direction, length, head } = arrow(along, new Vector3().setFromMatrixPosition(frame), false);
      this.#sensorLabel = { key: "sensor", kind: "force", text: value(newton), place: head };
      this.#tell({ sensor: { begin, direction, length } });
    } else this.#tell({ sensor: null });
    this.#name();
  }

  /** What the laser met; undefined: nothing that is fresh. */
  scan(fan: FanNews | undefined): void {
    this.#tell({ fan: fan ?? null });
  }

  /** The taught locations, as frames with their names. Those that are at one place have one name. */
  place(places: readonly Place[]): void {
    this.#places = [];
    for (const each of places) {
      const at = new Vector3(...(each.position as [number, number, number]));
      const there = this.#places.find((one) => one.label.place.distanceTo(at) < 1e-4);
      if (there) there.label.text += `, ${each.location}`;
      else this.#places.push({ place: each, label: { key: `location ${each.location}`, kind: "location", text: each.location, place: at } });
    }
    this.#tell({ places: this.#places.map((each) => each.place) });
    this.#name();
  }

  #name(): void {
    const axis = (text: string, ...place: [number, number, number]): Label => ({ key: `axis ${text}`, kind: "axis", text, place: new Vector3(...place).add(directions) });
    this.labels = [
      axis("x", 0.29, 0, 0), axis("y", 0, 0.29, 0), axis("z", 0, 0, 0.29),
      ...(this.#shows.locations ? this.#places.map((each) => each.label) : []), ...(this.#shows.contacts ? this.#forces : []), ...(this.#shows.sensor && this.#sensorLabel ? [this.#sensorLabel] : []),
    ];
    this.stale = true;
  }

  resize(width: number, height: number): void {
    this.camera.aspect = width / Math.max(1, height);
    this.camera.updateProjectionMatrix();
    this.#tell({ size: { width, height } });
  }

  // The camera about its target.
  get #spherical(): [number, number, number] {
    const offset = this.camera.position.clone().sub(this.controls.target), distance = offset.length();
    return [MathUtils.radToDeg(Math.atan2(offset.x, -offset.y)), MathUtils.radToDeg(Math.asin(MathUtils.clamp(offset.z / distance, -1, 1))), distance];
  }
  #put(azimuth: number, height: number, distance: number, target: Vector3): void {
    const a = MathUtils.degToRad(azimuth), h = MathUtils.degToRad(MathUtils.clamp(height, -9, 89.99));
    this.controls.target.copy(target);
    this.camera.position.set(Math.sin(a) * Math.cos(h), -Math.cos(a) * Math.cos(h), Math.sin(h)).multiplyScalar(distance).add(target);
    this.controls.update();
    this.stale = true;
  }
  /** All bodies are seen. */
  #wanted(view: NamedView | undefined): [number, number, number, Vector3] {
    const box = new Box3();
    this.#boxes?.forEach((each, i) => each && box.union(new Box3().setFromArray(each as number[]).applyMatrix4(this.#bodies.matrices[i]!)));
    const target = box.getCenter(new Vector3()), [azimuth, height] = view ? views[view] : this.#spherical;
    const radius = box.getSize(new Vector3()).length() / 2, half = MathUtils.degToRad(this.camera.fov / 2), narrow = Math.min(half, Math.atan(Math.tan(half) * this.camera.aspect));
    return [azimuth, height, (radius / Math.sin(narrow)) * 0.97, target];
  }
  /** Goes there in a quarter of a second, or at once for those who want no motion. */
  #go(to: [number, number, number, Vector3]): void {
    const from: [number, number, number, Vector3] = [...this.#spherical, this.controls.target.clone()];
    // The shorter way about.
    from[0] = to[0] + ((((from[0] - to[0] + 180) % 360) + 360) % 360) - 180;
    if (this.still()) this.#put(...to);
    else this.#flight = { from, to, begun: performance.now() };
    this.stale = true;
  }
  view(name: NamedView): void {
    this.#go(this.#wanted(name));
  }
  fit(): void {
    this.#go(this.#wanted(undefined));
  }
  /** Degrees. */
  orbit(about: number, over: number): void {
    this.#flight = undefined;
    const [azimuth, height, distance] = this.#spherical;
    this.#put(azimuth + about, height + over, distance, this.controls.target.clone());
  }
  zoom(factor: number): void {
    this.#flight = undefined;
    const [azimuth, height, distance] = this.#spherical;
    this.#put(azimuth, height, MathUtils.clamp(distance * factor, this.controls.minDistance, this.controls.maxDistance), this.controls.target.clone());
  }
  /** The tool is in the middle from now on. */
  followTool(on: boolean): void {
    this.follow = on;
    if (!on) return;
    const [azimuth, height, distance] = this.#spherical;
    this.#go([azimuth, height, Math.min(distance, 1.1), this.tipAt.clone()]);
  }
  /** What the camera does, in a word that tests read. */
  get camera_words(): string {
    return this.#spherical.map((each, i) => each.toFixed(i < 2 ? 1 : 3)).join(" ");
  }

  /** How finely it was drawn, and how long pictures take, ms, in words that tests read. */
  get fineness_words(): string {
    return `${this.#ratio} ${this.#pace.took.toFixed(0)}`;
  }
  #ratio = 1;

  /** The picture that was asked for is not there yet. */
  get busy(): boolean {
    return this.#pace.drawing;
  }

  /** Asks for a picture, if something has changed and the machine keeps up. `named`: puts labels where their places are on the screen, in px. */
  draw(named: (label: Label, x: number, y: number, seen: boolean) => void): boolean {
    if (!this.#boxes) return false;
    if (this.#flight) {
      const { from, to, begun } = this.#flight, part = Math.min(1, (performance.now() - begun) / 250), eased = part * part * (3 - 2 * part);
      const between = (i: 0 | 1 | 2) => from[i] + (to[i] - from[i]) * eased;
      const target = this.follow ? this.tipAt.clone() : from[3].clone().lerp(to[3], eased);
      this.#put(between(0), between(1), between(2), target);
      if (part === 1) this.#flight = undefined;
    }
    const now = performance.now(), refines = !this.stale && this.#pace.shouldRefine(now);
    if ((!this.stale && !refines) || !this.#pace.may(now)) return false;
    this.stale = false;
    const { ratio, shadow } = this.#pace.begin(now, refines);
    this.#ratio = refines && !this.#graphicsCard ? ratio : Math.min(ratio, devicePixelRatio);
    const wanted: Wanted = {
      news: { ...this.#news, path: this.path.take(), wholePath: this.wholePath.take() },
      position: this.camera.position.toArray(), turn: this.camera.quaternion.toArray(), ratio: this.#ratio, shadow,
    };
    this.#painter.postMessage(wanted);
    this.#news = {};
    this.camera.updateMatrixWorld();
    const { clientWidth: width, clientHeight: height } = this.canvas, place = new Vector3();
    for (const each of this.labels) {
      place.copy(each.place).project(this.camera);
      named(each, ((place.x + 1) / 2) * width, ((1 - place.y) / 2) * height, place.z < 1 && Math.abs(place.x) < 1.02 && Math.abs(place.y) < 1.02);
    }
    return true;
  }

  end(): void {
    this.controls.dispose();
    this.#painter.terminate();
  }
}
