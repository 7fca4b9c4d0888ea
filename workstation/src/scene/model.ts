// The cell's shapes as three.js has them: one mesh and one set of edges for each body. It knows no server and no page.
import {
  BoxGeometry, BufferAttribute, BufferGeometry, CapsuleGeometry, Color, CylinderGeometry, EdgesGeometry, Group, LineBasicMaterial, LineSegments, Mesh, MeshLambertMaterial,
  SphereGeometry,
} from "three";
import { mergeGeometries } from "three/examples/jsm/utils/BufferGeometryUtils.js";
import type { Scene, SceneShape } from "../../generated/protocol";
import { matrixOf } from "./bodies";

const round = 32;

/** The shape about its own origin; undefined: a plane, which is drawn as the floor. */
function geometryOf(shape: SceneShape): BufferGeometry | undefined {
  const [a, b, c] = shape.size;
  switch (shape.kind) {
    case "box":
      return new BoxGeometry(2 * a, 2 * b, 2 * c);
    case "sphere":
      return new SphereGeometry(a, round, round / 2);
    case "ellipsoid":
      return new SphereGeometry(1, round, round / 2).scale(a, b, c);
    // Those of three.js stand along y.
    case "cylinder":
      return new CylinderGeometry(a, a, 2 * b, round).rotateX(Math.PI / 2);
    case "capsule":
      return new CapsuleGeometry(a, 2 * b, 6, round / 2).rotateX(Math.PI / 2);
    case "mesh": {
      if (!shape.corners || !shape.triangles) return new BoxGeometry(2 * a, 2 * b, 2 * c);
      const made = new BufferGeometry();
      made.setAttribute("position", new BufferAttribute(Float32Array.from(shape.corners), 3));
      made.setIndex(shape.triangles);
      made.computeVertexNormals();
      return made;
    }
    case "plane":
      return undefined;
  }
}

export interface Model {
  /** All bodies; add it to a scene. */
  root: Group;
  /** In the order of the scene's bodies. */
  bodies: readonly Group[];
  edges: LineBasicMaterial;
}

/** A body's shapes with their colours in one geometry each for what is solid and what can be seen through. */
export function modelOf(scene: Scene): Model {
  const root = new Group();
  const edges = new LineBasicMaterial({ transparent: true, opacity: 0.35 });
  // Without gloss: where the processor draws, a glossy picture takes a third longer.
  const solid = new MeshLambertMaterial({ vertexColors: true, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 });
  const clear = solid.clone();
  Object.assign(clear, { transparent: true, opacity: 0.5 });
  const bodies = scene.bodies.map((body, at) => {
    const group = new Group(), parts: Record<"solid" | "clear", BufferGeometry[]> = { solid: [], clear: [] }, lines: BufferGeometry[] = [];
    group.matrixAutoUpdate = false;
    group.matrix.copy(matrixOf(body.position, body.turn));
    for (const shape of scene.shapes.filter((each) => each.body === at)) {
      const made = geometryOf(shape);
      if (!made) continue;
      made.deleteAttribute("uv");
      made.applyMatrix4(matrixOf(shape.position, shape.turn));
      const color = new Color().setRGB(shape.colour[0], shape.colour[1], shape.colour[2], "srgb"), count = made.getAttribute("position").count;
      const colours = new Float32Array(3 * count);
      for (let i = 0; i < count; ++i) color.toArray(colours, 3 * i);
      made.setAttribute("color", new BufferAttribute(colours, 3));
      if (shape.kind !== "mesh") lines.push(new EdgesGeometry(made, 32));
      parts[shape.colour[3] < 1 ? "clear" : "solid"].push(made);
    }
    for (const kind of ["solid", "clear"] as const) {
      const merged = parts[kind].length > 0 ? mergeGeometries(parts[kind]) : null;
      if (!merged) continue;
      const mesh = new Mesh(merged, kind === "solid" ? solid : clear);
      mesh.castShadow = kind === "solid";
      mesh.receiveShadow = true;
      group.add(mesh);
    }
    if (lines.length > 0) group.add(new LineSegments(mergeGeometries(lines), edges));
    root.add(group);
    return group;
  });
  return { root, bodies, edges };
}
