// Data in the fragment of an address: `#s=1.<base64url>`, version 1 being JSON in a zlib stream.
//
// The fragment never leaves the browser: no server sees it, and it works from a file on disk too.

import { strFromU8, strToU8, unzlibSync, zlibSync } from "fflate";
import { toJson } from "./literal.ts";

/** A link that cannot be read; the message is a sentence for the user. */
export class LinkError extends Error {
  override name = "LinkError";
}

const KEY = "#s=";

/** The version of what this page writes. A page reads links of this version only. */
const VERSION = "1";

/**
 * The longest link that is read, in characters. A table full of balls needs about 2000; the limit
 * keeps a forged link from unpacking to more memory (at most a thousandfold) than a page has.
 */
const LONGEST = 100_000;

/** Bytes of a zlib stream before and after its content. */
const HEADER = 2;
const CHECKSUM = 4;

/** Whether a fragment claims to carry a state, readable or not. */
export function isLink(fragment: string): boolean {
  return fragment.startsWith(KEY);
}

/** The fragment, with its `#`, that carries plain data. */
export function toFragment(data: unknown): string {
  return `${KEY}${VERSION}.${toBase64Url(zlibSync(strToU8(toJson(data)), { level: 9 }))}`;
}

/**
 * The data that a fragment carries.
 *
 * @throws {LinkError} It is of another version, or damaged.
 */
export function fromFragment(fragment: string): unknown {
  const [version, text = ""] = fragment.slice(KEY.length).split(".", 2);
  if (!isLink(fragment) || !version) throw new LinkError("This link carries no shot.");
  if (version !== VERSION) {
    throw new LinkError(
      `This link was made by another version of the page (its links are of version ${version}, ` +
        `here they are of version ${VERSION}): open it with that one.`,
    );
  }
  if (text.length > LONGEST) throw new LinkError("This link is too long to be a shot.");
  try {
    return JSON.parse(strFromU8(unpack(fromBase64Url(text)))) as unknown;
  } catch (cause) {
    throw new LinkError("This link is damaged, perhaps cut off: copy it again, to its end.", {
      cause,
    });
  }
}

/** Unpacks a zlib stream and checks its sum, which the library leaves to us. */
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
  return btoa(binary).replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "");
}

function fromBase64Url(text: string): Uint8Array {
  const binary = atob(text.replaceAll("-", "+").replaceAll("_", "/"));
  return Uint8Array.from(binary, (c) => c.charCodeAt(0));
}
