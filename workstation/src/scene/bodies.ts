// Where the cell's bodies are, by the rows of the channel of poses. It knows no graphics.
import { Matrix4, Quaternion, Vector3 } from "three";
import type { Scene } from "../../generated/protocol";

export const matrixOf = (position: readonly number[], turn: readonly number[]): Matrix4 =>
  new Matrix4().compose(new Vector3(...(position as [number, number, number])), new Quaternion(...(turn as [number, number, number, number])), new Vector3(1, 1, 1));

const one = new Vector3(1, 1, 1), place = new Vector3(), next = new Vector3(), turn = new Quaternion(), nextTurn = new Quaternion();
/** The numbers of a pose: where it is, and how it is turned. */
const width = 7;

function poseOf(rows: Float32Array, i: number, position: Vector3, rotation: Quaternion): void {
  const at = i * width;
  if (at + width > rows.length) return;
  position.fromArray(rows, at);
  rotation.fromArray(rows, at + 3);
}

export class Bodies {
  /** Of each body, in the world. */
  readonly matrices: readonly Matrix4[];
  /** Those that move, in the order of the rows. */
  #moving: readonly number[];

  constructor(readonly scene: Scene) {
    this.matrices = scene.bodies.map((each) => matrixOf(each.position, each.turn));
    this.#moving = scene.bodies.flatMap((body, at) => (body.moves ? [at] : []));
  }

  /** Puts the bodies where the rows say; `part` of the way to the next rows, if there are such. */
  put(rows: Float32Array, later?: Float32Array, part = 0): void {
    this.#moving.forEach((body, i) => {
      poseOf(rows, i, place, turn);
      if (later && part > 0) {
        poseOf(later, i, next, nextTurn);
        place.lerp(next, part);
        turn.slerp(nextTurn, part);
      }
      this.matrices[body]!.compose(place, turn, one);
    });
  }

  /** A frame on a body, in the world, where the body was put. */
  frame({ body, position, turn: turned }: Scene["tip"]): Matrix4 {
    return this.matrices[body]!.clone().multiply(matrixOf(position, turned));
  }

  /** A frame on a body, in the world, as these rows have it. The bodies stay where they are. */
  frameBy(rows: Float32Array, { body, position, turn: turned }: Scene["tip"], into: Matrix4): Matrix4 {
    const i = this.#moving.indexOf(body), { position: at, turn: as } = this.scene.bodies[body]!;
    if (i < 0 || (i + 1) * width > rows.length) into.copy(matrixOf(at, as));
    else {
      poseOf(rows, i, place, turn);
      into.compose(place, turn, one);
    }
    return into.multiply(matrixOf(position, turned));
  }
}
