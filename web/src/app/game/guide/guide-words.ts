/** The aimed shot in a sentence that does not tell its result. */

import type { Trace } from "../../../engine/index.ts";
import { objectName } from "../../common/shot-words.ts";
import type { Guide } from "../../document/stored-game.ts";
import { firstContact } from "../../pot/first-contact.ts";
import { cutText } from "../../pot/pot-words.ts";
import { capital, t } from "../../words/translate.ts";

/** What the short guide says of an aim without a pocket; nothing without a guide. */
export function guideText(trace: Trace, guide: Exclude<Guide, "full">): string {
  const { outcome } = trace;
  if (outcome.miscue) return t("outcome.miscue");
  if (guide === "none") return t("guide.hidden");
  if (outcome.rails_before_first_contact.length > 0) return t("guide.cushion");
  if (outcome.first_contact === null) return t("guide.nothing");
  const contact = firstContact(trace);
  const ball = objectName(outcome.first_contact, outcome);
  return contact
    ? t("guide.aimed", { ball: capital(ball), how: cutText(contact) })
    : t("outcome.hits", { ball });
}
