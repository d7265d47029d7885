import { GOLDENS, shotFile } from "../unit/engine/files.ts";
import { expect, test } from "./fixture.ts";

test("in the browser every golden shot has the native engine's events, to the bit", async ({
  open,
}) => {
  const page = await open();
  const names = Object.keys(GOLDENS);
  const ours = await page.evaluate(
    (files) =>
      files.map((file) => {
        const trace = window.carom!.engine.shot(file).simulate();
        return { events: trace.events.length, hash: trace.hash };
      }),
    names.map(shotFile),
  );
  expect(Object.fromEntries(names.map((name, i) => [name, ours[i]]))).toEqual(GOLDENS);
});
