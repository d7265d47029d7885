import { pathToFileURL } from "node:url";
import type { Page } from "playwright-core";
import { inject } from "vitest";
import { expect, newContext, test, usable } from "./fixture.ts";

/** Does something in a page that its content security policy forbids; gives the directive that forbade it. */
function refusedBy(page: Page, kind: "script" | "handler" | "request" | "frame" | "picture") {
  return page.evaluate(
    (kind) =>
      new Promise<string>((resolve) => {
        document.addEventListener("securitypolicyviolation", (event) => {
          resolve(event.effectiveDirective);
        });
        const holder = document.createElement("div");
        document.body.append(holder);
        const element = {
          script: () => {
            const script = document.createElement("script");
            script.textContent = "window.intruder = true";
            return script;
          },
          handler: () => {
            holder.innerHTML = '<img src="data:," onerror="window.intruder = true">';
            return holder;
          },
          request: () => {
            void fetch("https://example.invalid/").catch(() => undefined);
            return holder;
          },
          frame: () => {
            const frame = document.createElement("iframe");
            frame.src = "https://example.invalid/";
            return frame;
          },
          picture: () => {
            const picture = document.createElement("img");
            picture.src = "https://example.invalid/a.png";
            return picture;
          },
        }[kind]();
        if (element !== holder) holder.append(element);
      }),
    kind,
  );
}

for (const place of ["page", "file"] as const) {
  test(`the policy of the ${place === "page" ? "served page" : "page on disk"} refuses foreign scripts and requests`, async ({
    browser,
  }) => {
    const page = await (await newContext(browser)).newPage();
    await page.goto(place === "page" ? inject("page") : pathToFileURL(inject("file")).href);
    await usable(page);
    expect(await refusedBy(page, "script")).toBe("script-src-elem");
    expect(await refusedBy(page, "handler")).toBe("script-src-attr");
    expect(await refusedBy(page, "request")).toBe("connect-src");
    expect(await refusedBy(page, "frame")).toBe("frame-src");
    expect(await refusedBy(page, "picture")).toBe("img-src");
    expect(await page.evaluate(() => "intruder" in window)).toBe(false);
    await page.context().close();
  });
}
