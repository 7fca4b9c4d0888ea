// What the page and the painter must agree on, so that names stand where things are drawn.
export const view = {
  /** From the lower to the upper edge, degrees. */
  angle: 32,
  /** What is nearer or farther is not drawn, m. */
  near: 0.02,
  far: 60,
  /** Where the floor shows which way x, y and z are, m: before the cell, where nothing hides it. */
  directions: [-0.7, -0.9, 0.002],
  /** The length of these arrows, m. */
  directionLength: 0.25,
} as const;
