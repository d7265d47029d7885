import { defineConfig } from "vitest/config";
import { viteSingleFile } from "vite-plugin-singlefile";
import { withContentPolicy } from "./scripts/content_policy.ts";

// The build is one HTML file that contains JavaScript, CSS, the WebAssembly (a string in a module) and the
// worker (`?worker&inline`). It works from disk, in an iframe and without a network.
export default defineConfig({
  plugins: [viteSingleFile({ removeViteModuleLoader: true }), withContentPolicy()],
  // The licenses are in the root of the checkout.
  server: { fs: { allow: [".."] } },
  build: {
    target: ["chrome111", "firefox115", "safari16.4"],
    assetsInlineLimit: () => true,
    modulePreload: { polyfill: false },
    reportCompressedSize: false,
    chunkSizeWarningLimit: 4000,
  },
  // A classic script: a page from disk or in a sandbox has no origin and cannot start a module worker.
  worker: { format: "iife" },
  test: {
    projects: [
      {
        extends: true,
        test: {
          name: "unit",
          include: ["tests/unit/**/*.test.ts"],
          // The files share modules, so that each worker loads the engine once, not once per file.
          isolate: false,
          // A limit for hanging tests, not for slow machines: some tests let a player think.
          testTimeout: 60_000,
        },
      },
      {
        extends: true,
        test: {
          name: "e2e",
          include: ["tests/e2e/**/*.spec.ts"],
          globalSetup: "tests/e2e/setup.ts",
          // All tests share one browser. Two files at a time: one draws while the other waits.
          maxWorkers: 2,
          // Limits for hanging tests, not for slow machines: pages are drawn in software.
          testTimeout: 180_000,
          hookTimeout: 120_000,
          expect: { poll: { timeout: 60_000 } },
          // On a busy machine 3 of 764 tests failed in two runs that pass alone. A fault of the page fails twice,
          // and the reporter marks a test that was repeated.
          retry: 1,
        },
      },
      {
        extends: true,
        test: {
          name: "bench",
          include: ["bench/**/*.bench.ts"],
          globalSetup: "tests/e2e/setup.ts",
          fileParallelism: false,
          hookTimeout: 60_000,
        },
      },
    ],
  },
});
