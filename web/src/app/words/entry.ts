/** An entry of a catalogue: a text with placeholders, `{ball} drops`, or one text per plural form. */

/** The plural forms of a text. The placeholder `{count}` chooses the form by the language's rule. */
export type Plural = Readonly<{ other: string } & Partial<Record<Intl.LDMLPluralRule, string>>>;

export type Entry = string | Plural;

/** The same keys in another language. A text with plural forms has them in every language. */
export type Translation<T extends Readonly<Record<string, Entry>>> = {
  readonly [K in keyof T]: T[K] extends string ? string : Plural;
};

/** The names of the placeholders of an entry. */
export type Placeholders<E extends Entry> = E extends string
  ? InText<E>
  : { [K in keyof E]: E[K] extends string ? InText<E[K]> : never }[keyof E];

type InText<T extends string> = T extends `${string}{${infer Name}}${infer Rest}`
  ? Name | InText<Rest>
  : never;
