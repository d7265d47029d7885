/** Small dense linear algebra: systems of at most a dozen unknowns. */

/** Rows of a matrix. */
export type Matrix = readonly (readonly number[])[];

/** The solution x of A x = b by elimination with partial pivoting; null if A is singular. */
export function solve(a: Matrix, b: readonly number[]): number[] | null {
  const n = b.length;
  const rows = a.map((row, i) => [...row, b[i]!]);
  for (let k = 0; k < n; k += 1) {
    let pivot = k;
    for (let i = k + 1; i < n; i += 1) {
      if (Math.abs(rows[i]![k]!) > Math.abs(rows[pivot]![k]!)) pivot = i;
    }
    const head = rows[pivot]!;
    rows[pivot] = rows[k]!;
    rows[k] = head;
    if (!(Math.abs(head[k]!) > Number.MIN_VALUE)) return null;
    for (const row of rows.slice(k + 1)) {
      const factor = row[k]! / head[k]!;
      for (let j = k; j <= n; j += 1) row[j]! -= factor * head[j]!;
    }
  }
  const x = new Array<number>(n).fill(0);
  for (let k = n - 1; k >= 0; k -= 1) {
    const row = rows[k]!;
    let rest = row[n]!;
    for (let j = k + 1; j < n; j += 1) rest -= row[j]! * x[j]!;
    x[k] = rest / row[k]!;
  }
  return x.every(Number.isFinite) ? x : null;
}

/** The inverse of a symmetric matrix; null if it is singular. */
export function inverse(a: Matrix): number[][] | null {
  const columns = a.map((_, k) =>
    solve(
      a,
      a.map((_, i) => Number(i === k)),
    ),
  );
  return columns.every((column) => column !== null) ? columns : null;
}

/** Aᵀ A and Aᵀ b: the normal equations of the least squares problem A x ≈ b. */
export function normal(a: Matrix, b: readonly number[]): { matrix: number[][]; right: number[] } {
  const n = a[0]?.length ?? 0;
  const matrix = Array.from({ length: n }, () => new Array<number>(n).fill(0));
  const right = new Array<number>(n).fill(0);
  a.forEach((row, k) => {
    for (let i = 0; i < n; i += 1) {
      right[i]! += row[i]! * b[k]!;
      for (let j = 0; j < n; j += 1) matrix[i]![j]! += row[i]! * row[j]!;
    }
  });
  return { matrix, right };
}
