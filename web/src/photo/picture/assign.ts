/** Which ball is which: every name at most once, at the least total cost. */

/** Rounds of exchanges at most; with 22 balls four are usual. */
const ROUNDS = 50;

/**
 * A column for each row of `costs`, all different, such that no exchange of two rows, and no change to a free
 * column, lowers the sum. Rows must not outnumber columns.
 */
export function assign(costs: readonly (readonly number[])[]): number[] {
  const columns = costs[0]?.length ?? 0;
  const free = new Set(Array.from({ length: columns }, (_, k) => k));
  const chosen = costs.map(() => -1);
  // The row with the most to lose chooses first.
  const order = costs.map((row, k) => ({ k, loss: regret(row) })).sort((a, b) => b.loss - a.loss);
  for (const { k } of order) {
    const best = [...free].reduce((a, b) => (costs[k]![b]! < costs[k]![a]! ? b : a));
    chosen[k] = best;
    free.delete(best);
  }
  for (let round = 0; round < ROUNDS && improved(costs, chosen, free); round += 1);
  return chosen;
}

/** One round of exchanges; false if none lowers the sum. */
function improved(
  costs: readonly (readonly number[])[],
  chosen: number[],
  free: Set<number>,
): boolean {
  let better = false;
  for (let a = 0; a < chosen.length; a += 1) {
    for (const column of free) {
      if (costs[a]![column]! >= costs[a]![chosen[a]!]!) continue;
      free.add(chosen[a]!);
      free.delete(column);
      chosen[a] = column;
      better = true;
    }
    for (let b = 0; b < a; b += 1) {
      const [x, y] = [chosen[a]!, chosen[b]!];
      if (costs[a]![y]! + costs[b]![x]! >= costs[a]![x]! + costs[b]![y]!) continue;
      [chosen[a], chosen[b]] = [y, x];
      better = true;
    }
  }
  return better;
}

/** How much more the second best column of a row costs than the best one. */
function regret(row: readonly number[]): number {
  const sorted = row.toSorted((a, b) => a - b);
  return (sorted[1] ?? Infinity) - sorted[0]!;
}

/** The sum of the costs of an assignment. */
export function total(costs: readonly (readonly number[])[], chosen: readonly number[]): number {
  return chosen.reduce((sum, column, row) => sum + costs[row]![column]!, 0);
}
