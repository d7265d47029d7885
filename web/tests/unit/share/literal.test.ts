import { describe, expect, test } from "vitest";
import { toJson, toPrettyJson, toPython } from "../../../src/app/share/literal.ts";

describe("data as text", () => {
  const data = {
    text: 'a "quote"',
    numbers: [1, -0, 0.1, 1e-9, 1e21],
    words: [true, false, null],
    inner: { list: Array.from({ length: 40 }, (_, i) => i / 7) },
  };

  test("reads back as JSON, compact and broken over lines", () => {
    expect(JSON.parse(toJson({ nothing: undefined, ...data }))).toStrictEqual(data);
    expect(JSON.parse(toPrettyJson(data))).toStrictEqual(data);
    expect(toJson(data)).not.toContain("\n");
  });

  test("breaks only values that do not fit on a line", () => {
    expect(toPrettyJson({ position: [0.5, 1.2] })).toBe('{"position": [0.5, 1.2]}');
    const lines = toPrettyJson(data).split("\n");
    expect(lines[2]).toBe('  "numbers": [1, -0.0, 0.1, 1e-9, 1e+21],');
    expect(Math.max(...lines.map((line) => line.length))).toBeLessThanOrEqual(97);
  });

  test("is valid Python, with a comma after the last line of a list", () => {
    expect(toPython([true, false, null, -0])).toBe("[True, False, None, -0.0]");
    expect(toPython(data).split("\n").at(-2)).toBe("  },");
  });

  test("refuses numbers that a file cannot contain", () => {
    expect(() => toJson([Number.NaN])).toThrow(TypeError);
    expect(() => toJson([Infinity])).toThrow(TypeError);
  });
});
