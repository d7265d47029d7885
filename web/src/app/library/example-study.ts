/** The example study in the language of the page; `scripts/example_study.py` makes it. */

import de from "../../../../studies/twenty_positions.de.json?raw";
import en from "../../../../studies/twenty_positions.en.json?raw";
import zh from "../../../../studies/twenty_positions.zh.json?raw";
import type { Engine, StudyFile } from "../../engine/index.ts";
import { language } from "../words/translate.ts";

const TEXTS: Readonly<Record<string, string>> = { de, en, zh };

export function exampleStudy(engine: Engine): StudyFile {
  return engine.study(TEXTS[language()] ?? en);
}
