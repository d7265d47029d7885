import { expect, test } from "vitest";
import { hintText } from "../../../src/photo/dialog/hint-text.ts";
import type { Session } from "../../../src/photo/photo-session.ts";

/** The hint beside a photo whose rails bow by a share of their length. */
const told = (bow: number | null) =>
  hintText({
    draft: { marked: true, next: null },
    accuracy: 0.004,
    suggested: 0,
    bow,
  } as unknown as Session);

test("a lens that visibly bends lines is reported with its share, a usual one is not", () => {
  expect(told(0.034)).toMatch(/The lens bends straight lines by 3 %/);
  expect(told(0.009)).not.toMatch(/lens/);
  expect(told(null)).not.toMatch(/lens/);
  expect(told(0.009)).toMatch(/4 mm/);
});
