// Draws the cell: bodies, marks, light. It knows no page, and runs in a thread of its own: where the processor draws, a
// picture takes longer than the page may wait.
import { Box3, Color, DirectionalLight, HemisphereLight, type Mesh, PCFShadowMap, PerspectiveCamera, Scene as Picture, WebGLRenderer } from "three";
import { Bodies, matrixOf } from "./bodies";
import { Arrow, arrowLook, Axes, Fan, Floor, Path } from "./marks";
import { modelOf, type Model } from "./model";
import type { ArrowNews, Begin, Colours, Corners, News, Place, Shows, Wanted } from "./news";
import { view } from "./view";

/** False: the processor draws. */
function hasGraphicsCard(): boolean {
  const context = new OffscreenCanvas(1, 1).getContext("webgl2", { failIfMajorPerformanceCaveat: true });
  context?.getExtension("WEBGL_lose_context")?.loseContext();
  return context !== null;
}

/** A map of shadows with so many pixels is a coarse one. */
const coarseShadow = 512;

export class Painter {
  /** Edges are smooth by the graphics card. Else those of a picture that rests are, since it is drawn with more pixels. */
  readonly graphicsCard = hasGraphicsCard();
  #renderer: WebGLRenderer;
  #camera = new PerspectiveCamera(view.angle, 1, view.near, view.far);
  #bodies: Bodies;
  #model: Model;
  #picture = new Picture();
  #sky = new HemisphereLight(0xffffff, 0x8a8f96, 1.7);
  #sun = new DirectionalLight(0xffffff, 2.1);
  #floor = new Floor();
  #tool = new Axes(0.08, 3);
  #world = new Axes(view.directionLength, 2.5);
  #path = new Path(2.5);
  #wholePath = new Path(1.5);
  #fan = new Fan();
  #places: Axes[] = [];
  #arrows: Arrow[] = [];
  #contactLook = arrowLook();
  #sensorLook = arrowLook();
  #sensor = new Arrow(this.#sensorLook);
  #colours: Colours | undefined;
  #shows: Shows = { path: true, contacts: true, sensor: false, laser: true, locations: true };
  #contacts = 0;
  /** How often bodies were put. */
  #moves = 0;
  #felt = false;
  #scanned = false;

