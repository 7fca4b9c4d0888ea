// What is drawn over the bodies: axes, arrows of forces, the laser's fan, the tool's path, the floor's grid.
import {
  BufferAttribute, BufferGeometry, Color, DynamicDrawUsage, Group, type InstancedInterleavedBuffer, LineBasicMaterial, LineSegments, Matrix4, Mesh, MeshBasicMaterial, MeshStandardMaterial, PlaneGeometry, ShadowMaterial,
  CylinderGeometry, ConeGeometry, DoubleSide, Vector3, type ColorRepresentation,
} from "three";
import { LineMaterial } from "three/examples/jsm/lines/LineMaterial.js";
import { LineSegments2 } from "three/examples/jsm/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/examples/jsm/lines/LineSegmentsGeometry.js";
import type { ArrowNews, FanNews } from "./news";
import { longestTrail, nextCount, type TrailNews } from "./trail";

/** Three arrows along x, y and z. */
export class Axes extends Group {
  #lines: LineSegments2;
  constructor(length: number, width: number) {
    super();
    const geometry = new LineSegmentsGeometry();
    geometry.setPositions([0, 0, 0, length, 0, 0, 0, 0, 0, 0, length, 0, 0, 0, 0, 0, 0, length]);
    this.#lines = new LineSegments2(geometry, new LineMaterial({ linewidth: width, vertexColors: true }));
    this.add(this.#lines);
    this.matrixAutoUpdate = false;
  }
  colour(colours: readonly ColorRepresentation[]): void {
    this.#lines.geometry.setColors(colours.flatMap((each) => [...new Color(each).toArray(), ...new Color(each).toArray()]));
  }
  end(): void {
    this.#lines.geometry.dispose();
    this.#lines.material.dispose();
  }
}

const up = new Vector3(0, 1, 0);

/** An arrow with a body, so that light shows where it points. It ends, or begins, at a place. */
export class Arrow extends Group {
  #shaft: Mesh<CylinderGeometry, MeshStandardMaterial>;
  #head: Mesh<ConeGeometry, MeshStandardMaterial>;
  constructor(material: MeshStandardMaterial) {
    super();
    this.#shaft = new Mesh(new CylinderGeometry(0.0028, 0.0028, 1, 12), material);
    this.#head = new Mesh(new ConeGeometry(0.008, 0.022, 16), material);
    this.#shaft.renderOrder = this.#head.renderOrder = 10;
    this.add(this.#shaft, this.#head);
  }
  put({ begin, direction, length }: ArrowNews): void {
    const shaft = Math.max(0.001, length - 0.022);
    this.position.fromArray(begin as number[]);
    this.quaternion.setFromUnitVectors(up, new Vector3().fromArray(direction as number[]));
    this.#shaft.scale.y = shaft;
    this.#shaft.position.y = shaft / 2;
    this.#head.position.y = shaft + 0.011;
  }
}

/** A line through points that come one after the other. */
export class Path {
  readonly object: LineSegments2;
  #points = new Float32Array(longestTrail * 6);
  #count = 0;
  /** Where the next piece begins. */
  #last: readonly number[] | undefined;
  constructor(width: number) {
    const geometry = new LineSegmentsGeometry();
    geometry.setPositions(this.#points);
    geometry.instanceCount = 0;
    this.object = new LineSegments2(geometry, new LineMaterial({ linewidth: width, transparent: true }));
    this.#buffer.setUsage(DynamicDrawUsage);
    this.object.frustumCulled = false;
  }
  get #buffer(): InstancedInterleavedBuffer {
    return (this.object.geometry.getAttribute("instanceStart") as unknown as { data: InstancedInterleavedBuffer }).data;
  }
  take({ cleared, points, upTo }: TrailNews): void {
    if (cleared) {
      this.#count = 0;
      this.#last = undefined;
    }
    for (let at = 0; at < points.length; at += 3) this.#add(points.slice(at, at + 3));
    this.object.geometry.instanceCount = Math.min(this.#count, upTo ?? this.#count);
  }
  #add(point: readonly number[]): void {
    if (this.#last) {
      const buffer = this.#buffer, count = nextCount(this.#count);
      if (count <= this.#count) {
        this.#points.copyWithin(0, (this.#count - count + 1) * 6);
        buffer.addUpdateRange(0, count * 6);
      }
      this.#points.set([...this.#last, ...point], (count - 1) * 6);
      // The graphics get what is new, not the whole.
      buffer.addUpdateRange((count - 1) * 6, 6);
      buffer.needsUpdate = true;
      this.#count = count;
    }
    this.#last = point;
  }
  colour(colour: ColorRepresentation, opacity: number): void {
    this.object.material.color.set(colour);
    this.object.material.opacity = opacity;
  }
}

/** The laser's fan: a sheet from the tool to the points that it met, and the line that it draws on them. */
export class Fan {
  readonly object = new Group();
  #sheet = new BufferGeometry();
  #line = new BufferGeometry();
  #sheetLook = new MeshBasicMaterial({ transparent: true, opacity: 0.16, side: DoubleSide, depthWrite: false });
  #lineLook = new LineBasicMaterial();
  constructor() {
    const sheet = new Mesh(this.#sheet, this.#sheetLook), line = new LineSegments(this.#line, this.#lineLook);
    sheet.frustumCulled = line.frustumCulled = false;
    this.object.add(sheet, line);
    this.object.visible = false;
  }
  put({ y, z, tip: numbers }: FanNews): void {
    const tip = new Matrix4().fromArray(numbers as number[]), origin = new Vector3().setFromMatrixPosition(tip), points = Array.from(y, (at, i) => new Vector3(0, at / 1000, z[i]! / 1000).applyMatrix4(tip));
    const sheet: number[] = [], line: number[] = [];
    // Points that are far apart are of two surfaces: nothing is between them.
    const one_surface = 0.012;
    for (let i = 1; i < points.length; ++i) {
      const a = points[i - 1]!, b = points[i]!;
      if (a.distanceTo(b) > one_surface) continue;
      line.push(...a.toArray(), ...b.toArray());
      sheet.push(...origin.toArray(), ...a.toArray(), ...b.toArray());
    }
    this.#sheet.setAttribute("position", new BufferAttribute(Float32Array.from(sheet), 3));
    this.#line.setAttribute("position", new BufferAttribute(Float32Array.from(line), 3));
    this.object.visible = points.length > 0;
  }
  colour(colour: ColorRepresentation): void {
    this.#sheetLook.color.set(colour);
    this.#lineLook.color.set(colour);
  }
}

/** The floor: a line each 100 mm, a stronger one each metre, and the shadows of what stands there. */
export class Floor {
  readonly object = new Group();
  #fine = new LineBasicMaterial({ transparent: true });
  #strong = new LineBasicMaterial({ transparent: true });
  #shadow = new ShadowMaterial({ opacity: 0.16 });
  constructor() {
    const half = 2, fine: number[] = [], strong: number[] = [];
    for (let i = -10 * half; i <= 10 * half; ++i) (i % 10 === 0 ? strong : fine).push(i / 10, -half, 0, i / 10, half, 0, -half, i / 10, 0, half, i / 10, 0);
    for (const [points, look] of [[fine, this.#fine], [strong, this.#strong]] as const) {
      const geometry = new BufferGeometry();
      geometry.setAttribute("position", new BufferAttribute(Float32Array.from(points), 3));
      this.object.add(new LineSegments(geometry, look));
    }
    const shadow = new Mesh(new PlaneGeometry(2 * half, 2 * half), this.#shadow);
    shadow.receiveShadow = true;
    shadow.position.z = -0.001;
    this.object.add(shadow);
  }
  colour(colour: ColorRepresentation, dark: boolean): void {
    this.#fine.color.set(colour);
    this.#strong.color.set(colour);
    this.#fine.opacity = dark ? 0.4 : 0.5;
    this.#strong.opacity = 1;
    this.#shadow.opacity = dark ? 0.4 : 0.14;
  }
}

/** Seen through what is before them: a force on a tool begins inside of what it presses. */
export const arrowLook = (): MeshStandardMaterial => new MeshStandardMaterial({ roughness: 0.5, depthTest: false, transparent: true });
