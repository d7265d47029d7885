/** What the service worker keeps for use without a network. */

import { readFileSync } from "node:fs";
import { runInNewContext } from "node:vm";
import { expect, test } from "vitest";

const SOURCE = readFileSync(new URL("../../../public/service-worker.js", import.meta.url), "utf8");
const PAGE = "https://host.example/carom/";

interface Fetched {
  readonly request: Request;
  respondWith(response: Promise<Response>): void;
}

/** The worker at `PAGE`, with the responses that it keeps by address. */
function worker(answer: () => Response) {
  const kept = new Map<string, string>();
  let listen: (event: Fetched) => void = () => undefined;
  const cache = {
    put: async ({ url }: Request, response: Response) => kept.set(url, await response.text()),
    match: ({ url }: Request) => {
      const text = kept.get(url);
      return Promise.resolve(text === undefined ? undefined : new Response(text));
    },
  };
  runInNewContext(SOURCE, {
    URL,
    caches: { open: () => Promise.resolve(cache) },
    fetch: () => Promise.resolve().then(answer),
    self: {
      registration: { scope: PAGE },
      addEventListener: (name: string, listener: typeof listen) => {
        if (name === "fetch") listen = listener;
      },
    },
  });
  const open = async (): Promise<string> => {
    let response = Promise.reject<Response>(new Error("not answered"));
    response.catch(() => undefined);
    listen({
      request: new Request(PAGE),
      respondWith: (given) => {
        response = given;
      },
    });
    return (await response).text();
  };
  return { open };
}

test("without a network the last page opens, but not one with a shot of `carom play`", async () => {
  let answer = () => new Response("the page");
  const { open } = worker(() => answer());
  expect(await open()).toBe("the page");
  answer = () => new Response("a shot", { headers: { "cache-control": "no-store" } });
  expect(await open()).toBe("a shot");
  answer = () => {
    throw new TypeError("offline");
  };
  expect(await open()).toBe("the page");
});
