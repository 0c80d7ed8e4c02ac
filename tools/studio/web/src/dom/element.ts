// Elements of the page, without a template language.

export type Child = Node | string | number | null | undefined | false;

export interface Properties {
  class?: string;
  on?: { [K in keyof HTMLElementEventMap]?: (event: HTMLElementEventMap[K]) => void };
  /** Anything else becomes an attribute; `true` an empty one, `false` and undefined none. */
  [attribute: string]: unknown;
}

const fill = (element: Element, properties: Properties, children: Child[]): void => {
  for (const [name, value] of Object.entries(properties)) {
    if (value === undefined || value === false || value === null) continue;
    if (name === 'on')
      for (const [event, run] of Object.entries(value as object)) element.addEventListener(event, run as EventListener);
    else element.setAttribute(name, value === true ? '' : String(value));
  }
  element.append(...children.filter((child): child is Node | string | number => child !== null && child !== undefined && child !== false)
    .map((child) => (typeof child === 'number' ? String(child) : child)));
};

export const h = <K extends keyof HTMLElementTagNameMap>(
  tag: K, properties: Properties = {}, ...children: Child[]
): HTMLElementTagNameMap[K] => {
  const element = document.createElement(tag);
  fill(element, properties, children);
  return element;
};

export const svg = <K extends keyof SVGElementTagNameMap>(
  tag: K, properties: Properties = {}, ...children: Child[]
): SVGElementTagNameMap[K] => {
  const element = document.createElementNS('http://www.w3.org/2000/svg', tag);
  fill(element, properties, children);
  return element;
};
