import { expect, test } from "vitest";
import { ownHost } from "../../../src/app/share/address.ts";

const hostOf = (address: string) => ownHost(new URL(address));

// Seen: a link to http://127.0.0.1:8000/ was shared, and no text said that other computers cannot open it.
test.each(["http://127.0.0.1:8000/", "http://localhost:5173/", "http://[::1]:8000/"])(
  "%s is reached by this computer only",
  (address) => {
    expect(hostOf(address)).toBe(new URL(address).hostname);
  },
);

test.each(["https://carom.example/", "http://192.168.1.20:8000/", "file:///home/a/page.html"])(
  "%s is not an address of this computer only",
  (address) => {
    expect(hostOf(address)).toBeNull();
  },
);
