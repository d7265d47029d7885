import { expect, test } from "vitest";
import { namesOf } from "../../../src/app/diagram/paper-diagram.ts";
import { paperMarks } from "../../../src/app/diagram/paper-marks.ts";

test("balls have their numbers or the first letters of their colours", () => {
  expect(namesOf(["cue", "7", "12"])).toEqual(["", "7", "12"]);
  expect(namesOf(["cue", "yellow", "red"])).toEqual(["", "Y", "R"]);
  expect(namesOf(["brown", "blue", "black", "green"])).toEqual(["Br", "Blu", "Bla", "G"]);
});

test("several balls of one colour have no letter", () => {
  expect(namesOf(["red-1", "red-2", "pink"])).toEqual(["", "", "P"]);
});

test("marks lie along the table, and their colours are dark", () => {
  const [line, circle, area, label] = paperMarks([
    { kind: "arrow", color: "white", from: [0.5, 1], to: [0.5, 2] },
    { kind: "circle", color: "yellow", center: [0.2, 0.4], radius: 0.1 },
    {
      kind: "area",
      color: "red",
      outline: [
        [0, 0],
        [0, 1],
        [1, 1],
      ],
    },
    { kind: "label", color: "blue", at: [0.3, 0.6], text: "here <b>" },
  ]);
  expect(line![1]).toMatchObject({ stroke: "#000000", fill: "none" });
  expect(line![1].d).toMatch(/^M1000 500L2000 500M/);
  expect(circle![1]).toMatchObject({ cx: 400, cy: 200, r: 100, stroke: "#7a6000" });
  expect(area![1].d).toBe("M0 0L1000 0L1000 1000Z");
  expect(label![1]).toMatchObject({ x: 600, y: 300 });
  expect(label![2]).toBe("here <b>");
});
