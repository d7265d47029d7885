import { readFileSync, readdirSync } from "node:fs";
import { strToU8, zlibSync } from "fflate";
import { describe, expect, test } from "vitest";
import { fromFragment, isLink, LinkError, toFragment } from "../../../src/app/share/link.ts";

const SHOTS = new URL("../../../../shots/", import.meta.url);
const NAMES = readdirSync(SHOTS).filter((name) => name.endsWith(".json"));
const read = (name: string): unknown => JSON.parse(readFileSync(new URL(name, SHOTS), "utf8"));

/** Longest link to a break of fifteen balls, in characters. */
const LONG_ENOUGH = 1500;

describe("a link", () => {
  test("is tested with all example shots", () => {
    expect(NAMES.length).toBeGreaterThan(20);
  });

  test.each(NAMES)("restores %s to the bit", (name) => {
    const shot = read(name);
    expect(fromFragment(toFragment(shot))).toStrictEqual(shot);
  });

  test("keeps the sign of zero, and numbers of every size", () => {
    const data = { numbers: [-0, 0, 5e-324, 1e21, -1.7976931348623157e308, 0.1 + 0.2] };
    expect(fromFragment(toFragment(data))).toStrictEqual(data);
  });

  test("keeps names in any script", () => {
    const data = { balls: [{ id: 'Weiß 白 🎱 "quoted" \\ \n' }] };
    expect(fromFragment(toFragment(data))).toStrictEqual(data);
  });

  test("needs no escapes in an address, and stays short enough to send", () => {
    const link = toFragment(read("eight_ball_break.json"));
    expect(link).toMatch(/^#s=1\.[A-Za-z0-9_-]+$/);
    expect(link.length).toBeLessThan(LONG_ENOUGH);
  });

  test("is distinguished from other fragments", () => {
    expect(isLink(toFragment({}))).toBe(true);
    expect(isLink("#help")).toBe(false);
    expect(isLink("")).toBe(false);
  });

  test("of another version is refused, and the message names both versions", () => {
    const link = toFragment({}).replace("#s=1.", "#s=7.");
    expect(() => fromFragment(link)).toThrow(LinkError);
    expect(() => fromFragment(link)).toThrow(/version 7.*version 1/);
  });

  test("that is incomplete is refused at every length", () => {
    const link = toFragment(read("jump_shot.json"));
    for (let length = "#s=1.".length; length < link.length; length++) {
      expect(() => fromFragment(link.slice(0, length))).toThrow(/damaged/);
    }
  });

  test("with one character changed is refused", () => {
    const link = toFragment(read("jump_shot.json"));
    const last = link.length - 1; // its lowest bits may be unused
    for (let i = "#s=1.".length; i < last; i++) {
      const other = link[i] === "A" ? "B" : "A";
      const wrong = link.slice(0, i) + other + link.slice(i + 1);
      let read: unknown;
      try {
        read = fromFragment(wrong);
      } catch (error) {
        expect(error).toBeInstanceOf(LinkError);
        continue;
      }
      // Only unused bits of the stream may differ.
      expect(read).toStrictEqual(fromFragment(link));
    }
  });

  test("of garbage, or of text that is not JSON, is refused", () => {
    expect(() => fromFragment("#s=1.%%%")).toThrow(/damaged/);
    expect(() => fromFragment("#s=")).toThrow(/no shot/);
    const text = Buffer.from(zlibSync(strToU8("no JSON"))).toString("base64url");
    expect(() => fromFragment(`#s=1.${text}`)).toThrow(/damaged/);
  });

  test("that is too long is refused before it is unpacked", () => {
    expect(() => fromFragment(`#s=1.${"A".repeat(1_000_000)}`)).toThrow(/too long/);
  });
});
