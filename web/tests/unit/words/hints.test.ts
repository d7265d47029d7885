/** The forms of physics and table explain their numbers in every language. */

import { expect, test } from "vitest";
import { load } from "../../../src/engine/index.ts";
import type { Schema } from "../../../src/app/form/parameters.ts";
import { CATALOGUES } from "../../../src/app/words/catalogue.ts";

const engine = await load();
const { $defs } = engine.schema("shot") as { $defs: Record<string, Schema> };

/** Parameters whose name and unit say everything. */
const PLAIN = ["physics.ball.mass", "physics.ball.radius", "physics.cue.mass"];

/** Parts of a table that no form shows. */
const NOT_SHOWN = /^table\.(?:markings|sights|physics)\b/;

/** The places of all numbers and choices of a schema, as the catalogue writes them. */
function places(schema: Schema, at: string): string[] {
  const full = schema.$ref ? $defs[schema.$ref.replace("#/$defs/", "")]! : schema;
  const inner = [
    ...Object.entries(full.properties ?? {})
      .filter(([key]) => key !== "base")
      .flatMap(([key, value]) => places(value, `${at}.${key.replace(/_deg$/, "")}`)),
    ...(full.oneOf ?? []).flatMap((choice) => places(choice, at)),
    ...(full.items ? places(full.items, at) : []),
  ];
  const isValue = full.enum !== undefined || full.type === "number" || full.type === "integer";
  return isValue ? [at, ...inner] : inner;
}

/** The description of a part from a base, which the form shows. */
const described = (part: "physics" | "table"): Schema =>
  $defs[part]!.oneOf!.find(({ properties }) => properties?.base)!;

const found = [
  ...new Set(
    [...places(described("physics"), "physics"), ...places(described("table"), "table")].map(
      (place) => place.replace(/^table\.\w+_pocket/, "pocket"),
    ),
  ),
].filter((place) => !NOT_SHOWN.test(place));

test("every parameter of the physics and of the table has a hint, or is listed without one", () => {
  const hinted = found.filter((place) => Object.hasOwn(CATALOGUES.en, `hint.${place}`));
  expect(hinted.length).toBeGreaterThan(50);
  expect(found.filter((place) => !hinted.includes(place)).sort()).toEqual(PLAIN);
});

test("every hint belongs to a parameter", () => {
  const hints = Object.keys(CATALOGUES.en).filter((key) => key.startsWith("hint."));
  expect(hints.filter((key) => !found.includes(key.replace("hint.", "")))).toEqual([]);
});
