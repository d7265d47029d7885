import { createHash } from "node:crypto";
import { expect, test } from "vitest";
import { contentPolicy } from "../../../scripts/content_policy.ts";

const SCRIPT = "console.log(1)";
const HASH = createHash("sha256").update(SCRIPT).digest("base64");

test("the policy allows the page's own script by its hash, and no data", () => {
  const page = `<script type="application/json" id="carom-document">{}</script><script type="module">${SCRIPT}</script>`;
  expect(contentPolicy(page)).toContain(`script-src 'sha256-${HASH}' 'wasm-unsafe-eval';`);
});

test("the policy sends nothing and loads nothing from another host", () => {
  const directives = contentPolicy(`<script>${SCRIPT}</script>`).split("; ");
  const named = (name: string) =>
    directives.filter((directive) => directive.startsWith(`${name} `));
  expect(named("default-src")).toEqual(["default-src 'none'"]);
  expect(named("connect-src")).toEqual([]);
  expect(named("script-src")).toHaveLength(1);
  expect(named("script-src")[0]).not.toContain("'unsafe-inline'");
  for (const directive of directives) expect(directive).not.toMatch(/https?:|\*/u);
});
