import { expect, test, usable } from "./fixture.ts";

test("a served page can be installed, and opens again without a network", async ({ open }) => {
  const page = await open({ serviceWorkers: "allow" });
  // The page itself may not fetch: its content security policy.
  const address = await page.evaluate(
    () => document.querySelector<HTMLLinkElement>('link[rel="manifest"]')!.href,
  );
  const manifest = (await (await page.request.get(address)).json()) as {
    name: string;
    icons: { src: string }[];
  };
  expect(manifest.name).toBe("carom");
  for (const { src } of manifest.icons) {
    const size = await page.evaluate(async (address) => {
      const image = new Image();
      image.src = address;
      await image.decode();
      return image.naturalWidth;
    }, src);
    expect(src).toContain(String(size));
  }
  await page.evaluate(async () => {
    await navigator.serviceWorker.ready;
    if (!navigator.serviceWorker.controller) {
      await new Promise((resolve) => {
        navigator.serviceWorker.addEventListener("controllerchange", resolve);
      });
    }
  });
  await page.context().setOffline(true);
  await page.reload();
  await usable(page);
  expect(
    await page.evaluate(() => window.carom!.store.shot.simulate().events.length),
  ).toBeGreaterThan(3);
  await page.context().setOffline(false);
});

test("a page from disk asks for no other file", async ({ open }) => {
  const { inject } = await import("vitest");
  const page = await open({ url: `file://${inject("file")}`, serviceWorkers: "allow" });
  expect(await page.locator('link[rel="manifest"]').count()).toBe(0);
});
