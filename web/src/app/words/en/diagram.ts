/** Diagrams for paper. */
export const texts = {
  "diagram.heading": "Diagram for paper",
  "diagram.label": "Diagram of the table",
  "diagram.caption": "{number}. {comment}",
  "diagram.svg": "SVG",
  "diagram.png": "PNG",
  "diagram.print": "Print …",
  "diagram.paper": "Paper",
  "diagram.a4": "A4",
  "diagram.letter": "Letter",
  "diagram.per-page": "Diagrams on a page",
  "diagram.what": "What",
  "diagram.this": "This position",
  "diagram.all": "All shots of the analysis",
  "diagram.none": "Cloth without edges has no diagram: choose a table.",
} as const;
