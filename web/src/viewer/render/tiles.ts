/** The part of the screen that a picture changes, in square tiles. */

/** Side of a tile, device pixels. Smaller tiles fit better, larger ones are fewer. */
export const TILE = 32;

/** Tiles in which something is drawn, for the present picture and the one before. */
export class Tiles {
  #columns = 0;
  #rows = 0;
  /** One number per tile, row by row from the lower left: 1 if something is drawn in it. */
  #now = new Uint8Array(0);
  #before = new Uint8Array(0);
  /** Indices of the tiles of the last call of `take`. */
  #taken = new Uint32Array(0);

  get columns(): number {
    return this.#columns;
  }

  get count(): number {
    return this.#now.length;
  }

  /** Adapts to a screen, pixels. After a change every tile is marked. */
  resize(width: number, height: number): void {
    const [columns, rows] = [Math.ceil(width / TILE), Math.ceil(height / TILE)];
    if (columns === this.#columns && rows === this.#rows) return;
    [this.#columns, this.#rows] = [columns, rows];
    this.#now = new Uint8Array(columns * rows);
    this.#before = new Uint8Array(columns * rows);
    this.#taken = new Uint32Array(columns * rows);
    this.markAll();
  }

  markAll(): void {
    this.#now.fill(1);
  }

  /** Marks the tiles of a rectangle; pixels from the lower left corner of the screen. */
  mark(left: number, bottom: number, right: number, top: number): void {
    const first = Math.max(0, Math.floor(left / TILE));
    const last = Math.min(this.#columns - 1, Math.floor(right / TILE));
    const highest = Math.min(this.#rows - 1, Math.floor(top / TILE));
    if (last < first) return;
    for (let row = Math.max(0, Math.floor(bottom / TILE)); row <= highest; row += 1) {
      this.#now.fill(1, row * this.#columns + first, row * this.#columns + last + 1);
    }
  }

  /** Marks the tiles within `margin` of the line from (x, y) to (endX, endY), all in pixels. */
  markLine(x: number, y: number, endX: number, endY: number, margin: number): void {
    const [dx, dy] = [endX - x, endY - y];
    const steps = Math.max(1, Math.ceil((2 * Math.max(Math.abs(dx), Math.abs(dy))) / TILE));
    for (let step = 0; step < steps; step += 1) {
      const [fromX, fromY] = [x + (dx * step) / steps, y + (dy * step) / steps];
      const [toX, toY] = [fromX + dx / steps, fromY + dy / steps];
      this.mark(
        Math.min(fromX, toX) - margin,
        Math.min(fromY, toY) - margin,
        Math.max(fromX, toX) + margin,
        Math.max(fromY, toY) + margin,
      );
    }
  }

  /**
   * Ends a picture.
   *
   * @returns The tiles that were marked for it or for the one before: what it covers, and what it must
   * restore. The array is valid until the next call.
   */
  take(): Uint32Array {
    let count = 0;
    for (let tile = 0; tile < this.#now.length; tile += 1) {
      if (this.#now[tile] || this.#before[tile]) this.#taken[count++] = tile;
    }
    [this.#now, this.#before] = [this.#before, this.#now];
    this.#now.fill(0);
    return this.#taken.subarray(0, count);
  }
}
