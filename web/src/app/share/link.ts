/**
 * Data in the fragment of an address: `#s=1.<base64url>`. Version 1 is JSON in a zlib stream.
 *
 * Browsers do not send the fragment to a server, and it works for a page from disk too.
 */

import { strFromU8, strToU8, unzlibSync, zlibSync } from "fflate";
import { toJson } from "./literal.ts";
import { t } from "../words/translate.ts";

/** A link that cannot be opened. The message is shown to the user. */
export class LinkError extends Error {
  override name = "LinkError";
}

const KEY = "#s=";

/** Of a link to a drill. */
export const DRILL_KEY = "#d=";

/** The version of links that this page writes and reads. */
const VERSION = "1";

/**
 * The longest link that is read, in characters. A table full of balls needs about 2000. A forged link
 * could unpack to a thousand times its length; this limit bounds the memory that it takes.
 */
const LONGEST = 100_000;

/** Bytes of a zlib stream before and after its contents. */
const HEADER = 2;
const CHECKSUM = 4;

/** Whether a fragment has the form of a link, valid or not. */
export function isLink(fragment: string): boolean {
  return fragment.startsWith(KEY);
}

/**
 * The link in a text that holds nothing else: an address, or the fragment alone; null if there is none.
 *
 * A file of strangers may be long: this reads it a fixed number of times, and no pattern searches it.
 */
export function linkIn(text: string): string | null {
  const link = text.trim();
  // Behind the key at least the version follows.
  const at = link.lastIndexOf(KEY, Math.max(0, link.length - KEY.length - 1));
  const isLinkAlone = at >= 0 && link.length > at + KEY.length && !/\s/.test(link);
  return isLinkAlone ? link.slice(at) : null;
}

/** The fragment, with its `#`, for plain data. */
export function toFragment(data: unknown, key = KEY): string {
  return `${key}${VERSION}.${toBase64Url(zlibSync(strToU8(toJson(data)), { level: 9 }))}`;
}

/** Whether a fragment is longer than those that are read. */
export function isTooLong(fragment: string): boolean {
  return fragment.length > LONGEST + KEY.length + VERSION.length + 1;
}

/**
 * The data in a fragment.
 *
 * @throws {LinkError} The link is of another version, or damaged.
 */
export function fromFragment(fragment: string, key = KEY): unknown {
  const [version, text = ""] = fragment.slice(key.length).split(".", 2);
  if (!fragment.startsWith(key) || !version) throw new LinkError(t("link.no-shot"));
  if (version !== VERSION) {
    throw new LinkError(t("link.version", { version, own: VERSION }));
  }
  if (isTooLong(fragment)) throw new LinkError(t("link.too-long"));
  try {
    return JSON.parse(strFromU8(unpack(fromBase64Url(text)))) as unknown;
  } catch (cause) {
    throw new LinkError(t("link.damaged"), { cause });
  }
}

/** Unpacks a zlib stream and verifies its checksum, which fflate does not do. */
function unpack(stream: Uint8Array): Uint8Array {
  if (stream.length < HEADER + CHECKSUM) throw new RangeError("no stream");
  const content = unzlibSync(stream);
  const end = new DataView(stream.buffer, stream.byteOffset + stream.length - CHECKSUM);
  if (end.getUint32(0) !== adler32(content)) throw new RangeError("the checksum differs");
  return content;
}

/** The checksum of a zlib stream (RFC 1950, section 9). */
function adler32(bytes: Uint8Array): number {
  const MODULUS = 65521;
  let a = 1;
  let b = 0;
  for (const byte of bytes) {
    a = (a + byte) % MODULUS;
    b = (b + a) % MODULUS;
  }
  return ((b << 16) | a) >>> 0;
}

function toBase64Url(bytes: Uint8Array): string {
  let binary = "";
  for (const byte of bytes) binary += String.fromCharCode(byte);
  return btoa(binary)
    .replaceAll("+", "-")
    .replaceAll("/", "_")
    .replace(/={1,2}$/, "");
}

function fromBase64Url(text: string): Uint8Array {
  const binary = atob(text.replaceAll("-", "+").replaceAll("_", "/"));
  return Uint8Array.from(binary, (c) => c.charCodeAt(0));
}
