/**
 * No pattern takes more than linear time: the steps of a search grow at most in proportion to the text. Texts
 * come from strangers: files, links, pasted trees, and the names in them.
 *
 * `recheck` builds the automaton of each pattern and counts how the steps of a backtracking search grow.
 */

import { readdirSync, readFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { checkSync } from "recheck";
import ts from "typescript";
import { describe, expect, test } from "vitest";

const ROOT = fileURLToPath(new URL("../../../src/", import.meta.url));

interface Pattern {
  readonly place: string;
  readonly source: string;
  readonly flags: string;
}

/** The patterns of a file. */
function patternsIn(file: string): Pattern[] {
  const text = readFileSync(ROOT + file, "utf8");
  const source = ts.createSourceFile(file, text, ts.ScriptTarget.Latest, true);
  const found: Pattern[] = [];
  const visit = (node: ts.Node): void => {
    if (ts.isRegularExpressionLiteral(node)) {
      const end = node.text.lastIndexOf("/");
      const { line } = source.getLineAndCharacterOfPosition(node.getStart());
      const place = `${file}:${line + 1}`;
      found.push({ place, source: node.text.slice(1, end), flags: node.text.slice(end + 1) });
    }
    // A pattern that is made from a text would not be checked.
    if (ts.isNewExpression(node) && node.expression.getText() === "RegExp")
      found.push({ place: file, source: "new RegExp", flags: "?" });
    ts.forEachChild(node, visit);
  };
  visit(source);
  return found;
}

const FILES = readdirSync(ROOT, { recursive: true, encoding: "utf8" })
  .filter((file) => file.endsWith(".ts") && !file.includes("engine/pkg"))
  .map((file) => file.replaceAll("\\", "/"));
const PATTERNS = FILES.flatMap(patternsIn);

/** How the steps of a search grow with the text. */
function growth(source: string, flags: string): string {
  const checked = checkSync(source, flags, { checker: "automaton", timeout: 20_000 });
  if (checked.status === "safe") return "linear";
  return checked.status === "unknown" ? "not known" : checked.complexity.type;
}

describe("the steps of a search", () => {
  test.each([
    // Seen: 120 kB of "#s=" in a text file froze the tab for 15 s.
    ["^\\s*\\S*(#s=\\S+)\\s*$", "polynomial"],
    ["[-_ ]*\\d*$", "polynomial"],
    ["^(a+)+$", "exponential"],
  ])("are counted: /%s/ is %s", (source, expected) => {
    expect(growth(source, "")).toBe(expected);
  });

  test("grow with the length of the text and no faster, in every pattern of the page", () => {
    expect(PATTERNS.length).toBeGreaterThan(40);
    const worse = PATTERNS.map(({ place, source, flags }) => ({
      place,
      source,
      growth: growth(source, flags),
    })).filter(({ growth: found }) => found !== "linear");
    expect(worse).toEqual([]);
  });
});
