/** Places on a table, and the names of its parts. */

export type Point = readonly [x: number, y: number];
export type Vector = readonly [x: number, y: number, z: number];

export type RailName =
  "bottom" | "top" | "left" | "right" | "left-lower" | "left-upper" | "right-lower" | "right-upper";

export type PocketName =
  "bottom-left" | "bottom-right" | "left" | "right" | "top-left" | "top-right";
