import { BoxGeometry, Group, Mesh, PerspectiveCamera, Vector3 } from "three";
import { expect, test } from "vitest";
import { Lines } from "../../../src/viewer/overlay/pixel-lines.ts";
import { Extent, setCover } from "../../../src/viewer/render/extent.ts";
import { TILE, Tiles } from "../../../src/viewer/render/tiles.ts";

/** Tiles of a screen of 10 × 6 tiles, without the marks of its first picture. */
function screen(): Tiles {
  const tiles = new Tiles();
  tiles.resize(10 * TILE, 6 * TILE);
  tiles.take();
  tiles.take();
  return tiles;
}

/** A camera 10 m above the origin that sees 10 m × 6 m: a metre per tile. */
function above(): PerspectiveCamera {
  const camera = new PerspectiveCamera((360 / Math.PI) * Math.atan(0.3), 10 / 6, 0.1, 100);
  camera.position.set(0, 0, 10);
  camera.updateMatrixWorld();
  return camera;
}

/** The tiles that an object marks, and a function that says whether those include a place (m). */
function extentOf(object: Group | Mesh, camera = above()) {
  const tiles = screen();
  new Extent(tiles).mark(object, camera, [10 * TILE, 6 * TILE]);
  const marked = new Set(tiles.take());
  const covers = (x: number, y: number) => marked.has(10 * Math.floor(y + 3) + Math.floor(x + 5));
  return { marked, covers };
}

test("the first picture on a screen, and the one after, cover all tiles", () => {
  const tiles = new Tiles();
  tiles.resize(TILE + 1, 2 * TILE);
  expect([...tiles.take()]).toEqual([0, 1, 2, 3]);
  expect(tiles.take()).toHaveLength(4);
  expect(tiles.take()).toHaveLength(0);
});

test("a screen of the same size keeps its marks", () => {
  const tiles = screen();
  tiles.resize(10 * TILE, 6 * TILE);
  expect(tiles.take()).toHaveLength(0);
});

test("a tile is restored once more after what it shows has left", () => {
  const tiles = screen();
  tiles.mark(5, 5, 6, 6);
  expect([...tiles.take()]).toEqual([0]);
  tiles.mark(TILE + 5, 5, TILE + 6, 6);
  expect([...tiles.take()]).toEqual([0, 1]);
  expect([...tiles.take()]).toEqual([1]);
  expect([...tiles.take()]).toEqual([]);
});

test("a rectangle marks the tiles that it touches on the screen", () => {
  const tiles = screen();
  tiles.mark(-50, -50, TILE + 1, 1);
  expect([...tiles.take()]).toEqual([0, 1]);
  tiles.take();
  tiles.mark(11 * TILE, 0, 12 * TILE, TILE);
  tiles.mark(0, -2 * TILE, TILE, -TILE);
  tiles.mark(0, 7 * TILE, TILE, 8 * TILE);
  expect(tiles.take()).toHaveLength(0);
});

test("a diagonal line marks every tile that it crosses, and not the whole rectangle around it", () => {
  const tiles = screen();
  tiles.markLine(0, 0, 6 * TILE - 1, 6 * TILE - 1, 1);
  const marked = [...tiles.take()];
  for (let k = 0; k < 6; k += 1) expect(marked).toContain(11 * k);
  expect(marked.length).toBeLessThan(20);
});

test("a mesh covers the tiles of its box", () => {
  const { covers, marked } = extentOf(new Mesh(new BoxGeometry(3, 1, 0.01)));
  for (const x of [-1.4, 0, 1.4]) for (const y of [-0.4, 0.4]) expect(covers(x, y)).toBe(true);
  expect(marked.size).toBeLessThan(40);
});

test("a turned stick covers the tiles along it", () => {
  const stick = new Mesh(new BoxGeometry(0.02, 6, 0.02));
  stick.rotation.z = -Math.PI / 4;
  const { covers, marked } = extentOf(stick);
  for (const at of [-2, -0.7, 0.3, 2]) expect(covers(at, at)).toBe(true);
  expect(marked.size).toBeLessThan(20);
});

test("hidden objects, and those of other layers, cover nothing", () => {
  const group = new Group();
  const [hidden, other] = [new Mesh(new BoxGeometry()), new Mesh(new BoxGeometry())];
  hidden.visible = false;
  other.layers.set(1);
  group.add(hidden, other);
  expect(extentOf(group).marked.size).toBe(0);
});

test("an object names its parts itself, and what is behind the camera covers everything", () => {
  const group = new Group();
  const at = new Vector3(-4.5, -2.5, 0);
  setCover(group, (add) => add(at, at, 0.1, 0));
  expect([...extentOf(group).marked]).toEqual([0]);
  at.z = 11;
  expect(extentOf(group).marked.size).toBe(60);
});

test("lines cover the tiles along their segments", () => {
  const lines = new Lines({ width: 2, opacity: 1 });
  lines.add([-4.5, -2.5, 0, 1.5, -2.5, 0, 1.5, 1.5, 0], 3, "#ffffff").commit();
  const { covers } = extentOf(lines.object);
  expect([covers(-4.5, -2.5), covers(-1.5, -2.5), covers(1.5, 0.5)]).toEqual([true, true, true]);
  expect([covers(-4.5, 1.5), covers(3.5, -2.5)]).toEqual([false, false]);
  lines.clear().commit();
  expect(extentOf(lines.object).marked.size).toBe(0);
});
