import js from "@eslint/js";
import prettier from "eslint-config-prettier";
import { defineConfig, globalIgnores } from "eslint/config";
import ts from "typescript-eslint";

/** Relative imports that do not name a file; those of the WebAssembly and of scripts end in `.js`. */
const IMPRECISE = "^\\.(?!.*\\.(ts|css|json)$|.*\\?|.*/(pkg|scripts)/.*\\.js$)";

export default defineConfig(
  globalIgnores(["dist/", "src/engine/pkg/", "src/engine/dist/", "tests/e2e/out/"]),
  js.configs.recommended,
  ts.configs.strictTypeChecked,
  ts.configs.stylisticTypeChecked,
  {
    languageOptions: {
      parserOptions: { projectService: true, tsconfigRootDir: import.meta.dirname },
    },
    rules: {
      // Most texts of this page contain numbers.
      "@typescript-eslint/restrict-template-expressions": ["error", { allowNumber: true }],
      "@typescript-eslint/no-confusing-void-expression": ["error", { ignoreArrowShorthand: true }],
      // Loops bound the indices of typed arrays.
      "@typescript-eslint/no-non-null-assertion": "off",
    },
  },
  {
    files: ["**/*.ts"],
    rules: {
      // A relative import names a file of ours as it is on disk: `./file.ts`, not `./file` or `./file.js`.
      "no-restricted-imports": ["error", { patterns: [{ regex: IMPRECISE }] }],
    },
  },
  {
    files: ["src/**/*.ts"],
    rules: {
      // A longer function shares variables between too many steps: a class or a state object names them.
      "max-lines-per-function": ["error", { max: 70, skipBlankLines: true, skipComments: true }],
    },
  },
  {
    files: ["public/service-worker.js"],
    languageOptions: {
      globals: { self: "readonly", caches: "readonly", fetch: "readonly", URL: "readonly" },
    },
  },
  { files: ["**/*.js"], extends: [ts.configs.disableTypeChecked] },
  prettier,
);
