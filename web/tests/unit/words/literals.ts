/** Finds texts in TypeScript that users would see, but that are in no catalogue. */

import ts from "typescript";

export interface Found {
  readonly line: number;
  readonly text: string;
}

/** Calls whose arguments from this index on are shown. */
const SHOWN: Readonly<Record<string, number>> = {
  h: 2,
  setText: 1,
  refuse: 0,
  announce: 0,
  say: 0,
  option: 1,
  PageError: 0,
  CaromError: 0,
  LinkError: 0,
};

/** Attributes and properties that are shown. */
const VISIBLE = new Set([
  "title",
  "label",
  "aria-label",
  "aria-roledescription",
  "aria-valuetext",
  "placeholder",
  "alt",
  "textContent",
]);

/** Attributes, variables and calls whose texts are for the browser, or details for programmers. */
const TECHNICAL = new Set([
  "class",
  "d",
  "viewBox",
  "accept",
  "SHEET",
  "DARK",
  "TEXT_CONTROLS",
  "LAYOUT",
]);
const FOR_BROWSER =
  /^(?:querySelector(?:All)?|closest|matches|matchMedia|input|mark|log|replace|startsWith|lastIndexOf|between|broken)$/;

/** Two words, or a word with a capital letter. */
const PROSE = /[A-Za-z]{2,} [A-Za-z]{2,}|^[A-Z][a-z]+[ .:!?]/;

const UNITS = /^\s*(?:m\/s|rad\/s|km\/h|mph|rpm|m|mm|mJ|R|%|°|s)\s*$/;

/** The visible literals of a module. */
export function visibleLiterals(code: string): Found[] {
  const file = ts.createSourceFile("x.ts", code, ts.ScriptTarget.Latest, true);
  const found: Found[] = [];
  const visit = (node: ts.Node): void => {
    if (isText(node) && isVisible(node)) {
      const line = file.getLineAndCharacterOfPosition(node.getStart()).line + 1;
      found.push({ line, text: node.text });
    }
    ts.forEachChild(node, visit);
  };
  visit(file);
  return found;
}

type Text = ts.StringLiteralLike | ts.TemplateHead | ts.TemplateMiddle | ts.TemplateTail;

function isText(node: ts.Node): node is Text {
  return (
    ts.isStringLiteralLike(node) ||
    ts.isTemplateHead(node) ||
    ts.isTemplateMiddle(node) ||
    ts.isTemplateTail(node)
  );
}

function isVisible(node: Text): boolean {
  const { text } = node;
  if (!/[A-Za-z]{2}/.test(text) || UNITS.test(text)) return false;
  const place = placeOf(node);
  if (place === "shown") return true;
  return place === "open" && PROSE.test(text);
}

/** Whether a literal is shown, is for the browser or the compiler, or may be either. */
function placeOf(node: Text): "shown" | "hidden" | "open" {
  let child: ts.Node = node;
  for (let at = node.parent; !ts.isSourceFile(at); child = at, at = at.parent) {
    if (ts.isImportDeclaration(at) || ts.isLiteralTypeNode(at) || ts.isCaseClause(at))
      return "hidden";
    if (ts.isElementAccessExpression(at) || isComparison(at)) return "hidden";
    if (ts.isConditionalExpression(at) && child === at.condition) return "hidden";
    if (ts.isPropertyAssignment(at) && child === at.name) return "hidden";
    const name = nameOf(at);
    if (name !== null && VISIBLE.has(name)) return "shown";
    if (name !== null && TECHNICAL.has(name)) return "hidden";
    if (ts.isCallExpression(at) || ts.isNewExpression(at)) return placeInCall(at, child);
    if (ts.isFunctionLike(at)) return "open";
  }
  return "open";
}

function placeInCall(
  call: ts.CallExpression | ts.NewExpression,
  child: ts.Node,
): "shown" | "hidden" | "open" {
  const { expression } = call;
  const name = ts.isPropertyAccessExpression(expression)
    ? expression.name.text
    : expression.getText();
  const index = call.arguments?.indexOf(child as ts.Expression) ?? -1;
  const from = SHOWN[name];
  // The second argument of an error is a place in the file.
  if (name.endsWith("Error") && index > 0) return "hidden";
  if (from !== undefined) return index >= from ? "shown" : "open";
  // A fault of the program, which no user can mend.
  if (/^(?:Type|Range)?Error$/.test(name)) return "hidden";
  if (name === "setAttribute") return isVisibleAttribute(call) && index === 1 ? "shown" : "hidden";
  return FOR_BROWSER.test(name) ? "hidden" : "open";
}

function isVisibleAttribute({
  arguments: [name] = [] as never,
}: ts.CallExpression | ts.NewExpression) {
  return name !== undefined && ts.isStringLiteralLike(name) && VISIBLE.has(name.text);
}

function isComparison(node: ts.Node): boolean {
  return ts.isBinaryExpression(node) && /^[!=]==$|^in$/.test(node.operatorToken.getText());
}

/** The name of the property or variable that gets the value. */
function nameOf(node: ts.Node): string | null {
  if (ts.isPropertyAssignment(node) || ts.isVariableDeclaration(node))
    return ts.isStringLiteral(node.name) ? node.name.text : node.name.getText();
  if (ts.isBinaryExpression(node) && node.operatorToken.kind === ts.SyntaxKind.EqualsToken) {
    return ts.isPropertyAccessExpression(node.left) ? node.left.name.text : null;
  }
  return null;
}
