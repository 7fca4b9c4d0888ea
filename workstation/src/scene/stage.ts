// The picture of the cell: bodies, marks, light, camera. It is drawn anew only when something in it has changed.
import { Box3, Color, DirectionalLight, HemisphereLight, Matrix4, MathUtils, PCFShadowMap, PerspectiveCamera, Scene as Picture, Vector3, WebGLRenderer } from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import type { Scene } from "../../generated/protocol";
import { look } from "../live/look";
import { Arrow, arrowLook, Axes, Fan, Floor, Path, presses } from "./marks";
import { frameAt, matrixOf, modelOf, putBodies, type Model } from "./model";
import { Pace, type Fineness } from "./pace";

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

/** Where the floor shows which way x, y and z are: before the cell, where nothing hides it. */
const directions = new Vector3(-0.7, -0.9, 0.002);

export interface Label {
  key: string;
  kind: "location" | "force" | "axis";
  text: string;
  place: Vector3;
}

export interface Place {
  location: string;
  position: readonly number[];
  turn: readonly number[];
}

export interface Shows {
  path: boolean;
  contacts: boolean;
  sensor: boolean;
  laser: boolean;
  locations: boolean;
}

/** False: the processor draws. */
function hasGraphicsCard(): boolean {
  const context = document.createElement("canvas").getContext("webgl2", { failIfMajorPerformanceCaveat: true });
  context?.getExtension("WEBGL_lose_context")?.loseContext();
  return context !== null;
}

export class Stage {
  readonly model: Model;
  readonly camera = new PerspectiveCamera(32, 1, 0.02, 60);
  readonly controls: OrbitControls;
  readonly path = new Path(2.5, 40000);
  /** Of a replay: the whole of it. */
  readonly wholePath = new Path(1.5, 40000);
  readonly fan = new Fan();
  readonly tip = new Matrix4();
  readonly tipAt = new Vector3();
  follow = false;
  /** Something has changed since it was drawn last. */
  stale = true;
  labels: Label[] = [];

  #renderer: WebGLRenderer;
  #pace = new Pace();
  /** Edges are smooth by the graphics card. Else those of a picture that rests are, since it is drawn with more pixels. */
  #smooth: boolean;
  /** Passed once the picture that was asked for is drawn. */
  #fence: WebGLSync | null = null;
  #picture = new Picture();
  #sky = new HemisphereLight(0xffffff, 0x8a8f96, 1.7);
  #sun = new DirectionalLight(0xffffff, 2.1);
  #floor = new Floor();
  #tool = new Axes(0.08, 3);
  #world = new Axes(0.25, 2.5);
  #places: { axes: Axes; label: Label }[] = [];
  #arrows: Arrow[] = [];
  #contactLook = arrowLook();
  #sensorLook = arrowLook();
  #sensorArrow = new Arrow(this.#sensorLook);
  #flight: { from: [number, number, number, Vector3]; to: [number, number, number, Vector3]; begun: number } | undefined;
  #shows: Shows = { path: true, contacts: true, sensor: false, laser: true, locations: true };
  #forces: Label[] = [];
  /** The rows that are in the picture; undefined: none, or a place between two rows. */
  #bodiesPut: Float32Array | undefined;
  #contactsPut: Float32Array | undefined;
  #sensorLabel: Label | undefined;