  /** Throws if this browser draws nothing in three dimensions. */
  constructor({ canvas, scene }: Begin) {
    this.#renderer = new WebGLRenderer({ canvas, antialias: this.graphicsCard });
    this.#renderer.shadowMap.enabled = true;
    this.#renderer.shadowMap.type = PCFShadowMap;
    // Shadows move with the bodies, not with the camera.
    this.#renderer.shadowMap.autoUpdate = false;
    this.#renderer.shadowMap.needsUpdate = true;
    this.#bodies = new Bodies(scene);
    this.#model = modelOf(scene);
    this.#sun.position.set(1.2, -1.6, 3.2);
    this.#sun.castShadow = true;
    Object.assign(this.#sun.shadow.camera, { left: -1.6, right: 1.6, top: 1.6, bottom: -1.6, near: 0.5, far: 7 });
    this.#sun.shadow.bias = -0.0006;
    this.#sun.shadow.normalBias = 0.01;
    this.#sky.position.set(0, 0, 1);
    this.#world.matrix.setPosition(...view.directions);
    this.#picture.add(this.#model.root, this.#floor.object, this.#sky, this.#sun, this.#tool, this.#world, this.#path.object, this.#wholePath.object, this.#fan.object, this.#sensor);
    this.#look();
  }

  /** Of each body's shapes, in the body's frame. */
  get boxes(): (Corners | null)[] {
    return this.#model.bodies.map((body) => {
      const whole = new Box3();
      body.children.forEach((each) => {
        const { geometry } = each as Mesh;
        geometry.computeBoundingBox();
        whole.union(geometry.boundingBox!);
      });
      return whole.isEmpty() ? null : [...whole.min.toArray(), ...whole.max.toArray()];
    });
  }

  #colour(colours: Colours): void {
    this.#colours = colours;
    this.#picture.background = new Color(colours.background);
    this.#floor.colour(colours.grid, colours.dark);
    this.#model.edges.color.set(colours.edges);
    this.#model.edges.opacity = colours.dark ? 0.55 : 0.35;
    for (const each of [this.#tool, this.#world, ...this.#places]) each.colour(colours.axes);
    this.#path.colour(colours.path, 1);
    this.#wholePath.colour(colours.path, 0.4);
    this.#fan.colour(colours.contact);
    this.#contactLook.color.set(colours.contact);
    this.#sensorLook.color.set(colours.sensor);
    this.#sky.intensity = colours.dark ? 1.15 : 1.7;
    this.#sun.intensity = colours.dark ? 1.7 : 2.1;
  }

  #press(contacts: readonly ArrowNews[]): void {
    while (this.#arrows.length < contacts.length) {
      const made = new Arrow(this.#contactLook);
      this.#arrows.push(made);
      this.#picture.add(made);
    }
    contacts.forEach((each, i) => this.#arrows[i]!.put(each));
    this.#contacts = contacts.length;
  }

  #place(places: readonly Place[]): void {
    for (const each of this.#places) {
      this.#picture.remove(each);
      each.end();
    }
    this.#places = places.map(({ position, turn }) => {
      const axes = new Axes(0.05, 2.5);
      axes.matrix.copy(matrixOf(position, turn));
      if (this.#colours) axes.colour(this.#colours.axes);
      this.#picture.add(axes);
      return axes;
    });
  }

  /** What is seen of what there is. */
  #look(): void {
    const { path, contacts, sensor, laser, locations } = this.#shows;
    this.#path.object.visible = this.#wholePath.object.visible = path;
    this.#arrows.forEach((each, i) => (each.visible = contacts && i < this.#contacts));
    this.#sensor.visible = sensor && this.#felt;
    this.#fan.object.visible = laser && this.#scanned;
    for (const each of this.#places) each.visible = locations;
  }

  #take({ colours, shows, size, bodies, tip, contacts, sensor, fan, places, path, wholePath }: News): void {
    if (colours) this.#colour(colours);
    if (shows) this.#shows = shows;
    if (size) {
      this.#renderer.setSize(size.width, size.height, false);
      this.#camera.aspect = size.width / Math.max(1, size.height);
      this.#camera.updateProjectionMatrix();
    }
    if (bodies) {
      this.#bodies.put(bodies.rows, bodies.later, bodies.part);
      this.#model.bodies.forEach((each, i) => {
        each.matrix.copy(this.#bodies.matrices[i]!);
        each.matrixWorldNeedsUpdate = true;
      });
      // Where pictures are coarse, shadows follow less often.
      if (++this.#moves % (this.#sun.shadow.mapSize.x > coarseShadow ? 1 : 3) === 0) this.#renderer.shadowMap.needsUpdate = true;
    }
    if (tip) {
      this.#tool.matrix.fromArray(tip as number[]);
      this.#tool.matrixWorldNeedsUpdate = true;
    }
    if (contacts) this.#press(contacts);
    if (sensor) this.#sensor.put(sensor);
    if (sensor !== undefined) this.#felt = sensor !== null;
    if (fan) this.#fan.put(fan);
    if (fan !== undefined) this.#scanned = fan !== null;
    if (places) this.#place(places);
    if (path) this.#path.take(path);
    if (wholePath) this.#wholePath.take(wholePath);
    this.#look();
  }

  #refine(ratio: number, shadow: number): void {
    if (this.#renderer.getPixelRatio() !== ratio) this.#renderer.setPixelRatio(ratio);
    if (this.#sun.shadow.mapSize.x === shadow) return;
    this.#sun.shadow.mapSize.set(shadow, shadow);
    this.#sun.shadow.map?.dispose();
    this.#sun.shadow.map = null;
    this.#renderer.shadowMap.needsUpdate = true;
  }

  /** Draws what is wanted, and ends when the picture is there. */
  async draw({ news, position, turn, ratio, shadow }: Wanted): Promise<void> {
    this.#refine(ratio, shadow);
    this.#take(news);
    this.#camera.matrixAutoUpdate = false;
    this.#camera.matrix.copy(matrixOf(position, turn));
    this.#camera.matrixWorldNeedsUpdate = true;
    this.#renderer.render(this.#picture, this.#camera);
    const gl = this.#renderer.getContext() as WebGL2RenderingContext, fence = gl.fenceSync(gl.SYNC_GPU_COMMANDS_COMPLETE, 0);
    gl.flush();
    while (fence && gl.getSyncParameter(fence, gl.SYNC_STATUS) !== gl.SIGNALED && !gl.isContextLost()) await new Promise((then) => setTimeout(then, 1));
    gl.deleteSync(fence);
  }
}
