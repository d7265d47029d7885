/** A finger on the screen of a phone. */

import type { CDPSession, Page } from "playwright-core";
import { PHONE, type Spot } from "./fixture.ts";

export const TOUCH = { viewport: PHONE, hasTouch: true, isMobile: true };

/** The same phone, turned. */
export const LYING = { ...TOUCH, viewport: { width: PHONE.height, height: PHONE.width } };

export async function finger(page: Page) {
  const session: CDPSession = await page.context().newCDPSession(page);
  const send = (type: "touchStart" | "touchMove" | "touchEnd", at?: Spot) =>
    session.send("Input.dispatchTouchEvent", { type, touchPoints: at ? [at] : [] });
  return {
    down: (at: Spot) => send("touchStart", at),
    move: (at: Spot) => send("touchMove", at),
    up: () => send("touchEnd"),
  };
}