  /** Throws if this browser draws nothing in three dimensions. */
  constructor(readonly canvas: HTMLCanvasElement, readonly scene: Scene, readonly still: () => boolean) {
    this.#smooth = hasGraphicsCard();
    this.#renderer = new WebGLRenderer({ canvas, antialias: this.#smooth });
    this.#renderer.shadowMap.enabled = true;
    this.#renderer.shadowMap.type = PCFShadowMap;
    // Shadows move with the bodies, not with the camera.
    this.#renderer.shadowMap.autoUpdate = false;
    this.model = modelOf(scene);
    this.camera.up.set(0, 0, 1);
    this.#sun.position.set(1.2, -1.6, 3.2);
    this.#sun.castShadow = true;
    this.#sun.shadow.mapSize.set(2048, 2048);
    Object.assign(this.#sun.shadow.camera, { left: -1.6, right: 1.6, top: 1.6, bottom: -1.6, near: 0.5, far: 7 });
    this.#sun.shadow.bias = -0.0006;
    this.#sun.shadow.normalBias = 0.01;
    this.#sky.position.set(0, 0, 1);
    this.#sensorArrow.visible = false;
    this.#picture.add(this.model.root, this.#floor.object, this.#sky, this.#sun, this.#tool, this.#world, this.path.object, this.wholePath.object, this.fan.object, this.#sensorArrow);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.enableDamping = false;
    this.controls.maxPolarAngle = MathUtils.degToRad(100);
    this.controls.minDistance = 0.12;
    this.controls.maxDistance = 12;
    this.controls.addEventListener("change", () => (this.stale = true));
    this.controls.addEventListener("start", () => (this.#flight = undefined));
    this.#world.matrix.setPosition(directions);
    this.colour();
    this.#put(...this.#wanted("iso"));
    this.#renderer.shadowMap.needsUpdate = true;
  }

  /** The colours of the page's theme. */
  colour(): void {
    const style = getComputedStyle(document.documentElement), of = (name: string) => style.getPropertyValue(name).trim(), colours = look();
    const dark = document.documentElement.dataset["theme"] === "dark";
    this.#picture.background = new Color(of("--canvas"));
    this.#floor.colour(of("--edge"), dark);
    this.model.edges.color.set(dark ? "#000000" : colours.ink);
    this.model.edges.opacity = dark ? 0.55 : 0.35;
    for (const each of [this.#tool, this.#world, ...this.#places.map((one) => one.axes)]) each.colour(colours.series.slice(0, 3));
    this.path.colour(colours.accent, 1);
    this.wholePath.colour(colours.accent, 0.4);
    this.fan.colour(colours.error);
    this.#contactLook.color.set(colours.error);
    this.#sensorLook.color.set(colours.series[5]!);
    this.#sky.intensity = dark ? 1.15 : 1.7;
    this.#sun.intensity = dark ? 1.7 : 2.1;
    this.stale = true;
  }

  get shown(): Shows {
    return this.#shows;
  }
  show(shows: Shows): void {
    this.#shows = shows;
    this.path.object.visible = this.wholePath.object.visible = shows.path;
    for (const each of this.#places) each.axes.visible = shows.locations;
    for (const each of this.#arrows) each.visible = shows.contacts && each.userData["used"] === true;
    this.#sensorArrow.visible = shows.sensor && this.#sensorLabel !== undefined;
    this.#name();
  }

  /** Where the bodies are; the tool's tip with them. A cell that rests sends what was there before. */
  put(rows: Float32Array, later?: Float32Array, part = 0): void {
    if (part === 0 && near(rows, this.#bodiesPut, () => bodyStep)) return;
    this.#bodiesPut = part === 0 ? rows : undefined;
    putBodies(this.model, rows, later, part);
    this.#renderer.shadowMap.needsUpdate = true;
    this.model.root.updateMatrixWorld(true);
    const { tip } = this.scene, body = this.model.bodies[tip.body]!;
    this.tip.copy(body.matrixWorld).multiply(matrixOf(tip.position, tip.turn));
    const before = this.tipAt.clone();
    this.tipAt.setFromMatrixPosition(this.tip);
    this.#tool.matrix.copy(this.tip);
    this.#tool.matrixWorldNeedsUpdate = true;
    if (this.follow) {
      const moved = this.tipAt.clone().sub(before);
      this.camera.position.add(moved);
      this.controls.target.add(moved);
    }
    this.stale = true;
  }

  /** Where the tip is by these rows. */
  tipOf(rows: Float32Array, into: Matrix4): Matrix4 {
    return frameAt(this.scene, this.model, this.scene.tip, rows, into);
  }

  /** Contacts as rows of the protocol have them. `value`: a force in words. */
  press(rows: Float32Array, value: (newton: number) => string): void {
    if (near(rows, this.#contactsPut, (column) => (column < 3 ? contactStep : forceStep))) return;
    this.#contactsPut = rows;
    const all = presses(rows);
    while (this.#arrows.length < all.length) {
      const made = new Arrow(this.#contactLook);
      this.#arrows.push(made);
      this.#picture.add(made);
    }
    this.#forces = all.map(({ position, force }, i) => {
      const newton = force.length(), length = MathUtils.clamp(newton * m_per_N, shortest, longest), direction = force.normalize();
      // It ends where it presses.
      const begin = position.clone().addScaledVector(direction, -length);
      this.#arrows[i]!.put(begin, direction, length);
      return { key: `force ${i}`, kind: "force", text: value(newton), place: begin };
    });
    this.#arrows.forEach((each, i) => {
      each.userData["used"] = i < all.length;
      each.visible = this.#shows.contacts && i < all.length;
    });
    this.#name();
  }

  /** What acts on the sensor, N in its frame; undefined: it is not known. */
  feel(force: readonly number[] | undefined, value: (newton: number) => string): void {
    // It always sways a little, and its arrow is seldom asked for.
    if (!this.#shows.sensor && !this.#sensorLabel) return;
    this.#sensorLabel = undefined;
    if (force) {
      const { sensor } = this.scene, frame = this.model.bodies[sensor.body]!.matrixWorld.clone().multiply(matrixOf(sensor.position, sensor.turn));
      const begin = new Vector3().setFromMatrixPosition(frame), along = new Vector3(force[0], force[1], force[2]).transformDirection(frame);
      const newton = Math.hypot(force[0]!, force[1]!, force[2]!);
      if (newton > 0.05) {
        const length = MathUtils.clamp(newton * m_per_N, shortest, longest);
        this.#sensorArrow.put(begin, along, length);
        this.#sensorLabel = { key: "sensor", kind: "force", text: value(newton), place: begin.clone().addScaledVector(along, length) };
      }
    }
    this.#sensorArrow.visible = this.#shows.sensor && this.#sensorLabel !== undefined;
    this.#name();
  }

  /** The taught locations, as frames with their names. Those that are at one place have one name. */
  place(places: readonly Place[]): void {
    for (const { axes } of this.#places) {
      this.#picture.remove(axes);
      axes.end();
    }
    this.#places = [];
    for (const each of places) {
      const at = new Vector3(...(each.position as [number, number, number]));
      const there = this.#places.find((one) => one.label.place.distanceTo(at) < 1e-4);
      if (there) {
        there.label.text += `, ${each.location}`;
        continue;
      }
      const axes = new Axes(0.05, 2.5);
      axes.matrix.copy(matrixOf(each.position, each.turn));
      axes.visible = this.#shows.locations;
      axes.colour(look().series.slice(0, 3));
      this.#picture.add(axes);
      this.#places.push({ axes, label: { key: `location ${each.location}`, kind: "location", text: each.location, place: at } });
    }
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
    this.#renderer.setSize(width, height, false);
    this.camera.aspect = width / Math.max(1, height);
    this.camera.updateProjectionMatrix();
    this.stale = true;
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
    this.model.root.updateMatrixWorld(true);
    const box = new Box3().setFromObject(this.model.root), target = box.getCenter(new Vector3()), [azimuth, height] = view ? views[view] : this.#spherical;
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

  #refine({ ratio, shadow }: Fineness, still: boolean): void {
    const wanted = still && !this.#smooth ? ratio : Math.min(ratio, devicePixelRatio);
    if (this.#renderer.getPixelRatio() !== wanted) this.#renderer.setPixelRatio(wanted);
    if (this.#sun.shadow.mapSize.x === shadow) return;
    this.#sun.shadow.mapSize.set(shadow, shadow);
    this.#sun.shadow.map?.dispose();
    this.#sun.shadow.map = null;
    this.#renderer.shadowMap.needsUpdate = true;
  }

  /** The picture that was asked for is there. */
  #passed(): boolean {
    const gl = this.#renderer.getContext() as WebGL2RenderingContext;
    if (this.#fence && gl.getSyncParameter(this.#fence, gl.SYNC_STATUS) !== gl.SIGNALED && !gl.isContextLost()) return false;
    gl.deleteSync(this.#fence);
    this.#fence = null;
    return true;
  }

  /** How finely it was drawn, and how long pictures take, ms, in words that tests read. */
  get fineness_words(): string {
    return `${this.#renderer.getPixelRatio()} ${this.#pace.took.toFixed(0)}`;
  }

  /** Draws, if something has changed and the machine keeps up. `named`: puts labels where their places are on the screen, in px. */
  draw(named: (label: Label, x: number, y: number, seen: boolean) => void): boolean {
    if (this.#flight) {
      const { from, to, begun } = this.#flight, part = Math.min(1, (performance.now() - begun) / 250), eased = part * part * (3 - 2 * part);
      const between = (i: 0 | 1 | 2) => from[i] + (to[i] - from[i]) * eased;
      const target = this.follow ? this.tipAt.clone() : from[3].clone().lerp(to[3], eased);
      this.#put(between(0), between(1), between(2), target);
      if (part === 1) this.#flight = undefined;
    }
    const now = performance.now();
    if (this.#pace.drawing && this.#passed()) this.#pace.end(now);
    const refines = !this.stale && this.#pace.shouldRefine(now);
    if ((!this.stale && !refines) || !this.#pace.may(now)) return false;
    this.stale = false;
    this.#refine(this.#pace.begin(now, refines), refines);
    this.#renderer.render(this.#picture, this.camera);
    const gl = this.#renderer.getContext() as WebGL2RenderingContext;
    this.#fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
    const { clientWidth: width, clientHeight: height } = this.canvas, place = new Vector3();
    for (const each of this.labels) {
      place.copy(each.place).project(this.camera);
      named(each, ((place.x + 1) / 2) * width, ((1 - place.y) / 2) * height, place.z < 1 && Math.abs(place.x) < 1.02 && Math.abs(place.y) < 1.02);
    }
    return true;
  }

  end(): void {
    this.controls.dispose();
    this.path.end();
    this.wholePath.end();
    this.fan.end();
    this.#renderer.dispose();
    this.#renderer.forceContextLoss();
  }
}
