import { describe, expect, test } from "vitest";
import { linkIn } from "../../../src/app/share/link.ts";

describe("the link in a text file", () => {
  test.each([
    ["#s=1.abc", "#s=1.abc"],
    ["  https://example.org/carom/#s=1.abc\n", "#s=1.abc"],
    ["\uFEFF#s=1.abc", "#s=1.abc"],
    ["#s=", null],
    ["", null],
    ["look: #s=1.abc", null],
    ['{"format": "carom-shot/1"}', null],
  ])("%j is %j", (text, link) => {
    expect(linkIn(text)).toBe(link);
  });

  test("is looked for without a search that grows faster than the file", () => {
    // Seen: 120 kB of "#s=" repeated froze the tab for 15 s.
    const text = "#s=".repeat(40_000);
    expect(linkIn(text)).toBe("#s=#s=");
    expect(linkIn(`${text} `.repeat(2))).toBeNull();
  });
});
